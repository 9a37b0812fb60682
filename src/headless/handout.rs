//! Pages of a handout: as pictures, or as one PDF of lines and texts.

use super::figure::{FigureFormat, figure_options, surfaces, written};
use super::paper::PictureSize;
use super::shot::{HeadlessError, Studio};
use crate::frame::Frame;
use crate::objects::{PAGE, PAGE_ON_PAPER, build_page};
use crate::render::Gpu;
use crate::render::png::{Remark, encode_marked};
use crate::scene::Scene;
use crate::sim::Simulation;
use crate::vector::{self, FigureOptions, FigureStyle, Sketch};

/// How large a page is.
#[must_use]
pub fn page_size() -> PictureSize {
    let density = f64::from(PAGE[0]) / PAGE_ON_PAPER[0] * 72.0;
    PictureSize { pixels: PAGE, paper: Some(PAGE_ON_PAPER), density: Some(density) }
}

/// The page of a scene at a time (s).
///
/// # Errors
/// A method that could not go on.
pub fn page(scene: &Scene, time: f64, has_answer: bool) -> Result<Frame, HeadlessError> {
    let mut simulation = Simulation::new(scene);
    if time != 0.0 {
        simulation.go_to(time);
    }
    match simulation.main().failure() {
        Some(failure) => Err(HeadlessError::Method(failure.to_string())),
        None => Ok(build_page(scene, &simulation, has_answer)),
    }
}

/// A page as the bytes of a PNG file.
///
/// # Errors
/// See [`HeadlessError`].
pub fn page_as_png(gpu: &Gpu, page: &Frame, remarks: &[Remark]) -> Result<Vec<u8>, HeadlessError> {
    let pixels = Studio::new(gpu, PAGE)?.draw(page)?;
    Ok(encode_marked(&pixels, false, remarks, page_size().pixels_per_metre())?)
}

/// A page as the bytes of an SVG file.
///
/// # Errors
/// See [`HeadlessError`].
pub fn page_as_svg(gpu: &Gpu, page: &Frame, remarks: &[Remark]) -> Result<Vec<u8>, HeadlessError> {
    written(sketch(page), surfaces(gpu, page, page_size())?, FigureFormat::Svg, remarks)
}

/// All pages as the bytes of one PDF file.
///
/// # Errors
/// See [`HeadlessError`].
pub fn pages_as_pdf(gpu: &Gpu, pages: &[Frame], remarks: &[Remark]) -> Result<Vec<u8>, HeadlessError> {
    let mut drawn = vec![];
    for page in pages {
        drawn.push((sketch(page), surfaces(gpu, page, page_size())?));
    }
    Ok(vector::pdf(drawn, &options(), remarks)?)
}

/// The lines, marks and texts of a page.
fn sketch(page: &Frame) -> Sketch {
    Sketch::new(page, &options())
}

/// How a page is written.
fn options() -> FigureOptions {
    figure_options(page_size(), FigureStyle::default())
}
