//! The panels on a screen that is held in the hand, or as small as one: the picture first, time below it, all else in a drawer that
//! opens.

use egui::{Align, Frame, Label, Layout, Margin, Panel, RichText, Ui, Vec2};

use super::icons::{Icon, icon_button};
use super::keys::keys_of;
use super::style::FINGER;
use super::{Command, Look, style, timeline, transport};

/// A screen with a side below these (points) is one.
const SMALLEST_DESK: Vec2 = Vec2::new(640.0, 400.0);
/// Part of the height that the drawer takes where the screen stands upright.
const DRAWER: f32 = 0.46;
/// Least part of the height that is kept for the picture.
pub(super) const PICTURE_SHARE: f32 = 0.55;

/// Whether a screen of this size (points) is one.
pub(super) fn is_small(room: Vec2) -> bool {
    room.x < SMALLEST_DESK.x || room.y < SMALLEST_DESK.y
}

/// The strip of time: the scrub bar, and what is used most.
pub(super) fn strip(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let margin = Margin { left: 8, right: 8, top: 2, bottom: 4 };
    let panel = Panel::bottom("time in the hand").frame(Frame::new().inner_margin(margin)).show_separator_line(false);
    panel.show(ui, |ui| strip_inside(ui, look, commands));
}

/// What the strip holds.
pub(super) fn strip_inside(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    timeline::show(ui, look, commands);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        ui.set_height(FINGER);
        let is_paused = look.sim.clock.paused;
        let (play, name) = if is_paused { (Icon::Play, "play") } else { (Icon::Pause, "pause") };
        let flips = look.timeline.first_flip.is_some();
        for (icon, name, state, command, is_there) in [
            (Icon::Menu, "panel", Some(look.shown.panel), Command::TogglePanel, true),
            (Icon::Before, "the step or scene before", None, Command::PreviousStep, true),
            (play, name, Some(!is_paused), Command::PlayPause, true),
            (Icon::Next, "to the next flip", None, Command::NextFlip, flips),
            (Icon::After, "the next step or scene", None, Command::NextStep, true),
        ] {
            let name = keys_of(&command, look.front).map_or(name.to_owned(), |keys| format!("{name} ({keys})"));
            ui.add_enabled_ui(is_there, |ui| {
                if icon_button(ui, icon, &name, FINGER, state).clicked() {
                    commands.push(command);
                }
            });
        }
        let time = format!("{:.2} {}", look.sim.time(), look.time_unit()).replace('-', "−");
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.add(Label::new(RichText::new(time).monospace().size(17.0)).truncate());
        });
    });
}

/// The drawer: from below on a screen that stands upright, from the right on one that lies; what it holds comes from the caller.
pub(super) fn drawer(ui: &mut Ui, room: Vec2, contents: impl FnOnce(&mut Ui)) {
    let frame = Frame::new().inner_margin(Margin { left: 12, right: 6, top: 8, bottom: 4 });
    if room.y > room.x {
        let panel = Panel::bottom("drawer").frame(frame).resizable(false);
        panel.exact_size(DRAWER * room.y).show(ui, contents);
    } else {
        let panel = Panel::right("drawer beside").frame(frame).resizable(false);
        panel.exact_size((style::PANEL_WIDTH + FINGER).min(0.5 * room.x)).show(ui, contents);
    }
}

/// The rest of time, which has no room in the strip.
pub(super) fn time_in_drawer(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    ui.horizontal_wrapped(|ui| {
        for (icon, name, state, command) in [
            (Icon::Restart, "restart", None, Command::Restart),
            (Icon::StepBack, "one step back", None, Command::Step(-1)),
            (Icon::StepOn, "one step on", None, Command::Step(1)),
            (Icon::Reverse, "reverse time", Some(look.sim.clock.speed < 0.0), Command::Reverse),
        ] {
            if icon_button(ui, icon, name, FINGER, state).clicked() {
                commands.push(command);
            }
        }
    });
    transport::flips(ui, look);
    ui.horizontal(|ui| {
        ui.set_height(FINGER);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| transport::speed_row(ui, look, commands));
    });
    ui.horizontal(|ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| transport::where_and_how_slow(ui, look));
    });
}
