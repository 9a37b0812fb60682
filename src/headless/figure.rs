//! One figure of vectors, over its surfaces as pixels.

use super::shot::{HeadlessError, ShotOptions, Studio};
use crate::objects::{Cameras, build_frame};
use crate::render::Gpu;
use crate::render::png::Remark;
use crate::scene::Scene;
use crate::sim::Simulation;
use crate::vector::{self, FigureOptions, Surfaces};

/// What a figure is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FigureFormat {
    /// SVG.
    Svg,
}

/// Draws a scene as its simulation is now, by its own view, on the device that the options opened: the bytes of a file. The
/// size is that of `figure`.
///
/// # Errors
/// See [`HeadlessError`].
pub fn figure(
    gpu: &Gpu,
    scene: &Scene,
    simulation: &Simulation,
    shot: &ShotOptions,
    figure: &FigureOptions,
    format: FigureFormat,
    remarks: &[Remark],
) -> Result<Vec<u8>, HeadlessError> {
    let [width, height] = figure.size;
    let mut frame = build_frame(scene, simulation, &Cameras::new(&scene.view), width as f32 / height as f32);
    frame.transparent = shot.transparent;
    let mut studio = Studio::new(gpu, figure.size)?;
    let [below, above] = vector::surfaces(&frame);
    let mut drawn = |frame: Option<crate::frame::Frame>| frame.map(|frame| studio.draw(&frame)).transpose();
    let surfaces = Surfaces { below: drawn(below)?, above: drawn(above)? };
    Ok(match format {
        FigureFormat::Svg => vector::svg(&frame, &surfaces, figure, remarks)?.into_bytes(),
    })
}
