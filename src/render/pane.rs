//! What every shader knows of the pane it draws, of its world or of the screen before it.

use bytemuck::{Pod, Zeroable};
use glam::{Mat4, Vec2, Vec3, Vec4};

use super::light::Light;
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
        let metrics = Vec4::new(pixels.x, pixels.y, point, 0.0);
        Self { clip_from_world: clip_from_pixel, eye: Vec4::new(0.0, 0.0, 0.0, NEAR), metrics, ..Self::zeroed() }
    }

    /// Of a pane that is this many pixels wide and high, with this many pixels a point.
    pub(super) fn new(pane: &Pane, pixels: Vec2, point: f32) -> Self {
        let aspect = pixels.x / pixels.y;
        let (right, up, forward) = pane.camera.axes();
        let half_height = (0.5 * Camera::vertical_field(aspect)).tan();
        let light = Light::of(&pane.camera);
        let wide = |v: Vec3, w: f32| v.extend(w);
        Self {
            clip_from_world: pane.camera.clip_from_world(aspect),
            ray_right: wide(right * (half_height * aspect), 0.0),
            ray_up: wide(up * half_height, 0.0),
            ray_forward: wide(forward, 0.0),
            eye: wide(pane.camera.eye(), NEAR),
            key_light: wide(light.key.0, light.key.1),
            fill_light: wide(light.fill.0, light.fill.1),
            metrics: Vec4::new(pixels.x, pixels.y, point, light.ambient),
        }
    }
}

/// Takes places of a pane's world to pixels of the picture.
pub(super) struct Projection<'a> {
    uniform: &'a PaneUniform,
    /// The pane's corner in the picture (pixels).
    corner: Vec2,
}

impl<'a> Projection<'a> {
    /// Of the pane at this corner of the picture (pixels).
    pub(super) fn new(uniform: &'a PaneUniform, corner: Vec2) -> Self {
        Self { uniform, corner }
    }

    /// A place in clip space.
    pub(super) fn clip(&self, at: Vec3) -> Vec4 {
        self.uniform.clip_from_world * at.extend(1.0)
    }

    /// A place in clip space as a pixel of the picture.
    pub(super) fn pixel(&self, clip: Vec4) -> Vec2 {
        self.corner + (0.5 + Vec2::new(0.5, -0.5) * (clip.truncate().truncate() / clip.w)) * self.size()
    }

    /// Whether something between these places of the picture may be seen in the pane.
    pub(super) fn may_show(&self, places: &[Vec3; 4]) -> bool {
        let [a, b, c, d] = places.map(Vec3::truncate);
        let (low, high) = (a.min(b).min(c.min(d)), a.max(b).max(c.max(d)));
        low.cmplt(self.corner + self.size()).all() && high.cmpgt(self.corner).all()
    }

    fn size(&self) -> Vec2 {
        Vec2::new(self.uniform.metrics.x, self.uniform.metrics.y)
    }
}
