//! Marks: a quad each.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};

use super::buffer::QuadBuffer;
use super::pipeline::PipelineMaker;
use crate::frame::{Mark, Marker};

/// `Mark` of shaders/marker.wgsl.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct MarkData {
    pub(super) position: [f32; 3],
    pub(super) style: [f32; 3],
    pub(super) color: [f32; 4],
    pub(super) rim: [f32; 4],
}

/// The names of the marks in the shader, by their places in [`Mark`].
const FORMS: [(Mark, &str); 15] = [
    (Mark::Disc, "DISC"),
    (Mark::Ring, "RING"),
    (Mark::Diamond, "DIAMOND"),
    (Mark::Cross, "CROSS"),
    (Mark::Square, "SQUARE"),
    (Mark::Triangle, "TRIANGLE"),
    (Mark::TriangleDown, "TRIANGLE_DOWN"),
    (Mark::OpenSquare, "OPEN_SQUARE"),
    (Mark::OpenDiamond, "OPEN_DIAMOND"),
    (Mark::OpenTriangle, "OPEN_TRIANGLE"),
    (Mark::Star, "STAR"),
    (Mark::OpenTriangleDown, "OPEN_TRIANGLE_DOWN"),
    (Mark::Hourglass, "HOURGLASS"),
    (Mark::Bow, "BOW"),
    (Mark::Bars, "BARS"),
];

/// The shader after the numbers of the marks, which it names.
pub(super) fn source() -> String {
    let numbers: Vec<String> = FORMS.iter().map(|(mark, name)| format!("const {name} = {}u;\n", *mark as u8)).collect();
    numbers.concat() + include_str!("../../shaders/marker.wgsl")
}

/// Draws the markers of a frame.
pub(super) struct Markers {
    seen: wgpu::RenderPipeline,
    hidden: wgpu::RenderPipeline,
    marks: QuadBuffer,
    layers: Vec<Range<u32>>,
}

impl Markers {
    pub(super) fn new(maker: &PipelineMaker<'_>) -> Self {
        let module = maker.module("marker", &source());
        let attributes = wgpu::vertex_attr_array![
            0 => Float32x3, 1 => Float32x3, 2 => Float32x4, 3 => Float32x4
        ];
        let pipeline = |label, vertex, depth| maker.overlay::<MarkData>(label, &module, &attributes, vertex, depth);
        Self {
            seen: pipeline("markers", "vertex_seen", wgpu::CompareFunction::GreaterEqual),
            hidden: pipeline("hidden markers", "vertex_hidden", wgpu::CompareFunction::Less),
            marks: QuadBuffer::new("markers"),
            layers: vec![],
        }
    }

    /// Those of each layer, of a pane's world or of what lies on the screen before it.
    pub(super) fn upload<'a>(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        layers: impl Iterator<Item = &'a [Marker]>,
    ) {
        let mut marks = vec![];
        self.layers.clear();
        for markers in layers {
            let start = marks.len() as u32;
            marks.extend(markers.iter().map(|marker| MarkData {
                position: marker.position.to_array(),
                style: [marker.size, marker.hidden, f32::from(marker.mark as u8)],
                color: marker.color.0,
                rim: marker.rim.0,
            }));
            self.layers.push(start..marks.len() as u32);
        }
        self.marks.write(device, queue, &marks);
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, layer: usize) {
        let Some(range) = self.layers.get(layer).filter(|range| !range.is_empty()) else { return };
        if !self.marks.bind(pass) {
            return;
        }
        for pipeline in [&self.hidden, &self.seen] {
            pass.set_pipeline(pipeline);
            QuadBuffer::draw(pass, range.clone());
        }
    }
}
