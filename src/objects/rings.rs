//! The paths of M at other energies, each in the colour of the axis that it circles: rings.

use super::{Context, curve, level_sets};
use crate::frame::{Line, Pane};
use crate::physics::poinsot;

/// Rings round each end of an axis.
pub(super) const RINGS: u32 = 4;
const POINTS: usize = 160;
/// Less than a pixel in a picture 2160 pixels high.
const TOLERANCE: f32 = 6e-4;

pub(super) fn draw(context: &Context<'_>, pane: &mut Pane) {
    let body = context.simulation.body();
    let moments = body.principal_moments();
    // Where two moments are equal the rings are circles about the third axis, and no border parts them.
    if context.unit_momentum().is_none() || !(moments.x < moments.y && moments.y < moments.z) {
        return;
    }
    for (number, momentum) in level_sets::momenta(body, RINGS).enumerate() {
        // In turn round axis 3 and round axis 1.
        let color = context.palette.axes[if number % 2 == 0 { 2 } else { 0 }];
        let path = poinsot::polhode(body, body.body_from_principal() * momentum, POINTS);
        let points: Vec<_> = path.into_iter().map(|m| context.principal(m)).collect();
        let points = curve::simplified(&points, TOLERANCE);
        for sign in [1.0, -1.0] {
            pane.lines.push(Line::new(points.iter().map(|point| point * sign), 2.2, color.alpha(0.85)).through(0.3));
        }
    }
}
