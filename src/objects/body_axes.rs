//! The principal axes as they turn with the body, and the way of one of them over a faint sphere.

use glam::{Mat3, Vec2, Vec3};

use super::{Context, labels};
use crate::frame::{Color, Label, Line, LinePoint, Pane, Quadric, QuadricPair, single, single_matrix};
use crate::physics::State;

/// Half length of the drawn axes, and radius of the sphere.
const REACH: f32 = 1.12;
const TRAIL_POINTS: u32 = 600;

/// How far the names of the axes stand out of the body.
const STUB: f32 = 0.16;

/// How much of an axis must look towards the eye for its number to be seen whole.
const FACING: f32 = 0.12;

/// How much of an end looks away from the eye where its name begins to fade, and where it is gone.
const BEHIND: std::ops::Range<f32> = 0.4..0.65;

/// What the axes are called.
pub(super) const NUMBERS: [&str; 3] = ["1", "2", "3"];

/// A short piece of each axis out of the body, with its number: which one is which on the momentum sphere. It is the end on
/// the side of the eye, which the body never hides; both ends fade while they change places.
pub(super) fn names(context: &Context<'_>, pane: &mut Pane) {
    // They stand on the body, and the whole axes have their own.
    if !context.shows(&super::BODY) || context.shows(&super::BODY_AXES) {
        return;
    }
    let world_from_principal = world_from_principal(context, context.simulation.state());
    let eye = pane.camera.eye().normalize_or_zero();
    for number in (0..3).filter(|number| !context.shows(&super::ENDS) || *number != started_about(context)) {
        let axis = world_from_principal.col(number);
        let facing = axis.dot(eye);
        let axis = if facing < 0.0 { -axis } else { axis };
        // Not in the colour of the axis, which is that of the face under it.
        let color = context.palette.ink.fade((facing.abs() / FACING).min(1.0));
        // Through a sphere that carries a trail.
        stub(context, pane, axis, NUMBERS[number], color, 0.6);
    }
}

/// Which end of the axis that the body was started about was up at the start, and which one down: seen to change places.
pub(super) fn ends(context: &Context<'_>, pane: &mut Pane) {
    if !context.shows(&super::BODY) || context.shows(&super::BODY_AXES) || context.unit_momentum().is_none() {
        return;
    }
    let (number, sign) = up_at_start(context);
    let axis = world_from_principal(context, context.simulation.state()).col(number) * sign;
    let eye = pane.camera.eye().normalize_or_zero();
    for (axis, is_up) in [(axis, true), (-axis, false)] {
        // Over the body, the name of an end behind it would be read as that of the side in front.
        let seen = 1.0 - (-axis.dot(eye) - BEHIND.start) / (BEHIND.end - BEHIND.start);
        let color = context.palette.ink.fade(seen.clamp(0.0, 1.0));
        stub(context, pane, axis, &end_name(context, is_up), color, 0.15);
    }
}

/// What an end of the axis is called that the body was started about.
pub(super) fn end_name(context: &Context<'_>, is_up: bool) -> String {
    let (number, word) = (NUMBERS[started_about(context)], end_word(is_up));
    if context.shows(&super::AXIS_NAMES) { format!("{number}: {word}") } else { word.to_owned() }
}

/// The same in one word.
pub(super) fn end_word(is_up: bool) -> &'static str {
    if is_up { "top" } else { "bottom" }
}

/// The axis, counted from 0, that most of the momentum was along at the start.
pub(super) fn started_about(context: &Context<'_>) -> usize {
    up_at_start(context).0
}

/// That axis, and the sign of its end that was up then.
pub(super) fn up_at_start(context: &Context<'_>) -> (usize, f32) {
    let momentum = context.body_momentum(context.scene.start.body_momentum);
    let number = momentum.abs().max_position();
    (number, momentum[number].signum())
}

/// A short piece of an axis out of the body, this strong where something hides it.
fn stub(context: &Context<'_>, pane: &mut Pane, axis: Vec3, name: &str, color: Color, hidden: f32) {
    // The body's farthest point along the axis.
    let parts = super::body::placed_parts(context, context.simulation.state());
    let reach = parts.map(|(centre, map, ..)| axis.dot(centre) + (map.transpose() * axis).abs().element_sum());
    let foot = axis * reach.fold(0.0, f32::max);
    if foot.is_finite() {
        named_end(pane, foot, foot + axis * STUB, name, color, hidden);
    }
}

