//! A result under way: where it is written, and how it comes under its name.

use std::fs::{File, Metadata};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::FileError;
use super::place::{Place, folder_of, open_descriptor, open_to_write};
use super::staged::Staged;

/// A result under way. A file is there under its name only after [`Output::keep`]; before that nothing of it is seen,
/// and nothing is left where it is dropped.
#[derive(Debug)]
pub struct Output {
    path: PathBuf,
    writer: BufWriter<Sink>,
    way: Way,
}

/// What bytes go into.
#[derive(Debug)]
pub enum Sink {
    /// A file, a pipe, a device.
    File(File),
    /// Standard output where it is no file.
    Standard(io::Stdout),
}

/// How a result gets to its place.
#[derive(Debug)]
enum Way {
    /// It is there as it is written.
    Straight,
    /// Written elsewhere, then renamed.
    Rename { staged: Staged, to: PathBuf, like: Option<(Metadata, File)> },
    /// Written elsewhere, then copied over what is there.
    Over { staged: Staged, target: File },
    /// Written elsewhere, then copied into a stream.
    Into { staged: Staged, target: Sink },
}

impl Output {
    /// Begins a result: standard output and streams as they are, anything else beside its place.
    ///
    /// # Errors
    /// See [`FileError`].
    pub fn create(path: &Path) -> Result<Self, FileError> {
        let refused = |error| FileError::write(path, error);
        let straight = |sink| Ok(Self { path: path.to_owned(), writer: BufWriter::new(sink), way: Way::Straight });
        match Place::of(path)? {
            Place::Descriptor(number) => straight(open_standard(number).map_err(refused)?),
            Place::Special(target) => straight(Sink::File(open_to_write(&target).map_err(refused)?)),
            Place::New(to) => {
                let staged = Staged::make(folder_of(&to), false).map_err(refused)?;
                Self::staged_as(path, Way::Rename { staged, to, like: None })
            }
            Place::File(to) => {
                // What may not be written may not be replaced either.
                let target = open_to_write(&to).map_err(refused)?;
                match way_over(to, target).map_err(refused)? {
                    Ok(way) => Self::staged_as(path, way),
                    Err(target) => {
                        target.set_len(0).map_err(refused)?;
                        straight(Sink::File(target))
                    }
                }
            }
        }
    }

    /// As [`Self::create`], for a program that writes a file itself, wherever it wants in it: see [`Self::beside`].
    ///
    /// # Errors
    /// See [`FileError`].
    pub fn create_for_program(path: &Path) -> Result<Self, FileError> {
        let output = Self::create(path)?;
        if !matches!(output.way, Way::Straight) {
            return Ok(output);
        }
        let staged = Staged::make(&std::env::temp_dir(), true).map_err(|error| FileError::write(path, error))?;
        let target = output.writer.into_inner().map_err(|error| FileError::write(path, error.into_error()))?;
        Self::staged_as(path, Way::Into { staged, target })
    }

    /// A result that is written to a file of its own first.
    fn staged_as(path: &Path, way: Way) -> Result<Self, FileError> {
        let file = match &way {
            Way::Rename { staged, .. } | Way::Over { staged, .. } | Way::Into { staged, .. } => staged.handle(),
            Way::Straight => Err(io::ErrorKind::NotFound.into()),
        };
        let file = file.map_err(|error| FileError::write(path, error))?;
        Ok(Self { path: path.to_owned(), writer: BufWriter::new(Sink::File(file)), way })
    }

    /// What to write to.
    pub fn writer(&mut self) -> &mut BufWriter<Sink> {
        &mut self.writer
    }

    /// A second handle, for a writer that takes one of its own.
    ///
    /// # Errors
    /// No handle left.
    pub fn handle(&self) -> Result<Sink, FileError> {
        self.writer.get_ref().duplicate().map_err(|error| FileError::write(&self.path, error))
    }

    /// Where the file is until it is kept; nowhere where it is written straight.
    #[must_use]
    pub fn beside(&self) -> Option<&Path> {
        match &self.way {
            Way::Straight => None,
            Way::Rename { staged, .. } | Way::Over { staged, .. } | Way::Into { staged, .. } => Some(staged.path()),
        }
    }

