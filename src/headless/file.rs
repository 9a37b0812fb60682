//! Files that are there whole or not at all.

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Where a result goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Output {
    /// To a file.
    File(PathBuf),
    /// To the standard output.
    Stdout,
}

impl From<&Path> for Output {
    /// `-` is the standard output.
    fn from(path: &Path) -> Self {
        if path.as_os_str() == "-" { Self::Stdout } else { Self::File(path.to_owned()) }
    }
}

/// Writes the bytes; a file is written beside its place and then renamed, so that none is ever half there.
///
/// # Errors
/// What the file system or the reader of the pipe refuses.
pub fn write(output: &Output, bytes: &[u8]) -> io::Result<()> {
    match output {
        Output::Stdout => {
            let mut stdout = io::stdout().lock();
            stdout.write_all(bytes)?;
            stdout.flush()
        }
        Output::File(path) => {
            let beside = beside(path);
            let written = fs::write(&beside, bytes).and_then(|()| fs::rename(&beside, path));
            if written.is_err() {
                // The cause is reported, not that the remains could not be removed.
                let _ = fs::remove_file(&beside);
            }
            written
        }
    }
}

/// `dir/.name.part-PID` for `dir/name`.
fn beside(path: &Path) -> PathBuf {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!(".{name}.part-{}", std::process::id()))
}
