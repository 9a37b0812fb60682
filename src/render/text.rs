//! Texts: glyphs of an atlas as quads, with a halo that keeps them readable over anything.

use glam::Vec2;

use super::glyphs::{Glyphs, PlacedGlyph, TextLine};
use super::labels::{self, Box2};
use super::line;
use super::notes::{self, PlacedNote};
use super::overlay::{Kind, Quad, QuadData};
use super::pane::{PaneUniform, Projection};
use super::targets::extent;
use crate::frame::{Color, Frame, Line, Pane, PlacedName};

/// Radius of the halo (points).
pub(super) const HALO: f32 = 2.4;
pub(super) const HALO_OPACITY: f32 = 0.8;
/// Width of a leader (points), and its opacity.
const LEADER_WIDTH: f32 = 1.5;
const LEADER: f32 = 0.75;

/// Lays out the texts of a frame.
pub(super) struct Texts {
    atlas: Option<Atlas>,
    glyphs: Glyphs,
    names: Vec<PlacedName>,
}

/// The glyphs on the device.
struct Atlas {
    texture: wgpu::Texture,
    view: wgpu::TextureView,
}

impl Texts {
    pub(super) fn new() -> Self {
        Self { atlas: None, glyphs: Glyphs::new(), names: vec![] }
    }

    /// Lays out the notes of each pane: what a frame begins with.
    pub(super) fn lay_out_notes(&mut self, frame: &Frame, picture: Vec2, point: f32) -> Vec<Vec<PlacedNote>> {
        self.glyphs.begin_frame();
        self.names.clear();
        let panes = frame.panes.iter();
        panes.map(|pane| notes::lay_out(&pane.notes, &mut self.glyphs, pane.area.extent * picture, point)).collect()
    }

    /// Adds the corners of a pane's glyphs, the halos first. The pane's corner is in pixels of the picture.
    pub(super) fn append(
        &mut self,
        (pane, uniform, corner): (&Pane, &PaneUniform, Vec2),
        notes: &[PlacedNote],
        (background, point): (Color, f32),
        corners: &mut Vec<QuadData>,
    ) {
        let glyphs = &mut self.glyphs;
        let labels = lay_out_labels(glyphs, pane, uniform, notes, point);
        self.names.extend(labels.iter().map(|label| {
            let low = corner + label.low;
            PlacedName { text: label.text.to_owned(), low, high: low + Vec2::from_array(label.line.extent) }
        }));
        let screen = PaneUniform::flat(Vec2::new(uniform.metrics.x, uniform.metrics.y), point);
        let screen = Projection::new(&screen, corner);
        for leader in labels.iter().filter_map(|label| label.leader.as_ref()) {
            line::append(leader, 0.0, &screen, point, corners);
        }
        let texts = labels.iter().map(|label| (&label.line, label.low, label.color));
        let texts: Vec<_> = texts.chain(notes.iter().map(|note| (&note.line, note.low, note.color))).collect();
        let halo = background.alpha(HALO_OPACITY);
        for &(line, low, own) in &texts {
            let around = line.glyphs.iter().filter_map(|glyph| glyphs.halo(glyph, HALO * point));
            corners.extend(around.flat_map(|glyph| quad(&glyph, corner + low, halo.fade(own.0[3]))));
        }
        for &(line, low, own) in &texts {
            corners.extend(line.glyphs.iter().flat_map(|glyph| quad(glyph, corner + low, own)));
        }
    }

    /// The labels of the frame that was laid out last, where they stand.
    pub(super) fn names(&self) -> &[PlacedName] {
        &self.names
    }

    /// Sends glyphs that are new to the device; true where the atlas is another one than before.
    pub(super) fn upload(&mut self, device: &wgpu::Device, queue: &wgpu::Queue) -> bool {
        let (rows, changed) = self.glyphs.take_changed();
        let fits = self.atlas.as_ref().is_some_and(|atlas| atlas.texture.height() >= rows);
        if !fits {
            let texture = device.create_texture(&wgpu::TextureDescriptor {
                label: Some("glyph atlas"),
                size: extent([Glyphs::SIDE, rows.max(1).next_power_of_two()]),
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format: wgpu::TextureFormat::R8Unorm,
                usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
                view_formats: &[],
            });
            let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
            self.atlas = Some(Atlas { texture, view });
        }
        if let (Some(pixels), Some(atlas)) = (changed, &self.atlas) {
            let layout =
                wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(Glyphs::SIDE), rows_per_image: None };
            queue.write_texture(atlas.texture.as_image_copy(), pixels, layout, extent([Glyphs::SIDE, rows]));
        }
        !fits
    }

    /// The glyphs, once they were [uploaded](Self::upload).
    pub(super) fn atlas(&self) -> Option<&wgpu::TextureView> {
        self.atlas.as_ref().map(|atlas| &atlas.view)
    }
}

/// A label that is seen.
pub(super) struct SeenLabel<'a> {
    pub(super) text: &'a str,
    pub(super) line: TextLine,
    /// Its upper left corner (pixels of the pane).
    pub(super) low: Vec2,
    /// Its colour there.
    pub(super) color: Color,
    /// The stroke to what it names, in the same pixels.
    pub(super) leader: Option<Line>,
}

/// The labels of a pane that are seen. The notes are kept free of them.
pub(super) fn lay_out_labels<'a>(
    glyphs: &mut Glyphs,
    pane: &'a Pane,
    uniform: &PaneUniform,
    notes: &[PlacedNote],
    point: f32,
) -> Vec<SeenLabel<'a>> {
    let lines: Vec<TextLine> =
        pane.labels.iter().map(|label| glyphs.lay_out(&label.text, label.style.size * point)).collect();
    let extents: Vec<Vec2> = lines.iter().map(|line| Vec2::from_array(line.extent)).collect();
    let pixels = Vec2::new(uniform.metrics.x, uniform.metrics.y);
    let taken: Vec<Box2> = notes.iter().map(|note| note.room).collect();
    let places = labels::place(pane, uniform, &extents, &taken, pixels, point);
    let placed = pane.labels.iter().zip(lines).zip(places);
    let seen = placed.filter_map(|((label, line), place)| {
        let place = place?;
        let color = label.color.fade(place.opacity);
        let leader =
            place.leader.map(|ends| Line::new(ends.map(|end| end.extend(0.0)), LEADER_WIDTH, color.fade(LEADER)));
        Some(SeenLabel { text: &label.text, line, low: place.low, color, leader })
    });
    seen.collect()
}

/// A glyph of a text whose upper left corner is this pixel of the picture.
fn quad(glyph: &PlacedGlyph, text: Vec2, color: Color) -> [QuadData; 4] {
    let [width, height] = glyph.extent.map(|side| side as f32);
    let low = text + Vec2::from_array(glyph.low);
    let source = Vec2::new(glyph.source[0] as f32, glyph.source[1] as f32);
    let quad = Quad {
        kind: Kind::Text,
        place: [low, source],
        form: [Vec2::ZERO; 2],
        measures: [0.0; 4],
        hidden: 0.0,
        rim: 0.0,
        colors: [color; 2],
    };
    quad.at(Quad::rectangle(low, low + Vec2::new(width, height), 1.0))
}
