//! Picking on the momentum sphere: from a point of the picture to a direction of the body momentum, and back.

use glam::{DVec3, Vec2, Vec3};

use crate::camera::Camera;
use crate::frame::Area;
use crate::physics::{Body, poinsot};
use crate::ui::{Pixels, Preview};

/// Points of a previewed polhode.
const POINTS: usize = 160;

/// A view of the picture: its part in pixels, and its camera.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pane {
    corner: Vec2,
    extent: Vec2,
    camera: Camera,
}

impl Pane {
    pub(super) fn new(area: &Area, picture_size: Pixels, camera: Camera) -> Self {
        Self { corner: area.corner * picture_size, extent: (area.extent * picture_size).max(Vec2::ONE), camera }
    }

    fn aspect(&self) -> f32 {
        self.extent.x / self.extent.y
    }

    /// Where the unit sphere is met under a pixel, on the near side.
    pub(super) fn sphere_under(&self, at: Pixels) -> Option<Vec3> {
        let inside = (at - self.corner) / self.extent;
        let is_inside = inside.min_element() >= 0.0 && inside.max_element() <= 1.0;
        self.meet(at).filter(|(_, is_met)| *is_met && is_inside).map(|(point, _)| point)
    }

    /// The same, or the point of the outline that is nearest to a pixel beside the sphere.
    pub(super) fn sphere_nearest(&self, to: Pixels) -> Option<Vec3> {
        self.meet(to).map(|(point, _)| point).filter(|point| point.is_finite())
    }

    /// Where the ray through a pixel meets the unit sphere, or the point of its outline on that side; and whether it does meet it.
    fn meet(&self, at: Pixels) -> Option<(Vec3, bool)> {
        let inside = (at - self.corner) / self.extent;
        let up = (0.5 * Camera::vertical_field(self.aspect())).tan();
        let across = Vec2::new(2.0 * inside.x - 1.0, 1.0 - 2.0 * inside.y) * up * Vec2::new(self.aspect(), 1.0);
        let (right_axis, up_axis, forward) = self.camera.axes();
        let direction = (forward + right_axis * across.x + up_axis * across.y).normalize();
        let eye = self.camera.eye();
        // |eye + t direction| = 1, the smaller t.
        let half = eye.dot(direction);
        let under_root = half * half - (eye.length_squared() - 1.0);
        let distance = -half - under_root.max(0.0).sqrt();
        if distance <= 0.0 {
            return None;
        }
        let point = (eye + direction * distance).normalize();
        Some(if under_root > 0.0 { (point, true) } else { (outline_towards(eye, point), false) })
    }

    /// The pixel of a point, and whether the unit sphere does not hide it.
    fn project(&self, point: Vec3) -> (Pixels, bool) {
        let clip = self.camera.clip_from_world(self.aspect()) * point.extend(1.0);
        let place = Vec2::new(0.5 + 0.5 * clip.x / clip.w, 0.5 - 0.5 * clip.y / clip.w);
        (self.corner + place * self.extent, self.camera.eye().dot(point) >= 0.999)
    }

    /// The pixel of a momentum (principal components) on the sphere, where the sphere does not hide it.
    pub(super) fn near_side(&self, momentum: DVec3) -> Option<Pixels> {
        let (at, is_near) = self.project(momentum.normalize_or_zero().as_vec3());
        (is_near && at.is_finite()).then_some(at)
    }

    /// What a start at this point of the sphere (principal axes) would be.
    pub(super) fn preview(&self, body: &Body, at: Vec3) -> Preview {
        let momentum = body.body_from_principal() * at.as_dvec3();
        let path = poinsot::polhode(body, momentum, POINTS);
        let principal = |m: DVec3| (body.body_from_principal().transpose() * m).as_vec3();
        Preview {
            at: self.project(at).0,
            path: path.into_iter().map(|m| self.project(principal(m))).collect(),
            words: poinsot::classify(body, momentum).label(),
        }
    }
}

/// The point of the unit sphere's outline, as the eye sees it, on the side of a direction: there `eye · point = 1`.
fn outline_towards(eye: Vec3, direction: Vec3) -> Vec3 {
    let aside = direction.reject_from(eye).normalize_or(eye.any_orthonormal_vector());
    let along = eye.length_recip();
    (eye.normalize() * along + aside * (1.0 - along * along).max(0.0).sqrt()).normalize()
}
