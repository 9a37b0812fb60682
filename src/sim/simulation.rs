//! A scene set in motion.

use crate::physics::{Body, Integration, Method, MethodError, State, motion};
use crate::scene::Scene;

use super::{Clock, Tick};

/// Steps that can be counted without rounding.
const COUNTABLE: f64 = 9e15;

/// The scene's body followed by one method.
#[derive(Clone, Debug)]
pub struct Runner {
    integration: Integration,
    state: State,
    failure: Option<MethodError>,
}

impl Runner {
    fn new(body: &Body, start: State, method: &'static Method, step: f64) -> Self {
        Self { integration: Integration::new(method, body, start, step), state: start, failure: None }
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
            match self.integration.advance(count) {
                Ok(()) => self.state = self.integration.state(),
                Err(error) => self.failure = Some(error),
            }
        }
    }

    fn go_to(&mut self, time: f64) {
        if self.failure.is_none() {
            match self.integration.state_at(time) {
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
        Self::of_methods(&scene.body, scene.start, scene.step, scene.method, compare)
    }

    fn of_methods(
        body: &Body,
        start: State,
        step: f64,
        method: &'static Method,
        compare: impl Iterator<Item = &'static Method>,
    ) -> Self {
        Self {
            body: *body,
            start,
            step,
            clock: Clock::default(),
            time: 0.0,
            main: Runner::new(body, start, method, step),
            ghosts: compare.map(|method| Runner::new(body, start, method, step)).collect(),
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
        *self = Self::of_methods(&self.body, self.start, self.step, self.main.method(), compare);
        self.clock = clock;
        self.clock.clear();
    }

    /// Relative error of the energy since the start (absolute where the body was at rest).
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
