//! What graphics drivers and their loaders are told before they are loaded.

/// Mesa's drivers of graphics cards, by the names of their manifests: each finds its card in `/dev/dri`.
#[cfg(target_os = "linux")]
const DRIVERS_OF_CARDS: &str = "*intel*,*radeon*,*nouveau*,*virtio*";

/// Keeps a layer of the loader from talking on standard error, and drivers from being loaded that can find nothing.
///
/// Mesa's device-select layer asks for a Wayland display and, where `XDG_RUNTIME_DIR` is not set, complains although nothing is
/// wrong. Where there is no `/dev/dri`, loading the drivers of cards is a tenth of a small picture's time. Mesa's EGL complains of
/// drivers that it does not find, which `--quiet` is to end. Only the environment of a new program image can tell so, and so the
/// program replaces itself once, before it has done anything.
#[cfg(target_os = "linux")]
pub(super) fn keep_quiet() {
    use std::os::unix::process::CommandExt;
    let is_unset = |name: &str| std::env::var_os(name).is_none();
    let has_cards = std::path::Path::new("/dev/dri").exists();
    let is_quiet = std::env::args_os().take_while(|word| word != "--").any(|word| word == "--quiet");
    let told = [
        ("NODEVICE_SELECT", "1", is_unset("XDG_RUNTIME_DIR")),
        ("VK_LOADER_DRIVERS_DISABLE", DRIVERS_OF_CARDS, !has_cards),
        ("EGL_LOG_LEVEL", "fatal", is_quiet),
    ];
    let mut told = told.into_iter().filter(|(name, _, is_wanted)| *is_wanted && is_unset(name)).peekable();
    if told.peek().is_none() {
        return;
    }
    if let Ok(program) = std::env::current_exe() {
        dzhanibekov::files::keep_closed();
        let mut command = std::process::Command::new(program);
        command.args(std::env::args_os().skip(1)).envs(told.map(|(name, value, _)| (name, value)));
        // Returns only where it failed, and then little is lost.
        let _ = command.exec();
    }
}

/// Nothing to do where there is no such loader.
#[cfg(not(target_os = "linux"))]
pub(super) fn keep_quiet() {}
