//! The tip of M, the momentum as the body sees it, and the way that it has come.

use glam::{Vec2, Vec3};

use super::{Context, arrow, labels};
use crate::frame::{Label, Line, LinePoint, Mark, Marker, Pane};
use crate::physics::poinsot;

/// Points of the tail.
const TAIL_POINTS: u32 = 40;
/// Points of the way on which the names of other things keep clear of M, about evenly in arc.
const WAY_POINTS: usize = 96;

/// M as an arrow, its tip as a ball.
pub(super) fn tip(context: &Context<'_>, pane: &mut Pane) {
    let color = context.palette.momentum;
    let tip = context.body_momentum(context.simulation.state().body_momentum);
    if tip == Vec3::ZERO {
        return;
    }
    arrow::add(pane, Vec3::ZERO, tip * 0.97, color);
    let rim = context.palette.background;
    pane.markers.push(Marker { position: tip, size: 17.0, mark: Mark::Disc, color, rim, hidden: 0.55, moves: true });
    pane.labels.push(Label::new(tip, Vec2::new(0.6, 1.0), "M", color, labels::TIP));
    // Near the border it comes by most names of the map, which are best beside what they name.
    let is_on_a_map = context.shows(&super::SEPARATRIX) && !context.shows(&super::POLHODE);
    if let Some(unit) = context.unit_momentum().filter(|_| !is_on_a_map) {
        let way = poinsot::polhode(context.simulation.body(), unit, WAY_POINTS);
        pane.ways.push(way.into_iter().map(|m| context.principal(m)).collect());
    }
}

/// Where M was a moment ago, fading.
pub(super) fn tail(context: &Context<'_>, pane: &mut Pane) {
    if context.unit_momentum().is_none() {
        return;
    }
    let states = context.simulation.around(-0.22 * context.period(), 0.0, TAIL_POINTS);
    let points = states.iter().rev().enumerate().map(|(n, state)| {
        let part = n as f32 / TAIL_POINTS as f32;
        let color = context.palette.momentum.fade((1.0 - part).powi(2));
        LinePoint { position: context.body_momentum(state.body_momentum), color }
    });
    let points: Vec<LinePoint> = points.filter(|point| point.position.is_finite()).collect();
    pane.lines.push(Line { points, ..Line::new([], 9.0, context.palette.momentum).through(0.4) });
}
