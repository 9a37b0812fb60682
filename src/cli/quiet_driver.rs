//! Keeps drivers and the layers before them from talking on standard error.

/// What keeps Mesa and its EGL from saying anything themselves, where the user wants no words.
#[cfg(target_os = "linux")]
const SILENT: [(&str, &str); 2] = [("EGL_LOG_LEVEL", "fatal"), ("MESA_LOG", "null")];

/// Mesa's device-select layer asks for a Wayland display and, where `XDG_RUNTIME_DIR` is not set, complains on standard
/// error although nothing is wrong; and with `--quiet` no driver is to say anything. Only the environment of a new program image
/// can switch them off, so the program replaces itself once with that set, before it has done anything.
#[cfg(target_os = "linux")]
pub(super) fn keep_quiet() {
    use std::os::unix::process::CommandExt;
    const OFF: &str = "NODEVICE_SELECT";
    let is_set = |name: &str| std::env::var_os(name).is_some();
    let is_quiet = std::env::args_os().take_while(|word| word != "--").any(|word| word == "--quiet");
    let mut words = vec![];
    if !is_set("XDG_RUNTIME_DIR") && !is_set(OFF) {
        words.push((OFF, "1"));
    }
    if is_quiet {
        words.extend(SILENT.into_iter().filter(|(name, _)| !is_set(name)));
    }
    if words.is_empty() {
        return;
    }
    if let Ok(program) = std::env::current_exe() {
        dzhanibekov::files::keep_closed();
        // Returns only where it failed, and then the noise is all that is lost.
        let _ = std::process::Command::new(program).args(std::env::args_os().skip(1)).envs(words).exec();
    }
}

/// Nothing to do where there is no such layer.
#[cfg(not(target_os = "linux"))]
pub(super) fn keep_quiet() {}
