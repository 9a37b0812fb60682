//! A camera that orbits a point, told only by how much it is turned: it knows no mouse and no window.

use std::f32::consts::{FRAC_PI_2, PI, TAU};

use glam::{Mat4, Vec2, Vec3};

/// Distance of the near plane; there is no far plane (reversed depth, infinite range).
pub const NEAR: f32 = 0.02;
/// Half the angle of view across the smaller side of a view (rad): narrow, so that parallels look parallel.
const HALF_FIELD: f32 = 13.0 * PI / 180.0;
const NEAREST: f32 = 0.4;
const FARTHEST: f32 = 60.0;
/// Farthest that the target is panned from the middle: something stays in sight.
const FARTHEST_TARGET: f32 = 1.5;
/// Short of straight up or down, where `up` and the view direction would fall together.
const STEEPEST: f32 = FRAC_PI_2 - 0.01;

/// An orbit camera about `target`; z is up. Lengths are in units of what the view shows (about 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Angle of the eye about the vertical (rad), from the x axis towards y.
    pub azimuth: f32,
    /// Angle of the eye above the horizontal (rad).
    pub elevation: f32,
    /// Distance of the eye from the target.
    pub distance: f32,
    /// The point looked at.
    pub target: Vec3,
}

impl Camera {
    /// A camera that looks at the origin. Angles in rad.
    #[must_use]
    pub fn new(azimuth: f32, elevation: f32, distance: f32) -> Self {
        let mut camera = Self { azimuth, elevation, distance, target: Vec3::ZERO };
        camera.settle();
        camera
    }

    /// The camera this far (0 to 1) on the way from one to another, round the vertical the shorter way.
    #[must_use]
    pub fn between(from: &Self, to: &Self, part: f32) -> Self {
        let turn = (to.azimuth - from.azimuth + PI).rem_euclid(TAU) - PI;
        let mut camera = Self {
            azimuth: from.azimuth + turn * part,
            elevation: from.elevation + (to.elevation - from.elevation) * part,
            distance: from.distance * (to.distance / from.distance).powf(part),
            target: from.target.lerp(to.target, part),
        };
        camera.settle();
        camera
    }

    /// Turns by this part of a view's smaller side (x to the right, y down, as a cursor moves); a drag across
    /// the whole side turns half a circle. Returns whether anything changed.
    pub fn orbit(&mut self, moved: Vec2) -> bool {
        self.change(|camera| {
            camera.azimuth -= moved.x * PI;
            camera.elevation += moved.y * PI;
        })
    }

    /// Shifts the target so that what is looked at follows the cursor; `moved` as in [`Camera::orbit`].
    pub fn pan(&mut self, moved: Vec2) -> bool {
        self.change(|camera| {
            let (right, up, _) = camera.axes();
            let span = 2.0 * camera.distance * HALF_FIELD.tan();
            camera.target += (up * moved.y - right * moved.x) * span;
        })
    }

    /// Comes nearer for positive steps (one is a notch of a wheel), farther for negative ones.
    pub fn zoom(&mut self, steps: f32) -> bool {
        self.change(|camera| camera.distance *= (-0.1 * steps).exp())
    }

    fn change(&mut self, edit: impl FnOnce(&mut Self)) -> bool {
        let before = *self;
        edit(self);
        self.settle();
        let sound = self.azimuth.is_finite() && self.distance.is_finite() && self.target.is_finite();
        if !(sound && self.elevation.is_finite()) {
            *self = before;
        }
        *self != before
    }

    /// Brings every value into its range.
    fn settle(&mut self) {
        self.azimuth = self.azimuth.rem_euclid(TAU);
        self.elevation = self.elevation.clamp(-STEEPEST, STEEPEST);
        self.distance = self.distance.clamp(NEAREST, FARTHEST);
        self.target = self.target.clamp_length_max(FARTHEST_TARGET);
    }

    /// Where the eye is.
    #[must_use]
    pub fn eye(&self) -> Vec3 {
        self.target - self.axes().2 * self.distance
    }

    /// Right, up and forward of the picture, orthonormal.
    #[must_use]
    pub fn axes(&self) -> (Vec3, Vec3, Vec3) {
        let (sin_a, cos_a) = self.azimuth.sin_cos();
        let (sin_e, cos_e) = self.elevation.sin_cos();
        let forward = -Vec3::new(cos_e * cos_a, cos_e * sin_a, sin_e);
        let right = Vec3::new(-sin_a, cos_a, 0.0);
        (right, right.cross(forward), forward)
    }

    /// The vertical angle of view (rad) in a view of this aspect (width over height): what fits the smaller
    /// side does not depend on the aspect.
    #[must_use]
    pub fn vertical_field(aspect: f32) -> f32 {
        if aspect >= 1.0 { 2.0 * HALF_FIELD } else { 2.0 * (HALF_FIELD.tan() / aspect.max(1e-3)).atan() }
    }

    /// The projection times the view: from the view's world to clip space, depth 1 at [`NEAR`] and 0 at infinity.
    #[must_use]
    pub fn clip_from_world(&self, aspect: f32) -> Mat4 {
        let (_, up, forward) = self.axes();
        let eye = self.eye();
        let view = glam::camera::rh::view::look_to_mat4(eye, forward, up);
        let field = Self::vertical_field(aspect);
        glam::camera::rh::proj::directx::perspective_infinite_reverse(field, aspect.max(1e-3), NEAR) * view
    }
}
