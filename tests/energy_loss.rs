//! Energy lost inside the body at constant L.
#![allow(clippy::expect_used, reason = "a test fails by it")]

mod common;

use common::{EPS, Random, assert_at_most, attitude_error};
use dzhanibekov::physics::{Body, Integration, State, method, methods::LOSS_METHOD, motion, poinsot, so3};
use glam::{DMat3, DVec3};

/// The method that knows loss, at work.
fn losing(body: &Body, start: State, step: f64, energy_loss: f64) -> Integration {
    Integration::with_energy_loss(method(LOSS_METHOD).expect("a method"), body, start, step, energy_loss)
}

/// A box with three edges that differ, turned in its own frame, and a start of ℓ about 1 anywhere on its sphere.
fn random_start(random: &mut Random) -> (Body, State) {
    let edges = DVec3::new(random.between(0.1, 0.4), random.between(0.5, 0.8), random.between(0.9, 1.4));
    let moments = Body::solid_box(edges, 10.0).expect("a box").principal_moments();
    let turn = random.rotation();
    let tensor = turn * DMat3::from_diagonal(moments) * turn.transpose();
    let body = Body::from_tensor(0.5 * (tensor + tensor.transpose())).expect("a body");
    let momentum = random.vector().normalize() * random.between(0.5, 2.0);
    let start = State::new(&body, random.rotation(), body.angular_velocity(momentum));
    (body, start)
}

/// The largest rate that a motion of this momentum can have, ℓ/I₁.
fn largest_rate(body: &Body, start: &State) -> f64 {
    start.body_momentum.length() / body.principal_moments().x
}

/// `R M = L₀` and `RᵀR = 1` at 16ε over 10⁵ steps, as of every method that is said to keep them; L itself to the bit.
#[test]
fn momentum_is_kept_to_rounding() {
    let mut random = Random::new(51);
    for _ in 0..20 {
        let (body, start) = random_start(&mut random);
        let mut integration = losing(&body, start, 0.05 / largest_rate(&body, &start), 0.02);
        for _ in 0..10 {
            integration.advance(10_000).expect("short steps");
            let state = integration.state();
            assert_at_most(motion::momentum_error(&start, &state), 16.0 * EPS, "|RM − L|/ℓ");
            assert_at_most(so3::orthogonality_error(state.world_from_body), 16.0 * EPS, "|RᵀR − 1|");
            assert_eq!(state.world_momentum, start.world_momentum);
        }
    }
}

/// The energy never rises by more than M's own rounding, a few ε of which each K has twice: 32ε, at any start and loss, down to the end.
#[test]
fn energy_never_rises() {
    let mut random = Random::new(52);
    for n in 0..60 {
        let (body, start) = random_start(&mut random);
        let loss = [1e-3, 0.02, 0.5][n % 3];
        let mut integration = losing(&body, start, 0.02 / largest_rate(&body, &start), loss);
        let mut before = start.energy(&body);
        let first = before;
        for _ in 0..20_000 {
            integration.advance(1).expect("short steps");
            let now = integration.state().energy(&body);
            assert!(now <= before * (1.0 + 32.0 * EPS), "{now} after {before}");
            before = now;
        }
        assert!(before < first * (1.0 - 1e-6), "nothing was lost of {first}");
    }
}