/// A piece of an axis, with its name at the end.
fn named_end(pane: &mut Pane, from: Vec3, end: Vec3, name: &str, color: Color, hidden: f32) {
    let (right, up, _) = pane.camera.axes();
    pane.lines.push(Line::new([from, end], 2.6, color).through(hidden));
    let along = Vec2::new(end.dot(right), end.dot(up)).normalize_or(Vec2::X);
    // Beside the end rather than above it, where L and ω may stand.
    let aside = along.x + 0.8 * (1.0 - along.x.abs());
    // A word is wide: it is set wholly beside.
    let (above, style) = if name.len() > 1 { (0.0, labels::END) } else { (0.5 * along.y, labels::NUMBER) };
    let toward = Vec2::new(aside, above);
    pane.labels.push(Label::new(end, toward, name, color, style));
}

/// The three axes, named at their positive ends.
pub(super) fn axes(context: &Context<'_>, pane: &mut Pane) {
    let world_from_principal = world_from_principal(context, context.simulation.state());
    for (number, color) in context.palette.axes.into_iter().enumerate() {
        let end = world_from_principal.col(number) * REACH;
        named_end(pane, -end, end, NUMBERS[number], color, 0.35);
    }
}

/// The way of the axis that the body was started about.
pub(super) fn trail(context: &Context<'_>, pane: &mut Pane) {
    trail_of(started_about(context), context, pane);
}

/// The way of axis `NUMBER`, counted from 0.
pub(super) fn trail_of_axis<const NUMBER: usize>(context: &Context<'_>, pane: &mut Pane) {
    trail_of(NUMBER, context, pane);
}

/// The way of an axis over the last two flips.
fn trail_of(number: usize, context: &Context<'_>, pane: &mut Pane) {
    if context.unit_momentum().is_none() {
        return;
    }
    let color = context.palette.axes[number];
    let first = Quadric::ellipsoid(Vec3::ZERO, Mat3::IDENTITY, Vec3::splat(REACH), context.palette.ink.alpha(0.035));
    let sphere = QuadricPair::one(first, true);
    // One sphere carries the trails of all axes.
    if !pane.quadrics.contains(&sphere) {
        pane.quadrics.push(sphere);
    }
    let states = context.simulation.around(-2.0 * context.period(), 0.0, TRAIL_POINTS);
    let points = states.iter().rev().enumerate().map(|(n, state)| {
        let position = world_from_principal(context, state).col(number) * REACH;
        LinePoint { position, color: color.fade(1.0 - n as f32 / TRAIL_POINTS as f32) }
    });
    let points: Vec<LinePoint> = points.filter(|point| point.position.is_finite()).collect();
    pane.lines.push(Line { points, ..Line::new([], 2.6, color).through(0.3) });
}

fn world_from_principal(context: &Context<'_>, state: &State) -> Mat3 {
    context.world_from_body(state) * single_matrix(context.simulation.body().body_from_principal())
}

/// The momentum sphere carried along by the body: it rolls along its polhode so that M's tip stays at the fixed L.
pub(super) fn carried_sphere(context: &Context<'_>, pane: &mut Pane) {
    if context.unit_momentum().is_none() {
        return;
    }
    let axes = world_from_principal(context, context.simulation.state());
    let semi_axes = single(super::surfaces::semi_axes(context));
    let first = Quadric::ellipsoid(Vec3::ZERO, axes, Vec3::ONE, context.palette.sphere);
    let second = Quadric::ellipsoid(Vec3::ZERO, axes, semi_axes, context.palette.ellipsoid);
    pane.quadrics.push(QuadricPair::two(first, second, true));
    let mut carried = Pane::new(pane.area, pane.camera, pane.lift);
    super::polhode::draw(context, &mut carried);
    super::tip::tail(context, &mut carried);
    for mut line in carried.lines {
        for point in &mut line.points {
            point.position = axes * point.position;
        }
        pane.lines.push(line);
    }
}
