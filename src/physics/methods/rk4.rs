//! The classical Runge–Kutta method on the entries of R.

use glam::DVec3;

use super::linear::{Entries, Linear, Rule};
use super::{Dash, Hue, Keeps, Mark, Method, Order};

pub(super) const METHOD: Method = Method {
    name: "rk4",
    label: "Runge–Kutta 4",
    order: Order::Finite(4),
    explicit: true,
    symplectic: false,
    keeps_momentum: Keeps::No,
    keeps_rotation: Keeps::No,
    keeps_energy: Keeps::No,
    is_direct: false,
    cost: "four matrix products",
    source: "Kutta, Z. Math. Phys. 46 (1901) 435",
    hue: Hue { on_dark: 0x0000_b080, on_light: 0x0000_8460 },
    dash: Dash::Dotted,
    mark: Mark::Diamond,
    start: Linear::<RungeKutta>::start,
};

/// `yₙ₊₁ = yₙ + h/6 (k₁ + 2k₂ + 2k₃ + k₄)`.
struct RungeKutta;

impl Rule for RungeKutta {
    fn step(inverse_moments: DVec3, now: Entries, h: f64) -> Option<Entries> {
        let k1 = now.rate(inverse_moments);
        let k2 = now.plus(0.5 * h, k1).rate(inverse_moments);
        let k3 = now.plus(0.5 * h, k2).rate(inverse_moments);
        let k4 = now.plus(h, k3).rate(inverse_moments);
        Some(now.plus(h / 6.0, k1).plus(h / 3.0, k2).plus(h / 3.0, k3).plus(h / 6.0, k4))
    }
}
