//! A start in the principal frame, from the numbers it was given by, before any of them is rounded.
//!
//! Which of the two families of orbits a start belongs to, and how long it lingers beside the middle axis, hangs on
//! `Δ₂ = I₃Ω₃²(I₃−I₂) − I₁Ω₁²(I₂−I₁)`. It is taken in double-double; where its two terms agree to three digits or more, without any
//! rounding. So its sign is right for every body and every spin that can be written down, and 0 means the separatrix itself.

use glam::DVec3;

use super::double_double::{DoubleDouble, Wide};
use super::dyadic::{self, Dyadic};
use super::motion::Origin;
use super::principal::{self, Given, Principal};
use super::{Body, State, bounds};

/// Moments further apart than this are taken as this far apart, so that no product leaves the range of f64.
const SMALLEST_RATIO: f64 = bounds::LARGEST_RATIO.recip();
/// Terms that agree to this many bits are subtracted without rounding; else 90 bits are left of the 106.
const CANCELLED_BITS: i32 = 10;
/// A spin within `2⁻¹⁶` of a principal axis of a turned body: what is beside the axis is found without the axis' own rounding.
const BESIDE_BITS: i32 = 16;

/// See the module. Moments in units of `2^moment_exponent`, momentum of `2^(moment_exponent + rate_exponent)`, time of `2^-rate_exponent`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Start {
    pub(crate) moments: [DoubleDouble; 3],
    /// `I₂ − I₁`, `I₃ − I₁`, `I₃ − I₂`.
    pub(crate) differences: [DoubleDouble; 3],
    /// In the principal frame; the largest component is near 1.
    pub(crate) momentum: [Wide; 3],
    /// `Δ₂`, with the sign that the given numbers have.
    pub(crate) difference: Wide,
    pub(crate) moment_exponent: i32,
    pub(crate) rate_exponent: i32,
}

impl Start {
    /// The start of a body.
    pub(crate) fn new(body: &Body, state: &State) -> Self {
        let principal = body.principal();
        let origin = state.origin();
        let given = match origin {
            Origin::AngularVelocity(velocity) => along_axes(principal, velocity),
            Origin::PrincipalAngularVelocity(velocity) => velocity.to_array().map(Wide::from),
            Origin::Momentum => principal.components(state.body_momentum.to_array()),
        };
        let is_momentum = origin == Origin::Momentum;
        let momentum = [0, 1, 2].map(|i| if is_momentum { given[i] } else { given[i] * principal.wide_moment(i) });
        let (moments, differences) = within_range(principal);
        let largest = momentum.iter().filter(|m| m.value.high != 0.0).map(|m| m.exponent).max().unwrap_or(0);
        let momentum = momentum.map(|m| Wide { exponent: m.exponent - largest, ..m });
        let mut start = Self {
            moments,
            differences,
            momentum,
            difference: Wide::ZERO,
            moment_exponent: principal.exponent,
            rate_exponent: if is_momentum { largest - principal.exponent } else { largest },
        };
        start.difference = start.separation(principal, origin, &given);
        start
    }

    /// The start with a momentum in the body frame of which nothing more is known.
    pub(crate) fn of_momentum(body: &Body, body_momentum: DVec3) -> Self {
        Self::new(body, &State::from_parts(glam::DMat3::IDENTITY, body_momentum, body_momentum))
    }

    /// The moments, to f64.
    pub(crate) fn rounded_moments(&self) -> DVec3 {
        DVec3::from_array(self.moments.map(DoubleDouble::value))
    }

    /// The momentum in the principal frame, to f64.
    pub(crate) fn rounded_momentum(&self) -> DVec3 {
        DVec3::from_array(self.momentum.map(|m| m.in_unit(0).value()))
    }

