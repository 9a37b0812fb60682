//! What the Lie group methods share: the attitude as a unit quaternion, the world momentum held fixed.

use std::marker::PhantomData;

use glam::{DMat3, DQuat, DVec3};

use super::{Failure, Problem, Stepper};
use crate::physics::so3;

/// The body's angular velocity over one step, in body components: all that sets one method apart from another.
/// `None` where it is the solution of an equation and none was found.
pub(super) trait MeanVelocity: Send + 'static {
    /// The rotation that one step makes, in the principal frame.
    fn rotation_of_step(inverse_moments: DVec3, momentum: DVec3, step: f64) -> Option<DQuat>;

    /// The same with energy lost, `Ω_eff = Ω + damping M×Ω`; as if there were none, where the method knows no loss.
    fn rotation_of_losing_step(inverse_moments: DVec3, momentum: DVec3, step: f64, _damping: f64) -> Option<DQuat> {
        Self::rotation_of_step(inverse_moments, momentum, step)
    }
}

/// Roundings of the energy before and after a step: of M a few ε, and K is conditioned by 2.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// The rotation by a mean angular velocity during a step.
pub(super) fn turn_by(velocity: DVec3, step: f64) -> DQuat {
    so3::exp_quaternion(step * velocity)
}

/// `R ← R exp(h[Ω̄×])` with the world momentum fixed: `M = RᵀL` follows from the attitude.
pub(super) struct LieGroup<V> {
    inverse_moments: DVec3,
    world_momentum: DVec3,
    attitude: DQuat,
    /// `c = loss/ℓ` in `Ω_eff = Ω + c M×Ω`.
    damping: f64,
    rule: PhantomData<fn() -> V>,
}

impl<V: MeanVelocity> LieGroup<V> {
    pub(super) fn start(problem: &Problem) -> Box<dyn Stepper> {
        let ell = problem.momentum.length();
        Box::new(Self {
            inverse_moments: problem.moments.recip(),
            world_momentum: problem.momentum,
            attitude: DQuat::IDENTITY,
            damping: if ell > 0.0 { problem.energy_loss / ell } else { 0.0 },
            rule: PhantomData,
        })
    }

    /// Steps that keep the energy, but for the method's error.
    fn conservative(&self, step: f64, count: u64) -> Result<DQuat, Failure> {
        let mut attitude = self.attitude;
        for _ in 0..count {
            let momentum = so3::rotate_back(attitude, self.world_momentum);
            let turn = V::rotation_of_step(self.inverse_moments, momentum, step).ok_or(Failure::NotSolved)?;
            attitude = so3::renormalize(attitude * turn);
        }
        Ok(attitude)
    }

    /// Steps that lose energy, or, against time, gain it. One so long that the method's error hides the loss is none.
    fn losing(&self, step: f64, count: u64) -> Result<DQuat, Failure> {
        let twice_energy = |momentum: DVec3| momentum.dot(self.inverse_moments * momentum);
        let mut attitude = self.attitude;
        let mut momentum = so3::rotate_back(attitude, self.world_momentum);
        let mut before = twice_energy(momentum);
        for _ in 0..count {
            let turn = V::rotation_of_losing_step(self.inverse_moments, momentum, step, self.damping);
            attitude = so3::renormalize(attitude * turn.ok_or(Failure::NotSolved)?);
            momentum = so3::rotate_back(attitude, self.world_momentum);
            let after = twice_energy(momentum);
            if (after - before) * step.signum() > ROUNDING * before {
                return Err(Failure::NotSolved);
            }
            before = after;
        }
        Ok(attitude)
    }
}

impl<V: MeanVelocity> Stepper for LieGroup<V> {
    fn advance(&mut self, step: f64, count: u64) -> Result<(), Failure> {
        let attitude = if self.damping > 0.0 { self.losing(step, count) } else { self.conservative(step, count) }?;
        if !attitude.is_finite() {
            return Err(Failure::Overflow);
        }
        self.attitude = attitude;
        Ok(())
    }

    fn attitude(&self) -> DMat3 {
        DMat3::from_quat(self.attitude)
    }

    fn momentum(&self) -> DVec3 {
        so3::rotate_back(self.attitude, self.world_momentum)
    }

    fn duplicate(&self) -> Box<dyn Stepper> {
        Box::new(Self { rule: PhantomData, ..*self })
    }
}
