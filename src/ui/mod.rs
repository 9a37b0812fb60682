//! The panels: they read what there is and return the [`Command`]s that the user gave.

mod body;
mod charts;
mod command;
mod hand;
mod help;
mod icons;
pub mod keys;
mod look;
mod method;
pub mod numbers;
mod picture;
mod presenter;
mod readouts;
mod save;
mod slide;
mod spin;
pub mod style;
mod time_field;
mod timeline;
mod transport;
mod viewport;
mod widgets;

use egui::{ComboBox, Frame, Margin, Panel, Rect, RichText, ScrollArea, Ui};

pub use command::{Command, Pixels};
pub use keys::path_in;
pub use look::{Front, Look, Preview, Shown};
pub use presenter::LARGER;
pub use spin::Spin;
pub use timeline::Timeline;
pub use transport::SPEED_POWERS;

/// What came of showing the panels.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// What the user asked for.
    pub commands: Vec<Command>,
    /// Where the picture is (points).
    pub picture: Rect,
}

/// The parts of the panel: few enough things at a time that what is used most need not be scrolled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Tab {
    #[default]
    Motion,
    Methods,
    Picture,
}

/// Width of a window (points) below which the strip of time goes below the panel.
const NARROW: f32 = 900.0;
/// Least part of the window's height that is kept for the picture.
const PICTURE_SHARE: f32 = 0.45;
/// Least and usual height of the charts (points).
const CHARTS_HEIGHT: (f32, f32) = (110.0, 190.0);

/// All panels.
#[derive(Clone, Debug, Default)]
pub struct Panels {
    charts: charts::Charts,
    viewport: viewport::Viewport,
    time_field: time_field::TimeField,
    tab: Tab,
    /// Whether the keyboard's focus is to move into the panel.
    focus_wanted: bool,
    /// What had it last.
    last_focus: Option<egui::Id>,
    /// When the pointer was last at work on a part of another page, or a finger (s), and whether it is over the strip of time there.
    last_pointer: Option<f64>,
    strip_is_hovered: bool,
}

impl Panels {
    /// Lets the panel take the keyboard's focus when it is next shown.
    pub fn take_focus(&mut self) {
        self.focus_wanted = true;
    }

    /// Shows everything around and over the picture. The ground of the panels is the colour the window is cleared to: to
    /// paint it once more would be dear where there is no GPU.
    pub fn ui(&mut self, ui: &mut Ui, look: &Look<'_>) -> Outcome {
        let mut commands = Vec::new();
        let room = ui.available_size();
        let in_hand = hand::is_small(room);
        let is_part = look.shown.embedded && !look.shown.panel;
        if look.shown.presenting && !is_part {
            presenter::strip(ui, look, &mut commands);
        } else if in_hand && !is_part {
            hand::strip(ui, look, &mut commands);
            if look.shown.panel {
                hand::drawer(ui, room, |ui| self.drawer(ui, look, &mut commands));
            }
        } else if look.shown.panel {
            // In a narrow window the strip of time has the whole width.
            if room.x < NARROW {
                transport_ui(ui, look, &mut commands);
                self.panel(ui, look, &mut commands);
            } else {
                self.panel(ui, look, &mut commands);
                transport_ui(ui, look, &mut commands);
            }
        }
        // The picture comes first: what stands above and below it gives way in a low window.
        let picture = room.y * if in_hand { hand::PICTURE_SHARE } else { PICTURE_SHARE };
        if look.shown.charts {
            let height = (ui.available_height() - picture).clamp(CHARTS_HEIGHT.0, CHARTS_HEIGHT.1);
            let frame = strip_frame(0);
            let strip = Panel::bottom("charts").frame(frame).show_separator_line(false);
            strip.exact_size(height).show(ui, |ui| self.charts.ui(ui, look, &mut commands));
        }
        if look.shown.slide {
            slide::show(ui, look, ui.available_height() - picture, &mut commands);
        }
        let picture = self.viewport.ui(ui, look, &mut commands);
        if is_part {
            self.part_ui(ui, picture, look, &mut commands);
        }
        if let Some(message) = look.message {
            message_ui(ui, picture, message);
        }
        if look.shown.help {
            help::show(ui, look, &mut commands);
        }
        if look.shown.asking_time {
            self.time_field.ui(ui, look, &mut commands);
        } else {
            self.time_field = time_field::TimeField::default();
        }
        if let Some(place) = &look.shown.saving {
            save::show(ui, place, &mut commands);
        }
        if let Some(focused) = ui.memory(egui::Memory::focused) {
            self.last_focus = Some(focused);
            focus_ring(ui, focused);
        }
        Outcome { commands, picture }
    }

    fn panel(&mut self, ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
        let margin = Margin { left: 18, right: 8, top: 14, bottom: 10 };
        let frame = Frame::new().inner_margin(margin);
        let panel = Panel::right("controls").frame(frame).resizable(false).show_separator_line(false);
        panel.exact_size(style::PANEL_WIDTH).show(ui, |ui| {
            self.controls(ui, look, commands, |_, _| {});
        });
    }

    /// The panel on a small screen, with all of time that has no room in the strip.
    fn drawer(&mut self, ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
        self.controls(ui, look, commands, |ui, commands| hand::time_in_drawer(ui, look, commands));
    }

