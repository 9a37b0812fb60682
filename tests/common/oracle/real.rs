//! Binary numbers of any length.

use dashu_float::{FBig, round::mode::HalfEven};

/// A number of so many bits as it was made with; results have those of the longer operand.
pub(crate) type Real = FBig<HalfEven, 2>;

/// A vector and a matrix by rows.
pub(crate) type Vector = [Real; 3];
pub(crate) type Matrix = [[Real; 3]; 3];

/// A binary64 number, exactly (if there are 53 bits or more).
pub(crate) fn real(x: f64, bits: usize) -> Real {
    with_bits(Real::try_from(x).expect("a finite number"), bits)
}

pub(crate) fn with_bits(x: Real, bits: usize) -> Real {
    x.with_precision(bits).value()
}

pub(crate) fn vector(v: [f64; 3], bits: usize) -> Vector {
    v.map(|x| real(x, bits))
}

/// The nearest binary64 number.
pub(crate) fn nearest(x: &Real) -> f64 {
    x.to_f64().value()
}

pub(crate) fn root(x: &Real) -> Real {
    if is_zero(x) { x.clone() } else { x.sqrt() }
}

pub(crate) fn is_zero(x: &Real) -> bool {
    *x == Real::ZERO
}

pub(crate) fn is_negative(x: &Real) -> bool {
    *x < Real::ZERO
}

pub(crate) fn size(x: &Real) -> Real {
    if is_negative(x) { -x } else { x.clone() }
}

/// 1 or −1; 1 for 0.
pub(crate) fn sign(x: &Real) -> i32 {
    if is_negative(x) { -1 } else { 1 }
}

pub(crate) fn signed(sign: i32, x: Real) -> Real {
    if sign < 0 { -x } else { x }
}

/// The binary exponent: `2^(e−1) ≤ |x| < 2^e`; far below any other for 0.
pub(crate) fn exponent(x: &Real) -> isize {
    if is_zero(x) { isize::MIN / 4 } else { x.repr().exponent() + x.repr().digits().cast_signed() }
}

pub(crate) fn dot(a: &Vector, b: &Vector) -> Real {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

pub(crate) fn cross(a: &Vector, b: &Vector) -> Vector {
    [&a[1] * &b[2] - &a[2] * &b[1], &a[2] * &b[0] - &a[0] * &b[2], &a[0] * &b[1] - &a[1] * &b[0]]
}

pub(crate) fn times(m: &Matrix, v: &Vector) -> Vector {
    [0, 1, 2].map(|i| dot(&m[i], v))
}

pub(crate) fn transposed(m: &Matrix) -> Matrix {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| m[j][i].clone()))
}

pub(crate) fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let b = transposed(b);
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| dot(&a[i], &b[j])))
}

pub(crate) fn identity(bits: usize) -> Matrix {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| real(f64::from(i == j), bits)))
}
