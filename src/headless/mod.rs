//! Pictures with no window and no event loop.

mod png;
mod shot;

pub use png::encode;
pub use shot::{HeadlessError, ShotOptions, Studio, shot};
