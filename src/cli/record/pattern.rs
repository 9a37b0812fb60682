//! Names of numbered files: `frame-{:05}.png`.

use std::path::{Path, PathBuf};

use crate::cli::failure::Failure;

/// A path with the place of a number in its file name.
#[derive(Debug)]
pub(super) struct Pattern {
    folder: PathBuf,
    before: String,
    after: String,
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
        let name = path.file_name().and_then(|name| name.to_str()).ok_or_else(refused)?;
        let (before, rest) = name.split_once('{').ok_or_else(refused)?;
        let (inside, after) = rest.split_once('}').ok_or_else(refused)?;
        let width = match inside.strip_prefix(':') {
            None if inside.is_empty() => 0,
            Some(width) => width.parse().ok().filter(|width| *width <= 20).ok_or_else(refused)?,
            None => return Err(refused()),
        };
        if after.contains('{') {
            return Err(refused());
        }
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        Ok(Self { folder, before: before.to_owned(), after: after.to_owned(), width })
    }

    /// The path of one number.
    pub(super) fn path(&self, index: u64) -> PathBuf {
        let Self { before, after, width, .. } = self;
        self.folder.join(format!("{before}{index:0width$}{after}"))
    }
}
