//! Numbers of about 106 bits as the unevaluated sum of two f64: just enough for the rates of the exact motion.
//!
//! A phase is rate × time. At `t = 10¹²` a rate of 53 bits would leave no digit of it; one of 106 bits leaves all.
//! Source: Dekker, Numer. Math. 18 (1971) 224. Each operation is good to a few `2⁻¹⁰⁴` relative, for operands whose
//! products stay within 1e±280 (the callers work in units that make everything near 1).

use std::ops::{Add, Div, Mul, Neg, Sub};

/// `high + low` with `|low| ≤ ulp(high)/2`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DoubleDouble {
    pub(crate) high: f64,
    pub(crate) low: f64,
}

/// π to 107 bits.
pub(crate) const PI: DoubleDouble = DoubleDouble { high: std::f64::consts::PI, low: 1.224_646_799_147_353_2e-16 };

/// ln 2 to 107 bits.
pub(crate) const LN_2: DoubleDouble = DoubleDouble { high: std::f64::consts::LN_2, low: 2.319_046_813_846_299_6e-17 };

impl DoubleDouble {
    pub(crate) const ZERO: Self = Self { high: 0.0, low: 0.0 };

    /// `a + b` without error.
    pub(crate) fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let b_part = high - a;
        Self { high, low: (a - (high - b_part)) + (b - b_part) }
    }

    /// `a + b` without error, given `|a| ≥ |b|`.
    pub(crate) fn quick_sum(a: f64, b: f64) -> Self {
        let high = a + b;
        Self { high, low: b - (high - a) }
    }

    /// `ab` without error, by splitting the factors in halves of 26 bits.
    pub(crate) fn product(a: f64, b: f64) -> Self {
        let high = a * b;
        let (a1, a2) = split(a);
        let (b1, b2) = split(b);
        Self { high, low: ((a1 * b1 - high) + a1 * b2 + a2 * b1) + a2 * b2 }
    }

    /// The square root of a number that is not negative.
    pub(crate) fn sqrt(self) -> Self {
        if self.high <= 0.0 {
            return Self::ZERO;
        }
        // One Newton step in the residual doubles the digits of the f64 root.
        let root = self.high.sqrt();
        let residual = self - Self::product(root, root);
        Self::quick_sum(root, residual.high / (2.0 * root))
    }

    /// Its square.
    pub(crate) fn squared(self) -> Self {
        self * self
    }

    /// The nearest f64.
    pub(crate) fn value(self) -> f64 {
        self.high + self.low
    }

    /// Times a power of two, or any factor whose product is wanted to 53 bits of each part.
    pub(crate) fn scaled(self, factor: f64) -> Self {
        Self { high: self.high * factor, low: self.low * factor }
    }

    /// The part of `self × factor` beyond the nearest whole number, in `[−½, ½]`.
    pub(crate) fn fraction_of_product(self, factor: f64) -> f64 {
        let product = Self::product(self.high, factor);
        let low = product.low + self.low * factor;
        beyond_whole(beyond_whole(product.high) + beyond_whole(low))
    }

    /// The part of `self × factor + other` beyond the nearest multiple of ½, and whether that is an odd one: with all
    /// the digits that a small part has.
    pub(crate) fn beyond_half(self, factor: f64, other: Self) -> (f64, bool) {
        let product = Self::product(self.high, factor);
        let low = beyond_whole(product.low + self.low * factor);
        let sum = Self::sum(beyond_whole(product.high), other.high) + Self::sum(low, other.low);
        let halves = 2.0 * sum.high - beyond_whole(2.0 * sum.high);
        ((sum.high - 0.5 * halves) + sum.low, beyond_whole(0.5 * halves) != 0.0)
    }
}

/// `x` less the nearest whole number. By addition of 2⁵² and a half of that, whose last place is 1: without the instruction
/// for it, which not every processor has, rounding is a call that costs as much as a division.
pub(crate) fn beyond_whole(x: f64) -> f64 {
    const SHIFT: f64 = 6_755_399_441_055_744.0;
    const WHOLE_FROM: f64 = 2_251_799_813_685_248.0;
    if x.abs() < WHOLE_FROM { x - ((x + SHIFT) - SHIFT) } else { x - x.round() }
}

/// `a = a₁ + a₂` with 26 bits in each.
fn split(a: f64) -> (f64, f64) {
    let c = 134_217_729.0 * a;
    let first = c - (c - a);
    (first, a - first)
}

impl From<f64> for DoubleDouble {
    fn from(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }
}

