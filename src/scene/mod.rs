//! What a scene says: the body, how it spins, by which method it is followed and how it is looked at.
//!
//! [`SceneFile`] is the text as written, part by part and all of it optional; [`Scene`] is the same thing checked,
//! with the body and the starting state worked out. The command line and the window change a [`SceneFile`]
//! and check it again, so there is one way in.

mod check;
mod command;
mod file;
mod nearest;
mod parts;
mod presets;
mod view;

pub use check::{DEFAULT_EDGES, Scene, SceneError};
pub use command::{flags, quoted};
pub use file::{BodyFile, MotionFile, SceneFile, SolidFile, SpinFile, ViewFile};
pub use nearest::nearest;
pub use parts::{Part, PartKind};
pub use presets::{DEFAULT_PRESET, Preset, preset, presets};
pub use view::{Layout, Theme, View};
