//! The flow of all motions of this momentum: arrowheads that run along the levels of the energy as fast as the motion itself.
//!
//! On each path they are evenly apart in time, so that they crowd where M is slow. They move with the simulated time, by the exact motion.

use glam::DVec3;

use super::{Context, cloud, level_sets, rings};
use crate::frame::{Color, Line, Pane};
use crate::physics::{Motion, State, motion, period, poinsot, so3};

/// Arrowheads on a path that closes, where it keeps away from the middle axis; and most that there may be.
const HEADS: u32 = 8;
const MOST: f64 = 512.0;
/// How far apart in time they are beside the middle axis at most, in e-folds of the growth there.
const E_FOLDS: f64 = 1.0;
/// How near to an end of the middle axis, as `1 − |cos|`, arrowheads are not seen: so many crowd there. They fade over as much again.
const NEAREST: f32 = 0.015;
/// Momentum that runs slower than this part of the fastest stands still: two moments are equal, and the path is none.
const SLOWEST: f64 = 1e-9;
/// From the middle of an arrowhead to its tip, to its tail, and to either side; and how much larger those of M's own path are.
const TIP: f32 = 0.040;
const TAIL: f32 = 0.031;
const SIDE: f32 = 0.032;
const OWN: f32 = 1.5;
/// Round a small ring they are smaller: this for each unit of its radius, down to the smallest.
const SIZE_OF_RADIUS: f32 = 4.0;
const SMALLEST: f32 = 0.4;

pub(super) fn draw(context: &Context<'_>, pane: &mut Pane) {
    let simulation = context.simulation;
    let (body, start, time) = (simulation.body(), simulation.start(), simulation.time());
    let Some(now) = context.unit_momentum() else { return };
    if simulation.energy_loss() > 0.0 {
        return cloud::caption(pane, context.palette.ink, "the flow is drawn without energy loss only");
    }
    let ell = so3::norm(start.body_momentum);
    let quiet = context.palette.ink.alpha(0.75);
    let state = |momentum: DVec3| State::new(body, start.world_from_body, body.angular_velocity(momentum));
    let paths = if context.shows(&super::RINGS) { rings::RINGS } else { level_sets::PATHS };
    for momentum in level_sets::momenta(body, paths) {
        // The same path round the other end of the axis is run through the other way.
        for sign in [1.0, -1.0] {
            let momentum = body.body_from_principal() * momentum * (sign * ell);
            heads(context, pane, &state(momentum), time, (quiet, 1.0));
        }
    }
    branches(context, pane, ell, context.palette.separatrix);
    // The path of M itself: M runs ahead of the first of them.
    heads(context, pane, &state(now * ell), 0.0, (context.palette.polhode, OWN));
}

/// Those of a path that closes, at a time (s), evenly apart in time.
fn heads(context: &Context<'_>, pane: &mut Pane, start: &State, time: f64, (color, size): (Color, f32)) {
    let body = context.simulation.body();
    let Some(period) = period::period_of(body, start) else { return };
    let exact = Motion::new(body, start);
    let folds = period.time * poinsot::growth_rate(body, so3::norm(start.body_momentum));
    let count = (folds / E_FOLDS).ceil().clamp(f64::from(HEADS), MOST);
    // Half a space on, M itself is not covered by one.
    for n in 0..count as u32 {
        let at = exact.momentum(time + period.time * (f64::from(n) + 0.5) / count);
        let radius = context.principal(period.axis).cross(context.body_momentum(at)).length();
        head(context, pane, at, (color, (radius * SIZE_OF_RADIUS).max(SMALLEST).min(size)));
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
    // From 1 − tanh to NEAREST.
    let each_way = (0.5 * f64::from(2.0 / NEAREST).ln() / E_FOLDS).ceil() as i32;
    for n in -each_way - 1..=each_way {
        let Some(momenta) = period::separatrix_at(body, ell, first + spacing * f64::from(n)) else { return };
        for momentum in momenta {
            head(context, pane, momentum, (color, 1.0));
        }
    }
}

/// An arrowhead on the sphere at a momentum, along its rate, in this colour and so much larger.
fn head(context: &Context<'_>, pane: &mut Pane, momentum: DVec3, (color, size): (Color, f32)) {
    let body = context.simulation.body();
    let (at, rate) = (context.body_momentum(momentum), motion::momentum_rate(body, momentum));
    let moments = body.principal_moments();
    let fastest = momentum.length_squared() * (moments.x.recip() - moments.z.recip());
    let strength = ((1.0 - at.y.abs() - NEAREST) / NEAREST).clamp(0.0, 1.0);
    if strength <= 0.0 || rate.length() <= SLOWEST * fastest || !at.is_finite() {
        return;
    }
    let along = context.principal(rate.normalize_or_zero());
    let aside = at.cross(along);
    let corners = [aside * SIDE - along * TAIL, along * TIP, aside * -SIDE - along * TAIL];
    let points = corners.map(|corner| (at + corner * size).normalize());
    pane.lines.push(Line::new(points, 2.4 * size.max(0.7), color.fade(strength)).through(0.3));
}
