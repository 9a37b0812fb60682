//! Pictures with no window and no event loop.

mod shot;

pub use shot::{HeadlessError, ShotOptions, Studio, shot};
