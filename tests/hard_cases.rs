//! What an adversary would try: scales, degenerate bodies, separatrices, pure spins, long times, coarse steps.
#![allow(clippy::expect_used, reason = "a test fails by it")]

mod common;

use common::{EPS, Random, assert_at_most, attitude_error, random_motion, state_of};
use dzhanibekov::physics::{
    Body, Integration, METHODS, Motion, MotionClass, State, bounds, methods::Keeps, motion, poinsot, so3,
};
use glam::{DMat3, DVec3};

/// R a rotation, `RM = L`, `|M| = ℓ` and K kept, to 32ε: each is a few sums of products of numbers that are good to a few ε.
fn assert_on_orbit(body: &Body, start: &State, state: &State, what: &str) {
    let ell = so3::norm(start.body_momentum);
    assert_at_most(so3::orthogonality_error(state.world_from_body), bounds::ROTATION.allowed(0.0), what);
    assert_at_most((so3::norm(state.body_momentum / ell) - 1.0).abs(), bounds::WORLD_MOMENTUM.allowed(0.0), what);
    assert_at_most(motion::momentum_error(start, state), bounds::WORLD_MOMENTUM.allowed(0.0), what);
    assert_at_most(motion::energy_error(body, start, state).abs(), bounds::CLOSED_FORM_ENERGY.allowed(0.0), what);
}

/// 10⁵ bodies of every kind at every scale and to any time.
#[test]
fn closed_form_stays_on_its_orbit() {
    let mut random = Random::new(2);
    for n in 0..100_000 {
        let (moments, momentum) = random_motion(&mut random);
        let scale = [1.0, 1e-150, 1e150][n % 3];
        let body = Body::from_moments(moments * scale).expect("a body");
        let attitude = random.rotation();
        let start = state_of(&body, attitude, momentum * [1.0, 1e-100, 1e100][n / 3 % 3] * scale.powf(0.25));
        let exponent = random.between(-3.0, 12.0);
        let time = 10f64.powf(exponent) * random.between(-1.0, 1.0);
        let state = Motion::new(&body, &start).state(time);
        assert_on_orbit(&body, &start, &state, &format!("moments {moments} momentum {momentum} time {time:e}"));
    }
}

/// The same motion in other units is the same motion: to the last bit for units that are powers of two.
#[test]
fn units_do_not_matter() {
    let mut random = Random::new(3);
    for _ in 0..2_000 {
        let (moments, momentum) = random_motion(&mut random);
        let time = random.between(-30.0, 30.0);
        let at = |moment_unit: f64, momentum_unit: f64| {
            let body = Body::from_moments(moments * moment_unit).expect("a body");
            let start = state_of(&body, DMat3::IDENTITY, momentum * momentum_unit);
            Motion::new(&body, &start).state(time * (moment_unit / momentum_unit))
        };
        let here = at(1.0, 1.0);
        for (moment_unit, momentum_unit) in [(2f64.powi(400), 2f64.powi(-400)), (2f64.powi(-497), 2f64.powi(-480))] {
            let there = at(moment_unit, momentum_unit);
            assert_eq!(here.world_from_body, there.world_from_body);
            assert_eq!(here.body_momentum * momentum_unit, there.body_momentum);
        }
    }
}

/// Any valid body, any finite time: no number that is none. Denormals, the largest numbers, the widest ratios.
#[test]
fn nothing_is_ever_not_a_number() {
    let sizes = [5e-324, 1e-308, 1e-200, 1e-150, 1e-16, 1.0, 3.0, 1e16, 1e150, 1e200, 1e300];
    let mut random = Random::new(4);
    let mut pick = |signed: bool| {
        let size = sizes[random.below(sizes.len() as u64) as usize];
        if signed { size * [1.0, -1.0, 0.0][random.below(3) as usize] } else { size }
    };
    for _ in 0..30_000 {
        let moments = DVec3::new(pick(false), pick(false), pick(false));
        let momentum = DVec3::new(pick(true), pick(true), pick(true));
        let body = Body::from_moments(moments).expect("a body");
        let velocity = body.angular_velocity(momentum);
        if !velocity.is_finite() || !body.momentum(velocity).is_finite() {
            continue;
        }
        let start = State::new(&body, DMat3::IDENTITY, velocity);
        for time in [0.0, 1.0, -1e-300, 1e12, -1e300, f64::MAX] {
            let state = Motion::new(&body, &start).state(time);
            let what = format!("moments {moments:?} momentum {momentum:?} time {time:e}");
            assert!(state.world_from_body.is_finite() && state.body_momentum.is_finite(), "{what}");
            assert_at_most(so3::orthogonality_error(state.world_from_body), 1e-14, &what);
        }
        for points in [
            poinsot::polhode(&body, start.body_momentum, 5),
            poinsot::separatrix(&body, 1.0, 5).map_or(vec![], |[a, b]| [a, b].concat()),
        ] {
            assert!(points.iter().all(|point| point.is_finite()), "moments {moments:?} momentum {momentum:?}");
        }
        for time in [poinsot::flip_period(&body, start.body_momentum), poinsot::next_flip(&body, start.body_momentum)] {
            assert!(time.is_none_or(|time| time.is_finite() && time >= 0.0), "moments {moments} momentum {momentum}");
        }
    }
}

