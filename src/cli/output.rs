//! Files written whole or not at all: beside their place first, then renamed into it.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::failure::Failure;
use super::signal;

/// Writes what `write` writes to a file, or to standard output where the path is `-`.
///
/// A file appears under its name only once it is whole and on the disk; after a failure nothing of it is left.
pub(super) fn write_whole(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<(), Failure>,
) -> Result<(), Failure> {
    if path == Path::new("-") {
        let mut stdout = BufWriter::new(io::stdout().lock());
        write(&mut stdout)?;
        return stdout.flush().map_err(|error| io_failure(path, &error));
    }
    check_place(path)?;
    let is_special = fs::metadata(path).is_ok_and(|metadata| !metadata.is_file());
    if is_special {
        // A device or a pipe takes no renaming.
        let mut file = BufWriter::new(File::create(path).map_err(|error| io_failure(path, &error))?);
        write(&mut file)?;
        return file.flush().map_err(|error| io_failure(path, &error));
    }
    let mut file = WholeFile::create(path)?;
    write(file.writer())?;
    file.keep()
}

/// A file under way beside its place: there under its name only once it is kept, gone where it is dropped before.
pub(super) struct WholeFile {
    path: PathBuf,
    beside: PathBuf,
    writer: BufWriter<File>,
}

impl WholeFile {
    pub(super) fn create(path: &Path) -> Result<Self, Failure> {
        let Some(name) = path.file_name() else {
            return Err(Failure::request(format!("{} does not name a file", path.display())));
        };
        let mut beside = std::ffi::OsString::from(".");
        beside.push(name);
        beside.push(format!(".part-{}", std::process::id()));
        let beside = path.with_file_name(beside);
        signal::begin(&beside);
        let file = File::create(&beside).map_err(|error| {
            signal::end(&beside);
            io_failure(path, &error)
        })?;
        Ok(Self { path: path.to_owned(), beside, writer: BufWriter::new(file) })
    }

    pub(super) fn writer(&mut self) -> &mut BufWriter<File> {
        &mut self.writer
    }

    /// A second handle on the file for a writer that takes one of its own.
    #[allow(dead_code, reason = "used by the commands that draw")]
    pub(super) fn reopen(&self) -> io::Result<File> {
        self.writer.get_ref().try_clone()
    }

    /// Where the file is until it is kept.
    #[allow(dead_code, reason = "used by the commands that draw")]
    pub(super) fn beside(&self) -> &Path {
        &self.beside
    }

    /// Puts the file, whole and on the disk, under its name.
    pub(super) fn keep(mut self) -> Result<(), Failure> {
        let kept = self
            .writer
            .flush()
            .and_then(|()| self.writer.get_ref().sync_data())
            .and_then(|()| fs::rename(&self.beside, &self.path));
        kept.map_err(|error| io_failure(&self.path, &error))
    }
}

impl Drop for WholeFile {
    fn drop(&mut self) {
        // After the renaming there is nothing to remove; before it, what is left has no value.
        let _ = fs::remove_file(&self.beside);
        signal::end(&self.beside);
    }
}

/// Refuses a place where no file can be, before any work is done for it.
pub(super) fn check_place(path: &Path) -> Result<(), Failure> {
    if path.is_dir() {
        return Err(Failure::request(format!("{} is a folder: name a file in it", path.display())));
    }
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() && !folder.is_dir() => {
            Err(Failure::could(format!("could not write {}: there is no folder {}", path.display(), folder.display())))
        }
        _ => Ok(()),
    }
}

/// What could not be written and why.
pub(super) fn io_failure(path: &Path, error: &io::Error) -> Failure {
    let place = if path == Path::new("-") { "standard output".to_owned() } else { path.display().to_string() };
    Failure::could(format!("could not write {place}: {error}"))
}
