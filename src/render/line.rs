//! Lines: a quad a segment.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};

use super::buffer::QuadBuffer;
use super::pipeline::PipelineMaker;
use crate::frame::{Dash, Line};

/// `Segment` of shaders/line.wgsl.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct SegmentData {
    pub(super) before: [f32; 3],
    pub(super) start: [f32; 3],
    pub(super) end: [f32; 3],
    pub(super) after: [f32; 3],
    pub(super) style: [f32; 4],
    pub(super) along: [f32; 3],
    pub(super) start_color: [f32; 4],
    pub(super) end_color: [f32; 4],
}

/// Draws the lines of a frame; where they are hidden, at their own fainter strength.
pub(super) struct Lines {
    seen: wgpu::RenderPipeline,
    hidden: wgpu::RenderPipeline,
    /// At the strength of hidden ones, but hidden wholly by opaque bodies.
    inside: wgpu::RenderPipeline,
    segments: QuadBuffer,
    layers: Vec<Range<u32>>,
}

impl Lines {
    pub(super) fn new(maker: &PipelineMaker<'_>) -> Self {
        let module = maker.module("line", include_str!("../../shaders/line.wgsl"));
        let attributes = wgpu::vertex_attr_array![
            0 => Float32x3, 1 => Float32x3, 2 => Float32x3, 3 => Float32x3,
            4 => Float32x4, 5 => Float32x3, 6 => Float32x4, 7 => Float32x4
        ];
        let pipeline = |label, vertex, depth| maker.overlay::<SegmentData>(label, &module, &attributes, vertex, depth);
        Self {
            seen: pipeline("lines", "vertex_seen", wgpu::CompareFunction::GreaterEqual),
            hidden: pipeline("hidden lines", "vertex_hidden", wgpu::CompareFunction::Less),
            inside: pipeline("lines inside", "vertex_hidden", wgpu::CompareFunction::GreaterEqual),
            segments: QuadBuffer::new("line segments"),
            layers: vec![],
        }
    }

    /// Those of each layer, of a pane's world or of what lies on the screen before it, with their lift.
    pub(super) fn upload<'a>(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        layers: impl Iterator<Item = (&'a [Line], f32)>,
    ) {
        let mut segments = vec![];
        self.layers.clear();
        for (lines, lift) in layers {
            let start = segments.len() as u32;
            for line in lines {
                append(line, lift, &mut segments);
            }
            self.layers.push(start..segments.len() as u32);
        }
        self.segments.write(device, queue, &segments);
    }

    /// Between the far and the near walls of hollow surfaces with a body in them: what of the lines shows through the
    /// near walls, and not through the body.
    pub(super) fn draw_inside(&self, pass: &mut wgpu::RenderPass<'_>, layer: usize) {
        self.draw_with(pass, layer, &[&self.inside]);
    }

    /// Where they are seen.
    pub(super) fn draw_seen(&self, pass: &mut wgpu::RenderPass<'_>, layer: usize) {
        self.draw_with(pass, layer, &[&self.seen]);
    }

    /// Where they are hidden, whatever hides them, and then where they are seen.
    pub(super) fn draw_all(&self, pass: &mut wgpu::RenderPass<'_>, layer: usize) {
        self.draw_with(pass, layer, &[&self.hidden, &self.seen]);
    }

    fn draw_with(&self, pass: &mut wgpu::RenderPass<'_>, layer: usize, pipelines: &[&wgpu::RenderPipeline]) {
        let Some(range) = self.layers.get(layer).filter(|range| !range.is_empty()) else { return };
        if !self.segments.bind(pass) {
            return;
        }
        for pipeline in pipelines {
            pass.set_pipeline(pipeline);
            QuadBuffer::draw(pass, range.clone());
        }
    }
}

fn append(line: &Line, lift: f32, segments: &mut Vec<SegmentData>) {
    let points = &line.points;
    let last = points.len().saturating_sub(1);
    let closed = points.len() > 2 && points[0].position == points[last].position;
    let (kind, period) = match line.dash {
        Dash::Solid => (0.0, 1.0),
        Dash::Dashed(period) => (1.0, period),
        Dash::Dotted(period) => (2.0, period),
    };
    let mut along = 0.0;
    for i in 0..last {
        let (start, end) = (points[i], points[i + 1]);
        // A free end is its own neighbour, which the shader takes for none.
        let before = if i > 0 { points[i - 1] } else { points[if closed { last - 1 } else { 0 }] };
        let after = if i + 1 < last { points[i + 2] } else { points[if closed { 1 } else { last }] };
        let next = along + start.position.distance(end.position);
        segments.push(SegmentData {
            before: before.position.to_array(),
            start: start.position.to_array(),
            end: end.position.to_array(),
            after: after.position.to_array(),
            style: [line.width, line.hidden, period, kind],
            along: [along, next, lift],
            start_color: start.color.0,
            end_color: end.color.0,
        });
        along = next;
    }
}
