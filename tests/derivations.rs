//! The lecture notes' derivations, each as a number that must come out.
#![allow(clippy::expect_used, reason = "a test fails by it")]

mod common;

use common::{EPS, Random, assert_at_most, state_of};
use dzhanibekov::physics::{Body, Motion, State, motion, poinsot, so3};
use glam::{DMat3, DVec3};

fn body() -> Body {
    Body::from_moments(DVec3::new(0.5, 0.85, 1.0)).expect("a body")
}

fn start(body: &Body) -> State {
    State::new(body, so3::exp(DVec3::new(0.2, -0.5, 1.0)), DVec3::new(0.4, 1.2, 0.4))
}

/// Angular velocity in the body of a path of attitudes, `Ω = log(RᵀR′)/h` between two close times, good to h².
fn mean_velocity(before: DMat3, after: DMat3, h: f64) -> DVec3 {
    so3::log(before.transpose() * after) / h
}

/// `∫ ½ Ω·IΩ dt` over 2 s of the path, by mean velocities over intervals of h = 1/200: error h²/12 or so, the same for neighbours.
fn action(body: &Body, path: impl Fn(f64) -> DMat3) -> f64 {
    let h = 0.005;
    let intervals = (0..400).map(|n| {
        let t = h * f64::from(n);
        let velocity = mean_velocity(path(t), path(t + h), h);
        0.5 * h * velocity.dot(body.momentum(velocity))
    });
    intervals.sum()
}

/// The motion makes the action stationary: pushed by `R exp(ε[V×])`, V = 0 at the ends, it changes by O(ε²). On a path that is no
/// motion it changes by O(ε). The first-order part is `(S(ε) − S(−ε))/2ε`.
#[test]
fn least_action() {
    let body = body();
    let exact = Motion::new(&body, &start(&body));
    let push = |t: f64| (0.5 * std::f64::consts::PI * t).sin() * DVec3::new(0.3, 1.0 - 0.4 * t, -0.7);
    let slope = |path: &dyn Fn(f64) -> DMat3| {
        let pushed = |e: f64| action(&body, |t| path(t) * so3::exp(e * push(t)));
        (pushed(1e-3) - pushed(-1e-3)) / 2e-3
    };
    let on_motion = slope(&|t| exact.attitude(t));
    // Even rotation about a fixed axis between the same ends.
    let turn = so3::log(exact.attitude(0.0).transpose() * exact.attitude(2.0));
    let elsewhere = slope(&|t| exact.attitude(0.0) * so3::exp(0.5 * t * turn));
    // ε² of third order 1e-6, and h²/12 of the discrete action.
    assert_at_most(on_motion.abs(), 1e-5, "slope of the action at the motion");
    assert!(elsewhere.abs() > 1e-2, "slope {elsewhere} at a path that is no motion");
    let curve =
        |e: f64| action(&body, |t| exact.attitude(t) * so3::exp(e * push(t))) - action(&body, |t| exact.attitude(t));
    let ratio = curve(2e-2) / curve(1e-2);
    assert_at_most((ratio - 4.0).abs(), 0.1, "the action changes by O(ε²)");
}

/// `δΩ = V̇ + Ω × V` for `δR = R[V×]`, by central differences in both directions: errors of 1e-8 and less.
#[test]
fn variation_of_the_angular_velocity() {
    let body = body();
    let exact = Motion::new(&body, &start(&body));
    let push = |t: f64| DVec3::new((2.0 * t).sin(), t * t, 1.0 - t);
    let push_rate = |t: f64| DVec3::new(2.0 * (2.0 * t).cos(), 2.0 * t, -1.0);
    let h = 1e-4;
    for t in [0.3, 1.1, 2.7] {
        let velocity = |e: f64| {
            let path = |t: f64| exact.attitude(t) * so3::exp(e * push(t));
            mean_velocity(path(t - h), path(t + h), 2.0 * h)
        };
        let variation = (velocity(1e-4) - velocity(-1e-4)) / 2e-4;
        let omega = exact.state(t).body_angular_velocity(&body);
        assert_at_most((variation - (push_rate(t) + omega.cross(push(t)))).length(), 1e-6, "δΩ");
    }
}

