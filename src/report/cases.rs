//! The motions that are measured, and the truth about them.

use glam::{DMat3, DVec3};
use serde::{Deserialize, Serialize};

use super::ReportError;
use crate::physics::poinsot::flip_period;
use crate::physics::{Body, Integration, Method, MethodError, Motion, State, motion, so3};
use crate::scene::Scene;

/// Attitudes from 60-digit arithmetic.
const REFERENCE: &str = include_str!("../../tests/free_rigid_body.json");
/// Angle turned (rad) over which a scene of the user's is followed.
const SCENE_ANGLE: f64 = 300.0;

/// What an error is measured against.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Reference {
    /// The embedded table of 60-digit arithmetic.
    #[serde(rename = "60-digit")]
    SixtyDigits,
    /// The closed form, which the table itself confirms.
    #[serde(rename = "closed form")]
    ClosedForm,
}

impl Reference {
    /// Its name, as in the files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::SixtyDigits => "60-digit",
            Self::ClosedForm => "closed form",
        }
    }
}

/// A motion to be measured.
#[derive(Clone, Debug)]
pub struct Case {
    /// Its name in every table.
    pub name: String,
    /// The body.
    pub body: Body,
    /// The start.
    pub start: State,
    /// The motion in closed form.
    pub motion: Motion,
    /// The time (s) at which work and precision are compared.
    pub time: f64,
    /// `|Ω|` at the start (rad/s): the step is told in turns of this rate.
    pub rate: f64,
    pub(super) samples: Vec<(f64, DMat3)>,
}

/// How far a state is from the truth.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Errors {
    /// Angle between the attitudes (rad).
    pub attitude_error: f64,
    /// Change of the energy since the start, relative to it.
    pub energy_error: f64,
    /// Change of `RM` since the start, relative to it.
    pub momentum_error: f64,
    /// `|RᵀR − 1|`.
    pub orthogonality_error: f64,
}

#[derive(Deserialize)]
struct File {
    cases: Vec<FileCase>,
}

#[derive(Deserialize)]
struct FileCase {
    name: String,
    moments: [f64; 3],
    omega: [f64; 3],
    samples: Vec<FileSample>,
}

#[derive(Deserialize)]
struct FileSample {
    t: f64,
    #[serde(rename = "R")]
    attitude: [[f64; 3]; 3],
}

/// The cases of the reference table, in its order.
///
/// # Errors
/// None for the table that is in the repository and passed the tests.
pub fn reference_cases() -> Result<Vec<Case>, ReportError> {
    let file: File = serde_json::from_str(REFERENCE).map_err(|error| ReportError::Reference(error.to_string()))?;
    file.cases
        .into_iter()
        .map(|case| {
            let body = Body::from_moments(DVec3::from_array(case.moments))
                .map_err(|error| ReportError::Reference(format!("{}: {error}", case.name)))?;
            let start = State::new(&body, DMat3::IDENTITY, DVec3::from_array(case.omega));
            let samples: Vec<(f64, DMat3)> = case
                .samples
                .iter()
                // The table holds rows.
                .map(|sample| (sample.t, DMat3::from_cols_array_2d(&sample.attitude).transpose()))
                .collect();
            let times = || samples.iter().map(|sample| sample.0);
            // Long enough for errors to show, short enough for small steps.
            let time = times().find(|time| (10.0..=200.0).contains(time)).or_else(|| times().find(|time| *time > 1.0));
            Ok(Case { time: time.unwrap_or(1.0), samples, ..Case::new(case.name, &body, start) })
        })
        .collect()
}

impl Case {
    /// A case with no table, from a body and its start.
    #[must_use]
    pub fn new(name: impl Into<String>, body: &Body, start: State) -> Self {
        let rate = so3::norm(start.body_angular_velocity(body));
        Self {
            name: name.into(),
            body: *body,
            start,
            motion: Motion::new(body, &start),
            time: 1.0,
            rate,
            samples: Vec::new(),
        }
    }

    /// The same case with another time (s) at which it is compared.
    #[must_use]
    pub fn at(self, time: f64) -> Self {
        Self { time, ..self }
    }

