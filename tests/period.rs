//! One period of the momentum, against the exact motion and against areas on the sphere.
#![allow(clippy::expect_used, reason = "a test fails by it")]

mod common;

use std::f64::consts::TAU;

use common::{EPS, Random, assert_at_most};
use dzhanibekov::physics::{Body, Motion, State, motion, period, poinsot, so3};
use glam::{DMat3, DVec3};

/// A turned body with three moments and a start anywhere, or beside axis 1, 2, 3.
fn random_start(random: &mut Random, n: usize) -> (Body, State) {
    let moments = DVec3::new(random.between(0.3, 0.9), 1.0, random.between(1.05, 1.3));
    let turn = random.rotation();
    let tensor = turn * DMat3::from_diagonal(moments) * turn.transpose();
    let body = Body::from_tensor(0.5 * (tensor + tensor.transpose())).expect("a body");
    let direction = match n % 4 {
        0 => random.vector(),
        axis => DVec3::AXES[axis - 1] + 0.1 * random.vector(),
    };
    let momentum = body.body_from_principal() * direction * random.between(0.5, 2.0);
    (body, State::new(&body, random.rotation(), body.angular_velocity(momentum)))
}

/// An angle's distance from a multiple of a full turn.
fn from_whole_turns(angle: f64) -> f64 {
    (angle - TAU * (angle / TAU).round()).abs()
}

/// After T the momentum is what it was, and `R(T)R(0)ᵀ` a turn about L, by Δψ but for whole turns: round axis 1 and round axis 3.
#[test]
fn after_one_period_the_body_has_turned_about_the_momentum() {
    let mut random = Random::new(61);
    let mut round = [0, 0];
    for n in 0..400 {
        let (body, start) = random_start(&mut random, n);
        let period = period::period_of(&body, &start).expect("no such start is steady");
        let after = Motion::new(&body, &start).state(period.time);
        // Some ten roundings at either end, and the phases of the whole way: 64ε of the angle turned.
        let bound = 64.0 * EPS * (1.0 + period.turn.abs());
        let ell = so3::norm(start.body_momentum);
        assert_at_most(so3::norm(after.body_momentum - start.body_momentum) / ell, bound, "M comes back");
        let turn = after.world_from_body * start.world_from_body.transpose();
        let axis = start.world_momentum / ell;
        assert_at_most((turn * axis - axis).length(), bound, "a turn about L");
        assert_at_most(so3::frobenius_norm(turn - so3::exp(period.turn * axis)), 2.0 * bound, "by Δψ");
        assert_at_most(
            from_whole_turns(period::turn_about_momentum(&start, &after) - period.turn),
            2.0 * bound,
            "as read",
        );
        // And Montgomery's formula, with its two terms.
        let energy_term = 2.0 * start.energy(&body) * period.time / ell;
        assert_at_most((energy_term - period.solid_angle - period.turn).abs(), bound, "2KT/ℓ − Λ");
        let axis_number = (body.body_from_principal().transpose() * period.axis).abs().max_position();
        round[usize::from(axis_number == 2)] += 1;
        // Round axis 3 it runs counter-clockwise, round axis 1 clockwise.
        assert_eq!(period.solid_angle > 0.0, axis_number == 2);
    }
    assert!(round[0] > 50 && round[1] > 50, "{round:?}");
}

/// Λ is the area that M's path encloses: `∮(1 − m·a)dφ` about its axis a, by the sum of spherical triangles (Van Oosterom and Strackee) between the axis and 4000 pieces
/// of the path. Chords for arcs leave out `(2π/4000)²/12` or so of each piece's area: 1e-5.
#[test]
fn the_solid_angle_is_that_of_the_path() {
    let mut random = Random::new(62);
    for n in 0..60 {
        let (body, start) = random_start(&mut random, n);
        let period = period::period_of(&body, &start).expect("no such start is steady");
        let exact = Motion::new(&body, &start);
        let ell = so3::norm(start.body_momentum);
        let pieces = 4_000;
        let at = |piece: i32| exact.momentum(period.time * f64::from(piece) / f64::from(pieces)) / ell;
        let area: f64 = (0..pieces)
            .map(|piece| {
                let (a, b, c) = (period.axis, at(piece), at(piece + 1));
                2.0 * a.dot(b.cross(c)).atan2(1.0 + a.dot(b) + b.dot(c) + c.dot(a))
            })
            .sum();
        assert_at_most((area - period.solid_angle).abs(), 1e-5, &format!("Λ = {area}"));
    }
}

