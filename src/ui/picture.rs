//! The picture's part of the panel: what is drawn and how, and what to keep of it.

use egui::Ui;

use super::widgets::{choice, section};
use super::{Command, Item, Look, keys};
use crate::scene::{Layout, Theme};

/// Shows it.
pub(super) fn show(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    section(ui, "View");
    let layouts = [
        (Layout::Both, "both", "World and body side by side"),
        (Layout::World, "world", "Seen from the room: the body tumbles, L stays"),
        (Layout::Body, "body", "Seen from the body: momentum space, M moves"),
    ];
    if let Some(layout) = choice(ui, Some(look.view.layout), &layouts) {
        commands.push(Command::SetLayout(layout));
    }
    let themes = [(Theme::Dark, "dark", "For a dark hall"), (Theme::Light, "light", "For bright rooms and print")];
    if choice(ui, Some(look.view.theme), &themes).is_some_and(|theme| theme != look.view.theme) {
        commands.push(Command::ToggleTheme);
    }
    ui.horizontal_wrapped(|ui| {
        for (name, is_on, command) in [
            ("names", look.view.labels, Command::ToggleLabels),
            ("text", look.shown.slide, Command::ToggleSlide),
            ("graphs", look.shown.charts, Command::ToggleCharts),
        ] {
            let mut is_on = is_on;
            if ui.checkbox(&mut is_on, name).on_hover_text(keys::hint_of(&command)).changed() {
                commands.push(command);
            }
        }
    });
    keep(ui, commands);
    let items = (look.items)(look.view);
    if look.view.layout != Layout::Body {
        section(ui, "In the room");
        checkboxes(ui, items.iter().filter(|item| item.is_of_world), commands);
    }
    if look.view.layout != Layout::World {
        section(ui, "In the body");
        checkboxes(ui, items.iter().filter(|item| !item.is_of_world), commands);
    }
}

/// What is kept of a scene: its picture, its command, its text.
fn keep(ui: &mut Ui, commands: &mut Vec<Command>) {
    ui.add_space(4.0);
    let buttons = [
        ("write picture", Command::Picture { transparent: false }),
        ("copy as command", Command::CopyCommand),
        ("save scene", Command::SaveScene),
        ("camera home", Command::Home),
        ("keys", Command::ToggleHelp),
    ];
    ui.horizontal_wrapped(|ui| {
        for (name, command) in buttons {
            if ui.button(name).on_hover_text(keys::hint_of(&command)).clicked() {
                commands.push(command);
            }
        }
    });
}

fn checkboxes<'a>(ui: &mut Ui, items: impl Iterator<Item = &'a Item>, commands: &mut Vec<Command>) {
    ui.spacing_mut().item_spacing.y = 3.0;
    for item in items {
        let mut is_shown = item.is_shown;
        if ui.checkbox(&mut is_shown, item.label).on_hover_text(item.name).changed() {
            commands.push(Command::Show { name: item.name, is_shown });
        }
    }
}
