//! What is copied and pasted. On Wayland it belongs to the window's own connection, which `egui_winit` has; elsewhere to the desktop,
//! which is asked here for texts and lists of files, and for nothing that is drawn.

use egui::{Event, Key, Modifiers, OutputCommand, PlatformOutput, PointerButton, RawInput};
use winit::event_loop::ActiveEventLoop;

/// The desktop's clipboard.
pub(super) struct Clipboard(arboard::Clipboard);

impl Clipboard {
    /// None on Wayland, and where the desktop has none.
    pub(super) fn open(event_loop: &ActiveEventLoop) -> Option<Self> {
        if is_wayland(event_loop) {
            return None;
        }
        arboard::Clipboard::new().ok().map(Self)
    }

    /// Puts a text there.
    ///
    /// # Errors
    /// Why the desktop does not take it.
    pub(super) fn copy(&mut self, text: String) -> Result<(), String> {
        self.0.set_text(text).map_err(|error| error.to_string())
    }

    /// The files that were copied in a file manager, as `file:` addresses, a line each; else the text; nothing where there is neither.
    fn pasted(&mut self) -> String {
        let files = self.0.get().file_list().unwrap_or_default();
        // The sign that begins an escape stands for itself.
        let addresses = files.iter().filter_map(|path| Some(format!("file://{}", path.to_str()?.replace('%', "%25"))));
        let addresses = addresses.collect::<Vec<_>>().join("\n");
        if addresses.is_empty() { self.0.get_text().unwrap_or_default().replace("\r\n", "\n") } else { addresses }
    }

    /// Turns the keys that cut, copy and paste into what they do, and the middle button into a paste of what is marked.
    pub(super) fn translate(&mut self, input: &mut RawInput) {
        let mut translated = Vec::with_capacity(input.events.len());
        for event in input.events.drain(..) {
            let (held, key) = match event {
                Event::Key { key, modifiers, pressed: true, .. } => (modifiers, key),
                Event::PointerButton { pos, button: PointerButton::Middle, pressed: true, .. } => {
                    translated.push(event);
                    let text = self.marked();
                    translated.extend((!text.is_empty()).then_some(Event::MiddleClickPaste { pos, text }));
                    continue;
                }
                event => {
                    translated.push(event);
                    continue;
                }
            };
            if cuts(held, key) {
                translated.push(Event::Cut);
            } else if copies(held, key) {
                translated.push(Event::Copy);
            } else if pastes(held, key) {
                let text = self.pasted();
                translated.extend((!text.is_empty()).then_some(Event::Paste(text)));
            } else {
                translated.push(event);
            }
        }
        input.events = translated;
    }

    /// Takes what the panels copy or mark.
    pub(super) fn take(&mut self, output: &mut PlatformOutput) {
        output.commands.retain(|command| match command {
            OutputCommand::CopyText(text) => self.copy(text.clone()).is_err(),
            OutputCommand::TextSelectionSettled(text) => {
                self.mark(text);
                false
            }
            _ => true,
        });
    }

    /// What is marked on the screen, which X11 knows apart from what was copied.
    #[cfg(all(unix, not(target_vendor = "apple")))]
    fn marked(&mut self) -> String {
        use arboard::{GetExtLinux, LinuxClipboardKind};
        self.0.get().clipboard(LinuxClipboardKind::Primary).text().unwrap_or_default()
    }

    #[cfg(all(unix, not(target_vendor = "apple")))]
    fn mark(&mut self, text: &str) {
        use arboard::{LinuxClipboardKind, SetExtLinux};
        // A desktop that takes no marks loses nothing that was asked for.
        let _ = self.0.set().clipboard(LinuxClipboardKind::Primary).text(text);
    }

    #[cfg(not(all(unix, not(target_vendor = "apple"))))]
    #[expect(clippy::unused_self, reason = "elsewhere nothing is marked")]
    fn marked(&mut self) -> String {
        String::new()
    }

    #[cfg(not(all(unix, not(target_vendor = "apple"))))]
    #[expect(clippy::unused_self, reason = "elsewhere nothing is marked")]
    fn mark(&mut self, _: &str) {}
}

/// Ctrl+X (Cmd+X), and the older keys of Windows.
fn cuts(held: Modifiers, key: Key) -> bool {
    key == Key::Cut || held.command_only() && key == Key::X || cfg!(windows) && held.shift && key == Key::Delete
}

/// Ctrl+C.
fn copies(held: Modifiers, key: Key) -> bool {
    key == Key::Copy || held.command_only() && key == Key::C || cfg!(windows) && held.ctrl && key == Key::Insert
}

/// Ctrl+V.
fn pastes(held: Modifiers, key: Key) -> bool {
    key == Key::Paste || held.command_only() && key == Key::V || cfg!(windows) && held.shift && key == Key::Insert
}

#[cfg(all(unix, not(target_vendor = "apple")))]
fn is_wayland(event_loop: &ActiveEventLoop) -> bool {
    winit::platform::wayland::ActiveEventLoopExtWayland::is_wayland(event_loop)
}

#[cfg(not(all(unix, not(target_vendor = "apple"))))]
fn is_wayland(_: &ActiveEventLoop) -> bool {
    false
}
