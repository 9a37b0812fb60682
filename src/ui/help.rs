//! The sheet of keys.

use egui::{Align2, Button, Grid, Key, RichText, ScrollArea, Ui, Window};

use super::keys::{BINDINGS, Binding};
use super::widgets::explained;
use super::{Command, Front, Look, style};
use crate::objects::WORDS;

/// Width (points) that two columns take.
const TWO_COLUMNS: f32 = 860.0;
/// Width (points) below which keys and states have no column of their own: a screen in the hand, on which the rows are pressed.
const ONE_COLUMN: f32 = 560.0;
/// Height (points) that the frame takes besides what it holds.
const FRAME: f32 = 96.0;

/// The sheet of keys, over everything.
pub(super) fn show(ui: &Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let mut open = !ui.input(|input| input.key_pressed(Key::Escape));
    let room = ui.ctx().content_rect().size();
    let for_fingers = style::is_for_fingers(ui);
    let window = Window::new("Keys");
    // The cross of a window is too small for a finger.
    let mut is_closed = false;
    let window = if for_fingers { window } else { window.open(&mut open) };
    window.anchor(Align2::CENTER_CENTER, [0.0, 0.0]).collapsible(false).resizable(false).show(ui.ctx(), |ui| {
        is_closed = for_fingers && ui.button("close").clicked();
        let columns = if room.x < TWO_COLUMNS { 1 } else { 2 };
        let close = if for_fingers { style::FINGER + ui.spacing().item_spacing.y } else { 0.0 };
        let most = (room.y - FRAME - close).max(60.0);
        ScrollArea::vertical().max_height(most).min_scrolled_height(most).show(ui, |ui| {
            sheet(ui, look, columns, room.x < ONE_COLUMN, commands);
        });
    });
    if !open || is_closed {
        commands.push(Command::ToggleHelp);
    }
}

fn sheet(ui: &mut Ui, look: &Look<'_>, columns: usize, is_slim: bool, commands: &mut Vec<Command>) {
    let bound: Vec<_> = BINDINGS.iter().filter_map(|row| Some((row, keys(row, look.front)?))).collect();
    let mut press = |ui: &mut Ui, binding: &Binding| {
        // What it does stands at the left also where the place to press is wider.
        let button = Button::new(()).left_text(binding.does).frame(false).min_size(ui.spacing().interact_size);
        if ui.add(button).clicked() {
            commands.push(binding.command.clone());
        }
        if let Some(state) = (binding.state)(look) {
            ui.label(RichText::new(state).weak());
        }
    };
    if is_slim {
        for (binding, _) in &bound {
            ui.horizontal(|ui| press(ui, binding));
        }
        return words_below(ui, look);
    }
    ui.horizontal_top(|ui| {
        for (column, rows) in bound.chunks(bound.len().div_ceil(columns)).enumerate() {
            if column > 0 {
                ui.add_space(24.0);
            }
            Grid::new(("keys", column)).num_columns(3).spacing([14.0, 6.0]).show(ui, |ui| {
                for (binding, keys) in rows {
                    ui.label(RichText::new(*keys).monospace().strong());
                    press(ui, binding);
                    ui.end_row();
                }
            });
        }
    });
    words_below(ui, look);
}

/// The words, and what there is besides keys.
fn words_below(ui: &mut Ui, look: &Look<'_>) {
    ui.separator();
    // As wide as the keys, however long the sentences are.
    let width = ui.min_rect().width();
    ui.scope(|ui| {
        ui.set_max_width(width);
        ui.label(RichText::new("Words").strong());
        for word in WORDS {
            ui.label(explained(word));
        }
    });
    ui.separator();
    for line in words(look.front) {
        ui.label(*line);
    }
}

/// The keys of a row. What has none on a page is there too, to be pressed; but the keyboard's way into the panel is the browser's.
fn keys(row: &Binding, front: Front) -> Option<&'static str> {
    row.keys(front).or_else(|| (front == Front::Page && row.command != Command::FocusPanel).then_some(""))
}

/// What there is besides keys.
fn words(front: Front) -> &'static [&'static str] {
    match front {
        Front::Window => &[
            "Mouse: drag to orbit, right or Shift drag to pan, wheel to zoom; drag M or click its sphere for a new start.",
            "A scene, a picture of one or a folder of scenes: drop it here, or copy it in a file manager and press Ctrl+V.",
            "Keyboard alone: F6, then Tab and Shift+Tab (or arrows) from one to the next, arrows to slide,",
            "digits to type a number, Space or Enter to press, Esc to leave; F6 again comes back to the same place.",
        ],
        Front::Page => &[
            "Mouse: drag to orbit, right or Shift drag to pan, wheel to zoom; drag M or click its sphere for a new start.",
            "Fingers: one turns, two move and zoom; tap the sphere for a new start, hold a finger still to take M along.",
            "A scene: drop its file here, or paste its text or a link; the address is always the link of what is shown.",
            "Keyboard alone: Tab from one to the next, arrows to slide, Space or Enter to press.",
        ],
    }
}
