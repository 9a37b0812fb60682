//! The border between circling axis 1 and circling axis 3: two great circles through the poles of axis 2.

use glam::{Vec2, Vec3};

use super::{Context, labels};
use crate::frame::{Dash, Label, Line, Pane};
use crate::physics::poinsot;

const POINTS: usize = 97;
const DASH: f32 = 0.075;

pub(super) fn draw(context: &Context<'_>, pane: &mut Pane) {
    if context.unit_momentum().is_none() {
        return;
    }
    let Some(circles) = poinsot::separatrix(context.simulation.body(), 1.0, POINTS) else { return };
    let color = context.palette.separatrix;
    let (right, up, forward) = pane.camera.axes();
    let mut labelled: Option<(f32, Vec3)> = None;
    for circle in circles {
        let points: Vec<Vec3> = circle.into_iter().map(|m| context.principal(m)).collect();
        for &point in &points {
            // The label goes where a branch is well in sight, low and to the left, away from where M mostly is.
            let fitness = point.dot(-forward).min(0.55) - 0.5 * point.dot(up) - 0.35 * point.dot(right);
            if labelled.is_none_or(|(best, _)| fitness > best) {
                labelled = Some((fitness, point));
            }
        }
        pane.lines.push(Line::new(points, 2.2, color).dashed(Dash::Dashed(DASH)).through(0.3));
    }
    if let Some((_, anchor)) = labelled {
        pane.labels.push(Label::new(anchor, Vec2::new(-1.0, -0.6), "border (separatrix)", color, labels::BORDER));
    }
}
