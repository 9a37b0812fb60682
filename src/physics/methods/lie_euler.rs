//! The simplest Lie group integrator, of first order: the angular velocity is held fixed during a step.

use glam::{DQuat, DVec3};

use super::lie_group::{LieGroup, MeanVelocity, turn_by};
use super::{Dash, Hue, Keeps, Mark, Method, Order};

pub(super) const METHOD: Method = Method {
    name: "lie-euler",
    label: "Lie–Euler",
    order: Order::Finite(1),
    explicit: true,
    symplectic: false,
    keeps_momentum: Keeps::Exactly,
    keeps_rotation: Keeps::Exactly,
    keeps_energy: Keeps::No,
    is_direct: false,
    cost: "one sin/cos",
    source: "lecture notes; Buss, J. Comput. Phys. 164 (2000) 377, first order",
    hue: Hue { on_dark: 0x0056_b4e9, on_light: 0x0040_87af },
    dash: Dash::Long,
    mark: Mark::Ring,
    start: LieGroup::<LieEuler>::start,
};

/// `Ω̄ = Ω = I⁻¹M`.
struct LieEuler;

impl MeanVelocity for LieEuler {
    fn rotation_of_step(inverse_moments: DVec3, momentum: DVec3, step: f64) -> Option<DQuat> {
        Some(turn_by(inverse_moments * momentum, step))
    }
}
