//! Buss' augmented second-order method.

use glam::{DQuat, DVec3};

use super::lie_group::{LieGroup, MeanVelocity, turn_by};
use super::{Dash, Hue, Keeps, Mark, Method, Order};

pub(super) const METHOD: Method = Method {
    name: "buss",
    label: "Buss, augmented second order",
    order: Order::Finite(2),
    explicit: true,
    symplectic: false,
    keeps_momentum: Keeps::Exactly,
    keeps_rotation: Keeps::Exactly,
    keeps_energy: Keeps::No,
    is_direct: false,
    cost: "one sin/cos, three cross products",
    source: "Buss, J. Comput. Phys. 164 (2000) 377, augmented second order",
    hue: Hue { on_dark: 0x00e6_b400, on_light: 0x00ac_8700 },
    dash: Dash::Solid,
    mark: Mark::Triangle,
    start: LieGroup::<Buss>::start,
};

/// `ω̄ = ω + h/2 α + h²/12 α×ω` with `α = −I_world⁻¹(ω × L)`, in body components `α = −I⁻¹(Ω × M)`.
struct Buss;

impl MeanVelocity for Buss {
    fn rotation_of_step(inverse_moments: DVec3, momentum: DVec3, step: f64) -> Option<DQuat> {
        let velocity = inverse_moments * momentum;
        let acceleration = -inverse_moments * velocity.cross(momentum);
        let mean = velocity + 0.5 * step * acceleration + step * step / 12.0 * acceleration.cross(velocity);
        Some(turn_by(mean, step))
    }
}
