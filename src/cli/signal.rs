//! Ctrl-C and the signal to end: nothing half-written is left behind.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
#[cfg(feature = "picture")]
use std::sync::Arc;
#[cfg(feature = "picture")]
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

use super::failure::Failure;

/// Files that are not whole yet.
static UNDER_WAY: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// Remembers a file that a signal must remove.
pub(super) fn begin(path: &Path) {
    UNDER_WAY.lock().unwrap_or_else(PoisonError::into_inner).insert(path.to_owned());
}

/// Forgets a file that is whole or gone.
pub(super) fn end(path: &Path) {
    UNDER_WAY.lock().unwrap_or_else(PoisonError::into_inner).remove(path);
}

/// From now on a signal ends the program at once, after removing what is not whole.
pub(super) fn end_at_once() -> Result<(), Failure> {
    listen(|| {
        let files = UNDER_WAY.lock().unwrap_or_else(PoisonError::into_inner);
        for path in files.iter() {
            let _ = fs::remove_file(path);
        }
        // The lock is held to the end, so that no other thread begins a file meanwhile.
        Failure::could("stopped by a signal; nothing half-written is left").report();
        std::process::exit(1);
    })
}

/// From now on a signal raises a flag.
#[cfg(feature = "picture")]
pub(super) fn raise_flag() -> Result<Arc<AtomicBool>, Failure> {
    let stop = Arc::new(AtomicBool::new(false));
    let raised = Arc::clone(&stop);
    listen(move || raised.store(true, Ordering::Relaxed))?;
    Ok(stop)
}

fn listen(react: impl FnMut() + Send + 'static) -> Result<(), Failure> {
    ctrlc::set_handler(react).map_err(|error| Failure::could(format!("signals cannot be listened for: {error}")))
}
