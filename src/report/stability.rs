//! Large steps: the error up to three radians a step, and the largest step at which the body still flips rightly.

use serde::Serialize;

use super::Effort;
use super::cases::{Case, Errors};
use crate::physics::{Integration, METHODS, Method};

/// Flips that must come at their times.
const FLIPS: usize = 5;
/// How far a flip may be from its time, as a part of the time between two.
const TOLERANCE: f64 = 0.1;
/// Largest step (rad).
const LARGEST: f64 = 3.0;
/// Smallest step (rad).
const SMALLEST: f64 = 0.0011;
/// Samples a radian in which the true flips are looked for.
const SCAN: f64 = 8.0;

/// A method over the steps from small to large.
#[derive(Clone, Debug, Serialize)]
pub struct Stability {
    /// Name of the method.
    pub method: &'static str,
    /// Largest `|Ω|h` (rad) up to which every step tried flips rightly; `None` where none does.
    pub largest_right_step: Option<f64>,
    /// What happened at each step.
    pub samples: Vec<StabilitySample>,
}

/// A method at one step.
#[derive(Clone, Debug, Serialize)]
pub struct StabilitySample {
    /// Angle a step, `|Ω|h` (rad).
    pub angle: f64,
    /// The errors after one flip; `None` where the method said that it could not.
    pub errors: Option<Errors>,
    /// What it said.
    pub said: Option<String>,
    /// Whether the first five flips come at their times.
    pub flips_rightly: bool,
}

/// Scans the steps of every method on a motion that flips; nothing where it does not.
#[must_use]
pub fn measure(case: &Case, time: f64, effort: &Effort) -> Vec<Stability> {
    let truth = true_flips(case);
    let Some(&last) = truth.last().filter(|_| truth.len() == FLIPS) else { return Vec::new() };
    let period = (last - truth[0]) / (FLIPS - 1) as f64;
    let ratio = (LARGEST / SMALLEST).ln();
    let count = effort.stability_points;
    METHODS
        .iter()
        .map(|method| {
            let samples: Vec<StabilitySample> = (0..count)
                .map(|i| {
                    let wanted = SMALLEST * (ratio * i as f64 / (count - 1) as f64).exp();
                    let steps = (case.rate * time / wanted).floor().max(1.0) as u64;
                    let outcome = case.run(method, time, steps).map(|state| case.errors(time, &state));
                    let angle = case.rate * time / steps as f64;
                    let flips = flips(case, method, angle / case.rate, last + period);
                    let flips_rightly = flips.len() >= FLIPS
                        && flips.iter().zip(&truth).all(|(flip, truth)| (flip - truth).abs() <= TOLERANCE * period);
                    StabilitySample {
                        angle,
                        said: outcome.as_ref().err().map(ToString::to_string),
                        errors: outcome.ok(),
                        flips_rightly,
                    }
                })
                .collect();
            let right = samples.iter().take_while(|sample| sample.flips_rightly).last();
            Stability { method: method.name, largest_right_step: right.map(|sample| sample.angle), samples }
        })
        .collect()
}

/// Times at which the momentum along the middle axis changes its sign under a method.
fn flips(case: &Case, method: &'static Method, step: f64, end: f64) -> Vec<f64> {
    let mut integration = Integration::new(method, &case.body, case.start, step);
    let mut before = middle(case, case.start.body_momentum);
    let mut flips = Vec::new();
    while integration.time() < end && flips.len() < FLIPS {
        if integration.advance(1).is_err() {
            break;
        }
        let now = middle(case, integration.state().body_momentum);
        if !now.is_finite() {
            break;
        }
        if before * now < 0.0 {
            flips.push(integration.time() - step * now / (now - before));
        }
        before = now;
    }
    flips
}

fn true_flips(case: &Case) -> Vec<f64> {
    let step = 1.0 / (SCAN * case.rate);
    let at = |time: f64| middle(case, case.motion.momentum(time));
    // A flip takes as long as ln(1/ε) in units of the slowest rate; past that there is none.
    let most = 1_000_000;
    let mut flips = Vec::new();
    let mut before = at(0.0);
    for i in 1..most {
        let time = f64::from(i) * step;
        let now = at(time);
        if before * now < 0.0 {
            flips.push(time - step * now / (now - before));
            if flips.len() == FLIPS {
                break;
            }
        }
        before = now;
    }
    flips
}

/// Momentum along the axis of the middle moment.
fn middle(case: &Case, body_momentum: glam::DVec3) -> f64 {
    case.body.body_from_principal().y_axis.dot(body_momentum)
}
