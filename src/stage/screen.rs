//! Everything that lives on the graphics device: made anew as a whole when the device is lost.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use super::StageError;
use super::kept_pixels::KeptPixels;
use super::stale::Shown;
use super::surface::{Acquired, Surface};
use crate::frame::{Frame, PlacedName};
use crate::render::{Canvas, Gpu, Painter, Reading};

/// The device, the surface and what is drawn with.
pub(super) struct Screen {
    // Dropped in this order: what lives on the device before the device.
    surface: Surface,
    painter: Painter,
    panels: egui_wgpu::Renderer,
    /// The window's pixels, where they are kept.
    kept: Option<KeptPixels>,
    /// Whether the picture is another one than that of the last frame.
    is_picture_new: bool,
    gpu: Gpu,
    is_lost: Arc<AtomicBool>,
    /// The device was taken away on trial.
    is_trial: Arc<AtomicBool>,
}

/// What came of presenting a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Presented {
    /// It is on the screen.
    Shown,
    /// There was nothing to draw to.
    Skipped,
    /// It should be tried again at once.
    Again,
    /// The surface is gone: it should be tried again with another one.
    SurfaceLost,
}

/// What the panels came to, ready for drawing.
pub(super) struct Painted {
    /// Triangles.
    pub(super) primitives: Vec<egui::ClippedPrimitive>,
    /// Pixels a point.
    pub(super) pixels_per_point: f32,
    /// Behind everything.
    pub(super) background: egui::Color32,
}

impl Screen {
    /// Finds an adapter for the surface and opens a device on it; `on_lost` is called where that device is gone.
    pub(super) async fn open(
        instance: &wgpu::Instance,
        surface: wgpu::Surface<'static>,
        adapter: Option<&str>,
        size: (u32, u32),
        on_lost: impl Fn() + Send + 'static,
    ) -> Result<Self, StageError> {
        let mut gpu = Gpu::for_surface(instance, &surface, adapter).await?;
        let is_lost = Arc::new(AtomicBool::new(false));
        let is_trial = Arc::new(AtomicBool::new(false));
        let (flag, trial) = (Arc::clone(&is_lost), Arc::clone(&is_trial));
        gpu.device.set_device_lost_callback(move |reason, _| {
            // Dropping the device on purpose comes here too.
            if reason != wgpu::DeviceLostReason::Destroyed || trial.load(Ordering::Relaxed) {
                flag.store(true, Ordering::Relaxed);
                on_lost();
            }
        });
        let surface = Surface::new(surface, &gpu, size)?;
        let kept = surface.takes_copies().then(KeptPixels::default);
        if kept.is_some() {
            gpu.draw_as(surface.format());
        }
        let painter = Painter::for_window(&gpu, surface.format());
        let panels = egui_wgpu::Renderer::new(&gpu.device, surface.format(), egui_wgpu::RendererOptions::default());
        Ok(Self { surface, painter, panels, kept, is_picture_new: false, gpu, is_lost, is_trial })
    }

    /// Whether the device is gone and everything on it.
    pub(super) fn is_lost(&self) -> bool {
        self.is_lost.load(Ordering::Relaxed)
    }

    /// Takes the device away; all that follows is as with a driver that gave up.
    pub(super) fn lose(&self) {
        self.is_trial.store(true, Ordering::Relaxed);
        self.gpu.device.destroy();
    }

    /// The device.
    pub(super) fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Its size in pixels.
    pub(super) fn size(&self) -> (u32, u32) {
        self.surface.size()
    }

    /// Follows the screen's size.
    pub(super) fn resize(&mut self, width: u32, height: u32) {
        self.surface.resize(&self.gpu, width, height);
    }

    /// Gives the picture its size; true where it must be drawn anew.
    pub(super) fn resize_picture(&mut self, size: (u32, u32)) -> bool {
        self.painter.resize_picture(&self.gpu, size)
    }

    /// Draws the picture, with this many pixels a point.
    pub(super) fn draw_picture(&mut self, frame: &Frame, point: f32) {
        self.is_picture_new = true;
        self.painter.draw_picture(&self.gpu, frame, point);
    }

    /// The labels of the picture, where they stand.
    pub(super) fn names(&self) -> &[PlacedName] {
        self.painter.names()
    }

