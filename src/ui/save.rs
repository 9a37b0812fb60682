//! The question whether a scene that came from a file is to be written there.

use egui::{Align2, Key, Ui, Window};

use super::Command;

/// The question, over everything. Enter takes the file that is offered, Esc leaves everything as it is.
pub(super) fn show(ui: &Ui, place: &str, commands: &mut Vec<Command>) {
    let answer = Window::new("Save the scene").anchor(Align2::CENTER_CENTER, [0.0, 0.0]).collapsible(false);
    let answer = answer.resizable(false).show(ui.ctx(), |ui| {
        ui.label(format!("It came from {place}."));
        ui.add_space(6.0);
        ui.horizontal(|ui| {
            let over = ui.button("write it there (Enter)").clicked();
            let new = ui.button("a new file (N)").clicked();
            let none = ui.button("cancel (Esc)").clicked();
            let key = |key: Key| ui.input_mut(|input| input.consume_key(egui::Modifiers::NONE, key));
            if over || key(Key::Enter) {
                Some(Command::SaveTo(Some(place.to_owned())))
            } else if new || key(Key::N) {
                Some(Command::SaveTo(None))
            } else {
                (none || key(Key::Escape)).then_some(Command::SaveNothing)
            }
        })
        .inner
    });
    commands.extend(answer.and_then(|answer| answer.inner).flatten());
}
