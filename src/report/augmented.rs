//! The augmented term of Buss' second-order method: does it help, and with which sign?
//!
//! Three mean velocities of a step, otherwise the same method: `Ω̄ = Ω + h/2 α + s h²/12 α×Ω` with s = 0, +1 (as in
//! Buss' paper) and −1, over many random bodies that start at random.

use glam::{DMat3, DQuat};
use serde::Serialize;

use super::fit::quantile;
use super::random::Random;
use crate::physics::{Body, Motion, State, so3};

/// Angle a step (rad).
const ANGLE: f64 = 0.02;
/// Steps after which the error is looked at: 2, 20 and 200 rad.
const STEPS: [u32; 3] = [100, 1000, 10_000];
/// Seed of the bodies: the same ones each time.
const SEED: u64 = 0x5eed_0fb0_d1e5;

/// The three signs.
pub const VARIANTS: [(&str, f64); 3] =
    [("no augmented term", 0.0), ("Buss' own sign (+)", 1.0), ("opposite sign (−)", -1.0)];

/// The experiment's outcome.
#[derive(Clone, Debug, Serialize)]
pub struct Augmented {
    /// Number of bodies.
    pub bodies: usize,
    /// Angle a step (rad).
    pub angle: f64,
    /// The outcome after a short, a middling and a long time.
    pub horizons: Vec<Horizon>,
    /// What it shows, in words.
    pub words: String,
}

/// The outcome after some steps.
#[derive(Clone, Debug, Serialize)]
pub struct Horizon {
    /// Angle turned (rad).
    pub turned: f64,
    /// The variants, in the order of [`VARIANTS`].
    pub variants: Vec<Variant>,
}

/// One sign of the term.
#[derive(Clone, Debug, Serialize)]
pub struct Variant {
    /// Its name.
    pub name: &'static str,
    /// Median attitude error (rad).
    pub median_error: f64,
    /// Quantiles 0.1, 0.25, 0.5, 0.75 and 0.9 of the error's ratio to plain second order on the same body.
    pub ratio_quantiles: [f64; 5],
    /// Share of the bodies on which it is better than plain second order.
    pub better: f64,
    /// The ratios, ascending.
    #[serde(skip)]
    pub ratios: Vec<f64>,
}

/// Runs the experiment on so many bodies.
#[must_use]
pub fn measure(bodies: usize) -> Augmented {
    let mut random = Random::new(SEED);
    // By horizon and variant, one error a body.
    let mut errors: [[Vec<f64>; 3]; 3] = Default::default();
    let mut count = 0;
    while count < bodies {
        let (body, start) = random.body_in_motion();
        count += 1;
        let step = ANGLE / so3::norm(start.body_angular_velocity(&body));
        let motion = Motion::new(&body, &start);
        for (variant, (_, sign)) in VARIANTS.iter().enumerate() {
            let reached = run(&body, &start, step, *sign);
            for (horizon, (steps, attitude)) in STEPS.iter().zip(reached).enumerate() {
                let truth = motion.attitude(f64::from(*steps) * step);
                errors[horizon][variant].push(so3::angle_between(attitude, truth));
            }
        }
    }
    let horizons: Vec<Horizon> = STEPS
        .iter()
        .zip(&errors)
        .map(|(steps, errors)| Horizon { turned: ANGLE * f64::from(*steps), variants: variants(errors) })
        .collect();
    Augmented { bodies, angle: ANGLE, words: words(&horizons), horizons }
}

fn variants(errors: &[Vec<f64>; 3]) -> Vec<Variant> {
    let variant = |((name, _), own): (&(&'static str, f64), &Vec<f64>)| {
        let mut ratios: Vec<f64> = own.iter().zip(&errors[0]).map(|(own, plain)| own / plain).collect();
        ratios.sort_by(f64::total_cmp);
        Variant {
            name,
            median_error: quantile(own, 0.5),
            ratio_quantiles: [0.1, 0.25, 0.5, 0.75, 0.9].map(|share| quantile(&ratios, share)),
            better: ratios.iter().filter(|ratio| **ratio < 1.0).count() as f64 / own.len().max(1) as f64,
            ratios,
        }
    };
    VARIANTS.iter().zip(errors).map(variant).collect()
}

fn words(horizons: &[Horizon]) -> String {
    let says = |variant: usize| {
        let parts: Vec<String> = horizons
            .iter()
            .map(|horizon| {
                let variant = &horizon.variants[variant];
                let median = variant.ratio_quantiles[2];
                let (factor, how) = if median >= 1.0 { (median, "larger") } else { (1.0 / median, "smaller") };
                format!(
                    "{factor:.1} times {how} after {:.0} rad (better on {:.0} % of the bodies)",
                    horizon.turned,
                    100.0 * variant.better
                )
            })
            .collect();
        parts.join(", ")
    };
    format!(
        "Against plain second order on the same body, the error is in the median over random bodies: with the augmented term as Buss has it {}; \
         with the opposite sign {}.",
        says(1),
        says(2)
    )
}

/// The attitudes that one sign of the term reaches, from the identity, after each number of [`STEPS`].
fn run(body: &Body, start: &State, step: f64, sign: f64) -> [DMat3; 3] {
    let inverse_moments = body.principal_moments().recip();
    let mut attitude = DQuat::IDENTITY;
    let mut taken = 0;
    STEPS.map(|steps| {
        while taken < steps {
            let momentum = attitude.inverse() * start.world_momentum;
            let velocity = inverse_moments * momentum;
            let acceleration = -inverse_moments * velocity.cross(momentum);
            let mean = velocity + 0.5 * step * acceleration + sign * step * step / 12.0 * acceleration.cross(velocity);
            attitude = (attitude * so3::exp_quaternion(step * mean)).normalize();
            taken += 1;
        }
        DMat3::from_quat(attitude)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_sign_has_second_order_and_the_notes_sign_the_largest_error() {
        let outcome = measure(60);
        let [plain, notes, opposite] = [0, 1, 2].map(|i| outcome.horizons[0].variants[i].median_error);
        // |Ω|h = 0.02 over 2 rad: second order leaves at most (|Ω|h)² for every radian.
        assert!(notes < 0.02 * 0.02 * 2.0 && notes > plain && opposite < plain, "{plain} {notes} {opposite}");
    }
}
