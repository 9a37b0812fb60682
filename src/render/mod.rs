//! How a [`Frame`](crate::frame::Frame) is drawn: wgpu, one file a primitive, the same for window, page and file.

mod attempts;
mod buffer;
mod compose;
mod dots;
mod glyphs;
mod gpu;
mod labels;
#[cfg(test)]
mod layout_test;
pub mod light;
mod line;
mod marker;
mod mesh;
mod notes;
mod outline;
mod overlay;
mod painter;
mod pane;
mod part;
mod pipeline;
pub mod png;
mod quadrics;
mod readback;
mod renderer;
mod solids;
mod targets;
mod text;
mod words;

pub use glyphs::{Letter, TYPEFACES};
pub use gpu::{AdapterDescription, Gpu, GpuError, adapters, no_adapter};
pub use painter::Painter;
pub use readback::{Canvas, Pixels, Reading};
pub use renderer::point_size;
pub use targets::FORMAT;
pub use words::{PlacedText, ScreenLayer, halo, screen_layers};
