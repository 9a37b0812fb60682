//! Files that are read and written for a person: one reader with a bound, one writer that leaves whole files only.
//!
//! A result goes beside its place first and is then renamed into it ([`write()`], [`write_with`], [`Output`]). Links are
//! followed and stay links; a file that is there keeps its mode and its owner; where renaming would not do (a device, a
//! pipe, a descriptor, a file with a second name or in a folder that takes none) it is written in its place.
//! [`write_new`] writes under a free name and over nothing. [`read_scene`] reads the scene of a file, also
//! of a picture that carries one, [`read_scenes`] those of a file or a folder; [`page()`] makes one file of a page's.

mod error;
mod folder;
mod new;
mod output;
mod page;
mod place;
mod read;
mod staged;
mod standard;
mod under_way;

use std::io::Write;
use std::path::Path;

pub use error::FileError;
pub use folder::Folder;
pub use new::write_new;
pub use output::{Output, Sink};
pub use page::{is_page, page};
pub use place::{check, takes_streams};
pub use read::{LARGEST_PICTURE, LARGEST_SCENE, NamedScene, read_scene, read_scenes, read_standard_input, read_text};
pub use standard::keep_closed;
pub use under_way::abandon;

/// Writes a file whole, or standard output where the path is `-`.
///
/// # Errors
/// See [`FileError`]; nothing half-written is left.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), FileError> {
    write_with(path, |output| output.write_all(bytes).map_err(|error| FileError::write(path, error)))
}

/// As [`write()`], what `fill` writes. Where that fails nothing is left.
///
/// # Errors
/// See [`FileError`], and whatever `fill` returns.
pub fn write_with<E: From<FileError>>(
    path: &Path,
    fill: impl FnOnce(&mut dyn Write) -> Result<(), E>,
) -> Result<(), E> {
    let mut output = Output::create(path)?;
    fill(output.writer())?;
    Ok(output.keep()?)
}
