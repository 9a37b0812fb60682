//! The cases at which double precision ends, against references of 140 digits and more.
#![allow(clippy::expect_used, reason = "a test fails by it")]

mod common;

use common::{EPS, assert_at_most, attitude_error, vector};
use dzhanibekov::physics::{Body, Integration, Motion, State, method, poinsot::flip_period_of};
use glam::{DMat3, DVec3};

/// A case of the reference file.
struct Case {
    name: String,
    body: Body,
    start: State,
    /// `(t, R)`.
    samples: Vec<(f64, DMat3)>,
}

fn cases() -> Vec<Case> {
    let file: serde_json::Value = serde_json::from_str(include_str!("harder_cases.json")).expect("it is JSON");
    let cases = file["cases"].as_array().expect("a list of cases").iter().map(|case| {
        let body = if case["moments"].is_array() {
            Body::from_moments(vector(&case["moments"])).expect("a body")
        } else {
            let [xx, yy, zz, xy, xz, yz] = [0, 1, 2, 3, 4, 5].map(|i| case["inertia"][i].as_f64().expect("a number"));
            Body::from_tensor(DMat3::from_cols_array(&[xx, xy, xz, xy, yy, yz, xz, yz, zz])).expect("a body")
        };
        let samples = case["samples"].as_array().expect("samples").iter().map(|sample| {
            let rows = DMat3::from_cols(vector(&sample["R"][0]), vector(&sample["R"][1]), vector(&sample["R"][2]));
            (sample["t"].as_f64().expect("a time"), rows.transpose())
        });
        let start = State::new(&body, DMat3::IDENTITY, vector(&case["omega"]));
        Case { name: case["name"].as_str().expect("a name").to_owned(), body, start, samples: samples.collect() }
    });
    cases.collect()
}

/// Closed form, directly and as a method: 1e-13 at any time.
#[test]
fn closed_form_at_any_time() {
    let mut worst: f64 = 0.0;
    for case in cases() {
        let motion = Motion::new(&case.body, &case.start);
        let closed_form = method("closed-form").expect("a method");
        let mut integration = Integration::new(closed_form, &case.body, case.start, 1.0);
        for (t, attitude) in &case.samples {
            let error = attitude_error(motion.attitude(*t), *attitude);
            if std::env::var("SHOW").is_ok() {
                println!("{error:9.2e} {} at {t}", case.name);
                worst = worst.max(error);
                continue;
            }
            let what = format!("{} at {t} s", case.name);
            assert_at_most(error, 1e-13, &what);
            let state = integration.state_at(*t).expect("any time");
            assert_at_most(attitude_error(state.world_from_body, *attitude), 1e-13, &what);
            let back = state.world_from_body * state.body_momentum - case.start.world_momentum;
            let ell = case.start.world_momentum.abs().max_element();
            assert_at_most(back.abs().max_element() / ell, 1e-13, &what);
        }
    }
    println!("worst {worst:e}");
}

/// The exact step, some 2·10⁵ steps to each time that they can reach: 8ε(1 + |Ω|t), |Ω| as large as it gets.
#[test]
fn exact_step_as_far_as_steps_can_be_counted() {
    for case in cases() {
        let moments = case.body.principal_moments();
        let principal = case.body.body_from_principal().transpose() * case.start.body_angular_velocity(&case.body);
        // ℓ/I₁ is the bound of |Ω|, far too large for needles, of which |Ω| stays near what it is.
        let largest = (principal * moments / moments.y).length().max(principal.length());
        for (t, attitude) in case.samples.iter().filter(|(t, _)| t.abs() <= 1e6) {
            let steps = (t.abs() * largest / 0.25).clamp(100.0, 2e5).ceil();
            let exact_step = method("exact-step").expect("a method");
            let mut integration = Integration::new(exact_step, &case.body, case.start, t.abs() / steps);
            let state = integration.state_at(*t).expect("steps that can be counted");
            let error = attitude_error(state.world_from_body, *attitude);
            let bound = 8.0 * EPS * (1.0 + largest * t.abs());
            if std::env::var("SHOW").is_ok() {
                println!("{error:9.2e} of {bound:9.2e} {} at {t}", case.name);
                continue;
            }
            assert_at_most(error, bound, &format!("{} at {t} s", case.name));
        }
    }
}

/// The next flip is that of the motion, not that of its rounded momentum.
#[test]
fn flips_are_those_of_the_motion() {
    let body =
        Body::from_moments(DVec3::new(0.683_746_691_970_283_7, 1.218_728_978_221_389_5, 1.382_707_716_141_862_8))
            .expect("a body");
    let velocity = DVec3::new(0.573_911_798_045_180_9, -0.285_087_802_457_204_33, 0.728_959_684_445_803_3);
    let start = State::new(&body, DMat3::IDENTITY, velocity);
    let period = flip_period_of(&body, &start).expect("it flips");
    assert_at_most((period / 135.095_612_007_281_61 - 1.0).abs(), 4.0 * EPS, "between flips");
}
