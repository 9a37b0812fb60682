//! Dots of the unit sphere: a triangle each, small as what is written of one for every frame, since there may be many thousands.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};

use super::buffer::FrameBuffer;
use super::pipeline::PipelineMaker;
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
    pipeline: wgpu::RenderPipeline,
    corners: FrameBuffer,
    panes: Vec<Range<u32>>,
}

impl Dots {
    pub(super) fn new(maker: &PipelineMaker<'_>) -> Self {
        let module = maker.module("dots", include_str!("../../shaders/dots.wgsl"));
        let attributes = wgpu::vertex_attr_array![0 => Float32x4, 1 => Unorm8x4];
        let near = wgpu::CompareFunction::GreaterEqual;
        Self {
            pipeline: maker.overlay::<DotData>("dots", &module, &attributes, "vertex", near),
            corners: FrameBuffer::new("dots", wgpu::BufferUsages::VERTEX),
            panes: vec![],
        }
    }

    pub(super) fn upload<'a>(
        &mut self,
        device: &wgpu::Device,
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
        self.corners.write(device, queue, bytemuck::cast_slice(&corners));
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, pane: usize) {
        let Some(range) = self.panes.get(pane).filter(|range| !range.is_empty()) else { return };
        let Some(corners) = self.corners.get() else { return };
        pass.set_pipeline(&self.pipeline);
        pass.set_vertex_buffer(0, corners.slice(..));
        pass.draw(range.clone(), 0..1);
    }
}

/// A colour in bytes.
fn bytes(color: Color) -> [u8; 4] {
    color.0.map(|channel| (channel * 255.0 + 0.5) as u8)
}
