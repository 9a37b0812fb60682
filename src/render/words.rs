//! What lies on the screen before the panes, laid out with no device: for figures of vectors, whose texts stand where those of
//! a picture stand.

use glam::Vec2;

use super::glyphs::{self, Glyphs, Letter};
use super::notes;
use super::pane::PaneUniform;
use super::renderer::point_size;
use super::text::{self, lay_out_labels};
use crate::frame::{Color, Frame, Line, Marker};

/// A text in its place.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedText {
    /// Its letters, from its upper left corner.
    pub letters: Vec<Letter>,
    /// That corner, in pixels of the pane.
    pub corner: Vec2,
    /// The colour, faded where the text makes room for another.
    pub color: Color,
}

/// What lies before one pane.
#[derive(Clone, Debug, PartialEq)]
pub struct ScreenLayer {
    /// The texts; no halo covers the ink of another.
    pub texts: Vec<PlacedText>,
    /// The lines of the legend and from names to what they name, in pixels from the pane's upper left corner.
    pub lines: Vec<Line>,
    /// Its marks, in the same pixels.
    pub markers: Vec<Marker>,
}

/// The halo behind the texts of a frame, from the inmost part on: how far it reaches beyond the ink (pixels), its colour with
/// its opacity there, in a picture of this size.
#[must_use]
pub fn halo(frame: &Frame, size: [u32; 2]) -> [(f32, Color); 2] {
    let reach = text::HALO * point_size(size) * frame.font_scale;
    let color = |part: f32| frame.background.alpha(text::HALO_OPACITY * part);
    [(glyphs::HALO_INNER * reach, color(1.0)), (reach, color(f32::from(glyphs::HALO_OUTER) / 256.0))]
}

/// What lies before each pane of a picture of this size.
#[must_use]
pub fn screen_layers(frame: &Frame, size: [u32; 2]) -> Vec<ScreenLayer> {
    let point = point_size(size) * frame.font_scale;
    let picture = Vec2::new(size[0] as f32, size[1] as f32);
    let mut glyphs = Glyphs::new();
    let panes = frame.panes.iter().map(|pane| {
        let pixels = pane.area.extent * picture;
        let uniform = PaneUniform::new(pane, pixels.max(Vec2::ONE), point);
        let notes = notes::lay_out(&pane.notes, &mut glyphs, pixels, point);
        let (mut lines, markers) = notes::swatches(&notes, point);
        let labels = lay_out_labels(&mut glyphs, pane, &uniform, &notes, point);
        lines.extend(labels.iter().filter_map(|label| label.leader.clone()));
        let labels = labels.into_iter().map(|label| (label.line, label.low, label.color));
        let texts = labels.chain(notes.into_iter().map(|note| (note.line, note.low, note.color)));
        let placed = texts.map(|(line, corner, color)| PlacedText { letters: line.letters, corner, color });
        ScreenLayer { texts: placed.collect(), lines, markers }
    });
    panes.collect()
}
