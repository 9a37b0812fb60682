//! Draws frames where they are wanted: one painter for the window, the page, panels drawn with no window and pictures for files.

use super::compose::Compose;
use super::gpu::{Gpu, GpuError};
use super::part::{Part, rows_of_band};
use super::readback::{Canvas, Reading};
use super::renderer::{Renderer, point_size};
use crate::frame::{Frame, PlacedName};

/// What draws frames on one device, and the window's picture where there is a window.
pub struct Painter {
    renderer: Renderer,
    compose: Option<Compose>,
}

impl Painter {
    /// For pictures on canvases.
    #[must_use]
    pub fn new(gpu: &Gpu) -> Self {
        Self { renderer: Renderer::new(gpu), compose: None }
    }

    /// For a window too, or what stands for one, whose own frames have this format. The picture has a texture of its own: it is
    /// drawn only when something in it changed, and the panels around it come and go without it.
    #[must_use]
    pub fn for_window(gpu: &Gpu, format: wgpu::TextureFormat) -> Self {
        Self { compose: Some(Compose::new(gpu, format)), ..Self::new(gpu) }
    }

    /// Draws a frame on a canvas, as a file shows it, and asks for it. Submits the work and does not wait for it.
    pub fn draw_on(&mut self, gpu: &Gpu, canvas: &Canvas, frame: &Frame) -> Reading {
        let size = canvas.size();
        self.renderer.prepare(gpu, frame, size, point_size(size));
        let mut last = None;
        for band in canvas.bands() {
            self.renderer.draw(gpu, canvas.view(), band);
            last = Some(canvas.take_band(gpu, band.low[1]));
        }
        last.map_or_else(|| canvas.begin_read(gpu), |last| canvas.ask(last))
    }

    /// Draws a frame as on a [`Canvas`] of this size, and hands over its rows from the top; the picture is never in memory as a
    /// whole, and each band of it is taken while the next one is drawn. Waits, so it is not for a browser.
    ///
    /// # Errors
    /// What the device reports, or what `take` returns.
    pub fn draw_rows<E: From<GpuError>>(
        &mut self,
        gpu: &Gpu,
        frame: &Frame,
        size: [u32; 2],
        mut take: impl FnMut(&[u8]) -> Result<(), E>,
    ) -> Result<(), E> {
        let [width, height] = size;
        let rows = rows_of_band(size);
        let canvases = [(); 2].map(|()| Canvas::whole(gpu, [width, rows]));
        gpu.check()?;
        self.renderer.prepare(gpu, frame, size, point_size(size));
        let mut under_way: Option<(&Canvas, Reading, u32)> = None;
        for (canvas, top) in canvases.iter().cycle().zip((0..height).step_by(rows.max(1) as usize)) {
            self.renderer.draw(gpu, canvas.view(), Part { low: [0, top], size: canvas.size() });
            let before = under_way.replace((canvas, canvas.begin_read(gpu), rows.min(height - top)));
            if let Some((canvas, reading, rows)) = before {
                canvas.finish_rows(gpu, &reading, rows, &mut take)?;
            }
        }
        under_way.map_or(Ok(()), |(canvas, reading, rows)| canvas.finish_rows(gpu, &reading, rows, &mut take))
    }

    /// Gives the window's picture its size; true where its content is thereby lost.
    pub fn resize_picture(&mut self, gpu: &Gpu, size: (u32, u32)) -> bool {
        self.compose.as_mut().is_some_and(|compose| compose.resize(gpu, size))
    }

    /// Draws the window's picture, with this many pixels a point.
    pub fn draw_picture(&mut self, gpu: &Gpu, frame: &Frame, point: f32) {
        if let Some((target, size)) = self.compose.as_ref().and_then(Compose::target) {
            self.renderer.render(gpu, frame, target, [size.0, size.1], point);
        }
    }

    /// The labels of what was drawn last, where they stand.
    #[must_use]
    pub fn names(&self) -> &[PlacedName] {
        self.renderer.names()
    }

    /// Copies what of the window's picture lies in a part of the window (corner and size in pixels), where it has the window's format
    /// ([`Gpu::draw_as`]) and its upper left corner at `corner`; false where none lies there.
    pub fn copy_picture(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        window: &wgpu::Texture,
        corner: [u32; 2],
        part: ([u32; 2], [u32; 2]),
    ) -> bool {
        self.compose.as_ref().is_some_and(|compose| compose.copy(encoder, window, corner, part))
    }

    /// Copies the window's picture to its place, `corner` in pixels of the window.
    pub fn place_picture(&self, pass: &mut wgpu::RenderPass<'_>, corner: (u32, u32), window: (u32, u32)) {
        if let Some(compose) = &self.compose {
            compose.draw(pass, corner, window);
        }
    }
}
