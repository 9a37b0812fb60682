//! What the window reads and writes: scenes of people's own, pictures, texts.

use std::path::{Path, PathBuf};

use crate::files;
use crate::objects;
use crate::scene::SceneFile;
use crate::session::{Slide, slug};

/// What is said of a file that is held over the window.
pub(super) fn offer(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    format!("Let go to open {name}")
}

/// The scene of a file, or those of a folder in the order of their names; one that cannot be shown says why and leaves the others.
///
/// # Errors
/// A folder that cannot be read or has no scene in it: one sentence.
pub fn read_slides(path: &Path) -> Result<Vec<Slide>, String> {
    let scenes = files::read_scenes(path).map_err(|error| error.to_string())?;
    let checked = scenes.into_iter().map(|(name, file)| {
        let checked = |file: SceneFile| objects::check(&file).map(|_| file);
        let file = file.and_then(|link| checked(link.file)).map_err(|error| error.to_string());
        Slide { name, file }
    });
    Ok(checked.collect())
}

/// The step and the time (s) that a picture shows, where these are what was read of it.
pub(super) fn moment_shown(path: &Path, read: &Result<Vec<Slide>, String>) -> Option<(Option<usize>, f64)> {
    let [Slide { file: Ok(_), .. }] = read.as_deref().ok()? else { return None };
    let link = files::read_scene(path).ok()?;
    Some((link.step, link.time?))
}

/// Writes a new file `title-N.extension` in the working directory, `N` the first number that is free.
pub(super) fn write_new(title: &str, extension: &str, bytes: &[u8]) -> Result<PathBuf, String> {
    files::write_new(Path::new(""), &slug(title), extension, bytes).map_err(|error| error.to_string())
}

/// Writes a file that is there already, or is not: nobody ever sees half of it.
pub(super) fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), String> {
    files::write(path, bytes).map_err(|error| error.to_string())
}
