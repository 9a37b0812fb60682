//! What the contrast methods share: the nine entries of R and the body momentum, moved by linear combinations.
//!
//! `Ṙ = R[Ω×]`, `Ṁ = M × Ω`. A sum of rotations is no rotation, so nothing is kept: the body they draw swells,
//! shrinks and shears. R is never made a rotation again; that is the point.

use std::marker::PhantomData;

use glam::{DMat3, DVec3};

use super::{Failure, Problem, Stepper};
use crate::physics::so3;

/// The twelve numbers.
#[derive(Clone, Copy)]
pub(super) struct Entries {
    pub(super) attitude: DMat3,
    pub(super) momentum: DVec3,
}

impl Entries {
    /// The right-hand side of the equations of motion.
    pub(super) fn rate(self, inverse_moments: DVec3) -> Self {
        let velocity = inverse_moments * self.momentum;
        Self { attitude: self.attitude * so3::hat(velocity), momentum: self.momentum.cross(velocity) }
    }

    /// `self + h rate`.
    pub(super) fn plus(self, h: f64, rate: Self) -> Self {
        Self { attitude: self.attitude + rate.attitude * h, momentum: self.momentum + rate.momentum * h }
    }
}

/// One step of a linear method; `None` where its equation was not solved.
pub(super) trait Rule: Send + 'static {
    fn step(inverse_moments: DVec3, now: Entries, h: f64) -> Option<Entries>;
}

pub(super) struct Linear<R> {
    inverse_moments: DVec3,
    now: Entries,
    rule: PhantomData<fn() -> R>,
}

impl<R: Rule> Linear<R> {
    pub(super) fn start(problem: &Problem) -> Box<dyn Stepper> {
        Box::new(Self {
            inverse_moments: problem.moments.recip(),
            now: Entries { attitude: DMat3::IDENTITY, momentum: problem.momentum },
            rule: PhantomData,
        })
    }
}

impl<R: Rule> Stepper for Linear<R> {
    fn advance(&mut self, step: f64, count: u64) -> Result<(), Failure> {
        let mut now = self.now;
        for _ in 0..count {
            now = R::step(self.inverse_moments, now, step).ok_or(Failure::NotSolved)?;
            if !now.momentum.is_finite() {
                return Err(Failure::Overflow);
            }
        }
        if !now.attitude.is_finite() {
            return Err(Failure::Overflow);
        }
        self.now = now;
        Ok(())
    }

    fn attitude(&self) -> DMat3 {
        self.now.attitude
    }

    fn momentum(&self) -> DVec3 {
        self.now.momentum
    }

    fn duplicate(&self) -> Box<dyn Stepper> {
        Box::new(Self { inverse_moments: self.inverse_moments, now: self.now, rule: PhantomData })
    }
}