/// `K̇ = −(loss/ℓ) |M×Ω|²`, by a difference over ±h. The difference's own error is `h² K⃛/6`: K is a square of M, which turns by some
/// `x = h ℓ/I₁` in h; three times d/dt of a bilinear form of M is at most 2³ (ℓ/I₁)³ of it, so `x² 8/6` of the largest K̇ there could be; the
/// method's error is `x⁵`; rounding is 64ε K/h.
#[test]
fn energy_falls_at_the_rate_of_the_formula() {
    let mut random = Random::new(53);
    for _ in 0..300 {
        let (body, start) = random_start(&mut random);
        let (rate, loss) = (largest_rate(&body, &start), random.between(0.01, 0.2));
        let x = 1e-4;
        let h = x / rate;
        let energy = |count| {
            let mut integration = losing(&body, start, h, loss);
            integration.advance(count).expect("short steps");
            integration.state().energy(&body)
        };
        let measured = (energy(1) - energy(-1)) / (2.0 * h);
        let (momentum, ell) = (start.body_momentum, start.body_momentum.length());
        let wanted = -loss / ell * motion::momentum_rate(&body, momentum).length_squared();
        let largest = loss * ell * ell / body.principal_moments().x * rate;
        let bound = 4.0 / 3.0 * x * x * largest + 64.0 * EPS * start.energy(&body) / h;
        assert_at_most((measured - wanted).abs(), bound, &format!("K̇ = {wanted}"));
        assert!(wanted.abs() > 100.0 * bound || motion::momentum_rate(&body, momentum).length() < 0.1 * ell * rate);
    }
}

/// Order 4, as the slope of log error over log step between four steps, each half the one before. There is no closed form: the error is the distance to the run with
/// half the step again, `(1 − 2⁻⁴)` of its own, which has the same slope.
#[test]
fn order_four_with_loss() {
    let body = Body::from_moments(DVec3::new(0.5, 0.85, 1.0)).expect("a body");
    let start = State::new(&body, so3::exp(DVec3::new(0.2, -0.5, 1.0)), DVec3::new(1.0, 0.6, 0.3));
    for loss in [0.0, 0.05, 0.2] {
        let runs: Vec<DMat3> = (5..=9)
            .map(|level| {
                let mut integration = losing(&body, start, 1.0 / f64::from(1 << level), loss);
                integration.advance(10 << level).expect("short steps");
                integration.state().world_from_body
            })
            .collect();
        let errors: Vec<f64> = runs.windows(2).map(|pair| attitude_error(pair[0], pair[1]).log2()).collect();
        // The next term of the error's series is some h of the first: a part of 2⁻⁵ or so at the coarse end.
        let slope = (errors[0] - errors[errors.len() - 1]) / (errors.len() - 1) as f64;
        assert_at_most((slope - 4.0).abs(), 0.15, &format!("loss {loss}: order {slope}, {errors:?}"));
        assert!(errors[errors.len() - 1] > -43.0, "above rounding: {errors:?}");
    }
}

/// Wherever it starts, it ends about axis 3, one way or the other: `M × Ω → 0` and `K → ℓ²/2I₃`.
#[test]
fn all_starts_end_about_axis_3() {
    let mut random = Random::new(54);
    let mut ends = [0, 0];
    for n in 0..100 {
        let (body, mut start) = random_start(&mut random);
        // Every third one close to axis 1, as a rod is spun.
        if n % 3 == 0 {
            let axis = body.body_from_principal() * DVec3::new(1.0, 0.0, 1e-3);
            start = State::new(&body, DMat3::IDENTITY, body.angular_velocity(axis));
        }
        let i = body.principal_moments();
        // The slowest of the wobbles dies by e^(−loss ℓ t d); forty e-folds and as many for the way from axis 1 and past axis 2.
        let (loss, ell) = (0.2, start.body_momentum.length());
        let slowest = (i.y.recip() - i.z.recip()).min(i.x.recip() - i.y.recip());
        let time = 80.0 / (loss * ell * slowest);
        let mut integration = losing(&body, start, 0.1 / largest_rate(&body, &start), loss);
        let end = integration.state_at(time).expect("short steps");
        let along = (body.body_from_principal().transpose() * end.body_momentum / ell).z;
        assert_at_most((along.abs() - 1.0).abs(), 32.0 * EPS, "M along axis 3");
        assert_at_most((end.energy(&body) * 2.0 * i.z / (ell * ell) - 1.0).abs(), 64.0 * EPS, "K = ℓ²/2I₃");
        ends[usize::from(along < 0.0)] += 1;
    }
    assert!(ends[0] > 20 && ends[1] > 20, "both ends are reached: {ends:?}");
}

