//! The principal axes of momentum space, with their moments, and the poles where they pierce the sphere: steady spins.
//! Stable and unstable ones differ in form.

use glam::{Vec2, Vec3};

use super::{Context, body_axes, labels};
use crate::frame::{Color, Label, LabelStyle, Line, Mark, Marker, Pane};

/// How far the axes stand out of the sphere.
const REACH: f32 = 1.22;
/// What the ends of axes 1, 2, 3 are on the map of the energy.
const HEIGHTS: [&str; 3] = ["summit", "pass", "valley"];

/// The parts of the axes outside the sphere.
pub(super) fn axes(context: &Context<'_>, pane: &mut Pane) {
    for (number, color) in context.palette.axes.into_iter().enumerate() {
        let axis = Vec3::AXES[number];
        for sign in [1.0, -1.0] {
            pane.lines.push(Line::new([axis * sign, axis * sign * REACH], 2.6, color).through(0.25));
        }
        // With its moment or its height it is named there.
        if !context.shows(&super::MOMENTS) && !has_heights(context) {
            let text = body_axes::NUMBERS[number];
            if let Some(up) = named_up(context, number) {
                for (end, is_up) in [(up, true), (-up, false)] {
                    name(pane, axis * end, &body_axes::end_name(context, is_up), color, labels::AXIS);
                }
            } else {
                name(pane, axis, text, color, labels::AXIS);
                // Where the ends of one axis have names, none is left without.
                if context.shows(&super::ENDS) {
                    name(pane, -axis, text, color, labels::AXIS);
                }
            }
        }
    }
}

/// The moments, beside the numbers of the axes.
pub(super) fn moments(context: &Context<'_>, pane: &mut Pane) {
    if !context.shows(&super::AXES) || has_heights(context) {
        return;
    }
    let moments = context.simulation.body().principal_moments();
    for (number, color) in context.palette.axes.into_iter().enumerate() {
        let index = ['₁', '₂', '₃'][number];
        let text = format!("{}: I{index} = {}", number + 1, significant(moments[number]));
        name(pane, Vec3::AXES[number], &text, color, labels::MOMENT);
    }
}

/// What each end is where the energy is taken as a height. Of all momenta of one length those along axis 1 have the most energy and
/// those along axis 3 the least; from axis 2 it rises towards axis 1 and falls towards axis 3.
pub(super) fn heights(context: &Context<'_>, pane: &mut Pane) {
    if !has_heights(context) {
        return;
    }
    for (number, color) in context.palette.axes.into_iter().enumerate() {
        let up = named_up(context, number);
        for sign in [1.0, -1.0] {
            let end = up.map_or_else(String::new, |up| format!(" ({})", body_axes::end_word(sign == up)));
            let text = format!("{}{end}: {}", body_axes::NUMBERS[number], HEIGHTS[number]);
            name(pane, Vec3::AXES[number] * sign, &text, color, labels::MOMENT);
        }
    }
}

/// The sign of the end of an axis that was up at the start, where the ends of that axis have names.
fn named_up(context: &Context<'_>, number: usize) -> Option<f32> {
    let (named, up) = body_axes::up_at_start(context);
    (number == named && context.shows(&super::ENDS)).then_some(up)
}

/// Whether the ends of the axes are named by their heights: where two moments are equal none is a pass.
fn has_heights(context: &Context<'_>) -> bool {
    context.shows(&super::HEIGHTS) && context.unit_momentum().is_some() && are_distinct(context)
}

/// Whether no two moments are equal.
fn are_distinct(context: &Context<'_>) -> bool {
    let moments = context.simulation.body().principal_moments();
    moments.x < moments.y && moments.y < moments.z
}

/// Names an axis at this end.
fn name(pane: &mut Pane, axis: Vec3, text: &str, color: Color, style: LabelStyle) {
    let (right, up, _) = pane.camera.axes();
    let toward = Vec2::new(2.0 * axis.dot(right), axis.dot(up));
    pane.labels.push(Label::new(axis * REACH, toward, text, color, style));
}

/// The steady spins on the sphere.
pub(super) fn poles(context: &Context<'_>, pane: &mut Pane) {
    if context.unit_momentum().is_none() {
        return;
    }
    // Where two moments are equal their axes are no better than those between; none is told apart by stability.
    let distinct = are_distinct(context);
    for (number, color) in context.palette.axes.into_iter().enumerate() {
        let mark = if number == 1 && distinct { Mark::Cross } else { Mark::Disc };
        let size = if mark == Mark::Cross { 19.0 } else { 12.0 };
        for sign in [1.0, -1.0] {
            let position = Vec3::AXES[number] * sign;
            pane.markers.push(Marker {
                position,
                size,
                mark,
                color,
                rim: context.palette.background,
                hidden: 0.35,
                moves: false,
            });
        }
    }
}

/// A whole number set high.
pub(super) fn superscript(number: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let high = |c: char| c.to_digit(10).map_or('⁻', |digit| DIGITS[digit as usize]);
    number.to_string().chars().map(high).collect()
}

/// Three significant digits, without needless zeros.
fn significant(value: f64) -> String {
    let exponent = value.log10().floor();
    if !(-4.0..5.0).contains(&exponent) {
        return format!("{:.2}·10{}", value / 10_f64.powf(exponent), superscript(exponent as i32));
    }
    let places = (2.0 - exponent).max(0.0) as usize;
    let text = format!("{value:.places$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}
