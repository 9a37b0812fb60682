//! Random starts of every kind against the oracle: the closed form and the exact step to their bounds, flips and classes.
//!
//! A short run is part of `cargo test`; the long one:
//!
//! ```text
//! DZHANIBEKOV_STARTS=100000 cargo test --release --no-default-features --test random_starts -- --nocapture
//! ```
//!
//! prints the worst error of each kind; it takes some five minutes of one core.
#![allow(clippy::expect_used, reason = "a test fails by it")]

mod common;
#[path = "common/kinds.rs"]
mod kinds;
#[path = "common/oracle/mod.rs"]
mod oracle;

use common::{EPS, Random, attitude_error};
use dzhanibekov::physics::bounds::{self, Bound, Limit};
use dzhanibekov::physics::{Integration, Motion, MotionClass, State, method, poinsot, so3};
use glam::{DMat3, DVec3};
use kinds::{KINDS, Start};
use oracle::motion::Turning;
use oracle::real::nearest;
use oracle::{Oracle, Spin};

/// How many starts a short run has.
const SHORT_RUN: usize = 1_700;

/// What is measured of a start, and the bound of each. Printed in the unit of its bound: rad, ε or ε(1 + |Ω|t), |Ω| the largest on the orbit.
const MEASURES: [(&str, Bound); 13] = [
    ("closed form", bounds::CLOSED_FORM_ATTITUDE),
    ("its M/ℓ", bounds::CLOSED_FORM_MOMENTUM),
    ("its energy", bounds::CLOSED_FORM_ENERGY),
    ("exact step", bounds::EXACT_STEP_ATTITUDE),
    ("its M/ℓ", bounds::EXACT_STEP_MOMENTUM),
    ("its energy", bounds::EXACT_STEP_ENERGY),
    ("RM − L", bounds::WORLD_MOMENTUM),
    ("rotation", bounds::ROTATION),
    ("|M|/ℓ − 1", MOMENTUM_SIZE),
    ("flip period", bounds::FLIP_PERIOD),
    ("next flip", bounds::NEXT_FLIP),
    ("moments", bounds::PRINCIPAL_MOMENTS),
    ("axes", bounds::PRINCIPAL_AXES),
];

/// Where in the table these are.
const STEP: usize = 3;
const INVARIANTS: usize = 6;
const FLIPS: usize = 9;

/// A consequence of the others: it is not drifted from, as M is drawn from its polhode anew.
const MOMENTUM_SIZE: Bound = Bound {
    of: "closed-form, exact-step",
    quantity: "|M|/ℓ − 1",
    domain: "any time and number of steps",
    limit: Limit::Epsilons(8.0),
    why: "functions good to 4ε on their curve times amplitudes good to 2ε",
};

/// The measures, and what is wrong beyond numbers.
struct Found {
    measures: [f64; 13],
    /// The exact step's length (s) and number.
    steps: (f64, i64),
    /// The crate's and the oracle's times of flips (s).
    flips: [[Option<f64>; 2]; 2],
    complaint: Option<String>,
}

