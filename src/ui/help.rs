//! The sheet of keys.

use egui::{Align2, Grid, Label, RichText, Ui, Window};

use super::keys::BINDINGS;
use super::{Command, Look};

/// Shows it over everything.
pub(super) fn show(ui: &Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let mut open = true;
    Window::new("Keys")
        .open(&mut open)
        .anchor(Align2::CENTER_CENTER, [0.0, 0.0])
        .collapsible(false)
        .resizable(false)
        .show(ui.ctx(), |ui| {
            ui.horizontal_top(|ui| {
                let half = BINDINGS.len().div_ceil(2);
                for (column, rows) in BINDINGS.chunks(half).enumerate() {
                    if column > 0 {
                        ui.add_space(24.0);
                    }
                    Grid::new(("keys", column)).num_columns(3).spacing([14.0, 6.0]).show(ui, |ui| {
                        for binding in rows {
                            ui.label(RichText::new(binding.keys).monospace().strong());
                            ui.add(Label::new(binding.does).extend());
                            ui.label(RichText::new((binding.state)(look).unwrap_or("")).weak());
                            ui.end_row();
                        }
                    });
                }
            });
            ui.separator();
            ui.label(
                "Mouse: drag to orbit, right or Shift drag to pan, wheel to zoom, click the sphere for a new start.",
            );
            ui.label("Keyboard alone: F6, then Tab and Shift+Tab (or arrows) from one to the next, arrows to slide,");
            ui.label("digits to type a number, Space or Enter to press, Esc to leave; F6 again comes back to the same place.");
        });
    if !open {
        commands.push(Command::ToggleHelp);
    }
}