    /// Takes another surface of the same screen.
    pub(super) fn replace_surface(&mut self, surface: wgpu::Surface<'static>) {
        self.surface.replace(surface, &self.gpu);
    }

    /// Draws a frame on a canvas, apart from the screen, and asks for it.
    pub(super) fn draw_on(&mut self, canvas: &Canvas, frame: &Frame) -> Reading {
        self.painter.draw_on(&self.gpu, canvas, frame)
    }

    /// Draws the picture at its place, the panels on top, and presents; `before` is called right before that. The context is that
    /// of the panels.
    pub(super) fn present(
        &mut self,
        context: &egui::Context,
        shown: Shown,
        mut textures: egui::TexturesDelta,
        before: impl FnOnce(),
    ) -> Presented {
        // A texture as a whole is another one, whatever shows it.
        if let Some(kept) = &mut self.kept
            && textures.set.values().flatten().any(egui::epaint::ImageDelta::is_whole)
        {
            kept.forget();
        }
        // Also where no frame is had: the next pass only tells what changed since.
        upload(&self.gpu, &mut self.panels, &mut textures);
        let presented = match self.surface.acquire(&self.gpu) {
            Acquired::Frame { texture, is_suboptimal } => {
                let is_picture_new = std::mem::take(&mut self.is_picture_new);
                if let Some(kept) = &mut self.kept {
                    let panels = (&mut self.panels, context);
                    kept.paint(&self.gpu, &texture.texture, (&self.painter, is_picture_new), panels, shown);
                } else {
                    let view = texture.texture.create_view(&wgpu::TextureViewDescriptor::default());
                    let picture = (&self.painter, (shown.picture.min.x as u32, shown.picture.min.y as u32));
                    let painted = Painted {
                        primitives: context.tessellate(shown.shapes, shown.pixels_per_point),
                        pixels_per_point: shown.pixels_per_point,
                        background: shown.background,
                    };
                    paint(&self.gpu, (&view, self.surface.size()), picture, &mut self.panels, &painted);
                }
                before();
                self.gpu.queue.present(texture);
                if is_suboptimal {
                    self.surface.configure(&self.gpu);
                }
                Presented::Shown
            }
            Acquired::Skip => Presented::Skipped,
            Acquired::Again => Presented::Again,
            Acquired::Lost => Presented::SurfaceLost,
            Acquired::Gone => {
                self.is_lost.store(true, Ordering::Relaxed);
                Presented::Skipped
            }
        };
        for id in textures.free.drain() {
            self.panels.free_texture(&id);
        }
        presented
    }
}

/// Draws the picture at its corner (pixels) and the panels on top.
pub(super) fn paint(
    gpu: &Gpu,
    (target, size): (&wgpu::TextureView, (u32, u32)),
    (painter, corner): (&Painter, (u32, u32)),
    panels: &mut egui_wgpu::Renderer,
    painted: &Painted,
) {
    let Gpu { device, queue, .. } = gpu;
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("screen") });
    let screen =
        egui_wgpu::ScreenDescriptor { size_in_pixels: [size.0, size.1], pixels_per_point: painted.pixels_per_point };
    let uploads = panels.update_buffers(device, queue, &mut encoder, &painted.primitives, &screen);
    let [r, g, b, _] = painted.background.to_normalized_gamma_f32();
    let background = wgpu::Color { r: r.into(), g: g.into(), b: b.into(), a: 1.0 };
    let mut pass = encoder
        .begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("screen"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: target,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load: wgpu::LoadOp::Clear(background), store: wgpu::StoreOp::Store },
            })],
            depth_stencil_attachment: None,
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        })
        .forget_lifetime();
    painter.place_picture(&mut pass, corner, size);
    panels.render(&mut pass, &painted.primitives, &screen);
    drop(pass);
    queue.submit(uploads.into_iter().chain([encoder.finish()]));
}

/// Sends the panels' new textures to the device.
pub(super) fn upload(gpu: &Gpu, panels: &mut egui_wgpu::Renderer, textures: &mut egui::TexturesDelta) {
    for (id, deltas) in textures.set.drain() {
        for delta in deltas {
            panels.update_texture(&gpu.device, &gpu.queue, id, &delta);
        }
    }
}
