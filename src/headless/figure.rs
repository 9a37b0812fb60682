//! One figure of vectors, over its surfaces as pixels.

use super::paper::{PictureSize, THINNEST_LINE};
use super::shot::{HeadlessError, ShotOptions, Studio};
use crate::frame::Frame;
use crate::objects::Cameras;
use crate::render::Gpu;
use crate::render::png::Remark;
use crate::scene::Scene;
use crate::sim::Simulation;
use crate::vector::{self, FigureOptions, FigureStyle, Shading, Surfaces};

/// Points of paper (1/72 in) of a pixel for screens, of which an inch has 96.
const SCREEN: f64 = 72.0 / 96.0;

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

/// Draws a scene as its simulation is now, by its own view, on the device that the options opened: the bytes of a file.
///
/// # Errors
/// See [`HeadlessError`].
pub fn figure(
    gpu: &Gpu,
    scene: &Scene,
    simulation: &Simulation,
    options: &ShotOptions,
    style: FigureStyle,
    format: FigureFormat,
    remarks: &[Remark],
) -> Result<Vec<u8>, HeadlessError> {
    let frame = options.frame(scene, simulation, &Cameras::new(&scene.view));
    figure_of(gpu, &frame, options.size, style, format, remarks)
}

/// The same of a frame for figures of this size.
pub(super) fn figure_of(
    gpu: &Gpu,
    frame: &Frame,
    size: PictureSize,
    style: FigureStyle,
    format: FigureFormat,
    remarks: &[Remark],
) -> Result<Vec<u8>, HeadlessError> {
    let surfaces = match style.shading {
        Shading::Pixels => surfaces(gpu, frame, size)?,
        Shading::Flat => Surfaces::default(),
    };
    let options = figure_options(size, style);
    Ok(match format {
        FigureFormat::Svg => vector::svg(frame, &surfaces, &options, remarks)?.into_bytes(),
        FigureFormat::Pdf => vector::pdf(frame, &surfaces, &options, remarks)?,
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
