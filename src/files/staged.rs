//! A file under way, under a name that nobody else has.

use std::fs::{File, OpenOptions};
use std::io::{self, Seek};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile, PersistError};

use super::under_way;

/// A file that is gone when it is dropped, unless it was put under its name before.
#[derive(Debug)]
pub(super) struct Staged {
    file: Option<NamedTempFile>,
    /// Where it is, remembered beyond the renaming.
    path: PathBuf,
}

impl Staged {
    /// Makes one in this folder. One that will replace another file is nobody else's until it has that file's mode.
    pub(super) fn make(folder: &Path, is_private: bool) -> io::Result<Self> {
        let create = |path: &Path| {
            let mut options = OpenOptions::new();
            options.read(true).write(true).create_new(true);
            #[cfg(unix)]
            if is_private {
                std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
            }
            #[cfg(not(unix))]
            let _ = is_private;
            under_way::begin(path);
            options.open(path).inspect_err(|_| under_way::end(path))
        };
        // A short name: that of the file itself may be as long as names can be.
        let file = Builder::new().prefix(".").suffix(".part").make_in(folder, create)?;
        let path = file.path().to_owned();
        Ok(Self { file: Some(file), path })
    }

    /// Where it is until it is kept.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// The file; gone after [`Self::rename`] alone.
    fn file(&self) -> io::Result<&File> {
        self.file.as_ref().map(NamedTempFile::as_file).ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    /// A handle to write with.
    pub(super) fn handle(&self) -> io::Result<File> {
        self.file()?.try_clone()
    }

    /// Gives it the owner of another file; whether that could be done.
    #[cfg(unix)]
    pub(super) fn give_owner(&self, like: &std::fs::Metadata) -> bool {
        use std::os::unix::fs::{MetadataExt, fchown};
        let Ok(file) = self.file() else { return false };
        let Ok(own) = file.metadata() else { return false };
        (own.uid(), own.gid()) == (like.uid(), like.gid()) || fchown(file, Some(like.uid()), Some(like.gid())).is_ok()
    }

    /// Where a file's owner is not part of it.
    #[cfg(not(unix))]
    pub(super) fn give_owner(&self, _like: &std::fs::Metadata) -> bool {
        true
    }

    /// Puts it, on the disk, under its name; with the mode of the file that it replaces. What could not be renamed is
    /// given back.
    pub(super) fn rename(&mut self, to: &Path, like: Option<&std::fs::Metadata>) -> io::Result<()> {
        if let Some(like) = like {
            self.file()?.set_permissions(like.permissions())?;
        }
        settle(self.file()?)?;
        let Some(file) = self.file.take() else { return Err(io::ErrorKind::NotFound.into()) };
        file.persist(to).map(|_| ()).map_err(|PersistError { error, file }| {
            self.file = Some(file);
            error
        })
    }

    /// Puts it, on the disk, under a name that nothing has.
    pub(super) fn rename_to_new(&mut self, to: &Path) -> io::Result<()> {
        settle(self.file()?)?;
        let Some(file) = self.file.take() else { return Err(io::ErrorKind::NotFound.into()) };
        file.persist_noclobber(to).map(|_| ()).map_err(|PersistError { error, file }| {
            self.file = Some(file);
            error
        })
    }

    /// Copies what it holds over a file, from that file's start to its new end.
    pub(super) fn copy_over(&self, target: &mut File) -> io::Result<()> {
        let length = self.file()?.metadata()?.len();
        reserve(target, length)?;
        target.rewind()?;
        self.copy_into(target)?;
        target.set_len(length)?;
        settle(target)
    }

    /// Copies what it holds into a stream.
    pub(super) fn copy_into(&self, target: &mut impl io::Write) -> io::Result<()> {
        let mut own = self.handle()?;
        own.rewind()?;
        io::copy(&mut own, target).map(|_| ())
    }
}

impl Drop for Staged {
    fn drop(&mut self) {
        // Removed, where it is still there, before it is forgotten.
        self.file = None;
        under_way::end(&self.path);
    }
}

/// Waits until a file is on the disk. Not every file system can say so, and then nothing is lost by not asking.
pub(super) fn settle(file: &File) -> io::Result<()> {
    file.sync_data().or_else(|error| if cannot_sync(&error) { Ok(()) } else { Err(error) })
}

/// Whether a file system refuses to be asked, rather than to keep what it was given.
#[cfg(unix)]
fn cannot_sync(error: &io::Error) -> bool {
    use rustix::io::Errno;
    Errno::from_io_error(error)
        .is_some_and(|errno| [Errno::INVAL, Errno::NOTSUP, Errno::OPNOTSUPP, Errno::NOSYS].contains(&errno))
}

/// Whether a file system refuses to be asked, rather than to keep what it was given.
#[cfg(not(unix))]
fn cannot_sync(error: &io::Error) -> bool {
    matches!(error.kind(), io::ErrorKind::Unsupported | io::ErrorKind::InvalidInput)
}

/// Asks for the room first, so that a full disk is known of before anything is written over.
#[cfg(target_os = "linux")]
fn reserve(file: &File, length: u64) -> io::Result<()> {
    use rustix::fs::{FallocateFlags, fallocate};
    use rustix::io::Errno;
    if length == 0 {
        return Ok(());
    }
    match fallocate(file, FallocateFlags::KEEP_SIZE, 0, length) {
        Err(error @ (Errno::NOSPC | Errno::DQUOT)) => Err(error.into()),
        // Not every file system can.
        _ => Ok(()),
    }
}

/// Where room cannot be asked for.
#[cfg(not(target_os = "linux"))]
fn reserve(_file: &File, _length: u64) -> io::Result<()> {
    Ok(())
}
