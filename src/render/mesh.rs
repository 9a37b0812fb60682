//! Surfaces of triangles: opaque ones first, translucent ones over them from the farthest on.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};

use super::buffer::FrameBuffer;
use super::pipeline::{PipelineMaker, Recipe};
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
    opaque: wgpu::RenderPipeline,
    far_sides: wgpu::RenderPipeline,
    near_sides: wgpu::RenderPipeline,
    vertices: FrameBuffer,
    indices: FrameBuffer,
    panes: Vec<Ranges>,
}

/// The indices of one pane's meshes; every translucent one by itself.
#[derive(Default)]
struct Ranges {
    opaque: Range<u32>,
    translucent: Vec<Range<u32>>,
}

impl Meshes {
    pub(super) fn new(maker: &PipelineMaker<'_>) -> Self {
        let module = maker.module("mesh", include_str!("../../shaders/mesh.wgsl"));
        let pipeline = |label, cull, writes_depth| {
            maker.pipeline(&Recipe {
                label,
                module: &module,
                vertex: "vertex",
                buffer: Some(wgpu::VertexBufferLayout {
                    array_stride: size_of::<VertexData>() as u64,
                    step_mode: wgpu::VertexStepMode::Vertex,
                    attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x4],
                }),
                group: None,
                cull,
                depth: wgpu::CompareFunction::GreaterEqual,
                writes_depth,
            })
        };
        Self {
            opaque: pipeline("opaque meshes", None, true),
            far_sides: pipeline("far sides of translucent meshes", Some(wgpu::Face::Front), false),
            near_sides: pipeline("near sides of translucent meshes", Some(wgpu::Face::Back), false),
            vertices: FrameBuffer::new("mesh vertices", wgpu::BufferUsages::VERTEX),
            indices: FrameBuffer::new("mesh indices", wgpu::BufferUsages::INDEX),
            panes: vec![],
        }
    }

    pub(super) fn upload(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, frame: &Frame) {
        let (mut vertices, mut indices) = (vec![], vec![]);
        self.panes.clear();
        for pane in &frame.panes {
            let start = indices.len() as u32;
            for mesh in pane.meshes.iter().filter(|mesh| mesh.opaque) {
                append(mesh, &mut vertices, &mut indices);
            }
            let mut ranges = Ranges { opaque: start..indices.len() as u32, translucent: vec![] };
            for mesh in farthest_first(pane) {
                let start = indices.len() as u32;
                append(mesh, &mut vertices, &mut indices);
                ranges.translucent.push(start..indices.len() as u32);
            }
            self.panes.push(ranges);
        }
        self.vertices.write(device, queue, bytemuck::cast_slice(&vertices));
        self.indices.write(device, queue, bytemuck::cast_slice(&indices));
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, pane: usize) {
        let (Some(vertices), Some(indices), Some(ranges)) =
            (self.vertices.get(), self.indices.get(), self.panes.get(pane))
        else {
            return;
        };
        if ranges.opaque.is_empty() && ranges.translucent.is_empty() {
            return;
        }
        pass.set_vertex_buffer(0, vertices.slice(..));
        pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
        if !ranges.opaque.is_empty() {
            pass.set_pipeline(&self.opaque);
            pass.draw_indexed(ranges.opaque.clone(), 0, 0..1);
        }
        for mesh in &ranges.translucent {
            for pipeline in [&self.far_sides, &self.near_sides] {
                pass.set_pipeline(pipeline);
                pass.draw_indexed(mesh.clone(), 0, 0..1);
            }
        }
    }
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
