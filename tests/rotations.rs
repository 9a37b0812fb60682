//! SO(3) and its Lie algebra.

mod common;

use std::f64::consts::PI;

use common::{EPS, Random, assert_at_most, attitude_error};
use dzhanibekov::physics::so3;
use glam::{DMat3, DVec3};

#[test]
fn hat_is_the_cross_product_and_vee_its_inverse() {
    let mut random = Random::new(21);
    for _ in 0..1_000 {
        let (a, b) = (random.vector(), random.vector());
        assert_eq!(so3::vee(so3::hat(a)), a);
        assert_at_most((so3::hat(a) * b - a.cross(b)).length(), 2.0 * EPS, "hat");
    }
}

/// `[a×][b×] − [b×][a×] = [(a×b)×]`: six products a side.
#[test]
fn bracket_identity() {
    let mut random = Random::new(22);
    for _ in 0..1_000 {
        let (a, b) = (random.vector(), random.vector());
        let bracket = so3::hat(a) * so3::hat(b) - so3::hat(b) * so3::hat(a);
        assert_at_most(so3::frobenius_norm(bracket - so3::hat(a.cross(b))), 8.0 * EPS, "bracket");
    }
}

/// `log exp v = v` for every angle up to π: from denormal to the last digit before π, where the sign may turn.
#[test]
fn exp_and_log_are_inverse() {
    let mut random = Random::new(23);
    for n in 0..40_000 {
        let axis = random.vector().normalize();
        let angle = match n % 4 {
            0 => random.between(0.0, PI),
            1 => 10f64.powf(random.between(-300.0, 0.0)),
            2 => PI - 10f64.powf(random.between(-16.0, -1.0)),
            // Either side of the change from series to sine and cosine.
            _ => 1.0 + random.between(-1e-3, 1e-3),
        };
        let v = angle * axis;
        let back = so3::log(so3::exp(v));
        // The matrix holds small rotations to ε absolutely; its entries are nine roundings.
        let error = (back - v).length().min(if angle > 3.1 { (back + v).length() } else { f64::MAX });
        assert_at_most(error, 8.0 * EPS, &format!("{v} and back {back}"));
    }
}

#[test]
fn exp_at_0_and_pi() {
    assert_eq!(so3::exp(DVec3::ZERO), DMat3::IDENTITY);
    assert_eq!(so3::log(DMat3::IDENTITY), DVec3::ZERO);
    for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
        let half_turn = DMat3::from_diagonal(2.0 * axis * axis - DVec3::ONE);
        assert_at_most(attitude_error(so3::exp(PI * axis), half_turn), 2.0 * EPS, "half turn");
        assert_at_most((so3::log(half_turn).abs() - PI * axis).length(), 2.0 * EPS, "its log");
    }
}

/// Rotations by any finite vector are rotations, and `exp(a) exp(b) = exp(a + b)` along one axis.
#[test]
fn exp_is_a_rotation() {
    let mut random = Random::new(24);
    for _ in 0..10_000 {
        let size = 10f64.powf(random.between(-320.0, 308.0));
        let rotation = so3::exp(size * random.vector());
        assert_at_most(so3::orthogonality_error(rotation), 16.0 * EPS, "orthogonality");
        assert_at_most((rotation.determinant() - 1.0).abs(), 16.0 * EPS, "determinant");
        let v = random.vector();
        let (a, b) = (random.between(-3.0, 3.0), random.between(-3.0, 3.0));
        let error = attitude_error(so3::exp(a * v) * so3::exp(b * v), so3::exp((a + b) * v));
        assert_at_most(error, 24.0 * EPS, "one-parameter group");
    }
}

/// The series of exp: `1 + [v×] + [v×]²/2 + …` summed as it stands.
#[test]
fn exp_is_the_power_series() {
    let mut random = Random::new(25);
    for _ in 0..1_000 {
        let v = 1.2 * random.vector();
        let (mut sum, mut term) = (DMat3::IDENTITY, DMat3::IDENTITY);
        for n in 1..40 {
            term = term * so3::hat(v) * (1.0 / f64::from(n));
            sum += term;
        }
        assert_at_most(attitude_error(so3::exp(v), sum), 16.0 * EPS, "series");
    }
}

#[test]
fn angles_between() {
    let mut random = Random::new(26);
    for _ in 0..1_000 {
        let attitude = random.rotation();
        let angle = 10f64.powf(random.between(-12.0, 0.49));
        let turned = attitude * so3::exp(angle * random.vector().normalize());
        assert_at_most((so3::angle_between(attitude, turned) - angle).abs(), 64.0 * EPS, "angle");
    }
    assert_eq!(so3::angle_between(DMat3::IDENTITY, DMat3::IDENTITY), 0.0);
}

#[test]
fn norms_of_any_size() {
    for size in [1e-320, 1e-200, 1.0, 1e200, 1e307] {
        let v = DVec3::new(2.0, -3.0, 6.0) * size;
        // Denormals have no more digits than that.
        let bound = if size < 1e-300 { 1e-3 } else { 4.0 * EPS };
        assert_at_most((so3::norm(v) / (7.0 * size) - 1.0).abs(), bound, "norm");
    }
    assert_eq!(so3::norm(DVec3::ZERO), 0.0);
}
