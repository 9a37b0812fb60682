//! One picture.

use super::png::{Note, encode};
use crate::frame::Frame;
use crate::objects::{Cameras, build_frame};
use crate::render::{Canvas, Gpu, GpuError, Pixels, Renderer, point_size};
use crate::sim::Simulation;

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum HeadlessError {
    /// A size that no picture has.
    #[error("size {width}x{height} cannot be drawn: both must be between 1 and {largest}")]
    Size {
        /// The width asked for.
        width: u32,
        /// The height asked for.
        height: u32,
        /// The most that the adapter draws.
        largest: u32,
    },
    /// No adapter, or one that failed.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The method could not go on.
    #[error("{0}")]
    Method(String),
    /// The picture could not be encoded.
    #[error("the picture could not be encoded: {0}")]
    Encoding(#[from] png::EncodingError),
}

impl HeadlessError {
    /// Whether the request was wrong, rather than this machine unable.
    #[must_use]
    pub fn is_bad_request(&self) -> bool {
        matches!(self, Self::Size { .. } | Self::Gpu(GpuError::NoSuchAdapter { .. }))
    }
}

/// What a picture with no window is to be like, besides its scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ShotOptions {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Leave the background out.
    pub transparent: bool,
    /// Part of the name of the adapter to draw with.
    pub adapter: Option<String>,
}

impl Default for ShotOptions {
    fn default() -> Self {
        Self { size: [1280, 720], transparent: false, adapter: None }
    }
}

impl ShotOptions {
    /// Opens a device that can draw this size.
    ///
    /// # Errors
    /// No adapter, or a size that it cannot draw.
    pub fn open(&self) -> Result<Gpu, HeadlessError> {
        let [width, height] = self.size;
        let refused = |largest| Err(HeadlessError::Size { width, height, largest });
        if width == 0 || height == 0 {
            return refused(8192);
        }
        let gpu = Gpu::headless(self.adapter.as_deref())?;
        let largest = gpu.largest_side();
        if width.max(height) > largest {
            return refused(largest);
        }
        Ok(gpu)
    }
}

/// A device with everything that draws pictures of one size, to be used again for each frame.
pub struct Studio {
    gpu: Gpu,
    renderer: Renderer,
    canvas: Canvas,
}

impl Studio {
    /// Opens a device.
    ///
    /// # Errors
    /// No adapter, or a size that it cannot draw.
    pub fn new(options: &ShotOptions) -> Result<Self, HeadlessError> {
        let gpu = options.open()?;
        let renderer = Renderer::new(&gpu);
        let canvas = Canvas::new(&gpu, options.size);
        gpu.check()?;
        Ok(Self { gpu, renderer, canvas })
    }

    /// Draws a frame.
    ///
    /// # Errors
    /// What the device reports.
    pub fn draw(&mut self, frame: &Frame) -> Result<Pixels, HeadlessError> {
        let size = self.canvas.size();
        self.renderer.render(&self.gpu, frame, self.canvas.view(), size, point_size(size));
        Ok(self.canvas.read(&self.gpu)?)
    }

    /// The aspect of the pictures: width over height.
    #[must_use]
    pub fn aspect(&self) -> f32 {
        let [width, height] = self.canvas.size();
        width as f32 / height as f32
    }
}

/// Draws a simulation as it is now, by its scene's own view: the bytes of a PNG file.
///
/// # Errors
/// See [`HeadlessError`].
pub fn shot(simulation: &Simulation, options: &ShotOptions, notes: &[Note]) -> Result<Vec<u8>, HeadlessError> {
    let mut studio = Studio::new(options)?;
    let view = &simulation.scene().view;
    let mut frame = build_frame(simulation, view, &Cameras::new(view), studio.aspect());
    frame.transparent = options.transparent;
    let pixels = studio.draw(&frame)?;
    Ok(encode(&pixels, options.transparent, notes)?)
}
