//! The panels: they read what there is and return the [`Command`]s that the user gave.

mod body;
mod command;
mod help;
mod icons;
pub mod keys;
mod method;
pub mod numbers;
mod readouts;
mod spin;
pub mod style;
mod transport;
mod viewport;
mod widgets;

use egui::{ComboBox, Frame, Margin, Panel, Rect, RichText, ScrollArea, Ui};

pub use command::{Command, Pixels};
pub use spin::Spin;
pub use transport::SPEED_POWERS;

use crate::scene::{Scene, View};
use crate::sim::Simulation;

/// What the panels see.
#[derive(Clone, Copy, Debug)]
pub struct Look<'a> {
    /// The running simulation.
    pub sim: &'a Simulation,
    /// Its scene.
    pub scene: &'a Scene,
    /// How it is looked at.
    pub view: &'a View,
    /// Titles of the scenes that can be gone through.
    pub titles: &'a [String],
    /// Which of them is open, if any.
    pub open: Option<usize>,
    /// Simulated seconds a real second, as measured while playing.
    pub real_time_factor: Option<f64>,
    /// Whether the panel is shown.
    pub panel_shown: bool,
    /// Whether the help sheet is shown.
    pub help_shown: bool,
    /// Whether the window fills the screen.
    pub fullscreen: bool,
    /// A sentence for the user about what was last done or refused.
    pub message: Option<&'a str>,
}

/// What came of showing the panels.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// What the user asked for.
    pub commands: Vec<Command>,
    /// Where the picture is (points).
    pub picture: Rect,
}

/// All panels.
#[derive(Clone, Copy, Debug, Default)]
pub struct Panels {
    /// Whether the keyboard's focus is to move into the panel.
    focus_wanted: bool,
}

impl Panels {
    /// Lets the panel take the keyboard's focus when it is next shown.
    pub fn take_focus(&mut self) {
        self.focus_wanted = true;
    }

    /// Shows everything around and over the picture.
    pub fn ui(&mut self, ui: &mut Ui, look: &Look<'_>) -> Shown {
        let mut commands = Vec::new();
        if look.panel_shown {
            self.panel(ui, look, &mut commands);
            let frame = Frame::new().fill(ui.visuals().panel_fill).inner_margin(Margin::symmetric(16, 6));
            Panel::bottom("transport").frame(frame).show_separator_line(false).exact_size(56.0).show(ui, |ui| {
                transport::show(ui, look, &mut commands);
            });
        }
        let picture = viewport::show(ui, &mut commands);
        if let Some(message) = look.message {
            message_ui(ui, picture, message);
        }
        if look.help_shown {
            help::show(ui, look, &mut commands);
        }
        Shown { commands, picture }
    }

    fn panel(&mut self, ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
        let frame =
            Frame::new().fill(ui.visuals().panel_fill).inner_margin(Margin { left: 18, right: 8, top: 14, bottom: 10 });
        let panel = Panel::right("controls").frame(frame).resizable(false).show_separator_line(false);
        panel.exact_size(style::PANEL_WIDTH).show(ui, |ui| {
            ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
                // Room for the scroll bar, so that nothing moves when it comes.
                ui.set_max_width(ui.available_width() - 10.0);
                let title = scene_picker(ui, look, commands);
                if std::mem::take(&mut self.focus_wanted) {
                    title.request_focus();
                }
                body::show(ui, look, commands);
                spin::show(ui, look, commands);
                method::show(ui, look, commands);
                readouts::show(ui, look);
            });
        });
    }
}

fn scene_picker(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) -> egui::Response {
    let title = look.open.and_then(|open| look.titles.get(open)).map_or(look.scene.file.title.as_str(), String::as_str);
    let text = RichText::new(if title.is_empty() { "Own scene" } else { title }).size(18.0).strong();
    let combo = ComboBox::from_id_salt("scene").width(ui.available_width()).selected_text(text);
    let shown = combo.show_ui(ui, |ui| {
        for (index, title) in look.titles.iter().enumerate() {
            if ui.selectable_label(look.open == Some(index), title).clicked() {
                commands.push(Command::OpenScene(index));
            }
        }
    });
    shown
        .response
        .widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::ComboBox, true, format!("scene: {title}")));
    shown.response
}

/// A sentence at the top of the picture, for a while.
fn message_ui(ui: &Ui, picture: Rect, message: &str) {
    let area = egui::Area::new(egui::Id::unique("message"))
        .order(egui::Order::Foreground)
        .interactable(false)
        .pivot(egui::Align2::CENTER_TOP)
        .fixed_pos(picture.center_top() + egui::vec2(0.0, 14.0));
    area.show(ui.ctx(), |ui| {
        let frame = Frame::window(ui.style()).inner_margin(Margin::symmetric(14, 8)).corner_radius(6);
        frame.show(ui, |ui| {
            ui.set_max_width(picture.width() * 0.8);
            ui.label(message);
        });
    });
}
