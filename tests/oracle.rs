//! The oracle of the random starts against two files of reference values and against Euler's equations themselves.
#![allow(clippy::expect_used, reason = "a test fails by it")]

mod common;
#[path = "common/oracle/mod.rs"]
mod oracle;

use common::assert_at_most;
use dzhanibekov::physics::so3;
use dzhanibekov::physics::solids::{Shape, Solid};
use glam::{DMat3, DVec3};
use oracle::{Inertia, Oracle, Spin, taylor};

fn cases(text: &str) -> Vec<serde_json::Value> {
    let file: serde_json::Value = serde_json::from_str(text).expect("JSON");
    file["cases"].as_array().expect("cases").clone()
}

/// The values have 17 digits, so that each entry is the nearest binary64 number; the oracle's are rounded once as well.
#[test]
fn reference_values() {
    for text in [include_str!("free_rigid_body.json"), include_str!("harder_cases.json")] {
        for case in cases(text) {
            let numbers = |value: &serde_json::Value| -> Vec<f64> {
                value.as_array().expect("a list").iter().map(|x| x.as_f64().expect("a number")).collect()
            };
            let inertia = if case["moments"].is_null() {
                Inertia::Tensor(numbers(&case["inertia"]).try_into().expect("six"))
            } else {
                Inertia::Moments(numbers(&case["moments"]).try_into().expect("three"))
            };
            let spin = Spin::Body(numbers(&case["omega"]).try_into().expect("three"));
            let oracle = Oracle::new(&inertia, &spin);
            for sample in case["samples"].as_array().expect("samples") {
                let time = sample["t"].as_f64().expect("a time");
                let row = |n: usize| DVec3::from_slice(&numbers(&sample["R"][n]));
                let expected = DMat3::from_cols(row(0), row(1), row(2)).transpose();
                assert_eq!(oracle.at(time).world_from_body(), expected, "{} at {time:e}", case["name"]);
            }
        }
    }
}

/// Bodies given in every way, and starts of every family.
fn starts() -> Vec<(Inertia, [f64; 3])> {
    let solid = |shape, density, position, turn| Solid { shape, density, position, body_from_solid: so3::exp(turn) };
    vec![
        (Inertia::Moments([0.5, 0.85, 1.0]), [0.4, 1.1, 0.4]),
        (Inertia::Moments([1.0, 0.85, 0.3]), [0.4, 1.1, -0.4]),
        (Inertia::Moments([4.0, 8.0, 9.0]), [-0.75, 0.5, 1.0]),
        (Inertia::Moments([4.0, 8.0, 9.0]), [-0.75, -0.5, -1.000_000_1]),
        (Inertia::Moments([2.0, 2.0, 3.0]), [0.3, -0.5, -0.7]),
        (Inertia::Moments([2.0, 3.0, 3.0]), [-0.3, 0.5, 0.7]),
        (Inertia::Moments([2.0, 2.0, 2.0]), [-0.3, 0.5, 0.7]),
        (Inertia::Moments([1e-3, 1.0, 1.5]), [1.0, 0.5, 0.01]),
        (Inertia::Moments([1.0, 2.0, 9.0]), [-0.3, 0.1, 0.2]),
        (Inertia::Moments([1.0, 2.0, 3.0]), [1e-9, -1.0, -1e-12]),
        (Inertia::Tensor([0.9, 1.2, 1.5, -0.11, 0.07, 0.19]), [0.5, 0.2, -0.7]),
        (Inertia::Tensor([2.0, 2.0, 2.5, 1.0, 0.0, 0.0]), [0.5, 0.2, -0.7]),
        (Inertia::Box { edges: [0.2, 0.12, 0.04], mass: 3.0 }, [0.01, 1.0, 0.0]),
        (
            Inertia::Solids(vec![
                solid(Shape::Box { edges: DVec3::new(1.0, 0.3, 0.2) }, 2.0, DVec3::X, DVec3::new(0.1, 0.2, 0.3)),
                solid(Shape::Cylinder { radius: 0.2, length: 1.5 }, 1.0, DVec3::new(0.1, 0.4, 0.2), DVec3::Z),
                solid(Shape::Ellipsoid { semi_axes: DVec3::new(0.1, 0.2, 0.3) }, 5.0, DVec3::Y, DVec3::ZERO),
            ]),
            [0.7, -0.4, 0.2],
        ),
    ]
}

/// Euler's equations themselves, by Taylor series of 40 terms: they leave 1e-41 a step, and a step adds no more than its neighbours' growth.
#[test]
fn eulers_equations() {
    for (n, (inertia, angular_velocity)) in starts().iter().enumerate() {
        let oracle = Oracle::new(inertia, &Spin::Body(*angular_velocity));
        // The fastest rate is ℓ/I₁, thousands of steps a second for the needle.
        for time in if n == 7 { [0.01, -0.02] } else { [0.7, -2.0] } {
            let series = taylor::at(inertia, *angular_velocity, time, 192);
            assert_at_most(oracle.at(time).distance(&series), 1e-37, &format!("{inertia:?} {time}"));
        }
    }
}

/// Numbers half as long again give the same, at any time.
#[test]
fn digits_to_spare() {
    for (inertia, angular_velocity) in starts() {
        let oracle = Oracle::new(&inertia, &Spin::Body(angular_velocity));
        let longer = Oracle::with_bits(&inertia, &Spin::Body(angular_velocity), 576);
        for time in [1e3, -1e12] {
            assert_at_most(oracle.at(time).distance(&longer.at(time)), 1e-80, &format!("{inertia:?} {time}"));
        }
    }
}
