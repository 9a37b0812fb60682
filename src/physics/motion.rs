//! A free rigid body at one moment, and the equation it obeys.

use glam::{DMat3, DVec3};

use super::{Body, so3};

/// Attitude and momentum at one moment. World momentum is stored and never recomputed from the attitude, so that
/// a method which keeps it keeps every bit of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Attitude `R`: takes body components to world components. A rotation, except under the methods that do not keep it one.
    pub world_from_body: DMat3,
    /// Body momentum `M` (kg m²/s).
    pub body_momentum: DVec3,
    /// World momentum `L = RM` (kg m²/s).
    pub world_momentum: DVec3,
    /// The numbers that it was made of.
    origin: Origin,
}

/// What a state was made from. The exact motion starts from that and not from the rounded momentum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Origin {
    /// An angular velocity in the body frame (rad/s).
    AngularVelocity(DVec3),
    /// An angular velocity in the principal frame (rad/s).
    PrincipalAngularVelocity(DVec3),
    /// Its body momentum: nothing more is known.
    Momentum,
}

impl State {
    /// The state with this attitude (a rotation) and body angular velocity (rad/s).
    #[must_use]
    pub fn new(body: &Body, world_from_body: DMat3, body_angular_velocity: DVec3) -> Self {
        let body_momentum = body.momentum(body_angular_velocity);
        let origin = Origin::AngularVelocity(body_angular_velocity);
        Self { world_from_body, body_momentum, world_momentum: world_from_body * body_momentum, origin }
    }

    /// The state with this attitude (a rotation) and an angular velocity (rad/s) along the principal axes 1, 2, 3. It is exact in their
    /// frame, also where they are turned: a spin about an axis stays about that axis for ever.
    #[must_use]
    pub fn in_principal_frame(body: &Body, world_from_body: DMat3, angular_velocity: DVec3) -> Self {
        let body_momentum = body.body_from_principal() * (body.principal_moments() * angular_velocity);
        let origin = Origin::PrincipalAngularVelocity(angular_velocity);
        Self { world_from_body, body_momentum, world_momentum: world_from_body * body_momentum, origin }
    }

    /// The state of a body that a method has moved.
    pub(crate) fn from_parts(world_from_body: DMat3, body_momentum: DVec3, world_momentum: DVec3) -> Self {
        Self { world_from_body, body_momentum, world_momentum, origin: Origin::Momentum }
    }

    /// The numbers that it was made of.
    pub(crate) fn origin(&self) -> Origin {
        self.origin
    }

    /// Body angular velocity `Ω = I⁻¹M` (rad/s).
    #[must_use]
    pub fn body_angular_velocity(&self, body: &Body) -> DVec3 {
        body.angular_velocity(self.body_momentum)
    }

    /// World angular velocity `ω = RΩ` (rad/s).
    #[must_use]
    pub fn world_angular_velocity(&self, body: &Body) -> DVec3 {
        self.world_from_body * self.body_angular_velocity(body)
    }

    /// Kinetic energy `K = ½ M·I⁻¹M` (J).
    #[must_use]
    pub fn energy(&self, body: &Body) -> f64 {
        body.energy(self.body_momentum)
    }

    /// Inertia in the world frame, `R I Rᵀ` (kg m²): it turns with the body.
    #[must_use]
    pub fn world_inertia(&self, body: &Body) -> DMat3 {
        self.world_from_body * body.inertia() * self.world_from_body.transpose()
    }
}

/// How far the world momentum has gone from that of the start, `|R M − L₀|/ℓ`; absolute (kg m²/s) where the start is at rest. It is measured on
/// attitude and body momentum as they are, not taken from a momentum that a method stores.
#[must_use]
pub fn momentum_error(start: &State, now: &State) -> f64 {
    let ell = so3::norm(start.world_momentum);
    let unit = if ell == 0.0 { 1.0 } else { ell };
    so3::norm(now.world_from_body * (now.body_momentum / unit) - start.world_momentum / unit)
}

/// How far the energy has gone from that of the start, `(K − K₀)/K₀`; absolute (J) where the start is at rest. Negative where some is lost.
#[must_use]
pub fn energy_error(body: &Body, start: &State, now: &State) -> f64 {
    let (before, difference) = (start.energy(body), now.energy(body) - start.energy(body));
    if before == 0.0 { difference } else { difference / before }
}

/// Euler's equation, the rate of the body momentum: `Ṁ = M × Ω` (kg m²/s²).
#[must_use]
pub fn momentum_rate(body: &Body, body_momentum: DVec3) -> DVec3 {
    body_momentum.cross(body.angular_velocity(body_momentum))
}
