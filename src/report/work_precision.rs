//! Time to solution against error, from the coarsest steps to the floor of round-off.

use serde::Serialize;
use web_time::Instant;

use super::Effort;
use super::cases::{Case, Errors, Reference};
use super::fit::median;
use super::timing::{Job, Timing, interleaved};
use crate::physics::methods::Order;
use crate::physics::{METHODS, Method, Motion};

/// Angle turned in the coarsest step (rad).
const COARSEST: f64 = 3.0;
/// Largest steps that methods without an error of method get (rad, at the fastest moment of the motion): the fewer steps the better,
/// up to a half turn.
const EXACT_COARSEST: [f64; 4] = [3.1, 2.4, 1.55, 1.19];
/// Smallest step of that scan (rad).
const EXACT_FINEST: f64 = 0.1;
/// Most points in that scan.
const EXACT_POINTS: usize = 8;
/// Points past the best one that still belong to the curve: they show the floor.
const POINTS_ON_THE_FLOOR: usize = 2;
/// Part of the usual time of its steps below which a run took no steps but leapt to its end: the exact step hands steps that
/// are too large for it to the closed form.
const LEAP: f64 = 0.6;
/// Above this error a curve has not begun to fall, and no floor is looked for.
const FLOOR_BELOW: f64 = 1e-9;

/// One run of one method: its cost and its errors.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// Name of the case.
    pub case: String,
    /// Name of the method.
    pub method: &'static str,
    /// Step (s); of the closed form the whole time.
    pub step: f64,
    /// Time reached (s).
    pub t: f64,
    /// Number of steps.
    pub steps: u64,
    /// Time taken by the integration alone.
    #[serde(flatten)]
    pub timing: Timing,
    /// The same a step (ns).
    pub ns_per_step: f64,
    /// What is prepared once before the first step (s): the solver and, where the method has any, its constants.
    pub prepare_seconds: f64,
    /// The errors at the end.
    #[serde(flatten)]
    pub errors: Errors,
    /// What the attitude was compared with.
    pub reference: Reference,
}

/// A run whose error is known and whose time is not yet.
struct Point {
    method: &'static Method,
    steps: u64,
    errors: Errors,
}

/// Measures every method on a case.
#[must_use]
pub fn measure(case: &Case, effort: &Effort) -> Vec<Row> {
    let points: Vec<Point> = METHODS.iter().flat_map(|method| points(case, method, effort)).collect();
    let mut jobs = Vec::new();
    for point in &points {
        let step = case.time / point.steps as f64;
        if point.method.is_direct {
            jobs.push(Job::repeat(|| case.motion.state(std::hint::black_box(case.time))));
            jobs.push(Job::repeat(|| Motion::new(std::hint::black_box(&case.body), &case.start)));
        } else {
            jobs.push(Job::stepping(case.warm(point.method, step), point.steps));
            jobs.push(Job::repeat(move || case.warm(point.method, step)));
        }
    }
    let timings = interleaved(jobs, effort.rounds, effort.budget);
    let mut rows: Vec<Row> = points
        .iter()
        .zip(timings.chunks_exact(2))
        .map(|(point, timings)| {
            let (timing, preparation) = (timings[0], timings[1]);
            let a_step = timing.seconds / point.steps as f64;
            // The preparation of a stepping method was timed with a first step, which is not part of it.
            let first_step = if point.method.is_direct { 0.0 } else { a_step };
            Row {
                case: case.name.clone(),
                method: point.method.name,
                step: case.time / point.steps as f64,
                t: case.time,
                steps: point.steps,
                timing,
                ns_per_step: a_step * 1e9,
                prepare_seconds: (preparation.seconds - first_step).max(0.0),
                errors: point.errors,
                reference: case.truth(case.time).1,
            }
        })
        .collect();
    for method in METHODS.iter().filter(|method| method.order == Order::Exact) {
        let own = rows.iter().filter(|row| row.method == method.name).map(|row| row.ns_per_step);
        let usual = median(&own.collect::<Vec<f64>>());
        rows.retain(|row| row.method != method.name || row.ns_per_step >= LEAP * usual);
    }
    rows
}

/// The step counts worth a point, with the error at each.
fn points(case: &Case, method: &'static Method, effort: &Effort) -> Vec<Point> {
    let point = |steps: u64| {
        let errors = case.errors(case.time, &case.run(method, case.time, steps).ok()?);
        errors.attitude_error.is_finite().then_some(Point { method, steps, errors })
    };
    if method.is_direct {
        return point(1).into_iter().collect();
    }
    let angle = case.rate * case.time;
    let mut points = Vec::new();
    if method.order == Order::Exact {
        let angle = case.largest_rate() * case.time;
        let counts: Vec<u64> = case.exact_divisions(angle / EXACT_COARSEST[0], angle / EXACT_FINEST).collect();
        let stride = counts.len().div_ceil(EXACT_POINTS).max(1);
        // The very fewest do not divide the time exactly: that costs the last digit, and none where time matters most.
        let fewest = EXACT_COARSEST.map(|coarsest| (angle / coarsest).ceil().max(1.0) as u64);
        let mut tried: Vec<u64> = counts.iter().copied().step_by(stride).chain(fewest).collect();
        tried.sort_unstable();
        tried.dedup();
        points.extend(tried.into_iter().filter_map(point));
        return points;
    }
    let Some(mut steps) = case.exact_divisions(angle / COARSEST, angle / COARSEST * 4.0 + 4.0).next() else {
        return points;
    };
    let mut best = f64::INFINITY;
    let mut since_best = 0;
    while since_best <= POINTS_ON_THE_FLOOR {
        let start = Instant::now();
        if let Some(point) = point(steps) {
            let error = point.errors.attitude_error;
            since_best = if error < 0.5 * best || best > FLOOR_BELOW { 0 } else { since_best + 1 };
            best = best.min(error);
            points.push(point);
        }
        if start.elapsed().as_secs_f64() * effort.refinement as f64 > effort.longest_run {
            break;
        }
        steps *= effort.refinement;
    }
    points
}