    /// Puts the result, whole and on the disk, under its name.
    ///
    /// # Errors
    /// See [`FileError`].
    pub fn keep(mut self) -> Result<(), FileError> {
        let kept = self.writer.flush().and_then(|()| match &mut self.way {
            Way::Straight => Ok(()),
            Way::Rename { staged, to, like } => match like {
                None => staged.rename(to, None),
                // A folder where names cannot be taken away: /tmp with another's file, a file mounted by itself.
                Some((like, target)) => staged
                    .rename(to, Some(like))
                    .or_else(|error| if is_refusal(&error) { staged.copy_over(target) } else { Err(error) }),
            },
            Way::Over { staged, target } => staged.copy_over(target),
            Way::Into { staged, target } => staged.copy_into(target).and_then(|()| target.flush()),
        });
        kept.map_err(|error| FileError::write(&self.path, error))
    }
}

/// How a file that is there is written; the file itself where nothing can be written elsewhere first.
fn way_over(to: PathBuf, target: File) -> io::Result<Result<Way, File>> {
    let metadata = target.metadata()?;
    match Staged::make(folder_of(&to), true) {
        Ok(staged) if can_be_replaced(&target, &metadata) && staged.give_owner(&metadata) => {
            Ok(Ok(Way::Rename { staged, to, like: Some((metadata, target)) }))
        }
        Ok(staged) => Ok(Ok(Way::Over { staged, target })),
        Err(error) if is_refusal(&error) => match Staged::make(&std::env::temp_dir(), true) {
            Ok(staged) => Ok(Ok(Way::Over { staged, target })),
            Err(_) => Ok(Err(target)),
        },
        Err(error) => Err(error),
    }
}

/// Whether a folder or a name takes no change, though the file in it may.
fn is_refusal(error: &io::Error) -> bool {
    use io::ErrorKind::{CrossesDevices, PermissionDenied, ReadOnlyFilesystem, ResourceBusy};
    matches!(error.kind(), PermissionDenied | ReadOnlyFilesystem | ResourceBusy | CrossesDevices)
}

/// Whether nothing but its name, mode and owner would be lost with a file: it has no second name and no attributes
/// beyond those that the system gives to every file.
#[cfg(unix)]
fn can_be_replaced(file: &File, metadata: &Metadata) -> bool {
    std::os::unix::fs::MetadataExt::nlink(metadata) == 1 && !has_attributes(file)
}

/// Elsewhere a file has one name.
#[cfg(not(unix))]
fn can_be_replaced(_file: &File, _metadata: &Metadata) -> bool {
    true
}

/// Whether a file has attributes of its own, such as a list of who may use it.
#[cfg(target_os = "linux")]
fn has_attributes(file: &File) -> bool {
    let mut names = [0_u8; 4096];
    match rustix::fs::flistxattr(file, &mut names) {
        Ok(length) => {
            names[..length].split(|byte| *byte == 0).any(|name| !name.is_empty() && name != b"security.selinux")
        }
        // More than fit here; or none where the file system knows of none.
        Err(error) => error == rustix::io::Errno::RANGE,
    }
}

/// Where they are not asked for.
#[cfg(all(unix, not(target_os = "linux")))]
fn has_attributes(_file: &File) -> bool {
    false
}

/// Standard output, or another descriptor.
fn open_standard(number: i32) -> io::Result<Sink> {
    if cfg!(unix) { open_descriptor(number).map(Sink::File) } else { Ok(Sink::Standard(io::stdout())) }
}

impl Sink {
    /// A second handle on the same.
    fn duplicate(&self) -> io::Result<Self> {
        match self {
            Self::File(file) => file.try_clone().map(Self::File),
            Self::Standard(_) => Ok(Self::Standard(io::stdout())),
        }
    }
}

impl Write for Sink {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Self::File(file) => file.write(bytes),
            Self::Standard(stdout) => stdout.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match self {
            Self::File(file) => file.flush(),
            Self::Standard(stdout) => stdout.flush(),
        }
    }
}
