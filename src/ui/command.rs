//! What panels and keys ask for. Nothing in `ui` changes anything itself.

use crate::scene::{BodyFile, Layout};

/// A point of the picture or a distance in it, in physical pixels.
pub type Pixels = glam::Vec2;

/// Something the user asks for. A command carries the part that it changes and nothing else, so that two of them in one
/// frame both hold.
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
    /// Asks which time to go to.
    AskTime,
    /// Leaves the question for a time unanswered.
    AskNothing,
    /// To the next flip.
    NextFlip,
    /// Runs through one flip again and again, or no longer.
    LoopFlip,
    /// Slows the clock round each flip, or no longer.
    ToggleSlow,
    /// Takes this body instead; the start stays as it is said.
    SetBody(Box<BodyFile>),
    /// Spin about this principal axis, tilt and rate as they are.
    SpinAxis(u8),
    /// Tilts the spin this far (degrees) from its axis, in the direction in which it is tilted.
    SetTilt(f64),
    /// Spins this fast (rad/s) about the same line.
    SetRate(f64),
    /// A start of the same momentum with this energy (J).
    SetEnergy(f64),
    /// A start of the same momentum on the separatrix.
    ToSeparatrix,
    /// Turns the body a little under its momentum, which stays.
    Poke,
    /// Follows the motion by the method of this name.
    SetMethod(&'static str),
    /// Takes steps of this length (s).
    SetStep(f64),
    /// Loses energy inside the body at this rate, a number without a unit; 0 for none. The method that knows it follows.
    SetEnergyLoss(f64),
    /// Runs a method beside it from the same start, or no longer.
    Compare {
        /// Its name.
        method: &'static str,
        /// Whether it runs.
        is_on: bool,
    },
    /// The pointer is here over the picture, or nowhere.
    Hover(Option<Pixels>),
    /// Starts with the body momentum where the sphere was clicked.
    Pick(Pixels),
    /// Starts with the body momentum where the tip of M is dragged to.
    DragTip(Pixels),
    /// Takes the last change back.
    Undo,
    /// Makes the change again that was taken back last.
    Redo,
    /// The scene as it was opened.
    Reopen,
    /// The next step of the scene, or the next scene after the last one.
    NextStep,
    /// The step before, or the scene before.
    PreviousStep,
    /// This step of the scene, counted from 0.
    GoToStep(usize),
    /// The next scene.
    NextScene,
    /// The scene before.
    PreviousScene,
    /// Opens the scene at this place in the list.
    OpenScene(usize),
    /// Opens what a place names: a scene file, or a folder of them.
    OpenPlace(String),
    /// Opens the text of a scene.
    OpenText {
        /// What it came from, for people.
        name: String,
        /// The text (TOML).
        text: String,
    },
    /// Opens the scene of a link, at its time.
    OpenLink(String),
    /// Lets a file be chosen, and opens it.
    ChooseFile,
    /// Takes what was pasted: the text of a scene, a link, or a place where one is.
    Paste(String),
    /// The picture is this large (pixels).
    Resize(Pixels),
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
    /// Presenter's mode, or no longer: large words, no panel, a slim strip.
    TogglePresenter,
    /// Shows or hides the panel.
    TogglePanel,
    /// Shows or hides the scene's title, text and question.
    ToggleSlide,
    /// Shows or hides the answer to the scene's question.
    ToggleAnswer,
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
    /// Writes the scene's steps as pages.
    Handout,
    /// The command that draws this picture, to the clipboard.
    CopyCommand,
    /// The link of the scene as it is, to the clipboard.
    CopyLink,
    /// Keeps the scene: at once in a new file, or, where it came from a file, after asking whether that one is meant.
    SaveScene,
    /// Writes the scene to this place; a new file where there is none.
    SaveTo(Option<String>),
    /// Leaves a question about saving unanswered.
    SaveNothing,
    /// Shows a sentence for a while.
    Say(String),
    /// Moves the keyboard's focus into the panel.
    FocusPanel,
}