/// Euler's equation in the body, `Ṁ = M × Ω`; in the world `I_w ω̇ + ω × I_w ω = 0` and `d/dt(I_w ω) = 0`;
/// and `Ṙ = R[Ω×] = [ω×]R`. Central differences of h = 1e-4: h² and ε/h are both about 1e-8.
#[test]
fn equations_of_motion() {
    let body = body();
    let exact = Motion::new(&body, &start(&body));
    let h = 1e-4;
    for t in [0.0, 0.7, 5.3, 100.1] {
        let (before, now, after) = (exact.state(t - h), exact.state(t), exact.state(t + h));
        let rate = (after.body_momentum - before.body_momentum) / (2.0 * h);
        assert_at_most((rate - motion::momentum_rate(&body, now.body_momentum)).length(), 1e-7, "Euler in the body");

        let world = |state: &State| state.world_angular_velocity(&body);
        let rate = (world(&after) - world(&before)) / (2.0 * h);
        let torque = now.world_inertia(&body) * rate + world(&now).cross(now.world_inertia(&body) * world(&now));
        assert_at_most(torque.length(), 1e-7, "Euler in the world");
        let momentum = |state: &State| state.world_inertia(&body) * world(state);
        assert_at_most((momentum(&after) - momentum(&before)).length(), 32.0 * EPS, "I_w ω");

        let rate = (after.world_from_body - before.world_from_body) * (0.5 / h);
        let in_body = now.world_from_body * so3::hat(now.body_angular_velocity(&body));
        let in_world = so3::hat(world(&now)) * now.world_from_body;
        assert_at_most(so3::frobenius_norm(rate - in_body), 1e-7, "R[Ω×]");
        assert_at_most(so3::frobenius_norm(in_body - in_world), 32.0 * EPS, "[ω×]R");
    }
}

/// A body of point masses: its energy is `½Ω·IΩ` and its momentum `IΩ`; about the centre of mass the motion of the centre adds
/// `½m|ċ|²` and nothing else.
#[test]
fn point_masses() {
    let mut random = Random::new(41);
    for _ in 0..200 {
        let mut points: Vec<(f64, DVec3)> = (0..12).map(|_| (random.between(0.1, 1.0), random.vector())).collect();
        let mass: f64 = points.iter().map(|(m, _)| m).sum();
        let centre: DVec3 = points.iter().map(|(m, r)| *m * *r).sum::<DVec3>() / mass;
        for (_, r) in &mut points {
            *r -= centre;
        }
        let mut inertia = DMat3::ZERO;
        for (m, r) in &points {
            inertia -= so3::hat(*r) * so3::hat(*r) * *m;
        }
        let body = Body::from_tensor(0.5 * (inertia + inertia.transpose())).expect("a body");
        let state = State::new(&body, random.rotation(), random.vector());
        let (world, drift) = (state.world_angular_velocity(&body), random.vector());
        let (mut energy, mut momentum) = (0.0, DVec3::ZERO);
        for (m, r) in &points {
            let at = state.world_from_body * *r;
            let velocity = drift + world.cross(at);
            energy += 0.5 * m * velocity.length_squared();
            momentum += *m * at.cross(velocity);
        }
        let bound = 200.0 * EPS * (1.0 + energy);
        assert_at_most((energy - (state.energy(&body) + 0.5 * mass * drift.length_squared())).abs(), bound, "energy");
        assert_at_most((momentum - state.world_momentum).length(), bound, "momentum");
    }
}

/// A unit spin about principal axis i has the energy `I_i/2`.
#[test]
fn energy_of_a_unit_spin() {
    let body = body();
    for (axis, moment) in [(DVec3::X, 0.5), (DVec3::Y, 0.85), (DVec3::Z, 1.0)] {
        assert_eq!(State::new(&body, DMat3::IDENTITY, axis).energy(&body), 0.5 * moment);
    }
}

