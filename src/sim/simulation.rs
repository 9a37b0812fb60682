//! A scene set in motion.

use std::cell::OnceCell;

use glam::DVec3;

use crate::physics::{
    Body, Integration, Method, MethodError, Motion, State, method, methods::LOSS_METHOD, motion, so3,
};
use crate::scene::{self, Scene};

use super::checkpoints::Checkpoints;
use super::{Clock, Cloud, Tick};

/// Steps that can be counted without rounding.
const COUNTABLE: f64 = 9e15;
/// Longest turn (rad) of a step by which a body that loses energy is followed for the picture alone.
const DRAWN_TURN: f64 = 0.05;
/// The same for the way since the start, and the most points of it.
const TRACK_TURN: f64 = 0.15;
const MOST_TRACK: f64 = 40_000.0;

/// The scene's body followed by one method.
#[derive(Clone, Debug)]
pub struct Runner {
    integration: Integration,
    /// The way back, where energy is lost.
    checkpoints: Option<Checkpoints>,
    state: State,
    failure: Option<MethodError>,
}

impl Runner {
    fn new(body: &Body, start: State, method: &'static Method, step: f64, energy_loss: f64) -> Self {
        let integration = Integration::with_energy_loss(method, body, start, step, energy_loss);
        let checkpoints = (energy_loss > 0.0).then(|| Checkpoints::new(&integration));
        Self { integration, checkpoints, state: start, failure: None }
    }

    /// The method that follows the body.
    #[must_use]
    pub fn method(&self) -> &'static Method {
        self.integration.method()
    }

    /// The state now; after a failure the last good one.
    #[must_use]
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Why the method stopped, if it did.
    #[must_use]
    pub fn failure(&self) -> Option<&MethodError> {
        self.failure.as_ref()
    }

    fn advance(&mut self, count: i64) {
        if self.failure.is_none() {
            let target = self.integration.steps().saturating_add(count);
            let outcome = match &mut self.checkpoints {
                Some(checkpoints) => checkpoints.go_to(&mut self.integration, target),
                None => self.integration.advance(count),
            };
            match outcome {
                Ok(()) => self.state = self.integration.state(),
                Err(error) => self.failure = Some(error),
            }
        }
    }

    fn go_to(&mut self, time: f64) {
        if self.failure.is_none() {
            let whole = (time / self.integration.step()).trunc();
            let behind = match &mut self.checkpoints {
                Some(checkpoints) if whole.abs() < COUNTABLE => checkpoints.go_to(&mut self.integration, whole as i64),
                _ => Ok(()),
            };
            match behind.and_then(|()| self.integration.state_at(time)) {
                Ok(state) => {
                    self.state = state;
                    self.follow(time);
                }
                Err(error) => self.failure = Some(error),
            }
        }
    }

    /// A method that needed no steps to a time counts them all the same: from there it goes on.
    fn follow(&mut self, time: f64) {
        if self.method().is_direct {
            let target = (time / self.integration.step()).trunc().clamp(-COUNTABLE, COUNTABLE) as i64;
            if let Err(error) = self.integration.advance(target - self.integration.steps()) {
                self.failure = Some(error);
            }
        }
    }

    /// Steps that going to a time takes.
    fn steps_to(&self, time: f64) -> f64 {
        if self.method().is_direct {
            return 0.0;
        }
        let (target, now) = ((time / self.integration.step()).abs(), self.integration.steps() as f64);
        // What lies behind is reached from the start.
        let is_ahead = time * now >= 0.0 && target >= now.abs();
        if is_ahead { target - now.abs() } else { target }
    }
}

/// A body in motion: its method, and beside it the ghosts that other methods make of the same start.
#[derive(Clone, Debug)]
pub struct Simulation {
    body: Body,
    start: State,
    step: f64,
    energy_loss: f64,
    /// What is said of the cloud, and the cloud itself from when it is first looked at.
    cloud_wanted: scene::Cloud,
    cloud: OnceCell<Cloud>,
    /// The clock.
    pub clock: Clock,
    time: f64,
    main: Runner,
    ghosts: Vec<Runner>,
}