/// Known by hand: a symmetric body with a small tilt turns, in one round of M in the body, `Λ = 2π(1 − cos θ)`, θ the tilt of M.
#[test]
fn a_symmetric_body_is_known_by_hand() {
    let body = Body::from_moments(DVec3::new(1.0, 1.0, 1.6)).expect("a body");
    for tilt in [0.01, 0.5, 1.2] {
        let start =
            State::new(&body, DMat3::IDENTITY, body.angular_velocity(DVec3::new(f64::sin(tilt), 0.0, f64::cos(tilt))));
        let period = period::period_of(&body, &start).expect("M goes round");
        // φ̇ = ℓ cos θ (1/I₁ − 1/I₃).
        let time = TAU / (tilt.cos() * (1.0 - 1.0 / 1.6));
        assert_at_most((period.time / time - 1.0).abs(), 8.0 * EPS, "T");
        assert_at_most((period.solid_angle - TAU * (1.0 - tilt.cos())).abs(), 64.0 * EPS * (1.0 + period.turn), "Λ");
        // Precession round L at ℓ/I₁ all that time, and back by the round itself: Δψ = ℓT/I₁ − 2π.
        assert_at_most((period.turn - (time - TAU)).abs(), 64.0 * EPS * (1.0 + period.turn), "Δψ");
    }
}

/// M that does not move has no period, and on the separatrix it does not come back.
#[test]
fn what_never_comes_back_has_none() {
    let body = Body::from_moments(DVec3::new(1.0, 2.0, 3.0)).expect("a body");
    for axis in [DVec3::X, DVec3::Y, DVec3::Z, DVec3::ZERO] {
        assert_eq!(period::period_of(&body, &State::new(&body, DMat3::IDENTITY, axis)), None);
    }
    // s(4, 8, 9), Ω₁ : Ω₃ = 3 : 4 lies on it exactly.
    let body = Body::from_moments(DVec3::new(4.0, 8.0, 9.0)).expect("a body");
    let start = State::new(&body, DMat3::IDENTITY, DVec3::new(3.0, 1.0, 4.0));
    assert_eq!(period::period_of(&body, &start), None);
}

/// The branches of the separatrix obey Euler's equation, lie on the sphere and on the separatrix: `2K = ℓ²/I₂`.
#[test]
fn the_branches_of_the_separatrix_are_motions() {
    let mut random = Random::new(63);
    for n in 0..50 {
        let (body, _) = random_start(&mut random, n);
        let ell = random.between(0.5, 2.0);
        for time in [-3.0, -0.4, 0.0, 1.1, 5.0] {
            let h = 1e-4;
            let [before, now, after] =
                [-h, 0.0, h].map(|by| period::separatrix_at(&body, ell, time + by).expect("three moments"));
            for branch in 0..4 {
                let m = now[branch];
                assert_at_most((m.length() / ell - 1.0).abs(), 8.0 * EPS, "sphere");
                let energy = 2.0 * body.energy(m) * body.principal_moments().y / (ell * ell);
                assert_at_most((energy - 1.0).abs(), 64.0 * EPS, "energy");
                // Central differences: h²/6 of a third derivative of some (ℓ/I₁)³ ≤ 300, and ε/h.
                let rate = (after[branch] - before[branch]) / (2.0 * h);
                assert_at_most((rate - motion::momentum_rate(&body, m)).length(), 2e-6, "Euler");
            }
        }
    }
    assert!(period::separatrix_at(&Body::from_moments(DVec3::ONE).expect("a body"), 1.0, 0.0).is_none());
    assert!(poinsot::growth_rate(&Body::from_moments(DVec3::ONE).expect("a body"), 1.0) == 0.0);
}
