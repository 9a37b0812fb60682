//! The flow of all motions of this momentum: arrowheads that run along the levels of the energy as fast as the motion itself.
//!
//! On each path they are evenly apart in time, so that they crowd where M is slow. They move with the simulated time, by the exact motion.

use glam::{DVec3, Vec3};

use super::{Context, cloud, level_sets};
use crate::frame::{Color, Line, Pane};
use crate::physics::{Body, Motion, State, motion, period, poinsot, so3};

/// Arrowheads on a path that closes.
const HEADS: u32 = 8;
/// Arrowheads on either half of a branch of the separatrix, how far apart in e-folds of the growth there, and how near to its ends the last are seen.
const BRANCH_HEADS: i32 = 3;
const E_FOLDS: f64 = 1.3;
const NEAREST: f32 = 0.05;
/// From the middle of an arrowhead to its tip, to its tail, and to either side.
const TIP: f32 = 0.034;
const TAIL: f32 = 0.026;
const SIDE: f32 = 0.027;

pub(super) fn draw(context: &Context<'_>, pane: &mut Pane) {
    let simulation = context.simulation;
    let (body, start, time) = (simulation.body(), simulation.start(), simulation.time());
    let Some(now) = context.unit_momentum() else { return };
    if simulation.energy_loss() > 0.0 {
        return cloud::knows_no_loss(pane, context.palette.ink, "the flow is drawn without energy loss only");
    }
    let ell = so3::norm(start.body_momentum);
    let quiet = context.palette.ink.alpha(0.75);
    for momentum in level_sets::momenta(body) {
        // The same path round the other end of the axis is run through the other way.
        for sign in [1.0, -1.0] {
            let momentum = body.body_from_principal() * momentum * (sign * ell);
            let state = State::new(body, start.world_from_body, body.angular_velocity(momentum));
            heads(context, pane, &state, time, quiet);
        }
    }
    branches(context, pane, ell, context.palette.separatrix);
    // The path of M itself, of which M is the first: on from where it is now.
    let momentum = now * ell;
    let state = State::new(body, start.world_from_body, body.angular_velocity(momentum));
    if let Some(period) = period::period_of(body, &state) {
        let exact = Motion::new(body, &state);
        for n in 1..HEADS {
            let at = exact.momentum(period.time * f64::from(n) / f64::from(HEADS));
            head(context, pane, body, at, context.palette.polhode, 1.0);
        }
    }
}

/// Those of a path that closes, at a time (s).
fn heads(context: &Context<'_>, pane: &mut Pane, start: &State, time: f64, color: Color) {
    let body = context.simulation.body();
    let Some(period) = period::period_of(body, start) else { return };
    let exact = Motion::new(body, start);
    for n in 0..HEADS {
        let at = exact.momentum(time + period.time * f64::from(n) / f64::from(HEADS));
        head(context, pane, body, at, color, 1.0);
    }
}

/// Those of the separatrix, which come out of one end of the middle axis and creep towards the other.
fn branches(context: &Context<'_>, pane: &mut Pane, ell: f64, color: Color) {
    let body = context.simulation.body();
    let rate = poinsot::growth_rate(body, ell);
    if rate == 0.0 {
        return;
    }
    let spacing = E_FOLDS / rate;
    let first = context.simulation.time().rem_euclid(spacing);
    for n in -BRANCH_HEADS - 1..=BRANCH_HEADS {
        let Some(momenta) = period::separatrix_at(body, ell, first + spacing * f64::from(n)) else { return };
        for momentum in momenta {
            // They fade where they come out and go in.
            let aside = 1.0 - context.body_momentum(momentum).y.abs();
            head(context, pane, body, momentum, color, ((aside - NEAREST) / NEAREST).clamp(0.0, 1.0));
        }
    }
}

/// An arrowhead on the sphere at a momentum, along its rate.
fn head(context: &Context<'_>, pane: &mut Pane, body: &Body, momentum: DVec3, color: Color, strength: f32) {
    let at = context.body_momentum(momentum);
    let along = context.principal(motion::momentum_rate(body, momentum).normalize_or_zero());
    if strength <= 0.0 || along == Vec3::ZERO || !at.is_finite() {
        return;
    }
    let aside = at.cross(along);
    let corners = [aside * SIDE - along * TAIL, along * TIP, aside * -SIDE - along * TAIL];
    let points = corners.map(|corner| (at + corner).normalize());
    pane.lines.push(Line::new(points, 2.4, color.fade(strength)).through(0.3));
}
