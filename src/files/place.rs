//! Where a path leads: a file that may be replaced, or something that must be written as it is.

use std::fs::{self, File, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

use super::FileError;

/// Links followed before a ring of them is taken for one (as Linux does).
const MOST_LINKS: usize = 40;

/// What a path leads to once its links are followed.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// A descriptor of this program: `-`, `/dev/stdout`, `/dev/fd/3`.
    Descriptor(i32),
    /// A device, a pipe, a socket, another program's descriptor: no file can take its place.
    Special(PathBuf),
    /// A file that is there.
    File(PathBuf),
    /// Nothing yet, in a folder that is there.
    New(PathBuf),
}

impl Place {
    /// Follows the links of a path.
    pub(super) fn of(path: &Path) -> Result<Self, FileError> {
        if path == Path::new("-") {
            return Ok(Self::Descriptor(1));
        }
        let refused = |error| FileError::write(path, error);
        let ends_in_slash =
            path.as_os_str().as_encoded_bytes().last().is_some_and(|byte| std::path::is_separator(*byte as char));
        let mut target = path.to_owned();
        for _ in 0..=MOST_LINKS {
            if let Some(place) = descriptor(&target) {
                return Ok(place);
            }
            let metadata = match fs::symlink_metadata(&target) {
                Ok(metadata) => metadata,
                Err(error) if error.kind() == io::ErrorKind::NotFound => {
                    let folder = folder_of(&target);
                    if !folder.is_dir() {
                        let (place, folder) = (path.display().to_string(), folder.display().to_string());
                        return Err(FileError::NoFolder { place, folder });
                    }
                    if ends_in_slash || target.file_name().is_none() {
                        return Err(FileError::name(path, "does not name a file"));
                    }
                    return Ok(Self::New(target));
                }
                Err(error) if error.kind() == io::ErrorKind::NotADirectory => {
                    let (place, folder) = (path.display().to_string(), folder_of(&target).display().to_string());
                    return Err(FileError::NoFolder { place, folder });
                }
                Err(error) => return Err(refused(error)),
            };
            if metadata.is_dir() {
                return Err(FileError::name(path, "is a folder: name a file in it"));
            }
            if metadata.is_file() {
                return Ok(Self::File(target));
            }
            if !metadata.is_symlink() {
                return Ok(Self::Special(target));
            }
            let next = fs::read_link(&target).map_err(refused)?;
            target = folder_of(&target).join(next);
        }
        Err(FileError::name(path, "is a link that leads back to itself"))
    }
}

/// The folder that a path is in.
pub(super) fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// `/dev/fd/3` and `/proc/self/fd/3` are descriptor 3, whatever file that is: what the caller has opened must be
/// written where it stands, not replaced.
#[cfg(unix)]
fn descriptor(path: &Path) -> Option<Place> {
    let number: i32 = path.file_name()?.to_str()?.parse().ok().filter(|number| *number >= 0)?;
    let folder = fs::canonicalize(folder_of(path)).ok()?;
    let own = [Path::new("/dev/fd"), Path::new("/proc/self/fd"), Path::new("/proc/thread-self/fd")];
    if own.into_iter().any(|own| fs::canonicalize(own).is_ok_and(|own| own == folder)) {
        return Some(Place::Descriptor(number));
    }
    (folder.starts_with("/proc") && folder.ends_with("fd")).then(|| Place::Special(path.to_owned()))
}

/// Windows has devices in every folder, by their names: no file can have one of these.
#[cfg(windows)]
fn descriptor(path: &Path) -> Option<Place> {
    let name = path.file_name()?.to_str()?.to_ascii_uppercase();
    let port = name.strip_prefix("COM").or(name.strip_prefix("LPT"));
    let is_port = port.is_some_and(|number| matches!(number.as_bytes(), [b'1'..=b'9']));
    let is_device = is_port || matches!(&*name, "NUL" | "CON" | "PRN" | "AUX" | "CONOUT$");
    is_device.then(|| Place::Special(path.to_owned()))
}

/// Where neither descriptors nor devices have names of their own.
#[cfg(not(any(unix, windows)))]
fn descriptor(_path: &Path) -> Option<Place> {
    None
}

/// Refuses a place where no file can be, before any work is done for it.
///
/// # Errors
/// A folder, a missing folder, a file that may not be written, a standard output that is closed.
pub fn check(path: &Path) -> Result<(), FileError> {
    match Place::of(path)? {
        #[cfg(unix)]
        Place::Descriptor(number) if super::standard::was_closed(number) => {
            Err(FileError::write(path, rustix::io::Errno::BADF.into()))
        }
        Place::File(target) => open_to_write(&target).map(|_| ()).map_err(|error| FileError::write(path, error)),
        Place::Descriptor(_) | Place::Special(_) | Place::New(_) => Ok(()),
    }
}

/// Whether a path leads to a stream rather than to a file: standard output, a descriptor, a pipe, a device.
#[must_use]
pub fn takes_streams(path: &Path) -> bool {
    matches!(Place::of(path), Ok(Place::Descriptor(_) | Place::Special(_)))
}

/// Opens what is there, and leaves in it what it holds.
pub(super) fn open_to_write(path: &Path) -> io::Result<File> {
    OpenOptions::new().write(true).open(path)
}

/// A second handle on a descriptor that this program was given: what is written goes where the caller stands in it.
#[cfg(unix)]
pub(super) fn open_descriptor(number: i32) -> io::Result<File> {
    use std::os::fd::AsFd;
    if super::standard::was_closed(number) {
        return Err(rustix::io::Errno::BADF.into());
    }
    let owned = match number {
        0 => io::stdin().as_fd().try_clone_to_owned()?,
        1 => io::stdout().as_fd().try_clone_to_owned()?,
        2 => io::stderr().as_fd().try_clone_to_owned()?,
        _ => return open_other(number),
    };
    Ok(owned.into())
}

/// Linux opens a descriptor's name as a file of its own, which begins at its start; the system hands out the
/// descriptor itself.
#[cfg(target_os = "linux")]
fn open_other(number: i32) -> io::Result<File> {
    use rustix::process::{PidfdFlags, PidfdGetfdFlags, getpid, pidfd_getfd, pidfd_open};
    let handed = pidfd_open(getpid(), PidfdFlags::empty())
        .and_then(|program| pidfd_getfd(program, number, PidfdGetfdFlags::empty()));
    match handed {
        Ok(owned) => Ok(owned.into()),
        Err(rustix::io::Errno::BADF) => Err(rustix::io::Errno::BADF.into()),
        // An old kernel or one that forbids it: at least nothing is written over.
        Err(_) => OpenOptions::new().append(true).open(format!("/proc/self/fd/{number}")),
    }
}

/// Elsewhere to open the name is to get the descriptor.
#[cfg(all(unix, not(target_os = "linux")))]
fn open_other(number: i32) -> io::Result<File> {
    open_to_write(Path::new(&format!("/dev/fd/{number}")))
}

/// Where descriptors have no names, none is asked for.
#[cfg(not(unix))]
pub(super) fn open_descriptor(_number: i32) -> io::Result<File> {
    Err(io::ErrorKind::Unsupported.into())
}
