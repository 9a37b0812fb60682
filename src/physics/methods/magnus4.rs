//! Buss' fourth-order method: Magnus' expansion of the angular velocity to the third power of the step.

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
/// `a = Ω′`, `ω″ = Ω″ + Ω×Ω′`, `ω‴ = Ω‴ + 2Ω×Ω″ + Ω×(Ω×Ω′)`.
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

        let first_cross = v0.cross(v1);
        let second = v2 + first_cross;
        let third = v3 + 2.0 * v0.cross(v2) + v0.cross(first_cross);
        let mean = v0
            + h / 2.0 * v1
            + h * h / 6.0 * second
            + h * h / 12.0 * v1.cross(v0)
            + h * h * h / 24.0 * (third + second.cross(v0));
        Some(turn_by(mean, h))
    }
}
