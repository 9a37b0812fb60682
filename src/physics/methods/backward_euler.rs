//! Backward Euler on the entries of R: implicit, stable, and as wrong as forward Euler the other way round.

use glam::{DMat3, DVec3};

use super::linear::{Entries, Linear, Rule};
use super::{Dash, Hue, Keeps, Mark, Method, Order};
use crate::physics::so3;

pub(super) const METHOD: Method = Method {
    name: "backward-euler",
    label: "Backward Euler",
    order: Order::Finite(1),
    explicit: false,
    symplectic: false,
    keeps_momentum: Keeps::No,
    keeps_rotation: Keeps::No,
    keeps_energy: Keeps::No,
    is_direct: false,
    cost: "some three 3×3 inverses",
    source: "Hairer & Wanner, Solving Ordinary Differential Equations II, IV.3",
    hue: Hue { on_dark: 0x00d6_86b4, on_light: 0x00a0_6487 },
    dash: Dash::Short,
    mark: Mark::TriangleDown,
    start: Linear::<BackwardEuler>::start,
};

/// `yₙ₊₁ = yₙ + h f(yₙ₊₁)`.
///
/// First the momentum, `M′ = M + h M′ × I⁻¹M′`, by Newton's method; then the attitude, linear in R′:
/// `R′ = R (1 − h[Ω′×])⁻¹`.
struct BackwardEuler;

impl Rule for BackwardEuler {
    fn step(inverse_moments: DVec3, now: Entries, h: f64) -> Option<Entries> {
        let momentum = solve_momentum(inverse_moments, now.momentum, h)?;
        let v = h * inverse_moments * momentum;
        // (1 − [v×])⁻¹ = (1 + [v×] + v vᵀ)/(1 + v²).
        let outer = DMat3::from_cols(v * v.x, v * v.y, v * v.z);
        let inverse = (DMat3::IDENTITY + so3::hat(v) + outer) * (1.0 / (1.0 + v.length_squared()));
        Some(Entries { attitude: now.attitude * inverse, momentum })
    }
}

/// Newton's method on `M′ − M − h M′ × I⁻¹M′ = 0` from `M′ = M`. Solved means: the last correction is below 1e-10 of M′,
/// so that the one before rounding, its square, is lost. `None` after 30 corrections.
fn solve_momentum(inverse_moments: DVec3, momentum: DVec3, h: f64) -> Option<DVec3> {
    let inverse_inertia = DMat3::from_diagonal(inverse_moments);
    let mut next = momentum;
    for _ in 0..30 {
        let velocity = inverse_moments * next;
        let residual = next - momentum - h * next.cross(velocity);
        let slope = DMat3::IDENTITY - (so3::hat(next) * inverse_inertia - so3::hat(velocity)) * h;
        let correction = slope.inverse() * residual;
        next -= correction;
        if !next.is_finite() {
            return None;
        }
        if correction.length() <= 1e-10 * next.length() {
            return Some(next);
        }
    }
    None
}