/// A small wobble about axis 3 dies away as `e^(−loss ℓ t d)`, d the mean of `1/I₁ − 1/I₃` and `1/I₂ − 1/I₃`; the one about axis 1 grows likewise. Over
/// a whole number of wobbles, of which the shape is left out; the next order of a wobble of 1e-4 is 1e-8, of the loss 1e-3 its square.
#[test]
fn a_small_wobble_dies_away_and_one_about_axis_1_grows() {
    let body = Body::from_moments(DVec3::new(1.0, 2.0, 2.5)).expect("a body");
    let i = body.principal_moments().recip();
    let loss = 1e-3;
    for (axis, mean) in [(2, 0.5 * (i.x + i.y) - i.z), (0, 0.5 * (i.y + i.z) - i.x)] {
        let momentum = DVec3::AXES[axis] + 1e-4 * DVec3::Y;
        let start = State::new(&body, DMat3::IDENTITY, body.angular_velocity(momentum));
        let period = 2.0 * poinsot::flip_period_of(&body, &start).expect("a wobble has a period");
        let steps = 200_000;
        let mut integration = losing(&body, start, 20.0 * period / f64::from(steps), loss);
        integration.advance(i64::from(steps)).expect("short steps");
        let end = integration.state().body_momentum;
        let across = (end - DVec3::AXES[axis] * end[axis]).length() / 1e-4;
        let wanted = (-loss * mean * 20.0 * period).exp();
        assert_at_most((across / wanted - 1.0).abs(), 1e-5, &format!("about axis {}", axis + 1));
    }
}

/// Steady spins have nothing to lose, and without loss it is one more method.
#[test]
fn a_steady_spin_loses_nothing() {
    let body = Body::from_moments(DVec3::new(0.5, 0.85, 1.0)).expect("a body");
    for axis in DVec3::AXES {
        let start = State::new(&body, DMat3::IDENTITY, axis);
        let mut integration = losing(&body, start, 0.01, 0.3);
        integration.advance(1_000).expect("short steps");
        let state = integration.state();
        // A turn of 1000 steps, each good to ε.
        assert_at_most(attitude_error(state.world_from_body, so3::exp(10.0 * axis)), 1e3 * EPS, "turned");
        assert_at_most((state.body_momentum - start.body_momentum).length(), 16.0 * EPS, "M");
    }
    let at_rest = State::new(&body, DMat3::IDENTITY, DVec3::ZERO);
    let mut integration = losing(&body, at_rest, 0.01, 0.3);
    integration.advance(10).expect("nothing turns");
    assert_eq!(integration.state().body_momentum, DVec3::ZERO);
}

/// A step that cannot resolve the loss is refused, and the state stays: at a small loss the method's own error, which takes energy or gives it, is the larger one.
#[test]
fn too_long_a_step_is_refused() {
    let body = Body::from_moments(DVec3::new(0.5, 0.85, 1.0)).expect("a body");
    let start = State::new(&body, DMat3::IDENTITY, DVec3::new(0.4, 1.2, 0.4));
    for (step, count) in [(0.5, 1_000), (1.0, 1_000), (0.5, -1_000), (1.0, -1_000), (3.0, 1_000)] {
        let mut integration = losing(&body, start, step, 1e-6);
        let error = integration.advance(count).expect_err("the steps are too long");
        let said = format!("magnus4 could not solve its step of {step} s: take a smaller step");
        assert_eq!(error.to_string(), said);
        assert_eq!(integration.state(), start);
    }
}

/// In other units the motion is the same.
#[test]
fn loss_has_no_unit() {
    let at = |unit: f64| {
        let body = Body::from_moments(unit * DVec3::new(0.5, 0.85, 1.0)).expect("a body");
        let start = State::new(&body, DMat3::IDENTITY, DVec3::new(1.0, 0.2, 0.4));
        let mut integration = losing(&body, start, 0.01, 0.1);
        integration.advance(2_000).expect("short steps");
        integration.state().world_from_body
    };
    assert_eq!(at(1.0), at(2f64.powi(-60)));
    assert_at_most(attitude_error(at(1.0), at(1e9)), 2_000.0 * 8.0 * EPS, "units");
}
