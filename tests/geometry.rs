//! Poinsot's geometry: curves on their surfaces, times against the motion itself, classes.
#![allow(clippy::expect_used, reason = "a test fails by it")]

mod common;

use common::{EPS, Random, assert_at_most, random_motion, reference_case, state_of};
use dzhanibekov::physics::{Body, Motion, MotionClass, State, poinsot, so3};
use glam::{DMat3, DVec3};

fn tilted(moments: DVec3, tilt: DMat3) -> Body {
    let tensor = tilt * DMat3::from_diagonal(moments) * tilt.transpose();
    Body::from_tensor(0.5 * (tensor + tensor.transpose())).expect("a body")
}

/// The polhode lies on sphere and ellipsoid, is closed, evenly spaced, on the start's side, and the motion runs along it.
#[test]
fn polhode() {
    let mut random = Random::new(51);
    for _ in 0..500 {
        let moments = DVec3::new(random.between(0.2, 1.0), random.between(1.0, 2.0), random.between(2.0, 3.0));
        let body = tilted(moments, random.rotation());
        let momentum = random.vector();
        let (ell, energy) = (momentum.length(), body.energy(momentum));
        let points = poinsot::polhode(&body, momentum, 101);
        assert_eq!(points.len(), 101);
        assert_eq!(points[0], points[100]);
        let gaps: Vec<f64> = points.windows(2).map(|pair| (pair[1] - pair[0]).length()).collect();
        let (least, most) = gaps.iter().fold((f64::MAX, 0.0_f64), |(a, b), gap| (a.min(*gap), b.max(*gap)));
        assert_at_most(most / least, 1.1, "spacing");
        for point in &points {
            assert_at_most((point.length() / ell - 1.0).abs(), 32.0 * EPS, "sphere");
            assert_at_most((body.energy(*point) / energy - 1.0).abs(), 32.0 * EPS, "ellipsoid");
        }
        let motion = Motion::new(&body, &state_of(&body, DMat3::IDENTITY, momentum));
        for n in 0..20 {
            let m = motion.momentum(0.37 * f64::from(n));
            let nearest = points.iter().map(|point| (*point - m).length()).fold(f64::MAX, f64::min);
            // Half a gap, and what the chord is short of the arc.
            assert_at_most(nearest, 0.51 * most, "the motion is on the curve");
        }
        for omega in poinsot::angular_velocity_polhode(&body, momentum, 33) {
            assert_at_most((0.5 * omega.dot(body.momentum(omega)) / energy - 1.0).abs(), 64.0 * EPS, "ω-space");
            assert_at_most((body.momentum(omega).length() / ell - 1.0).abs(), 64.0 * EPS, "ω-space");
        }
    }
}

/// Great circles of the energy `ℓ²/2I₂`, in the plane `M₁ = ±κM₃`.
#[test]
fn separatrix() {
    let moments = DVec3::new(6.0, 8.0, 12.0);
    let body = tilted(moments, so3::exp(DVec3::new(0.3, 0.2, -0.4)));
    let circles = poinsot::separatrix(&body, 2.0, 65).expect("there is one");
    for (circle, sign) in circles.iter().zip([1.0, -1.0]) {
        assert_eq!(circle.len(), 65);
        assert_eq!(circle[0], circle[64]);
        for point in circle {
            assert_at_most((point.length() - 2.0).abs(), 16.0 * EPS, "sphere");
            assert_at_most((body.energy(*point) - 4.0 / 16.0).abs(), 16.0 * EPS, "energy");
            let m = body.body_from_principal().transpose() * *point;
            // κ² = 6·4/(12·2) = 1.
            assert_at_most((m.x - sign * m.z).abs(), 64.0 * EPS, "plane");
        }
    }
    let oblate = Body::from_moments(DVec3::new(1.0, 1.0, 2.0)).expect("a body");
    assert!(poinsot::separatrix(&oblate, 1.0, 10).is_none());
}

/// The time to the next flip is when `M₂` vanishes, and a period later it does again with the other sign of its rate.
#[test]
fn flips_come_when_they_are_said_to() {
    let mut random = Random::new(52);
    let mut flips = 0;
    for _ in 0..5_000 {
        let (moments, momentum) = random_motion(&mut random);
        let body = Body::from_moments(moments).expect("a body");
        let start = state_of(&body, DMat3::IDENTITY, momentum);
        let Some(period) = poinsot::flip_period(&body, start.body_momentum) else { continue };
        let next = poinsot::next_flip(&body, start.body_momentum).expect("it flips again");
        assert_at_most(next, period * (1.0 + 16.0 * EPS), "the next flip is within a period");
        let motion = Motion::new(&body, &start);
        let middle = |time: f64| motion.momentum(time).y;
        // As far from 0 as it may be by the rounding of the time, at a quarter period; and beside the separatrix by that of
        // the momentum, which Δ₂ makes `condition` times larger in k′².
        let (m, i) = (start.body_momentum, moments);
        let (about_3, about_1) = (m.z * m.z * (i.z - i.y) / i.z, m.x * m.x * (i.y - i.x) / i.x);
        let condition = (about_3 + about_1) / (about_3 - about_1).abs();
        if condition > 1e10 {
            continue;
        }
        let (first, second) = (middle(next), middle(next + period));
        let swing = middle(next + 0.5 * period).abs();
        let bound = 1e-13 * swing * (1.0 + (next + period) / period) * (40.0 + condition);
        let what = format!("{moments} {momentum}");
        assert_at_most(first.abs(), bound, &what);
        assert_at_most(second.abs(), bound, &what);
        assert!(middle(next + 0.25 * period) * middle(next + 1.25 * period) <= 0.0, "{what}");
        flips += 1;
    }
    assert!(flips > 2_000, "{flips} only");
}

