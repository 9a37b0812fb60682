//! Buss' augmented second-order method.

use glam::DVec3;

use super::lie_group::LieGroup;
use super::{Keeps, Method, Order};

pub(super) const METHOD: Method = Method {
    name: "buss",
    label: "Buss, augmented second order",
    order: Order::Finite(2),
    explicit: true,
    symplectic: false,
    keeps_momentum: Keeps::Exactly,
    keeps_rotation: Keeps::Exactly,
    keeps_energy: Keeps::No,
    cost: "one sin/cos, three cross products",
    source: "Buss, J. Comput. Phys. 164 (2000) 377, augmented second order",
    start: |moments, momentum| LieGroup::start(METHOD.name, mean_velocity, moments, momentum),
};

/// `ω̄ = ω + h/2 α + h²/12 α×ω` with `α = −I_world⁻¹(ω × L)`, in body components `α = −I⁻¹(Ω × M)`.
fn mean_velocity(inverse_moments: DVec3, momentum: DVec3, step: f64) -> DVec3 {
    let velocity = inverse_moments * momentum;
    let acceleration = -inverse_moments * velocity.cross(momentum);
    velocity + 0.5 * step * acceleration + step * step / 12.0 * acceleration.cross(velocity)
}
