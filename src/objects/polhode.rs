//! The path of M in the body: where the sphere and the ellipsoid meet.

use glam::{Vec2, Vec3};

use super::Context;
use super::curve::simplified;
use crate::frame::{Label, Line, View};
use crate::physics::poinsot;

/// Points of the curve, evenly in arc.
pub(super) const POINTS: usize = 512;
/// A quarter of a pixel in a picture 2160 pixels high.
const TOLERANCE: f32 = 3e-4;

pub(super) fn draw(context: &Context<'_>, view: &mut View) {
    let Some(unit) = context.unit_momentum() else { return };
    let curve = poinsot::polhode(context.simulation.body(), unit, POINTS);
    let points: Vec<Vec3> = curve.into_iter().map(|m| context.principal(m)).collect();
    let (right, up, forward) = view.camera.axes();
    // Well in sight, high and to the right, where neither the separatrix nor the ellipsoid has its name.
    let fitness = |point: Vec3| point.dot(-forward).min(0.5) + 0.5 * point.dot(up) + 0.3 * point.dot(right);
    // A steady spin is a point of the sphere and no line.
    let is_line = points.iter().any(|point| point.distance(points[0]) > 0.05);
    if let Some(&anchor) = points.iter().filter(|_| is_line).max_by(|a, b| fitness(**a).total_cmp(&fitness(**b))) {
        let (text, color) = ("polhode: path of M".to_owned(), context.palette.polhode);
        let toward = Vec2::new(1.0, 0.4);
        view.labels.push(Label { anchor, toward, gap: 12.0, text, size: 19.0, color, priority: 4, moves: false });
    }
    view.lines.push(Line::new(simplified(&points, TOLERANCE), 4.5, context.palette.polhode).through(0.4));
}
