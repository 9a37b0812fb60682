//! Files that are followed: a scene that is changed on the disk is read again by itself.

use std::path::Path;

use notify::{Event, EventKind, RecommendedWatcher, RecursiveMode, Watcher, event::ModifyKind};
use winit::event_loop::EventLoopProxy;

use super::Wake;

/// A file or a folder that is watched.
pub(super) struct Watch {
    /// Watches for as long as it lives.
    _watcher: RecommendedWatcher,
}

impl Watch {
    /// Wakes the event loop where a scene at this place changes; none where the system does not watch files.
    pub(super) fn new(place: &Path, proxy: EventLoopProxy<Wake>) -> Option<Self> {
        let place = std::path::absolute(place).ok()?;
        let on_event = move |event: notify::Result<Event>| {
            let is_change = event.is_ok_and(|event| {
                let is_scene = event.paths.iter().any(|path| path.extension().is_some_and(|end| end == "toml"));
                is_scene && !matches!(event.kind, EventKind::Access(_) | EventKind::Modify(ModifyKind::Metadata(_)))
            });
            if is_change {
                // The loop may have ended: then nobody looks.
                let _ = proxy.send_event(Wake::FilesChanged);
            }
        };
        let mut watcher = notify::recommended_watcher(on_event).ok()?;
        // Editors put another file in the place of one: its folder is watched.
        let folder = if place.is_dir() { place.as_path() } else { place.parent()? };
        watcher.watch(folder, RecursiveMode::NonRecursive).ok()?;
        Some(Self { _watcher: watcher })
    }
}
