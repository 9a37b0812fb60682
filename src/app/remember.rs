//! Where the window keeps what it remembers: where the system keeps such things.

use std::path::PathBuf;

use super::files::write_whole;
use crate::session::Remembered;

/// Reads it; as if it were the first time where there is nothing to read.
pub(super) fn load() -> Remembered {
    let text = path().and_then(|path| std::fs::read_to_string(path).ok());
    text.map_or_else(Remembered::default, |text| Remembered::read(&text))
}

/// Writes it. Where that cannot be done the next time starts as the first: nobody need be told.
pub(super) fn save(remembered: &Remembered) {
    let Some(path) = path() else { return };
    if let Some(folder) = path.parent()
        && std::fs::create_dir_all(folder).is_ok()
    {
        let _ = write_whole(&path, remembered.text().as_bytes());
    }
}

/// The file, by the customs of the system.
fn path() -> Option<PathBuf> {
    let from = |name: &str| std::env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from);
    let folder = if cfg!(windows) {
        from("APPDATA")?
    } else if cfg!(target_vendor = "apple") {
        from("HOME")?.join("Library/Application Support")
    } else {
        from("XDG_STATE_HOME").filter(|path| path.is_absolute()).or_else(|| Some(from("HOME")?.join(".local/state")))?
    };
    Some(folder.join("dzhanibekov").join("window.toml"))
}
