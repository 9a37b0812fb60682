//! Dyadic numbers, integers times powers of two: sums and products without rounding, at any exponent.
//!
//! Every f64 is one. They decide what double-double cannot: on which side of the separatrix a start lies whose two terms agree to
//! a hundred digits, and what the principal axes of a tensor are to any number of digits. An integer of any length and an exponent
//! serve where sums of f64 (Shewchuk, Discrete Comput. Geom. 18 (1997) 305) would underflow; the purpose is the same.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use super::double_double::{DoubleDouble, Wide, exponent_of, power_of_two_of};

/// `± integer × 2^(64 shift)`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Dyadic {
    is_negative: bool,
    /// The integer, 64 bits to a limb, the lowest first; the last one is not 0. None of them: 0.
    limbs: Vec<u64>,
    shift: i32,
}

impl Dyadic {
    /// The number of these limbs, brought to its one form.
    fn new(is_negative: bool, mut limbs: Vec<u64>, mut shift: i32) -> Self {
        while limbs.last() == Some(&0) {
            limbs.pop();
        }
        let zeros = limbs.iter().take_while(|&&limb| limb == 0).count();
        if zeros > 0 {
            limbs.drain(..zeros);
            shift += zeros.cast_signed() as i32;
        }
        if limbs.is_empty() { Self::default() } else { Self { is_negative, limbs, shift } }
    }

    /// −1, 0 or 1.
    pub(crate) fn sign(&self) -> i32 {
        match (self.limbs.is_empty(), self.is_negative) {
            (true, _) => 0,
            (false, true) => -1,
            (false, false) => 1,
        }
    }

    pub(crate) fn is_zero(&self) -> bool {
        self.limbs.is_empty()
    }

    /// The leading digits: `64 (limbs − 1)` bits of them at least.
    pub(crate) fn rounded(mut self, limbs: usize) -> Self {
        let excess = self.limbs.len().saturating_sub(limbs);
        if excess == 0 {
            return self;
        }
        self.limbs.drain(..excess);
        Self::new(self.is_negative, self.limbs, self.shift + excess.cast_signed() as i32)
    }

    /// Times `2^exponent`.
    pub(crate) fn scaled(&self, exponent: i32) -> Self {
        let (whole, rest) = (exponent.div_euclid(64), exponent.rem_euclid(64));
        let power = Self { is_negative: false, limbs: vec![1 << rest], shift: whole };
        self * &power
    }

    /// `1/x` to some `64 (limbs − 1)` bits, by Newton's iteration, which doubles the digits of the f64 quotient.
    pub(crate) fn reciprocal(&self, limbs: usize) -> Self {
        let wide = self.wide();
        let mut inverse = Self::from(1.0 / wide.value.high).scaled(-wide.exponent);
        let two = Self::from(2.0);
        let mut bits = 50;
        while bits < 64 * limbs {
            inverse = (&inverse * &(&two - &(self * &inverse))).rounded(limbs + 1);
            bits *= 2;
        }
        inverse
    }

    /// The nearest double-double, with an exponent of its own.
    pub(crate) fn wide(&self) -> Wide {
        let limb = |back: usize| self.limbs.len().checked_sub(back).map_or(0, |i| u128::from(self.limbs[i]));
        let Some(top) = self.limbs.last() else { return Wide::ZERO };
        // The leading 127 bits.
        let zeros = top.leading_zeros();
        let leading = (limb(1) << 64) | limb(2);
        let leading = if zeros == 0 { leading } else { (leading << zeros) | (limb(3) >> (64 - zeros)) } >> 1;
        let high = leading as f64;
        let low = leading.cast_signed().wrapping_sub(high as i128) as f64;
        let unit = 2f64.powi(-126);
        let value = DoubleDouble { high: high * unit, low: low * unit };
        let exponent = 64 * (self.shift + self.limbs.len().cast_signed() as i32) - zeros.cast_signed() - 1;
        Wide::new(if self.is_negative { -value } else { value }, exponent)
    }

    /// The sum, or the difference, of the integers.
    fn plus(&self, other: &Self, is_other_negative: bool) -> Self {
        if other.limbs.is_empty() {
            return self.clone();
        }
        if self.limbs.is_empty() {
            return Self { is_negative: is_other_negative, ..other.clone() };
        }
        let shift = self.shift.min(other.shift);
        let [first, second] = [self, other].map(|number| Aligned { number, zeros: (number.shift - shift) as usize });
        if self.is_negative == is_other_negative {
            return Self::new(self.is_negative, first.sum(&second), shift);
        }
        match first.compare(&second) {
            Ordering::Equal => Self::default(),
            Ordering::Greater => Self::new(self.is_negative, first.difference(&second), shift),
            Ordering::Less => Self::new(is_other_negative, second.difference(&first), shift),
        }
    }
}

/// A number as its limbs from a common exponent on.
struct Aligned<'a> {
    number: &'a Dyadic,
    /// Limbs of 0 before its own.
    zeros: usize,
}

