//! Whether a window can be opened at all, and one sentence about it where it cannot.

use std::panic::{AssertUnwindSafe, PanicHookInfo, catch_unwind, resume_unwind, set_hook, take_hook};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use winit::error::EventLoopError;
use winit::event_loop::{EventLoop, EventLoopBuilder};

use super::Wake;
use crate::render::GpuError;
use crate::stage::StageError;

/// Why there is no window.
#[derive(Debug, thiserror::Error)]
pub enum WindowError {
    /// Nothing to show a window on.
    #[error(
        "there is no display to open a window on (neither WAYLAND_DISPLAY nor DISPLAY is set); \
         `dzhanibekov shot` and `dzhanibekov record` draw with no display"
    )]
    NoDisplay,
    /// A compositor is named that is not there.
    #[error(
        "no compositor answers at WAYLAND_DISPLAY={0}, and DISPLAY is not set; \
         `dzhanibekov shot` and `dzhanibekov record` draw with no display"
    )]
    NoCompositor(String),
    /// An X server is named that cannot be reached.
    #[error(
        "the X server at DISPLAY={0} cannot be reached ({1}); `dzhanibekov shot` and `dzhanibekov record` draw with no display"
    )]
    NoServer(String, String),
    /// X11 keyboards need a library that is loaded late.
    #[error(
        "libxkbcommon-x11 is missing, which a window on X11 needs: install it, on Debian or Ubuntu with what else a window needs: \
         apt-get install libx11-6 libx11-xcb1 libxcursor1 libxi6 libxkbcommon-x11-0"
    )]
    NoKeyboardLibrary,
    /// The display refused.
    #[error(
        "the window could not be opened: {0}; on Debian or Ubuntu a window needs: \
         apt-get install libx11-6 libx11-xcb1 libxcursor1 libxi6 libxkbcommon-x11-0"
    )]
    Display(String),
    /// Nothing to draw with.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The display went away while the window was open.
    #[error("the display is gone: {0}")]
    DisplayGone(String),
    /// What a trial asked for could not be written.
    #[error("{0}")]
    Trial(String),
    /// New devices are lost at once, too.
    #[error("the graphics device was lost again and again: restart the driver, or choose another one with --adapter")]
    DeviceGone,
    /// The adapter cannot draw into this window.
    #[error("the adapter {0} cannot draw into this window: choose another one with --adapter")]
    Surface(String),
}

impl From<StageError> for WindowError {
    fn from(error: StageError) -> Self {
        match error {
            StageError::Gpu(error) => Self::Gpu(error),
            StageError::Surface(adapter) => Self::Surface(adapter),
        }
    }
}

/// Connects to the display that there is. What is known to be missing is looked for before the window system would trip
/// over it.
#[cfg(all(unix, not(target_vendor = "apple")))]
pub(super) fn connect() -> Result<EventLoop<Wake>, WindowError> {
    use winit::platform::x11::EventLoopBuilderExtX11;
    let is_set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    let mut builder = EventLoop::with_user_event();
    let compositor = std::env::var_os("WAYLAND_DISPLAY").filter(|name| !name.is_empty());
    if is_set("WAYLAND_SOCKET") || compositor.as_deref().is_some_and(answers) {
        return build(builder);
    }
    if !is_set("DISPLAY") {
        let gone = |name: std::ffi::OsString| WindowError::NoCompositor(name.to_string_lossy().into_owned());
        return Err(compositor.map_or(WindowError::NoDisplay, gone));
    }
    // Asked by a library of our own: what is missing of X11's is another matter.
    let asked = x11rb::connect(None)
        .map_err(|error| WindowError::NoServer(std::env::var("DISPLAY").unwrap_or_default(), error.to_string()))?;
    // winit would panic where this library is missing.
    if xkbcommon_dl::x11::xkbcommon_x11_option().is_none() {
        return Err(WindowError::NoKeyboardLibrary);
    }
    // Not left to winit, which asks for a compositor wherever one is named.
    builder.with_x11();
    let events = build(builder);
    // Not before: a server that is left by its last client begins anew, and meanwhile takes none.
    drop(asked);
    events
}

/// Whether a Wayland compositor listens under this name, or at this path.
#[cfg(all(unix, not(target_vendor = "apple")))]
fn answers(name: &std::ffi::OsStr) -> bool {
    let folder = std::env::var_os("XDG_RUNTIME_DIR").map(std::path::PathBuf::from).unwrap_or_default();
    std::os::unix::net::UnixStream::connect(folder.join(name)).is_ok()
}

/// Connects to the display.
#[cfg(not(all(unix, not(target_vendor = "apple"))))]
pub(super) fn connect() -> Result<EventLoop<Wake>, WindowError> {
    build(EventLoop::with_user_event())
}

fn build(mut builder: EventLoopBuilder<Wake>) -> Result<EventLoop<Wake>, WindowError> {
    builder.build().map_err(|error| WindowError::Display(cause(&error.to_string())))
}

/// What the window system says, without the place in its source that it puts before.
fn cause(words: &str) -> String {
    let told = words.strip_prefix("os error at ").and_then(|rest| rest.split_once(": "));
    told.map_or(words, |(_, told)| told).to_owned()
}

/// How the event loop ended, where it ended by itself.
pub(super) fn ended(error: &EventLoopError) -> WindowError {
    WindowError::DisplayGone(match error {
        EventLoopError::ExitFailure(_) => "the connection to it broke".to_owned(),
        other => cause(&other.to_string()),
    })
}

/// Runs the window. winit has no error for a display that goes away while it is asked something: it panics, and nothing
/// of ours is asked before. That panic, and no other, becomes a sentence.
pub(super) fn while_displayed<T>(run: impl FnOnce() -> T) -> Result<T, WindowError> {
    let is_gone = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&is_gone);
    let usual = Arc::new(take_hook());
    let inner = Arc::clone(&usual);
    set_hook(Box::new(move |info| {
        if is_broken_connection(info) {
            flag.store(true, Ordering::Relaxed);
        } else {
            inner(info);
        }
    }));
    let outcome = catch_unwind(AssertUnwindSafe(run));
    set_hook(Box::new(move |info| usual(info)));
    match outcome {
        Ok(outcome) => Ok(outcome),
        Err(_) if is_gone.load(Ordering::Relaxed) => {
            Err(WindowError::DisplayGone("the connection to it broke, or it took the window away".to_owned()))
        }
        Err(panic) => resume_unwind(panic),
    }
}

/// The connection broke, or the window was destroyed by someone else, which every request about it then trips over.
fn is_broken_connection(info: &PanicHookInfo<'_>) -> bool {
    let is_windowing = info.location().is_some_and(|location| location.file().contains("winit"));
    is_windowing
        && info
            .payload_as_str()
            .is_some_and(|text| text.contains("Connection(") || text.contains("IoError") || text.contains("X11Error"))
}
