//! Pictures with no window and no event loop.

mod file;
mod png;
mod shot;

pub use file::{Output, write};
pub use png::encode;
pub use shot::{HeadlessError, ShotOptions, Studio, shot};