impl Aligned<'_> {
    fn len(&self) -> usize {
        self.zeros + self.number.limbs.len()
    }

    fn limb(&self, index: usize) -> u64 {
        index.checked_sub(self.zeros).and_then(|i| self.number.limbs.get(i)).copied().unwrap_or(0)
    }

    fn sum(&self, other: &Self) -> Vec<u64> {
        let length = self.len().max(other.len());
        let mut limbs = Vec::with_capacity(length + 1);
        let mut carry = false;
        for i in 0..length {
            let (limb, first) = self.limb(i).overflowing_add(other.limb(i));
            let (limb, second) = limb.overflowing_add(u64::from(carry));
            carry = first || second;
            limbs.push(limb);
        }
        limbs.push(u64::from(carry));
        limbs
    }

    /// Less a number that is not larger.
    fn difference(&self, other: &Self) -> Vec<u64> {
        let mut borrow = false;
        (0..self.len())
            .map(|i| {
                let (limb, first) = self.limb(i).overflowing_sub(other.limb(i));
                let (limb, second) = limb.overflowing_sub(u64::from(borrow));
                borrow = first || second;
                limb
            })
            .collect()
    }

    fn compare(&self, other: &Self) -> Ordering {
        let by_length = self.len().cmp(&other.len());
        by_length.then_with(|| {
            let pairs = (0..self.len()).rev().map(|i| self.limb(i).cmp(&other.limb(i)));
            pairs.fold(Ordering::Equal, Ordering::then)
        })
    }
}

impl From<f64> for Dyadic {
    /// Finite numbers; any other becomes 0.
    fn from(value: f64) -> Self {
        if value == 0.0 || !value.is_finite() {
            return Self::default();
        }
        // 2⁵² ≤ |integer| < 2⁵³, once the number has an exponent near 0.
        let exponent = exponent_of(value);
        let [first, second] = power_of_two_of(-exponent);
        let integer = (value * first * second).abs() * 2f64.powi(52);
        let (shift, rest) = ((exponent - 52).div_euclid(64), (exponent - 52).rem_euclid(64));
        let limbs = u128::from(integer as u64) << rest;
        Self::new(value < 0.0, vec![limbs as u64, (limbs >> 64) as u64], shift)
    }
}

impl From<DoubleDouble> for Dyadic {
    fn from(value: DoubleDouble) -> Self {
        &Self::from(value.high) + &Self::from(value.low)
    }
}

impl Neg for Dyadic {
    type Output = Self;
    fn neg(self) -> Self {
        Self { is_negative: !self.is_negative && !self.limbs.is_empty(), ..self }
    }
}

impl Add for &Dyadic {
    type Output = Dyadic;
    fn add(self, other: Self) -> Dyadic {
        self.plus(other, other.is_negative)
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;
    fn sub(self, other: Self) -> Dyadic {
        self.plus(other, !other.is_negative)
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;
    fn mul(self, other: Self) -> Dyadic {
        if self.limbs.is_empty() || other.limbs.is_empty() {
            return Dyadic::default();
        }
        let mut limbs = vec![0_u64; self.limbs.len() + other.limbs.len()];
        for (i, &a) in self.limbs.iter().enumerate() {
            let mut carry = 0_u128;
            for (j, &b) in other.limbs.iter().enumerate() {
                let sum = u128::from(a) * u128::from(b) + u128::from(limbs[i + j]) + carry;
                limbs[i + j] = sum as u64;
                carry = sum >> 64;
            }
            limbs[i + other.limbs.len()] = carry as u64;
        }
        Dyadic::new(self.is_negative != other.is_negative, limbs, self.shift + other.shift)
    }
}

/// The cross product.
pub(crate) fn cross(a: &[Dyadic; 3], b: &[Dyadic; 3]) -> [Dyadic; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &(&a[i] * &b[j]) - &(&a[j] * &b[i]))
}

/// The scalar product.
pub(crate) fn dot(a: &[Dyadic; 3], b: &[Dyadic; 3]) -> Dyadic {
    &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2])
}

impl Dyadic {
    /// The nearest f64.
    pub(crate) fn value(&self) -> f64 {
        self.wide().rounded()
    }

    /// `a/b` of small whole numbers.
    pub(crate) fn ratio(a: f64, b: f64, limbs: usize) -> Self {
        (&Self::from(a) * &Self::from(b).reciprocal(limbs)).rounded(limbs)
    }

    /// As a sum of three f64: 159 bits of it at least.
    pub(crate) fn parts(&self) -> [f64; 3] {
        let first = self.value();
        let rest = self - &Self::from(first);
        let second = rest.value();
        [first, second, (&rest - &Self::from(second)).value()]
    }

    /// The sum of three f64.
    pub(crate) fn of_parts(parts: [f64; 3]) -> Self {
        let [first, second, third] = parts.map(Self::from);
        &(&first + &second) + &third
    }
}

/// π to 320 bits after the point.
pub(crate) fn pi() -> Dyadic {
    const FRACTION: [u64; 6] = [
        0x4528_21e6_38d0_1377,
        0x082e_fa98_ec4e_6c89,
        0xa409_3822_299f_31d0,
        0x1319_8a2e_0370_7344,
        0x243f_6a88_85a3_08d3,
        3,
    ];
    Dyadic::new(false, FRACTION.to_vec(), -5)
}
