//! Keys: which are the browser's own, and what the others are to the panels.

use egui::{Event, Key, Modifiers};
use web_sys::KeyboardEvent;

/// Keys that stay the browser's, whatever is held with them.
const OWN: [&str; 6] = ["F3", "F5", "F6", "F7", "F11", "F12"];
/// Letters that with Ctrl (⌘ on a Mac) are the page's; all others are the browser's.
const WITH_CONTROL: [&str; 2] = ["z", "s"];
/// Letters that with it move about in a text and change it.
const IN_TEXT: [&str; 2] = ["a", "y"];

/// What is held of Shift, Ctrl, Alt and ⌘ (Windows' key elsewhere).
pub(super) fn modifiers([shift, ctrl, alt, meta]: [bool; 4]) -> Modifiers {
    let is_mac = is_mac();
    Modifiers { alt, ctrl, shift, mac_cmd: is_mac && meta, command: if is_mac { meta } else { ctrl } }
}

/// Whether ⌘ is what Ctrl is elsewhere.
pub(super) fn is_mac() -> bool {
    let agent = super::dom::window().and_then(|window| window.navigator().user_agent().ok()).unwrap_or_default();
    ["Mac OS", "iPhone", "iPad"].iter().any(|name| agent.contains(name))
}

/// What a key is to the panels; none where it is the browser's.
pub(super) fn key_event(event: &KeyboardEvent, pressed: bool, is_typing: bool) -> Option<Event> {
    let name = event.key();
    let held = modifiers([event.shift_key(), event.ctrl_key(), event.alt_key(), event.meta_key()]);
    // Tab goes on to what can be reached next, out of the page too.
    let is_browsers = OWN.contains(&name.as_str()) || name == "Tab" || held.alt || (event.meta_key() && !held.command);
    let small = name.to_lowercase();
    let is_letter = |letters: &[&str]| letters.contains(&small.as_str());
    let is_command_of_browser =
        held.command && !(is_letter(&WITH_CONTROL) || is_typing && (is_letter(&IN_TEXT) || name.chars().count() > 1));
    if is_browsers || is_command_of_browser {
        return None;
    }
    let key = Key::from_name(&name)?;
    let physical_key = Key::from_name(&event.code());
    Some(Event::Key { key, physical_key, pressed, repeat: event.repeat(), modifiers: held })
}

/// The text that a key types, where it types any.
pub(super) fn text_of(event: &KeyboardEvent) -> Option<String> {
    let name = event.key();
    let is_sign = name.chars().count() == 1 && !event.ctrl_key() && !event.meta_key();
    is_sign.then_some(name)
}
