//! Ctrl-C and the signal to end: nothing half-written is left behind.

#[cfg(feature = "headless")]
use std::sync::atomic::{AtomicBool, Ordering};

use dzhanibekov::files;

use super::failure::Failure;

/// Whether a signal raises [`STOP`] rather than ends the program.
#[cfg(feature = "headless")]
static IS_FLAGGED: AtomicBool = AtomicBool::new(false);
/// Raised by a signal.
#[cfg(feature = "headless")]
static STOP: AtomicBool = AtomicBool::new(false);

/// From now on a signal ends the program at once, after removing what is not whole.
pub(super) fn end_at_once() -> Result<(), Failure> {
    let react = || {
        #[cfg(feature = "headless")]
        if IS_FLAGGED.load(Ordering::Relaxed) && !STOP.swap(true, Ordering::Relaxed) {
            return;
        }
        end();
    };
    ctrlc::set_handler(react).map_err(|error| Failure::could_not(format!("signals cannot be listened for: {error}")))
}

/// From now on a signal raises a flag instead. A second one still ends the program at once: it may be waiting for
/// whoever reads what it writes.
#[cfg(feature = "headless")]
pub(super) fn raise_flag() -> &'static AtomicBool {
    IS_FLAGGED.store(true, Ordering::Relaxed);
    &STOP
}

/// Removes what is not whole, says so and ends.
fn end() {
    files::abandon(|| {
        Failure::could_not("stopped by a signal; nothing half-written is left").report();
        std::process::exit(1);
    });
}
