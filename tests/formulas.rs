//! One step of each method against its formula as it is printed, in the world frame with full tensors.
#![allow(clippy::expect_used, reason = "a test fails by it")]

mod common;

use common::{EPS, Random, assert_at_most, attitude_error};
use dzhanibekov::physics::{Body, Integration, State, method, so3};
use glam::{DMat3, DVec3};

const STEP: f64 = 0.07;

/// A tilted body in a tilted attitude, and where one step of a method takes it.
fn one_step(name: &str, random: &mut Random) -> (Body, State, State) {
    let tilt = random.rotation();
    let moments = DVec3::new(0.5, 0.85, 1.0) + 0.3 * random.vector().abs();
    let tensor = tilt * DMat3::from_diagonal(moments) * tilt.transpose();
    let body = Body::from_tensor(0.5 * (tensor + tensor.transpose())).expect("a body");
    let start = State::new(&body, random.rotation(), 1.5 * random.vector());
    let mut integration = Integration::new(method(name).expect("a method"), &body, start, STEP);
    integration.advance(1).expect("a small step");
    (body, start, integration.state())
}

/// `R ← exp(h[ω̄×]) R` with ω̄ from `(I_world, ω, L)`; the few hundred operations of both sides leave 64ε.
fn lie_group(name: &str, mean: impl Fn(DMat3, DVec3, DVec3) -> DVec3) {
    let mut random = Random::new(71);
    for _ in 0..200 {
        let (body, start, end) = one_step(name, &mut random);
        let inertia = start.world_inertia(&body);
        let velocity = inertia.inverse() * start.world_momentum;
        let expected = so3::exp(STEP * mean(inertia, velocity, start.world_momentum)) * start.world_from_body;
        assert_at_most(attitude_error(end.world_from_body, expected), 64.0 * EPS, name);
    }
}

#[test]
fn lie_euler_is_the_notes() {
    lie_group("lie-euler", |_, omega, _| omega);
}

/// `α = −I_world (ω × L)`, as it is printed at times, lacks the inverse; this is Buss' own.
#[test]
fn buss_is_the_notes_corrected() {
    lie_group("buss", |inertia, omega, momentum| {
        let alpha = -(inertia.inverse() * omega.cross(momentum));
        omega + STEP / 2.0 * alpha + STEP * STEP / 12.0 * alpha.cross(omega)
    });
}

#[test]
fn magnus_is_the_expansion() {
    lie_group("magnus4", |inertia, omega, momentum| {
        let inverse = inertia.inverse();
        // A vector J y that turns with the body changes at the rate ω × Jy + J(ẏ − ω × y).
        let rate = |y: DVec3, y_rate: DVec3| omega.cross(inverse * y) + inverse * (y_rate - omega.cross(y));
        let y = momentum.cross(omega);
        let first = inverse * y;
        // ω″ = ω × ω′ + J z, z = L × ω′ − ω × (L × ω).
        let z = momentum.cross(first) - omega.cross(y);
        let second = omega.cross(first) + inverse * z;
        let z_rate = momentum.cross(second) - first.cross(y) - omega.cross(momentum.cross(first));
        let third = omega.cross(second) + rate(z, z_rate);
        let h = STEP;
        omega
            + h / 2.0 * first
            + h * h / 6.0 * second
            + h * h / 12.0 * first.cross(omega)
            + h * h * h / 24.0 * third
            + h * h * h / 24.0 * second.cross(omega)
    });
}

/// `(h/2) Mₙ = f₀ I𝐟 + 𝐟×I𝐟` and `(h/2) Mₙ₊₁ = f₀ I𝐟 − 𝐟×I𝐟` with the half-turn quaternion of the step.
#[test]
fn moser_veselov_solves_its_equation() {
    let mut random = Random::new(72);
    for _ in 0..200 {
        let (body, start, end) = one_step("moser-veselov", &mut random);
        let f = so3::quaternion(start.world_from_body.transpose() * end.world_from_body);
        let image = body.inertia() * f.xyz();
        let (even, odd) = (f.w * image, f.xyz().cross(image));
        assert_at_most((STEP / 2.0 * start.body_momentum - (even + odd)).length(), 32.0 * EPS, "before");
        assert_at_most((STEP / 2.0 * end.body_momentum - (even - odd)).length(), 32.0 * EPS, "after");
    }
}

/// `R′ = R + hR[Ω×]`, `M′ = M + h M×Ω`; backward Euler with the new values on the right.
#[test]
fn euler_both_ways() {
    let mut random = Random::new(73);
    for _ in 0..200 {
        for name in ["forward-euler", "backward-euler"] {
            let (body, start, end) = one_step(name, &mut random);
            let at = if name == "forward-euler" { start } else { end };
            let omega = body.angular_velocity(at.body_momentum);
            let change = at.world_from_body * so3::hat(omega) * STEP;
            let rest = end.world_from_body - start.world_from_body - change;
            assert_at_most(so3::frobenius_norm(rest), 64.0 * EPS, name);
            let rest = end.body_momentum - start.body_momentum - STEP * at.body_momentum.cross(omega);
            assert_at_most(rest.length(), 64.0 * EPS, name);
        }
    }
}

/// Kutta's four stages on `(R, M)`.
#[test]
fn runge_kutta() {
    let mut random = Random::new(74);
    for _ in 0..200 {
        let (body, start, end) = one_step("rk4", &mut random);
        let rate = |r: DMat3, m: DVec3| {
            let omega = body.angular_velocity(m);
            (r * so3::hat(omega), m.cross(omega))
        };
        let (r, m) = (start.world_from_body, start.body_momentum);
        let (r1, m1) = rate(r, m);
        let (r2, m2) = rate(r + r1 * (STEP / 2.0), m + m1 * (STEP / 2.0));
        let (r3, m3) = rate(r + r2 * (STEP / 2.0), m + m2 * (STEP / 2.0));
        let (r4, m4) = rate(r + r3 * STEP, m + m3 * STEP);
        let expected = r + (r1 + r2 * 2.0 + r3 * 2.0 + r4) * (STEP / 6.0);
        assert_at_most(so3::frobenius_norm(end.world_from_body - expected), 64.0 * EPS, "R");
        let expected = m + (m1 + m2 * 2.0 + m3 * 2.0 + m4) * (STEP / 6.0);
        assert_at_most((end.body_momentum - expected).length(), 64.0 * EPS, "M");
    }
}
