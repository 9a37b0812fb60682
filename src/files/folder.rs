//! Folders that a result is put into: those that are made for it go again where it does not come.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::under_way;

/// A folder with whatever was made for it. Dropped, or where a signal ends the program, each that was made and is still empty is
/// taken away.
#[derive(Debug)]
pub struct Folder {
    /// Those made, the innermost first.
    made: Vec<PathBuf>,
}

impl Folder {
    /// Makes a folder and those that it is to be in.
    ///
    /// # Errors
    /// As for any folder that cannot be made; what was made until then goes again.
    pub fn make(path: &Path) -> io::Result<Self> {
        let missing: Vec<&Path> =
            path.ancestors().take_while(|folder| !folder.as_os_str().is_empty() && !folder.is_dir()).collect();
        let mut folder = Self { made: vec![] };
        for path in missing.into_iter().rev() {
            match fs::create_dir(path) {
                Ok(()) => {
                    under_way::begin_folder(path);
                    folder.made.insert(0, path.to_owned());
                }
                // Another has made it in the meantime, or it is called `a/.`.
                Err(error) if path.is_dir() && error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
        Ok(folder)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        for path in &self.made {
            // One that holds something stays.
            let _ = fs::remove_dir(path);
            under_way::end_folder(path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Folder;

    #[test]
    fn folders_that_were_made_go_again_while_they_are_empty() -> std::io::Result<()> {
        let place = tempfile::tempdir()?;
        let inner = place.path().join("a/b");
        drop(Folder::make(&inner)?);
        assert!(!place.path().join("a").exists());
        let folder = Folder::make(&inner)?;
        assert!(inner.is_dir());
        std::fs::write(place.path().join("a/file"), "")?;
        drop(folder);
        assert!(!inner.exists() && place.path().join("a").is_dir());
        // What was there stays, empty or not.
        std::fs::create_dir(&inner)?;
        drop(Folder::make(&inner)?);
        assert!(inner.is_dir());
        assert!(Folder::make(&place.path().join("a/file/c")).is_err());
        Ok(())
    }
}
