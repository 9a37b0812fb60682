//! The discrete rigid body of Moser and Veselov: symplectic, and integrable as the body itself is.

use glam::{DMat3, DQuat, DVec3};

use super::lie_group::{LieGroup, MeanVelocity};
use super::{Dash, Hue, Keeps, Mark, Method, Order};
use crate::physics::so3;

pub(super) const METHOD: Method = Method {
    name: "moser-veselov",
    label: "Moser–Veselov",
    order: Order::Finite(2),
    explicit: false,
    symplectic: true,
    keeps_momentum: Keeps::Exactly,
    keeps_rotation: Keeps::Exactly,
    keeps_energy: Keeps::Exactly,
    is_direct: false,
    cost: "some three 3×3 inverses",
    source: "Moser & Veselov, Comm. Math. Phys. 139 (1991) 217; McLachlan & Zanna, Found. Comput. Math. 5 (2005) 87",
    hue: Hue { on_dark: 0x00b0_98e8, on_light: 0x0084_72ae },
    dash: Dash::Dotted,
    mark: Mark::OpenSquare,
    start: LieGroup::<MoserVeselov>::start,
};

/// The step's rotation `RₙᵀRₙ₊₁`, as the quaternion `f = (f₀, 𝐟)`, solves `(h/2) Mₙ = f₀ I𝐟 + 𝐟×I𝐟`; then
/// `(h/2) Mₙ₊₁ = f₀ I𝐟 − 𝐟×I𝐟`, which is `RᵀL` again.
///
/// The orbit of M is that of the body: with these steps L and K are both kept, and only the time on the orbit is wrong.
/// A spin about a principal axis turns by `arcsin h|Ω|` a step: with `h|Ω| > 1` there is no solution and the step is refused.
struct MoserVeselov;

impl MeanVelocity for MoserVeselov {
    fn rotation_of_step(inverse_moments: DVec3, momentum: DVec3, step: f64) -> Option<DQuat> {
        solve(inverse_moments, 0.5 * step * momentum)
    }
}

/// Newton's method on `f₀ I𝐟 + 𝐟×I𝐟 = m`, `f₀ = √(1 − |𝐟|²)`, from `𝐟 = I⁻¹m`. Solved means: the last correction is below 1e-9
/// of 𝐟, so that the next, its square, is lost in rounding, on the branch that begins at the identity, `f₀² > ½`. Else `None`.
fn solve(inverse_moments: DVec3, m: DVec3) -> Option<DQuat> {
    let moments = inverse_moments.recip();
    let inertia = DMat3::from_diagonal(moments);
    let mut f = inverse_moments * m;
    for _ in 0..30 {
        let f0 = (1.0 - f.length_squared()).sqrt();
        let image = moments * f;
        let residual = f0 * image + f.cross(image) - m;
        let outer = DMat3::from_cols(image * f.x, image * f.y, image * f.z) * (1.0 / f0);
        let slope = inertia * f0 - outer + so3::hat(f) * inertia - so3::hat(image);
        let correction = slope.inverse() * residual;
        f -= correction;
        let size = f.length_squared();
        if size.is_nan() || size >= 1.0 {
            return None;
        }
        if correction.length_squared() <= 1e-18 * size {
            return (size < 0.5).then(|| DQuat::from_xyzw(f.x, f.y, f.z, (1.0 - size).sqrt()));
        }
    }
    None
}
