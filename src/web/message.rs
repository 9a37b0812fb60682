//! What other pages ask by `postMessage`, slides and notebooks that show this one: an object with `dzhanibekov: "…"`.
//!
//! | `dzhanibekov` | besides | what it does |
//! |---|---|---|
//! | `"open"` | `link: "#flip?spin.rate=8"` | opens the scene of a link |
//! | `"play"`, `"pause"` | | lets time run, or stops it |
//! | `"goto"` | `time: 2.5` (s) | goes to a time |
//! | `"step"` | `count: 1` | pauses and takes so many steps |
//! | `"next"`, `"previous"` | | the scene's next step or the next scene, or back |
//! | `"state"` | | nothing but the answer |
//!
//! Each is answered to who sent it by `{ dzhanibekov: "is", title, time, playing, link }`; what no row says is not answered. The page
//! around gets the same, with `"ready"` for `"is"`, when the first frame is there. A message can open a scene and move time, which a
//! link can too, and nothing else: so it may come from anywhere.

use wasm_bindgen::{JsCast, JsValue};
use web_sys::{MessageEvent, Window};

use super::dom;
use crate::session::Session;
use crate::ui::Command;

/// The name of the field that says what is asked.
const FIELD: &str = "dzhanibekov";

/// The commands that a message comes to; none where it is no message to this page.
pub(super) fn commands(event: &MessageEvent, is_playing: bool) -> Option<Vec<Command>> {
    let data = event.data();
    let number = |name: &str| dom::property(&data, name).as_f64().filter(|number| number.is_finite());
    let command = match dom::property(&data, FIELD).as_string()?.as_str() {
        "open" => Command::OpenLink(dom::property(&data, "link").as_string()?),
        "play" if is_playing => return Some(vec![]),
        "pause" if !is_playing => return Some(vec![]),
        "play" | "pause" => Command::PlayPause,
        "goto" => Command::GoTo(number("time")?),
        "step" => Command::Step(number("count").unwrap_or(1.0) as i64),
        "next" => Command::NextStep,
        "previous" => Command::PreviousStep,
        "state" => return Some(vec![]),
        _ => return None,
    };
    Some(vec![command])
}

/// Answers a message with how it stands now.
pub(super) fn answer(event: &MessageEvent, session: &Session) {
    // A window of another origin cannot be asked whether it is one, and nothing else sends messages here.
    if let Some(sender) = event.source() {
        send(sender.unchecked_ref::<Window>(), "is", session);
    }
}

/// Tells the page around this one, where there is one, that the first frame is there.
pub(super) fn tell_ready(session: &Session) {
    let Some(window) = dom::window() else { return };
    if let Some(parent) = window.parent().ok().flatten().filter(|parent| *parent != window) {
        send(&parent, "ready", session);
    }
}

fn send(to: &Window, what: &str, session: &Session) {
    let told = js_sys::Object::new();
    for (name, value) in [
        (FIELD, JsValue::from_str(what)),
        ("title", JsValue::from_str(session.title())),
        ("time", JsValue::from_f64(session.time())),
        ("playing", JsValue::from_bool(session.is_playing())),
        ("link", JsValue::from_str(&session.link())),
    ] {
        dom::set_property(&told, name, &value);
    }
    // Nothing in it is secret, and a page from a file has no origin to name.
    let _ = to.post_message(&told, "*");
}
