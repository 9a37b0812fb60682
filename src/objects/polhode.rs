//! The path of M in the body: where the sphere and the ellipsoid meet.

use glam::{Vec2, Vec3};

use super::curve::simplified;
use super::{Context, labels};
use crate::frame::{Label, Line, Pane};
use crate::physics::poinsot;

/// Points of the curve, evenly in arc.
pub(super) const POINTS: usize = 512;
/// Places of it where its name may stand.
const PLACES: usize = 24;
/// A quarter of a pixel in a picture 2160 pixels high.
const TOLERANCE: f32 = 3e-4;

pub(super) fn draw(context: &Context<'_>, pane: &mut Pane) {
    let Some(unit) = context.unit_momentum() else { return };
    let curve = poinsot::polhode(context.simulation.body(), unit, POINTS);
    let points: Vec<Vec3> = curve.into_iter().map(|m| context.principal(m)).collect();
    let (right, up, forward) = pane.camera.axes();
    // Well in sight, high and to the right, where neither the separatrix nor the ellipsoid has its name.
    let fitness = |point: Vec3| point.dot(-forward).min(0.5) + 0.5 * point.dot(up) + 0.3 * point.dot(right);
    // A steady spin is a point of the sphere and no line.
    let is_line = points.iter().any(|point| point.distance(points[0]) > 0.05);
    if let Some(&anchor) = points.iter().filter(|_| is_line).max_by(|a, b| fitness(**a).total_cmp(&fitness(**b))) {
        // Where energy is lost M leaves it at once for the next one.
        let is_left = context.simulation.energy_loss() > 0.0;
        let name = if is_left { "polhode of this energy" } else { "path of M (polhode)" };
        let mut label = Label::new(anchor, Vec2::new(1.0, 0.4), name, context.palette.polhode, labels::PATH);
        // Else outside the loop, where M does not come by.
        let middle = points.iter().sum::<Vec3>() / points.len() as f32;
        let near = points.iter().step_by(POINTS / PLACES).filter(|point| point.dot(forward) < 0.0);
        label.others = near.map(|&on| (on, Vec2::new((on - middle).dot(right), (on - middle).dot(up)))).collect();
        pane.labels.push(label);
    }
    let points = simplified(&points, TOLERANCE);
    // The surfaces cross on the other side too, where M never comes. It is one path of many where others are drawn.
    if is_line && context.shows(&super::ELLIPSOID) && !context.shows(&super::SEPARATRIX) {
        let opposite = points.iter().map(|point| -point);
        pane.lines.push(Line::new(opposite, 2.0, context.palette.polhode.alpha(0.6)).through(0.4));
    }
    pane.lines.push(Line::new(points, 4.5, context.palette.polhode).through(0.4));
}
