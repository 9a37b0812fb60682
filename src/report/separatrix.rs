//! Beside the separatrix: how far a rounding of the start moves the answer, and how far each method is from it.

use glam::{DMat3, DVec3};
use serde::Serialize;

use super::cases::Case;
use super::hard::rounding;
use crate::physics::{METHODS, State};

/// Angle a step (rad).
const ANGLE: f64 = 0.01;
/// Tilts from the middle axis: `10⁻ⁿ` rad, n from 0 to this.
const DECADES: i32 = 15;

/// A start beside the middle axis.
#[derive(Clone, Debug, Serialize)]
pub struct BesideSeparatrix {
    /// Tilt of the angular velocity from the middle axis towards axis 3 (rad).
    pub tilt: f64,
    /// Time followed (s).
    pub t: f64,
    /// How far an ulp of the start moves the attitude up to then, at the worst moment (rad).
    pub an_ulp: f64,
    /// The error of every method that takes steps at that time.
    pub errors: Vec<MethodError>,
}

/// A method's error.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct MethodError {
    /// Name of the method.
    pub method: &'static str,
    /// Attitude error (rad); `None` where the method could not go on.
    pub attitude_error: Option<f64>,
}

/// Follows the body of a case from starts ever nearer to its middle axis, for the time of the case. The truth is the closed form.
#[must_use]
pub fn measure(case: &Case) -> Vec<BesideSeparatrix> {
    (0..=DECADES)
        .map(|n| {
            let tilt = 10f64.powi(-n);
            let velocity = case.body.body_from_principal() * DVec3::new(0.0, tilt.cos(), tilt.sin()) * case.rate;
            let start = State::new(&case.body, DMat3::IDENTITY, velocity);
            let near = Case::new("", &case.body, start).at(case.time);
            let steps = (near.rate * near.time / ANGLE).log2().ceil().exp2() as u64;
            let error = |method| {
                let state = near.run(method, near.time, steps).ok()?;
                Some(near.errors(near.time, &state).attitude_error).filter(|error| error.is_finite())
            };
            let errors = METHODS
                .iter()
                .filter(|method| !method.is_direct)
                .map(|method| MethodError { method: method.name, attitude_error: error(method) });
            BesideSeparatrix { tilt, t: near.time, an_ulp: rounding(&near, near.time), errors: errors.collect() }
        })
        .collect()
}