impl Simulation {
    /// Sets a scene at its start.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let compare = scene.compare.iter().copied();
        let numbers = (scene.step, scene.energy_loss);
        Self::of_methods(&scene.body, scene.start, numbers, scene.cloud.clone(), scene.method, compare)
    }

    fn of_methods(
        body: &Body,
        start: State,
        (step, energy_loss): (f64, f64),
        cloud_wanted: scene::Cloud,
        method: &'static Method,
        compare: impl Iterator<Item = &'static Method>,
    ) -> Self {
        Self {
            body: *body,
            start,
            step,
            energy_loss,
            cloud_wanted,
            cloud: OnceCell::new(),
            clock: Clock::default(),
            time: 0.0,
            main: Runner::new(body, start, method, step, energy_loss),
            ghosts: compare.map(|method| Runner::new(body, start, method, step, energy_loss)).collect(),
        }
    }

    /// The body.
    #[must_use]
    pub fn body(&self) -> &Body {
        &self.body
    }

    /// The state at time 0.
    #[must_use]
    pub fn start(&self) -> &State {
        &self.start
    }

    /// The step (s) of every method.
    #[must_use]
    pub fn step_length(&self) -> f64 {
        self.step
    }

    /// Energy lost inside the body at constant L, a number without a unit; 0 for none.
    #[must_use]
    pub fn energy_loss(&self) -> f64 {
        self.energy_loss
    }

    /// The scene's cloud of starts; all of its motions are exact and know no energy loss.
    pub fn cloud(&self) -> &Cloud {
        self.cloud.get_or_init(|| Cloud::new(&self.cloud_wanted, &self.body, &self.start))
    }

    /// Simulated time (s).
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// The state that the scene's method gives now.
    #[must_use]
    pub fn state(&self) -> &State {
        self.main.state()
    }

    /// The scene's method at work.
    #[must_use]
    pub fn main(&self) -> &Runner {
        &self.main
    }

    /// The same start under the methods compared with.
    #[must_use]
    pub fn ghosts(&self) -> &[Runner] {
        &self.ghosts
    }

    /// Advances by a frame's real time (s): as many whole steps as it holds.
    pub fn advance_frame(&mut self, real_seconds: f64) -> Tick {
        let tick = self.clock.tick(real_seconds, self.step);
        if let Tick::Steps(count) | Tick::Capped(count) = tick {
            self.step(count);
        }
        tick
    }

    /// Takes `count` steps, backwards where it is negative.
    pub fn step(&mut self, count: i64) {
        self.main.advance(count);
        for ghost in &mut self.ghosts {
            ghost.advance(count);
        }
        self.time = self.main.integration.time();
        if self.main.failure.is_some() {
            self.clock.paused = true;
        }
    }

    /// Steps that going to a time (s) takes, those of all methods together.
    #[must_use]
    pub fn steps_to(&self, time: f64) -> f64 {
        std::iter::once(&self.main).chain(&self.ghosts).map(|runner| runner.steps_to(time)).sum()
    }

    /// Goes to a time (s), from the start where it lies behind.
    pub fn go_to(&mut self, time: f64) {
        self.main.go_to(time);
        for ghost in &mut self.ghosts {
            ghost.go_to(time);
        }
        self.time = if self.main.failure.is_none() { time } else { self.main.integration.time() };
        self.clock.clear();
    }

    /// Back to the start; paused or running as before.
    pub fn restart(&mut self) {
        let clock = self.clock;
        let compare = self.ghosts.iter().map(Runner::method);
        let numbers = (self.step, self.energy_loss);
        let (wanted, cloud) = (self.cloud_wanted.clone(), std::mem::take(&mut self.cloud));
        *self = Self::of_methods(&self.body, self.start, numbers, wanted, self.main.method(), compare);
        (self.clock, self.cloud) = (clock, cloud);
        self.clock.clear();
    }

    /// Where the motion through the present state was and will be: at `count` + 1 times evenly from `low` to `high` (s) from now, 0 among them or at an end.
    ///
    /// It is the exact motion; where energy is lost, the method that knows it, by steps fine enough for a picture.
    #[must_use]
    pub fn around(&self, low: f64, high: f64, count: u32) -> Vec<State> {
        let (now, spacing) = (self.state(), (high - low) / f64::from(count.max(1)));
        let at = |n: u32| low + (high - low) * (f64::from(n) / f64::from(count.max(1)));
        let losing = method(LOSS_METHOD).filter(|_| self.energy_loss > 0.0 && spacing > 0.0);
        let followed = losing.and_then(|method| {
            let rate = so3::norm(now.body_momentum) / self.body.principal_moments().x;
            let step = spacing / (spacing * rate / DRAWN_TURN).ceil().clamp(1.0, 1e3);
            let mut integration = Integration::with_energy_loss(method, &self.body, *now, step, self.energy_loss);
            let (before, after): (Vec<u32>, Vec<u32>) = (0..=count).partition(|n| at(*n) < 0.0);
            let mut states = vec![*now; count as usize + 1];
            for n in before.into_iter().rev().chain(after) {
                states[n as usize] = integration.state_at(at(n)).ok()?;
            }
            Some(states)
        });
        // A loss too small for such steps to show is none that a picture would.
        followed.unwrap_or_else(|| {
            let motion = Motion::new(&self.body, now);
            (0..=count).map(|n| motion.state(at(n))).collect()
        })
    }

    /// The body momenta (kg m²/s) from the start until now, close enough to each other for a curve: of the exact motion, or, where energy is lost,
    /// of the method that knows it. Of more than a thousand turns the last ones; with loss, which is over by then, the first.
    #[must_use]
    pub fn momenta_since_start(&self) -> Vec<DVec3> {
        let rate = so3::norm(self.start.body_momentum) / self.body.principal_moments().x;
        let spacing = TRACK_TURN / rate;
        let count = (self.time.abs() / spacing).ceil().clamp(1.0, MOST_TRACK);
        let step = (self.time.abs() / count).min(spacing);
        let Some(method) = method(LOSS_METHOD).filter(|_| self.energy_loss > 0.0 && step > 0.0) else {
            let motion = Motion::new(&self.body, &self.start);
            let at = |n: u32| self.time - (step * (count - f64::from(n))).copysign(self.time);
            return (0..=count as u32).map(|n| motion.momentum(at(n))).collect();
        };
        let mut losing = Integration::with_energy_loss(method, &self.body, self.start, step, self.energy_loss);
        let states = (0..=count as u32).map_while(|n| losing.state_at(step.copysign(self.time) * f64::from(n)).ok());
        states.map(|state| state.body_momentum).collect()
    }

    /// Relative error of the energy since the start (absolute where the body was at rest); where energy is lost, what has been.
    #[must_use]
    pub fn energy_error(&self) -> f64 {
        motion::energy_error(&self.body, &self.start, self.state())
    }

    /// Relative error of the world momentum since the start (absolute where the body was at rest), as attitude and body momentum have it.
    #[must_use]
    pub fn momentum_error(&self) -> f64 {
        motion::momentum_error(&self.start, self.state())
    }
}

#[cfg(test)]
mod tests {
    use super::{Checkpoints, Runner};
    use crate::scene::{Scene, SceneError, SceneFile};
    use crate::sim::Simulation;
    use crate::sim::tests::LOSING;

    /// Where energy is lost a time is gone to by whole steps, which leave places behind to go back to.
    #[test]
    fn a_way_with_loss_leaves_places_behind() -> Result<(), SceneError> {
        let mut simulation = Simulation::new(&Scene::check(&SceneFile::parse(LOSING)?)?);
        assert_eq!(simulation.energy_loss(), 0.05);
        for (time, steps, places) in [(2.345, 234, vec![0, 64, 128, 192]), (-0.705, -70, vec![0, -64])] {
            simulation.go_to(time);
            let Runner { integration, checkpoints, .. } = simulation.main();
            assert_eq!(integration.steps(), steps, "{time}");
            assert_eq!(checkpoints.as_ref().map(Checkpoints::places), Some(places), "{time}");
        }
        Ok(())
    }
}
