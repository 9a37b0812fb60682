//! Names of numbered files: `frame-{:05}.png`.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use crate::cli::failure::Failure;

/// A path with the place of a number in its file name.
#[derive(Debug)]
pub(super) struct Pattern {
    folder: PathBuf,
    before: OsString,
    after: OsString,
    width: usize,
}

impl Pattern {
    pub(super) fn parse(path: &Path) -> Result<Self, Failure> {
        let refused = || {
            Failure::request(format!(
                "{} names one file: put the place of the number in its name, as in frame-{{:05}}.png",
                path.display()
            ))
        };
        // A name need not be text: only the braces in it are looked for.
        let name = path.file_name().ok_or_else(refused)?.as_encoded_bytes();
        let (before, rest) = split_at(name, b'{').ok_or_else(refused)?;
        let (inside, after) = split_at(rest, b'}').ok_or_else(refused)?;
        let inside = str::from_utf8(inside).map_err(|_| refused())?;
        let width = match inside.strip_prefix(':') {
            None if inside.is_empty() => 0,
            Some(width) => width.parse().ok().filter(|width| *width <= 20).ok_or_else(refused)?,
            None => return Err(refused()),
        };
        if after.contains(&b'{') {
            return Err(refused());
        }
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        Ok(Self { folder, before: os_string(before), after: os_string(after), width })
    }

    /// The path of one number.
    pub(super) fn path(&self, index: u64) -> PathBuf {
        let Self { before, after, width, .. } = self;
        let mut name = before.clone();
        name.push(format!("{index:0width$}"));
        name.push(after);
        self.folder.join(name)
    }
}

/// What lies before and behind the first of these bytes.
fn split_at(name: &[u8], mark: u8) -> Option<(&[u8], &[u8])> {
    let at = name.iter().position(|byte| *byte == mark)?;
    Some((&name[..at], &name[at + 1..]))
}

/// Bytes of a name as a name again.
#[cfg(unix)]
fn os_string(bytes: &[u8]) -> OsString {
    std::os::unix::ffi::OsStringExt::from_vec(bytes.to_vec())
}

/// Where a name is always text.
#[cfg(not(unix))]
fn os_string(bytes: &[u8]) -> OsString {
    String::from_utf8_lossy(bytes).into_owned().into()
}
