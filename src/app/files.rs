//! Files that the window writes: whole or not at all, and never over another one.

use std::io::Write;
use std::path::{Path, PathBuf};

use crate::session;

/// What is said of a file that is held over the window.
pub(super) fn offer(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    format!("Let go to open {name}")
}

/// Writes a new file `stem-N.extension` in the working directory, `N` the first number that is free.
pub(super) fn write_new(stem: &str, extension: &str, bytes: &[u8]) -> Result<PathBuf, String> {
    let stem = session::slug(stem);
    for number in 1..100_000 {
        let path = PathBuf::from(format!("{stem}-{number}.{extension}"));
        if !path.exists() {
            return write_whole(&path, bytes).map(|()| std::path::absolute(&path).unwrap_or(path));
        }
    }
    Err(format!("there is no free name left for {stem}"))
}

/// Writes beside the file, then renames: nobody ever sees half of it.
pub(super) fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), String> {
    let beside = path.with_extension("part");
    let write = || {
        let mut file = std::fs::File::create(&beside)?;
        file.write_all(bytes)?;
        file.sync_all()?;
        std::fs::rename(&beside, path)
    };
    write().map_err(|error: std::io::Error| {
        // Nothing half-written stays behind; where that fails too, the first error is the one to tell.
        let _ = std::fs::remove_file(&beside);
        format!("{} could not be written: {error}", path.display())
    })
}
