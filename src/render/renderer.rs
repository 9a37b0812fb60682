//! Draws a frame into a texture.

use glam::Vec2;

use super::buffer::UniformBuffer;
use super::dots::Dots;
use super::gpu::Gpu;
use super::mesh::Meshes;
use super::notes;
use super::overlay::{self, Overlays, Run, Shown};
use super::pane::{PaneUniform, Projection};
use super::part::Part;
use super::pipeline::PipelineMaker;
use super::quadrics::{self, Quadrics};
use super::solids::Solids;
use super::targets::{DEPTH_FORMAT, color_attachment, depth_attachment, target as texture_target};
use super::text::Texts;
use super::{line, marker};
use crate::frame::{Frame, Pane, PlacedName};

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
    dots: Dots,
    overlays: Overlays,
    texts: Texts,
    solids: Solids,
    depths: Option<Depths>,
    /// What the frame last prepared comes to.
    prepared: Prepared,
}

/// How near the surfaces of a picture, or of a part of it, are.
struct Depths {
    size: [u32; 2],
    view: wgpu::TextureView,
}

/// A frame whose data are on the device.
#[derive(Default)]
struct Prepared {
    clear: wgpu::Color,
    panes: Vec<PreparedPane>,
    /// The bind group of the overlays is another one from now on.
    is_atlas_new: bool,
}

/// A pane of it.
struct PreparedPane {
    /// Its upper left corner and its width and height (pixels of the picture).
    corner: Vec2,
    extent: Vec2,
    /// The quads of its lines, of its marks, and of all that lies on the screen before it.
    lines: Vec<Run>,
    /// The lines lie in an order in which those behind walls come first.
    is_sorted: bool,
    marks: Vec<Run>,
    flat: Vec<Run>,
}

impl Renderer {
    #[must_use]
    pub(super) fn new(gpu: &Gpu) -> Self {
        let panes = UniformBuffer::new(&gpu.device, "pane", size_of::<PaneUniform>());
        Self {
            panes,
            overlays: Overlays::new(gpu),
            meshes: Meshes::new(),
            quadrics: Quadrics::new(&gpu.device),
            dots: Dots::new(),
            texts: Texts::new(),
            solids: Solids::new(gpu),
            depths: None,
            prepared: Prepared::default(),
        }
    }

    /// Draws the frame into `target`, a view of a texture of this size and of the device's format, with `point` pixels a point
    /// (for a file [`point_size`]). Submits the work and does not wait for it.
    pub(super) fn render(&mut self, gpu: &Gpu, frame: &Frame, target: &wgpu::TextureView, size: [u32; 2], point: f32) {
        self.prepare(gpu, frame, size, point);
        self.draw(gpu, target, Part { low: [0; 2], size });
    }

    /// The labels of the frame that was prepared last.
    pub(super) fn names(&self) -> &[PlacedName] {
        self.texts.names()
    }

