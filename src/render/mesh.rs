//! Surfaces of triangles. Lit ones are solids, drawn in several samples a pixel: opaque ones first, translucent ones over them from
//! the farthest on. Flat ones, whose edges are soft by themselves, lie beside the translucent surfaces.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use glam::{Vec2, Vec3};

use super::buffer::FrameBuffer;
use super::pane::PaneUniform;
use super::pipeline::{Lazy, PipelineMaker, Recipe};
use super::targets::SAMPLES;
use crate::frame::{Frame, Mesh, Pane};

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct VertexData {
    pub(super) position: [f32; 3],
    pub(super) normal: [f32; 3],
    pub(super) color: [f32; 4],
}

/// Draws the meshes of a frame.
pub(super) struct Meshes {
    module: Option<wgpu::ShaderModule>,
    opaque: Lazy,
    far_sides: Lazy,
    near_sides: Lazy,
    flat: Lazy,
    /// Of opaque ones only how near they are.
    depths: Lazy,
    vertices: FrameBuffer,
    indices: FrameBuffer,
    panes: Vec<Ranges>,
}

/// The indices of one pane's meshes; every translucent one by itself.
#[derive(Default)]
struct Ranges {
    opaque: Range<u32>,
    translucent: Vec<Range<u32>>,
    flat: Vec<Range<u32>>,
    /// What the solids take of the pane: low and high corners (pixels of the pane).
    bounds: Option<[Vec2; 2]>,
}

impl Meshes {
    pub(super) fn new() -> Self {
        Self {
            module: None,
            opaque: Lazy::default(),
            far_sides: Lazy::default(),
            near_sides: Lazy::default(),
            flat: Lazy::default(),
            depths: Lazy::default(),
            vertices: FrameBuffer::new("mesh vertices", wgpu::BufferUsages::VERTEX),
            indices: FrameBuffer::new("mesh indices", wgpu::BufferUsages::INDEX),
            panes: vec![],
        }
    }

    /// Takes the meshes of a frame, and makes what they are drawn by; the depths of opaque ones by themselves where that is
    /// wanted.
    pub(super) fn upload(
        &mut self,
        maker: &PipelineMaker<'_>,
        queue: &wgpu::Queue,
        frame: &Frame,
        uniforms: &[PaneUniform],
        wants_depths: bool,
    ) {
        let (mut vertices, mut indices) = (vec![], vec![]);
        self.panes.clear();
        for (pane, uniform) in frame.panes.iter().zip(uniforms) {
            let mut add = |mesh: &Mesh| {
                let start = indices.len() as u32;
                append(mesh, &mut vertices, &mut indices);
                start..indices.len() as u32
            };
            let opaque = pane.meshes.iter().filter(|mesh| mesh.opaque).map(&mut add);
            let opaque = opaque.reduce(|all, one| all.start..one.end).unwrap_or_default();
            let mut ranges = Ranges { opaque, ..Ranges::default() };
            let translucent = farthest_first(pane);
            // Beside other translucent ones a flat one takes its turn among them.
            let are_mixed = !translucent.iter().all(|mesh| is_flat(mesh));
            for mesh in translucent {
                let range = add(mesh);
                if are_mixed { ranges.translucent.push(range) } else { ranges.flat.push(range) }
            }
            let solids = pane.meshes.iter().filter(|mesh| mesh.opaque || are_mixed);
            ranges.bounds = bounds(solids, uniform);
            self.panes.push(ranges);
        }
        self.vertices.write(&maker.gpu.device, queue, bytemuck::cast_slice(&vertices));
        self.indices.write(&maker.gpu.device, queue, bytemuck::cast_slice(&indices));
        if !indices.is_empty() {
            self.make(maker, wants_depths);
        }
    }

