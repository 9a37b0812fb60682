//! Draws a frame into a texture.

use glam::Vec2;

use super::buffer::UniformBuffer;
use super::gpu::Gpu;
use super::line::Lines;
use super::notes;
use super::pipeline::PipelineMaker;
use super::point::Points;
use super::quadrics::Quadrics;
use super::resolve::Resolve;
use super::solid::Solids;
use super::targets::Targets;
use super::text::Texts;
use super::touched::Touched;
use super::view::ViewUniform;
use crate::frame::Frame;

/// Pixels a point in a picture of this size, so that it looks the same at each size of one aspect: 1 at 1280×720 and
/// at 720×1280.
#[must_use]
pub fn point_size([width, height]: [u32; 2]) -> f32 {
    (width.max(height) as f32 / 1280.0).min(width.min(height) as f32 / 720.0)
}

/// The pipelines and the reused buffers. One serves window and file alike.
pub struct Renderer {
    views: UniformBuffer,
    solids: Solids,
    quadrics: Quadrics,
    lines: Lines,
    points: Points,
    texts: Texts,
    /// Where the device's own way is not taken.
    resolve: Option<Resolve>,
    targets: Option<Targets>,
}

impl Renderer {
    /// Makes the pipelines.
    #[must_use]
    pub fn new(gpu: &Gpu) -> Self {
        let views = UniformBuffer::new(&gpu.device, "view", size_of::<ViewUniform>());
        let maker = PipelineMaker { device: &gpu.device, view_layout: views.layout() };
        let solids = Solids::new(&maker);
        let quadrics = Quadrics::new(&maker);
        let lines = Lines::new(&maker);
        let points = Points::new(&maker);
        let texts = Texts::new(&maker);
        let resolve = gpu.is_software_vulkan().then(|| Resolve::new(&gpu.device));
        Self { views, solids, quadrics, lines, points, texts, resolve, targets: None }
    }

    /// Draws the frame into `target`, a view of a [`FORMAT`](super::FORMAT) texture of this size, with `point` pixels a point
    /// (for a file [`point_size`]). Submits the work and does not wait for it.
    pub fn render(&mut self, gpu: &Gpu, frame: &Frame, target: &wgpu::TextureView, size: [u32; 2], point: f32) {
        let (device, queue) = (&gpu.device, &gpu.queue);
        let point = point * frame.font_scale;
        let picture = Vec2::new(size[0] as f32, size[1] as f32);
        let uniforms: Vec<ViewUniform> = frame
            .views
            .iter()
            .map(|view| ViewUniform::new(view, (view.area.extent * picture).max(Vec2::ONE), point))
            .collect();
        let frame = &*self.texts.with_broken_notes(frame, picture, point);
        let frame = &*notes::with_samples(frame, &uniforms, picture, point);
        self.views.write(device, queue, &uniforms);
        self.solids.upload(device, queue, frame);
        self.quadrics.upload(device, queue, frame, &uniforms);
        self.lines.upload(device, queue, frame);
        self.points.upload(device, queue, frame);
        self.texts.upload(device, queue, frame, &uniforms, picture, point);

        if let Some(resolve) = &mut self.resolve {
            let mut touched = Touched::none(picture);
            touched.add_frame(frame, &uniforms, picture, point);
            for [low, high] in self.texts.boxes() {
                touched.add(*low, *high);
            }
            resolve.upload(device, queue, &touched.rectangles(), picture);
        }

        let targets = match self.targets.take() {
            Some(targets) if targets.size == size => targets,
            _ => Targets::new(device, size, self.resolve.is_some()),
        };
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("frame"),
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: &targets.color,
                    depth_slice: None,
                    resolve_target: self.resolve.is_none().then_some(target),
                    ops: wgpu::Operations {
                        load: wgpu::LoadOp::Clear(clear_color(frame)),
                        store: if self.resolve.is_some() { wgpu::StoreOp::Store } else { wgpu::StoreOp::Discard },
                    },
                })],
                depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                    view: &targets.depth,
                    depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store: wgpu::StoreOp::Discard }),
                    stencil_ops: None,
                }),
                timestamp_writes: None,
                occlusion_query_set: None,
                multiview_mask: None,
            });
            for (number, view) in frame.views.iter().enumerate() {
                let corner = view.area.corner * picture;
                let extent = (view.area.extent * picture).max(Vec2::ONE);
                pass.set_viewport(corner.x, corner.y, extent.x, extent.y, 0.0, 1.0);
                self.views.bind(&mut pass, 0, number);
                self.solids.draw(&mut pass, number);
                let hollow = self.quadrics.draw_far_walls(&mut pass, number);
                if hollow {
                    self.lines.draw_inside(&mut pass, number);
                }
                self.quadrics.draw_near_walls(&mut pass, number);
                if hollow {
                    self.lines.draw_seen(&mut pass, number);
                } else {
                    self.lines.draw_all(&mut pass, number);
                }
                self.points.draw(&mut pass, number);
                self.texts.draw(&mut pass, number);
            }
        }
        if let Some(resolve) = &self.resolve {
            resolve.draw(device, &mut encoder, &targets.color, target, clear_color(frame));
        }
        queue.submit([encoder.finish()]);
        self.targets = Some(targets);
    }
}

fn clear_color(frame: &Frame) -> wgpu::Color {
    if frame.transparent {
        return wgpu::Color::TRANSPARENT;
    }
    let [r, g, b, _] = frame.background.0.map(f64::from);
    wgpu::Color { r, g, b, a: 1.0 }
}
