//! The cases at which double precision ends, against references of 140 digits and more.
#![allow(clippy::expect_used, reason = "a test fails by it")]

mod common;

use common::Random;
use common::{EPS, assert_at_most, attitude_error, vector};
use dzhanibekov::physics::{
    Body, BodyError, Integration, METHODS, Motion, MotionClass, State, bounds, method,
    methods::Keeps,
    motion,
    poinsot::{class_of, flip_period_of, next_flip_of},
    so3,
    solids::{Shape, Solid, assemble, assemble_turned},
};
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

/// Closed form, directly and as a method, at any time.
#[test]
fn closed_form_at_any_time() {
    let bound = bounds::CLOSED_FORM_ATTITUDE.allowed(0.0);
    for case in cases() {
        let motion = Motion::new(&case.body, &case.start);
        let closed_form = method("closed-form").expect("a method");
        let mut integration = Integration::new(closed_form, &case.body, case.start, 1.0);
        for (t, attitude) in &case.samples {
            let error = attitude_error(motion.attitude(*t), *attitude);
            let what = format!("{} at {t} s", case.name);
            assert_at_most(error, bound, &what);
            let state = integration.state_at(*t).expect("any time");
            assert_at_most(attitude_error(state.world_from_body, *attitude), bound, &what);
            let lost = motion::momentum_error(&case.start, &state);
            assert_at_most(lost, bounds::WORLD_MOMENTUM.allowed(0.0), &what);
        }
    }
}

/// The exact step, up to 2·10⁵ steps to each time that these can reach.
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
            let bound = bounds::EXACT_STEP_ATTITUDE.allowed(largest * t);
            assert_at_most(error, bound, &format!("{} at {t} s", case.name));
        }
    }
}

