//! How a [`Frame`](crate::frame::Frame) is drawn: wgpu, one file a primitive, the same for window and file.

mod attempts;
mod buffer;
mod glyphs;
mod gpu;
mod labels;
#[cfg(test)]
mod layout_test;
mod line;
mod notes;
mod pipeline;
pub mod png;
mod point;
mod quadrics;
mod readback;
mod renderer;
mod resolve;
mod solid;
mod targets;
mod text;
mod touched;
mod transfer;
mod view;

pub use gpu::{AdapterDescription, Gpu, GpuError, adapters, no_adapter};
pub use readback::{Canvas, Pixels, Reading};
pub use renderer::{Renderer, point_size};
pub use targets::FORMAT;
pub use transfer::Transfer;
