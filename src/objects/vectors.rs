//! The angular momentum L, fixed and up, and the angular velocity ω, whose tip moves in a level plane.

use glam::{Vec2, Vec3};

use super::{Context, arrow, labels};
use crate::frame::{Color, Label, LabelStyle, Pane};

/// Longest arrow that stays in the picture.
const LONGEST: f32 = 1.7;

/// L of the state now: it moves only under the methods that do not keep it.
pub(super) fn momentum(context: &Context<'_>, pane: &mut Pane) {
    let arrow = context.world_momentum(context.simulation.state().world_momentum) * context.momentum_arrow();
    let (color, toward) = (context.palette.momentum, Vec2::new(-1.0, 0.3));
    add(pane, arrow.clamp_length_max(LONGEST), "L", color, toward, labels::FIXED_VECTOR);
}

/// ω of the state now.
pub(super) fn angular_velocity(context: &Context<'_>, pane: &mut Pane) {
    let simulation = context.simulation;
    let omega = simulation.state().world_angular_velocity(simulation.body());
    let arrow = context.world_angular_velocity(omega).clamp_length_max(LONGEST);
    // On the side of L's arrow where it is: on the right as long as it is near, and over its tip to the left farther on.
    let side = ((arrow.dot(pane.camera.axes().0) + 0.12) / 0.08).clamp(-1.0, 1.0);
    let toward = Vec2::new(side, 0.3 + 0.9 * (1.0 - side.abs()));
    add(pane, arrow, "ω", context.palette.omega, toward, labels::VECTOR);
}

fn add(pane: &mut Pane, to: Vec3, name: &str, color: Color, toward: Vec2, style: LabelStyle) {
    arrow::add(pane, Vec3::ZERO, to, color);
    if to.length() > 1e-3 {
        pane.labels.push(Label::new(to, toward, name, color, style));
    }
}
