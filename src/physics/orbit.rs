//! The orbit of the momentum on its sphere, put in standard position: the start of everything that is exact.
//!
//! The axes are relabelled, by signed permutations that round nothing, so that the momentum circles axis 3 on the side
//! `M₃ > 0` and starts with `M₁ ≥ 0`. Then `M = (B₁ cn u, s₂B₂ sn u, B₃ dn u)` with `u = λt + u₀`. After
//! relabelling `I₁ < I₂ < I₃` or `I₁ > I₂ > I₃`; only the sizes of the differences enter here, and `s₂` is the sign.
//! Every quantity is a sum or a product of positive terms but for one difference, `Δ₂`, which decides between
//! the two families of orbits; that one comes with the [start](super::start), exactly.

use glam::{DMat3, DVec3};

use super::Body;
use super::double_double::{self, DoubleDouble, Wide, power_of_two_of};
use super::elliptic;
use super::exact::rates;
use super::start::Start;

/// What the momentum does on its sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// It stays where it is: `M × Ω = 0`, at rest included.
    Steady,
    /// It goes round axis 3.
    Circling,
    /// It runs from one end of the middle axis to the other, once, in infinite time.
    Separatrix,
}

/// See the module. Moments and momenta are in units of their own size (powers of two), time in `moment_unit/momentum_unit`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Orbit {
    pub(crate) kind: Kind,
    /// Takes components in standard position to principal components: a signed permutation.
    pub(crate) principal_from_standard: DMat3,
    pub(crate) moments: DVec3,
    pub(crate) exact_moments: [DoubleDouble; 3],
    /// The sizes of `I₂−I₁`, `I₃−I₁`, `I₃−I₂`.
    pub(crate) differences: [DoubleDouble; 3],
    /// The momentum at the start.
    pub(crate) momentum: DVec3,
    start: StartPoint,
    /// `ℓ = |M|`.
    pub(crate) ell: DoubleDouble,
    /// `B₁, B₂, B₃`.
    pub(crate) amplitudes: DVec3,
    /// `s₂`: 1 about the largest moment, −1 about the smallest.
    pub(crate) handedness: f64,
    /// `λ`, the rate of u.
    pub(crate) rate: DoubleDouble,
    /// `λk′`.
    pub(crate) complementary_rate: Wide,
    /// The modulus `k` and the complementary modulus `k′`, each from its own product.
    pub(crate) modulus: f64,
    pub(crate) complementary_modulus: f64,
    /// Exponents of the units, which may be out of the range of f64.
    pub(crate) moment_exponent: i32,
    pub(crate) rate_exponent: i32,
}

/// Where on its orbit a start is: cn and sn of `u₀`, and `½(cn + dn)`, which may be as small as a number can be, over `2^exponent`.
#[derive(Clone, Copy, Debug, Default)]
struct StartPoint {
    cn: f64,
    sn: f64,
    half_sum: f64,
    exponent: i32,
}

/// Below this `k′` the functions differ from their limits by less than `k′² ln k′`: nothing.
const SMALL_COMPLEMENT: f64 = 1e-9;

/// A start whose axes are so named that it circles axis 3.
struct StandardPosition {
    principal_from_standard: DMat3,
    moments: [DoubleDouble; 3],
    differences: [DoubleDouble; 3],
    momentum: [Wide; 3],
    handedness: f64,
}

impl StandardPosition {
    fn of(start: &Start) -> Self {
        let about_largest = start.difference.value.high >= 0.0;
        let (order, mut signs) = if about_largest { ([0, 1, 2], [1.0; 3]) } else { ([2, 1, 0], [1.0, -1.0, 1.0]) };
        if start.momentum[order[2]].value.high < 0.0 {
            signs = [signs[0], -signs[1], -signs[2]];
        }
        if start.momentum[order[0]].value.high < 0.0 {
            signs = [-signs[0], -signs[1], signs[2]];
        }
        let column = |i: usize| DVec3::AXES[order[i]] * signs[i];
        let [i21, i31, i32] = start.differences;
        let mut momentum = order.map(|i| start.momentum[i]);
        for (m, sign) in momentum.iter_mut().zip(signs) {
            *m = if sign < 0.0 { -*m } else { *m };
        }
        Self {
            principal_from_standard: DMat3::from_cols(column(0), column(1), column(2)),
            moments: order.map(|i| start.moments[i]),
            differences: if about_largest { [i21, i31, i32] } else { [i32, i31, i21] },
            momentum,
            handedness: if about_largest { 1.0 } else { -1.0 },
        }
    }

