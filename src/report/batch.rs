//! Many bodies at a time: what a step of one of them costs, and what a motion at any time.

use std::hint::black_box;

use glam::DVec3;
use serde::Serialize;

use super::Effort;
use super::random::Random;
use super::timing::{Job, Timing, interleaved};
use crate::physics::{Batch, Body, Integration, Motion, State, method, methods, so3};

/// Bodies that are stepped.
const BODIES: usize = 1000;
/// Steps in one run.
const STEPS: i64 = 100;
/// Angle a step of the slowest body (rad) over that of the fastest is some hundred; this is the mean.
const ANGLE: f64 = 0.05;
/// Steps after which the errors are looked at.
const STEPS_TO_ERROR: i64 = 10_000;
/// Seed of the bodies: the same ones each time.
const SEED: u64 = 0xba7c_0b0d_1e50;

/// What was measured of batches.
#[derive(Clone, Debug, Serialize)]
pub struct BatchCost {
    /// Number of bodies stepped.
    pub bodies: usize,
    /// Number of starts that were gone to at any time.
    pub starts: usize,
    /// A step of one body (s): with all that the processor has, with what every one has, and each body by itself.
    pub step: [Timing; 3],
    /// The momentum of one start at any time (s).
    pub momentum: Timing,
    /// The state of one start at any time (s).
    pub state: Timing,
    /// Largest attitude error over 10⁴ steps, in parts of the bound `8ε(1 + |Ω|t)`.
    pub part_of_bound: f64,
}

/// Times batches, and looks at their errors.
#[must_use]
pub fn measure(effort: &Effort) -> BatchCost {
    let mut random = Random::new(SEED);
    let bodies: Vec<(Body, State)> = (0..BODIES).map(|_| random.body_in_motion()).collect();
    let rates = bodies.iter().map(|(body, start)| so3::norm(start.body_angular_velocity(body)));
    let step = ANGLE / (rates.sum::<f64>() / BODIES as f64);
    let part_of_bound = part_of_bound(&bodies, step);

    let mut wide = Batch::of_bodies(&bodies);
    let mut baseline = Batch::of_bodies(&bodies).on_any_processor();
    let mut alone: Vec<Integration> = method(methods::DEFAULT_METHOD)
        .into_iter()
        .flat_map(|method| bodies.iter().map(|(body, start)| Integration::new(method, body, *start, step)))
        .collect();
    // The first step prepares.
    wide.advance(step, 1);
    baseline.advance(step, 1);
    for integration in &mut alone {
        // What it could not do the timed run says.
        let _ = integration.advance(1);
    }
    let jobs = vec![
        Job::repeat(|| wide.advance(step, black_box(STEPS))),
        Job::repeat(|| baseline.advance(step, black_box(STEPS))),
        Job::repeat(|| {
            for integration in &mut alone {
                let _ = black_box(integration.advance(black_box(STEPS)));
            }
        }),
    ];
    let steps = interleaved(jobs, 3 * effort.rounds, effort.budget);

    let (body, _) = random.body_in_motion();
    let starts: Vec<State> = (0..effort.starts)
        .map(|_| {
            let velocity = DVec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0));
            State::new(&body, glam::DMat3::IDENTITY, velocity)
        })
        .collect();
    let cloud = Batch::of_starts(&body, &starts);
    let (mut time, mut other_time) = (0.0, 0.0);
    let (mut momenta, mut states) = (Vec::new(), Vec::new());
    let jobs = vec![
        Job::repeat(|| {
            time += 1.0;
            cloud.momenta_into(black_box(time), &mut momenta);
        }),
        Job::repeat(|| {
            other_time += 1.0;
            cloud.states_into(black_box(other_time), &mut states);
        }),
    ];
    let evaluations = interleaved(jobs, effort.rounds, effort.budget);
    let a_step = 1.0 / (BODIES as f64 * STEPS as f64);
    let a_start = 1.0 / effort.starts as f64;
    BatchCost {
        bodies: BODIES,
        starts: effort.starts,
        step: [0, 1, 2].map(|i| steps[i].scaled(a_step)),
        momentum: evaluations[0].scaled(a_start),
        state: evaluations[1].scaled(a_start),
        part_of_bound,
    }
}

/// The largest attitude error over the bound, on the way and at the end.
fn part_of_bound(bodies: &[(Body, State)], step: f64) -> f64 {
    let mut batch = Batch::of_bodies(bodies);
    let mut worst: f64 = 0.0;
    for _ in 0..4 {
        batch.advance(step, STEPS_TO_ERROR / 4);
        let time = batch.time();
        for ((body, start), state) in bodies.iter().zip(batch.states()) {
            let truth = Motion::new(body, start).attitude(time);
            // |Ω| is `ℓ/I₁` at most.
            let largest = so3::norm(start.body_momentum) / body.principal_moments().x;
            let bound = 8.0 * f64::EPSILON * (1.0 + largest * time);
            worst = worst.max(so3::angle_between(state.world_from_body, truth) / bound);
        }
    }
    worst
}
