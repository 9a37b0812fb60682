//! The implicit gyroscopic step of game engines: stable, and paid for with energy.

use glam::{DMat3, DVec3};

use super::free_momentum::{Advance, FreeMomentum, MomentumRule};
use super::{Dash, Hue, Keeps, Mark, Method, Order};
use crate::physics::so3;

pub(super) const METHOD: Method = Method {
    name: "implicit-gyroscopic",
    label: "Implicit gyroscopic, as in Bullet",
    order: Order::Finite(1),
    explicit: false,
    symplectic: false,
    keeps_momentum: Keeps::No,
    keeps_rotation: Keeps::Exactly,
    keeps_energy: Keeps::No,
    is_direct: false,
    cost: "one 3×3 inverse, one sin/cos",
    source: "Catto, Numerical Methods, Game Developers Conference 2015; Bullet's computeGyroscopicImpulseImplicit_Body, Avian in 2024",
    hue: Hue { on_dark: 0x009c_cc50, on_light: 0x0066_8a2c },
    dash: Dash::Long,
    mark: Mark::OpenTriangleDown,
    start: FreeMomentum::<ImplicitGyroscopic>::start,
};

/// Euler's equation by the backward Euler rule, `I(Ω′ − Ω) + h Ω′×IΩ′ = 0`, with a single step of Newton's method from Ω:
///
/// ```text
/// Ω′ = Ω − (I + h([Ω×]I − [IΩ×]))⁻¹ h Ω×IΩ
/// ```
///
/// then the attitude turns by `hΩ′`. As with every backward Euler rule energy and `|M|` fall, the faster the larger the step.
struct ImplicitGyroscopic;

impl MomentumRule for ImplicitGyroscopic {
    fn step(inverse_moments: DVec3, momentum: DVec3, h: f64) -> Option<Advance> {
        let moments = inverse_moments.recip();
        let inertia = DMat3::from_diagonal(moments);
        let velocity = inverse_moments * momentum;
        let residual = h * velocity.cross(momentum);
        let slope = inertia + (so3::hat(velocity) * inertia - so3::hat(momentum)) * h;
        let velocity = velocity - slope.inverse() * residual;
        velocity.is_finite().then(|| Advance { momentum: moments * velocity, velocity })
    }
}
