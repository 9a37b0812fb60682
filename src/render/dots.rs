//! Dots of the unit sphere: a triangle each, small as what is written of one for every frame, since there may be many thousands.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};

use super::buffer::FrameBuffer;
use super::pipeline::{Lazy, PipelineMaker, Recipe};
use crate::frame::{Color, Pane};

/// `Dot` of shaders/dots.wgsl.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct DotData {
    pub(super) place: [f32; 4],
    pub(super) color: [u8; 4],
}

/// Draws the dots of a frame.
pub(super) struct Dots {
    pipeline: Lazy,
    corners: FrameBuffer,
    panes: Vec<Range<u32>>,
}

impl Dots {
    pub(super) fn new() -> Self {
        let corners = FrameBuffer::new("dots", wgpu::BufferUsages::VERTEX);
        Self { pipeline: Lazy::default(), corners, panes: vec![] }
    }

    pub(super) fn upload<'a>(
        &mut self,
        maker: &PipelineMaker<'_>,
        queue: &wgpu::Queue,
        panes: impl Iterator<Item = &'a Pane> + Clone,
    ) {
        let count: usize = panes.clone().map(|pane| pane.dots.len()).sum();
        let mut corners: Vec<DotData> = Vec::with_capacity(3 * count);
        self.panes.clear();
        for pane in panes {
            let start = corners.len() as u32;
            for dot in &pane.dots {
                let [x, y, z] = dot.position.to_array();
                let corner = DotData { place: [x, y, z, dot.size], color: bytes(dot.color) };
                corners.extend([corner; 3]);
            }
            self.panes.push(start..corners.len() as u32);
        }
        self.corners.write(&maker.gpu.device, queue, bytemuck::cast_slice(&corners));
        self.pipeline.want(count > 0, || pipeline(maker));
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, pane: usize) {
        let Some(range) = self.panes.get(pane).filter(|range| !range.is_empty()) else { return };
        let Some(corners) = self.corners.get() else { return };
        if !self.pipeline.set(pass) {
            return;
        }
        pass.set_vertex_buffer(0, corners.slice(..));
        pass.draw(range.clone(), 0..1);
    }
}

/// Blended over the surfaces, tested against them.
fn pipeline(maker: &PipelineMaker<'_>) -> wgpu::RenderPipeline {
    let module = maker.module("dots", include_str!("../../shaders/dots.wgsl"));
    let buffer = wgpu::VertexBufferLayout {
        array_stride: size_of::<DotData>() as u64,
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes: &wgpu::vertex_attr_array![0 => Float32x4, 1 => Unorm8x4],
    };
    let recipe = Recipe {
        buffer: Some(buffer),
        groups: &[maker.pane_layout],
        depth: Some((wgpu::CompareFunction::GreaterEqual, false)),
        ..Recipe::new("dots", &module)
    };
    recipe.pipeline(maker.gpu)
}

/// A colour in bytes.
fn bytes(color: Color) -> [u8; 4] {
    color.0.map(|channel| (channel * 255.0 + 0.5) as u8)
}
