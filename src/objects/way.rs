//! The way round the body turns, as a bent arrow on the floor: as `ω·L = 2K` is above 0 at all times, it never changes.

use std::f32::consts::TAU;

use glam::{Vec2, Vec3};

use super::{Context, labels};
use crate::frame::{Label, Line, Mesh, Pane, Vertex};

/// Radius of the arrow, within the rim of the floor.
const RADIUS: f32 = 0.68;
/// Where it begins and ends, from the side of the eye on (turns).
const FROM: f32 = -0.17;
const TO: f32 = 0.11;
/// Length and half width of its head.
const HEAD: f32 = 0.15;
const HALF_WIDTH: f32 = 0.075;
const POINTS: u32 = 48;

pub(super) fn draw(context: &Context<'_>, pane: &mut Pane) {
    if context.unit_momentum().is_none() {
        return;
    }
    let color = context.palette.ink;
    let (_, _, forward) = pane.camera.axes();
    let nearest = Vec2::new(-forward.x, -forward.y).normalize_or(Vec2::X);
    let height = -context.plane_height() + 0.002;
    // The momentum points up, so that it is counter-clockwise seen from above.
    let at = |turns: f32, radius: f32| (Vec2::from_angle(turns * TAU).rotate(nearest) * radius).extend(height);
    let arc = (0..=POINTS).map(|n| at(FROM + (TO - FROM) * n as f32 / POINTS as f32, RADIUS));
    pane.lines.push(Line::new(arc, 4.5, color).through(0.3));
    let tip = TO + HEAD / (TAU * RADIUS);
    let corners = [at(TO, RADIUS - HALF_WIDTH), at(TO, RADIUS + HALF_WIDTH), at(tip, RADIUS)];
    let vertices = corners.map(|position| Vertex { position, normal: Vec3::ZERO, color }).to_vec();
    pane.meshes.push(Mesh { opaque: true, vertices, indices: vec![0, 1, 2] });
    let middle = 0.5 * (FROM + TO);
    pane.labels.push(Label::new(at(middle, RADIUS), Vec2::NEG_Y, "spins this way round, always", color, labels::FLOOR));
}
