//! The scene as a slide: its title, a few sentences and a question to the class, above the picture.

use egui::accesskit::Role;
use egui::{Button, Color32, CursorIcon, FontId, Frame, Label, Margin, Panel, RichText, Sense, Ui, WidgetInfo, vec2};

use super::keys::keys_of;
use super::{Command, Look, style};
use crate::scene::SceneFile;

/// Sizes of the title and of the words (points).
const TITLE: f32 = 26.0;
const WORDS: f32 = 17.0;
/// Space at the sides, above and below, and between the parts (points).
const SIDE: i8 = 24;
const ABOVE: i8 = 14;
const BELOW: i8 = 12;
const BETWEEN: f32 = 5.0;
/// How strong the words are that may no longer be true.
const FADED: f32 = 0.45;
/// Most signs that are named which no font has.
const MOST_MISSING: usize = 12;

/// The title, the words and the question, where the scene says anything, and only as many of its parts as this height (points) holds.
/// A press on the question opens its answer, for there may be no key to do so.
pub(super) fn show(ui: &mut Ui, look: &Look<'_>, most: f32, commands: &mut Vec<Command>) {
    let file = &look.scene.file;
    let text_color = ui.visuals().text_color();
    // The words speak of the scene as it was opened: changed, it may do something else.
    let faded = if look.is_edited() { FADED } else { 1.0 };
    let accent = style::accent(ui.visuals().dark_mode);
    let at = look.scene.at;
    let title = lines(&file.title_at(at));
    let title = if look.is_edited() && !title.is_empty() { format!("{title} (edited)") } else { title };
    // Where no strip says it.
    let place = look.step_words().filter(|_| !look.shown.panel && !look.shown.presenting);
    let title =
        place.map_or(title.clone(), |place| format!("{title}  ·  {place}").trim_start_matches("  ·  ").to_owned());
    let [title_size, words_size] = [TITLE, WORDS].map(|size| size * look.words_scale());
    // A question may name what the steps have yet to show.
    let question = if file.asks_at(at) || look.shown.answer { lines(&file.question) } else { String::new() };
    let answer = if look.shown.answer { lines(&file.answer) } else { String::new() };
    let parts = [
        (title, title_size, text_color),
        (lines(file.text_at(at)), words_size, text_color.gamma_multiply(faded)),
        (asked(&question, look, style::is_for_fingers(ui)), words_size, accent.gamma_multiply(faded)),
        (answer, words_size, text_color.gamma_multiply(faded)),
        (missing(ui, file), WORDS, style::warning(ui.visuals().dark_mode)),
    ];
    let width = ui.available_width() - 2.0 * f32::from(SIDE);
    let mut height = f32::from(ABOVE) + f32::from(BELOW);
    let fitting = parts.iter().filter(|(text, ..)| !text.is_empty()).take_while(|(text, size, _)| {
        height += BETWEEN + height_of(ui, text, *size, width);
        height <= most
    });
    let fitting: Vec<_> = fitting.collect();
    let is_question = |text: &str| !question.is_empty() && text.starts_with(&question) && has_answer(look);
    if fitting.is_empty() {
        return;
    }
    let margin = Margin { left: SIDE, right: SIDE, top: ABOVE, bottom: BELOW };
    let frame = Frame::new().inner_margin(margin);
    Panel::top("slide").frame(frame).show_separator_line(false).show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = BETWEEN;
        for (text, size, color) in fitting {
            let rich = RichText::new(text).size(*size).color(*color);
            if *size == title_size {
                ui.label(rich.strong());
            } else if is_question(text) {
                let pressed = if style::is_for_fingers(ui) {
                    ui.add(Button::new(rich).frame(false).wrap().min_size(vec2(style::FINGER, style::FINGER)))
                } else {
                    let label = ui.add(Label::new(rich).sense(Sense::click()));
                    label.widget_info(|| WidgetInfo::labeled(Role::Button, true, text));
                    label.on_hover_cursor(CursorIcon::PointingHand)
                };
                if pressed.clicked() {
                    commands.push(Command::ToggleAnswer);
                }
            } else {
                ui.label(rich);
            }
        }
    });
}

/// The question, with what opens its answer where there is one.
fn asked(question: &str, look: &Look<'_>, for_fingers: bool) -> String {
    let keys = keys_of(&Command::ToggleAnswer, look.front).filter(|_| !for_fingers);
    let way = keys.and_then(|keys| keys.split(',').next()).unwrap_or("tap");
    if has_answer(look) && !look.shown.answer && !question.is_empty() {
        format!("{question}  ({way}: the answer)")
    } else {
        question.to_owned()
    }
}

fn has_answer(look: &Look<'_>) -> bool {
    !look.scene.file.answer.trim().is_empty()
}

/// A text with the line breaks that were written, and no space around them.
fn lines(text: &str) -> String {
    text.trim().lines().map(str::trim).collect::<Vec<_>>().join("\n")
}

/// Which signs of a scene's words no font here has, in a sentence; empty where there are none.
fn missing(ui: &Ui, file: &SceneFile) -> String {
    let mut signs: Vec<char> = [&file.title, &file.text, &file.question, &file.answer]
        .into_iter()
        .chain(file.steps.iter().flat_map(|step| [&step.title, &step.text]))
        .flat_map(|text| text.chars())
        .filter(|sign| !sign.is_whitespace() && !sign.is_ascii())
        .collect();
    signs.sort_unstable();
    signs.dedup();
    let font = FontId::proportional(WORDS);
    let is_missing = |sign: &char| !ui.ctx().fonts_mut(|fonts| fonts.has_glyph(&font, *sign));
    let codes: Vec<String> = signs
        .iter()
        .filter(|sign| is_missing(sign))
        .take(MOST_MISSING)
        .map(|sign| format!("U+{:04X}", *sign as u32))
        .collect();
    if codes.is_empty() { codes.concat() } else { format!("No font here has these signs: {}", codes.join(", ")) }
}

/// Height of a text in lines of this width (points).
fn height_of(ui: &Ui, text: &str, size: f32, width: f32) -> f32 {
    let font = FontId::proportional(size);
    ui.painter().layout(text.to_owned(), font, Color32::PLACEHOLDER, width).size().y
}
