//! Solids are the one thing whose edges need several samples a pixel. They are drawn into a target of their own, no larger than
//! they are, and laid into the picture from there: to clear and average samples of a whole picture took most of a frame where
//! there is no GPU.

use bytemuck::{Pod, Zeroable};
use glam::Vec2;

use super::buffer::FrameBuffer;
use super::gpu::Gpu;
use super::part::Part;
use super::pipeline::Recipe;
use super::targets::{DEPTH_FORMAT, SAMPLES, color_attachment, depth_attachment, target};

/// Sides of the target are whole multiples of this (pixels), so that it serves the next frame too.
const STEP: u32 = 64;

/// What a corner of `shaders/solids.wgsl` reads.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct PlacedData {
    pub(super) ndc: Vec2,
    pub(super) shift: Vec2,
}

/// The solids of a pane: what they take of the picture, and from where on in the target.
#[derive(Clone, Copy, Debug)]
pub(super) struct Room {
    pub(super) pane: usize,
    pub(super) part: Part,
    pub(super) left: u32,
}

/// Lays solids into the picture.
pub(super) struct Solids {
    /// Whether the samples are read by a shader of our own: Mesa's software driver compiles its own anew in every process
    /// (35 ms), ours comes from its cache and takes the depths along. Not everywhere can samples be read.
    pub(super) reads_samples: bool,
    made: Option<(wgpu::RenderPipeline, wgpu::BindGroupLayout)>,
    targets: Option<Targets>,
    corners: FrameBuffer,
    /// How many corners of triangles are drawn.
    count: u32,
    rooms: Vec<Room>,
}

struct Targets {
    size: [u32; 2],
    color: wgpu::TextureView,
    depth: wgpu::TextureView,
    /// The means of the samples, where the device takes them.
    means: Option<wgpu::TextureView>,
    group: wgpu::BindGroup,
}