#[test]
fn random_starts() {
    let count = std::env::var("DZHANIBEKOV_STARTS").map_or(SHORT_RUN, |text| text.parse().expect("a number of starts"));
    let workers = std::thread::available_parallelism().map_or(1, usize::from);
    let mut found: Vec<(usize, u64, Found)> = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..workers)
            .map(|worker| {
                scope.spawn(move || {
                    let mine = (worker..count).step_by(workers);
                    mine.map(|n| (n % KINDS.len(), n as u64, examine(n % KINDS.len(), n as u64))).collect::<Vec<_>>()
                })
            })
            .collect();
        workers.into_iter().flat_map(|worker| worker.join().expect("a worker that ends")).collect()
    });
    found.sort_by_key(|(kind, n, _)| (*kind, *n));

    let mut failures = 0;
    for (number, kind) in KINDS.iter().enumerate() {
        let of_kind: Vec<_> = found.iter().filter(|(k, _, _)| *k == number).collect();
        println!("{} ({} starts)", kind.name, of_kind.len());
        let mut shown = 0;
        for (measure, (name, bound)) in MEASURES.iter().enumerate() {
            let (Limit::Fixed(bound) | Limit::Epsilons(bound) | Limit::Growing(bound)) = bound.limit;
            let above = of_kind.iter().filter(|(_, _, f)| f.measures[measure].is_nan() || f.measures[measure] > bound);
            let above = above.count();
            let key = |f: &Found| if f.measures[measure].is_nan() { f64::INFINITY } else { f.measures[measure] };
            let Some((_, n, worst)) = of_kind.iter().max_by(|a, b| key(&a.2).total_cmp(&key(&b.2))) else { continue };
            println!(
                "    {name:12} {:10.2e}{}",
                key(worst),
                if above > 0 { format!("  {above} ABOVE {bound:e}") } else { String::new() }
            );
            failures += above;
            if above > 0 && shown < 4 {
                if (STEP..INVARIANTS).contains(&measure) {
                    println!("        {:?} s, times", worst.steps);
                }
                if let Some(times) = measure.checked_sub(FLIPS).and_then(|n| worst.flips.get(n)) {
                    println!("        {times:?} s, and right");
                }
                println!("        start {n}: {:?}", start(number, *n));
                shown += 1;
            }
        }
        let mut complaints = of_kind.iter().filter_map(|(_, n, f)| Some((n, f.complaint.as_ref()?))).peekable();
        if complaints.peek().is_some() {
            let complaints: Vec<_> = complaints.collect();
            failures += complaints.len();
            println!("    {} COMPLAINTS, the first two:", complaints.len());
            for (n, complaint) in complaints.iter().take(2) {
                println!("        {complaint}: start {n}: {:?}", start(number, **n));
            }
        }
    }
    assert_eq!(failures, 0, "of {count} starts");
}

/// The oracle itself, half as long again: nowhere does it lose more than it has to spare.
#[test]
fn oracle_has_digits_to_spare() {
    for (number, kind) in KINDS.iter().enumerate() {
        for n in 0..4 {
            let start = start(number, n);
            let spin = Spin::Body(start.angular_velocity);
            let here = Oracle::new(&start.inertia, &spin).at(start.time);
            let longer = Oracle::with_bits(&start.inertia, &spin, 576).at(start.time);
            let distance = here.distance(&longer);
            assert!(distance < 1e-40, "{}: {distance:e} at {start:?}", kind.name);
        }
    }
}

fn start(kind: usize, n: u64) -> Start {
    (KINDS[kind].make)(&mut Random::new(0x5eed ^ (n << 20)))
}

