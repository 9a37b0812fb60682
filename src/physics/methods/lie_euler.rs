//! The notes' simple first-order Lie group integrator: the angular velocity is held fixed during a step.

use glam::{DQuat, DVec3};

use super::lie_group::{LieGroup, MeanVelocity, turn_by};
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
    start: LieGroup::<LieEuler>::start,
};

/// `Ω̄ = Ω = I⁻¹M`.
struct LieEuler;

impl MeanVelocity for LieEuler {
    fn turn(inverse_moments: DVec3, momentum: DVec3, step: f64) -> Option<DQuat> {
        Some(turn_by(inverse_moments * momentum, step))
    }
}