/// The T-handle of the reference file flips every 3.3177515 s.
#[test]
fn the_t_handle_flips() {
    let case = reference_case("T-handle");
    let period = poinsot::flip_period(&case.body, case.start.body_momentum).expect("it flips");
    assert_at_most((period - 3.317_751_5).abs(), 1e-7, "period");
}

/// The herpolhode lies in the invariable plane, inside its annulus, and comes close to both rims.
#[test]
fn herpolhode() {
    let body = tilted(DVec3::new(0.5, 0.85, 1.0), so3::exp(DVec3::new(0.5, 0.1, 0.2)));
    let start = State::new(&body, so3::exp(DVec3::new(1.0, 0.5, 0.3)), DVec3::new(0.6, 1.0, 0.3));
    let (inner, outer) = poinsot::herpolhode_radii(&body, start.body_momentum);
    let distance = poinsot::invariable_plane_distance(&body, start.body_momentum);
    let normal = start.world_momentum.normalize();
    let curve = poinsot::herpolhode(&body, &start, 200.0, 4_000);
    let (mut least, mut most) = (f64::MAX, 0.0_f64);
    for omega in curve {
        assert_at_most((omega.dot(normal) - distance).abs(), 64.0 * EPS, "plane");
        let radius = omega.cross(normal).length();
        (least, most) = (least.min(radius), most.max(radius));
    }
    assert!(inner < outer);
    // The samples are within 0.03 s of the rims, where the radius is stationary.
    assert_at_most((least - inner).abs(), 1e-3, "inner rim");
    assert_at_most((most - outer).abs(), 1e-3, "outer rim");
    assert!(least >= inner * (1.0 - 1e-12) && most <= outer * (1.0 + 1e-12));
}

#[test]
fn classes() {
    let class = |moments: [f64; 3], momentum: [f64; 3]| {
        let body = Body::from_moments(DVec3::from_array(moments)).expect("a body");
        poinsot::classify(&body, DVec3::from_array(momentum))
    };
    let body = [6.0, 8.0, 12.0];
    assert_eq!(class(body, [0.0; 3]), MotionClass::AtRest);
    assert_eq!(class(body, [1.0, 0.0, 0.0]), MotionClass::PureSpin { axis: 1 });
    assert_eq!(class(body, [0.0, -1.0, 0.0]), MotionClass::PureSpin { axis: 2 });
    assert_eq!(class(body, [0.0, 0.0, 1.0]), MotionClass::PureSpin { axis: 3 });
    assert_eq!(class(body, [12.0, 12.0, 12.0]), MotionClass::Separatrix);
    assert_eq!(class(body, [-12.0, 5.0, 12.0]), MotionClass::Separatrix);
    assert_eq!(class(body, [12.0, 12.0, 12.001]), MotionClass::AboutAxis3);
    assert_eq!(class(body, [12.001, 12.0, 12.0]), MotionClass::AboutAxis1);
    assert_eq!(class(body, [0.0, 1.0, 1e-12]), MotionClass::AboutAxis3);
    assert_eq!(class(body, [1e-200, 1.0, 0.0]), MotionClass::AboutAxis1);
    assert_eq!(class([1.0, 1.0, 2.0], [0.3, 0.2, 1.0]), MotionClass::Symmetric { axis: 3 });
    assert_eq!(class([1.0, 2.0, 2.0], [0.3, 0.2, 1.0]), MotionClass::Symmetric { axis: 1 });
    assert_eq!(class([1.0, 2.0, 2.0], [1.0, 0.0, 0.0]), MotionClass::PureSpin { axis: 1 });
    assert_eq!(class([2.0, 2.0, 2.0], [0.3, 0.2, 1.0]), MotionClass::Sphere);
    // Sorted: axis 1 is the smallest moment, whichever way the body's own axes go.
    assert_eq!(class([12.0, 8.0, 6.0], [0.0, 0.0, 1.0]), MotionClass::PureSpin { axis: 1 });
    assert!(!MotionClass::PureSpin { axis: 2 }.is_stable() && MotionClass::AboutAxis1.is_stable());
    assert!(MotionClass::PureSpin { axis: 2 }.label().contains("unstable"));
}

/// A small tilt from the middle axis grows as `e^{σt}`.
#[test]
fn growth_of_the_tilt() {
    let body = Body::from_moments(DVec3::new(1.0, 2.0, 3.0)).expect("a body");
    let start = state_of(&body, DMat3::IDENTITY, DVec3::new(1e-9, 1.0, -1e-9));
    let motion = Motion::new(&body, &start);
    let tilt = |time: f64| motion.momentum(time).cross(DVec3::Y).length();
    let sigma = poinsot::growth_rate(&body, 1.0);
    let (t, dt) = (20.0 / sigma * 0.5, 1.0);
    assert_at_most(((tilt(t + dt) / tilt(t)).ln() / sigma - 1.0).abs(), 1e-6, "growth");
}
