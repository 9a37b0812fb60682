//! The angular momentum L, fixed and up, and the angular velocity ω, whose tip moves in a level plane.

use glam::{Vec2, Vec3};

use super::{Context, arrow};
use crate::frame::{Color, Label, View};

/// Length of L's arrow, a little beyond the plane of ω's tip.
const MOMENTUM_ARROW: f32 = 1.34;
/// Longest arrow that stays in the picture.
const LONGEST: f32 = 1.7;

/// L of the state now: it moves only under the methods that do not keep it.
pub(super) fn momentum(context: &Context<'_>, view: &mut View) {
    let arrow = context.world_momentum(context.simulation.state().world_momentum);
    add(
        view,
        (arrow * MOMENTUM_ARROW).clamp_length_max(LONGEST),
        "L",
        context.palette.momentum,
        Vec2::new(-1.0, 0.3),
        false,
    );
}

/// ω of the state now.
pub(super) fn angular_velocity(context: &Context<'_>, view: &mut View) {
    let simulation = context.simulation;
    let omega = simulation.state().world_angular_velocity(simulation.body());
    let arrow = context.world_angular_velocity(omega).clamp_length_max(LONGEST);
    // On the side of L's arrow where it is: on the right as long as it is near, and over its tip to the left farther on.
    let side = ((arrow.dot(view.camera.axes().0) + 0.12) / 0.08).clamp(-1.0, 1.0);
    let toward = Vec2::new(side, 0.3 + 0.9 * (1.0 - side.abs()));
    add(view, arrow, "ω", context.palette.omega, toward, true);
}

fn add(view: &mut View, to: Vec3, name: &str, color: Color, toward: Vec2, moves: bool) {
    arrow::add(view, Vec3::ZERO, to, color);
    if to.length() > 1e-3 {
        let text = name.to_owned();
        view.labels.push(Label {
            anchor: to,
            toward,
            gap: 10.0,
            text,
            size: 26.0,
            color,
            priority: if moves { 10 } else { 11 },
            moves,
        });
    }
}
