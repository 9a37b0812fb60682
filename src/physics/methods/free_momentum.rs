//! What the methods of physics engines share: body momentum and attitude advance each by a rule of its own.
//!
//! Nothing ties one to the other, so `RM` need not stay where it was.

use std::marker::PhantomData;

use glam::{DMat3, DQuat, DVec3};

use super::{Failure, Problem, Stepper};
use crate::physics::so3;

/// The body momentum after a step.
pub(super) struct Advance {
    pub(super) momentum: DVec3,
    /// The body's angular velocity over the step, in body components.
    pub(super) velocity: DVec3,
}

/// One step of the body momentum; `None` where its equation was not solved.
pub(super) trait MomentumRule: Send + 'static {
    fn step(inverse_moments: DVec3, momentum: DVec3, h: f64) -> Option<Advance>;
}

/// `M ← M′`, `R ← R exp(h[Ω̄×])`.
pub(super) struct FreeMomentum<R> {
    inverse_moments: DVec3,
    momentum: DVec3,
    attitude: DQuat,
    rule: PhantomData<fn() -> R>,
}

impl<R: MomentumRule> FreeMomentum<R> {
    pub(super) fn start(problem: &Problem) -> Box<dyn Stepper> {
        Box::new(Self {
            inverse_moments: problem.moments.recip(),
            momentum: problem.momentum,
            attitude: DQuat::IDENTITY,
            rule: PhantomData,
        })
    }
}

impl<R: MomentumRule> Stepper for FreeMomentum<R> {
    fn advance(&mut self, step: f64, count: u64) -> Result<(), Failure> {
        let (mut momentum, mut attitude) = (self.momentum, self.attitude);
        for _ in 0..count {
            let advance = R::step(self.inverse_moments, momentum, step).ok_or(Failure::NotSolved)?;
            momentum = advance.momentum;
            attitude = so3::renormalize(attitude * so3::exp_quaternion(step * advance.velocity));
        }
        if !(momentum.is_finite() && attitude.is_finite()) {
            return Err(Failure::Overflow);
        }
        (self.momentum, self.attitude) = (momentum, attitude);
        Ok(())
    }

    fn attitude(&self) -> DMat3 {
        DMat3::from_quat(self.attitude)
    }

    fn momentum(&self) -> DVec3 {
        self.momentum
    }

    fn duplicate(&self) -> Box<dyn Stepper> {
        Box::new(Self { rule: PhantomData, ..*self })
    }
}