/// Increments of a quarter period, or three, that start where the momentum's middle component is 0: no digit of cn may be lost there. The first
/// is a case that was found, its value from a Taylor series of 50 digits; the others hit that phase, one step or another of each.
#[test]
fn rounds_of_a_quarter_period() {
    let exact_step = method("exact-step").expect("a method");
    let inertia = [
        0.981_349_019_099_275_6,
        0.666_875_417_244_217,
        0.746_602_420_255_317_9,
        0.094_542_894_664_950_7,
        -0.154_134_274_710_304_16,
        0.389_310_574_157_132_66,
    ];
    let body = Body::from_tensor(tensor(inertia)).expect("a body");
    let velocity = DVec3::new(-0.154_533_009_350_453_44, -0.003_863_893_504_721_161, -0.217_971_356_533_822_07);
    let start = State::new(&body, DMat3::IDENTITY, velocity);
    let mut integration = Integration::new(exact_step, &body, start, 2.798_789_978_027_343_8);
    integration.advance(6).expect("steps");
    let attitude = DMat3::from_cols_array(&[
        -0.212_206_646_841_369_36,
        -0.181_027_505_230_924_43,
        -0.960_311_085_735_351_7,
        -0.796_245_374_666_144_7,
        -0.537_674_014_173_897_5,
        0.277_308_416_397_516_2,
        -0.566_534_767_123_001_2,
        0.823_489_949_442_004_5,
        -0.030_044_314_085_893_187,
    ]);
    let state = integration.state();
    let turn = 0.283_742_613_976_629_4 * 6.0 * 2.798_789_978_027_343_8;
    let error = attitude_error(state.world_from_body, attitude);
    assert_at_most(error, bounds::EXACT_STEP_ATTITUDE.allowed(turn), "attitude");
    let direction = DVec3::new(0.849_243_458_721_861_6, 0.524_516_857_120_013_7, -0.060_560_832_351_222_485);
    let error = so3::norm(state.body_momentum / so3::norm(start.body_momentum) - direction);
    assert_at_most(error, bounds::EXACT_STEP_MOMENTUM.allowed(turn), "momentum");

    let mut random = Random::new(73);
    let mut count = 0;
    while count < 300 {
        let edges = random.vector().abs() + 0.1;
        let body = Body::solid_box(edges, 1.0).expect("a box");
        let moving = State::new(&body, DMat3::IDENTITY, random.vector());
        let (Some(period), Some(flip)) = (flip_period_of(&body, &moving), next_flip_of(&body, &moving)) else {
            continue;
        };
        // A step's turn is below π, |Ω| being ℓ/I₁ at most. Four are a quarter period, three or five.
        let largest = so3::norm(moving.body_momentum) / body.principal_moments().x;
        let step = period / [8.0, 8.0 / 3.0, 8.0 / 5.0][random.below(3) as usize];
        if step * largest > 3.0 {
            continue;
        }
        count += 1;
        // The flip comes close to the middle of this step.
        let early = (random.below(4) as f64 + 0.5) * step + random.between(-1.0, 1.0) * 1e-3 * step;
        let momentum = Motion::new(&body, &moving).momentum(flip - early);
        let start = State::new(&body, DMat3::IDENTITY, body.angular_velocity(momentum));
        let motion = Motion::new(&body, &start);
        let mut integration = Integration::new(exact_step, &body, start, step);
        for n in 1..=16 {
            integration.advance(1).expect("a step");
            let (time, state) = (f64::from(n) * step, integration.state());
            let (attitude, momentum) = motion.at(time);
            let what = format!("{edges}, {n} steps of {step} s");
            let turn = largest * time;
            let error = attitude_error(state.world_from_body, attitude);
            assert_at_most(error, bounds::EXACT_STEP_ATTITUDE.allowed(turn), &what);
            let error = so3::norm(state.body_momentum - momentum) / so3::norm(momentum);
            assert_at_most(error, bounds::EXACT_STEP_MOMENTUM.allowed(turn), &what);
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
    assert_at_most((period / 135.095_612_007_281_6 - 1.0).abs(), 4.0 * EPS, "between flips");
}

fn tensor([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> DMat3 {
    DMat3::from_cols_array(&[xx, xy, xz, xy, yy, yz, xz, yz, zz])
}

/// A spin given along a principal axis stays there for ever by every method that steps from `M × Ω`, also where the axis is turned; and
/// it is called what it is.
#[test]
fn spins_about_turned_axes_stay() {
    let inertia =
        [0.002_034_038_446_641_534_3, 0.002_765_961_553_358_465_3, 0.004_53, -0.001_005_471_104_240_922, 0.0, 0.0];
    let turned = Body::from_tensor(tensor(inertia)).expect("a body");
    let part = |x: f64, turn: f64| Solid {
        shape: Shape::Box { edges: DVec3::new(1.0, 0.3, 0.2) },
        density: 1.0,
        position: DVec3::new(x, 0.1, -x),
        body_from_solid: DMat3::from_rotation_x(turn),
    };
    let solids = assemble(&[part(0.4, 0.3), part(-0.7, 1.1)]).expect("a body").body;
    for body in [turned, solids] {
        for axis in 1..=3_u8 {
            let mut velocity = DVec3::ZERO;
            velocity[usize::from(axis) - 1] = 6.0;
            let start = State::in_principal_frame(&body, so3::exp(DVec3::new(0.3, -0.2, 0.9)), velocity);
            assert_eq!(class_of(&body, &start), MotionClass::PureSpin { axis });
            assert_eq!((flip_period_of(&body, &start), next_flip_of(&body, &start)), (None, None));
            let world_axis = start.world_momentum.normalize();
            let stays = |state: &State, what: &str| {
                let tilt = (state.world_momentum.normalize() - world_axis).length();
                assert_at_most(tilt, 16.0 * EPS, what);
                let velocity = state.body_angular_velocity(&body) / 6.0;
                let expected = body.body_from_principal().col(usize::from(axis) - 1);
                assert_at_most((velocity - expected).length(), 64.0 * EPS, what);
            };
            stays(&Motion::new(&body, &start).state(1e9), "closed form");
            for method in METHODS.iter().filter(|method| method.keeps_momentum == Keeps::Exactly) {
                let mut integration = Integration::new(method, &body, start, 0.01);
                integration.advance(20_000).expect("steps");
                stays(&integration.state(), method.name);
            }
        }
    }
}

/// A quarter turn, a half turn and thirds of a right angle in degrees are what they are, and the rest is good to ε.
#[test]
fn degrees() {
    let exact = [
        (0.0, (0.0, 1.0)),
        (90.0, (1.0, 0.0)),
        (-90.0, (-1.0, 0.0)),
        (180.0, (0.0, -1.0)),
        (-180.0, (0.0, -1.0)),
        (270.0, (-1.0, 0.0)),
        (360.0, (0.0, 1.0)),
    ];
    for (degrees, expected) in exact {
        assert_eq!(so3::sine_and_cosine_of_degrees(degrees), expected, "{degrees}");
    }
    assert_eq!(so3::sine_and_cosine_of_degrees(30.0).0, 0.5);
    assert_eq!(so3::sine_and_cosine_of_degrees(-60.0).1, 0.5);
    let mut random = Random::new(71);
    for _ in 0..1_000 {
        let degrees: f64 = random.between(-200.0, 200.0);
        let (sine, cosine) = so3::sine_and_cosine_of_degrees(degrees);
        let (expected_sine, expected_cosine) = degrees.to_radians().sin_cos();
        // The conversion to radians has its own rounding of up to 3.5 rad.
        let bound = bounds::DEGREES.allowed(0.0) + 4.0 * EPS;
        assert_at_most((sine - expected_sine).abs().max((cosine - expected_cosine).abs()), bound, "sine and cosine");
    }
}

/// Positive definite is decided without rounding, and what is refused is blamed for what it is.
#[test]
fn tensors_at_the_edge() {
    for smallest in [1e-16, 1e-30, 1e-320] {
        let body = Body::from_tensor(tensor([smallest, 1.0, 1.0, 0.0, 0.0, 1e-3])).expect("positive definite");
        let moments = body.principal_moments();
        assert_eq!(moments.x, smallest);
        assert_at_most((moments - DVec3::new(smallest, 0.999, 1.001)).length(), 4.0 * EPS, "its moments");
    }
    for wrong in [[1e-320, 1.0, 1.0, 1e-3, 0.0, 0.0], [1e-16, 1.0, 1.0, 2e-8, 0.0, 0.0], [1.0, 1.0, 3.0, 1.0, 0.0, 0.0]]
    {
        let refused = Body::from_tensor(tensor(wrong));
        assert!(matches!(refused, Err(BodyError::NotPositiveDefinite(smallest)) if smallest <= 0.0), "{refused:?}");
    }
}

/// However they are turned: a thin rod, and solids near both ends of the range, are let pass or refused alike, with the same moments.
#[test]
fn solids_turned_any_way() {
    let mut random = Random::new(72);
    for (size, density, is_body) in [
        (DVec3::new(2e-9, 2e-9, 1.0), 1.0, true),
        (DVec3::new(1e-60, 2e-60, 3e-60), 1.0, true),
        (DVec3::new(1e60, 2e60, 3e60), 1.0, true),
        (DVec3::new(1e-110, 2e-110, 3e-110), 1.0, false),
        (DVec3::new(1e110, 2e110, 3e110), 1.0, false),
        (DVec3::new(1e-110, 2e-110, 3e-110), 1e300, true),
    ] {
        let solid = |turn: DMat3| Solid {
            shape: Shape::Ellipsoid { semi_axes: size },
            density,
            position: DVec3::ZERO,
            body_from_solid: turn,
        };
        let straight = assemble(&[solid(DMat3::IDENTITY)]);
        assert_eq!(straight.is_ok(), is_body, "{size:?}");
        for _ in 0..20 {
            let turned = assemble(&[solid(random.rotation())]);
            assert_eq!(straight.is_ok(), turned.is_ok(), "{size:?}: {straight:?} and {turned:?}");
            match (&straight, &turned) {
                (Ok(straight), Ok(turned)) => {
                    let ratio = turned.body.principal_moments() / straight.body.principal_moments();
                    // The matrix of the turn is rounded.
                    assert_at_most((ratio - 1.0).abs().max_element(), 16.0 * EPS, &format!("{size:?}"));
                }
                (Err(straight), Err(turned)) => {
                    let kind = std::mem::discriminant;
                    assert_eq!(kind(straight), kind(turned), "{straight} and {turned}");
                }
                _ => {}
            }
        }
    }
}

/// A quarter turn in degrees leaves axes along axes, without rounding; by any other the moments stay and the axes turn.
#[test]
fn solids_turned_by_degrees() {
    let edges = DVec3::new(0.2, 0.12, 0.04);
    let brick = Solid {
        shape: Shape::Box { edges },
        density: 1000.0,
        position: DVec3::new(3.0, 1.0, 2.0),
        body_from_solid: DMat3::IDENTITY,
    };
    let at = |degrees: DVec3| assemble_turned(&[brick], &[degrees]).expect("a body").body;
    let straight = at(DVec3::ZERO);
    let quarter = at(DVec3::new(0.0, 0.0, 90.0));
    assert_eq!(quarter.principal_moments(), straight.principal_moments());
    assert!(quarter.body_from_principal().to_cols_array().iter().all(|entry| [0.0, 1.0].contains(&entry.abs())));
    let turned = at(DVec3::new(20.0, -30.0, 50.0));
    assert_eq!(turned.principal_moments(), straight.principal_moments());
    let rotation = so3::exp(DVec3::new(20.0, -30.0, 50.0).map(f64::to_radians));
    for i in 0..3 {
        let (axis, expected) = (turned.body_from_principal().col(i), rotation * straight.body_from_principal().col(i));
        assert_at_most((axis - expected).length().min((axis + expected).length()), 8.0 * EPS, "its axes");
    }
    assert!(assemble_turned(&[brick], &[]).is_err());
}

/// What a state's L has lost is seen in attitude and body momentum, whatever world momentum it stores.
#[test]
fn errors_are_measured_on_the_state() {
    let body = Body::from_moments(DVec3::new(1.0, 2.0, 3.0)).expect("a body");
    let start = State::new(&body, DMat3::IDENTITY, DVec3::new(0.3, 1.0, -0.4));
    let mut moved = start;
    moved.world_from_body = DMat3::from_rotation_x(1e-3);
    let expected =
        (moved.world_from_body * start.body_momentum - start.body_momentum).length() / start.body_momentum.length();
    assert_at_most((motion::momentum_error(&start, &moved) / expected - 1.0).abs(), 1e-12, "a turn");
    assert_eq!(motion::energy_error(&body, &start, &moved), 0.0);
    moved.body_momentum *= 1.01;
    assert_at_most((motion::energy_error(&body, &start, &moved) - 0.0201).abs(), 4.0 * EPS, "1 % more momentum");
    let rest = State::new(&body, DMat3::IDENTITY, DVec3::ZERO);
    assert_at_most((motion::momentum_error(&rest, &start) - start.body_momentum.length()).abs(), EPS, "from rest");
    assert_eq!(motion::energy_error(&body, &rest, &start), start.energy(&body));
}

/// The table names each of its rows once, and every bound is above 0 or means never.
#[test]
fn the_table_of_bounds() {
    for (n, bound) in bounds::BOUNDS.iter().enumerate() {
        assert!(bound.allowed(0.0) >= 0.0 && bound.allowed(1e3) >= bound.allowed(0.0), "{}", bound.of);
        let again = bounds::BOUNDS[..n].iter().find(|other| (other.of, other.quantity) == (bound.of, bound.quantity));
        assert!(again.is_none(), "{} twice", bound.of);
    }
}
