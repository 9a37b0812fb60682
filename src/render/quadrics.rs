//! Translucent ellipsoids, one or two at a time, composited exactly by one shader.

use bytemuck::{Pod, Zeroable};
use glam::{Mat4, Vec3, Vec4};

use super::buffer::UniformBuffer;
use super::pipeline::{PipelineMaker, Recipe};
use super::view::ViewUniform;
use crate::frame::{Frame, Quadric, QuadricPair};

/// `Pair` of shaders/quadrics.wgsl.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
struct PairUniform {
    quadrics: [QuadricData; 2],
    bounds: Vec4,
    choice: Vec4,
}

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
struct QuadricData {
    unit_from_world: Mat4,
    color: [f32; 4],
}

/// Draws the quadrics of a frame.
pub(super) struct Quadrics {
    /// Near walls, or all: they hide the lines behind them.
    hiding: wgpu::RenderPipeline,
    /// Far walls behind something opaque that is still to show through.
    far_walls: wgpu::RenderPipeline,
    uniforms: UniformBuffer,
    /// For each view its draws: number of the uniform, and whether it is far walls only.
    views: Vec<Vec<(usize, bool)>>,
}

impl Quadrics {
    pub(super) fn new(maker: &PipelineMaker<'_>) -> Self {
        let module = maker.module("quadrics", include_str!("../../shaders/quadrics.wgsl"));
        let uniforms = UniformBuffer::new(maker.device, "quadric pair", size_of::<PairUniform>());
        let pipeline = |label, writes_depth| {
            maker.pipeline(&Recipe {
                label,
                module: &module,
                vertex: "vertex",
                buffer: None,
                group: Some(uniforms.layout()),
                strips: true,
                cull: None,
                depth: wgpu::CompareFunction::GreaterEqual,
                writes_depth,
            })
        };
        Self {
            hiding: pipeline("quadrics", true),
            far_walls: pipeline("far walls of quadrics", false),
            uniforms,
            views: vec![],
        }
    }

    pub(super) fn upload(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        frame: &Frame,
        view_uniforms: &[ViewUniform],
    ) {
        let mut pairs = vec![];
        self.views.clear();
        for (view, uniform) in frame.views.iter().zip(view_uniforms) {
            let mut draws = vec![];
            for pair in &view.quadrics {
                let passes: &[[f32; 2]] = if pair.hollow { &[[0.0, 1.0], [1.0, 0.0]] } else { &[[1.0, 1.0]] };
                for &[near, far] in passes {
                    draws.push((pairs.len(), near == 0.0));
                    pairs.push(pair_uniform(pair, uniform.clip_from_world, [near, far]));
                }
            }
            self.views.push(draws);
        }
        if !pairs.is_empty() {
            self.uniforms.write(device, queue, &pairs);
        }
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, view: usize) {
        for &(number, far_only) in self.views.get(view).into_iter().flatten() {
            pass.set_pipeline(if far_only { &self.far_walls } else { &self.hiding });
            self.uniforms.bind(pass, 1, number);
            pass.draw(0..4, 0..1);
        }
    }
}

fn pair_uniform(pair: &QuadricPair, clip_from_world: Mat4, [near, far]: [f32; 2]) -> PairUniform {
    let data = |quadric: Quadric| QuadricData { unit_from_world: quadric.unit_from_world, color: quadric.color.0 };
    let second = pair.second.unwrap_or(pair.first);
    let (low_1, high_1) = bounds(pair.first, clip_from_world);
    let (low_2, high_2) = bounds(second, clip_from_world);
    let (low, high) = (low_1.min(low_2), high_1.max(high_2));
    PairUniform {
        quadrics: [data(pair.first), data(second)],
        bounds: Vec4::new(low.x, low.y, high.x, high.y),
        choice: Vec4::new(f32::from(pair.second.is_some()), near, far, 0.0),
    }
}

/// The rectangle of the screen that holds the quadric's bounding box, with a margin for its soft edge; the whole
/// screen where the box reaches behind the eye.
fn bounds(quadric: Quadric, clip_from_world: Mat4) -> (glam::Vec2, glam::Vec2) {
    const MARGIN: f32 = 1.02;
    let clip_from_unit = clip_from_world * quadric.unit_from_world.inverse();
    let (mut low, mut high) = (glam::Vec2::ONE, glam::Vec2::NEG_ONE);
    for corner in 0..8 {
        let sign = |bit: i32| if corner >> bit & 1 == 0 { -MARGIN } else { MARGIN };
        let clip = clip_from_unit * Vec3::new(sign(0), sign(1), sign(2)).extend(1.0);
        if clip.w <= crate::camera::NEAR {
            return (glam::Vec2::NEG_ONE, glam::Vec2::ONE);
        }
        let ndc = glam::Vec2::new(clip.x, clip.y) / clip.w;
        low = low.min(ndc);
        high = high.max(ndc);
    }
    (low.max(glam::Vec2::NEG_ONE), high.min(glam::Vec2::ONE))
}