    /// Whether `M × Ω = 0`: it has the components `M_i M_j (1/I_j − 1/I_i)`; the products themselves may underflow.
    fn is_steady(&self) -> bool {
        let is_zero = |i: usize| self.momentum[i].value.high == 0.0;
        let [i21, i31, i32] = self.differences;
        let pairs = [(0, 1, i21), (1, 2, i32), (0, 2, i31)];
        pairs.into_iter().all(|(i, j, difference)| is_zero(i) || is_zero(j) || difference.high == 0.0)
    }
}

/// Two components over the power of two of the larger one: so they keep their digits, however far below the momentum they are.
fn side_by_side(a: Wide, b: Wide) -> ([f64; 2], i32) {
    let exponents = [a, b].into_iter().filter(|m| m.value.high != 0.0).map(|m| m.exponent);
    let exponent = exponents.max().unwrap_or(0);
    ([a, b].map(|m| m.in_unit(exponent).value()), exponent)
}

impl Orbit {
    /// The orbit of a start.
    pub(crate) fn new(start: &Start) -> Self {
        let position = StandardPosition::of(start);
        let plain = position.momentum.map(|m| m.in_unit(0));
        let momentum = DVec3::from_array(plain.map(DoubleDouble::value));
        let mut orbit = Self {
            kind: Kind::Steady,
            principal_from_standard: position.principal_from_standard,
            moments: DVec3::from_array(position.moments.map(DoubleDouble::value)),
            exact_moments: position.moments,
            differences: position.differences,
            momentum,
            start: StartPoint::default(),
            ell: (plain[0].squared() + plain[1].squared() + plain[2].squared()).sqrt(),
            amplitudes: momentum,
            handedness: position.handedness,
            rate: DoubleDouble::ZERO,
            complementary_rate: Wide::ZERO,
            modulus: 0.0,
            complementary_modulus: 1.0,
            moment_exponent: start.moment_exponent,
            rate_exponent: start.rate_exponent,
        };
        if !position.is_steady() {
            orbit.set_rates(&position.momentum, start.difference);
        }
        if orbit.kind != Kind::Steady {
            orbit.set_amplitudes(&position.momentum);
        }
        orbit
    }

    /// `λ² = Δ₁(I₃−I₂)/(I₁I₂I₃)`, `(λk′)² = Δ₂(I₃−I₁)/(I₁I₂I₃)`, `(λk)² = −Δ₃(I₂−I₁)/(I₁I₂I₃)`.
    fn set_rates(&mut self, momentum: &[Wide; 3], difference: Wide) {
        let [i1, i2, i3] = self.exact_moments;
        let [i21, i31, i32] = self.differences;
        let [_, m2, m3] = *momentum;
        let common = i32 / (i1 * i3) / i2;
        let rate = (m2 * m2 * (i21 / i2 * common) + m3 * m3 * (i31 / i3 * common)).sqrt().in_unit(0);
        let size = if difference.value.high < 0.0 { -difference } else { difference };
        let complementary_rate = (size * (i31 / (i1 * i3) / i2)).sqrt();
        let root = |x: DoubleDouble| x.value().max(0.0).sqrt();
        let over = root(i21) / root(i2) / root(i1 * i3);
        let modulus_rate = (self.momentum.x * root(i31 / i1) * over).hypot(self.momentum.y * root(i32 / i2) * over);
        if !(rate.high > 0.0 && rate.high.is_finite()) {
            return;
        }
        self.kind = if complementary_rate.value.high == 0.0 { Kind::Separatrix } else { Kind::Circling };
        self.rate = rate;
        self.complementary_rate = complementary_rate;
        self.modulus = (modulus_rate / rate.high).min(1.0);
        self.complementary_modulus = (complementary_rate.in_unit(0).high / rate.high).min(1.0);
    }

