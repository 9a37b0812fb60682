//! What the window remembers from one time to the next, where the system keeps such things. It never touches a picture.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use super::files::write_whole;

/// The window's state.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
#[allow(clippy::struct_excessive_bools, reason = "each is remembered by itself")]
pub(super) struct Remembered {
    /// Width and height (points).
    pub(super) size: [f64; 2],
    /// Whether it filled the screen between the bars.
    pub(super) maximized: bool,
    /// Factor on the size of text.
    pub(super) text_size: f32,
    /// Whether the panel was shown.
    pub(super) panel: bool,
    /// Whether the scene's text was shown.
    pub(super) slide: bool,
    /// Whether the charts were shown.
    pub(super) charts: bool,
}

impl Default for Remembered {
    fn default() -> Self {
        Self { size: [1280.0, 720.0], maximized: false, text_size: 1.0, panel: true, slide: true, charts: false }
    }
}

impl Remembered {
    /// Reads it; as if it were the first time where there is nothing to read, or nothing sound.
    pub(super) fn load() -> Self {
        let read: Option<Self> =
            path().and_then(|path| std::fs::read_to_string(path).ok()).and_then(|text| toml::from_str(&text).ok());
        let read = read.unwrap_or_default();
        let is_sound =
            read.size.iter().all(|side| (200.0..20_000.0).contains(side)) && (0.4..=4.0).contains(&read.text_size);
        if is_sound { read } else { Self::default() }
    }

    /// Writes it. Where that cannot be done the next time starts as the first: nobody need be told.
    pub(super) fn save(&self) {
        let Some(path) = path() else { return };
        if let Some(folder) = path.parent()
            && std::fs::create_dir_all(folder).is_ok()
            && let Ok(text) = toml::to_string(self)
        {
            let _ = write_whole(&path, text.as_bytes());
        }
    }
}

/// The file, by the customs of the system.
fn path() -> Option<PathBuf> {
    let from = |name: &str| std::env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from);
    let folder = if cfg!(windows) {
        from("APPDATA")?
    } else if cfg!(target_vendor = "apple") {
        from("HOME")?.join("Library/Application Support")
    } else {
        from("XDG_STATE_HOME").filter(|path| path.is_absolute()).or_else(|| Some(from("HOME")?.join(".local/state")))?
    };
    Some(folder.join("dzhanibekov").join("window.toml"))
}
