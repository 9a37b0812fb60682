//! The window as it would look, drawn with no window: the picture with the panels around it.

use super::fit::{picture_point, place, zoom};
use super::screen::{Painted, paint, upload};
use crate::render::{Canvas, FORMAT, Gpu, GpuError, Painter, Pixels};
use crate::scene::Scene;
use crate::session::{Remembered, Session};
use crate::ui::{Panels, style};
use web_time::Instant;

/// Draws a scene at a time (s) with the window's panels, paused, in this many pixels, on a device that can draw them, or as it
/// is in presenter's mode.
/// What some window was last like is not looked at.
///
/// # Errors
/// What the device reports.
pub fn with_panels(
    gpu: &Gpu,
    scene: Scene,
    time: f64,
    [width, height]: [u32; 2],
    presenting: bool,
) -> Result<Pixels, GpuError> {
    let window = (width, height);
    let now = Instant::now();
    let mut session = Session::new(scene, Vec::new(), &Remembered { presenting, ..Remembered::default() }, now);
    session.say_nothing();
    session.show_time(time);

    let context = egui::Context::default();
    style::install(&context);
    style::set_theme(&context, session.theme());
    let (wide, high) = (width as f32, height as f32);
    let font_scale = session.scene().view.font_scale as f32;
    let zoom = zoom(wide, high, font_scale, presenting);
    context.set_zoom_factor(zoom);
    let mut panels = Panels::default();
    let canvas = Canvas::whole(gpu, [width, height]);
    // The panels' renderer ends the program on a device that is lost.
    gpu.check()?;
    let mut panels_painter = egui_wgpu::Renderer::new(&gpu.device, FORMAT, egui_wgpu::RendererOptions::PREDICTABLE);

    // The first pass has no sizes yet.
    let mut last = None;
    for _ in 0..3 {
        let input = egui::RawInput {
            screen_rect: Some(egui::Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(wide, high) / zoom)),
            max_texture_side: Some(gpu.largest_side() as usize),
            ..Default::default()
        };
        let mut picture = egui::Rect::NOTHING;
        let look = session.look(None, false);
        let mut output = context.run_ui(input, |ui| picture = panels.ui(ui, &look).picture);
        upload(gpu, &mut panels_painter, &mut output.textures_delta);
        last = Some((output, picture));
    }
    if let Some((output, picture)) = last {
        let (corner, size) = place(picture, output.pixels_per_point, window);
        let mut painter = Painter::for_window(gpu, FORMAT);
        if size.0 > 0 && size.1 > 0 {
            painter.resize_picture(gpu, size);
            let frame = session.frame(size.0 as f32 / size.1 as f32);
            // The frame scales its texts by this itself.
            painter.draw_picture(gpu, &frame, picture_point(output.pixels_per_point, size) / font_scale);
        }
        let painted = Painted {
            primitives: context.tessellate(output.shapes, output.pixels_per_point),
            pixels_per_point: output.pixels_per_point,
            background: context.global_style().visuals.panel_fill,
        };
        paint(gpu, (canvas.view(), window), (&painter, corner), &mut panels_painter, &painted);
    }
    canvas.read(gpu)
}
