//! Texts: glyphs of an atlas as quads, with a halo that keeps them readable over anything.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use glam::Vec2;

use super::buffer::QuadBuffer;
use super::glyphs::{Glyphs, TextLine};
use super::labels::{self, Box2};
use super::notes::{self, PlacedNote};
use super::pane::PaneUniform;
use super::pipeline::{PipelineMaker, Recipe};
use super::targets::extent;
use crate::frame::{Color, Frame, Pane};

/// Radius of the halo (points).
pub(super) const HALO: f32 = 2.4;
pub(super) const HALO_OPACITY: f32 = 0.8;
/// As the shader has it: its part of the radius with the whole opacity, and the part of the opacity beyond.
pub(super) const INNER_HALO: f32 = 0.6;
pub(super) const OUTER_HALO: f32 = 0.6;

/// `Glyph` of shaders/text.wgsl.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct GlyphData {
    pub(super) place: [f32; 4],
    pub(super) source: [f32; 3],
    pub(super) color: [f32; 4],
}

/// Draws the labels of a frame.
pub(super) struct Texts {
    pipeline: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
    atlas: wgpu::Texture,
    glyphs: Glyphs,
    instances: QuadBuffer,
    panes: Vec<Range<u32>>,
    /// Of each text with its halo, in the picture: low and high corners (pixels).
    boxes: Vec<[Vec2; 2]>,
}

impl Texts {
    pub(super) fn new(maker: &PipelineMaker<'_>) -> Self {
        let device = maker.device;
        let module = maker.module("text", include_str!("../../shaders/text.wgsl"));
        let entry = |binding, ty| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::FRAGMENT,
            ty,
            count: None,
        };
        let texture = wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable: true },
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        };
        let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("glyph atlas"),
            entries: &[entry(0, texture), entry(1, sampler)],
        });
        let atlas = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("glyph atlas"),
            size: extent([Glyphs::SIDE; 2]),
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::R8Unorm,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let view = atlas.create_view(&wgpu::TextureViewDescriptor::default());
        let sampler = device.create_sampler(&wgpu::SamplerDescriptor::default());
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("glyph atlas"),
            layout: &layout,
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&view) },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Sampler(&sampler) },
            ],
        });
        let pipeline = maker.pipeline(&Recipe {
            label: "text",
            module: &module,
            vertex: "vertex",
            buffer: Some(wgpu::VertexBufferLayout {
                array_stride: size_of::<GlyphData>() as u64,
                step_mode: wgpu::VertexStepMode::Vertex,
                attributes: &wgpu::vertex_attr_array![0 => Float32x4, 1 => Float32x3, 2 => Float32x4],
            }),
            group: Some(&layout),
            cull: None,
            depth: wgpu::CompareFunction::Always,
            writes_depth: false,
        });
        let instances = QuadBuffer::new("glyphs");
        Self { pipeline, group, atlas, glyphs: Glyphs::new(), instances, panes: vec![], boxes: vec![] }
    }

    /// Lays out the notes of each pane: what a frame begins with.
    pub(super) fn lay_out_notes(&mut self, frame: &Frame, picture: Vec2, point: f32) -> Vec<Vec<PlacedNote>> {
        self.glyphs.begin_frame();
        let panes = frame.panes.iter();
        panes.map(|pane| notes::lay_out(&pane.notes, &mut self.glyphs, pane.area.extent * picture, point)).collect()
    }

    pub(super) fn upload(
        &mut self,
        (device, queue): (&wgpu::Device, &wgpu::Queue),
        frame: &Frame,
        notes: &[Vec<PlacedNote>],
        uniforms: &[PaneUniform],
        picture: Vec2,
        point: f32,
    ) {
        let mut instances = vec![];
        self.panes.clear();
        self.boxes.clear();
        let halo = frame.background.alpha(HALO_OPACITY);
        for ((pane, notes), uniform) in frame.panes.iter().zip(notes).zip(uniforms) {
            let start = instances.len() as u32;
            let pixels = pane.area.extent * picture;
            let taken: Vec<Box2> = notes.iter().map(|note| note.room).collect();
            let (labels, notes) =
                (lay_out_labels(&mut self.glyphs, pane, uniform, &taken, pixels, point), notes.iter());
            let texts = labels.iter().map(|(line, low, color)| (line, *low, *color));
            let texts: Vec<_> = texts.chain(notes.map(|note| (&note.line, note.low, note.color))).collect();
            let corner = pane.area.corner * picture;
            let rim = Vec2::splat(HALO * point + 2.0);
            let around = |(line, low, _): &(&TextLine, Vec2, Color)| {
                let low = corner + *low;
                [low - rim, low + Vec2::from_array(line.extent) + rim]
            };
            self.boxes.extend(texts.iter().map(around));
            self.boxes.extend(taken.iter().map(|room| [corner + room.low - rim, corner + room.high + rim]));
            for (radius, ink) in [(HALO * point, false), (0.0, true)] {
                for &(line, place, own) in &texts {
                    let color = if ink { own } else { halo.fade(own.0[3]) };
                    append(line, place, radius, color, &mut instances);
                }
            }
            self.panes.push(start..instances.len() as u32);
        }
        self.instances.write(device, queue, &instances);
        if let Some((rows, pixels)) = self.glyphs.take_changed() {
            let layout =
                wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(Glyphs::SIDE), rows_per_image: None };
            queue.write_texture(self.atlas.as_image_copy(), pixels, layout, extent([Glyphs::SIDE, rows]));
        }
    }

    /// Where the texts of the frame last uploaded are: low and high corners (pixels).
    pub(super) fn boxes(&self) -> &[[Vec2; 2]] {
        &self.boxes
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, pane: usize) {
        let Some(range) = self.panes.get(pane).filter(|range| !range.is_empty()) else { return };
        if !self.instances.bind(pass) {
            return;
        }
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(1, &self.group, &[]);
        QuadBuffer::draw(pass, range.clone());
    }
}

/// The labels of a pane that are seen, each with its upper left corner (pixels of the pane) and its colour there; what is
/// taken is kept free of them.
pub(super) fn lay_out_labels(
    glyphs: &mut Glyphs,
    pane: &Pane,
    uniform: &PaneUniform,
    taken: &[Box2],
    pixels: Vec2,
    point: f32,
) -> Vec<(TextLine, Vec2, Color)> {
    let lines: Vec<TextLine> =
        pane.labels.iter().map(|label| glyphs.lay_out(&label.text, label.style.size * point)).collect();
    let extents: Vec<Vec2> = lines.iter().map(|line| Vec2::from_array(line.extent)).collect();
    let places = labels::place(pane, uniform, &extents, taken, pixels, point);
    let placed = pane.labels.iter().zip(lines).zip(places);
    let seen = placed
        .filter_map(|((label, line), place)| place.map(|place| (line, place.low, label.color.fade(place.opacity))));
    seen.collect()
}

fn append(line: &TextLine, place: Vec2, halo: f32, color: Color, instances: &mut Vec<GlyphData>) {
    instances.extend(line.glyphs.iter().map(|glyph| GlyphData {
        place: [place.x + glyph.low[0], place.y + glyph.low[1], glyph.extent[0] as f32, glyph.extent[1] as f32],
        source: [glyph.source[0] as f32, glyph.source[1] as f32, halo],
        color: color.0,
    }));
}
