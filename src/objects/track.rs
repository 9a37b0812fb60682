//! The way that M has come since the start.

use glam::Vec3;

use super::Context;
use super::curve::simplified;
use crate::frame::{Line, Pane};

/// A third of a pixel in a picture 2160 pixels high.
const TOLERANCE: f32 = 4e-4;

pub(super) fn draw(context: &Context<'_>, pane: &mut Pane) {
    if context.unit_momentum().is_none() {
        return;
    }
    let momenta = context.simulation.momenta_since_start();
    let points: Vec<Vec3> = momenta.into_iter().map(|momentum| context.body_momentum(momentum)).collect();
    if points.iter().all(|point| point.is_finite()) {
        let color = context.palette.momentum.fade(0.75);
        pane.lines.push(Line::new(simplified(&points, TOLERANCE), 2.0, color).through(0.35));
    }
}
