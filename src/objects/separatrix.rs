//! The border between circling axis 1 and circling axis 3: two great circles through the poles of axis 2.

use glam::{Vec2, Vec3};

use super::{Context, labels};
use crate::frame::{Dash, Label, Line, Pane};
use crate::physics::poinsot;

const POINTS: usize = 97;
const DASH: f32 = 0.075;
/// Every so many points the name may stand.
const STEP: usize = 6;
/// How much of a place there looks towards the eye where the name is set.
const NEAR_OUTLINE: f32 = 0.25;

pub(super) fn draw(context: &Context<'_>, pane: &mut Pane) {
    if context.unit_momentum().is_none() {
        return;
    }
    let Some(circles) = poinsot::separatrix(context.simulation.body(), 1.0, POINTS) else { return };
    let color = context.palette.separatrix;
    let (right, up, forward) = pane.camera.axes();
    let outwards = |point: Vec3| Vec2::new(point.dot(right), point.dot(up));
    let mut places: Vec<(f32, Vec3)> = vec![];
    for circle in circles {
        let points: Vec<Vec3> = circle.into_iter().map(|m| context.principal(m)).collect();
        // The label goes where a branch comes near the outline, low and to the left, away from where M mostly is.
        places.extend(points.iter().step_by(STEP).filter(|point| point.dot(forward) < 0.0).map(|&point| {
            let aside = outwards(point);
            (-(point.dot(-forward) - NEAR_OUTLINE).abs() - 0.5 * aside.y - 0.35 * aside.x, point)
        }));
        pane.lines.push(Line::new(points, 2.2, color).dashed(Dash::Dashed(DASH)).through(0.3));
    }
    places.sort_by(|a, b| b.0.total_cmp(&a.0));
    if let Some(((_, on), others)) = places.split_first() {
        let mut label = Label::new(*on, outwards(*on), "border (separatrix)", color, labels::BORDER);
        label.others = others.iter().map(|&(_, on)| (on, outwards(on))).collect();
        pane.labels.push(label);
    }
}