    /// Takes what a frame holds to the device, for a picture of this size.
    pub(super) fn prepare(&mut self, gpu: &Gpu, frame: &Frame, size: [u32; 2], point: f32) {
        let (device, queue) = (&gpu.device, &gpu.queue);
        let point = point * frame.font_scale;
        let picture = Vec2::new(size[0] as f32, size[1] as f32);
        let extents: Vec<Vec2> = frame.panes.iter().map(|pane| (pane.area.extent * picture).max(Vec2::ONE)).collect();
        let uniforms: Vec<PaneUniform> =
            frame.panes.iter().zip(&extents).map(|(pane, extent)| PaneUniform::new(pane, *extent, point)).collect();
        self.panes.write(device, queue, &uniforms);
        let maker = PipelineMaker { gpu, pane_layout: self.panes.layout() };
        self.meshes.upload(&maker, queue, frame, &uniforms, !self.solids.reads_samples);
        self.quadrics.upload(&maker, queue, frame, &uniforms);
        self.dots.upload(&maker, queue, frame.panes.iter());

        let notes = self.texts.lay_out_notes(frame, picture, point);
        let mut corners = vec![];
        let mut panes = vec![];
        for (((pane, uniform), notes), extent) in frame.panes.iter().zip(&uniforms).zip(&notes).zip(&extents) {
            let corner = pane.area.corner * picture;
            let mut begun = (corners.len() / 4) as u32;
            let mut runs = |corners: &Vec<_>| {
                let end = (corners.len() / 4) as u32;
                overlay::runs(corners, std::mem::replace(&mut begun, end)..end)
            };
            let first = corners.len();
            let world = Projection::new(uniform, corner);
            for line in &pane.lines {
                line::append(line, pane.lift, &world, point, &mut corners);
            }
            let is_sorted = is_sorted(pane);
            if is_sorted {
                overlay::put_first(&mut corners[first..], |middle| {
                    let ndc = ((middle.truncate() - corner) / extent * 2.0 - 1.0) * Vec2::new(1.0, -1.0);
                    quadrics::hide(&pane.quadrics, uniform, ndc, middle.z)
                });
            }
            let lines = runs(&corners);
            for marker in &pane.markers {
                marker::append(marker, &world, point, &mut corners);
            }
            let marks = runs(&corners);
            let screen = PaneUniform::flat(*extent, point);
            let screen = Projection::new(&screen, corner);
            let (swatch_lines, swatch_marks) = notes::swatches(notes, point);
            for line in &swatch_lines {
                line::append(line, 0.0, &screen, point, &mut corners);
            }
            for marker in &swatch_marks {
                marker::append(marker, &screen, point, &mut corners);
            }
            self.texts.append((pane, uniform, corner), notes, (frame.background, point), &mut corners);
            let flat = runs(&corners);
            panes.push(PreparedPane { corner, extent: *extent, lines, is_sorted, marks, flat });
        }
        let runs = panes.iter().flat_map(|pane: &PreparedPane| [&pane.lines, &pane.marks, &pane.flat]).flatten();
        self.overlays.upload(gpu, &corners, runs);
        let is_atlas_new = self.texts.upload(device, queue) || self.prepared.is_atlas_new;
        self.prepared = Prepared { clear: clear_color(frame), panes, is_atlas_new };
    }

    /// Draws a part of the frame that was prepared into `target`, of the part's size. Submits the work and does not wait for it.
    pub(super) fn draw(&mut self, gpu: &Gpu, target: &wgpu::TextureView, part: Part) {
        let (device, queue) = (&gpu.device, &gpu.queue);
        let prepared = &mut self.prepared;
        let rooms = prepared.panes.iter().enumerate().filter_map(|(number, pane)| {
            let outline = self.meshes.outline(number)?;
            let [low, high] = outline.bounds()?.map(|at| at + pane.corner);
            let room = part.within(low, high);
            Some((number, room, outline.rectangles(room, pane.corner).collect()))
        });
        self.solids.make_room(gpu, part, rooms);
        let mut are_new = std::mem::take(&mut prepared.is_atlas_new);
        let depths = match self.depths.take() {
            Some(depths) if depths.size == part.size => depths,
            _ => {
                are_new = true;
                let view = texture_target(device, "depths", part.size, DEPTH_FORMAT, 1, true);
                Depths { size: part.size, view }
            }
        };
        if let Some(atlas) = self.texts.atlas() {
            self.overlays.turn_to((device, queue), part, &depths.view, atlas, are_new);
        }

        let prepared = &self.prepared;
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        if let Some(mut pass) = self.solids.begin(&mut encoder) {
            for room in self.solids.rooms() {
                let Some(pane) = prepared.panes.get(room.pane) else { continue };
                let corner = pane.corner - room.part.corner() + Vec2::X * room.left as f32;
                pass.set_viewport(corner.x, corner.y, pane.extent.x, pane.extent.y, 0.0, 1.0);
                pass.set_scissor_rect(room.left, 0, room.part.size[0], room.part.size[1]);
                self.panes.bind(&mut pass, 0, room.pane);
                self.meshes.draw_solids(&mut pass, room.pane);
            }
            // OpenGL takes the means of no more than what is cut out last.
            self.solids.cut_nothing(&mut pass);
        }
        let is_hollow = |pane: usize| self.quadrics.are_hollow(pane);
        let any_hollow = (0..prepared.panes.len()).any(is_hollow);
        {
            let mut pass = surfaces_pass(&mut encoder, target, &depths.view, Some(prepared.clear));
            self.solids.draw(&mut pass);
            self.each_pane(&mut pass, part, |pass, pane| {
                self.meshes.draw_depths(pass, pane);
                self.meshes.draw_flat(pass, pane);
                self.quadrics.draw_far_walls(pass, pane);
                if !any_hollow {
                    self.quadrics.draw_near_walls(pass, pane);
                    self.dots.draw(pass, pane);
                }
            });
        }
        if any_hollow {
            // Between the walls: what of the lines shows through the near ones, and not through a body.
            self.draw_overlays(&mut encoder, target, part, |pass, number, pane| {
                if is_hollow(number) {
                    self.overlays.draw(pass, &pane.lines, Shown::Inside);
                }
            });
            let mut pass = surfaces_pass(&mut encoder, target, &depths.view, None);
            self.each_pane(&mut pass, part, |pass, pane| {
                self.quadrics.draw_near_walls(pass, pane);
                self.dots.draw(pass, pane);
            });
        }
        self.draw_overlays(&mut encoder, target, part, |pass, number, pane| {
            if pane.is_sorted {
                self.overlays.draw(pass, &pane.lines, Shown::Sorted);
            } else {
                if !is_hollow(number) {
                    self.overlays.draw(pass, &pane.lines, Shown::Hidden);
                }
                self.overlays.draw(pass, &pane.lines, Shown::Seen);
            }
            self.overlays.draw(pass, &pane.marks, Shown::Hidden);
            self.overlays.draw(pass, &pane.marks, Shown::Seen);
            self.overlays.draw(pass, &pane.flat, Shown::Seen);
        });
        queue.submit([encoder.finish()]);
        self.depths = Some(depths);
    }