impl Neg for DoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Add for DoubleDouble {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let high = Self::sum(self.high, other.high);
        let low = Self::sum(self.low, other.low);
        let first = Self::quick_sum(high.high, high.low + low.high);
        Self::quick_sum(first.high, first.low + low.low)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + (-other)
    }
}

impl Mul for DoubleDouble {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let high = Self::product(self.high, other.high);
        Self::quick_sum(high.high, high.low + (self.high * other.low + self.low * other.high))
    }
}

impl Mul<f64> for DoubleDouble {
    type Output = Self;
    fn mul(self, other: f64) -> Self {
        let high = Self::product(self.high, other);
        Self::quick_sum(high.high, high.low + self.low * other)
    }
}

impl Div for DoubleDouble {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let quotient = self.high / other.high;
        let residual = self - other * quotient;
        Self::quick_sum(quotient, residual.high / other.high)
    }
}

/// The exponent of the power of two at or below the size of a number that is not 0; also of a denormal one.
pub(crate) fn exponent_of(x: f64) -> i32 {
    let biased = |x: f64| (x.to_bits() >> 52 & 0x7ff) as i32;
    if biased(x) == 0 { biased(x * 2f64.powi(64)) - 64 - 1023 } else { biased(x) - 1023 }
}

/// The power of two at or below the size of a number in the middle of the range of f64.
pub(crate) fn power_of_two(x: f64) -> f64 {
    f64::from_bits(x.abs().max(f64::MIN_POSITIVE).to_bits() & 0x7ff0_0000_0000_0000)
}

/// Two powers of two whose product is `2^exponent`, which itself may be out of the range of f64.
pub(crate) fn power_of_two_of(exponent: i32) -> [f64; 2] {
    let power = |e: i32| f64::from_bits(u64::from((e.clamp(-1022, 1023) + 1023).unsigned_abs()) << 52);
    let half = exponent.div_euclid(2);
    [power(half), power(exponent - half)]
}

/// A double-double with an exponent of its own: `value × 2^exponent`, `1 ≤ |value| < 2`, or 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Wide {
    pub(crate) value: DoubleDouble,
    pub(crate) exponent: i32,
}

impl Wide {
    pub(crate) const ZERO: Self = Self { value: DoubleDouble::ZERO, exponent: 0 };

    /// `value × 2^exponent`.
    pub(crate) fn new(value: DoubleDouble, exponent: i32) -> Self {
        if value.high == 0.0 {
            return Self::ZERO;
        }
        let own = exponent_of(value.high);
        if own == 0 {
            return Self { value, exponent };
        }
        let [first, second] = power_of_two_of(-own);
        Self { value: value.scaled(first).scaled(second), exponent: exponent + own }
    }

    /// As a double-double times `2^exponent`; too small a number becomes 0.
    pub(crate) fn in_unit(self, exponent: i32) -> DoubleDouble {
        match self.exponent - exponent {
            0 => self.value,
            shift => {
                let [first, second] = power_of_two_of(shift.clamp(-2044, 2046));
                self.value.scaled(first).scaled(second)
            }
        }
    }

    /// The nearest f64; infinite beyond their range.
    pub(crate) fn rounded(self) -> f64 {
        if self.exponent > 1023 { f64::INFINITY.copysign(self.value.high) } else { self.in_unit(0).value() }
    }

    /// The logarithm of a number that is not negative.
    pub(crate) fn logarithm(self) -> f64 {
        self.value.value().ln() + f64::from(self.exponent) * std::f64::consts::LN_2
    }

    /// The square root of a number that is not negative.
    pub(crate) fn sqrt(self) -> Self {
        let odd = self.exponent.rem_euclid(2);
        Self::new(self.value.scaled(f64::from(1 + odd)).sqrt(), (self.exponent - odd) / 2)
    }
}

impl From<f64> for Wide {
    fn from(value: f64) -> Self {
        Self::new(DoubleDouble::from(value), 0)
    }
}

impl Neg for Wide {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

impl Add for Wide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        if self.value.high == 0.0 {
            return other;
        }
        if other.value.high == 0.0 {
            return self;
        }
        let unit = self.exponent.max(other.exponent);
        Self::new(self.in_unit(unit) + other.in_unit(unit), unit)
    }
}

impl Sub for Wide {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + (-other)
    }
}

impl Mul for Wide {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::new(self.value * other.value, self.exponent + other.exponent)
    }
}

impl Mul<DoubleDouble> for Wide {
    type Output = Self;
    fn mul(self, factor: DoubleDouble) -> Self {
        Self::new(self.value * factor, self.exponent)
    }
}

impl Div for Wide {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self::new(self.value / other.value, self.exponent - other.exponent)
    }
}