/// Exactly on the middle axis the body stays there, by every method that steps from `M × Ω`, for ever.
#[test]
fn exactly_on_the_middle_axis_it_stays() {
    let body = Body::from_moments(DVec3::new(1.0, 2.0, 3.0)).expect("a body");
    let start = State::new(&body, DMat3::IDENTITY, DVec3::new(0.0, 0.7, 0.0));
    let state = Motion::new(&body, &start).state(1e9);
    assert_eq!(state.body_momentum, start.body_momentum);
    assert_eq!(poinsot::classify(&body, start.body_momentum), MotionClass::PureSpin { axis: 2 });
    assert_eq!(poinsot::class_of(&body, &start), MotionClass::PureSpin { axis: 2 });
    for method in METHODS {
        if method.keeps_momentum != Keeps::Exactly {
            continue;
        }
        let mut integration = Integration::new(method, &body, start, 0.01);
        integration.advance(20_000).expect("steps");
        let tilt = integration.state().body_momentum.cross(DVec3::Y).length();
        assert_eq!(tilt, 0.0, "{}", method.name);
    }
}

/// Moments and momentum that come to a degenerate case as the number goes to 0.
type Family = fn(f64) -> ([f64; 3], [f64; 3]);

/// Close to a degenerate case the motion is close to that of the degenerate case: a difference δ of the bodies or starts makes
/// one of at most some `10 δ |Ω|t e^{σt}` in the attitude, at t = 2 with all rates near 1.
#[test]
fn degenerate_cases_are_limits() {
    let at = |moments: [f64; 3], momentum: [f64; 3]| {
        let body = Body::from_moments(DVec3::from_array(moments)).expect("a body");
        let start = state_of(&body, DMat3::IDENTITY, DVec3::from_array(momentum));
        Motion::new(&body, &start).state(2.0).world_from_body
    };
    let families: [(&str, Family); 9] = [
        ("two smaller moments equal", |d| ([1.0, 1.0 + d, 2.0], [0.3, 0.4, 0.8])),
        ("two larger moments equal", |d| ([1.0, 2.0, 2.0 + d], [0.8, 0.4, 0.3])),
        ("sphere", |d| ([1.0, 1.0 + d, 1.0 + 2.0 * d], [0.3, 0.4, 0.8])),
        ("spin in the plane of equals", |d| ([1.0, 1.0 + d, 2.0], [0.6, 0.8, d])),
        ("pure spin about 1", |d| ([1.0, 2.0, 3.0], [1.0, d, d])),
        ("pure spin about 2", |d| ([1.0, 2.0, 3.0], [d, 1.0, d])),
        ("pure spin about 3", |d| ([1.0, 2.0, 3.0], [d, d, 1.0])),
        ("separatrix", |d| ([6.0, 8.0, 12.0], [12.0 * (1.0 + d), 12.0, 12.0])),
        ("flat plate", |d| ([1.0, 2.0, 3.0 - d], [0.5, 0.8, 0.4])),
    ];
    for (name, family) in families {
        let (moments, momentum) = family(0.0);
        let limit = at(moments, momentum);
        for exponent in 3..19 {
            for sign in [1.0, -1.0] {
                let delta = sign * 10f64.powi(-exponent);
                let (moments, momentum) = family(delta);
                let error = attitude_error(at(moments, momentum), limit);
                assert_at_most(error, 300.0 * delta.abs() + 40.0 * EPS, &format!("{name}, {delta:e} off"));
            }
        }
    }
}

/// A body at rest stays as it is, by every method.
#[test]
fn at_rest() {
    let body = Body::from_moments(DVec3::new(1.0, 2.0, 3.0)).expect("a body");
    let start = State::new(&body, so3::exp(DVec3::new(0.3, 0.2, 0.1)), DVec3::ZERO);
    for method in METHODS {
        let mut integration = Integration::new(method, &body, start, 0.1);
        let state = integration.state_at(12.34).expect("rest");
        assert_at_most(attitude_error(state.world_from_body, start.world_from_body), 4.0 * EPS, method.name);
        assert_eq!(state.body_momentum, DVec3::ZERO);
    }
    assert_eq!(poinsot::classify(&body, DVec3::ZERO), MotionClass::AtRest);
}

/// Coarse steps, `h|Ω|` up to 3: a result on the orbit as far as the method claims it, or a word that there is none.
#[test]
fn coarse_steps_are_honest() {
    let mut random = Random::new(5);
    for n in 0..600 {
        let (moments, momentum) = random_motion(&mut random);
        let moments = moments.max(DVec3::splat(0.05));
        let body = Body::from_moments(moments).expect("a body");
        let start = state_of(&body, DMat3::IDENTITY, momentum);
        let step = [0.5, 1.0, 1.5, 2.0, 3.0][n % 5] / start.body_angular_velocity(&body).length();
        for method in METHODS {
            let mut integration = Integration::new(method, &body, start, step);
            let what = format!("{} moments {moments} momentum {momentum} step {step}", method.name);
            if integration.advance(300).is_err() {
                assert!(!method.explicit || method.keeps_rotation == Keeps::No, "{what} gave up");
                assert_eq!(integration.state(), start, "{what} moved all the same");
                continue;
            }
            let state = integration.state();
            assert!(state.world_from_body.is_finite() && state.body_momentum.is_finite(), "{what}");
            if method.keeps_rotation == Keeps::Exactly {
                assert_at_most(so3::orthogonality_error(state.world_from_body), 16.0 * EPS, &what);
            }
            let energy_error = (state.energy(&body) / start.energy(&body) - 1.0).abs();
            match method.keeps_energy {
                Keeps::Exactly => assert_at_most(energy_error, 1e-13, &what),
                // Of a method of order 2 at steps of a radian.
                Keeps::Nearby => assert_at_most(energy_error, 1.0, &what),
                Keeps::No => {}
            }
        }
    }
}
