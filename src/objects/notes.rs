//! The words of a view: from where it is seen, and which method is drawn how.

use super::{Context, ghosts};
use crate::frame::{Dash, Mark, Note, Sample, View};
use crate::scene::Layout;

const CAPTION_SIZE: f32 = 20.0;
/// Of the rows of the legend, which may be many.
const LEGEND_SIZE: f32 = 17.0;

/// Of the world.
pub(super) fn world(context: &Context<'_>, view: &mut View) {
    caption(context, view, "seen from the room: L stays");
    legend(context, view);
}

/// Of momentum space.
pub(super) fn body(context: &Context<'_>, view: &mut View) {
    let axes = context.shows("axes");
    let unit = if axes { " (I\u{a0}in\u{a0}kg\u{a0}m²)" } else { "" };
    caption(context, view, &format!("seen from the body: M is L{unit}"));
    if context.settings.layout == Layout::Body {
        legend(context, view);
    }
}

fn caption(context: &Context<'_>, view: &mut View, text: &str) {
    let color = context.palette.ink;
    view.notes.push(Note { text: text.to_owned(), size: CAPTION_SIZE, color, sample: None });
}

/// A row a method, the scene's own first.
fn legend(context: &Context<'_>, view: &mut View) {
    let simulation = context.simulation;
    if simulation.ghosts().is_empty() {
        return;
    }
    let rim = context.palette.background;
    let own = Sample { dash: Dash::Solid, mark: Mark::Disc, color: context.palette.momentum, rim };
    let text = format!("{} (the body)", simulation.main().method().short_label());
    view.notes.push(Note { text, size: LEGEND_SIZE, color: context.palette.momentum, sample: Some(own) });
    for ghost in simulation.ghosts() {
        let method = ghost.method();
        let color = ghosts::method_color(method, context.settings.theme);
        let sample = Sample { dash: ghosts::dash(method, 140.0), mark: ghosts::mark(method), color, rim };
        view.notes.push(Note { text: method.short_label().to_owned(), size: LEGEND_SIZE, color, sample: Some(sample) });
    }
}
