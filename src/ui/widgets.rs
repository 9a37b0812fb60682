//! The few widgets that the panels are made of.

use std::cell::Cell;

use egui::{Align, Button, DragValue, Label, Layout, Response, RichText, Sense, Slider, Ui, vec2};

use super::Command;
use super::numbers::{read, significant, trimmed};
use crate::objects::{Word, word_of};

/// Width of the labels in front of sliders (points).
const LABEL_WIDTH: f32 = 56.0;
/// Width of the numbers behind them (points).
const VALUE_WIDTH: f32 = 100.0;
/// Most characters that fit there.
const VALUE_CHARACTERS: usize = 12;

/// A label, a slider and a number with its unit, in one line.
#[derive(Clone, Copy, Debug)]
pub(super) struct NumberRow<'a> {
    /// What the number is.
    pub label: &'a str,
    /// The unit, with a space before it where one belongs.
    pub unit: &'a str,
    /// Smallest and largest value of the slider.
    pub range: (f64, f64),
    /// For a logarithmic slider the smallest value above 0.
    pub logarithmic: Option<f64>,
    /// What to know about it.
    pub hint: &'a str,
}

impl NumberRow<'_> {
    /// Adds the row to the panel; the response tells whether the value changed. What is typed and is no number is said to be none;
    /// past the ends of the slider numbers are kept.
    pub(super) fn ui(self, ui: &mut Ui, value: &mut f64, commands: &mut Vec<Command>) -> Response {
        let (low, high) = self.range;
        let unit = if self.unit.is_empty() { String::new() } else { format!(" ({})", self.unit.trim()) };
        let hint = format!("{}{unit}", self.hint);
        ui.horizontal(|ui| {
            let label = ui
                .allocate_ui_with_layout(
                    vec2(LABEL_WIDTH, ui.spacing().interact_size.y),
                    Layout::left_to_right(Align::Center),
                    |ui| {
                        ui.set_min_width(LABEL_WIDTH);
                        ui.label(self.label)
                    },
                )
                .inner;
            ui.spacing_mut().slider_width =
                (ui.available_width() - VALUE_WIDTH - ui.spacing().item_spacing.x).max(40.0);
            // A value from a file may lie outside the slider's range: it stays until the slider is moved.
            let mut slider = Slider::new(value, low..=high).show_value(false).clamping(egui::SliderClamping::Edits);
            if let Some(smallest) = self.logarithmic {
                slider = slider.logarithmic(true).smallest_positive(smallest).smart_aim(true);
            }
            let slid = ui.add(slider).labelled_by(label.id).on_hover_text(&hint);
            let speed = if self.logarithmic.is_some() { value.abs().max(1e-9) * 0.01 } else { (high - low) / 500.0 };
            let before = *value;
            let refused = Cell::new(None);
            let number = DragValue::new(value)
                .update_while_editing(false)
                .speed(speed)
                .suffix(self.unit)
                .custom_formatter(|number, _| fitting(number, self.unit))
                .custom_parser(|text| {
                    let read = read(text, self.unit);
                    refused.set(read.is_none().then(|| text.to_owned()));
                    read
                });
            let mut typed = ui
                .allocate_ui_with_layout(
                    vec2(VALUE_WIDTH, ui.spacing().interact_size.y),
                    Layout::centered_and_justified(egui::Direction::LeftToRight),
                    |ui| {
                        ui.spacing_mut().button_padding.x = 4.0;
                        ui.add(number)
                    },
                )
                .inner
                .labelled_by(label.id)
                .on_hover_text(&hint);
            // A number that was only visited keeps the digits that are not shown.
            if typed.changed() && !typed.dragged() && fitting(*value, self.unit) == fitting(before, self.unit) {
                *value = before;
                typed.flags.remove(egui::response::Flags::CHANGED);
            }
            if let Some(text) = refused.take().filter(|_| typed.lost_focus()) {
                let (label, unit) = (self.label, self.unit.trim());
                commands.push(Command::Say(format!(
                    "“{text}” is no number for {label} ({unit}): write it as 5, 0.5, 1/3, 9.5×10⁻⁵, with a unit if you like"
                )));
            }
            slid | typed
        })
        .inner
    }
}

/// A number with as many digits, four at most, as fit beside the slider with their unit.
fn fitting(number: f64, unit: &str) -> String {
    let room = VALUE_CHARACTERS.saturating_sub(unit.chars().count());
    let written = |digits| trimmed(&significant(number, digits)).to_owned();
    [4, 3, 2].map(written).into_iter().find(|text| text.chars().count() <= room).unwrap_or_else(|| written(1))
}

/// Buttons side by side of which one is chosen; gives the one that was clicked.
pub(super) fn choice<T: Copy + PartialEq>(ui: &mut Ui, chosen: Option<T>, options: &[(T, &str, &str)]) -> Option<T> {
    let mut clicked = None;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let count = options.len().max(1) as f32;
        let width = (ui.available_width() - 4.0 * (count - 1.0)) / count;
        for (value, name, hint) in options {
            let button = Button::selectable(chosen == Some(*value), *name)
                .frame_when_inactive(true)
                .truncate()
                .min_size(vec2(width, 26.0));
            if ui.add(button).on_hover_text(*hint).clicked() {
                clicked = Some(*value);
            }
        }
    });
    clicked
}

/// A word and its sentence.
pub(super) fn explained(word: &Word) -> String {
    format!("{}: {}", word.name, word.about)
}

/// A name that says what its word means, under the pointer and to the keyboard.
pub(super) fn named(ui: &mut Ui, name: RichText) -> Response {
    let Some(word) = word_of(name.text()) else { return ui.label(name) };
    let response = ui.add(Label::new(name).sense(Sense::focusable_noninteractive()));
    let text = explained(word);
    if response.has_focus() {
        response.show_tooltip_text(&text);
    }
    response.on_hover_text(text)
}

/// The heading of a part of the panel, with air above it.
pub(super) fn section(ui: &mut Ui, name: &str) {
    ui.add_space(6.0);
    ui.label(RichText::new(name).strong().size(16.0));
}

/// A small sentence in a soft colour.
pub(super) fn note(ui: &mut Ui, text: impl Into<String>) {
    ui.label(RichText::new(text).small().weak());
}

/// Where the middle of the handle moves, in a row that spans slider and number: it stays within by its own radius.
pub(super) fn slider_track(row: egui::Rect) -> egui::Rect {
    let right = row.right() - VALUE_WIDTH - 8.0;
    egui::Rect::from_min_max(row.min, egui::pos2(right, row.bottom())).shrink2(vec2(row.height() / 2.5, 0.0))
}

#[cfg(test)]
mod tests {
    use super::fitting;

    #[test]
    fn a_number_keeps_within_its_room() {
        assert_eq!(fitting(0.017_014, " kg m²"), "0.017");
        assert_eq!(fitting(17.014, " g m²"), "17.01");
        assert_eq!(fitting(12.34, " rad/s"), "12.34");
        assert_eq!(fitting(0.0, "°"), "0");
    }
}
