//! How far each method has strayed, kept along the way.

use std::collections::VecDeque;

use crate::physics::{Motion, State, so3};
use crate::scene::Scene;

use super::{Runner, Simulation};

/// Most samples kept; past that every second one goes, so that the beginning is never lost.
const MOST: usize = 1200;

/// How far one method's state is from what is exact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// Of the energy, relative.
    pub energy: f64,
    /// Of the world momentum, relative.
    pub momentum: f64,
    /// Of the attitude: the angle to the exact one (rad).
    pub attitude: f64,
}

impl Errors {
    /// Compares a state with the exact motion at the same time (s).
    #[must_use]
    pub fn of(scene: &Scene, exact: &Motion, time: f64, state: &State) -> Self {
        let start = &scene.start;
        let relative =
            |difference: f64, reference: f64| if reference == 0.0 { difference } else { difference / reference };
        let energy = start.energy(&scene.body);
        let drift = state.world_momentum - start.world_momentum;
        Self {
            energy: relative(state.energy(&scene.body) - energy, energy).abs(),
            momentum: relative(so3::norm(drift), so3::norm(start.world_momentum)),
            attitude: so3::angle_between(exact.attitude(time), state.world_from_body),
        }
    }
}

/// The errors of all methods at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Simulated time (s).
    pub time: f64,
    /// One entry a method: the scene's own, then those compared with.
    pub errors: Vec<Errors>,
}

/// Samples in order of time.
#[derive(Clone, Debug, Default)]
pub struct History {
    samples: VecDeque<Sample>,
    /// Shortest time between samples (s); it grows as the history is thinned.
    spacing: f64,
}

impl History {
    /// Forgets everything.
    pub fn clear(&mut self) {
        *self = Self::default();
    }

    /// Adds how the simulation stands. Times that have been seen already are not added again.
    pub fn record(&mut self, simulation: &Simulation, exact: &Motion) {
        let time = simulation.time();
        let is_after = self.samples.back().is_none_or(|last| time >= last.time + self.spacing && time > last.time);
        let is_before =
            self.samples.front().is_some_and(|first| time <= first.time - self.spacing && time < first.time);
        if !(is_after || is_before) {
            return;
        }
        let runners = std::iter::once(simulation.main()).chain(simulation.ghosts());
        let errors =
            runners.map(|runner: &Runner| Errors::of(simulation.scene(), exact, time, runner.state())).collect();
        let sample = Sample { time, errors };
        if is_after {
            self.samples.push_back(sample);
        } else {
            self.samples.push_front(sample);
        }
        if self.samples.len() > MOST {
            self.thin();
        }
    }

    fn thin(&mut self) {
        let mut index = 0;
        self.samples.retain(|_| {
            index += 1;
            index % 2 == 1
        });
        if let (Some(first), Some(last)) = (self.samples.front(), self.samples.back()) {
            self.spacing = (last.time - first.time) / self.samples.len() as f64;
        }
    }

    /// The samples, earliest first.
    pub fn samples(&self) -> impl Iterator<Item = &Sample> {
        self.samples.iter()
    }
}
