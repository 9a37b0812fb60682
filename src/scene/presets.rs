//! The scenes built into the program: the files of `assets/scenes/`, one a preset.

use include_dir::{Dir, include_dir};

use super::{SceneError, SceneFile};

static SCENES: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/assets/scenes");

/// The scene of a program that is given none.
pub const DEFAULT_PRESET: &str = "flip";

/// A scene built into the program.
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    /// The file's stem.
    pub name: &'static str,
    /// The file's text.
    pub text: &'static str,
}

impl Preset {
    /// Reads the preset.
    ///
    /// # Errors
    /// None for a file that is in the repository and passed the tests.
    pub fn read(&self) -> Result<SceneFile, SceneError> {
        SceneFile::parse(self.text)
    }
}

/// All files of the folder, in no order.
fn all() -> impl Iterator<Item = Preset> {
    SCENES
        .files()
        .filter_map(|file| Some(Preset { name: file.path().file_stem()?.to_str()?, text: file.contents_utf8()? }))
}

/// All presets, in the order their files give (`order`), then by name.
#[must_use]
pub fn presets() -> Vec<Preset> {
    let mut found: Vec<(i64, Preset)> =
        all().map(|preset| (preset.read().ok().and_then(|scene| scene.order).unwrap_or(i64::MAX), preset)).collect();
    found.sort_by_key(|(order, preset)| (*order, preset.name));
    found.into_iter().map(|(_, preset)| preset).collect()
}

/// The preset of this name.
///
/// # Errors
/// An unknown name, with the nearest known one.
pub fn preset(name: &str) -> Result<Preset, SceneError> {
    all()
        .find(|preset| preset.name == name)
        .ok_or_else(|| SceneError::unknown_name("scene", name, all().map(|preset| preset.name)))
}

#[cfg(test)]
mod tests {
    use super::{DEFAULT_PRESET, preset, presets};

    #[test]
    fn presets_stand_in_their_order_and_are_found_by_name() {
        let presets = presets();
        let order = |index: usize| presets.get(index).and_then(|preset| preset.read().ok()?.order);
        let orders: Vec<_> = (0..presets.len()).map(order).collect();
        assert!(orders.iter().all(Option::is_some) && orders.is_sorted(), "{orders:?}");
        assert_eq!(presets.first().map(|preset| preset.name), Some(DEFAULT_PRESET));
        for known in &presets {
            assert!(preset(known.name).is_ok_and(|found| found.text == known.text && !found.text.is_empty()));
        }
    }

    #[test]
    fn a_scene_that_is_not_there_is_said() {
        for (name, sentence) in [
            ("flop", "scene `flop` is not known: the nearest is `flip`"),
            ("x", "scene `x` is not known: there are axis-1, axis-3, "),
            ("../../etc/passwd", "scene `../../etc/passwd` is not known: there are axis-1, axis-3, "),
        ] {
            let said = preset(name).map_or_else(|error| error.to_string(), |_| "no refusal".to_owned());
            assert!(said.starts_with(sentence), "{said}");
        }
    }
}