    /// The motion of a scene; `None` where the body is at rest.
    #[must_use]
    pub fn of_scene(scene: &Scene) -> Option<Self> {
        let name = if scene.file.title.is_empty() { "scene" } else { &scene.file.title };
        let case = Self::new(name, &scene.body, scene.start);
        // A power of two: every halving of the step is then exact.
        let time = (SCENE_ANGLE / case.rate).log2().round().exp2();
        (time.is_finite() && time > 0.0).then_some(Self { time, ..case })
    }

    /// Times (s) at which the table has the attitude.
    pub fn sample_times(&self) -> impl Iterator<Item = f64> {
        self.samples.iter().map(|sample| sample.0)
    }

    /// The true attitude at a time, from the table where it has that time.
    #[must_use]
    pub fn truth(&self, time: f64) -> (DMat3, Reference) {
        match self.samples.iter().find(|sample| sample.0 == time) {
            Some((_, attitude)) => (*attitude, Reference::SixtyDigits),
            None => (self.motion.state(time).world_from_body, Reference::ClosedForm),
        }
    }

    /// How far a state at a time is from the truth.
    #[must_use]
    pub fn errors(&self, time: f64, state: &State) -> Errors {
        Errors {
            attitude_error: so3::angle_between(self.truth(time).0, state.world_from_body),
            energy_error: motion::energy_error(&self.body, &self.start, state).abs(),
            momentum_error: motion::momentum_error(&self.start, state),
            orthogonality_error: so3::orthogonality_error(state.world_from_body),
        }
    }

    /// The state that a method reaches at a time in so many steps of equal length.
    ///
    /// # Errors
    /// See [`MethodError`].
    pub fn run(&self, method: &'static Method, time: f64, steps: u64) -> Result<State, MethodError> {
        let mut integration = Integration::new(method, &self.body, self.start, time / steps as f64);
        integration.advance(i64::try_from(steps).unwrap_or(i64::MAX))?;
        Ok(integration.state())
    }

    /// An integration of this motion that has taken one step: whatever it prepares on its first step is done.
    #[must_use]
    pub fn warm(&self, method: &'static Method, step: f64) -> Integration {
        let mut integration = Integration::new(method, &self.body, self.start, step);
        // What it could not do the timed run says.
        let _ = integration.advance(1);
        integration
    }

    /// The largest `|Ω|` of the motion (rad/s), among samples of one period, or of the case's time where that is longer.
    #[must_use]
    pub fn largest_rate(&self) -> f64 {
        const SAMPLES: u32 = 4096;
        let period = flip_period(&self.body, self.start.body_momentum).unwrap_or(0.0);
        let step = period.max(self.time) / f64::from(SAMPLES);
        let rate = |i: u32| so3::norm(self.body.angular_velocity(self.motion.momentum(f64::from(i) * step)));
        (0..SAMPLES).map(rate).fold(self.rate, f64::max)
    }

    /// Numbers of steps in `from..=to` whose step `time/n` is an exact number: with any other the end would be missed
    /// by the rounding of the step, which the best methods can tell.
    pub fn exact_divisions(&self, from: f64, to: f64) -> impl Iterator<Item = u64> {
        let time = self.time;
        (from.ceil().max(1.0) as u64..=to as u64).filter(move |&n| {
            let n = n as f64;
            (time / n).mul_add(n, -time) == 0.0
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reference_table_is_read_and_the_closed_form_agrees_with_it() {
        let cases = reference_cases().unwrap_or_default();
        assert!(cases.len() >= 10);
        let case = cases.iter().find(|case| case.name == "Hairer-Lubich-Wanner");
        let (case, time) = case.map(|case| (case, 30.0)).into_iter().next().unwrap_or((&cases[0], 1.0));
        assert_eq!(case.time, 30.0);
        assert_eq!(case.truth(time).1, Reference::SixtyDigits);
        assert_eq!(case.truth(31.0).1, Reference::ClosedForm);
        assert!(case.errors(time, &case.motion.state(time)).attitude_error < 1e-14);
    }

    #[test]
    fn steps_divide_the_time_exactly() {
        let cases = reference_cases().unwrap_or_default();
        for case in &cases {
            for count in case.exact_divisions(20.0, 40.0) {
                let step = case.time / count as f64;
                assert_eq!(step * count as f64, case.time);
            }
            assert!(case.exact_divisions(20.0, 40.0).next().is_some());
        }
    }
}
