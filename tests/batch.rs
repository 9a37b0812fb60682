//! Batches against the motions one by one, on any processor and with all that this one has.
#![allow(clippy::expect_used, reason = "a test fails by it")]

mod common;

use common::{EPS, Random, assert_at_most, attitude_error, random_motion, reference_cases, state_of};
use dzhanibekov::physics::poinsot::{flip_period_of, next_flip_of};
use dzhanibekov::physics::{Batch, Body, Motion, State, so3};
use glam::{DMat3, DVec3};

/// Random boxes, tossed any way.
fn boxes(count: usize, seed: u64) -> Vec<(Body, State)> {
    let mut random = Random::new(seed);
    (0..count)
        .map(|_| {
            let body = Body::solid_box(random.vector().abs() + 0.05, 1.0).expect("a box");
            let attitude = random.rotation();
            (body, state_of(&body, attitude, body.body_from_principal() * random.vector()))
        })
        .collect()
}

/// The largest `|Ω|` of a motion: `ℓ/I₁` at most.
fn largest_rate(body: &Body, start: &State) -> f64 {
    start.body_momentum.length() / body.principal_moments().x
}

/// Both kinds of batch.
fn both(bodies: &[(Body, State)]) -> [Batch; 2] {
    [Batch::of_bodies(bodies), Batch::of_bodies(bodies).on_any_processor()]
}

fn assert_near(bodies: &[(Body, State)], states: &[State], time: f64, bound: impl Fn(f64) -> f64, what: &str) {
    assert_eq!(bodies.len(), states.len());
    for (index, ((body, start), state)) in bodies.iter().zip(states).enumerate() {
        let exact = Motion::new(body, start).state(time);
        let what = format!("{what}, body {index} at {time}: {:?}", body.principal_moments());
        let bound = bound(largest_rate(body, start));
        assert_at_most(attitude_error(state.world_from_body, exact.world_from_body), bound, &what);
        let error = (state.body_momentum - exact.body_momentum).length() / exact.body_momentum.length().max(1e-300);
        assert_at_most(error, bound, &what);
        // R(0), the frame, its transpose, the turn and three products: some 4ε each.
        assert_at_most(so3::orthogonality_error(state.world_from_body), 32.0 * EPS, &what);
        assert_eq!(state.world_momentum, start.world_momentum, "{what}");
    }
}

/// The bound of the single step, `8ε(1 + |Ω|t)`, over 10⁴ steps of every length, for a thousand bodies.
#[test]
fn a_thousand_bodies_over_ten_thousand_steps() {
    let bodies = boxes(1000, 31);
    for step in [1e-6, 1e-4, 0.003, 0.02, 0.1, 0.3] {
        for mut batch in both(&bodies) {
            for count in [1, 99, 2_900, 7_000] {
                batch.advance(step, count);
                let time = batch.time();
                let bound = |rate: f64| 8.0 * EPS * (1.0 + rate * time);
                assert_near(&bodies, &batch.states(), time, bound, &format!("steps of {step} s"));
            }
            assert_eq!(batch.time(), 10_000.0 * step);
        }
    }
}

/// The reference cases side by side, each at its own rate, forwards and backwards: the separatrix among them.
#[test]
fn the_reference_cases() {
    let bodies: Vec<(Body, State)> = reference_cases().iter().map(|case| (case.body, case.start)).collect();
    for step in [1e-5, 0.001, 0.05] {
        for mut batch in both(&bodies) {
            let mut taken = 0.0;
            for count in [500, -1_300, 40, 7, -3] {
                batch.advance(step, count);
                taken += step * count.abs() as f64;
                let bound = |rate: f64| 8.0 * EPS * (1.0 + rate * taken) + 200.0 * EPS;
                assert_near(&bodies, &batch.states(), batch.time(), bound, &format!("steps of {step} s"));
            }
        }
    }
}

/// Steps of a quarter period of nearly symmetric bodies, one of which starts where the momentum's middle component is 0: no digit of cn is lost.
#[test]
fn steps_of_a_quarter_period() {
    let mut random = Random::new(37);
    for _ in 0..200 {
        let body = Body::from_moments(DVec3::new(1.0, 1.0 + random.between(0.01, 0.3), 1.9)).expect("a body");
        // Near its axis, where M goes round almost as fast as the body: a quarter of the one is less than half a turn of the other.
        let momentum = DVec3::new(random.between(-0.3, 0.3), random.between(-0.3, 0.3), 2.0);
        let moving = state_of(&body, DMat3::IDENTITY, momentum);
        let step = 0.5 * flip_period_of(&body, &moving).expect("it goes round");
        let flip = next_flip_of(&body, &moving).expect("it goes round");
        let early = (0.5 + random.between(-1.0, 1.0) * 1e-3) * step;
        let bodies = [(body, state_of(&body, random.rotation(), Motion::new(&body, &moving).momentum(flip - early)))];
        for mut batch in both(&bodies) {
            for _ in 0..16 {
                batch.advance(step, 1);
                let time = batch.time();
                let bound = |rate: f64| 8.0 * EPS * (1.0 + rate * time);
                assert_near(&bodies, &batch.states(), time, bound, &format!("steps of {step} s"));
            }
        }
    }
}

