//! The address: it always holds the scene as it is, and a scene that is gone to is a step that the browser's back takes back.

use wasm_bindgen::JsValue;

use super::dom;
use crate::session::Session;

/// How often (ms) it is brought up to date while time runs, and after a change while it stands: browsers refuse more than some
/// hundred changes in half a minute.
const WHILE_PLAYING: f64 = 1000.0;
const WHILE_STILL: f64 = 300.0;

/// What the address holds.
#[derive(Debug, Default)]
pub(super) struct Address {
    /// The fragment that was written or read last.
    fragment: String,
    /// The title of the scene then.
    title: String,
    /// When it was written (ms).
    written: f64,
    /// The session's revision then.
    revision: Option<u64>,
}

impl Address {
    /// The fragment that the address has now, from its `#` on; empty where there is none.
    pub(super) fn read() -> String {
        dom::window().and_then(|window| window.location().hash().ok()).unwrap_or_default()
    }

    /// Whether the address was changed by someone else since: by hand, or by the browser's back.
    pub(super) fn is_foreign(&self) -> bool {
        Self::read() != self.fragment
    }

    /// Notes a scene that the address led to.
    pub(super) fn follow(&mut self, session: &Session) {
        self.fragment = Self::read();
        session.title().clone_into(&mut self.title);
    }

    /// Writes the scene as it is, where that is due; says after how long (ms) it will be where it is not yet.
    pub(super) fn write(&mut self, session: &Session, now: f64) -> Option<f64> {
        if self.revision == Some(session.revision()) {
            return None;
        }
        let pause = if session.is_playing() { WHILE_PLAYING } else { WHILE_STILL };
        let left = self.written + pause - now;
        if left > 0.0 {
            return Some(left);
        }
        self.write_now(session, now);
        None
    }

    /// The same at once.
    pub(super) fn write_now(&mut self, session: &Session, now: f64) {
        self.revision = Some(session.revision());
        self.written = now;
        let fragment = session.link();
        if fragment == self.fragment {
            return;
        }
        let Some(history) = dom::window().and_then(|window| window.history().ok()) else { return };
        let is_another_scene = !self.title.is_empty() && self.title != session.title();
        let written = if is_another_scene {
            history.push_state_with_url(&JsValue::NULL, "", Some(&fragment))
        } else {
            history.replace_state_with_url(&JsValue::NULL, "", Some(&fragment))
        };
        // Refused where the page is a file, or too often: then it is tried at the next change.
        if written.is_ok() {
            session.title().clone_into(&mut self.title);
            self.fragment = Self::read();
        }
    }
}
