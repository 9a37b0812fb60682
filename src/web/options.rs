//! What the address asks of the page besides the scene: how it looks in another page.

use super::dom;
use crate::scene::Theme;

/// Whether people want less motion.
pub(super) const REDUCED_MOTION: &str = "(prefers-reduced-motion: reduce)";

/// Whether people want it light.
pub(super) const LIGHT: &str = "(prefers-color-scheme: light)";

/// What stands after the `?` of the address.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(clippy::struct_excessive_bools, reason = "each is asked for by itself")]
pub(super) struct Options {
    /// Part of another page: no panel, the strip of time only under a finger or the pointer.
    pub(super) embed: bool,
    /// Whether the panel is shown, where that is said.
    pub(super) panel: Option<bool>,
    /// Dark or light, where that is said.
    pub(super) theme: Option<Theme>,
    /// Whether time runs from the start.
    pub(super) play: bool,
    /// Whether one flip is shown again and again.
    pub(super) loops: bool,
    /// Whether WebGPU is to be tried.
    pub(super) webgpu: bool,
}

impl Options {
    /// Reads the address, and the file's own wishes before it.
    pub(super) fn read() -> Self {
        let root = dom::document().and_then(|document| document.document_element());
        let own = root.and_then(|root| root.get_attribute("data-query")).unwrap_or_default();
        let search = dom::window().and_then(|window| window.location().search().ok()).unwrap_or_default();
        Self::of(&[&own, &search])
    }

    /// Of queries; what is said later counts.
    fn of(queries: &[&str]) -> Self {
        let pairs = || {
            queries.iter().flat_map(|query| query.trim_start_matches('?').split('&')).map(|pair| {
                let (key, value) = pair.split_once('=').unwrap_or((pair, ""));
                (key, value)
            })
        };
        let last = |key: &str| pairs().rfind(|(name, _)| *name == key).map(|(_, value)| value);
        let flag = |key: &str| last(key).map(|value| !matches!(value, "0" | "false" | "off" | "no"));
        Self {
            embed: flag("embed").unwrap_or(false),
            panel: flag("panel"),
            theme: last("theme").and_then(|name| match name {
                "dark" => Some(Theme::Dark),
                "light" => Some(Theme::Light),
                _ => None,
            }),
            play: flag("play").unwrap_or_else(|| !dom::matches(REDUCED_MOTION)),
            loops: flag("loop").unwrap_or(false),
            webgpu: last("renderer") == Some("webgpu"),
        }
    }
}
