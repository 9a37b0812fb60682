//! Presenter's mode: no panel, large words, and a slim strip that says where one is and when the next flip comes.

use egui::accesskit::Role;
use egui::{Align, Layout, Panel, RichText, Sense, Stroke, Ui, WidgetInfo, vec2};

use super::icons::{Icon, icon_button};
use super::{Command, Look, strip_frame, style, transport};

/// How much larger the words are than usual, those of the picture too.
pub const LARGER: f32 = 1.45;
/// Height of the strip and of its words (points).
const HEIGHT: f32 = 38.0;
const WORDS: f32 = 21.0;
/// Radius of the dot of a step, and width that it takes (points).
const DOT: f32 = 5.0;
const DOT_WIDTH: f32 = 20.0;
/// Most steps that have dots: more are only counted.
const MOST_DOTS: usize = 12;

/// Height of the strip where fingers press its buttons (points).
const FINGERS_HEIGHT: f32 = style::FINGER + 14.0;
/// Width (points) of a strip that has room for buttons and all words.
const ALL_WORDS: f32 = 640.0;
/// Size of the words where there is less (points).
const SMALLER_WORDS: f32 = 15.0;

/// The strip: the scene and its step on the left, the next flip on the right.
pub(super) fn strip(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let strip = Panel::bottom("presenter's strip").frame(strip_frame(6)).show_separator_line(false);
    let for_fingers = style::is_for_fingers(ui);
    let is_narrow = ui.available_width() < ALL_WORDS;
    let size = if is_narrow { SMALLER_WORDS } else { WORDS };
    strip.exact_size(if for_fingers { FINGERS_HEIGHT } else { HEIGHT }).show(ui, |ui| {
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            if for_fingers {
                buttons(ui, look, commands);
            } else {
                dots(ui, look, commands);
            }
            if let Some(words) = look.step_words().filter(|_| !(for_fingers && is_narrow)) {
                ui.label(RichText::new(words).size(size));
            }
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let (words, is_soon) = transport::next_flip(look);
                let warning = style::warning(ui.visuals().dark_mode);
                let words = RichText::new(words).size(size).strong();
                ui.label(if is_soon { words.color(warning) } else { words });
                let state = look.slow_words().or_else(|| look.sim.clock.paused.then(|| "paused".to_owned()));
                // Its button says it too.
                if let Some(state) = state.filter(|_| !(for_fingers && is_narrow)) {
                    ui.label(RichText::new(format!("{state}  ·")).size(size).color(warning));
                }
                // The scene's own words say it else.
                if look.shown.slide || (for_fingers && is_narrow) {
                    return;
                }
                ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                    let title = RichText::new(look.title()).size(size).weak();
                    ui.add(egui::Label::new(title).truncate());
                });
            });
        });
    });
}

/// What keys do where there are some: back to the panel, back, on, and time.
fn buttons(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    ui.spacing_mut().item_spacing.x = 6.0;
    let is_paused = look.sim.clock.paused;
    let (play, name) = if is_paused { (Icon::Play, "play") } else { (Icon::Pause, "pause") };
    for (icon, name, state, command) in [
        (Icon::Menu, "leave presenter's mode", None, Command::TogglePresenter),
        (Icon::Before, "the step or scene before", None, Command::PreviousStep),
        (play, name, Some(!is_paused), Command::PlayPause),
        (Icon::After, "the next step or scene", None, Command::NextStep),
    ] {
        if icon_button(ui, icon, name, style::FINGER, state).clicked() {
            commands.push(command);
        }
    }
    ui.spacing_mut().item_spacing.x = 10.0;
}

/// A dot a step, that goes there.
fn dots(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let count = look.scene.file.steps.len();
    if count > MOST_DOTS {
        return;
    }
    let accent = style::accent(ui.visuals().dark_mode);
    let rail = ui.visuals().widgets.inactive.bg_fill;
    ui.spacing_mut().item_spacing.x = 0.0;
    for step in 0..count {
        let (rect, response) = ui.allocate_exact_size(vec2(DOT_WIDTH, ui.available_height()), Sense::click());
        let name = format!("step {} of {count}", step + 1);
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
        let is_here = look.scene.at == Some(step);
        let color = if is_here || response.hovered() { accent } else { rail };
        let radius = if is_here { 1.3 * DOT } else { DOT };
        ui.painter().circle(rect.center(), radius, color, Stroke::NONE);
        if response.clicked() {
            commands.push(Command::GoToStep(step));
        }
    }
    ui.spacing_mut().item_spacing.x = 10.0;
    if count > 0 {
        ui.add_space(4.0);
    }
}
