//! What panels and keys ask for. Nothing in `ui` changes anything itself.

use std::path::PathBuf;

use crate::scene::{Layout, SceneFile};

/// A point of the picture or a distance in it, in physical pixels.
pub type Pixels = glam::Vec2;

/// A wish of the user.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Runs or pauses.
    PlayPause,
    /// Pauses and takes this many steps.
    Step(i64),
    /// Turns time round.
    Reverse,
    /// Twice as fast.
    Faster,
    /// Half as fast.
    Slower,
    /// This many simulated seconds a real second; the direction stays.
    SetSpeed(f64),
    /// Back to the start.
    Restart,
    /// Goes to this time (s).
    GoTo(f64),
    /// To shortly before the next flip.
    NextFlip,
    /// Changes the scene's text; body and start take hold at once.
    Edit(Box<SceneFile>),
    /// Spin about this principal axis, tilt and rate as they are.
    SpinAxis(u8),
    /// A start of the same momentum with this energy (J).
    SetEnergy(f64),
    /// A start of the same momentum on the separatrix.
    ToSeparatrix,
    /// A small nudge to the body as it turns, which keeps the momentum.
    Poke,
    /// The pointer is here over the picture, or nowhere.
    Hover(Option<Pixels>),
    /// Starts with the body momentum where the sphere was clicked.
    Pick(Pixels),
    /// Starts with the body momentum where the tip of M is dragged to.
    DragTip(Pixels),
    /// The scene as it was opened.
    Reopen,
    /// The next scene.
    NextScene,
    /// The scene before.
    PreviousScene,
    /// Opens the scene at this place in the list.
    OpenScene(usize),
    /// Opens a scene file.
    OpenFile(PathBuf),
    /// Turns the camera of the view under the pointer.
    Orbit {
        /// Where the pointer is.
        at: Pixels,
        /// How far it moved.
        by: Pixels,
    },
    /// Moves the camera of the view under the pointer sideways.
    Pan {
        /// Where the pointer is.
        at: Pixels,
        /// How far it moved.
        by: Pixels,
    },
    /// Brings the camera of the view under the pointer nearer (above 1) or farther.
    Zoom {
        /// Where the pointer is.
        at: Pixels,
        /// The factor.
        by: f32,
    },
    /// All cameras back to where they were.
    Home,
    /// Shows world, body, or both.
    SetLayout(Layout),
    /// The next of world, body, both.
    NextLayout,
    /// Draws something, or leaves it out.
    Show {
        /// Its name in scene files.
        name: &'static str,
        /// Whether it is drawn.
        is_shown: bool,
    },
    /// Dark or light.
    ToggleTheme,
    /// Shows or hides the panel.
    TogglePanel,
    /// Shows or hides the scene's title, text and question.
    ToggleSlide,
    /// Shows or hides the charts.
    ToggleCharts,
    /// Names beside things, or not.
    ToggleLabels,
    /// Larger text (above 1) or smaller; 0 is the usual size.
    TextSize(f32),
    /// Shows or hides the sheet of keys.
    ToggleHelp,
    /// Full screen or back.
    ToggleFullscreen,
    /// Writes the picture to a file.
    Picture {
        /// With no background.
        transparent: bool,
    },
    /// The command that draws this picture, to the clipboard.
    CopyCommand,
    /// Writes the scene to a file.
    SaveScene,
    /// Moves the keyboard's focus into the panel.
    FocusPanel,
}
