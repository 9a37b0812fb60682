//! The path of M in the body: where the sphere and the ellipsoid meet.

use super::Context;
use crate::frame::{Line, View};
use crate::physics::poinsot;

/// Points of the curve, evenly in arc.
pub(super) const POINTS: usize = 256;

pub(super) fn draw(context: &Context<'_>, view: &mut View) {
    let Some(unit) = context.unit_momentum() else { return };
    let curve = poinsot::polhode(context.simulation.body(), unit, POINTS);
    let points = curve.into_iter().map(|m| context.principal(m));
    view.lines.push(Line::new(points, 4.5, context.palette.polhode).through(0.4));
}
