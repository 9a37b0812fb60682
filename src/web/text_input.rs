//! The field that is typed in: the panels' own are drawn, and a phone shows its keyboard only for one of the page's.

use std::rc::Rc;

use egui::{Event, Key, Modifiers};
use web_sys::{HtmlElement, HtmlInputElement, InputEvent, KeyboardEvent};

use super::dom;
use super::inbox::{Happening, Inbox};

/// Its id in the page.
const ID: &str = "typed";

/// Passes on what is typed.
pub(super) fn listen(inbox: &Rc<Inbox>) {
    let Some(field) = dom::element::<HtmlInputElement>(ID) else { return };
    let (inbox, own) = (Rc::clone(inbox), field.clone());
    dom::listen(&field, "input", move |event: InputEvent| {
        if event.is_composing() {
            return;
        }
        match event.input_type().as_str() {
            "deleteContentBackward" => press(&inbox, Key::Backspace),
            "deleteContentForward" => press(&inbox, Key::Delete),
            "insertLineBreak" => press(&inbox, Key::Enter),
            _ => {
                let text = own.value().trim_start_matches(FILLER).to_owned();
                if !text.is_empty() {
                    inbox.put(Happening::Event(Event::Text(text)));
                }
            }
        }
        own.set_value(FILLER);
    });
}

/// Something for a phone's keyboard to delete, or it would not tell that it does.
const FILLER: &str = "\u{200b}";

fn press(inbox: &Inbox, key: Key) {
    for pressed in [true, false] {
        let event = Event::Key { key, physical_key: None, pressed, repeat: false, modifiers: Modifiers::NONE };
        inbox.put(Happening::Event(event));
    }
}

/// Shows or hides a phone's keyboard: `at` is where it is typed (CSS pixels), where it is.
pub(super) fn follow(at: Option<[f32; 4]>) {
    let Some(field) = dom::element::<HtmlInputElement>(ID) else { return };
    match at {
        Some([left, top, width, height]) => {
            for (name, value) in [("left", left), ("top", top), ("width", width), ("height", height)] {
                dom::style(&field, name, &format!("{value}px"));
            }
            if !is_typing() {
                field.set_value(FILLER);
                let _ = field.focus();
            }
        }
        None if is_typing() => {
            let _ = field.blur();
        }
        None => {}
    }
}

/// Whether something is typed.
pub(super) fn is_typing() -> bool {
    active().is_some_and(|active| active.id() == ID)
}

/// Whether the page's own control that has the keyboard answers to this key itself.
pub(super) fn control_wants(event: &KeyboardEvent) -> bool {
    let Some(active) = active() else { return false };
    let tag = active.tag_name();
    let is_control = ["BUTTON", "INPUT", "SELECT", "TEXTAREA", "A"].contains(&tag.as_str()) && active.id() != ID;
    let is_its = match event.key().as_str() {
        " " | "Enter" => true,
        "ArrowLeft" | "ArrowRight" | "ArrowUp" | "ArrowDown" | "Home" | "End" => tag != "BUTTON" && tag != "A",
        key => tag == "INPUT" && key.chars().count() == 1 && active.get_attribute("type").as_deref() == Some("text"),
    };
    is_control && is_its
}

/// Takes the keyboard from the page's own controls.
pub(super) fn leave_controls() {
    if let Some(active) = active().filter(|active| active.id() != ID) {
        let _ = active.blur();
    }
}

fn active() -> Option<HtmlElement> {
    use wasm_bindgen::JsCast;
    dom::document()?.active_element()?.dyn_into().ok()
}
