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

impl DoubleDouble {
    pub(crate) const ZERO: Self = Self { high: 0.0, low: 0.0 };

    /// `a + b` without error.
    pub(crate) fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let b_part = high - a;
        Self { high, low: (a - (high - b_part)) + (b - b_part) }
    }

    /// `a + b` without error, given `|a| ≥ |b|`.
    fn quick_sum(a: f64, b: f64) -> Self {
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
