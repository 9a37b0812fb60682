//! Why a file could not be had, in one sentence.

use std::io;
use std::path::Path;

/// Why a file could not be read or written.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// No file can have this name: it is the request that is wrong.
    #[error("{0}")]
    Name(String),
    /// It could not be written.
    #[error("could not write {place}: {error}")]
    Write {
        /// Where to.
        place: String,
        /// Why not.
        error: io::Error,
    },
    /// There is no folder for it.
    #[error("could not write {place}: there is no folder {folder}")]
    NoFolder {
        /// Where to.
        place: String,
        /// What is missing.
        folder: String,
    },
    /// It could not be read.
    #[error("{place}: {reason}")]
    Read {
        /// Where from.
        place: String,
        /// Why not.
        reason: String,
    },
    /// Who read what is written went away: there is nobody to tell.
    #[error("the reader of {0} went away")]
    ReaderGone(String),
}

impl FileError {
    /// What became of a write to this path.
    #[must_use]
    pub fn write(path: &Path, error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::ReaderGone(place(path)),
            _ => Self::Write { place: place(path), error },
        }
    }

    /// A name that no file can have, and what would be one.
    pub(super) fn name(path: &Path, reason: &str) -> Self {
        Self::Name(format!("{} {reason}", path.display()))
    }

    /// What became of a read from this path.
    pub(super) fn read(path: &Path, reason: impl Into<String>) -> Self {
        Self::Read { place: path.display().to_string(), reason: reason.into() }
    }

    /// Whether the request was wrong, rather than this machine unable.
    #[must_use]
    pub fn is_bad_request(&self) -> bool {
        matches!(self, Self::Name(_) | Self::Read { .. })
    }
}

/// How a path is called in a sentence.
fn place(path: &Path) -> String {
    if path == Path::new("-") { "standard output".to_owned() } else { path.display().to_string() }
}
