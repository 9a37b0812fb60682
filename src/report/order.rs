//! The order of each method as measured: the slope of error against step, between the coarse steps and the floor.

use serde::Serialize;

use super::cases::Case;
use super::fit::power;
use super::write::format::short;
use crate::physics::methods::Order;
use crate::physics::{METHODS, Method};

/// Time (s) that is followed: some seven radians on the case it is used on, so that at small steps the leading term rules.
const TIME: f64 = 4.0;
/// Fewest steps.
const FEWEST_STEPS: u64 = 4;
/// Doublings of the number of steps from there.
const DOUBLINGS: u32 = 16;
/// Above this error (rad) the leading term does not rule yet.
const COARSE: f64 = 0.02;
/// Round-off in an error: this many ε for every radian turned and for the root of every step.
const FLOOR: f64 = 40.0 * f64::EPSILON;
/// Fewest points a line is laid through.
const FEWEST_POINTS: usize = 3;
/// Most points the line is laid through: the finest ones, where the leading term rules.
const POINTS: usize = 5;
/// How far the slope may be from the claim.
const TOLERANCE: f64 = 0.15;
/// Largest error, in ε for every radian turned, of a method that claims to have none.
const EXACT_WITHIN: f64 = 100.0;

/// A method's order, claimed and measured.
#[derive(Clone, Debug, Serialize)]
pub struct OrderRow {
    /// Name of the method.
    pub method: &'static str,
    /// Claimed order; `None`: exact.
    pub claimed: Option<u32>,
    /// Slope of the logarithm of the error against that of the step; `None` where there is no error of method to see.
    pub measured: Option<f64>,
    /// Case on which it was measured.
    pub case: String,
    /// Time followed (s).
    pub t: f64,
    /// Number of points the line was laid through.
    pub points: usize,
    /// Largest attitude error over the steps measured (rad).
    pub largest_error: f64,
    /// Whether measurement and claim agree.
    pub agrees: bool,
    /// The outcome in words.
    pub words: String,
    /// Every step tried.
    pub samples: Vec<OrderSample>,
}

/// A step and the error it leaves.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct OrderSample {
    /// Step (s).
    pub step: f64,
    /// Number of steps.
    pub steps: u64,
    /// Attitude error (rad).
    pub attitude_error: f64,
}

/// Order of every method, on a case of its own length: no clock is needed, so the steps can be as many as the floor asks.
#[must_use]
pub fn measure(case: &Case) -> Vec<OrderRow> {
    METHODS
        .iter()
        .map(|method| {
            let samples = samples(case, method);
            let mut row = OrderRow {
                method: method.name,
                claimed: None,
                measured: None,
                case: case.name.clone(),
                t: TIME,
                points: 0,
                largest_error: samples.iter().map(|sample| sample.attitude_error).fold(0.0, f64::max),
                agrees: false,
                words: String::new(),
                samples,
            };
            match method.order {
                Order::Exact => exact(&mut row, case.rate, method.is_direct),
                Order::Finite(order) => finite(&mut row, case.rate, order),
            }
            row
        })
        .collect()
}

fn samples(case: &Case, method: &'static Method) -> Vec<OrderSample> {
    let sample = |time: f64, steps: u64| {
        let state = case.run(method, time, steps).ok()?;
        let attitude_error = case.errors(time, &state).attitude_error;
        attitude_error.is_finite().then_some(OrderSample { step: time / steps as f64, steps, attitude_error })
    };
    if method.is_direct {
        // Against the table: elsewhere it is itself the truth.
        return case.sample_times().filter_map(|time| sample(time, 1)).collect();
    }
    (0..=DOUBLINGS).filter_map(|doubling| sample(TIME, FEWEST_STEPS << doubling)).collect()
}

fn exact(row: &mut OrderRow, rate: f64, is_direct: bool) {
    let rounding = |sample: &OrderSample| EXACT_WITHIN * f64::EPSILON * (rate * TIME + (sample.steps as f64).sqrt());
    row.agrees = !row.samples.is_empty() && row.samples.iter().all(|sample| sample.attitude_error <= rounding(sample));
    let largest = short(row.largest_error);
    row.words = if row.agrees {
        let place = match row.samples.last() {
            Some(last) if is_direct => format!("any time of the table, up to {:e} s", last.step),
            _ => "any step".to_owned(),
        };
        format!("no error of method: at most {largest} rad at {place}")
    } else {
        format!("claims to be exact, and is wrong by {largest} rad, more than rounding explains")
    };
}

fn finite(row: &mut OrderRow, rate: f64, order: u32) {
    row.claimed = Some(order);
    let is_clean = |sample: &&OrderSample| {
        let error = sample.attitude_error;
        error < COARSE && error > FLOOR * (rate * TIME + (sample.steps as f64).sqrt())
    };
    let mut points: Vec<(f64, f64)> =
        row.samples.iter().filter(is_clean).map(|sample| (sample.step, sample.attitude_error)).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points.truncate(POINTS);
    row.points = points.len();
    row.measured = if points.len() >= FEWEST_POINTS { power(&points) } else { None };
    row.agrees = row.measured.is_some_and(|slope| (slope - f64::from(order)).abs() <= TOLERANCE);
    row.words = match row.measured {
        Some(slope) if row.agrees => {
            format!("order {order} as claimed: halving the step divides the error by {:.1}", slope.exp2())
        }
        Some(slope) => format!("claims order {order} and shows {slope:.2}: the claim does not hold"),
        None => {
            let smallest = row.samples.iter().map(|sample| sample.attitude_error).fold(f64::INFINITY, f64::min);
            format!(
                "claims order {order}, and its error does not fall with the step: {} rad at the best",
                short(smallest)
            )
        }
    };
}
