//! Draws frames where they are wanted: one painter for the window, the page, panels drawn with no window and pictures for files.

use super::compose::Compose;
use super::gpu::Gpu;
use super::part::Part;
use super::readback::Canvas;
use super::renderer::{Renderer, point_size};
use crate::frame::Frame;

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

    /// Draws a frame on a canvas, as a file shows it. Submits the work and does not wait for it.
    pub fn draw_on(&mut self, gpu: &Gpu, canvas: &Canvas, frame: &Frame) {
        let size = canvas.size();
        self.renderer.render(gpu, frame, canvas.view(), size, point_size(size));
    }

    /// Takes a frame to the device, to be drawn in bands of a picture of this size.
    pub fn prepare(&mut self, gpu: &Gpu, frame: &Frame, size: [u32; 2]) {
        self.renderer.prepare(gpu, frame, size, point_size(size));
    }

    /// Draws the band of the prepared picture that a canvas as wide holds, from the row `top` on. Submits the work and does
    /// not wait for it.
    pub fn draw_band(&mut self, gpu: &Gpu, canvas: &Canvas, top: u32) {
        self.renderer.draw(gpu, canvas.view(), Part { low: [0, top], size: canvas.size() });
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

    /// Copies the window's picture to its place, `corner` in pixels of the window.
    pub fn place_picture(&self, pass: &mut wgpu::RenderPass<'_>, corner: (u32, u32), window: (u32, u32)) {
        if let Some(compose) = &self.compose {
            compose.draw(pass, corner, window);
        }
    }
}
