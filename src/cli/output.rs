//! Results of commands: written by the room of files, refused in the command line's words.

use std::io;
use std::path::Path;

use dzhanibekov::files::{self, FileError};

use super::failure::Failure;

pub(super) use files::{check as check_place, write_with as write_whole};

impl From<FileError> for Failure {
    fn from(error: FileError) -> Self {
        match error {
            FileError::ReaderGone(_) => Self::ReaderGone,
            error if error.is_bad_request() => Self::request(error.to_string()),
            error => Self::could_not(error.to_string()),
        }
    }
}

/// What a name ends in, without the dot and in small letters: the format that it asks for.
#[cfg(feature = "headless")]
pub(super) fn ending(output: &Path) -> Option<String> {
    output.extension()?.to_str().map(str::to_lowercase)
}

/// What could not be written and why.
pub(super) fn io_failure(path: &Path, error: io::Error) -> Failure {
    FileError::write(path, error).into()
}