    /// Draws something in each pane of which this part shows anything, as its own camera sees it.
    fn each_pane(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        part: Part,
        mut draw: impl FnMut(&mut wgpu::RenderPass<'_>, usize),
    ) {
        for (number, pane) in self.prepared.panes.iter().enumerate() {
            if let Some(scissor) = pane.scissor(part) {
                let corner = pane.corner - part.corner();
                pass.set_viewport(corner.x, corner.y, pane.extent.x, pane.extent.y, 0.0, 1.0);
                let ([x, y], [width, height]) = scissor;
                pass.set_scissor_rect(x, y, width, height);
                self.panes.bind(pass, 0, number);
                draw(pass, number);
            }
        }
    }

    /// Draws overlays in each pane of which this part shows anything.
    fn draw_overlays(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        target: &wgpu::TextureView,
        part: Part,
        draw: impl Fn(&mut wgpu::RenderPass<'_>, usize, &PreparedPane),
    ) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("overlays"),
            color_attachments: &[Some(color_attachment(target, None, wgpu::LoadOp::Load, wgpu::StoreOp::Store))],
            depth_stencil_attachment: None,
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        });
        if !self.overlays.begin(&mut pass) {
            return;
        }
        for (number, pane) in self.prepared.panes.iter().enumerate() {
            if let Some(([x, y], [width, height])) = pane.scissor(part) {
                pass.set_scissor_rect(x, y, width, height);
                draw(&mut pass, number, pane);
            }
        }
    }
}

impl PreparedPane {
    /// What a part shows of it, from the part's corner: corner and size; none where that is nothing.
    fn scissor(&self, part: Part) -> Option<([u32; 2], [u32; 2])> {
        let shown = part.within(self.corner, self.corner + self.extent);
        let corner = [shown.low[0] - part.low[0], shown.low[1] - part.low[1]];
        (!shown.is_empty()).then_some((corner, shown.size))
    }
}

/// Whether the lines of a pane are drawn once, those behind the walls of its quadrics first: half the work, where there are many.
fn is_sorted(pane: &Pane) -> bool {
    !pane.quadrics.is_empty() && pane.quadrics.iter().all(|pair| !pair.hollow)
}

/// Begins a pass that surfaces are drawn in, onto this colour or onto what is there.
fn surfaces_pass<'a>(
    encoder: &'a mut wgpu::CommandEncoder,
    target: &wgpu::TextureView,
    depths: &wgpu::TextureView,
    clear: Option<wgpu::Color>,
) -> wgpu::RenderPass<'a> {
    let load = clear.map_or(wgpu::LoadOp::Load, wgpu::LoadOp::Clear);
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("surfaces"),
        color_attachments: &[Some(color_attachment(target, None, load, wgpu::StoreOp::Store))],
        depth_stencil_attachment: Some(depth_attachment(depths, clear.is_some(), wgpu::StoreOp::Store)),
        timestamp_writes: None,
        occlusion_query_set: None,
        multiview_mask: None,
    })
}

fn clear_color(frame: &Frame) -> wgpu::Color {
    if frame.transparent {
        return wgpu::Color::TRANSPARENT;
    }
    let [r, g, b, _] = frame.background.0.map(f64::from);
    wgpu::Color { r, g, b, a: 1.0 }
}
