//! Forward Euler on the entries of R: the simplest of the contrast methods.

use glam::DVec3;

use super::linear::{Entries, Linear, Rule};
use super::{Dash, Hue, Keeps, Mark, Method, Order};

pub(super) const METHOD: Method = Method {
    name: "forward-euler",
    label: "Forward Euler",
    order: Order::Finite(1),
    explicit: true,
    symplectic: false,
    keeps_momentum: Keeps::No,
    keeps_rotation: Keeps::No,
    keeps_energy: Keeps::No,
    is_direct: false,
    cost: "one matrix product",
    source: "Euler, Institutionum calculi integralis (1768), §650",
    hue: Hue { on_dark: 0x00e5_6a0c, on_light: 0x00ac_5009 },
    dash: Dash::Solid,
    mark: Mark::Square,
    start: Linear::<ForwardEuler>::start,
};

/// `yₙ₊₁ = yₙ + h f(yₙ)`: every step lengthens the columns of R and the momentum.
struct ForwardEuler;

impl Rule for ForwardEuler {
    fn step(inverse_moments: DVec3, now: Entries, h: f64) -> Option<Entries> {
        Some(now.plus(h, now.rate(inverse_moments)))
    }
}
