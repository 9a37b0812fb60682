//! What an object may know: the simulation, the settings, and the scales that bring both spaces to size 1.

use glam::{DMat3, DQuat, DVec3, Mat3, Vec3};

use super::Palette;
use crate::frame::{single, single_matrix};
use crate::physics::{State, so3};
use crate::scene;
use crate::sim::Simulation;

/// Radius at which the body is drawn in the world view.
const BODY_RADIUS: f64 = 0.86;
/// Height at which the tip of ω moves in the world view.
const OMEGA_HEIGHT: f64 = 1.02;

/// What the objects of a picture are made from.
#[derive(Debug)]
pub struct Context<'a> {
    /// The simulation.
    pub simulation: &'a Simulation,
    /// The settings of the view.
    pub settings: &'a scene::View,
    /// The colours.
    pub palette: Palette,
    /// Turns the world so that the angular momentum points up (z).
    picture_from_world: DMat3,
    /// Units of the picture a metre.
    per_metre: f64,
    /// |L| of the start (kg m²/s).
    momentum_length: f64,
    /// Units of the picture a rad/s.
    per_radian: f64,
}

impl<'a> Context<'a> {
    pub(super) fn new(simulation: &'a Simulation, settings: &'a scene::View, palette: Palette) -> Self {
        let scene = simulation.scene();
        let momentum = scene.start.world_momentum;
        let momentum_length = so3::norm(momentum);
        let radius = scene.parts.iter().map(|part| part.centre.length() + 0.5 * part.size.length()).fold(0.0, f64::max);
        // ω·L/ℓ = 2K/ℓ is constant: the tip of ω moves in a plane, drawn at a fixed height.
        let energy = scene.start.energy(&scene.body);
        let height = 2.0 * energy / momentum_length;
        let reciprocal = |value: f64| if value.is_normal() { value.recip() } else { 0.0 };
        Self {
            simulation,
            settings,
            palette,
            picture_from_world: upright(momentum, momentum_length),
            per_metre: BODY_RADIUS * reciprocal(radius),
            momentum_length,
            per_radian: OMEGA_HEIGHT * reciprocal(height),
        }
    }

    /// Takes the body's own axes to the picture of the world.
    #[must_use]
    pub fn world_from_body(&self, state: &State) -> Mat3 {
        single_matrix(self.picture_from_world * state.world_from_body)
    }

    /// Units of the picture a metre.
    #[must_use]
    pub fn per_metre(&self) -> f64 {
        self.per_metre
    }

    /// An angular velocity of the world (rad/s) as an arrow of the picture.
    #[must_use]
    pub fn world_angular_velocity(&self, omega: DVec3) -> Vec3 {
        single(self.picture_from_world * (omega * self.per_radian))
    }

    /// A momentum of the world as an arrow of the picture, of length 1 where it is as long as at the start.
    #[must_use]
    pub fn world_momentum(&self, momentum: DVec3) -> Vec3 {
        single(self.picture_from_world * self.unit(momentum))
    }

    /// A body momentum as a point of momentum space: principal components, the sphere of radius 1.
    #[must_use]
    pub fn body_momentum(&self, momentum: DVec3) -> Vec3 {
        let body = self.simulation.body();
        single(body.body_from_principal().transpose() * self.unit(momentum))
    }

    /// |L| at the start (kg m²/s).
    #[must_use]
    pub fn momentum_length(&self) -> f64 {
        self.momentum_length
    }

    /// A momentum in units of the start's, without overflow.
    fn unit(&self, momentum: DVec3) -> DVec3 {
        if self.momentum_length > 0.0 { momentum / self.momentum_length } else { DVec3::ZERO }
    }
}

/// The shortest turn that takes a momentum to the vertical.
fn upright(momentum: DVec3, length: f64) -> DMat3 {
    if length == 0.0 || !length.is_finite() {
        return DMat3::IDENTITY;
    }
    let up = (momentum / length).normalize();
    if up.z < -0.999_999 {
        return DMat3::from_diagonal(DVec3::new(1.0, -1.0, -1.0));
    }
    DMat3::from_quat(DQuat::from_rotation_arc(up, DVec3::Z))
}
