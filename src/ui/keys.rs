//! The keys: one table that the bindings and the help sheet both read.

use egui::{Event, Key, RawInput};

use super::{Command, Look};
use crate::scene::{Layout, Theme};

/// Whether a chord wants the Shift key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Shift {
    /// Without it.
    Up,
    /// With it.
    Down,
    /// Either way, as for signs that need it on some keyboards.
    Any,
}

/// A row of the table.
#[derive(Debug)]
pub struct Binding {
    chords: &'static [(Shift, Key)],
    /// Whether a held key repeats.
    repeats: bool,
    /// The keys as people write them.
    pub keys: &'static str,
    /// What they do.
    pub does: &'static str,
    command: Command,
    /// How it stands now, where that is worth saying.
    pub state: fn(&Look<'_>) -> Option<&'static str>,
}

const fn row(
    keys: &'static str,
    chords: &'static [(Shift, Key)],
    does: &'static str,
    command: Command,
    state: fn(&Look<'_>) -> Option<&'static str>,
) -> Binding {
    Binding { chords, repeats: false, keys, does, command, state }
}

const fn repeating(
    keys: &'static str,
    chords: &'static [(Shift, Key)],
    does: &'static str,
    command: Command,
) -> Binding {
    Binding { chords, repeats: true, keys, does, command, state: silent }
}

fn silent(_: &Look<'_>) -> Option<&'static str> {
    None
}

fn on_off(is_on: bool) -> &'static str {
    if is_on { "on" } else { "off" }
}

use Shift::{Any, Down, Up};

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
    row("1", &[(Up, Key::Num1)], "spin about axis 1 (smallest moment)", Command::SpinAxis(1), silent),
    row("2", &[(Up, Key::Num2)], "spin about axis 2 (middle moment)", Command::SpinAxis(2), silent),
    row("3", &[(Up, Key::Num3)], "spin about axis 3 (largest moment)", Command::SpinAxis(3), silent),
    row("PageDown", &[(Up, Key::PageDown)], "next scene", Command::NextScene, silent),
    row("PageUp", &[(Up, Key::PageUp)], "previous scene", Command::PreviousScene, silent),
    row("F", &[(Up, Key::F)], "frame: world, body, both", Command::NextLayout, |look| {
        Some(match look.view.layout {
            Layout::Both => "both",
            Layout::World => "world",
            Layout::Body => "body",
        })
    }),
    row("Home", &[(Up, Key::Home)], "camera home", Command::Home, silent),
    row("T", &[(Up, Key::T)], "theme", Command::ToggleTheme, |look| {
        Some(match look.view.theme {
            Theme::Dark => "dark",
            Theme::Light => "light",
        })
    }),
    row("Tab", &[(Up, Key::Tab)], "panel", Command::TogglePanel, |look| Some(on_off(look.panel_shown))),
    row("F6", &[(Up, Key::F6)], "keyboard into the panel (Esc leaves)", Command::FocusPanel, silent),
    row("F11", &[(Up, Key::F11)], "full screen", Command::ToggleFullscreen, |look| Some(on_off(look.fullscreen))),
    row("F12", &[(Up, Key::F12)], "write the picture", Command::Picture { transparent: false }, silent),
    row(
        "Shift+F12",
        &[(Down, Key::F12)],
        "write the picture, transparent",
        Command::Picture { transparent: true },
        silent,
    ),
    row("H, F1", &[(Up, Key::H), (Any, Key::F1), (Any, Key::Questionmark)], "this help", Command::ToggleHelp, silent),
];

/// The keys of a command, for hints.
#[must_use]
pub fn keys_of(command: &Command) -> Option<&'static str> {
    BINDINGS.iter().find(|binding| binding.command == *command).map(|binding| binding.keys)
}

/// Takes the bound keys out of the input, and gives the commands they stand for.
///
/// While a widget has the keyboard everything is left to it, function keys aside.
pub fn take_commands(input: &mut RawInput, widget_has_keyboard: bool) -> Vec<Command> {
    let mut commands = Vec::new();
    input.events.retain(|event| {
        let Event::Key { key, pressed, repeat, modifiers, .. } = event else { return true };
        if modifiers.ctrl || modifiers.alt || modifiers.command {
            return true;
        }
        let is_function_key = matches!(key, Key::F1 | Key::F6 | Key::F11 | Key::F12 | Key::PageUp | Key::PageDown);
        if widget_has_keyboard && !is_function_key {
            return true;
        }
        let found = BINDINGS.iter().find(|binding| {
            binding.chords.iter().any(|(shift, bound)| {
                bound == key
                    && match shift {
                        Up => !modifiers.shift,
                        Down => modifiers.shift,
                        Any => true,
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
