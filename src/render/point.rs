//! Marks: a quad each.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};

use super::buffer::QuadBuffer;
use super::pipeline::PipelineMaker;
use crate::frame::{Frame, Mark};

/// `Mark` of shaders/point.wgsl.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct MarkData {
    position: [f32; 3],
    style: [f32; 3],
    color: [f32; 4],
    rim: [f32; 4],
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
    numbers.concat() + include_str!("../../shaders/point.wgsl")
}

/// Draws the points of a frame.
pub(super) struct Points {
    seen: wgpu::RenderPipeline,
    hidden: wgpu::RenderPipeline,
    marks: QuadBuffer,
    views: Vec<Range<u32>>,
}

impl Points {
    pub(super) fn new(maker: &PipelineMaker<'_>) -> Self {
        let module = maker.module("point", &source());
        let attributes = wgpu::vertex_attr_array![
            0 => Float32x3, 1 => Float32x3, 2 => Float32x4, 3 => Float32x4
        ];
        let pipeline = |label, vertex, depth| maker.overlay::<MarkData>(label, &module, &attributes, vertex, depth);
        Self {
            seen: pipeline("points", "vertex_seen", wgpu::CompareFunction::GreaterEqual),
            hidden: pipeline("hidden points", "vertex_hidden", wgpu::CompareFunction::Less),
            marks: QuadBuffer::new("points"),
            views: vec![],
        }
    }

    pub(super) fn upload(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, frame: &Frame) {
        let mut marks = vec![];
        self.views.clear();
        for view in &frame.views {
            let start = marks.len() as u32;
            marks.extend(view.points.iter().map(|point| MarkData {
                position: point.position.to_array(),
                style: [point.size, point.hidden, f32::from(point.mark as u8)],
                color: point.color.0,
                rim: point.rim.0,
            }));
            self.views.push(start..marks.len() as u32);
        }
        self.marks.write(device, queue, &marks);
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        let Some(range) = self.views.get(view).filter(|range| !range.is_empty()) else { return };
        if !self.marks.bind(pass) {
            return;
        }
        for pipeline in [&self.hidden, &self.seen] {
            pass.set_pipeline(pipeline);
            QuadBuffer::draw(pass, range.clone());
        }
    }
}