fn examine(kind: usize, n: u64) -> Found {
    let mut found = Found { measures: [0.0; 13], steps: (0.0, 0), flips: [[None; 2]; 2], complaint: None };
    let start = start(kind, n);
    let body = match start.inertia.body() {
        Ok(body) => body,
        Err(error) => {
            found.complaint = Some(error);
            return found;
        }
    };
    let angular_velocity = DVec3::from_array(start.angular_velocity);
    let (spin, state) = if start.is_along_axes {
        let spin = Spin::AlongAxes(start.angular_velocity, body.body_from_principal());
        (spin, State::in_principal_frame(&body, DMat3::IDENTITY, angular_velocity))
    } else {
        (Spin::Body(start.angular_velocity), State::new(&body, DMat3::IDENTITY, angular_velocity))
    };
    let oracle = Oracle::new(&start.inertia, &spin);
    let [ell, speed, fastest, energy] = [&oracle.ell, &oracle.speed, &oracle.fastest, &oracle.energy].map(nearest);
    let at_start = oracle.at(0.0).momentum_direction();
    // Attitude, momentum and energy against the right ones, from this place in the table.
    let compare = |found: &mut Found, first: usize, state: &State, time: f64| {
        let right = oracle.at(time);
        let momentum = state.body_momentum / ell;
        let errors = [
            attitude_error(state.world_from_body, right.world_from_body()),
            so3::norm(momentum - right.momentum_direction()),
            (state.energy(&body) / energy - 1.0).abs(),
        ];
        for (n, error) in errors.into_iter().enumerate() {
            found.measures[first + n] = in_units(first + n, error, fastest * time);
        }
        let kept = [
            so3::norm(state.world_from_body * momentum - at_start),
            so3::orthogonality_error(state.world_from_body),
            (so3::norm(momentum) - 1.0).abs(),
        ];
        for (n, error) in kept.into_iter().enumerate() {
            let place = INVARIANTS + n;
            found.measures[place] = found.measures[place].max(in_units(place, error, 0.0));
        }
    };
    compare(&mut found, 0, &Motion::new(&body, &state).state(start.time), start.time);

    // A step of few bits, so that so many of them are a time without rounding.
    let mut random = Random::new(n);
    let turn = 10f64.powf(random.between(-3.0, 0.3));
    let step = f64::from_bits((turn / speed).to_bits() & !0xffff_ffff).copysign(start.time);
    let count = 1 + 10f64.powf(random.between(0.0, 3.0)) as i64;
    let time = step * count as f64;
    found.steps = (step, count);
    if step.is_normal() && time.is_finite() {
        let exact_step = method("exact-step").expect("a method");
        let mut integration = Integration::new(exact_step, &body, state, step.abs());
        match integration.advance(if step < 0.0 { -count } else { count }) {
            Ok(()) => compare(&mut found, STEP, &integration.state(), time),
            Err(error) => found.complaint = Some(format!("the exact step: {error}")),
        }
    }

    let class = poinsot::class_of(&body, &state);
    let agrees = match oracle.turning {
        Turning::Steady => {
            matches!(
                class,
                MotionClass::AtRest
                    | MotionClass::Sphere
                    | MotionClass::Symmetric { .. }
                    | MotionClass::PureSpin { .. }
            )
        }
        Turning::Separatrix => class == MotionClass::Separatrix,
        Turning::About(1) => matches!(class, MotionClass::AboutAxis1 | MotionClass::Symmetric { axis: 1 }),
        Turning::About(_) => matches!(class, MotionClass::AboutAxis3 | MotionClass::Symmetric { axis: 3 }),
    };
    if !agrees {
        found.complaint = Some(format!("{class:?}, and it is {:?}", oracle.turning));
    }
    let times = [poinsot::flip_period_of(&body, &state), poinsot::next_flip_of(&body, &state)];
    let right = [oracle.flip_period(), oracle.next_flip()].map(|time| time.map(|time| nearest(&time)));
    for (n, (time, right)) in times.into_iter().zip(right).enumerate() {
        found.flips[n] = [time, right];
        match (time, right) {
            (None, None) => {}
            // Among the denormals a time is as good as the last of their digits.
            (Some(time), Some(right)) if (time - right).abs() <= f64::from_bits(1) => {}
            (Some(time), Some(right)) => {
                found.measures[FLIPS + n] = in_units(FLIPS + n, (time / right - 1.0).abs(), 0.0);
            }
            _ => found.complaint = Some(format!("{} {time:?}, and it is {right:?}", MEASURES[FLIPS + n].0)),
        }
    }

    let moments = oracle.principal.moments.each_ref().map(nearest);
    let of_moments = [0, 1, 2].map(|n| (body.principal_moments()[n] / moments[n] - 1.0).abs());
    found.measures[11] = in_units(11, of_moments.into_iter().fold(0.0, f64::max), 0.0);
    if !oracle.is_symmetric {
        let off = |n: usize| {
            let right = DVec3::from_array(oracle.principal.principal_from_body[n].each_ref().map(nearest));
            let axis = body.body_from_principal().col(n);
            (axis - right).abs().max_element().min((axis + right).abs().max_element())
        };
        found.measures[12] = in_units(12, off(0).max(off(1)).max(off(2)), 0.0);
    }
    found
}

/// An error in the unit of its bound.
fn in_units(measure: usize, error: f64, grows_with: f64) -> f64 {
    match MEASURES[measure].1.limit {
        Limit::Fixed(_) => error,
        Limit::Epsilons(_) => error / EPS,
        Limit::Growing(_) => error / (EPS * (1.0 + grows_with.abs())),
    }
}
