//! The scene as a slide: its title, a few sentences and a question to the class, above the picture.

use egui::{Frame, Margin, Panel, RichText, Ui};

use super::{Look, style};

/// Shows it, where the scene says anything.
pub(super) fn show(ui: &mut Ui, look: &Look<'_>) {
    let file = &look.scene.file;
    let (title, text, question) = (file.title.trim(), file.text.trim(), file.question.trim());
    if title.is_empty() && text.is_empty() && question.is_empty() {
        return;
    }
    let frame = Frame::new().fill(look.ground).inner_margin(Margin { left: 24, right: 24, top: 14, bottom: 12 });
    Panel::top("slide").frame(frame).show_separator_line(false).show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = 5.0;
        if !title.is_empty() {
            ui.label(RichText::new(title).size(26.0).strong());
        }
        if !text.is_empty() {
            // Lines of the file are no lines of the slide.
            let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
            ui.label(RichText::new(text).size(17.0));
        }
        if !question.is_empty() {
            let question = question.split_whitespace().collect::<Vec<_>>().join(" ");
            ui.label(RichText::new(question).size(17.0).color(style::accent(ui.visuals().dark_mode)));
        }
    });
}
