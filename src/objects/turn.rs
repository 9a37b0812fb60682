//! One period of M: the solid angle of its path, and how far the body has turned about L when M has come round.

use std::f32::consts::TAU;

use glam::{Vec2, Vec3};

use super::{Context, cloud, labels};
use crate::frame::{Color, Label, Line, Mesh, Note, Pane, Vertex, single};
use crate::physics::period::{Period, period_of};
use crate::physics::{Motion, State, poinsot};

/// Points along the path, and rings of triangles from the axis out to it.
const POINTS: usize = 145;
const RINGS: usize = 12;
/// Radius of the arc on the floor, and of the lines that it begins and ends at.
const ARC: f32 = 0.62;
const REACH: f32 = 0.9;
/// How large the figures are written.
const SIZE: f32 = 17.0;

/// The period of the motion through the state now, where there is one and nothing is lost.
fn period(context: &Context<'_>, pane: &mut Pane) -> Option<Period> {
    context.unit_momentum()?;
    if context.simulation.energy_loss() > 0.0 {
        cloud::caption(pane, context.palette.ink, "with energy loss M never comes back");
        return None;
    }
    let period = period_of(context.simulation.body(), context.simulation.state());
    if period.is_none() {
        note(context, pane, "M does not come round: no period");
    }
    period
}

fn note(context: &Context<'_>, pane: &mut Pane, text: &str) {
    pane.notes.push(Note { text: text.to_owned(), size: SIZE, color: context.palette.ink, swatch: None });
}

/// The part of the sphere that M's path goes round, on M's side.
pub(super) fn solid_angle(context: &Context<'_>, pane: &mut Pane) {
    let Some(period) = period(context, pane) else { return };
    let simulation = context.simulation;
    let path = poinsot::polhode(simulation.body(), context.unit_momentum().unwrap_or_default(), POINTS);
    let axis = context.principal(period.axis);
    let color = context.palette.polhode.alpha(0.3);
    let mut mesh = Mesh::default();
    for momentum in path {
        let rim = context.principal(momentum).normalize_or_zero();
        for ring in 0..=RINGS {
            let position = between(axis, rim, ring as f32 / RINGS as f32);
            mesh.vertices.push(Vertex { position, normal: Vec3::ZERO, color });
        }
    }
    let width = RINGS as u32 + 1;
    for point in 0..POINTS as u32 - 1 {
        for ring in 0..RINGS as u32 {
            let at = point * width + ring;
            mesh.indices.extend([at, at + 1, at + width + 1, at, at + width + 1, at + width]);
        }
    }
    // Which way round the path goes decides which side is outside.
    if period.solid_angle < 0.0 {
        for triangle in mesh.indices.chunks_exact_mut(3) {
            triangle.swap(1, 2);
        }
    }
    pane.meshes.push(mesh);
    let label = Label::new(axis * 1.02, Vec2::new(-0.5, 0.6), "Λ", context.palette.polhode, labels::BORDER);
    pane.labels.push(label);
    let text = format!("solid angle of M's path: Λ = {:.3} sr", period.solid_angle);
    note(context, pane, &text.replace('-', "−"));
}

/// The point of the sphere this part of the way from one to another.
fn between(from: Vec3, to: Vec3, part: f32) -> Vec3 {
    let angle = from.dot(to).clamp(-1.0, 1.0).acos();
    if angle < 1e-4 {
        return from.lerp(to, part).normalize_or(from);
    }
    (from * ((1.0 - part) * angle).sin() + to * (part * angle).sin()) / angle.sin()
}

/// The angle on the floor between where a mark of the body stood at the start and where it stands one period of M later.
pub(super) fn turn(context: &Context<'_>, pane: &mut Pane) {
    let Some(period) = period(context, pane) else { return };
    let simulation = context.simulation;
    let whole = (period.turn / std::f64::consts::TAU).floor();
    let rest = period.turn - whole * std::f64::consts::TAU;
    let motion = Motion::new(simulation.body(), simulation.start());
    let [before, after] = [0.0, period.time].map(|time| motion.state(time));
    let floor = Vec3::new(0.0, 0.0, 0.006 - context.plane_height());
    let axis = flattest(context, &before);
    let [first, second] = [&before, &after].map(|state| floor_direction(context, state, axis));
    let (old, new) = (context.palette.ink.alpha(0.7), context.palette.polhode);
    for (direction, color) in [(first, old), (second, new)] {
        pane.lines.push(Line::new([floor, floor + direction * REACH], 2.6, color).through(0.5));
    }
    let start = first.y.atan2(first.x);
    let arc = |part: f32| floor + (Vec2::from_angle(start + part * rest as f32) * ARC).extend(0.0);
    let steps = 1 + (64.0 * rest as f32 / TAU) as u32;
    pane.lines.push(Line::new((0..=steps).map(|n| arc(n as f32 / steps as f32)), 3.6, new).through(0.5));
    sector(pane, floor, start, rest as f32, context.palette.polhode.alpha(0.18));
    let side = (first + second).truncate();
    pane.labels.push(Label::new(arc(0.5), side, "Δψ", new, labels::FLOOR));
    let marks = [(first, format!("axis {} at first", axis + 1), old), (second, "after T".to_owned(), new)];
    for (direction, text, color) in marks {
        pane.labels.push(Label::new(floor + direction * REACH, direction.truncate(), &text, color, labels::FLOOR));
    }
    note(context, pane, &format!("M comes round in T = {:.3} {}", period.time, context.settings.time_unit.sign()));
    let turns = match whole as i64 {
        0 => String::new(),
        1 => "1 turn and ".to_owned(),
        whole => format!("{whole} turns and "),
    };
    let text = format!("Δψ = 2KT/ℓ − Λ = {turns}{:.1}° about L", rest.to_degrees());
    note(context, pane, &text);
}

/// Where a principal axis, from 0, points in the picture.
fn direction(context: &Context<'_>, state: &State, axis: usize) -> Vec3 {
    context.world_from_body(state) * single(context.simulation.body().body_from_principal().col(axis))
}

/// The principal axis, from 0, that lies flattest.
fn flattest(context: &Context<'_>, state: &State) -> usize {
    let height = |axis: &usize| direction(context, state, *axis).z.abs();
    (0..3).min_by(|a, b| height(a).total_cmp(&height(b))).unwrap_or(0)
}

/// Where an axis points, on the floor.
fn floor_direction(context: &Context<'_>, state: &State, axis: usize) -> Vec3 {
    direction(context, state, axis).truncate().normalize_or(Vec2::X).extend(0.0)
}

/// A part of a disc on the floor.
fn sector(pane: &mut Pane, centre: Vec3, start: f32, angle: f32, color: Color) {
    const SPOKES: u32 = 64;
    let mut mesh = Mesh::default();
    mesh.vertices.push(Vertex { position: centre, normal: Vec3::ZERO, color });
    for spoke in 0..=SPOKES {
        let direction = Vec2::from_angle(start + angle * spoke as f32 / SPOKES as f32) * ARC;
        mesh.vertices.push(Vertex { position: centre + direction.extend(0.0), normal: Vec3::ZERO, color });
    }
    mesh.indices.extend((1..=SPOKES).flat_map(|spoke| [0, spoke, spoke + 1]));
    pane.meshes.push(mesh);
}
