//! How far each method has strayed, kept along the way.

use std::collections::VecDeque;

use glam::DVec3;

use super::{Runner, Simulation};
use crate::physics::{Motion, State, motion, so3};

/// Most samples kept; past that every second one goes, so that the beginning is never lost.
const MOST: usize = 1200;

/// How far one method's state is from what is exact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// Of the energy, relative; negative where some is lost. Of a body that is to lose energy this is no error but what it has lost.
    pub energy: f64,
    /// Of the world momentum, relative.
    pub momentum: f64,
    /// Of the attitude: the angle to the exact one (rad). Of a body that loses energy there is no exact one, and this is the angle to
    /// that of a body which loses none.
    pub attitude: f64,
}

impl Errors {
    /// Compares a state that a simulation has now with its start and with the exact motion.
    #[must_use]
    pub fn of(simulation: &Simulation, exact: &Motion, state: &State) -> Self {
        let (body, start, time) = (simulation.body(), simulation.start(), simulation.time());
        Self {
            energy: motion::energy_error(body, start, state),
            momentum: motion::momentum_error(start, state),
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
    /// The body momentum of the scene's own method (kg m²/s).
    pub momentum: DVec3,
    /// Nothing is known of the time between the sample before and this one.
    pub is_after_gap: bool,
}

/// Samples in order of time.
#[derive(Clone, Debug, Default)]
pub struct History {
    samples: VecDeque<Sample>,
    /// Shortest time between samples (s); it grows as the history is thinned.
    spacing: f64,
    /// Whether time has come to where it is without a jump.
    is_continuous: bool,
}

impl History {
    /// Forgets everything.
    pub fn clear(&mut self) {
        *self = Self::default();
    }

    /// Time was set: what lies between was not seen.
    pub fn jump(&mut self) {
        self.is_continuous = false;
    }

    /// Adds how the simulation stands. Times that have been seen already are not added again.
    pub fn record(&mut self, simulation: &Simulation, exact: &Motion) {
        let time = simulation.time();
        let has_jumped = !std::mem::replace(&mut self.is_continuous, true);
        let is_after = self.samples.back().is_none_or(|last| time >= last.time + self.spacing && time > last.time);
        let is_before =
            self.samples.front().is_some_and(|first| time <= first.time - self.spacing && time < first.time);
        if !(is_after || is_before) {
            return;
        }
        let runners = std::iter::once(simulation.main()).chain(simulation.ghosts());
        let errors = runners.map(|runner: &Runner| Errors::of(simulation, exact, runner.state())).collect();
        let momentum = simulation.state().body_momentum;
        let sample = Sample { time, errors, momentum, is_after_gap: is_after && has_jumped };
        if is_after {
            self.samples.push_back(sample);
        } else {
            if let Some(next) = self.samples.front_mut() {
                next.is_after_gap = has_jumped;
            }
            self.samples.push_front(sample);
        }
        if self.samples.len() > MOST {
            self.thin();
        }
    }

    fn thin(&mut self) {
        let mut index = 0;
        let mut has_lost_gap = false;
        self.samples.retain_mut(|sample| {
            index += 1;
            sample.is_after_gap |= std::mem::take(&mut has_lost_gap);
            let is_kept = index % 2 == 1;
            has_lost_gap = !is_kept && sample.is_after_gap;
            is_kept
        });
        if let (Some(first), Some(last)) = (self.samples.front(), self.samples.back()) {
            self.spacing = (last.time - first.time) / self.samples.len() as f64;
        }
    }

    /// The samples, earliest first.
    pub fn samples(&self) -> impl Iterator<Item = &Sample> {
        self.samples.iter()
    }

    /// What a curve shows of them, in pieces where there are gaps: points of time (s) and value.
    pub fn pieces(&self, value: impl Fn(&Sample) -> Option<f64>) -> Vec<Vec<[f64; 2]>> {
        let mut pieces: Vec<Vec<[f64; 2]>> = Vec::new();
        for sample in &self.samples {
            let Some(value) = value(sample) else { continue };
            match pieces.last_mut() {
                Some(piece) if !sample.is_after_gap => piece.push([sample.time, value]),
                _ => pieces.push(vec![[sample.time, value]]),
            }
        }
        pieces
    }
}

#[cfg(test)]
mod tests {
    use super::History;
    use crate::physics::Motion;
    use crate::scene::{Scene, SceneError, SceneFile};
    use crate::sim::Simulation;

    #[test]
    fn a_jump_leaves_a_gap_and_nothing_else_does() -> Result<(), SceneError> {
        let scene = Scene::check(&SceneFile::default())?;
        let exact = Motion::new(&scene.body, &scene.start);
        let mut simulation = Simulation::new(&scene);
        let step = simulation.step_length();
        let mut history = History::default();
        history.record(&simulation, &exact);
        let mut run = |history: &mut History, to: Option<f64>| {
            if let Some(to) = to {
                simulation.go_to(to);
                history.jump();
                history.record(&simulation, &exact);
            }
            for _ in 0..10 {
                simulation.step(1);
                history.record(&simulation, &exact);
            }
            history.pieces(|_| Some(0.0)).len()
        };
        assert_eq!(run(&mut history, None), 1);
        assert_eq!(run(&mut history, Some(4.0 * step)), 1);
        assert_eq!(run(&mut history, Some(100.0 * step)), 2);
        assert_eq!(run(&mut history, Some(2.0 * step)), 2);
        for _ in 0..200 {
            run(&mut history, None);
        }
        assert_eq!(run(&mut history, None), 2);
        Ok(())
    }
}