impl Solids {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let corners = FrameBuffer::new("places of solids", wgpu::BufferUsages::VERTEX);
        Self { reads_samples: gpu.is_software_vulkan(), made: None, targets: None, corners, count: 0, rooms: vec![] }
    }

    /// Makes room for the solids of panes, as parts of the part of a picture that is drawn, and for each the rectangles of it (low and
    /// high corners) that are laid into the picture.
    pub(super) fn make_room(
        &mut self,
        gpu: &Gpu,
        whole: Part,
        wanted: impl Iterator<Item = (usize, Part, Vec<[Vec2; 2]>)>,
    ) {
        let mut left = 0;
        let mut corners: Vec<PlacedData> = vec![];
        let ndc = |pixel: Vec2| ((pixel - whole.corner()) / whole.extent() * 2.0 - 1.0) * Vec2::new(1.0, -1.0);
        self.rooms.clear();
        for (pane, part, rectangles) in wanted.filter(|(_, part, _)| !part.is_empty()) {
            let shift = Vec2::new(left as f32, 0.0) - (part.corner() - whole.corner());
            corners.extend(rectangles.iter().flat_map(|&[low, high]| {
                let [a, b, c, d] = [low, Vec2::new(high.x, low.y), high, Vec2::new(low.x, high.y)].map(ndc);
                [a, b, c, a, c, d].map(|ndc| PlacedData { ndc, shift })
            }));
            self.rooms.push(Room { pane, part, left });
            left += part.size[0];
        }
        self.count = corners.len() as u32;
        let Some(highest) = self.rooms.iter().map(|room| room.part.size[1]).max() else { return };
        self.fit(gpu, [left, highest]);
        self.corners.write(&gpu.device, &gpu.queue, bytemuck::cast_slice(&corners));
    }

    /// Provides a target of at least this size and not of many times it.
    fn fit(&mut self, gpu: &Gpu, [width, height]: [u32; 2]) {
        let device = &gpu.device;
        let pixels = |[width, height]: [u32; 2]| u64::from(width) * u64::from(height);
        let size =
            [width, height].map(|side| side.next_multiple_of(STEP).min(device.limits().max_texture_dimension_2d));
        let fits = self.targets.as_ref().is_some_and(|targets| {
            targets.size[0] >= width && targets.size[1] >= height && 2 * pixels(targets.size) <= 3 * pixels(size)
        });
        if fits {
            return;
        }
        let is_read = self.reads_samples;
        let (_, layout) = self.made.get_or_insert_with(|| make(gpu, is_read));
        let color = target(device, "samples of solids", size, gpu.format(), SAMPLES, is_read);
        let depth = target(device, "depths of solids", size, DEPTH_FORMAT, SAMPLES, is_read);
        let means = (!is_read).then(|| target(device, "means of solids", size, gpu.format(), 1, true));
        let entry =
            |binding, view| wgpu::BindGroupEntry { binding, resource: wgpu::BindingResource::TextureView(view) };
        let entries = match &means {
            Some(means) => vec![entry(0, means)],
            None => vec![entry(0, &color), entry(1, &depth)],
        };
        let descriptor = wgpu::BindGroupDescriptor { label: Some("solids"), layout, entries: &entries };
        let group = device.create_bind_group(&descriptor);
        self.targets = Some(Targets { size, color, depth, means, group });
    }

    /// The solids of each pane.
    pub(super) fn rooms(&self) -> &[Room] {
        &self.rooms
    }

    /// Begins the pass that the solids are drawn in; none where there are none.
    pub(super) fn begin<'a>(&self, encoder: &'a mut wgpu::CommandEncoder) -> Option<wgpu::RenderPass<'a>> {
        let targets = self.targets.as_ref().filter(|_| !self.rooms.is_empty())?;
        let store = if self.reads_samples { wgpu::StoreOp::Store } else { wgpu::StoreOp::Discard };
        let clear = wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT);
        Some(encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("solids"),
            color_attachments: &[Some(color_attachment(&targets.color, targets.means.as_ref(), clear, store))],
            depth_stencil_attachment: Some(depth_attachment(&targets.depth, true, store)),
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        }))
    }

    /// Lets a pass draw on all of the target again.
    pub(super) fn cut_nothing(&self, pass: &mut wgpu::RenderPass<'_>) {
        if let Some(targets) = &self.targets {
            pass.set_scissor_rect(0, 0, targets.size[0], targets.size[1]);
        }
    }

    /// Lays them into the picture, with their depths where samples are read.
    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        let (Some((pipeline, _)), Some(targets), Some(corners)) = (&self.made, &self.targets, self.corners.get())
        else {
            return;
        };
        if !self.rooms.is_empty() {
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, &targets.group, &[]);
            pass.set_vertex_buffer(0, corners.slice(..));
            pass.draw(0..self.count, 0..1);
        }
    }
}

fn make(gpu: &Gpu, reads_samples: bool) -> (wgpu::RenderPipeline, wgpu::BindGroupLayout) {
    let device = &gpu.device;
    // The shader takes the mean of four.
    const { assert!(SAMPLES == 4) };
    let entry = |binding, sample_type| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty: wgpu::BindingType::Texture {
            sample_type,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: reads_samples,
        },
        count: None,
    };
    let colors = entry(0, wgpu::TextureSampleType::Float { filterable: false });
    let depths = entry(1, wgpu::TextureSampleType::Depth);
    let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("solids"),
        entries: &[colors, depths][..if reads_samples { 2 } else { 1 }],
    });
    let source = if reads_samples {
        concat!(include_str!("../../shaders/solids.wgsl"), include_str!("../../shaders/solids_of_samples.wgsl"))
    } else {
        concat!(include_str!("../../shaders/solids.wgsl"), include_str!("../../shaders/solids_of_pixels.wgsl"))
    };
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("solids"),
        source: wgpu::ShaderSource::Wgsl(source.into()),
    });
    let pipeline = Recipe {
        buffer: Some(wgpu::VertexBufferLayout {
            array_stride: size_of::<PlacedData>() as u64,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &wgpu::vertex_attr_array![0 => Float32x2, 1 => Float32x2],
        }),
        groups: &[&layout],
        depth: Some((wgpu::CompareFunction::Always, reads_samples)),
        ..Recipe::new("solids", &module)
    };
    let pipeline = pipeline.pipeline(gpu);
    (pipeline, layout)
}
