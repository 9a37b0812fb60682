//! Hard cases: every method on every one of them, its error beside a bound worked out beforehand.
//!
//! The bound rests on the condition `κ` of the motion: how far a rounding of the start, `ε|M|` along any axis, moves the
//! truth at the worst moment up to then, over ε. A method of order p that takes the angle `θ = |Ω|h` a step makes at most some θ^p of that kind of
//! error, and rounds once a step: `bound = 4κθ^p + κε(4 + √n)`. Past one radian
//! nothing is promised, and no attitude is wrong by more than half a turn.

use std::f64::consts::PI;

use glam::{DMat3, DVec3};
use serde::Serialize;

use super::cases::{Case, reference_cases};
use super::{Effort, ReportError};
use crate::physics::methods::{Keeps, Order};
use crate::physics::{Body, Integration, METHODS, Method, Motion, State, so3};

/// Angle a step (rad).
const ANGLE: f64 = 0.01;
/// Angle a step in the case of large steps (rad).
const LARGE_ANGLE: f64 = 3.0;
/// Steps in the case of large steps.
const LARGE_STEPS: i64 = 1000;
/// Roundings of an evaluation of the closed form, in ε.
const EVALUATION: f64 = 16.0;
/// Moments at which the condition is looked at.
const MOMENTS: u32 = 64;
/// Bound on the energy of a method that keeps it, for every step: 4ε.
const ENERGY: f64 = 4.0 * f64::EPSILON;

/// A method on a hard case.
#[derive(Clone, Debug, Serialize)]
pub struct HardRow {
    /// Name of the case.
    pub case: String,
    /// Name of the method.
    pub method: &'static str,
    /// What the error is of: the attitude (rad), or the energy (relative).
    pub quantity: &'static str,
    /// Time (s).
    pub t: f64,
    /// Number of steps.
    pub steps: u64,
    /// The error; `None` where the method said that it could not go on.
    pub error: Option<f64>,
    /// What the error must not exceed; `None` where the method claims nothing.
    pub bound: Option<f64>,
    /// Whether it holds: the error is a number and within the bound; where nothing is promised, to stop and say so will do.
    pub held: bool,
    /// What the method said, if it stopped.
    pub said: Option<String>,
    /// What the error was measured against.
    pub reference: &'static str,
}

impl HardRow {
    /// Whether the bound says anything.
    #[must_use]
    pub fn is_promised(&self) -> bool {
        self.bound.is_some_and(|bound| bound < 1.0)
    }
}

/// Every method on every hard case.
///
/// # Errors
/// See [`reference_cases`].
pub fn measure(effort: &Effort, mut done: impl FnMut(&str)) -> Result<Vec<HardRow>, ReportError> {
    let mut rows = Vec::new();
    let cases = reference_cases()?;
    for case in &cases {
        done(&case.name);
        let affordable = |time: &f64| case.rate * time / ANGLE <= effort.most_hard_steps;
        let time = case.sample_times().filter(affordable).fold(case.time.min(1.0), f64::max);
        rows.extend(METHODS.iter().map(|method| at_time(case, method, time, &case.name)));
    }
    let Some(case) = cases.first() else { return Ok(rows) };
    for case in made_up(case) {
        done(&case.name);
        // The closed form is not held against itself.
        let is_judge = |method: &Method| case.sample_times().next().is_none() && method.is_direct;
        let methods = METHODS.iter().filter(|method| !is_judge(method));
        rows.extend(methods.map(|method| at_time(&case, method, case.time, &case.name)));
    }
    done("far ahead");
    // No number of steps reaches that far.
    for method in METHODS.iter().filter(|method| method.is_direct) {
        rows.extend(case.sample_times().filter(|time| *time >= 1e9).map(|time| {
            let name = format!("{} at {time:.0e} s", case.name);
            at_time(case, method, time, &name)
        }));
    }
    done("there and back");
    let stepping = METHODS.iter().filter(|method| !method.is_direct);
    rows.extend(stepping.map(|method| there_and_back(case, method)));
    done("large steps");
    rows.extend(METHODS.iter().filter_map(|method| large_steps(case, method)));
    Ok(rows)
}

/// Cases that the table has not; where their truth is known without the closed form, with that.
fn made_up(generic: &Case) -> Vec<Case> {
    let mut cases = Vec::new();
    let mut add = |name: &str, moments: [f64; 3], omega: DVec3, time: f64, truth: Option<DMat3>| {
        if let Ok(body) = Body::from_moments(DVec3::from_array(moments)) {
            let start = State::new(&body, DMat3::IDENTITY, omega);
            let samples = truth.map(|truth| (time, truth)).into_iter().collect();
            cases.push(Case { time, samples, ..Case::new(name, &body, start) });
        }
    };
    let middle = DVec3::new(0.0, 0.5, 0.0);
    add("exactly on the middle axis", [1.0, 2.0, 3.0], middle, 30.0, Some(so3::exp(30.0 * middle)));
    add("at rest", [1.0, 2.0, 3.0], DVec3::ZERO, 30.0, Some(DMat3::IDENTITY));
    // A power of two scales without rounding: the attitudes of the table are met at other times.
    let moments = generic.body.principal_moments().to_array();
    let omega = generic.start.body_angular_velocity(&generic.body);
    let (time, truth) = (generic.time, Some(generic.truth(generic.time).0));
    for (name, scale) in [("momentum of 1e-151", f64::exp2(-500.0)), ("momentum of 1e150", f64::exp2(500.0))] {
        add(name, moments, omega * scale, time / scale, truth);
    }
    add("flat plate", [1.0, 2.0, 3.0], DVec3::new(0.7, 1.0, -0.3), 100.0, None);
    add("moments equal to 1e-12", [1.0, 1.0 + 1e-12, 2.0], DVec3::new(0.3, 0.4, 0.4), 100.0, None);
    cases
}

