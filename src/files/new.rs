//! Files under names of their own, over nothing that is there.

use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::FileError;
use super::staged::{Staged, settle};

/// Numbers tried before a folder is taken to be full of them.
const MOST: u32 = 100_000;

/// Writes a new file `stem-N.extension` in a folder, `N` the first number that is free, and says where it is. Two
/// programs that do so at once get two files.
///
/// # Errors
/// See [`FileError`]; nothing half-written is left.
pub fn write_new(folder: &Path, stem: &str, extension: &str, bytes: &[u8]) -> Result<PathBuf, FileError> {
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let place = |number| folder.join(format!("{stem}-{number}.{extension}"));
    let refused = |error| FileError::write(&place(1), error);
    let mut staged = Staged::make(folder, false).map_err(refused)?;
    staged.handle().and_then(|mut file| file.write_all(bytes)).map_err(refused)?;
    for number in 1..MOST {
        let path = place(number);
        let kept = match staged.rename_to_new(&path) {
            Err(error) if error.kind() != io::ErrorKind::AlreadyExists => create_new(&path, bytes).map_err(|second| {
                // A file system that neither renames without replacing nor links.
                if second.kind() == io::ErrorKind::AlreadyExists { second } else { error }
            }),
            kept => kept,
        };
        match kept {
            Ok(()) => return Ok(std::path::absolute(&path).unwrap_or(path)),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(FileError::write(&path, error)),
        }
    }
    Err(FileError::name(&place(1), &format!("and {} more names after it are taken", MOST - 2)))
}

/// Writes a file that is not there yet, where the file system has no better way; a part of it does not stay.
fn create_new(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = OpenOptions::new().write(true).create_new(true).open(path)?;
    file.write_all(bytes).and_then(|()| settle(&file)).inspect_err(|_| {
        let _ = std::fs::remove_file(path);
    })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::write_new;

    #[test]
    fn many_at_once_get_a_file_each() -> std::io::Result<()> {
        let folder = tempfile::tempdir()?;
        let place = folder.path();
        std::fs::write(place.join("scene-2.toml"), "mine")?;
        // A link that leads nowhere is a name that is taken.
        #[cfg(unix)]
        std::os::unix::fs::symlink("nowhere", place.join("scene-3.toml"))?;
        let texts: Vec<String> = (0..40).map(|index| index.to_string()).collect();
        let written: Vec<_> = std::thread::scope(|scope| {
            let writers: Vec<_> = texts
                .iter()
                .map(|text| scope.spawn(move || write_new(place, "scene", "toml", text.as_bytes()).ok()))
                .collect();
            writers.into_iter().map(|writer| writer.join().ok().flatten()).collect()
        });
        let paths: BTreeSet<_> = written.iter().flatten().collect();
        assert_eq!(paths.len(), texts.len());
        for (path, text) in written.iter().flatten().zip(&texts) {
            assert_eq!(&std::fs::read_to_string(path)?, text);
        }
        assert_eq!(std::fs::read_to_string(place.join("scene-2.toml"))?, "mine");
        assert!(!place.join("nowhere").exists());
        // Nothing under way is left.
        let left = std::fs::read_dir(place)?.count();
        assert_eq!(left, texts.len() + if cfg!(unix) { 2 } else { 1 });
        Ok(())
    }
}
