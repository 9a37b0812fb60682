//! A time that is typed: the field in which it is, and why it is refused.

use egui::text::{CCursor, CCursorRange};
use egui::{Align2, Key, RichText, TextEdit, Ui, Window};

use super::numbers::{read, significant, trimmed};
use super::{Command, Look, style};

/// Width of the field and of what is said about it (points).
const FIELD: f32 = 130.0;
const SENTENCE: f32 = 330.0;
/// How far above the foot of the window it stands (points).
const ABOVE: f32 = 112.0;

/// What is typed so far.
#[derive(Clone, Debug, Default)]
pub(super) struct TimeField {
    text: Option<String>,
    refused: Option<String>,
}

impl TimeField {
    /// The field over the strip of time. Enter goes to the time, Esc leaves it as it is.
    pub(super) fn ui(&mut self, ui: &Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
        let unit = look.time_unit();
        let is_new = self.text.is_none();
        let text = self.text.get_or_insert_with(|| trimmed(&significant(look.sim.time(), 6)).to_owned());
        let window = Window::new("Go to a time").anchor(Align2::CENTER_BOTTOM, [0.0, -ABOVE]);
        window.collapsible(false).resizable(false).show(ui.ctx(), |ui| {
            let mut go = false;
            let mut cancel = ui.input(|input| input.key_pressed(Key::Escape));
            ui.horizontal(|ui| {
                let label = ui.label(format!("time ({unit})"));
                let mut field = TextEdit::singleline(text).desired_width(FIELD).show(ui);
                let field_response = field.response.response.labelled_by(label.id);
                if is_new {
                    field_response.request_focus();
                    let all = CCursorRange::two(CCursor::new(0), CCursor::new(text.chars().count()));
                    field.state.cursor.set_char_range(Some(all));
                    field.state.store(ui.ctx(), field_response.id);
                }
                go |= field_response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
                go |= ui.button("go (Enter)").clicked();
                cancel |= ui.button("cancel (Esc)").clicked();
                if go && read(text, unit).is_none() {
                    // To be mended at once.
                    field_response.request_focus();
                }
            });
            if cancel {
                commands.push(Command::AskNothing);
            } else if go {
                match read(text, unit) {
                    Some(time) => commands.push(Command::GoTo(time)),
                    None => self.refused = Some(refusal(text, unit)),
                }
            }
            if let Some(why) = &self.refused {
                ui.set_max_width(SENTENCE);
                ui.label(RichText::new(why).color(style::warning(ui.visuals().dark_mode)));
            }
        });
    }
}

/// Why a text is none.
fn refusal(text: &str, unit: &str) -> String {
    format!("“{}” is no time: write 2.5 (in {unit}), 1/3, 2×10³, or a unit with it, as in 3 min.", text.trim())
}

#[cfg(test)]
mod tests {
    use super::{read, refusal};

    #[test]
    fn a_time_is_taken_in_any_unit_of_time_and_nothing_else_is() {
        for (text, unit, time) in
            [("2.5", "s", 2.5), ("3 min", "s", 180.0), ("−4", "s", -4.0), ("36 h", "d", 1.5), ("2 d", "s", 172_800.0)]
        {
            assert_eq!(read(text, unit), Some(time), "{text}");
        }
        for text in ["", "soon", "5 mm", "1e999", "NaN", "inf"] {
            assert_eq!(read(text, "s"), None, "{text}");
        }
        assert!(refusal(" soon ", "s").starts_with("“soon” is no time: write 2.5 (in s)"));
    }
}
