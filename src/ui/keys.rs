//! The keys: one table that the bindings and the help sheet both read.

use egui::{Event, Key, RawInput};

use super::{Command, Front, Look};
use crate::scene::{Layout, Theme};

/// What a chord wants held besides its key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Held {
    /// Neither Shift nor Ctrl.
    Up,
    /// Shift.
    Down,
    /// Either way, as for signs that need it on some keyboards.
    Any,
    /// With Ctrl (⌘ on a Mac), Shift either way.
    Control,
    /// With Ctrl (⌘ on a Mac) and Shift.
    ControlShift,
}

/// A row of the table.
#[derive(Debug)]
pub struct Binding {
    chords: &'static [(Held, Key)],
    /// Whether a held key repeats.
    repeats: bool,
    /// The keys as people write them, in a window and on a page; none where a browser keeps them to itself.
    keys: &'static str,
    on_page: Option<&'static str>,
    /// What they do.
    pub does: &'static str,
    /// What they ask for.
    pub command: Command,
    /// How it stands now, where that is worth saying.
    pub state: fn(&Look<'_>) -> Option<&'static str>,
}

const fn row(
    keys: &'static str,
    chords: &'static [(Held, Key)],
    does: &'static str,
    command: Command,
    state: fn(&Look<'_>) -> Option<&'static str>,
) -> Binding {
    Binding { chords, repeats: false, keys, on_page: Some(keys), does, command, state }
}

const fn repeating(
    keys: &'static str,
    chords: &'static [(Held, Key)],
    does: &'static str,
    command: Command,
) -> Binding {
    Binding { chords, repeats: true, keys, on_page: Some(keys), does, command, state: silent }
}

impl Binding {
    /// The same, with other keys on a page, or with none.
    const fn on_page(mut self, keys: Option<&'static str>) -> Self {
        self.on_page = keys;
        self
    }

    /// Its keys as people write them; none where they do nothing.
    #[must_use]
    pub fn keys(&self, front: Front) -> Option<&'static str> {
        match front {
            Front::Window => Some(self.keys),
            Front::Page => self.on_page,
        }
    }
}

fn silent(_: &Look<'_>) -> Option<&'static str> {
    None
}

fn on_off(is_on: bool) -> &'static str {
    if is_on { "on" } else { "off" }
}

use Held::{Any, Control, ControlShift, Down, Up};

/// The keys, in the order in which the help sheet shows them.
pub static BINDINGS: &[Binding] = &[
    row("Space", &[(Up, Key::Space)], "play or pause", Command::PlayPause, |look| {
        Some(if look.sim.clock.paused { "paused" } else { "playing" })
    }),
    repeating("→", &[(Up, Key::ArrowRight)], "one step on", Command::Step(1)),
    repeating("←", &[(Up, Key::ArrowLeft)], "one step back", Command::Step(-1)),
    row("Shift+Space", &[(Down, Key::Space)], "reverse time", Command::Reverse, |look| {
        Some(if look.sim.clock.speed < 0.0 { "backwards" } else { "forwards" })
    }),
    repeating("+", &[(Any, Key::Plus), (Up, Key::Equals)], "faster", Command::Faster),
    repeating("−", &[(Any, Key::Minus)], "slower", Command::Slower),
    row("R", &[(Up, Key::R)], "restart", Command::Restart, silent),
    row("Shift+R", &[(Down, Key::R)], "the scene as it was opened", Command::Reopen, silent),
    row("N", &[(Up, Key::N)], "to the next flip", Command::NextFlip, silent),
    row("Shift+N", &[(Down, Key::N)], "one flip again and again", Command::LoopFlip, |look| {
        Some(on_off(look.is_looping))
    }),
    row("Shift+S", &[(Down, Key::S)], "slow at each flip", Command::ToggleSlow, |look| {
        Some(on_off(look.scene.view.slow_at_flip))
    }),
    row(":, Shift+T", &[(Any, Key::Colon), (Down, Key::T)], "go to a time that is typed", Command::AskTime, silent),
    row("K", &[(Up, Key::K)], "poke", Command::Poke, silent),
    row("1", &[(Any, Key::Num1)], "spin about axis 1 (smallest moment)", Command::SpinAxis(1), silent),
    row("2", &[(Any, Key::Num2)], "spin about axis 2 (middle moment)", Command::SpinAxis(2), silent),
    row("3", &[(Any, Key::Num3)], "spin about axis 3 (largest moment)", Command::SpinAxis(3), silent),
    row("PageDown", &[(Up, Key::PageDown)], "next step, then the next scene", Command::NextStep, silent),
    row("PageUp", &[(Up, Key::PageUp)], "the step before, then the scene before", Command::PreviousStep, silent),
    row("Shift+PageDown", &[(Down, Key::PageDown)], "next scene", Command::NextScene, silent),
    row("Shift+PageUp", &[(Down, Key::PageUp)], "previous scene", Command::PreviousScene, silent),
    row(
        "A, B, .",
        &[(Up, Key::A), (Up, Key::B), (Up, Key::Period)],
        "the answer to the question",
        Command::ToggleAnswer,
        |look| (!look.scene.file.answer.trim().is_empty()).then(|| on_off(look.shown.answer)),
    ),
    row("F", &[(Up, Key::F)], "frame: world, body, both", Command::NextLayout, |look| {
        Some(match look.scene.view.layout {
            Layout::Both => "both",
            Layout::World => "world",
            Layout::Body => "body",
        })
    }),
    row("Home", &[(Up, Key::Home)], "camera home", Command::Home, silent),
    row("T", &[(Up, Key::T)], "theme", Command::ToggleTheme, |look| {
        Some(match look.scene.view.theme {
            Theme::Dark => "dark",
            Theme::Light => "light",
        })
    }),
    row("L", &[(Up, Key::L)], "names in the picture", Command::ToggleLabels, |look| {
        Some(on_off(look.scene.view.labels))
    }),
    row("S", &[(Up, Key::S)], "text of the scene", Command::ToggleSlide, |look| Some(on_off(look.shown.slide))),
    row("G", &[(Up, Key::G)], "graphs", Command::ToggleCharts, |look| Some(on_off(look.shown.charts))),
    row("P", &[(Up, Key::P)], "presenter's mode: large words, no panel", Command::TogglePresenter, |look| {
        Some(on_off(look.shown.presenting))
    }),
    row("Tab, M", &[(Up, Key::Tab), (Up, Key::M)], "panel", Command::TogglePanel, |look| {
        Some(on_off(look.shown.panel))
    })
    .on_page(Some("M")),
    row("F6", &[(Up, Key::F6)], "keyboard into the panel (Esc leaves)", Command::FocusPanel, silent).on_page(None),
    row("F11", &[(Up, Key::F11)], "full screen", Command::ToggleFullscreen, |look| Some(on_off(look.fullscreen)))
        .on_page(None),
    row("F12", &[(Up, Key::F12)], "write the picture", Command::Picture { transparent: false }, silent).on_page(None),
    row(
        "Shift+F12",
        &[(Down, Key::F12)],
        "write the picture, transparent",
        Command::Picture { transparent: true },
        silent,
    )
    .on_page(None),
    row("Ctrl+P", &[(Control, Key::P)], "write a handout: a page a step", Command::Handout, silent).on_page(None),
    row("Ctrl+C", &[(Control, Key::C)], "copy as command", Command::CopyCommand, silent),
    row("Ctrl+Z", &[(Control, Key::Z)], "take the last change back", Command::Undo, silent),
    row("Ctrl+Shift+Z", &[(ControlShift, Key::Z)], "make it again", Command::Redo, silent),
    row("Ctrl+S", &[(Control, Key::S)], "save the scene", Command::SaveScene, silent),
    row("Ctrl +", &[(Control, Key::Plus), (Control, Key::Equals)], "larger text", Command::TextSize(1.1), silent)
        .on_page(None),
    row("Ctrl −", &[(Control, Key::Minus)], "smaller text", Command::TextSize(1.0 / 1.1), silent).on_page(None),
    row("Ctrl 0", &[(Control, Key::Num0)], "usual text", Command::TextSize(0.0), silent).on_page(None),
    row(
        "H, F1",
        &[(Up, Key::H), (Any, Key::F1), (Any, Key::Questionmark)],
        "this help (Esc closes it)",
        Command::ToggleHelp,
        silent,
    ),
];

/// What a command does and its keys, for hints.
#[must_use]
pub fn hint_of(command: &Command, front: Front) -> String {
    let row = BINDINGS.iter().find(|binding| binding.command == *command);
    row.map_or_else(String::new, |binding| match binding.keys(front) {
        Some(keys) => format!("{} ({keys})", binding.does),
        None => binding.does.to_owned(),
    })
}

/// The keys of a command, for hints.
#[must_use]
pub fn keys_of(command: &Command, front: Front) -> Option<&'static str> {
    BINDINGS.iter().find(|binding| binding.command == *command)?.keys(front)
}