    fn make(&mut self, maker: &PipelineMaker<'_>, wants_depths: bool) {
        let source = include_str!("../../shaders/mesh.wgsl");
        let module: &wgpu::ShaderModule = self.module.get_or_insert_with(|| maker.module("mesh", source));
        let base = Recipe {
            buffer: Some(wgpu::VertexBufferLayout {
                array_stride: size_of::<VertexData>() as u64,
                step_mode: wgpu::VertexStepMode::Vertex,
                attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x4],
            }),
            groups: &[maker.pane_layout],
            depth: Some((wgpu::CompareFunction::GreaterEqual, false)),
            ..Recipe::new("flat meshes", module)
        };
        let writing = Some((wgpu::CompareFunction::GreaterEqual, true));
        let solid =
            |label, cull, depth| Recipe { label, cull, depth, samples: SAMPLES, ..base.clone() }.pipeline(maker.gpu);
        let any = |holds: fn(&Ranges) -> bool| self.panes.iter().any(holds);
        let is_opaque = any(|ranges| !ranges.opaque.is_empty());
        let is_translucent = any(|ranges| !ranges.translucent.is_empty());
        let is_flat = any(|ranges| !ranges.flat.is_empty());
        self.opaque.want(is_opaque, || solid("opaque meshes", None, writing));
        let (front, back) = (Some(wgpu::Face::Front), Some(wgpu::Face::Back));
        self.far_sides.want(is_translucent, || solid("far sides of translucent meshes", front, base.depth));
        self.near_sides.want(is_translucent, || solid("near sides of translucent meshes", back, base.depth));
        self.flat.want(is_flat, || Recipe { constants: &[("is_lit", 0.0)], ..base.clone() }.pipeline(maker.gpu));
        self.depths.want(is_opaque && wants_depths, || {
            Recipe { label: "depths of meshes", depth: writing, is_colourless: true, ..base.clone() }
                .pipeline(maker.gpu)
        });
    }

    /// What the solids take of a pane: low and high corners (pixels of the pane).
    pub(super) fn bounds(&self, pane: usize) -> Option<[Vec2; 2]> {
        self.panes.get(pane)?.bounds
    }

    /// Draws the solids, in several samples a pixel.
    pub(super) fn draw_solids(&self, pass: &mut wgpu::RenderPass<'_>, pane: usize) {
        let Some(ranges) = self.bind(pass, pane) else { return };
        if !ranges.opaque.is_empty() && self.opaque.set(pass) {
            pass.draw_indexed(ranges.opaque.clone(), 0, 0..1);
        }
        for mesh in &ranges.translucent {
            for pipeline in [&self.far_sides, &self.near_sides] {
                if pipeline.set(pass) {
                    pass.draw_indexed(mesh.clone(), 0, 0..1);
                }
            }
        }
    }

    /// Leaves the depths of the opaque ones.
    pub(super) fn draw_depths(&self, pass: &mut wgpu::RenderPass<'_>, pane: usize) {
        let Some(ranges) = self.bind(pass, pane).filter(|ranges| !ranges.opaque.is_empty()) else { return };
        if self.depths.set(pass) {
            pass.draw_indexed(ranges.opaque.clone(), 0, 0..1);
        }
    }

    /// Draws the flat ones.
    pub(super) fn draw_flat(&self, pass: &mut wgpu::RenderPass<'_>, pane: usize) {
        let Some(ranges) = self.bind(pass, pane).filter(|ranges| !ranges.flat.is_empty()) else { return };
        if self.flat.set(pass) {
            for mesh in &ranges.flat {
                pass.draw_indexed(mesh.clone(), 0, 0..1);
            }
        }
    }

    fn bind(&self, pass: &mut wgpu::RenderPass<'_>, pane: usize) -> Option<&Ranges> {
        let (vertices, indices) = (self.vertices.get()?, self.indices.get()?);
        pass.set_vertex_buffer(0, vertices.slice(..));
        pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
        self.panes.get(pane)
    }
}

/// Whether it takes no light: its colours are all that it is, and fade at its edges.
fn is_flat(mesh: &Mesh) -> bool {
    mesh.vertices.first().is_some_and(|vertex| vertex.normal == Vec3::ZERO)
}

fn append(mesh: &Mesh, vertices: &mut Vec<VertexData>, indices: &mut Vec<u32>) {
    let base = vertices.len() as u32;
    vertices.extend(mesh.vertices.iter().map(|vertex| VertexData {
        position: vertex.position.to_array(),
        normal: vertex.normal.to_array(),
        color: vertex.color.0,
    }));
    indices.extend(mesh.indices.iter().map(|index| base + index));
}

/// The pixels of the pane that meshes take, all of it where one reaches behind the eye.
fn bounds<'a>(meshes: impl Iterator<Item = &'a Mesh>, uniform: &PaneUniform) -> Option<[Vec2; 2]> {
    let size = Vec2::new(uniform.metrics.x, uniform.metrics.y);
    let mut found: Option<[Vec2; 2]> = None;
    for vertex in meshes.flat_map(|mesh| &mesh.vertices) {
        let Some(ndc) = uniform.ndc(vertex.position) else { return Some([Vec2::ZERO, size]) };
        let pixel = (ndc * Vec2::new(0.5, -0.5) + 0.5) * size;
        let [low, high] = found.get_or_insert([pixel; 2]);
        (*low, *high) = (low.min(pixel), high.max(pixel));
    }
    found.map(|[low, high]| [low.max(Vec2::ZERO), high.min(size)])
}

fn farthest_first(pane: &Pane) -> Vec<&Mesh> {
    let eye = pane.camera.eye();
    let depth = |mesh: &Mesh| {
        let count = mesh.vertices.len().max(1) as f32;
        let centre = mesh.vertices.iter().map(|vertex| vertex.position).sum::<glam::Vec3>() / count;
        centre.distance_squared(eye)
    };
    let mut translucent: Vec<&Mesh> = pane.meshes.iter().filter(|mesh| !mesh.opaque).collect();
    translucent.sort_by(|a, b| depth(b).total_cmp(&depth(a)));
    translucent
}
