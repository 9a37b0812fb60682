//! A hundred thousand turns: what each method keeps, and by what law its errors grow.

use serde::Serialize;

use super::cases::{Case, Errors};
use super::fit::power;
use crate::physics::{Integration, METHODS, Method};

/// Samples a decade of time.
const SAMPLES: f64 = 8.0;
/// Above this error (rad) the attitude is lost, and the law of growth with it.
pub const LOST: f64 = 0.5;
/// Above this relative error an invariant is lost.
pub const INVARIANT_LOST: f64 = 0.1;
/// Fewest samples that a law is fitted to: a decade of time and one more.
const FEWEST_SAMPLES: usize = SAMPLES as usize + 1;
/// An invariant whose error stays below this is kept to round-off.
const ROUND_OFF: f64 = 1e-9;
/// Decades of time at the end over which the law is fitted.
const FITTED_DECADES: f64 = 2.5;
/// Powers of time that have a name.
const LAWS: [(f64, &str); 5] =
    [(0.0, "bounded"), (0.5, "grows as √t"), (1.0, "grows as t"), (1.5, "grows as t^1.5"), (2.0, "grows as t²")];
/// How near a named power a slope must be.
const NEAR: f64 = 0.2;

/// The errors of one method over a long time.
#[derive(Clone, Debug, Serialize)]
pub struct LongRun {
    /// Name of the case.
    pub case: String,
    /// Name of the method.
    pub method: &'static str,
    /// Step (s).
    pub step: f64,
    /// Time and errors.
    pub samples: Vec<LongSample>,
    /// Law of growth of the attitude error.
    pub attitude: Growth,
    /// Law of growth of the energy error.
    pub energy: Growth,
    /// Law of growth of the momentum error.
    pub momentum: Growth,
    /// Law of growth of the distance from a rotation.
    pub orthogonality: Growth,
}

/// The errors at one time.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct LongSample {
    /// Time (s).
    pub t: f64,
    /// Turns since the start.
    pub turns: f64,
    /// The errors.
    #[serde(flatten)]
    pub errors: Errors,
}

/// How an error grows.
#[derive(Clone, Debug, Serialize)]
pub struct Growth {
    /// Fitted power of time; `None` where there is nothing to fit.
    pub power: Option<f64>,
    /// Largest error met.
    pub largest: f64,
    /// In words.
    pub words: String,
}

/// Follows a case with every method to a time (s) with one step (s).
pub fn measure(case: &Case, time: f64, step: f64, mut done: impl FnMut()) -> Vec<LongRun> {
    METHODS
        .iter()
        .map(|method| {
            let samples = samples(case, method, time, step);
            done();
            let growth = |error: fn(&Errors) -> f64, lost: f64| growth(&samples, error, lost);
            LongRun {
                case: case.name.clone(),
                method: method.name,
                step,
                attitude: growth(|errors| errors.attitude_error, LOST),
                energy: growth(|errors| errors.energy_error, INVARIANT_LOST),
                momentum: growth(|errors| errors.momentum_error, INVARIANT_LOST),
                orthogonality: growth(|errors| errors.orthogonality_error, INVARIANT_LOST),
                samples,
            }
        })
        .collect()
}

fn samples(case: &Case, method: &'static Method, time: f64, step: f64) -> Vec<LongSample> {
    let mut integration = Integration::new(method, &case.body, case.start, step);
    let mut samples = Vec::new();
    for at in times(case, method, time, step) {
        let Ok(state) = integration.state_at(at) else { break };
        let errors = case.errors(at, &state);
        if !(errors.attitude_error.is_finite() && errors.energy_error.is_finite()) {
            break;
        }
        samples.push(LongSample { t: at, turns: case.rate * at / std::f64::consts::TAU, errors });
    }
    samples
}

/// Multiples of the step, evenly on a logarithmic scale, with the times of the table among them. The closed form is
/// compared at the times of the table alone: elsewhere it is itself the truth.
fn times(case: &Case, method: &'static Method, time: f64, step: f64) -> Vec<f64> {
    let table = case.sample_times().filter(|at| *at >= 1.0);
    if method.is_direct {
        return table.collect();
    }
    let count = (time.log10() * SAMPLES).ceil();
    let mut times: Vec<f64> = table
        .filter(|at| *at <= time && (at / step).fract() == 0.0)
        .chain((0..=count as u32).map(|i| ((time.ln() * f64::from(i) / count).exp() / step).round() * step))
        .collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

fn growth(samples: &[LongSample], error: fn(&Errors) -> f64, lost: f64) -> Growth {
    let largest = samples.iter().map(|sample| error(&sample.errors)).fold(0.0, f64::max);
    let is_lost = |sample: &&LongSample| error(&sample.errors) >= lost;
    let kept = samples.iter().position(|sample| is_lost(&sample)).unwrap_or(samples.len());
    let end = samples[..kept].last().map_or(0.0, |sample| sample.t);
    let begin = end / 10f64.powf(FITTED_DECADES);
    // What is largest so far: the error's own oscillation is not its growth.
    let mut so_far = 0.0;
    let envelope: Vec<(f64, f64)> = samples[..kept]
        .iter()
        .map(|sample| {
            so_far = error(&sample.errors).max(so_far);
            (sample.t, so_far)
        })
        .filter(|(t, e)| *t >= begin && *e > 0.0)
        .collect();
    let power = if envelope.len() >= FEWEST_SAMPLES { power(&envelope) } else { None };
    let law = power.map(|power| {
        let named = LAWS.iter().find(|(law, _)| (law - power).abs() <= NEAR);
        named.map_or_else(|| format!("grows as t^{power:.1}"), |(_, name)| (*name).to_owned())
    });
    let words = match (law, samples.get(kept)) {
        _ if samples.is_empty() => "no number at all".to_owned(),
        _ if largest == 0.0 => "exactly zero".to_owned(),
        (law, Some(sample)) => {
            let law = law.map(|law| format!("{law}, then ")).unwrap_or_default();
            let turns = sample.turns;
            if turns < 1.0 { format!("{law}lost within a turn") } else { format!("{law}lost after {turns:.0} turns") }
        }
        (Some(law), None) if largest < ROUND_OFF => format!("round-off, {law}"),
        (Some(law), None) => law,
        (None, None) if largest < ROUND_OFF => "round-off".to_owned(),
        (None, None) => "too few samples".to_owned(),
    };
    Growth { power, largest, words }
}
