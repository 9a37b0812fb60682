//! What a step costs, beside the least that a step with one sine and cosine can cost.

use std::hint::black_box;

use serde::Serialize;

use super::Effort;
use super::cases::Case;
use super::timing::{Job, Timing, interleaved};
use crate::physics::{METHODS, Motion};

/// Angle a step (rad): small enough for every method.
const ANGLE: f64 = 0.05;
/// Steps in one run.
const STEPS: u64 = 2000;
/// Links of the chain of sines and cosines in one run.
const LINKS: u32 = 2000;

/// Times of one step, in seconds.
#[derive(Clone, Debug, Serialize)]
pub struct Cost {
    /// The floor: a sine and cosine that waits for the one before, as the steps of a method do.
    pub floor: Timing,
    /// Every method.
    pub methods: Vec<CostRow>,
}

/// A method's cost.
#[derive(Clone, Debug, Serialize)]
pub struct CostRow {
    /// Name of the method.
    pub method: &'static str,
    /// One step; of the closed form one evaluation.
    #[serde(flatten)]
    pub timing: Timing,
    /// Its ratio to the floor.
    pub ratio: f64,
    /// Preparation before the first step (s), once for each motion.
    pub prepare: Timing,
}

/// Times a step of every method on a case.
#[must_use]
pub fn measure(case: &Case, effort: &Effort) -> Cost {
    let step = ANGLE / case.rate;
    let mut jobs = vec![Job::repeat(chain)];
    for method in METHODS {
        if method.is_direct {
            let mut time = 0.0;
            jobs.push(Job::repeat(move || {
                // Another time on each turn, so that nothing is foreseen.
                time += step;
                case.motion.state(black_box(time))
            }));
            jobs.push(Job::repeat(|| Motion::new(black_box(&case.body), &case.start)));
        } else {
            jobs.push(Job::stepping(case.warm(method, step), STEPS));
            jobs.push(Job::repeat(move || case.warm(method, step)));
        }
    }
    let timings = interleaved(jobs, 3 * effort.rounds, effort.budget);
    let floor = timings[0].scaled(1.0 / f64::from(LINKS));
    let methods = METHODS
        .iter()
        .zip(timings[1..].chunks_exact(2))
        .map(|(method, timings)| {
            let runs = if method.is_direct { 1.0 } else { STEPS as f64 };
            let timing = timings[0].scaled(1.0 / runs);
            CostRow { method: method.name, timing, ratio: timing.seconds / floor.seconds, prepare: timings[1] }
        })
        .collect();
    Cost { floor, methods }
}

/// A chain in which each sine and cosine waits for the one before.
fn chain() -> f64 {
    let mut angle: f64 = black_box(0.3);
    for _ in 0..LINKS {
        let (sine, cosine) = angle.sin_cos();
        angle = 0.5 * (sine + cosine);
    }
    angle
}
