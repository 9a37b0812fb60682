//! How the error of each method is spread over many bodies: one case may flatter a method, ten thousand do not.

use serde::Serialize;

use super::fit::quantile;
use super::random::Random;
use crate::physics::{Body, Integration, METHODS, Method, Motion, State, so3};

/// Angle a step (rad).
const ANGLE: f64 = 0.05;
/// Seed of the bodies: the same ones each time.
const SEED: u64 = 0xd157_0b0d_1e5a;

/// The errors of a method over all bodies.
#[derive(Clone, Debug, Serialize)]
pub struct Distribution {
    /// Name of the method.
    pub method: &'static str,
    /// Number of bodies.
    pub bodies: usize,
    /// Angle a step (rad).
    pub angle: f64,
    /// Angle turned (rad).
    pub turned: f64,
    /// Half of the bodies have a smaller attitude error (rad).
    pub median: f64,
    /// So have 99 % of them.
    pub percentile_99: f64,
    /// The largest.
    pub worst: f64,
    /// Bodies with which the method could not go on.
    pub failed: usize,
    /// The errors, ascending.
    #[serde(skip)]
    pub errors: Vec<f64>,
}

/// Follows so many bodies for so many steps with every method.
///
/// The truth is the closed form; for a method that is direct itself it is the motion begun anew halfway.
#[must_use]
pub fn measure(bodies: usize, steps: u32) -> Vec<Distribution> {
    let mut random = Random::new(SEED);
    let bodies: Vec<(Body, State, f64)> = (0..bodies)
        .map(|_| {
            let (body, start) = random.body_in_motion();
            let step = ANGLE / so3::norm(start.body_angular_velocity(&body));
            (body, start, step)
        })
        .collect();
    METHODS
        .iter()
        .map(|method| {
            let mut errors: Vec<f64> = bodies.iter().filter_map(|body| error(method, body, steps)).collect();
            errors.sort_by(f64::total_cmp);
            Distribution {
                method: method.name,
                bodies: bodies.len(),
                angle: ANGLE,
                turned: ANGLE * f64::from(steps),
                median: quantile(&errors, 0.5),
                percentile_99: quantile(&errors, 0.99),
                worst: quantile(&errors, 1.0),
                failed: bodies.len() - errors.len(),
                errors,
            }
        })
        .collect()
}

/// The attitude error on one body (rad); `None` where the method could not go on.
fn error(method: &'static Method, (body, start, step): &(Body, State, f64), steps: u32) -> Option<f64> {
    let mut integration = Integration::new(method, body, *start, *step);
    let time = step * f64::from(steps);
    let motion = Motion::new(body, start);
    let (reached, truth) = if method.is_direct {
        let second_half = Motion::new(body, &motion.state(0.5 * time));
        (integration.state_at(time).ok()?, second_half.attitude(0.5 * time))
    } else {
        integration.advance(i64::from(steps)).ok()?;
        (integration.state(), motion.attitude(time))
    };
    let error = so3::angle_between(reached.world_from_body, truth);
    error.is_finite().then_some(error)
}
