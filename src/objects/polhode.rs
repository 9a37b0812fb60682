//! The path of M in the body: where the sphere and the ellipsoid meet.

use glam::Vec3;

use super::Context;
use super::curve::simplified;
use crate::frame::{Line, View};
use crate::physics::poinsot;

/// Points of the curve, evenly in arc.
pub(super) const POINTS: usize = 512;
/// A quarter of a pixel in a picture 2160 pixels high.
const TOLERANCE: f32 = 3e-4;

pub(super) fn draw(context: &Context<'_>, view: &mut View) {
    let Some(unit) = context.unit_momentum() else { return };
    let curve = poinsot::polhode(context.simulation.body(), unit, POINTS);
    let points: Vec<Vec3> = curve.into_iter().map(|m| context.principal(m)).collect();
    view.lines.push(Line::new(simplified(&points, TOLERANCE), 4.5, context.palette.polhode).through(0.4));
}
