//! Bodies of triangles: opaque ones first, translucent ones over them from the farthest on.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};

use super::buffer::FrameBuffer;
use super::pipeline::{PipelineMaker, Recipe};
use crate::frame::{Frame, Solid, View};

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct VertexData {
    position: [f32; 3],
    normal: [f32; 3],
    color: [f32; 4],
}

/// Draws the solids of a frame.
pub(super) struct Solids {
    opaque: wgpu::RenderPipeline,
    far_sides: wgpu::RenderPipeline,
    near_sides: wgpu::RenderPipeline,
    vertices: FrameBuffer,
    indices: FrameBuffer,
    views: Vec<Ranges>,
}

/// The indices of one view's solids; every translucent one by itself.
#[derive(Default)]
struct Ranges {
    opaque: Range<u32>,
    translucent: Vec<Range<u32>>,
}

impl Solids {
    pub(super) fn new(maker: &PipelineMaker<'_>) -> Self {
        let module = maker.module("solid", include_str!("../../shaders/solid.wgsl"));
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
            opaque: pipeline("opaque solids", None, true),
            far_sides: pipeline("far sides of translucent solids", Some(wgpu::Face::Front), false),
            near_sides: pipeline("near sides of translucent solids", Some(wgpu::Face::Back), false),
            vertices: FrameBuffer::new("solid vertices", wgpu::BufferUsages::VERTEX),
            indices: FrameBuffer::new("solid indices", wgpu::BufferUsages::INDEX),
            views: vec![],
        }
    }

    pub(super) fn upload(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, frame: &Frame) {
        let (mut vertices, mut indices) = (vec![], vec![]);
        self.views.clear();
        for view in &frame.views {
            let start = indices.len() as u32;
            for solid in view.solids.iter().filter(|solid| solid.opaque) {
                append(solid, &mut vertices, &mut indices);
            }
            let mut ranges = Ranges { opaque: start..indices.len() as u32, translucent: vec![] };
            for solid in farthest_first(view) {
                let start = indices.len() as u32;
                append(solid, &mut vertices, &mut indices);
                ranges.translucent.push(start..indices.len() as u32);
            }
            self.views.push(ranges);
        }
        self.vertices.write(device, queue, bytemuck::cast_slice(&vertices));
        self.indices.write(device, queue, bytemuck::cast_slice(&indices));
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        let (Some(vertices), Some(indices), Some(ranges)) =
            (self.vertices.get(), self.indices.get(), self.views.get(view))
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
        for solid in &ranges.translucent {
            for pipeline in [&self.far_sides, &self.near_sides] {
                pass.set_pipeline(pipeline);
                pass.draw_indexed(solid.clone(), 0, 0..1);
            }
        }
    }
}

fn append(solid: &Solid, vertices: &mut Vec<VertexData>, indices: &mut Vec<u32>) {
    let base = vertices.len() as u32;
    vertices.extend(solid.mesh.vertices.iter().map(|vertex| VertexData {
        position: vertex.position.to_array(),
        normal: vertex.normal.to_array(),
        color: vertex.color.0,
    }));
    indices.extend(solid.mesh.indices.iter().map(|index| base + index));
}

fn farthest_first(view: &View) -> Vec<&Solid> {
    let eye = view.camera.eye();
    let depth = |solid: &Solid| {
        let count = solid.mesh.vertices.len().max(1) as f32;
        let centre = solid.mesh.vertices.iter().map(|vertex| vertex.position).sum::<glam::Vec3>() / count;
        centre.distance_squared(eye)
    };
    let mut translucent: Vec<&Solid> = view.solids.iter().filter(|solid| !solid.opaque).collect();
    translucent.sort_by(|a, b| depth(b).total_cmp(&depth(a)));
    translucent
}
