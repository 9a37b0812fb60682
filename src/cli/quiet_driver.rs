//! Keeps a layer of the Vulkan loader from talking on standard error.

/// Mesa's device-select layer asks for a Wayland display and, where `XDG_RUNTIME_DIR` is not set, complains on standard
/// error although nothing is wrong. Only the environment of a new program image can switch it off, so the program
/// replaces itself once with that set, before it has done anything.
#[cfg(target_os = "linux")]
pub(super) fn keep_quiet() {
    use std::os::unix::process::CommandExt;
    const OFF: &str = "NODEVICE_SELECT";
    if std::env::var_os("XDG_RUNTIME_DIR").is_some() || std::env::var_os(OFF).is_some() {
        return;
    }
    if let Ok(program) = std::env::current_exe() {
        dzhanibekov::files::keep_closed();
        // Returns only where it failed, and then the noise is all that is lost.
        let _ = std::process::Command::new(program).args(std::env::args_os().skip(1)).env(OFF, "1").exec();
    }
}

/// Nothing to do where there is no such layer.
#[cfg(not(target_os = "linux"))]
pub(super) fn keep_quiet() {}
