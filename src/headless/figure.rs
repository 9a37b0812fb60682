//! One figure of vectors, over its surfaces as pixels.

use super::paper::{PictureSize, THINNEST_LINE};
use super::shot::{HeadlessError, ShotOptions, Studio};
use crate::frame::Frame;
use crate::objects::Cameras;
use crate::render::Gpu;
use crate::render::png::Remark;
use crate::scene::Scene;
use crate::sim::Simulation;
use crate::vector::{self, FigureOptions, FigureStyle, Shading, Sketch, Surfaces};

/// Points of paper (1/72 in) of a pixel for screens, of which an inch has 96.
const SCREEN: f64 = 72.0 / 96.0;
/// Largest width and height (pixels) of what is vectors alone: up to there an f32 holds places to a 256th of a pixel.
const LARGEST: u32 = 1 << 15;

/// What a figure is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FigureFormat {
    /// SVG.
    Svg,
    /// PDF.
    Pdf,
}

impl FigureFormat {
    /// What the names of such files end in.
    #[must_use]
    pub fn ending(self) -> &'static str {
        match self {
            Self::Svg => "svg",
            Self::Pdf => "pdf",
        }
    }
}

/// Draws a scene as its simulation is now, by its own view: the bytes of a file. The device that the options open is asked for
/// only where surfaces are pixels: what is vectors alone needs none.
///
/// # Errors
/// See [`HeadlessError`]; what `open` returns.
pub fn figure<E: From<HeadlessError>>(
    open: impl FnOnce() -> Result<Gpu, E>,
    scene: &Scene,
    simulation: &Simulation,
    options: &ShotOptions,
    (style, format): (FigureStyle, FigureFormat),
    remarks: &[Remark],
) -> Result<Vec<u8>, E> {
    let frame = options.frame(scene, simulation, &Cameras::new(&scene.view));
    figure_of(open, &frame, options.size, (style, format), remarks)
}

/// The same of a frame for figures of this size. Its lines are found out while the device is opened and draws the surfaces.
pub(super) fn figure_of<E: From<HeadlessError>>(
    open: impl FnOnce() -> Result<Gpu, E>,
    frame: &Frame,
    size: PictureSize,
    (style, format): (FigureStyle, FigureFormat),
    remarks: &[Remark],
) -> Result<Vec<u8>, E> {
    let options = figure_options(size, style);
    if style.shading == Shading::Flat {
        let [width, height] = size.pixels;
        if width.min(height) == 0 || width.max(height) > LARGEST {
            return Err(HeadlessError::FigureSize { width, height, largest: LARGEST }.into());
        }
        return Ok(written(Sketch::new(frame, &options), Surfaces::default(), format, remarks)?);
    }
    let sketch = || Sketch::new(frame, &options);
    std::thread::scope(|scope| {
        // Where no other thread can be had, one after the other.
        let ahead = std::thread::Builder::new().spawn_scoped(scope, sketch).ok();
        let surfaces = surfaces(&open()?, frame, size)?;
        let sketch = match ahead {
            Some(thread) => thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
            None => sketch(),
        };
        Ok(written(sketch, surfaces, format, remarks)?)
    })
}

/// A figure over its surfaces as the bytes of a file.
pub(super) fn written(
    sketch: Sketch,
    surfaces: Surfaces,
    format: FigureFormat,
    remarks: &[Remark],
) -> Result<Vec<u8>, HeadlessError> {
    let options = *sketch.options();
    Ok(match format {
        FigureFormat::Svg => vector::svg(sketch, &surfaces, remarks)?.into_bytes(),
        FigureFormat::Pdf => vector::pdf(vec![(sketch, surfaces)], &options, remarks)?,
    })
}

/// The surfaces of a frame, drawn.
pub(super) fn surfaces(gpu: &Gpu, frame: &Frame, size: PictureSize) -> Result<Surfaces, HeadlessError> {
    let mut studio = Studio::new(gpu, size.pixels)?;
    let mut drawn = |frame: Option<Frame>| frame.map(|frame| studio.draw(&frame)).transpose();
    let [below, above] = vector::surfaces(frame);
    Ok(Surfaces { below: drawn(below)?, above: drawn(above)? })
}

/// How large a figure is that has the size of this picture.
pub(super) fn figure_options(size: PictureSize, style: FigureStyle) -> FigureOptions {
    let marked = size.density.map(|density| size.pixels.map(|pixels| f64::from(pixels) / density * 72.0));
    let paper = size.paper.or(marked);
    let point = paper.map_or(SCREEN, |[width, _]| width / f64::from(size.pixels[0]));
    FigureOptions { size: size.pixels, paper, thinnest: THINNEST_LINE / point, style }
}
