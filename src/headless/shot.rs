//! One picture.

use super::fault;
use super::paper::PictureSize;
use crate::frame::Frame;
use crate::objects::{Cameras, build_frame_scaled};
use crate::render::png::{EncodingError, Remark, encode_rows};
use crate::render::{Canvas, Gpu, GpuError, Painter, Pixels};
use crate::scene::Scene;
use crate::sim::Simulation;

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum HeadlessError {
    /// A size that no picture has.
    #[error(
        "size {width}x{height} cannot be drawn: both must be between 1 and {largest}, and a picture has at most {most} pixels"
    )]
    Size {
        /// The width asked for.
        width: u32,
        /// The height asked for.
        height: u32,
        /// The largest side that the adapter draws.
        largest: u32,
        /// The most pixels that it draws at once.
        most: u64,
    },
    /// A size that no figure of vectors alone has.
    #[error("size {width}x{height} cannot be drawn: both must be between 1 and {largest}")]
    FigureSize {
        /// The width asked for.
        width: u32,
        /// The height asked for.
        height: u32,
        /// The largest of either.
        largest: u32,
    },
    /// No adapter, or one that failed.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The method could not go on.
    #[error("{0}")]
    Method(String),
    /// The system gives no thread.
    #[error("no thread could be had to write what is drawn: {0}")]
    Thread(std::io::Error),
    /// The picture could not be encoded.
    #[error("the picture could not be encoded: {0}")]
    Encoding(#[from] EncodingError),
}

impl HeadlessError {
    /// Whether the request was wrong, rather than this machine unable.
    #[must_use]
    pub fn is_bad_request(&self) -> bool {
        matches!(self, Self::Size { .. } | Self::FigureSize { .. } | Self::Gpu(GpuError::NoSuchAdapter { .. }))
    }
}

/// What a picture with no window is to be like, besides its scene.
#[derive(Clone, Debug, PartialEq)]
pub struct ShotOptions {
    /// How large it is.
    pub size: PictureSize,
    /// Leave the background out.
    pub transparent: bool,
    /// Part of the name of the adapter to draw with.
    pub adapter: Option<String>,
}

impl Default for ShotOptions {
    fn default() -> Self {
        Self { size: PictureSize::in_pixels([1280, 720]), transparent: false, adapter: None }
    }
}

impl ShotOptions {
    /// Opens a device that can draw this size.
    ///
    /// # Errors
    /// No adapter, or a size that it cannot draw.
    pub fn open(&self) -> Result<Gpu, HeadlessError> {
        let [width, height] = self.size.pixels;
        let refused = |largest, most| Err(HeadlessError::Size { width, height, largest, most });
        if width == 0 || height == 0 {
            return refused(8192, 1 << 26);
        }
        let gpu = pollster::block_on(Gpu::headless(self.adapter.as_deref()))?;
        if !Canvas::fits(&gpu, self.size.pixels) {
            return refused(gpu.largest_side(), Canvas::most_pixels(&gpu));
        }
        fault::after(0, &gpu);
        Ok(gpu)
    }

    /// The picture of a scene as its simulation is now, with type and lines of the size that is right on this one.
    #[must_use]
    pub fn frame(&self, scene: &Scene, simulation: &Simulation, cameras: &Cameras) -> Frame {
        let [width, height] = self.size.pixels;
        let aspect = width as f32 / height as f32;
        let mut frame = build_frame_scaled(scene, simulation, cameras, aspect, self.size.type_scale());
        frame.transparent = self.transparent;
        frame
    }
}

/// Everything that draws pictures of one size, to be used again for each frame.
pub struct Studio<'a> {
    gpu: &'a Gpu,
    painter: Painter,
    canvas: Canvas,
}

impl<'a> Studio<'a> {
    /// Prepares pictures of this size on a device that can draw them (see [`ShotOptions::open`]).
    ///
    /// # Errors
    /// What the device reports.
    pub fn new(gpu: &'a Gpu, size: [u32; 2]) -> Result<Self, HeadlessError> {
        let painter = Painter::new(gpu);
        let canvas = Canvas::new(gpu, size);
        gpu.check()?;
        Ok(Self { gpu, painter, canvas })
    }

    /// Draws a frame.
    ///
    /// # Errors
    /// What the device reports.
    pub fn draw(&mut self, frame: &Frame) -> Result<Pixels, HeadlessError> {
        let reading = self.painter.draw_on(self.gpu, &self.canvas, frame);
        Ok(self.canvas.finish_read(self.gpu, &reading)?)
    }
}

/// Draws a scene as its simulation is now, by its own view, on the device that the options opened: the bytes of a
/// PNG file.
///
/// # Errors
/// See [`HeadlessError`].
pub fn shot(
    gpu: &Gpu,
    scene: &Scene,
    simulation: &Simulation,
    options: &ShotOptions,
    remarks: &[Remark],
) -> Result<Vec<u8>, HeadlessError> {
    let frame = options.frame(scene, simulation, &Cameras::new(&scene.view));
    let size = options.size.pixels;
    encode_rows(size, options.transparent, remarks, options.size.pixels_per_metre(), |take| {
        Painter::new(gpu).draw_rows(gpu, &frame, size, |row| take(row).map_err(HeadlessError::from))
    })
}
