//! What an object may know: the simulation, the settings, and the scales that bring both spaces to size 1.

use std::f64::consts::TAU;

use glam::{DMat3, DQuat, DVec3, Mat3, Vec3};

use super::{OBJECTS, Object, Palette, Role, is_shown};
use crate::frame::{single, single_matrix};
use crate::physics::{State, poinsot, so3};
use crate::scene::{self, Scene};
use crate::sim::Simulation;

/// Radius at which the body is drawn in the world view.
const BODY_RADIUS: f64 = 0.95;
/// Length of L's arrow, a little beyond the plane of ω's tip.
const MOMENTUM_ARROW: f32 = 1.34;
/// Height at which the tip of ω moves in the world view.
const OMEGA_HEIGHT: f64 = 1.02;
/// Longest semi-axis of Poinsot's ellipsoid in the picture; where it is shown ω is drawn small enough for that.
const LONGEST_SEMI_AXIS: f64 = 1.3;

/// What the objects of a picture are made from.
#[derive(Debug)]
pub struct Context<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// Its motion.
    pub simulation: &'a Simulation,
    /// The settings of the view.
    pub settings: &'a scene::View,
    /// The colours.
    pub palette: Palette,
    /// Factor on type and lines, besides the one that the settings say.
    pub(super) type_scale: f32,
    /// Width over height of the picture.
    pub(super) aspect: f32,
    /// Turns the world so that the angular momentum points up (z).
    picture_from_world: DMat3,
    /// Units of the picture a metre.
    per_metre: f64,
    /// |L| of the start (kg m²/s).
    momentum_length: f64,
    /// Units of the picture a rad/s.
    per_radian: f64,
    /// Height of the tip of ω.
    plane_height: f64,
    /// Length of L's arrow while |L| is that of the start.
    momentum_arrow: f32,
    /// A time (s) in which much happens: between flips, or about a turn where there are none.
    period: f64,
}

impl<'a> Context<'a> {
    pub(super) fn new(scene: &'a Scene, simulation: &'a Simulation, palette: &Palette) -> Self {
        let settings = &scene.view;
        let momentum = scene.start.world_momentum;
        let momentum_length = so3::norm(momentum);
        let radius = scene.parts.iter().map(|part| part.centre.length() + 0.5 * part.size.length()).fold(0.0, f64::max);
        // ω·L/ℓ = 2K/ℓ is constant: the tip of ω moves in a plane, drawn at a fixed height.
        let energy = scene.start.energy(&scene.body);
        let height = 2.0 * energy / momentum_length;
        let ratio = (2.0 * energy / scene.body.principal_moments().x).sqrt() / height;
        let needs_room = shows_any(settings, |role| role == Role::RollingEllipsoid);
        let plane_height = if needs_room { OMEGA_HEIGHT.min(LONGEST_SEMI_AXIS / ratio) } else { OMEGA_HEIGHT };
        let turn = TAU / so3::norm(scene.start.body_angular_velocity(&scene.body));
        let flip = poinsot::flip_period_of(&scene.body, &scene.start);
        let period = flip.unwrap_or(2.0 * turn).min(20.0 * turn);
        // Where energy is lost, ω's tip comes down: with Poinsot's construction the plane that is rolled on comes up likewise.
        let rolls = shows_any(settings, |role| matches!(role, Role::RollingEllipsoid | Role::OnPlane));
        let left = if simulation.energy_loss() > 0.0 && rolls && energy > 0.0 {
            simulation.state().energy(&scene.body) / energy
        } else {
            1.0
        };
        let reciprocal = |value: f64| if value.is_normal() { value.recip() } else { 0.0 };
        Self {
            scene,
            simulation,
            settings,
            palette: *palette,
            type_scale: 1.0,
            aspect: 1.0,
            picture_from_world: upright(momentum, momentum_length),
            per_metre: BODY_RADIUS * reciprocal(radius),
            momentum_length,
            per_radian: plane_height * reciprocal(height),
            plane_height: plane_height * left,
            // Where the sphere |M| = |L| is drawn too, L ends on it.
            momentum_arrow: if shows_any(settings, |role| role == Role::MomentumSphere) { 1.0 } else { MOMENTUM_ARROW },
            period: if period.is_finite() { period } else { 1.0 },
        }
    }

    /// Whether the settings show an object.
    pub(super) fn shows(&self, object: &Object) -> bool {
        is_shown(object, self.settings)
    }

    /// Whether they show any object of the world with a role like this.
    pub(super) fn shows_any(&self, is_meant: impl Fn(Role) -> bool) -> bool {
        shows_any(self.settings, is_meant)
    }

    /// Length of L's arrow while |L| is that of the start.
    #[must_use]
    pub fn momentum_arrow(&self) -> f32 {
        self.momentum_arrow
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
        single(self.principal_unit(momentum))
    }

    /// A body momentum in principal components and units of ℓ at the start, with all its digits.
    pub(super) fn principal_unit(&self, momentum: DVec3) -> DVec3 {
        self.simulation.body().body_from_principal().transpose() * self.unit(momentum)
    }

    /// The body momentum now in units of ℓ at the start; none where there is none.
    #[must_use]
    pub fn unit_momentum(&self) -> Option<DVec3> {
        let unit = self.unit(self.simulation.state().body_momentum);
        (unit != DVec3::ZERO && unit.is_finite()).then_some(unit)
    }

    /// Principal components of a vector of the body.
    #[must_use]
    pub fn principal(&self, vector: DVec3) -> Vec3 {
        single(self.simulation.body().body_from_principal().transpose() * vector)
    }

    /// Units of the picture a rad/s.
    #[must_use]
    pub fn per_radian(&self) -> f64 {
        self.per_radian
    }

    /// Height above the centre at which the tip of ω moves, and depth below it of the invariable plane.
    #[must_use]
    pub fn plane_height(&self) -> f32 {
        self.plane_height as f32
    }

    /// A time (s) in which much happens: between flips, or about two turns where there are none.
    #[must_use]
    pub fn period(&self) -> f64 {
        self.period
    }

    /// A momentum in units of the start's, without overflow.
    fn unit(&self, momentum: DVec3) -> DVec3 {
        if self.momentum_length > 0.0 { momentum / self.momentum_length } else { DVec3::ZERO }
    }
}

fn shows_any(settings: &scene::View, is_meant: impl Fn(Role) -> bool) -> bool {
    OBJECTS.iter().any(|object| is_meant(object.role) && is_shown(object, settings))
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
