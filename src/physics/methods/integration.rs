//! A method at work on a body: steps counted from the start, so that no rounding of the time piles up.

use glam::{DMat3, DVec3};

use super::{Failure, Keeps, Method, Problem, Stepper};
use crate::physics::double_double::power_of_two_of;
use crate::physics::start::Start;
use crate::physics::{Body, State, number};

/// Why a method could not go on.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MethodError {
    /// The equation of an implicit step was not solved.
    #[error("{method} could not solve its step of {} s: take a smaller step", number(*.step))]
    NotSolved {
        /// The method's name.
        method: &'static str,
        /// The step (s).
        step: f64,
    },
    /// The state grew past the range of f64.
    #[error("{method} left the range of numbers with steps of {} s: take a smaller step", number(*.step))]
    Overflow {
        /// The method's name.
        method: &'static str,
        /// The step (s).
        step: f64,
    },
    /// The time asked for is more steps away than can be counted without rounding, 2⁵³.
    #[error("{} s is more than 2^53 steps of {} s away: take a longer step or the closed form", number(*.time), number(*.step))]
    TooFar {
        /// The time (s).
        time: f64,
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
    energy_loss: f64,
    /// Two factors that take momenta of the stepper to kg m²/s.
    momentum_unit: [f64; 2],
    /// Two factors that take seconds to the units of the stepper.
    units_from_seconds: [f64; 2],
    stepper: Box<dyn Stepper>,
    /// From the stepper's frame to the body's, and at the start to the world's.
    body_from_stepper: DMat3,
    world_from_stepper: DMat3,
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
        Self::with_energy_loss(method, body, start, step, 0.0)
    }

    /// The same with energy lost inside the body at constant L: `Ω_eff = Ω + (loss/ℓ) M×Ω`. The loss is a number without a unit, finite and not
    /// negative. Only [`LOSS_METHOD`](super::LOSS_METHOD) knows it: with the others it is as if there were none.
    ///
    /// ```
    /// use dzhanibekov::glam::{DMat3, DVec3};
    /// use dzhanibekov::physics::{Body, Integration, State, method, methods::LOSS_METHOD};
    ///
    /// fn main() -> Result<(), Box<dyn std::error::Error>> {
    ///     // A rod spun about its length ends about axis 3, where it turns I₁/I₃ times as fast.
    ///     let body = Body::from_moments(DVec3::new(0.2, 1.0, 1.1))?;
    ///     let start = State::new(&body, DMat3::IDENTITY, DVec3::new(10.0, 0.0, 0.1));
    ///     let method = method(LOSS_METHOD).expect("it is in the table");
    ///     let mut integration = Integration::with_energy_loss(method, &body, start, 0.01, 0.1);
    ///     let end = integration.state_at(200.0)?;
    ///     let slower = end.body_angular_velocity(&body).length() / start.body_angular_velocity(&body).length();
    ///     assert!((slower - 0.2 / 1.1).abs() < 1e-3);
    ///     Ok(())
    /// }
    /// ```
    #[must_use]
    pub fn with_energy_loss(method: &'static Method, body: &Body, start: State, step: f64, energy_loss: f64) -> Self {
        let exact = Start::new(body, &start);
        // The stepper's units are those of the start.
        let problem = Problem {
            moments: exact.rounded_moments(),
            momentum: exact.rounded_momentum(),
            start: Start { moment_exponent: 0, rate_exponent: 0, ..exact },
            energy_loss,
        };
        let stepper = (method.start)(&problem);
        let body_from_stepper = body.body_from_principal() * stepper.principal_from_own();
        Self {
            method,
            body: *body,
            start,
            step,
            steps: 0,
            energy_loss,
            momentum_unit: power_of_two_of(exact.moment_exponent + exact.rate_exponent),
            units_from_seconds: power_of_two_of(exact.rate_exponent),
            stepper,
            body_from_stepper,
            world_from_stepper: start.world_from_body * body_from_stepper,
        }
    }

    /// The method.
    #[must_use]
    pub fn method(&self) -> &'static Method {
        self.method
    }

    /// The step (s).
    #[must_use]
    pub fn step(&self) -> f64 {
        self.step
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

    /// Takes `count` steps, backwards where it is negative. Where it fails, the integration stays where it was.
    ///
    /// # Errors
    /// See [`MethodError`].
    pub fn advance(&mut self, count: i64) -> Result<(), MethodError> {
        let signed_step = if count < 0 { -self.step } else { self.step };
        self.stepper.advance(self.in_units(signed_step), count.unsigned_abs()).map_err(|f| self.error(f))?;
        self.steps += count;
        Ok(())
    }

    /// The state at any time (s, finite): whole steps from the start, then one shorter step where the time is no multiple
    /// of the step. The integration itself stays on its grid, so what one time gives does not depend on
    /// which others were asked for. Going back from where it is begins anew at the start. The closed form goes
    /// to any time at once and moves no step.
    ///
    /// # Errors
    /// See [`MethodError`].
    pub fn state_at(&mut self, time: f64) -> Result<State, MethodError> {
        if let Some(state) = self.directly(time) {
            return Ok(state);
        }
        let ratio = time / self.step;
        let nearest = ratio.round();
        // A quotient within its own rounding of a whole number is that number.
        let is_whole = (ratio - nearest).abs() <= 4.0 * f64::EPSILON * nearest.abs();
        let whole = if is_whole { nearest } else { ratio.trunc() };
        if whole.abs() >= 2f64.powi(53) {
            return Err(MethodError::TooFar { time, step: self.step });
        }
        let target = whole as i64;
        // Steps are not undone: what lies behind, or beyond the start, is reached from the start.
        let is_ahead = self.steps.signum() * target.signum() >= 0 && target.abs() >= self.steps.abs();
        if !is_ahead {
            *self = Self::with_energy_loss(self.method, &self.body, self.start, self.step, self.energy_loss);
        }
        self.advance(target - self.steps)?;
        if is_whole {
            return Ok(self.state());
        }
        let mut last = self.stepper.duplicate();
        last.advance(self.in_units(time - whole * self.step), 1).map_err(|f| self.error(f))?;
        Ok(self.state_of(last.now()))
    }

    /// The state now. After each step of the exact one, step and state cost some 70 ns, of which 8 are the step: the momentum half a step back waits for
    /// a root and a quotient, the attitude that goes with it for another pair, and two products of matrices take it to the world.
    #[must_use]
    pub fn state(&self) -> State {
        if self.steps == 0 {
            return self.start;
        }
        let directly = if self.method.is_direct { self.directly(self.time()) } else { None };
        directly.unwrap_or_else(|| self.state_of(self.stepper.now()))
    }

    fn directly(&self, time: f64) -> Option<State> {
        let moved = self.stepper.directly(self.in_units(time))?;
        Some(if time == 0.0 { self.start } else { self.state_of(moved) })
    }

    /// A time (s) in the units of the stepper: exact, as these are powers of two.
    fn in_units(&self, time: f64) -> f64 {
        time * self.units_from_seconds[0] * self.units_from_seconds[1]
    }

    fn error(&self, failure: Failure) -> MethodError {
        let (method, step) = (self.method.name, self.step);
        match failure {
            Failure::NotSolved => MethodError::NotSolved { method, step },
            Failure::Overflow => MethodError::Overflow { method, step },
        }
    }

    fn state_of(&self, (attitude, momentum): (DMat3, DVec3)) -> State {
        let world_from_body = self.world_from_stepper * attitude * self.body_from_stepper.transpose();
        let body_momentum = self.body_from_stepper * (momentum * self.momentum_unit[0] * self.momentum_unit[1]);
        let world_momentum = if self.method.keeps_momentum == Keeps::Exactly {
            self.start.world_momentum
        } else {
            world_from_body * body_momentum
        };
        State::from_parts(world_from_body, body_momentum, world_momentum)
    }
}
