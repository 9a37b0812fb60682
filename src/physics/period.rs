//! One period of the momentum: how long it takes M to come round, the solid angle of its path, and how far the body has turned by then.
//!
//! When M has come back after T, attitude and L have not parted: the body is what it was but for a turn about L, by
//!
//! ```text
//! Δψ = 2KT/ℓ − Λ
//! ```
//!
//! with Λ the solid angle of M's path, on the side of the axis that it circles, positive where it goes round that axis counter-clockwise
//! seen from outside. The first term is what ω along L makes, `ω·L/ℓ = 2K/ℓ`; the second is the share of geometry alone. Source: Montgomery,
//! How much does the rigid body rotate?, Am. J. Phys. 59 (1991) 394.
//!
//! In standard position M circles axis 3 with `φ̇ = M₃(2K − ℓ²/I₃)/(ℓ² − M₃²)`, so that `Λ̇ = (1 − M₃/ℓ)φ̇ = (2K/ℓ − ℓ/I₃) M₃/(ℓ + M₃)`, and
//! `2K/ℓ − Λ̇ = (2K + ℓM₃/I₃)/(ℓ + M₃)` is the rate ψ̇ of the [exact motion](super::exact): its mean times T is Δψ, with no turn left out.

use std::f64::consts::TAU;

use glam::DVec3;

use super::exact::rates;
use super::orbit::{Kind, Orbit};
use super::start::Start;
use super::{Body, State, poinsot, so3};

/// What one period of the momentum comes to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Period {
    /// Its length T (s).
    pub time: f64,
    /// Δψ (rad), whole turns with it.
    pub turn: f64,
    /// Λ (sr).
    pub solid_angle: f64,
    /// The principal axis that M circles, in the body frame, on M's side.
    pub axis: DVec3,
}

/// The period of the motion that starts here.
///
/// `None` where M never comes back: a steady spin, of which any time is a period, and the separatrix. Relative errors of time and turn some ε;
/// Λ is what the two terms leave, good to some ε of the larger one.
#[must_use]
pub fn period_of(body: &Body, start: &State) -> Option<Period> {
    let orbit = Orbit::new(&Start::new(body, start));
    if orbit.kind != Kind::Circling {
        return None;
    }
    let (phase_rate, angle_rate) = rates(&orbit);
    let (momentum, moments, ell) = (orbit.momentum, orbit.moments, orbit.ell.value());
    // In the orbit's units.
    let time = TAU / phase_rate.value();
    let turn = TAU * (angle_rate / phase_rate).value();
    let along = momentum.dot(momentum / moments) / ell * time;
    let seconds = orbit.seconds(time);
    let axis = body.body_from_principal() * orbit.principal_from_standard.z_axis;
    seconds.is_finite().then_some(Period { time: seconds, turn, solid_angle: along - turn, axis })
}

/// Momenta (kg m²/s) on the four branches of the separatrix, a time (s) after each passed between the ends of the middle axis, for a momentum of length ℓ:
/// `M = ℓ(d sech σt ± e₂ tanh σt)`, σ the [growth rate](poinsot::growth_rate), d the direction midway, the sign that of `d₁d₃`, for
/// `Ṁ₂ = M₁M₃(1/I₁ − 1/I₃)`. `None` where two moments are equal.
#[must_use]
pub fn separatrix_at(body: &Body, ell: f64, time: f64) -> Option<[DVec3; 4]> {
    let i = body.principal_moments();
    let [i21, _, i32] = body.moment_differences();
    if i21 == 0.0 || i32 == 0.0 {
        return None;
    }
    let midway = DVec3::new((i.x / i.z * i32).sqrt(), 0.0, i21.sqrt()).normalize();
    let u = poinsot::growth_rate(body, ell) * time;
    let branch = |first: f64, third: f64| {
        let direction = DVec3::new(first, 0.0, third) * midway;
        let momentum = direction / u.cosh() + DVec3::Y * (first * third * u.tanh());
        body.body_from_principal() * (momentum * ell)
    };
    Some([branch(1.0, 1.0), branch(-1.0, 1.0), branch(-1.0, -1.0), branch(1.0, -1.0)])
}

/// The body's turn about L between two states of the same L (rad, −π to π): of `R₂R₁ᵀ` the angle about that line.
#[must_use]
pub fn turn_about_momentum(before: &State, after: &State) -> f64 {
    let turn = so3::quaternion(after.world_from_body * before.world_from_body.transpose());
    let axis = before.world_momentum / so3::norm(before.world_momentum);
    let angle = 2.0 * turn.xyz().dot(axis).atan2(turn.w);
    if angle > std::f64::consts::PI { angle - TAU } else { angle }
}