    /// `Δ₂`.
    fn separation(&self, principal: &Principal, origin: Origin, given: &[Wide; 3]) -> Wide {
        let [i1, _, i3] = self.moments;
        let [i21, _, i32] = self.differences;
        let [m1, _, m3] = self.momentum;
        let about_3 = m3 * m3 * (i32 / i3);
        let about_1 = m1 * m1 * (i21 / i1);
        let difference = about_3 - about_1;
        let is_zero = |x: Wide| x.value.high == 0.0;
        if is_zero(about_3) || is_zero(about_1) {
            return difference;
        }
        let is_certain = !is_zero(difference) && difference.exponent + CANCELLED_BITS >= about_3.exponent;
        if is_certain {
            return difference;
        }
        match (principal.given, origin) {
            (Given::Tensor(tensor, _), Origin::AngularVelocity(velocity)) => {
                self.separation_of_tensor(tensor, velocity)
            }
            (Given::Tensor(..), Origin::Momentum) => difference,
            _ => {
                let [i1, i2, i3] = principal.exact_moments();
                let [g1, _, g3] = given.map(|x| Dyadic::from(x.value).scaled(x.exponent));
                let (first, third) = if origin == Origin::Momentum { (&i3, &i1) } else { (&i1, &i3) };
                let about_3_exactly = &(&(&g3 * &g3) * third) * &(&i3 - &i2);
                let about_1_exactly = &(&(&g1 * &g1) * first) * &(&i2 - &i1);
                about_3 * ((&about_3_exactly - &about_1_exactly).wide() / about_3_exactly.wide())
            }
        }
    }

    /// By `det(ℓ² − 2K I) = Δ₁Δ₂Δ₃`, a polynomial in the tensor's entries and the angular velocity.
    fn separation_of_tensor(&self, tensor: [[f64; 3]; 6], velocity: DVec3) -> Wide {
        let tensor = tensor.map(Dyadic::of_parts);
        let velocity = velocity.to_array().map(Dyadic::from);
        let momentum = principal::product(&tensor, &velocity);
        let square = dyadic::dot(&momentum, &momentum);
        let twice_energy = dyadic::dot(&momentum, &velocity);
        let mut less = tensor.each_ref().map(|entry| -(&twice_energy * entry));
        for entry in &mut less[..3] {
            *entry = &*entry + &square;
        }
        let all = principal::determinant(&less).wide();
        let all = Wide { exponent: all.exponent - 6 * self.rate_exponent, ..all };
        let [i1, i2, i3] = self.moments;
        let [i21, i31, i32] = self.differences;
        let [m1, m2, m3] = self.momentum.map(|m| m * m);
        let first = m2 * (i21 / i2) + m3 * (i31 / i3);
        let third = m1 * (i31 / i1) + m2 * (i32 / i2);
        if all.value.high == 0.0 { Wide::ZERO } else { -(all / (first * third)) }
    }
}

/// Moments and their differences, none further apart than [`SMALLEST_RATIO`].
fn within_range(principal: &Principal) -> ([DoubleDouble; 3], [DoubleDouble; 3]) {
    if principal.moments[0].high >= SMALLEST_RATIO {
        return (principal.moments, principal.differences);
    }
    let least = |x: DoubleDouble| if x.high < SMALLEST_RATIO { DoubleDouble::from(SMALLEST_RATIO) } else { x };
    let [i1, i2, i3] = principal.moments.map(least);
    ([i1, i2, i3], [i2 - i1, i3 - i1, i3 - i2])
}

/// The components of an angular velocity along the principal axes. Close to one of them, those along the others come from
/// `IΩ × Ω`, which is exact and has the components `(I₂−I₃)Ω₂Ω₃` and so on round: a spin about the axis itself has none at all.
fn along_axes(principal: &Principal, velocity: DVec3) -> [Wide; 3] {
    let mut along = principal.components(velocity.to_array());
    let Given::Tensor(tensor, _) = principal.given else { return along };
    let size = |w: Wide| if w.value.high == 0.0 { i32::MIN } else { w.exponent };
    let i = (0..3).max_by_key(|&i| size(along[i])).unwrap_or(0);
    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
    if size(along[j]).max(size(along[k])) > size(along[i]).saturating_sub(BESIDE_BITS) || size(along[i]) == i32::MIN {
        return along;
    }
    let tensor = tensor.map(Dyadic::of_parts);
    let exact = velocity.to_array().map(Dyadic::from);
    let torque = dyadic::cross(&principal::product(&tensor, &exact), &exact);
    let component = |i: usize| dyadic::dot(&principal.axes[i].map(Dyadic::from), &torque).wide();
    // I_b − I_a with its sign.
    let [i21, i31, i32] = principal.differences;
    let difference = |b: usize, a: usize| {
        let size = match a + b {
            1 => i21,
            2 => i31,
            _ => i32,
        };
        Wide::new(if b > a { size } else { -size }, 0)
    };
    for (wanted, other) in [(k, j), (j, k)] {
        let difference = if wanted == k { difference(k, i) } else { difference(i, j) };
        if difference.value.high != 0.0 {
            along[wanted] = component(other) / (difference * along[i]);
        }
    }
    along
}
