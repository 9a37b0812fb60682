//! What the Lie group methods share: the attitude as a unit quaternion, the world momentum held fixed.

use glam::{DMat3, DQuat, DVec3};

use super::{MethodError, Stepper};
use crate::physics::so3;

/// The body's angular velocity over one step, in body components (rad/s): all that sets one method apart from another.
pub(super) type MeanVelocity = fn(inverse_moments: DVec3, momentum: DVec3, step: f64) -> DVec3;

/// `R ← R exp(h[Ω̄×])` with the world momentum fixed: `M = RᵀL` follows from the attitude.
#[derive(Clone)]
pub(super) struct LieGroup {
    name: &'static str,
    mean_velocity: MeanVelocity,
    inverse_moments: DVec3,
    world_momentum: DVec3,
    attitude: DQuat,
}

impl LieGroup {
    pub(super) fn start(
        name: &'static str,
        mean_velocity: MeanVelocity,
        moments: DVec3,
        momentum: DVec3,
    ) -> Box<dyn Stepper> {
        Box::new(Self {
            name,
            mean_velocity,
            inverse_moments: moments.recip(),
            world_momentum: momentum,
            attitude: DQuat::IDENTITY,
        })
    }
}

impl Stepper for LieGroup {
    fn advance(&mut self, step: f64, count: u64) -> Result<(), MethodError> {
        let mut attitude = self.attitude;
        for _ in 0..count {
            let momentum = attitude.inverse() * self.world_momentum;
            let velocity = (self.mean_velocity)(self.inverse_moments, momentum, step);
            attitude = (attitude * so3::exp_quaternion(step * velocity)).normalize();
        }
        if !attitude.is_finite() {
            return Err(MethodError::Overflow { method: self.name, step });
        }
        self.attitude = attitude;
        Ok(())
    }

    fn attitude(&self) -> DMat3 {
        DMat3::from_quat(self.attitude)
    }

    fn momentum(&self) -> DVec3 {
        self.attitude.inverse() * self.world_momentum
    }

    fn duplicate(&self) -> Box<dyn Stepper> {
        Box::new(self.clone())
    }
}
