//! The closed form against 60-digit references, an independent integrator, and itself.

#![allow(clippy::expect_used, reason = "a test fails by it")]
mod common;

use common::{EPS, Random, assert_at_most, attitude_error, random_motion, reference_cases, state_of, taylor};
use dzhanibekov::physics::{Body, Motion, so3};
use glam::{DMat3, DVec3};

/// Inputs are exact, rates carry 100 bits and phases are reduced, so that no error grows with time: some ten roundings
/// of numbers up to 1, 1e-13 being 450 ε.
#[test]
fn every_reference_case_at_every_time() {
    for case in reference_cases() {
        let motion = Motion::new(&case.body, &case.start);
        let ell = case.start.body_momentum.length();
        for (t, attitude, momentum) in &case.samples {
            let state = motion.state(*t);
            let what = format!("{} at {t} s", case.name);
            assert_at_most(so3::angle_between(state.world_from_body, *attitude), 1e-13, &what);
            assert_at_most((state.body_momentum - *momentum).length() / ell, 1e-13, &what);
            assert_eq!(state.world_momentum, case.start.world_momentum);
        }
    }
}

/// Bodies of every kind, backwards and forwards, over times up to 4 rad at the fastest rate of the orbit, against Taylor series of
/// order 24: some 14 steps of 4ε there, and the closed form's own 10ε.
#[test]
fn random_bodies_against_taylor_series() {
    let mut random = Random::new(1);
    let mut worst = (0.0, DVec3::ZERO, DVec3::ZERO);
    for _ in 0..20_000 {
        let (moments, momentum) = random_motion(&mut random);
        let body = Body::from_moments(moments).expect("a body");
        let start = state_of(&body, DMat3::IDENTITY, momentum);
        let momentum = start.body_momentum;
        let time = random.between(-4.0, 4.0) * moments.x / momentum.length();
        let (attitude, end) = taylor::integrate(moments, momentum, time);
        let state = Motion::new(&body, &start).state(time);
        let error = attitude_error(state.world_from_body, attitude)
            .max((state.body_momentum - end).length() / momentum.length());
        assert!(!error.is_nan());
        if error > worst.0 {
            worst = (error, moments, momentum);
        }
    }
    assert_at_most(worst.0, 64.0 * EPS, &format!("moments {} momentum {}", worst.1, worst.2));
}

/// At the end of a long time the motion goes on as from a fresh start there: 10³ to 10⁹ rad later, two more radians against
/// Taylor series from the state that was reached. The start of those is rounded, which `e^{λt} < e⁴` may blow up.
#[test]
fn far_states_go_on_as_the_equations_say() {
    let mut random = Random::new(7);
    for _ in 0..5_000 {
        let (moments, momentum) = random_motion(&mut random);
        let body = Body::from_moments(moments).expect("a body");
        let motion = Motion::new(&body, &state_of(&body, DMat3::IDENTITY, momentum));
        let unit = moments.x / momentum.length();
        let far = unit * 10f64.powf(random.between(3.0, 9.0)).floor();
        // A time that the sum with holds exactly.
        let step = (far + 2.0 * unit) - far;
        let (here, there) = (motion.state(far), motion.state(far + step));
        let (attitude, end) = taylor::integrate(moments, here.body_momentum, step);
        let what = format!("moments {moments} momentum {momentum} time {far}");
        let error = attitude_error(there.world_from_body, here.world_from_body * attitude);
        assert_at_most(error, 400.0 * EPS, &what);
        assert_at_most((there.body_momentum - end).length() / momentum.length(), 400.0 * EPS, &what);
    }
}
