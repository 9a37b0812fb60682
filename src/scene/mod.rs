//! What a scene says: the body, how it spins, by which method it is followed and how it is looked at.
//!
//! [`SceneFile`] is the text as written, part by part and all of it optional; [`Scene`] is the same thing checked,
//! with the body and the starting state worked out. [`KEYS`] is the table of all that a scene can say: files, flags,
//! `--set` and links are read and written by it. The command line and the window change a [`SceneFile`]
//! and check it again, so there is one way in.

pub mod carried;
mod check;
mod cloud;
mod command;
mod edit;
mod field;
mod file;
mod keys;
pub mod link;
mod nearest;
mod parts;
mod presets;
mod read;
mod step;
#[cfg(test)]
mod tests;
mod value;
mod view;
mod warnings;
mod word;
mod write;

pub use check::{DEFAULT_EDGES, SPEEDS, Scene, SceneError};
pub use cloud::Cloud;
pub use command::{flags, quoted};
pub use edit::{Edit, Edits};
pub use field::Kind;
pub use file::{BodyFile, CameraFile, CloudFile, MotionFile, SceneFile, SolidFile, SpinFile, ViewFile};
pub use keys::{Flag, KEYS, Key, SOLID_KEYS, STEP_KEYS, inside, key};
pub use nearest::nearest;
pub use parts::{Part, PartKind};
pub use presets::{DEFAULT_PRESET, Preset, preset, presets};
pub use step::{ALL, Pace, StepFile, Written};
pub use value::{Entry, Item, Value};
pub use view::{Layout, Theme, TimeUnit, View};
pub use word::one_number;