/// M stays on its sphere and its energy ellipsoid, at any time.
#[test]
fn momentum_stays_on_sphere_and_ellipsoid() {
    let body = body();
    let start = start(&body);
    let exact = Motion::new(&body, &start);
    let (ell, energy) = (start.body_momentum.length(), start.energy(&body));
    for n in 0..2_000 {
        let m = exact.momentum(0.1 * f64::from(n));
        assert_at_most((m.length() / ell - 1.0).abs(), 8.0 * EPS, "sphere");
        let on_ellipsoid = (m / poinsot::energy_semi_axes(&body, energy)).length_squared();
        assert_at_most((on_ellipsoid - 1.0).abs(), 16.0 * EPS, "ellipsoid");
    }
}

/// Poinsot: the inertia ellipsoid, moved by R, touches the invariable plane at ω, and the body's point there is at rest: the ellipsoid
/// rolls without slipping. Its normal at Ω is along M; the plane's distance is constant.
#[test]
fn the_ellipsoid_rolls_without_slipping() {
    let body = body();
    let start = start(&body);
    let exact = Motion::new(&body, &start);
    let distance = poinsot::invariable_plane_distance(&body, start.body_momentum);
    let normal = start.world_momentum.normalize();
    let h = 1e-4;
    for n in 0..100 {
        let t = 0.37 * f64::from(n);
        let state = exact.state(t);
        let (omega, world) = (state.body_angular_velocity(&body), state.world_angular_velocity(&body));
        assert_at_most((world.dot(normal) - distance).abs(), 32.0 * EPS, "the plane");
        let axes = poinsot::inertia_semi_axes(&body, start.energy(&body));
        assert_at_most(((omega / axes).length_squared() - 1.0).abs(), 32.0 * EPS, "on the ellipsoid");
        let gradient = state.world_from_body * (omega / (axes * axes));
        assert_at_most(gradient.normalize().cross(normal).length(), 32.0 * EPS, "tangent");
        // The point of the body that is at ω now, a moment before and after.
        let velocity = (exact.attitude(t + h) - exact.attitude(t - h)) * omega / (2.0 * h);
        assert_at_most(velocity.length(), 1e-7, "velocity of the contact point");
    }
}

/// A tilt ten times smaller delays the flip by `2 ln 10/σ`, nearly: the period is `2 ln(4/k′)/λ` and k′ goes with the tilt.
#[test]
fn a_smaller_tilt_delays_the_flip() {
    let body = Body::from_moments(DVec3::new(1.0, 2.0, 3.0)).expect("a body");
    let period = |tilt: f64| {
        let start = state_of(&body, DMat3::IDENTITY, DVec3::new(0.0, 1.0, tilt));
        poinsot::flip_period(&body, start.body_momentum).expect("it flips")
    };
    let sigma = poinsot::growth_rate(&body, 1.0);
    for tilt in [1e-3, 1e-5, 1e-9] {
        let delay = period(0.1 * tilt) - period(tilt);
        assert_at_most((delay * sigma / (2.0 * 10f64.ln()) - 1.0).abs(), 10.0 * tilt, "delay");
    }
}

/// What the exact step rests on: with f the half-turn quaternion of a step of one length, `1/f₀²` is linear in the square of the middle
/// component of the momentum halfway through the step (`f₀² = A/(1 − k² sn²w sn²u)`), at any step up to a half turn.
#[test]
fn scalar_part_of_an_exact_step() {
    let body = body();
    let exact = Motion::new(&body, &start(&body));
    for step in [0.1, 0.7, 1.2, 1.9] {
        let points = [0.0, 0.9, 1.7, 2.2, 3.1, 4.0].map(|t| {
            let turn = so3::quaternion(exact.attitude(t).transpose() * exact.attitude(t + step));
            (exact.momentum(t + 0.5 * step).y.powi(2), turn.w.powi(-2))
        });
        let (least, most) = points
            .iter()
            .fold((points[0], points[0]), |(a, b), &p| (if p.0 < a.0 { p } else { a }, if p.0 > b.0 { p } else { b }));
        let slope = (most.1 - least.1) / (most.0 - least.0);
        for (square, inverse) in points {
            let line = least.1 + slope * (square - least.0);
            // f₀² and the matrices have errors of a few ε; 1/f₀⁴ of it is seen, and the slope is one of two such.
            assert_at_most((inverse - line).abs(), 64.0 * EPS * most.1.powi(2), &format!("steps of {step} s"));
        }
    }
}
