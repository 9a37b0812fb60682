//! The clamped gyroscopic step of game engines: cheap, never unstable, and it drifts to a spin about the middle axis.

use glam::DVec3;

use super::free_momentum::{Advance, FreeMomentum, MomentumRule};
use super::{Dash, Hue, Keeps, Mark, Method, Order};

pub(super) const METHOD: Method = Method {
    name: "clamped-gyroscopic",
    label: "Clamped gyroscopic, as in Jolt and Avian",
    order: Order::Finite(1),
    explicit: true,
    symplectic: false,
    keeps_momentum: Keeps::No,
    keeps_rotation: Keeps::Exactly,
    keeps_energy: Keeps::No,
    is_direct: false,
    cost: "one square root, one sin/cos, one cross product",
    source: "Jolt Physics, MotionProperties::ApplyGyroscopicForceInternal; Avian since 2025",
    hue: Hue { on_dark: 0x00c0_9a6b, on_light: 0x0090_7450 },
    dash: Dash::Dotted,
    mark: Mark::Bars,
    start: FreeMomentum::<ClampedGyroscopic>::start,
};

/// A step of forward Euler, `M + h M×Ω`, brought back to the length of M; then the attitude turns by `hΩ′`.
///
/// Forward Euler would add energy without end. On the sphere `|M| = ℓ` what it adds or takes leads from both stable axes to the
/// middle one: the energy goes to `ℓ²/2I₂`, and whatever the body did at first, it ends flipping.
struct ClampedGyroscopic;

impl MomentumRule for ClampedGyroscopic {
    fn step(inverse_moments: DVec3, momentum: DVec3, h: f64) -> Option<Advance> {
        let next = momentum + h * momentum.cross(inverse_moments * momentum);
        let size = next.length_squared();
        let momentum = if size > 0.0 { next * (momentum.length_squared() / size).sqrt() } else { DVec3::ZERO };
        Some(Advance { momentum, velocity: inverse_moments * momentum })
    }
}
