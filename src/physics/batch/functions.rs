//! Sine, cosine and exponential of several numbers at a time, and the phases that go into them.
#![allow(clippy::inline_always, reason = "what is not inlined has not the instructions of its caller")]

use std::f64::consts::{LOG2_E, TAU};

use fearless_simd::prelude::*;

/// To add and take away again what rounds a number below 2⁵¹ to a whole one: 1.5 · 2⁵².
const SHIFT: f64 = 6_755_399_441_055_744.0;

/// Coefficients of `(sin x − x)/x³` and `(cos x − 1 + x²/2)/x⁴` in x², for `|x| ≤ π/4`, with errors below 2⁻⁵⁸.
/// Source: Sun's fdlibm, `k_sin.c` and `k_cos.c`, which has them by Remez' algorithm.
const SINE: [f64; 6] = [
    1.589_690_995_211_55e-10,
    -2.505_076_025_340_686_3e-8,
    2.755_731_370_707_006_8e-6,
    -1.984_126_982_985_795e-4,
    8.333_333_333_322_49e-3,
    -0.166_666_666_666_666_32,
];
const COSINE: [f64; 6] = [
    -1.135_964_755_778_819_5e-11,
    2.087_572_321_298_175e-9,
    -2.755_731_435_139_066_3e-7,
    2.480_158_728_947_673e-5,
    -1.388_888_888_887_411e-3,
    4.166_666_666_666_66e-2,
];

/// ln 2 in two parts, the first of 33 bits.
const LN_2: [f64; 2] = [0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10];

/// `1/n!` for n from 13 down to 2: the first term left out of `e^r`, `|r| ≤ ½ ln 2`, is `r¹⁴/14! < 5e-18`.
const RECIPROCAL_FACTORIALS: [f64; 12] = [
    1.0 / 6_227_020_800.0,
    1.0 / 479_001_600.0,
    1.0 / 39_916_800.0,
    1.0 / 3_628_800.0,
    1.0 / 362_880.0,
    1.0 / 40_320.0,
    1.0 / 5_040.0,
    1.0 / 720.0,
    1.0 / 120.0,
    1.0 / 24.0,
    1.0 / 6.0,
    0.5,
];

#[inline(always)]
fn polynomial<S: Simd>(simd: S, coefficients: &[f64], x: S::f64s) -> S::f64s {
    let mut sum = S::f64s::splat(simd, coefficients[0]);
    for coefficient in &coefficients[1..] {
        sum = sum.mul_add(x, S::f64s::splat(simd, *coefficient));
    }
    sum
}

/// The nearest whole number, for `|x| < 2⁵¹`.
#[inline(always)]
pub(super) fn whole<S: Simd>(simd: S, x: S::f64s) -> S::f64s {
    let shift = S::f64s::splat(simd, SHIFT);
    (x + shift) - shift
}

/// What is beyond it.
#[inline(always)]
pub(super) fn beyond_whole<S: Simd>(simd: S, x: S::f64s) -> S::f64s {
    x - whole(simd, x)
}

/// A time in the two halves of its digits, so that its products with the halves of a rate are exact (Dekker).
#[derive(Clone, Copy)]
pub(super) struct SplitTime {
    whole: f64,
    high: f64,
    low: f64,
}

impl SplitTime {
    pub(super) fn new(time: f64) -> Self {
        let [high, low] = halves(time);
        Self { whole: time, high, low }
    }
}

/// A number as a sum of two of 26 bits.
pub(super) fn halves(x: f64) -> [f64; 2] {
    let c = 134_217_729.0 * x;
    let high = c - (c - x);
    [high, x - high]
}

/// The fraction of a turn that is left of a rate times a time, below 2⁵⁰ turns. The rate is given in three parts: the halves of its
/// first 53 bits, and the next 53.
#[inline(always)]
pub(super) fn phase<S: Simd>(simd: S, [high, middle, low]: [S::f64s; 3], time: SplitTime) -> S::f64s {
    let of = |x: f64| S::f64s::splat(simd, x);
    let (t, t1, t2) = (of(time.whole), of(time.high), of(time.low));
    let product = (high + middle) * t;
    let rest = ((high * t1 - product) + high * t2 + middle * t1) + middle * t2;
    beyond_whole(simd, beyond_whole(simd, product) + beyond_whole(simd, rest + low * t))
}

/// `[sin, cos]` of so many turns, `|turns| ≤ 1`. Errors of some ε: the angle left of whole quarters is exact in turns.
#[inline(always)]
pub(super) fn sine_and_cosine<S: Simd>(simd: S, turns: S::f64s) -> [S::f64s; 2] {
    let one = S::f64s::splat(simd, 1.0);
    let turns = beyond_whole(simd, turns);
    let quarters = whole(simd, turns * 4.0);
    let x = quarters.mul_add(S::f64s::splat(simd, -0.25), turns) * TAU;
    let square = x * x;
    let s = (x * square).mul_add(polynomial(simd, &SINE, square), x);
    // 1 − x²/2 rounds; what it loses goes with the small rest.
    let half = square * 0.5;
    let first = one - half;
    let rest = ((one - first) - half) + (square * square) * polynomial(simd, &COSINE, square);
    let c = first + rest;
    // −2 … 2 quarters.
    let is_odd = quarters.abs().simd_eq(one);
    let sign = one - quarters.abs();
    [is_odd.select(quarters * c, sign * s), is_odd.select(-(quarters * s), sign * c)]
}

/// `e^x` for `−700 < x ≤ 0`.
#[inline(always)]
pub(super) fn exponential<S: Simd>(simd: S, x: S::f64s) -> S::f64s {
    let of = |x: f64| S::f64s::splat(simd, x);
    // The exponent's bits are then those of the lowest place.
    let biased = x.mul_add(of(LOG2_E), of(SHIFT + 1023.0));
    let count = biased - of(SHIFT + 1023.0);
    let rest = count.mul_add(of(-LN_2[0]), x);
    let rest = count.mul_add(of(-LN_2[1]), rest);
    let beyond = (rest * rest).mul_add(polynomial(simd, &RECIPROCAL_FACTORIALS, rest), rest);
    let power = S::f64s::from_bits(biased.to_bits() << 52_u32);
    beyond.mul_add(power, power)
}
