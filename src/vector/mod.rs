//! Figures of vectors: a [`Frame`](crate::frame::Frame) as SVG or PDF. Lines, marks and texts are written as what they are, cut
//! where surfaces hide them by solving for it; the shaded surfaces lie under them as pixels that [`render`](crate::render) has drawn, or as flat areas.
//!
//! What is drawn and where is the picture's: the same frame, the same places of labels, the same order.

mod dots;
mod drawing;
mod facets;
mod figure;
mod flats;
mod fonts;
mod lines;
mod marks;
mod metadata;
mod pdf;
mod shells;
mod sight;
#[cfg(test)]
mod sight_test;
mod svg;

use crate::render::png::{EncodingError, Remark};

pub use figure::{Sketch, Surfaces, surfaces};

/// How texts are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Letters {
    /// As text, with the fonts in the file.
    #[default]
    Text,
    /// As outlines, which need no font.
    Outlines,
}

/// How shaded surfaces are drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shading {
    /// As pixels, beneath the lines.
    #[default]
    Pixels,
    /// As areas of one colour or a gradient: all is vectors.
    Flat,
}

/// How a figure is written, whatever its size.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FigureStyle {
    /// Its texts.
    pub letters: Letters,
    /// Its surfaces.
    pub shading: Shading,
}

/// What a figure is to be like, besides its frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FigureOptions {
    /// Width and height in pixels, as those of the picture would be.
    pub size: [u32; 2],
    /// Its width and height on paper, in points of 1/72 in; none where it is for a screen, a pixel being one of browsers'.
    pub paper: Option<[f64; 2]>,
    /// Width of the thinnest line that is written (pixels).
    pub thinnest: f64,
    /// How it is written.
    pub style: FigureStyle,
}

/// A figure as SVG, over its surfaces drawn as pixels. The remarks are kept in its metadata.
///
/// # Errors
/// None but for pixels that cannot be encoded.
pub fn svg(sketch: Sketch, surfaces: &Surfaces, remarks: &[Remark]) -> Result<String, EncodingError> {
    let options = *sketch.options();
    svg::write(&sketch.over(surfaces), &options, remarks)
}

/// Figures of one size, each over its surfaces, as the pages of one PDF, as large as they are.
///
/// # Errors
/// None but for pixels that cannot be encoded.
pub fn pdf(
    pages: Vec<(Sketch, Surfaces)>,
    options: &FigureOptions,
    remarks: &[Remark],
) -> Result<Vec<u8>, EncodingError> {
    let drawings: Vec<_> = pages.into_iter().map(|(sketch, surfaces)| sketch.over(&surfaces)).collect();
    pdf::write(&drawings, options, remarks)
}
