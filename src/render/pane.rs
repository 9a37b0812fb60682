//! What every shader knows of the pane it draws, of its world or of the screen before it.

use bytemuck::{Pod, Zeroable};
use glam::{Mat4, Vec2, Vec3, Vec4};

use crate::camera::{Camera, NEAR};
use crate::frame::Pane;

/// `Pane` of shaders/pane.wgsl.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct PaneUniform {
    pub(super) clip_from_world: Mat4,
    pub(super) ray_right: Vec4,
    pub(super) ray_up: Vec4,
    pub(super) ray_forward: Vec4,
    pub(super) eye: Vec4,
    pub(super) key_light: Vec4,
    pub(super) fill_light: Vec4,
    pub(super) metrics: Vec4,
}

const AMBIENT: f32 = 0.24;

impl PaneUniform {
    /// Where a point of the pane's world is seen (normalised device coordinates); none behind the eye.
    pub(super) fn ndc(&self, at: Vec3) -> Option<Vec2> {
        let clip = self.clip_from_world * at.extend(1.0);
        (clip.w > NEAR).then(|| Vec2::new(clip.x, clip.y) / clip.w)
    }

    /// Of what lies flat on the screen before a pane: places are pixels from its upper left corner, nearest to the eye.
    pub(super) fn flat(pixels: Vec2, point: f32) -> Self {
        let clip_from_pixel = Mat4::from_cols(
            Vec4::new(2.0 / pixels.x, 0.0, 0.0, 0.0),
            Vec4::new(0.0, -2.0 / pixels.y, 0.0, 0.0),
            Vec4::ZERO,
            Vec4::new(-1.0, 1.0, 1.0, 1.0),
        );
        let metrics = Vec4::new(pixels.x, pixels.y, point, AMBIENT);
        Self { clip_from_world: clip_from_pixel, eye: Vec4::new(0.0, 0.0, 0.0, NEAR), metrics, ..Self::zeroed() }
    }

    /// Of a pane that is this many pixels wide and high, with this many pixels a point.
    pub(super) fn new(pane: &Pane, pixels: Vec2, point: f32) -> Self {
        let aspect = pixels.x / pixels.y;
        let (right, up, forward) = pane.camera.axes();
        let half_height = (0.5 * Camera::vertical_field(aspect)).tan();
        // The lights stay with the eye, so that a turned camera sees the same light: key from the upper left,
        // fill from the right.
        let key = (up * 0.6 - right * 0.42 - forward * 0.75).normalize();
        let fill = (right * 0.9 - forward * 0.4 - up * 0.1).normalize();
        let wide = |v: Vec3, w: f32| v.extend(w);
        Self {
            clip_from_world: pane.camera.clip_from_world(aspect),
            ray_right: wide(right * (half_height * aspect), 0.0),
            ray_up: wide(up * half_height, 0.0),
            ray_forward: wide(forward, 0.0),
            eye: wide(pane.camera.eye(), NEAR),
            key_light: wide(key, 0.72),
            fill_light: wide(fill, 0.2),
            metrics: Vec4::new(pixels.x, pixels.y, point, AMBIENT),
        }
    }
}
