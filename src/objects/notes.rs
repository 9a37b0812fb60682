//! The words of a pane: from where it is seen, and which method is drawn how.

use super::{Context, Space, body_axes, ghosts};
use crate::frame::{Color, Dash, Mark, Note, Pane, Swatch};
use crate::physics::{poinsot, so3};
use crate::scene::Layout;
use crate::sim::Simulation;

const CAPTION_SIZE: f32 = 20.0;
/// Of the rows of the legend, which may be many.
const LEGEND_SIZE: f32 = 17.0;
/// How far along the vertical an axis points that is upright.
const UPRIGHT: f64 = 0.7;
/// The middle axis, counted from 0.
const MIDDLE: usize = 1;
/// Columns that it mostly has in half a picture, and the height of a row as a part of a pane's.
const COLUMNS: usize = 2;
const ROW_HEIGHT: f32 = 0.04;
/// Most of a pane's height that it is given.
const MOST_OF_A_PANE: f32 = 0.25;

/// Of the world.
pub(super) fn world(context: &Context<'_>, pane: &mut Pane) {
    let others = std::mem::take(&mut pane.notes);
    // L is spoken of where it is seen.
    let words = if context.shows(&super::MOMENTUM) { "seen from the world: L stays" } else { "seen from the world" };
    caption(context, pane, words);
    if context.simulation.energy_loss() > 0.0 {
        let left = 100.0 * (1.0 + context.simulation.energy_error());
        caption(context, pane, &format!("energy is lost: {left:.1} % of K is left"));
    }
    pane.notes.extend(others);
    legend(context, pane);
}

/// What flips and what stays, of a body that does.
pub(super) fn flip(context: &Context<'_>, pane: &mut Pane) {
    let Some(now) = context.unit_momentum().map(|now| context.principal(now)) else { return };
    let (axis, sign) = body_axes::up_at_start(context);
    let flips = poinsot::flip_period_of(&context.scene.body, &context.scene.start).is_some();
    if axis != MIDDLE || !flips || context.simulation.energy_loss() > 0.0 {
        return;
    }
    // L points up, so that M along an axis is how far that axis points up.
    let way = if is_turning_over(context.simulation) {
        "turning over"
    } else if now[axis] * sign > 0.0 {
        "as at the start"
    } else {
        "turned over"
    };
    note(pane, format!("flips: the body – now {way}"), context.palette.axes[axis]);
    let has_arrow = context.shows(&super::MOMENTUM);
    // The caption says it else.
    if !(has_arrow && context.shows(&super::WORLD_NOTES)) {
        let stays = if has_arrow { "stays: the arrow L" } else { "stays: the way round it spins" };
        note(pane, stays.to_owned(), context.palette.ink);
    }
}

/// Whether a body that flips is on its way over: its middle axis points neither up nor down.
#[must_use]
pub fn is_turning_over(simulation: &Simulation) -> bool {
    let body = simulation.body();
    let momentum = simulation.state().body_momentum;
    let along = (body.body_from_principal().transpose() * momentum)[MIDDLE];
    along.abs() <= UPRIGHT * so3::norm(momentum)
}

fn note(pane: &mut Pane, text: String, color: Color) {
    pane.notes.push(Note { text, size: CAPTION_SIZE, color, swatch: None });
}

/// Of momentum space.
pub(super) fn momentum_space(context: &Context<'_>, pane: &mut Pane) {
    let unit = if context.shows(&super::AXES) && context.shows(&super::MOMENTS) {
        " (I\u{a0}in\u{a0}kg\u{a0}m²)"
    } else {
        ""
    };
    let others = std::mem::take(&mut pane.notes);
    caption(context, pane, &format!("seen from the body: L is called M{unit}"));
    pane.notes.extend(others);
    if context.settings.layout == Layout::Body {
        legend(context, pane);
    }
}

/// Height of what is written below the caption as a part of a pane's, about: what is drawn stands under it.
pub(super) fn height(context: &Context<'_>, space: Space) -> f32 {
    let (notes, holds_legend) = match space {
        Space::World => (&super::WORLD_NOTES, true),
        Space::Momentum => (&super::MOMENTUM_NOTES, context.settings.layout == Layout::Body),
    };
    if !context.settings.labels {
        return 0.0;
    }
    let mut rows = 0;
    let ghosts = context.simulation.ghosts().len();
    if ghosts > 0 && holds_legend && context.shows(notes) {
        let columns = if context.scene.view.layout == Layout::Both { COLUMNS } else { 2 * COLUMNS };
        // Larger type leaves room for fewer columns.
        let columns = ((columns as f32 / context.type_scale) as usize).clamp(1, columns);
        rows += (ghosts + 1).div_ceil(columns);
    }
    if space == Space::World {
        // The sphere leaves room enough over it.
        rows += usize::from(context.simulation.energy_loss() > 0.0 && context.shows(notes));
        rows += if context.shows(&super::TURN) { 2 } else { 0 };
    }
    (ROW_HEIGHT * context.type_scale.max(1.0) * rows as f32).min(MOST_OF_A_PANE * context.type_scale.clamp(1.0, 1.6))
}

fn caption(context: &Context<'_>, pane: &mut Pane, text: &str) {
    note(pane, text.to_owned(), context.palette.ink);
}

/// A row a method, the scene's own first.
fn legend(context: &Context<'_>, pane: &mut Pane) {
    let simulation = context.simulation;
    if simulation.ghosts().is_empty() {
        return;
    }
    let rim = context.palette.background;
    let own = Swatch { dash: Dash::Solid, mark: Mark::Disc, color: context.palette.momentum, rim };
    let text = format!("{} (the body)", simulation.main().method().short_label());
    pane.notes.push(Note { text, size: LEGEND_SIZE, color: context.palette.momentum, swatch: Some(own) });
    for ghost in simulation.ghosts() {
        let method = ghost.method();
        let color = ghosts::method_color(method, context.settings.theme);
        let swatch = Swatch { dash: ghosts::dash(method, 140.0), mark: ghosts::mark(method), color, rim };
        pane.notes.push(Note { text: method.short_label().to_owned(), size: LEGEND_SIZE, color, swatch: Some(swatch) });
    }
}
