//! The notes' simple first-order Lie group integrator: the angular velocity is held fixed during a step.

use glam::DVec3;

use super::lie_group::LieGroup;
use super::{Keeps, Method, Order};

pub(super) const METHOD: Method = Method {
    name: "lie-euler",
    label: "Lie–Euler",
    order: Order::Finite(1),
    explicit: true,
    symplectic: false,
    keeps_momentum: Keeps::Exactly,
    keeps_rotation: Keeps::Exactly,
    keeps_energy: Keeps::No,
    cost: "one sin/cos",
    source: "lecture notes; Buss, J. Comput. Phys. 164 (2000) 377, first order",
    start: |moments, momentum| LieGroup::start(METHOD.name, mean_velocity, moments, momentum),
};

/// `Ω̄ = Ω = I⁻¹M`.
fn mean_velocity(inverse_moments: DVec3, momentum: DVec3, _step: f64) -> DVec3 {
    inverse_moments * momentum
}
