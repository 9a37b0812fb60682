//! Draws a frame into a texture.

use glam::Vec2;

use super::buffer::UniformBuffer;
use super::dots::Dots;
use super::gpu::Gpu;
use super::line::Lines;
use super::marker::Markers;
use super::mesh::Meshes;
use super::notes;
use super::pane::PaneUniform;
use super::pipeline::PipelineMaker;
use super::quadrics::Quadrics;
use super::resolve::Resolve;
use super::targets::Targets;
use super::text::Texts;
use super::touched::Touched;
use crate::frame::Frame;

/// Pixels a point in a picture of this size, so that it looks the same at each size of one aspect: 1 at 1280×720 and
/// at 720×1280.
#[must_use]
pub fn point_size([width, height]: [u32; 2]) -> f32 {
    (width.max(height) as f32 / 1280.0).min(width.min(height) as f32 / 720.0)
}

/// The pipelines and the reused buffers. One serves window and file alike.
pub(super) struct Renderer {
    panes: UniformBuffer,
    meshes: Meshes,
    quadrics: Quadrics,
    lines: Lines,
    dots: Dots,
    markers: Markers,
    texts: Texts,
    /// Where the device's own way is not taken.
    resolve: Option<Resolve>,
    targets: Option<Targets>,
}

impl Renderer {
    /// Makes the pipelines.
    #[must_use]
    pub(super) fn new(gpu: &Gpu) -> Self {
        let panes = UniformBuffer::new(&gpu.device, "pane", size_of::<PaneUniform>());
        let maker = PipelineMaker { device: &gpu.device, pane_layout: panes.layout() };
        let meshes = Meshes::new(&maker);
        let quadrics = Quadrics::new(&maker);
        let lines = Lines::new(&maker);
        let dots = Dots::new(&maker);
        let markers = Markers::new(&maker);
        let texts = Texts::new(&maker);
        let resolve = gpu.is_software_vulkan().then(|| Resolve::new(&gpu.device));
        Self { panes, meshes, quadrics, lines, dots, markers, texts, resolve, targets: None }
    }

    /// Draws the frame into `target`, a view of a [`FORMAT`](super::FORMAT) texture of this size, with `point` pixels a point
    /// (for a file [`point_size`]). Submits the work and does not wait for it.
    pub(super) fn render(&mut self, gpu: &Gpu, frame: &Frame, target: &wgpu::TextureView, size: [u32; 2], point: f32) {
        let (device, queue) = (&gpu.device, &gpu.queue);
        let point = point * frame.font_scale;
        let picture = Vec2::new(size[0] as f32, size[1] as f32);
        let uniforms: Vec<PaneUniform> = frame
            .panes
            .iter()
            .map(|pane| PaneUniform::new(pane, (pane.area.extent * picture).max(Vec2::ONE), point))
            .collect();
        // Of each pane two layers: its world, and what lies on the screen before it.
        let notes = self.texts.lay_out_notes(frame, picture, point);
        let flat: Vec<_> = notes.iter().map(|notes| notes::swatches(notes, point)).collect();
        let layers = frame.panes.iter().zip(&uniforms);
        let layers = layers
            .flat_map(|(pane, world)| [*world, PaneUniform::flat((pane.area.extent * picture).max(Vec2::ONE), point)]);
        self.panes.write(device, queue, &layers.collect::<Vec<_>>());
        self.meshes.upload(device, queue, frame);
        self.quadrics.upload(device, queue, frame, &uniforms);
        let layers = || frame.panes.iter().zip(&flat);
        let lines = layers().flat_map(|(pane, (lines, _))| [(&*pane.lines, pane.lift), (&**lines, 0.0)]);
        self.lines.upload(device, queue, lines);
        self.dots.upload(device, queue, frame.panes.iter());
        self.markers.upload(device, queue, layers().flat_map(|(pane, (_, markers))| [&*pane.markers, &**markers]));
        self.texts.upload((device, queue), frame, &notes, &uniforms, picture, point);

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
            for (number, pane) in frame.panes.iter().enumerate() {
                let corner = pane.area.corner * picture;
                let extent = (pane.area.extent * picture).max(Vec2::ONE);
                pass.set_viewport(corner.x, corner.y, extent.x, extent.y, 0.0, 1.0);
                let (world, flat) = (2 * number, 2 * number + 1);
                self.panes.bind(&mut pass, 0, world);
                self.meshes.draw(&mut pass, number);
                let hollow = self.quadrics.draw_far_walls(&mut pass, number);
                if hollow {
                    self.lines.draw_inside(&mut pass, world);
                }
                self.quadrics.draw_near_walls(&mut pass, number);
                if hollow {
                    self.lines.draw_seen(&mut pass, world);
                } else {
                    self.lines.draw_all(&mut pass, world);
                }
                self.dots.draw(&mut pass, number);
                self.markers.draw(&mut pass, world);
                self.panes.bind(&mut pass, 0, flat);
                self.lines.draw_seen(&mut pass, flat);
                self.markers.draw(&mut pass, flat);
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
