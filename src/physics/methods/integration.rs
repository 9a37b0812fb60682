//! A method at work on a body: steps counted from the start, so that no rounding of the time piles up.

use glam::DMat3;

use super::{Method, Stepper};
use crate::physics::{Body, State};

/// Why a method could not go on.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MethodError {
    /// The equation of an implicit step was not solved.
    #[error("{method} could not solve its step of {step} s: take a smaller step")]
    NotSolved {
        /// The method's name.
        method: &'static str,
        /// The step (s).
        step: f64,
    },
    /// The state grew past the range of f64.
    #[error("{method} left the range of numbers with steps of {step} s: take a smaller step")]
    Overflow {
        /// The method's name.
        method: &'static str,
        /// The step (s).
        step: f64,
    },
}

/// A body set in motion by one method with a fixed step.
pub struct Integration {
    method: &'static Method,
    body: Body,
    start: State,
    step: f64,
    steps: i64,
    stepper: Box<dyn Stepper>,
}

impl Clone for Integration {
    fn clone(&self) -> Self {
        Self { stepper: self.stepper.duplicate(), ..*self }
    }
}

impl std::fmt::Debug for Integration {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Integration by {} at {} s", self.method.name, self.time())
    }
}

impl Integration {
    /// Starts a method from a state with a fixed step (s, finite and above 0).
    #[must_use]
    pub fn new(method: &'static Method, body: &Body, start: State, step: f64) -> Self {
        let principal_from_body = body.body_from_principal().transpose();
        let momentum = principal_from_body * start.body_momentum;
        Self { method, body: *body, start, step, steps: 0, stepper: (method.start)(body.principal_moments(), momentum) }
    }

    /// The method.
    #[must_use]
    pub fn method(&self) -> &'static Method {
        self.method
    }

    /// Simulated time since the start (s): steps taken times the step, one rounding.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.steps as f64 * self.step
    }

    /// Steps taken since the start; negative where it ran backwards.
    #[must_use]
    pub fn steps(&self) -> i64 {
        self.steps
    }

    /// Takes `count` steps, backwards where it is negative.
    ///
    /// # Errors
    /// See [`MethodError`].
    pub fn advance(&mut self, count: i64) -> Result<(), MethodError> {
        let signed_step = if count < 0 { -self.step } else { self.step };
        self.stepper.advance(signed_step, count.unsigned_abs())?;
        self.steps += count;
        Ok(())
    }

    /// The state at any time (s): whole steps from the start, then one shorter step where the time is no multiple
    /// of the step. The integration itself stays on its grid, so what one time gives does not depend on
    /// which others were asked for. Going back from where it is begins anew at the start.
    ///
    /// # Errors
    /// See [`MethodError`].
    pub fn state_at(&mut self, time: f64) -> Result<State, MethodError> {
        let ratio = time / self.step;
        let nearest = ratio.round();
        // A quotient within its own rounding of a whole number is that number.
        let is_whole = (ratio - nearest).abs() <= 4.0 * f64::EPSILON * nearest.abs();
        let whole = if is_whole { nearest } else { ratio.trunc() };
        let target = whole as i64;
        let is_behind = (target - self.steps).signum() * target.signum() < 0;
        if is_behind || (target == 0 && self.steps != 0) {
            *self = Self::new(self.method, &self.body, self.start, self.step);
        }
        self.advance(target - self.steps)?;
        if is_whole {
            return Ok(self.state());
        }
        let mut last = self.stepper.duplicate();
        last.advance(time - whole * self.step, 1)?;
        Ok(self.state_of(last.as_ref()))
    }

    /// The state now.
    #[must_use]
    pub fn state(&self) -> State {
        if self.steps == 0 {
            return self.start;
        }
        self.state_of(self.stepper.as_ref())
    }

    fn state_of(&self, stepper: &dyn Stepper) -> State {
        let body_from_principal = self.body.body_from_principal();
        let start_from_now: DMat3 = body_from_principal * stepper.attitude() * body_from_principal.transpose();
        let world_from_body = self.start.world_from_body * start_from_now;
        let body_momentum = body_from_principal * stepper.momentum();
        let world_momentum = if self.method.keeps_momentum == super::Keeps::Exactly {
            self.start.world_momentum
        } else {
            world_from_body * body_momentum
        };
        State::from_parts(world_from_body, body_momentum, world_momentum)
    }
}
