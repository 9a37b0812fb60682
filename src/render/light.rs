//! The light that surfaces are seen in, as `shaders/pane.wgsl` reckons it.

use glam::Vec3;

use crate::camera::Camera;

/// Two lights that stay with the eye, so that a turned camera sees the same light, and some from everywhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Towards the key light, from the upper left, and its strength.
    pub key: (Vec3, f32),
    /// Towards the light that fills the shade, from the right, and its strength.
    pub fill: (Vec3, f32),
    /// From everywhere.
    pub ambient: f32,
}

/// How much of the key light surfaces throw back as mirrors do: bodies, and walls on their outer side.
pub const BODY_GLOSS: f32 = 0.06;
/// Of walls.
pub const WALL_GLOSS: f32 = 0.12;
/// The inner side of a wall is so much darker.
pub const INNER_SIDE: f32 = 0.8;
/// A wall that is seen aslant takes more light, no more than at this cosine.
pub const SLANTED: f32 = 0.2;

impl Light {
    /// The light of what this camera sees.
    #[must_use]
    pub fn of(camera: &Camera) -> Self {
        let (right, up, forward) = camera.axes();
        let key = (up * 0.6 - right * 0.42 - forward * 0.75).normalize();
        let fill = (right * 0.9 - forward * 0.4 - up * 0.1).normalize();
        Self { key: (key, 0.72), fill: (fill, 0.2), ambient: 0.24 }
    }

    /// What a surface of this colour, with this unit normal, shows towards the eye. Channels may exceed 1.
    #[must_use]
    pub fn lit(&self, color: Vec3, normal: Vec3, to_eye: Vec3, gloss: f32) -> Vec3 {
        let half_way = (self.key.0 + to_eye).normalize_or_zero();
        // Wrapped: no face goes black, and the turn from light to shade is soft.
        let key = 0.5 + 0.5 * normal.dot(self.key.0);
        let fill = 0.5 + 0.5 * normal.dot(self.fill.0);
        let light = self.ambient + key * (0.3 + 0.7 * key) * self.key.1 + fill * self.fill.1;
        color * light.sqrt() + Vec3::splat(gloss * normal.dot(half_way).max(0.0).powi(32))
    }
}