/// What an adversary would choose.
#[test]
fn random_motions() {
    let mut random = Random::new(32);
    let bodies: Vec<(Body, State)> = (0..3_000)
        .filter_map(|_| {
            let (moments, momentum) = random_motion(&mut random);
            let body = Body::from_moments(moments).ok()?;
            Some((body, state_of(&body, DMat3::IDENTITY, momentum)))
        })
        .collect();
    for mut batch in both(&bodies) {
        for (step, count) in [(0.01, 300), (0.4, -200), (0.01, 1)] {
            batch.advance(step, count);
        }
        // 501 steps over 83 s in all.
        let bound = |rate: f64| 8.0 * EPS * (501.0 + 83.1 * rate);
        assert_near(&bodies, &batch.states(), batch.time(), bound, "random motions");
    }
}

/// The closed form side by side, at times up to 10¹² s, is the closed form of each body alone: each of the two is some ε from the truth.
/// Momenta keep their small components too.
#[test]
fn any_time_is_that_of_each_alone() {
    let mut random = Random::new(35);
    let mut bodies = boxes(2_000, 36);
    bodies.extend((0..6_000).filter_map(|_| {
        let (moments, momentum) = random_motion(&mut random);
        let body = Body::from_moments(moments).ok()?;
        Some((body, state_of(&body, random.rotation(), momentum)))
    }));
    for batch in both(&bodies) {
        for time in [-1e3, -0.7, 1e-9, 0.3, 11.0, 5e4, 1e8, 1e12, 1e17, 1e300] {
            let (states, momenta) = (batch.states_at(time), batch.momenta_at(time));
            assert_eq!([states.len(), momenta.len()], [bodies.len(); 2]);
            for (((body, start), state), momentum) in bodies.iter().zip(&states).zip(&momenta) {
                let alone = Motion::new(body, start).state(time);
                let what = format!("{:?} {:?} at {time}", body.principal_moments(), start.body_momentum);
                let size = start.body_momentum.length();
                assert_at_most(attitude_error(state.world_from_body, alone.world_from_body), 64.0 * EPS, &what);
                assert_at_most(so3::orthogonality_error(state.world_from_body), 32.0 * EPS, &what);
                assert_at_most((state.body_momentum - alone.body_momentum).length() / size, 32.0 * EPS, &what);
                assert_eq!(state.body_momentum, *momentum, "{what}");
                assert_eq!(state.world_momentum, start.world_momentum, "{what}");
            }
        }
    }
}

/// And against the references: 1e-13.
#[test]
fn any_time_meets_the_references() {
    for case in reference_cases() {
        let batch = Batch::of_starts(&case.body, &[case.start; 11]);
        for (time, attitude, momentum) in &case.samples {
            for state in batch.states_at(*time) {
                let what = format!("{} at {time}", case.name);
                assert_at_most(attitude_error(state.world_from_body, *attitude), 1e-13, &what);
                assert_at_most((state.body_momentum - *momentum).length() / momentum.length(), 1e-13, &what);
            }
        }
    }
}

/// However often it turns round, and whatever the steps before were: each of them adds the rounding of one.
#[test]
fn to_and_fro_and_other_steps() {
    let bodies = boxes(70, 33);
    for mut batch in both(&bodies) {
        for n in 0..300 {
            batch.advance(0.02, 1);
            batch.advance(0.02, -1);
            batch.advance(0.3 / f64::from(1 + n % 7), 3);
        }
        let time = batch.time();
        let bound = |rate: f64| 8.0 * EPS * (1_500.0 + rate * (time + 12.0));
        assert_near(&bodies, &batch.states(), time, bound, "to and fro");
    }
}

/// Many starts of one body are as many bodies with a start; the order is kept, and how many there are does not matter.
#[test]
fn starts_of_one_body() {
    let body = Body::solid_box(DVec3::new(0.2, 0.12, 0.04), 1.0).expect("a box");
    let mut random = Random::new(34);
    for count in [0, 1, 2, 31, 32, 33, 257] {
        let starts: Vec<State> = (0..count).map(|_| state_of(&body, random.rotation(), random.vector())).collect();
        let pairs: Vec<(Body, State)> = starts.iter().map(|start| (body, *start)).collect();
        let (mut starts_batch, mut pairs_batch) = (Batch::of_starts(&body, &starts), Batch::of_bodies(&pairs));
        assert_eq!((starts_batch.len(), starts_batch.is_empty()), (count, count == 0));
        assert_eq!(starts_batch.states(), starts);
        assert_eq!(starts_batch.states_at(0.0), starts);
        starts_batch.advance(0.01, 77);
        pairs_batch.advance(0.01, 77);
        assert_eq!(starts_batch.states(), pairs_batch.states());
        let (states, momenta) = (starts_batch.states_at(12.3), starts_batch.momenta_at(12.3));
        assert_eq!([states.len(), momenta.len()], [count; 2]);
        for (state, momentum) in states.iter().zip(&momenta) {
            assert_at_most((state.body_momentum - *momentum).length() / momentum.length(), 8.0 * EPS, "momenta");
        }
        // One at a time: the same bits.
        for (start, state) in starts.iter().zip(starts_batch.states()) {
            let mut alone = Batch::of_starts(&body, &[*start]);
            alone.advance(0.01, 70);
            alone.advance(0.01, 7);
            assert_eq!(alone.states(), [state]);
        }
    }
}
