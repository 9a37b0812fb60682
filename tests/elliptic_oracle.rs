//! The elliptic functions and integrals to their documented bounds, against Carlson's integrals and Landen's transformation in 256 bits,
//! for complementary parameters from 1e-300 to 1.
#![allow(clippy::expect_used, reason = "a test fails by it")]

mod common;
#[path = "common/oracle/mod.rs"]
mod oracle;

use common::{EPS, Random, assert_at_most};
use dzhanibekov::physics::bounds;
use dzhanibekov::physics::elliptic::{
    Jacobi, arithmetic_geometric_mean, complete_first_kind, complete_second_kind, incomplete_first_kind,
};
use oracle::carlson;
use oracle::jacobi::Modulus;
use oracle::real::{Real, nearest, real, sign, signed, size};

const BITS: usize = 256;

/// From 1e-300 to 1, as often near 1e-300 as near 1, and thick at 1 and where the crate changes from one series to the other.
fn parameter(random: &mut Random) -> f64 {
    match random.below(5) {
        0 => 1.0 - 10f64.powf(random.between(-16.0, 0.0)),
        1 => 0.5 + 10f64.powf(random.between(-16.0, -1.0)) * random.between(-1.0, 1.0),
        2 => 10f64.powf(random.between(-20.0, 0.0)),
        _ => 10f64.powf(random.between(-300.0, 0.0)),
    }
    .clamp(1e-300, 1.0)
}

/// The relative distance of a number from the right one.
fn relative(value: f64, right: &Real) -> f64 {
    nearest(&((real(value, BITS) - right) / right)).abs()
}

/// `K = R_F(0, k′², 1)`.
fn complete(parameter: f64) -> Real {
    carlson::first_kind(&real(0.0, BITS), &real(parameter, BITS), &real(1.0, BITS))
}

#[test]
fn complete_integrals() {
    let mut random = Random::new(31);
    for n in 0..1_500 {
        // The first kind is defined beyond 1 as well.
        let parameter = if n % 10 == 0 { 10f64.powf(random.between(0.0, 300.0)) } else { parameter(&mut random) };
        let first = complete(parameter);
        assert_at_most(
            relative(complete_first_kind(parameter), &first),
            bounds::COMPLETE_FIRST_KIND.allowed(0.0),
            &format!("K at {parameter:e}"),
        );
        let mean = Real::pi(BITS) / (Real::from(2) * &first);
        let other = parameter.sqrt();
        if real(other, BITS).sqr() == real(parameter, BITS) {
            assert_at_most(
                relative(arithmetic_geometric_mean(1.0, other), &mean),
                bounds::ARITHMETIC_GEOMETRIC_MEAN.allowed(0.0),
                &format!("M(1, {other:e})"),
            );
        }
        if parameter <= 1.0 {
            // E = K − k²/3 R_D(0, k′², 1).
            let (k1, one) = (real(parameter, BITS), real(1.0, BITS));
            let square = Real::from(1) - &k1;
            let second = &first - square * carlson::third_kind(&real(0.0, BITS), &k1, &one, &one) / Real::from(3);
            let bound = bounds::COMPLETE_SECOND_KIND.allowed(nearest(&first));
            assert_at_most(relative(complete_second_kind(parameter), &second), bound, &format!("E at {parameter:e}"));
        }
    }
}

/// `F = s R_F(c², c² + k′²s², c² + s²)`, for the pair in any units and cosines far below k′ and far above.
#[test]
fn incomplete_integral() {
    let right = |sine: f64, cosine: f64, parameter: f64| {
        let (s, c, k1) = (real(sine, BITS), real(cosine, BITS), real(parameter, BITS));
        let (s2, c2) = (s.sqr(), c.sqr());
        &s * carlson::first_kind(&c2, &(&c2 + k1 * &s2), &(&c2 + &s2))
    };
    let mut random = Random::new(32);
    for _ in 0..3_000 {
        let parameter = parameter(&mut random);
        let (sine, cosine) = match random.below(4) {
            0 => random.between(-1.57, 1.57).sin_cos(),
            1 => (random.between(-1.0, 1.0), 10f64.powf(random.between(-300.0, 0.0))),
            2 => (10f64.powf(random.between(-300.0, 0.0)), random.between(0.1, 1.0)),
            _ => (1.0, parameter.sqrt() * 10f64.powf(random.between(-3.0, 3.0))),
        };
        let value = incomplete_first_kind(sine, cosine, parameter);
        let what = format!("F at {sine:e}, {cosine:e}, {parameter:e}");
        assert_at_most(
            relative(value, &right(sine, cosine, parameter)),
            bounds::INCOMPLETE_FIRST_KIND.allowed(0.0),
            &what,
        );
        // Back again: the functions there are the pair.
        let [sn, cn, _] = Jacobi::new(parameter).at(value);
        let length = sine.hypot(cosine);
        let bound = bounds::JACOBI.allowed(value) + bounds::INCOMPLETE_FIRST_KIND.allowed(0.0) * value.abs();
        assert_at_most((sn - sine / length).abs(), bound, &format!("sn, {what}"));
        assert_at_most((cn - cosine / length).abs(), bound, &format!("cn, {what}"));
    }
    // One that a doubling of the angle loses.
    let (cosine, parameter) = (2.008_318_038_325_701e-27, 2.330_320_636_042_048_6e-278);
    assert_at_most((incomplete_first_kind(1.0, cosine, parameter) / 62.165_647_116_491 - 1.0).abs(), 8.0 * EPS, "F");
}

/// sn, cn, dn within and beyond a period, to the documented bound.
#[test]
fn functions() {
    let mut random = Random::new(33);
    for _ in 0..2_000 {
        let parameter = parameter(&mut random);
        let quarter = complete(parameter);
        let size_of_u = nearest(&quarter) * [1.0, 4.0, 100.0][random.below(3) as usize];
        let u = size_of_u * random.between(-1.0, 1.0);
        let half = Real::from(2) * &quarter;
        let exact = real(u, BITS);
        let halves = (&exact / &half).round();
        let parity = if (nearest(&halves) % 2.0).abs() == 1.0 { -1 } else { 1 };
        let rest = exact - halves * half;
        let [s, c, d] = Modulus::from_complementary(&real(parameter, BITS)).at(&size(&rest));
        let right = [signed(parity * sign(&rest), s), signed(parity, c), d];
        let values = Jacobi::new(parameter).at(u);
        for (value, right) in values.iter().zip(&right) {
            let error = nearest(&(real(*value, BITS) - right)).abs();
            assert_at_most(error, bounds::JACOBI.allowed(u), &format!("k'2 {parameter:e} u {u}"));
        }
    }
}
