//! Files that are not whole yet, so that a signal can remove them.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

/// Where they are.
static UNDER_WAY: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// Folders made for what is not whole yet, each after that which it is in.
static FOLDERS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// Remembers a folder that a signal takes away where it is empty.
pub(super) fn begin_folder(path: &Path) {
    FOLDERS.lock().unwrap_or_else(PoisonError::into_inner).push(path.to_owned());
}

/// Forgets a folder.
pub(super) fn end_folder(path: &Path) {
    FOLDERS.lock().unwrap_or_else(PoisonError::into_inner).retain(|folder| folder != path);
}

/// Remembers a file that a signal must remove.
pub(super) fn begin(path: &Path) {
    UNDER_WAY.lock().unwrap_or_else(PoisonError::into_inner).insert(path.to_owned());
}

/// Forgets a file that is whole or gone.
pub(super) fn end(path: &Path) {
    UNDER_WAY.lock().unwrap_or_else(PoisonError::into_inner).remove(path);
}

/// Removes what is not whole, then does `last`, while which no other thread begins a file.
pub fn abandon(last: impl FnOnce()) {
    let files = UNDER_WAY.lock().unwrap_or_else(PoisonError::into_inner);
    for path in files.iter() {
        let _ = fs::remove_file(path);
    }
    for path in FOLDERS.lock().unwrap_or_else(PoisonError::into_inner).iter().rev() {
        // One that holds something stays.
        let _ = fs::remove_dir(path);
    }
    last();
}