    /// What the panel holds; on a small screen with more above it.
    fn controls(
        &mut self,
        ui: &mut Ui,
        look: &Look<'_>,
        commands: &mut Vec<Command>,
        above: impl FnOnce(&mut Ui, &mut Vec<Command>),
    ) {
        // Room for the scroll bar, so that nothing moves when it comes.
        ui.set_max_width(ui.available_width() - 10.0);
        let title = scene_picker(ui, look, commands);
        if std::mem::take(&mut self.focus_wanted) {
            // Back to where it was, as after a number typed; else to the beginning.
            let last = self.last_focus.filter(|last| ui.ctx().read_response(*last).is_some());
            ui.memory_mut(|memory| memory.request_focus(last.unwrap_or(title.id)));
        }
        let tabs = [
            (Tab::Motion, "Motion", "The body and how it starts"),
            (Tab::Methods, "Methods", "How the motion is followed, and how well"),
            (Tab::Picture, "Picture", "What is drawn, and pictures and scenes to keep"),
        ];
        if let Some(tab) = widgets::choice(ui, Some(self.tab), &tabs) {
            self.tab = tab;
        }
        // They stay while what is below them scrolls.
        ui.set_max_width(ui.available_width() + 10.0);
        ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            ui.set_max_width(ui.available_width() - 10.0);
            above(ui, commands);
            match self.tab {
                Tab::Motion => {
                    body::show(ui, look, commands);
                    spin::show(ui, look, commands);
                    readouts::motion(ui, look);
                }
                Tab::Methods => {
                    method::show(ui, look, commands);
                    readouts::errors(ui, look);
                }
                Tab::Picture => picture::show(ui, look, commands),
            }
        });
    }
}

impl Panels {
    /// The strip of time over a picture that is part of another page, for as long as someone is at work there.
    fn part_ui(&mut self, ui: &Ui, picture: Rect, look: &Look<'_>, commands: &mut Vec<Command>) {
        let (now, has_pointer, rests) = ui.input(|input| {
            (input.time, input.pointer.has_pointer(), f64::from(input.pointer.time_since_last_movement()))
        });
        // A pointer that lies still is at work on the strip alone: a page is not always told that it went away.
        let is_there = has_pointer && (rests < LINGERS || self.strip_is_hovered);
        if is_there {
            self.last_pointer = Some(if self.strip_is_hovered { now } else { now - rests });
        }
        self.strip_is_hovered = false;
        let Some(left) = self.last_pointer.map(|last| last + LINGERS - now).filter(|left| *left > 0.0) else { return };
        ui.ctx().request_repaint_after_secs(left as f32);
        let area = egui::Area::new(egui::Id::unique("time in another page"))
            .order(egui::Order::Foreground)
            .pivot(egui::Align2::CENTER_BOTTOM)
            .fixed_pos(picture.center_bottom() - egui::vec2(0.0, 8.0));
        let shown = area.show(ui.ctx(), |ui| {
            Frame::window(ui.style()).inner_margin(Margin::symmetric(10, 4)).show(ui, |ui| {
                ui.set_width((picture.width() - 40.0).clamp(200.0, 560.0));
                hand::strip_inside(ui, look, commands);
            });
        });
        self.strip_is_hovered = shown.response.contains_pointer();
    }
}

/// How long (s) the strip stays in another page after the pointer or the finger is gone or lies still.
const LINGERS: f64 = 3.0;

/// The margins of a strip below the picture.
fn strip_frame(bottom: i8) -> Frame {
    Frame::new().inner_margin(Margin { left: 16, right: 16, top: 6, bottom })
}

fn transport_ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let strip = Panel::bottom("transport").frame(strip_frame(4)).show_separator_line(false);
    let row = if transport::is_narrow(ui, ui.available_width() - 32.0) { transport::SECOND_ROW + 6.0 } else { 0.0 };
    // Fingers have a higher bar, and higher buttons below it.
    let more = if style::is_for_fingers(ui) { 8.0 } else { 0.0 };
    strip.exact_size(98.0 + row + more).show(ui, |ui| transport::show(ui, look, commands));
}

fn scene_picker(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) -> egui::Response {
    let title = look.title();
    let text = RichText::new(title).size(18.0).strong();
    let combo =
        ComboBox::from_id_salt("scene").width(ui.available_width()).height(420.0).truncate().selected_text(text);
    let shown = combo.show_ui(ui, |ui| {
        for (index, title) in look.titles.iter().enumerate() {
            if ui.selectable_label(look.open == Some(index), title).clicked() {
                commands.push(Command::OpenScene(index));
            }
        }
    });
    let name = format!("scene: {title}");
    shown.response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::ComboBox, true, &name));
    shown.response
}

/// A ring around what has the keyboard, over whatever colour it has.
fn focus_ring(ui: &Ui, focused: egui::Id) {
    let Some(response) = ui.ctx().read_response(focused) else { return };
    let color = style::warning(ui.visuals().dark_mode);
    let painter = ui.ctx().layer_painter(egui::LayerId::new(egui::Order::Tooltip, egui::Id::unique("focus ring")));
    painter.rect_stroke(response.rect.expand(2.0), 7.0, egui::Stroke::new(2.5, color), egui::StrokeKind::Outside);
}

/// A sentence at the foot of the picture, for a while.
fn message_ui(ui: &Ui, picture: Rect, message: &str) {
    let area = egui::Area::new(egui::Id::unique("message"))
        .order(egui::Order::Foreground)
        .interactable(false)
        .pivot(egui::Align2::CENTER_BOTTOM)
        .fixed_pos(picture.center_bottom() - egui::vec2(0.0, 12.0));
    area.show(ui.ctx(), |ui| {
        let frame = Frame::window(ui.style()).inner_margin(Margin::symmetric(14, 8)).corner_radius(6);
        frame.show(ui, |ui| {
            ui.set_max_width(picture.width() * 0.8);
            ui.label(message);
        });
    });
}
