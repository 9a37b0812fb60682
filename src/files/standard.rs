//! Whether the standard streams were open when the program was started.
//!
//! Rust's runtime puts `/dev/null` in the place of one that is closed, before `main`: a result would vanish there and the
//! program call it done. So this is asked before the runtime begins.

#[cfg(unix)]
use std::sync::atomic::{AtomicBool, Ordering};

/// Standard input, output, error: whether each was closed.
#[cfg(unix)]
static CLOSED: [AtomicBool; 3] = [const { AtomicBool::new(false) }; 3];

/// Asks for the descriptors' flags, which a closed one has not. Nothing of the standard library is used but atomics,
/// as it promises nothing before `main`.
#[cfg(unix)]
#[ctor::ctor]
fn look() {
    let streams = [rustix::stdio::stdin(), rustix::stdio::stdout(), rustix::stdio::stderr()];
    for (closed, stream) in CLOSED.iter().zip(streams) {
        closed.store(rustix::io::fcntl_getfd(stream).is_err(), Ordering::Relaxed);
    }
}

/// Whether this standard stream was closed when the program was started.
#[cfg(unix)]
pub(super) fn was_closed(number: i32) -> bool {
    usize::try_from(number)
        .ok()
        .and_then(|index| CLOSED.get(index))
        .is_some_and(|closed| closed.load(Ordering::Relaxed))
}

/// Closes again, for a program that takes this one's place, the standard streams that were closed when it was started.
pub fn keep_closed() {
    #[cfg(unix)]
    for (closed, stream) in
        CLOSED.iter().zip([rustix::stdio::stdin(), rustix::stdio::stdout(), rustix::stdio::stderr()])
    {
        if closed.load(Ordering::Relaxed) {
            // Where it cannot be done the new program finds it open, and no more than that.
            let _ = rustix::io::fcntl_setfd(stream, rustix::io::FdFlags::CLOEXEC);
        }
    }
}
