//! What a front end remembers from one time to the next. It never touches a picture.

use serde::{Deserialize, Serialize};

/// The front end's state.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
#[allow(clippy::struct_excessive_bools, reason = "each is remembered by itself")]
pub struct Remembered {
    /// Width and height of the window (points); none the first time.
    pub size: Option<[f64; 2]>,
    /// Whether it filled the screen between the bars.
    pub maximized: bool,
    /// Factor on the size of text.
    pub text_size: f32,
    /// Whether it was in presenter's mode.
    pub presenting: bool,
    /// Whether the panel was shown.
    pub panel: bool,
    /// Whether the scene's text was shown.
    pub slide: bool,
    /// Whether the charts were shown.
    pub charts: bool,
}

impl Default for Remembered {
    fn default() -> Self {
        Self {
            size: None,
            maximized: false,
            text_size: 1.0,
            presenting: false,
            panel: true,
            slide: true,
            charts: false,
        }
    }
}

impl Remembered {
    /// Reads its text (TOML); as if it were the first time where that says nothing sound.
    #[must_use]
    pub fn read(text: &str) -> Self {
        let read: Self = toml::from_str(text).unwrap_or_default();
        let is_sound = read.size.is_none_or(|size| size.iter().all(|side| (200.0..20_000.0).contains(side)))
            && (0.4..=4.0).contains(&read.text_size);
        if is_sound { read } else { Self::default() }
    }

    /// Its text (TOML).
    #[must_use]
    pub fn text(&self) -> String {
        toml::to_string(self).unwrap_or_default()
    }
}