/// The file or folder that a text from a file manager's clipboard names: a path, or a `file:` address with `%20` for a space.
#[must_use]
pub fn path_in(text: &str) -> Option<String> {
    let line = text.lines().map(str::trim).find(|line| line.starts_with('/') || line.starts_with("file://"))?;
    let Some(address) = line.strip_prefix("file://") else { return Some(line.to_owned()) };
    let mut bytes = vec![];
    let mut rest = address.as_bytes();
    while let Some((&byte, after)) = rest.split_first() {
        let code = after.get(..2).and_then(|code| u8::from_str_radix(std::str::from_utf8(code).ok()?, 16).ok());
        let decoded = code.filter(|_| byte == b'%');
        bytes.push(decoded.unwrap_or(byte));
        rest = if decoded.is_some() { &after[2..] } else { after };
    }
    String::from_utf8(bytes).ok()
}

/// Takes the bound keys out of the input, and gives the commands they stand for.
///
/// While a widget has the keyboard everything is left to it, function keys aside.
pub fn take_commands(input: &mut RawInput, widget_has_keyboard: bool) -> Vec<Command> {
    let mut commands = Vec::new();
    input.events.retain(|event| {
        if *event == Event::Copy && !widget_has_keyboard {
            commands.push(Command::CopyCommand);
            return false;
        }
        if let Event::Paste(text) = event
            && !widget_has_keyboard
        {
            commands.push(Command::Paste(text.clone()));
            return false;
        }
        let Event::Key { key, pressed, repeat, modifiers, .. } = event else { return true };
        if modifiers.alt {
            return true;
        }
        let is_function_key = matches!(key, Key::F1 | Key::F6 | Key::F11 | Key::F12 | Key::PageUp | Key::PageDown);
        if widget_has_keyboard && !is_function_key && !modifiers.command {
            return true;
        }
        let found = BINDINGS.iter().find(|binding| {
            binding.chords.iter().any(|(held, bound)| {
                bound == key
                    && match held {
                        Up => !modifiers.shift && !modifiers.command,
                        Down => modifiers.shift && !modifiers.command,
                        Any => !modifiers.command,
                        Control => modifiers.command && !(modifiers.shift && *bound == Key::Z),
                        ControlShift => modifiers.command && modifiers.shift,
                    }
            })
        });
        let Some(binding) = found else { return true };
        if *pressed && (binding.repeats || !*repeat) {
            commands.push(binding.command.clone());
        }
        false
    });
    commands
}

#[cfg(test)]
mod tests {
    use super::path_in;

    #[test]
    fn a_copied_file_is_found_in_the_clipboard() {
        let path = |text: &str| Some(text.to_owned());
        assert_eq!(path_in("/home/me/flip.toml\n"), path("/home/me/flip.toml"));
        assert_eq!(path_in("copy\nfile:///tmp/my%20lecture/%C3%BC.toml"), path("/tmp/my lecture/ü.toml"));
        assert_eq!(path_in("file:///tmp/50%.toml"), path("/tmp/50%.toml"));
        assert_eq!(path_in("dzhanibekov shot flip"), None);
    }
}
