//! Surfaces of triangles. Lit ones are solids, drawn in several samples a pixel: opaque ones first, translucent ones over them from
//! the farthest on. Flat ones, whose edges are soft by themselves, lie beside the translucent surfaces.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use glam::{Vec2, Vec3};

use super::buffer::FrameBuffer;
use super::outline::Outline;
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
    /// What the solids take of the pane.
    outline: Option<Outline>,
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
            let (eye, first) = (pane.camera.eye(), vertices.len());
            let mut add = |mesh: &Mesh| {
                let start = indices.len() as u32;
                append(mesh, eye, &mut vertices, &mut indices);
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
            let solids = [ranges.opaque.clone()].into_iter().chain(ranges.translucent.iter().cloned());
            ranges.outline = Some(outline(&vertices[first..], &indices, solids, first, uniform));
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
        let solid = Recipe { samples: SAMPLES, ..base.clone() };
        let translucent = |label, cull| Recipe { label, cull, ..solid.clone() }.pipeline(maker.gpu);
        let any = |holds: fn(&Ranges) -> bool| self.panes.iter().any(holds);
        let is_opaque = any(|ranges| !ranges.opaque.is_empty());
        let is_translucent = any(|ranges| !ranges.translucent.is_empty());
        let is_flat = any(|ranges| !ranges.flat.is_empty());
        self.opaque.want(is_opaque, || {
            Recipe { label: "opaque meshes", depth: writing, blend: None, ..solid.clone() }.pipeline(maker.gpu)
        });
        let (front, back) = (Some(wgpu::Face::Front), Some(wgpu::Face::Back));
        self.far_sides.want(is_translucent, || translucent("far sides of translucent meshes", front));
        self.near_sides.want(is_translucent, || translucent("near sides of translucent meshes", back));
        self.flat.want(is_flat, || Recipe { constants: &[("is_lit", 0.0)], ..base.clone() }.pipeline(maker.gpu));
        self.depths.want(is_opaque && wants_depths, || {
            Recipe { label: "depths of meshes", depth: writing, is_colourless: true, ..base.clone() }
                .pipeline(maker.gpu)
        });
    }

    /// What the solids take of a pane.
    pub(super) fn outline(&self, pane: usize) -> Option<&Outline> {
        self.panes.get(pane)?.outline.as_ref()
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

/// Adds a mesh; of a solid one only the triangles that turn to the eye, unless that is within it: the others are hidden by them.
fn append(mesh: &Mesh, eye: Vec3, vertices: &mut Vec<VertexData>, indices: &mut Vec<u32>) {
    let base = vertices.len() as u32;
    vertices.extend(mesh.vertices.iter().map(|vertex| VertexData {
        position: vertex.position.to_array(),
        normal: vertex.normal.to_array(),
        color: vertex.color.0,
    }));
    let is_closed = mesh.opaque && !is_flat(mesh) && !may_hold(mesh, eye);
    let triangles = mesh.indices.as_chunks::<3>().0.iter();
    let seen = triangles.filter(|corners| {
        let [a, b, c] = corners.map(|index| mesh.vertices[index as usize].position);
        !is_closed || (b - a).cross(c - a).dot(eye - a) > 0.0
    });
    indices.extend(seen.flatten().map(|index| base + index));
}

/// Whether a place is so near that it may be within a mesh.
fn may_hold(mesh: &Mesh, place: Vec3) -> bool {
    let places = || mesh.vertices.iter().map(|vertex| vertex.position);
    let (low, high) = (places().reduce(Vec3::min), places().reduce(Vec3::max));
    low.zip(high).is_some_and(|(low, high)| place.cmpge(low).all() && place.cmple(high).all())
}

/// What the triangles of these indices take of a pane whose vertices are these, from the first on.
fn outline(
    vertices: &[VertexData],
    indices: &[u32],
    solids: impl Iterator<Item = Range<u32>>,
    first: usize,
    uniform: &PaneUniform,
) -> Outline {
    let size = Vec2::new(uniform.metrics.x, uniform.metrics.y);
    let pixel = |vertex: &VertexData| {
        let ndc = uniform.ndc(Vec3::from_array(vertex.position))?;
        Some((ndc * Vec2::new(0.5, -0.5) + 0.5) * size)
    };
    let pixels: Vec<Option<Vec2>> = vertices.iter().map(pixel).collect();
    let mut outline = Outline::new(size);
    for range in solids {
        for corners in indices[range.start as usize..range.end as usize].as_chunks::<3>().0 {
            outline.add(corners.map(|index| pixels[index as usize - first]));
        }
    }
    outline
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

#[cfg(test)]
mod tests {
    use super::append;
    use crate::frame::{Color, Mesh, Vertex};
    use glam::Vec3;

    /// A tetrahedron about the origin, in the unit cube.
    fn tetrahedron(normal: Vec3) -> Mesh {
        let corners = [Vec3::ONE, Vec3::new(1.0, -1.0, -1.0), Vec3::new(-1.0, 1.0, -1.0), Vec3::new(-1.0, -1.0, 1.0)];
        let vertices = corners.map(|position| Vertex { position, normal, color: Color::hex(0) }).to_vec();
        Mesh { opaque: true, vertices, indices: vec![0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2] }
    }

    #[test]
    fn of_a_solid_the_sides_are_drawn_that_turn_to_the_eye() {
        let drawn = |mesh: &Mesh, eye: Vec3| {
            let (mut vertices, mut indices) = (vec![], vec![]);
            append(mesh, eye, &mut vertices, &mut indices);
            indices
        };
        let solid = tetrahedron(Vec3::X);
        // From beyond a corner its three sides, from opposite one side, from within all.
        assert_eq!(drawn(&solid, Vec3::splat(9.0)), [0, 1, 2, 0, 2, 3, 0, 3, 1]);
        assert_eq!(drawn(&solid, Vec3::splat(-9.0)), [1, 3, 2]);
        assert_eq!(drawn(&solid, Vec3::splat(0.9)).len(), 12);
        // What is flat has two sides, and through what is translucent both are seen.
        assert_eq!(drawn(&tetrahedron(Vec3::ZERO), Vec3::splat(9.0)).len(), 12);
        assert_eq!(drawn(&Mesh { opaque: false, ..solid }, Vec3::splat(9.0)).len(), 12);
    }
}
