//! The implicit midpoint rule on the body momentum, as two robot simulators advance a free body.

use glam::{DMat3, DVec3};

use super::free_momentum::{Advance, FreeMomentum, MomentumRule};
use super::{Dash, Hue, Keeps, Mark, Method, Order};
use crate::physics::so3;

pub(super) const METHOD: Method = Method {
    name: "implicit-midpoint",
    label: "Implicit midpoint, as in Genesis and MuJoCo 3.10",
    order: Order::Finite(2),
    explicit: false,
    symplectic: false,
    keeps_momentum: Keeps::Nearby,
    keeps_rotation: Keeps::Exactly,
    keeps_energy: Keeps::Exactly,
    is_direct: false,
    cost: "some three 3×3 inverses, one sin/cos",
    source: "Hairer, Lubich & Wanner, Geometric Numerical Integration, IV.2; Genesis 2026, pull request 3074, after MuJoCo 3.10",
    hue: Hue { on_dark: 0x00f0_7878, on_light: 0x00b4_5a5a },
    dash: Dash::Short,
    mark: Mark::Hourglass,
    start: FreeMomentum::<Midpoint>::start,
};

/// `M′ = M + h M̄×Ω̄`, `M̄ = (M + M′)/2`, `Ω̄ = I⁻¹M̄`, and the attitude turns by `hΩ̄`.
///
/// A midpoint rule keeps every quadratic invariant, here `|M|` and the energy. M itself turns by the Cayley transform of `hΩ̄` and
/// the attitude by its exponential: they differ by `(h|Ω|)³/12` a step, so that `RM` sways about L by some `(h|Ω|)²`.
struct Midpoint;

impl MomentumRule for Midpoint {
    fn step(inverse_moments: DVec3, momentum: DVec3, h: f64) -> Option<Advance> {
        let half_change = solve_half_change(inverse_moments, momentum, 0.5 * h)?;
        let velocity = inverse_moments * (momentum + half_change);
        Some(Advance { momentum: momentum + 2.0 * half_change, velocity })
    }
}

/// Newton's method on `d − (h/2) M̄ × I⁻¹M̄ = 0`, `M̄ = M + d`, from `d = 0`. Solved means: the last correction is below 1e-9 of M,
/// so that the next, its square, is lost in rounding. `None` after 30 corrections.
///
/// The change is solved for and not M̄, so that what rounding does to it is small where it is: else a spin that stays where it is
/// would gain or lose an ε each step, always to the same side.
fn solve_half_change(inverse_moments: DVec3, momentum: DVec3, half: f64) -> Option<DVec3> {
    let inverse_inertia = DMat3::from_diagonal(inverse_moments);
    let mut half_change = DVec3::ZERO;
    for _ in 0..30 {
        let middle = momentum + half_change;
        let velocity = inverse_moments * middle;
        let residual = half_change - half * middle.cross(velocity);
        let slope = DMat3::IDENTITY - (so3::hat(middle) * inverse_inertia - so3::hat(velocity)) * half;
        let correction = slope.inverse() * residual;
        half_change -= correction;
        if !half_change.is_finite() {
            return None;
        }
        if correction.length() <= 1e-9 * momentum.length() {
            return Some(half_change);
        }
    }
    None
}
