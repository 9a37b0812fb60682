//! The scenes that can be gone through, and what is open of them.

use std::path::Path;

use crate::scene::{Preset, SceneFile, presets};

/// Endings of pictures that carry a scene.
const PICTURES: [&str; 5] = ["png", "apng", "svg", "pdf", "html"];

/// A scene that can be gone to.
#[derive(Clone, Debug, PartialEq)]
pub struct Slide {
    /// What the command line calls it: a name or a path.
    pub name: String,
    /// Its text, or why it cannot be shown.
    pub file: Result<SceneFile, String>,
}

impl Slide {
    /// What the list of scenes calls it: its title, or else its file.
    #[must_use]
    pub fn title(&self) -> String {
        let title = self.file.as_ref().map_or("", |file| file.title.trim());
        if !title.is_empty() {
            return title.to_owned();
        }
        let stem = Path::new(&self.name).file_stem();
        stem.map_or(self.name.clone().into(), std::ffi::OsStr::to_string_lossy).into_owned()
    }

    /// Whether it is a text that can be written again: a file, not built into the program and no picture.
    #[must_use]
    pub fn is_file(&self) -> bool {
        Path::new(&self.name)
            .extension()
            .is_some_and(|extension| !PICTURES.iter().any(|it| extension.eq_ignore_ascii_case(it)))
    }
}

/// The scenes built into the program.
#[must_use]
pub fn built_in() -> Vec<Slide> {
    let slide =
        |preset: Preset| Slide { name: preset.name.to_owned(), file: preset.read().map_err(|error| error.to_string()) };
    presets().into_iter().map(slide).collect()
}

/// What the open scene came from.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Opened {
    /// As the command line names it: a name or a path.
    pub(super) name: String,
    /// What it is called for people.
    pub(super) title: String,
    /// Its text as it was opened.
    pub(super) file: SceneFile,
    /// The text of the scene of that name, where it is another one: of a scene that has no name of its own.
    pub(super) base: Option<SceneFile>,
    /// Its place in the list, where it is there.
    pub(super) place: Option<usize>,
}
