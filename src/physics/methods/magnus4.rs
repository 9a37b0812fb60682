//! Buss' fourth-order method: Magnus' expansion of the angular velocity to the third power of the step. It is the one that knows energy loss.
//!
//! Inside a body that is not quite rigid energy is lost while L stays. The double bracket of Bloch, Krishnaprasad, Marsden & Ratiu,
//! Commun. Math. Phys. 175 (1996) 1, does this to the equations:
//!
//! ```text
//! Ṙ = R[Ω_eff×],   Ω_eff = Ω + c M×Ω,   hence   Ṁ = M×Ω + c M×(M×Ω)
//! ```
//!
//! `M = RᵀL` solves the second, so that `RM = L` and `|M| = ℓ` stay. Of the energy `K̇ = Ω·Ṁ = c Ω·(M×(M×Ω)) = −c |M×Ω|² ≤ 0`: it falls
//! until `M×Ω = 0`, a steady spin, of which only that about axis 3 is stable. c is one over a momentum, so with `c = loss/ℓ` the loss is
//! a number without a unit: a small wobble about axis 3 dies away as `e^(−loss ℓ d t)`, d the mean of `1/I₁ − 1/I₃` and `1/I₂ − 1/I₃`.
//!
//! Of the friction inside a real body the double bracket has this much, that it takes energy and no momentum, and stops where the
//! spin is steady; how fast, and by which way, is its own.

use glam::{DQuat, DVec3};

use super::lie_group::{LieGroup, MeanVelocity, turn_by};
use super::{Dash, Hue, Keeps, Mark, Method, Order};

pub(super) const METHOD: Method = Method {
    name: "magnus4",
    label: "Magnus 4 (Buss)",
    order: Order::Finite(4),
    explicit: true,
    symplectic: false,
    keeps_momentum: Keeps::Exactly,
    keeps_rotation: Keeps::Exactly,
    keeps_energy: Keeps::No,
    is_direct: false,
    cost: "one sin/cos, a dozen cross products",
    source: "Buss, J. Comput. Phys. 164 (2000) 377, augmented fourth order; Magnus, Comm. Pure Appl. Math. 7 (1954) 649",
    hue: Hue { on_dark: 0x0030_80d0, on_light: 0x0024_609c },
    dash: Dash::Short,
    mark: Mark::OpenDiamond,
    start: LieGroup::<Magnus4>::start,
};

/// `ω̄ = ω + h/2 a + h²/6 ω″ + h²/12 a×ω + h³/24 ω‴ + h³/24 ω″×ω`, `a = ω′`, with the derivatives in the world frame.
///
/// In body components the derivatives follow from those of Ω in the body, `Ω′ = I⁻¹(M×Ω)` and so on by the product rule:
/// `a = Ω′`, `ω″ = Ω″ + Ω×Ω′`, `ω‴ = Ω‴ + 2Ω×Ω″ + Ω×(Ω×Ω′)`. Where energy is lost `Ω_eff` stands for Ω, and its derivatives have those
/// of `c M×Ω` besides.
struct Magnus4;

impl MeanVelocity for Magnus4 {
    fn rotation_of_step(inverse_moments: DVec3, momentum: DVec3, h: f64) -> Option<DQuat> {
        let m0 = momentum;
        let v0 = inverse_moments * m0;
        let m1 = m0.cross(v0);
        let v1 = inverse_moments * m1;
        let m2 = m1.cross(v0) + m0.cross(v1);
        let v2 = inverse_moments * m2;
        let v3 = inverse_moments * (m2.cross(v0) + 2.0 * m1.cross(v1) + m0.cross(v2));
        Some(turn_by(mean(v0, v1, v2, v3, h), h))
    }

    fn rotation_of_losing_step(inverse_moments: DVec3, momentum: DVec3, h: f64, damping: f64) -> Option<DQuat> {
        // M and Ω with their derivatives, and Ω_eff with its own.
        let m0 = momentum;
        let w0 = inverse_moments * m0;
        let v0 = w0 + damping * m0.cross(w0);
        let m1 = m0.cross(v0);
        let w1 = inverse_moments * m1;
        let v1 = w1 + damping * (m1.cross(w0) + m0.cross(w1));
        let m2 = m1.cross(v0) + m0.cross(v1);
        let w2 = inverse_moments * m2;
        let v2 = w2 + damping * (m2.cross(w0) + 2.0 * m1.cross(w1) + m0.cross(w2));
        let m3 = m2.cross(v0) + 2.0 * m1.cross(v1) + m0.cross(v2);
        let w3 = inverse_moments * m3;
        let v3 = w3 + damping * (m3.cross(w0) + 3.0 * (m2.cross(w1) + m1.cross(w2)) + m0.cross(w3));
        Some(turn_by(mean(v0, v1, v2, v3, h), h))
    }
}

/// The mean angular velocity over a step, of the angular velocity in the body and its derivatives there.
fn mean(v0: DVec3, v1: DVec3, v2: DVec3, v3: DVec3, h: f64) -> DVec3 {
    let first_cross = v0.cross(v1);
    let second = v2 + first_cross;
    let third = v3 + 2.0 * v0.cross(v2) + v0.cross(first_cross);
    v0 + h / 2.0 * v1
        + h * h / 6.0 * second
        + h * h / 12.0 * v1.cross(v0)
        + h * h * h / 24.0 * (third + second.cross(v0))
}