    /// `B₂/B₁ = √(I₂(I₃−I₁)/(I₁(I₃−I₂)))`, `B₃/B₂ = √(I₃(I₂−I₁)/(I₂(I₃−I₁)))`, and where the start is: `M/B`.
    fn set_amplitudes(&mut self, momentum: &[Wide; 3]) {
        let [i1, i2, i3] = self.exact_moments.map(DoubleDouble::value);
        let [i21, i31, i32] = self.differences.map(DoubleDouble::value);
        let ratio = (i2 / i1 * (i31 / i32)).sqrt();
        let of_third = (i3 / i2 * (i21 / i31)).sqrt();
        let ([x, y], beside_3) = side_by_side(momentum[0], momentum[1]);
        let (b1, b2) = (x.hypot(y / ratio), y.hypot(x * ratio));
        let [p, q] = power_of_two_of(beside_3);
        self.amplitudes = DVec3::new(b1 * p * q, b2 * p * q, self.momentum.z.hypot(self.momentum.y * of_third));
        let ([first, third], exponent) = side_by_side(momentum[0], momentum[2]);
        let (cn, dn) = (first / self.amplitudes.x, third / self.amplitudes.z);
        let half_sum = if self.kind == Kind::Separatrix { dn } else { 0.5 * (cn + dn) };
        self.start = StartPoint { cn: x / b1, sn: self.handedness * y / b2, half_sum, exponent };
    }

    /// Two factors that take seconds to the orbit's units of time.
    pub(crate) fn units_from_seconds(&self) -> [f64; 2] {
        power_of_two_of(self.rate_exponent)
    }

    /// A time in the orbit's units in seconds.
    pub(crate) fn seconds(&self, time: f64) -> f64 {
        let [first, second] = power_of_two_of(-self.rate_exponent);
        time * first * second
    }

    /// A map of momenta in the orbit's units, followed by one of those to kg m²/s.
    pub(crate) fn with_momentum_unit(&self, map: DMat3) -> DMat3 {
        let [first, second] = power_of_two_of(self.moment_exponent + self.rate_exponent);
        map * first * second
    }

    /// A map of angular velocities in the orbit's units, followed by one of those to rad/s.
    pub(crate) fn with_rate_unit(&self, map: DMat3) -> DMat3 {
        let [first, second] = self.units_from_seconds();
        map * first * second
    }

    /// `u₀`, in `[−K, K]`, where `M₁ ≥ 0`.
    ///
    /// Beside the separatrix `e^{−|u|} = ½(cn u + dn u)/(1 + |sn u|)`, of which the part that is small has an exponent of its own.
    pub(crate) fn start_phase(&self) -> DoubleDouble {
        let StartPoint { cn, sn, half_sum, exponent } = self.start;
        if self.kind == Kind::Steady {
            return DoubleDouble::ZERO;
        }
        if self.kind == Kind::Circling && self.complementary_modulus >= SMALL_COMPLEMENT {
            return elliptic::incomplete_by_modulus(sn, cn, self.complementary_modulus).into();
        }
        let own = double_double::exponent_of(half_sum);
        if exponent + own > -4 {
            let [p, q] = power_of_two_of(exponent);
            return (sn / (half_sum * p * q)).asinh().into();
        }
        let [p, q] = power_of_two_of(-own);
        let logarithm = ((1.0 + sn.abs()) / (half_sum * p * q)).ln();
        let phase = double_double::LN_2 * f64::from(-(exponent + own)) + logarithm.into();
        if sn < 0.0 { -phase } else { phase }
    }

    /// `K(k) = πλ/2ν` of the rate ν of `πu/2K`; infinite on the separatrix.
    pub(crate) fn quarter_period(&self, phase_rate: DoubleDouble) -> DoubleDouble {
        if self.kind == Kind::Separatrix {
            return f64::INFINITY.into();
        }
        double_double::PI.scaled(0.5) * (self.rate / phase_rate)
    }

    /// Time (s) between reversals of `M₂`, `2K/λ`; `None` where it does not reverse again and again.
    pub(crate) fn half_period(&self) -> Option<f64> {
        let time = self.seconds((double_double::PI / rates(self).0).value());
        (self.kind == Kind::Circling && time.is_finite()).then_some(time)
    }

    /// Time (s) to the next passage of `M₂` through 0.
    pub(crate) fn next_passage(&self) -> Option<f64> {
        if self.kind == Kind::Steady {
            return None;
        }
        let start = self.start_phase();
        let is_past = self.kind == Kind::Circling && start.high >= 0.0;
        let wait = if is_past { self.quarter_period(rates(self).0).scaled(2.0) - start } else { -start };
        let time = self.seconds((wait / self.rate).value());
        (wait.high > 0.0 && time.is_finite()).then_some(time)
    }

    /// The orbit of a body momentum of a body.
    pub(crate) fn of(body: &Body, body_momentum: DVec3) -> Self {
        Self::new(&Start::of_momentum(body, body_momentum))
    }
}
