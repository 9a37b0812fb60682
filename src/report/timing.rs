//! How long a thing takes, on a machine that does other things as well.
//!
//! Short runs are repeated within one reading of the clock, and the things compared are timed in turns, so that a busy
//! moment of the machine falls on all of them and not on one. What is told is the median with the whole spread.

use std::hint::black_box;

use serde::Serialize;
use web_time::Instant;

use super::fit::{median, quantile};
use crate::physics::Integration;

/// Seconds of one run below which several are put in one reading (s): some thousand times the clock's own grain.
const READING: f64 = 100e-6;
/// Most runs in one reading.
const LARGEST_BATCH: u32 = 512;
/// Readings that a long run gets at the least.
const FEWEST: usize = 3;

/// Seconds of one run over the repeats: the median, the ends and the quartiles.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Timing {
    /// Median (s).
    pub seconds: f64,
    /// Least (s).
    pub seconds_min: f64,
    /// Most (s): on a busy machine that is the machine's and not the method's.
    pub seconds_max: f64,
    /// A quarter of the readings lie below (s).
    pub seconds_lower: f64,
    /// A quarter of the readings lie above (s).
    pub seconds_upper: f64,
    /// Number of readings.
    pub repeats: usize,
}

impl Timing {
    fn of(samples: &[f64]) -> Self {
        let fold = |f: fn(f64, f64) -> f64, start| samples.iter().copied().fold(start, f);
        Self {
            seconds: median(samples),
            seconds_min: fold(f64::min, f64::INFINITY),
            seconds_max: fold(f64::max, 0.0),
            seconds_lower: quantile(samples, 0.25),
            seconds_upper: quantile(samples, 0.75),
            repeats: samples.len(),
        }
    }

    /// The same for a part of the run, or for several runs.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            seconds: self.seconds * factor,
            seconds_min: self.seconds_min * factor,
            seconds_max: self.seconds_max * factor,
            seconds_lower: self.seconds_lower * factor,
            seconds_upper: self.seconds_upper * factor,
            ..self
        }
    }
}

/// A thing to be timed: given a number of runs it does them and says how long they took together (s).
pub struct Job<'a> {
    run: Box<dyn FnMut(u32) -> f64 + 'a>,
    batch: u32,
    samples: Vec<f64>,
}

impl std::fmt::Debug for Job<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Job of {} runs a reading", self.batch)
    }
}

impl<'a> Job<'a> {
    /// A job that times itself.
    pub fn new(run: impl FnMut(u32) -> f64 + 'a) -> Self {
        Self { run: Box::new(run), batch: 1, samples: Vec::new() }
    }

    /// A job that does `once` over and over.
    pub fn repeat<T>(mut once: impl FnMut() -> T + 'a) -> Self {
        Self::new(move |runs| {
            let start = Instant::now();
            for _ in 0..runs {
                black_box(once());
            }
            start.elapsed().as_secs_f64()
        })
    }

    /// The integration alone: copies of it are made before the clock starts.
    #[must_use]
    pub fn stepping(integration: Integration, steps: u64) -> Self {
        let mut copies: Vec<Integration> = Vec::new();
        let steps = i64::try_from(steps).unwrap_or(i64::MAX);
        Self::new(move |runs| {
            copies.clear();
            copies.extend((0..runs).map(|_| integration.clone()));
            let start = Instant::now();
            for copy in &mut copies {
                let _ = black_box(copy.advance(black_box(steps)));
            }
            start.elapsed().as_secs_f64()
        })
    }

    /// Warms the caches and finds how many runs make a reading.
    fn warm(&mut self) {
        (self.run)(1);
        let once = (self.run)(1).max(1e-9);
        let batch = (READING / once).ceil().clamp(1.0, f64::from(LARGEST_BATCH)) as u32;
        // The first guess holds the clock's own cost; a second one of many runs does not.
        let once = ((self.run)(batch) / f64::from(batch)).max(1e-9);
        self.batch = (READING / once).ceil().clamp(1.0, f64::from(LARGEST_BATCH)) as u32;
    }
}

/// Times the jobs in turns: `rounds` readings each, fewer (three at least) once a job has used up `budget` seconds.
#[must_use]
pub fn interleaved(mut jobs: Vec<Job<'_>>, rounds: usize, budget: f64) -> Vec<Timing> {
    for job in &mut jobs {
        job.warm();
    }
    for _ in 0..rounds {
        for job in &mut jobs {
            let spent = job.samples.iter().sum::<f64>() * f64::from(job.batch);
            if job.samples.len() < FEWEST || spent < budget {
                let seconds = (job.run)(job.batch) / f64::from(job.batch);
                job.samples.push(seconds);
            }
        }
    }
    jobs.iter().map(|job| Timing::of(&job.samples)).collect()
}
