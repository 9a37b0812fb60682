//! The picture's part of the panel: what is drawn and how, and what to keep of it.

use egui::Ui;

use super::widgets::{choice, section};
use super::{Command, Front, Look, keys};
use crate::objects::{self, Space};
use crate::scene::{Layout, Theme};

/// What is drawn, how it is looked at, and what to keep of it.
pub(super) fn show(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    section(ui, "View");
    let layouts = [
        (Layout::Both, "both", "World and body side by side"),
        (Layout::World, "world", "Seen from the world: the body tumbles, L stays"),
        (Layout::Body, "body", "Seen from the body: momentum space, M moves"),
    ];
    if let Some(layout) = choice(ui, Some(look.scene.view.layout), &layouts) {
        commands.push(Command::SetLayout(layout));
    }
    let themes = [(Theme::Dark, "dark", "For a dark hall"), (Theme::Light, "light", "For bright rooms and print")];
    if choice(ui, Some(look.scene.view.theme), &themes).is_some_and(|theme| theme != look.scene.view.theme) {
        commands.push(Command::ToggleTheme);
    }
    ui.horizontal_wrapped(|ui| {
        for (name, is_on, command) in [
            ("names", look.scene.view.labels, Command::ToggleLabels),
            ("text", look.shown.slide, Command::ToggleSlide),
            ("graphs", look.shown.charts, Command::ToggleCharts),
        ] {
            let mut is_on = is_on;
            if ui.checkbox(&mut is_on, name).on_hover_text(keys::hint_of(&command, look.front)).changed() {
                commands.push(command);
            }
        }
    });
    keep(ui, look, commands);
    if look.scene.view.layout != Layout::Body {
        section(ui, "In the world");
        checkboxes(ui, look, Space::World, commands);
    }
    if look.scene.view.layout != Layout::World {
        section(ui, "In the body");
        checkboxes(ui, look, Space::Momentum, commands);
    }
}

/// What is kept of a scene: its picture, its link, its command, its text.
fn keep(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    ui.add_space(4.0);
    let buttons = [
        ("write picture", Command::Picture { transparent: false }),
        ("transparent", Command::Picture { transparent: true }),
        ("copy link", Command::CopyLink),
        ("copy as command", Command::CopyCommand),
        ("save scene", Command::SaveScene),
        ("undo", Command::Undo),
        ("redo", Command::Redo),
        ("camera home", Command::Home),
        ("keys", Command::ToggleHelp),
    ];
    let (open, screen) = (("open a file", Command::ChooseFile), ("full screen", Command::ToggleFullscreen));
    // To a window files are dropped, and it has a key that fills the screen.
    let pages_own = [open, screen].into_iter().filter(|_| look.front == Front::Page);
    ui.horizontal_wrapped(|ui| {
        for (name, command) in buttons.into_iter().chain(pages_own) {
            if ui.button(name).on_hover_text(keys::hint_of(&command, look.front)).clicked() {
                commands.push(command);
            }
        }
    });
}

/// What can be drawn in a space, what is usually shown first.
fn checkboxes(ui: &mut Ui, look: &Look<'_>, space: Space, commands: &mut Vec<Command>) {
    ui.spacing_mut().item_spacing.y = 3.0;
    let of_space = || objects::OBJECTS.iter().filter(|object| object.space == space);
    for object in of_space().filter(|object| object.shown).chain(of_space().filter(|object| !object.shown)) {
        let mut is_shown = objects::is_shown(object, &look.scene.view);
        if ui.checkbox(&mut is_shown, object.label).on_hover_text(object.name).changed() {
            commands.push(Command::Show { name: object.name, is_shown });
        }
    }
}
