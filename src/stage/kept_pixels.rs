//! The window's pixels, kept where there is no GPU: only what is stale of them is painted again, and the frame is a copy.

use egui::epaint::{ClippedPrimitive, Mesh, Primitive};
use egui::{Rect, Vec2};

use super::stale::{Shown, add, outside};
use crate::render::{Gpu, Painter};

/// The pixels, and what they come from.
#[derive(Default)]
pub(super) struct KeptPixels {
    texture: Option<wgpu::Texture>,
    shown: Option<Shown>,
}

impl KeptPixels {
    /// Forgets what it shows: all of it will be painted.
    pub(super) fn forget(&mut self) {
        self.shown = None;
    }

    /// Brings the pixels up to what is to be shown, with `painter`'s picture, which may be another than before, and copies it to the
    /// frame. The context is that of the shapes.
    pub(super) fn paint(
        &mut self,
        gpu: &Gpu,
        frame: &wgpu::Texture,
        (painter, is_picture_new): (&Painter, bool),
        (panels, context): (&mut egui_wgpu::Renderer, &egui::Context),
        shown: Shown,
    ) {
        let (device, queue) = (&gpu.device, &gpu.queue);
        let size = frame.size();
        let window = Vec2::new(size.width as f32, size.height as f32);
        let texture = match self.texture.take() {
            Some(texture) if texture.size() == size => texture,
            _ => {
                self.forget();
                make(device, size, frame.format())
            }
        };
        let whole = Rect::from_min_size(egui::Pos2::ZERO, window);
        let mut stale = self.shown.as_ref().map_or_else(|| vec![whole], |before| shown.stale_since(before, window));
        if is_picture_new {
            add(&mut stale, shown.picture.intersect(whole));
        }

        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("window") });
        let mut primitives = vec![];
        for &rect in &stale {
            let seen = rect.intersect(shown.picture);
            let corner = [shown.picture.min.x as u32, shown.picture.min.y as u32];
            let part = ([seen.min.x as u32, seen.min.y as u32], [seen.width() as u32, seen.height() as u32]);
            let is_copied = seen.is_positive() && painter.copy_picture(&mut encoder, &texture, corner, part);
            let ground = if is_copied { outside(rect, shown.picture) } else { vec![rect] };
            let ground = ground.into_iter().map(|rect| filled(rect / shown.pixels_per_point, shown.background));
            primitives.extend(ground);
            primitives.extend(context.tessellate(shown.within(rect), shown.pixels_per_point));
        }
        let screen = egui_wgpu::ScreenDescriptor {
            size_in_pixels: [size.width, size.height],
            pixels_per_point: shown.pixels_per_point,
        };
        let uploads = panels.update_buffers(device, queue, &mut encoder, &primitives, &screen);
        if !primitives.is_empty() {
            let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
            let mut pass = encoder
                .begin_render_pass(&wgpu::RenderPassDescriptor {
                    label: Some("what is stale of the window"),
                    color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                        view: &view,
                        depth_slice: None,
                        resolve_target: None,
                        ops: wgpu::Operations { load: wgpu::LoadOp::Load, store: wgpu::StoreOp::Store },
                    })],
                    depth_stencil_attachment: None,
                    timestamp_writes: None,
                    occlusion_query_set: None,
                    multiview_mask: None,
                })
                .forget_lifetime();
            panels.render(&mut pass, &primitives, &screen);
        }
        encoder.copy_texture_to_texture(texture.as_image_copy(), frame.as_image_copy(), size);
        queue.submit(uploads.into_iter().chain([encoder.finish()]));
        self.texture = Some(texture);
        self.shown = Some(shown);
    }
}

fn make(device: &wgpu::Device, size: wgpu::Extent3d, format: wgpu::TextureFormat) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("window kept"),
        size,
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    })
}

/// A rectangle (points) of one colour.
fn filled(rect: Rect, color: egui::Color32) -> ClippedPrimitive {
    let mut mesh = Mesh::default();
    mesh.add_colored_rect(rect, color);
    ClippedPrimitive { clip_rect: rect, primitive: Primitive::Mesh(mesh) }
}