/// `κε`: how far a rounding of the start moves the attitude up to a time, at the worst moment (rad).
pub(super) fn rounding(case: &Case, time: f64) -> f64 {
    let times = (1..=MOMENTS).map(|i| time * (f64::from(i) / f64::from(MOMENTS)));
    let truth: Vec<(f64, DMat3)> = times.map(|time| (time, case.motion.attitude(time))).collect();
    let momentum = case.start.body_momentum;
    let size = f64::EPSILON * so3::norm(momentum);
    [DVec3::X, DVec3::Y, DVec3::Z]
        .into_iter()
        .flat_map(|axis| [axis, -axis])
        .map(|axis| {
            let moved = case.body.angular_velocity(momentum + size * axis);
            let start = State::new(&case.body, case.start.world_from_body, moved);
            let motion = Motion::new(&case.body, &start);
            truth.iter().map(|(time, truth)| so3::angle_between(motion.attitude(*time), *truth)).fold(0.0, f64::max)
        })
        .fold(f64::EPSILON, f64::max)
}

fn bound(rounding: f64, method: &Method, angle: f64, steps: u64) -> f64 {
    let rounded = rounding * (4.0 + (steps as f64).sqrt()) + EVALUATION * f64::EPSILON;
    let bound = match method.order {
        Order::Exact => rounded,
        Order::Finite(order) => rounded + 4.0 * rounding / f64::EPSILON * angle.powi(order.cast_signed()),
    };
    if bound < 1.0 { bound } else { PI }
}

fn at_time(case: &Case, method: &'static Method, time: f64, name: &str) -> HardRow {
    // A power of two: the step is then exact. At rest one step is as good as many.
    let wanted = if method.is_direct { 1.0 } else { (case.rate * time / ANGLE).max(1.0) };
    let steps = wanted.log2().ceil().exp2() as u64;
    let angle = case.rate * time / steps as f64;
    let outcome = case.run(method, time, steps);
    let bound = bound(rounding(case, time), method, angle, steps);
    let error = outcome.as_ref().ok().map(|state| case.errors(time, state).attitude_error);
    HardRow {
        case: name.to_owned(),
        method: method.name,
        quantity: "attitude",
        t: time,
        steps,
        held: error.map_or(bound >= 1.0, |error| error <= bound),
        error,
        bound: Some(bound),
        said: outcome.err().map(|error| error.to_string()),
        reference: case.truth(time).1.name(),
    }
}

/// Ahead and back by the same steps: how far from the start it ends.
fn there_and_back(case: &Case, method: &'static Method) -> HardRow {
    let steps = (case.rate * case.time / ANGLE).log2().ceil().exp2() as u64;
    let step = case.time / steps as f64;
    let count = i64::try_from(steps).unwrap_or(i64::MAX);
    // A step past the start, so that the end is not the start itself.
    let mut integration = Integration::new(method, &case.body, case.start, step);
    let outcome = integration.advance(count + 1).and_then(|()| integration.advance(-count));
    let error = outcome
        .is_ok()
        .then(|| so3::angle_between(integration.state().world_from_body, case.motion.state(step).world_from_body));
    let bound = bound(rounding(case, case.time), method, case.rate * step, 2 * steps);
    HardRow {
        case: "there and back".to_owned(),
        method: method.name,
        quantity: "attitude",
        t: case.time,
        steps: 2 * steps,
        held: error.is_some_and(|error| error <= bound),
        error,
        bound: Some(bound),
        said: outcome.err().map(|error| error.to_string()),
        reference: "start",
    }
}

/// Steps of three radians: a method that claims the energy either keeps it or says that it cannot. The others claim
/// nothing here and have no row.
fn large_steps(case: &Case, method: &'static Method) -> Option<HardRow> {
    let bound = match method.keeps_energy {
        Keeps::Exactly => ENERGY * LARGE_STEPS as f64,
        // A nearby energy is kept: it may be off by the step, and by no more for all time.
        Keeps::Nearby => 1.0,
        Keeps::No => return None,
    };
    let step = LARGE_ANGLE / case.rate;
    let mut integration = Integration::new(method, &case.body, case.start, step);
    let outcome = integration.advance(LARGE_STEPS);
    let time = step * LARGE_STEPS as f64;
    let energy = case.start.energy(&case.body);
    let error = outcome.is_ok().then(|| (integration.state().energy(&case.body) - energy).abs() / energy);
    Some(HardRow {
        case: format!("steps of {LARGE_ANGLE} rad"),
        method: method.name,
        quantity: "energy",
        t: time,
        steps: LARGE_STEPS as u64,
        held: error.is_none_or(|error| error <= bound),
        error,
        bound: Some(bound),
        said: outcome.err().map(|error| error.to_string()),
        reference: "start",
    })
}
