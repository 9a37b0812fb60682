//! From samples to pixels by a shader of our own, where the processor draws: Mesa's software driver compiles its own anew
//! in every process (35 ms), ours comes from its cache, and is done only where anything was drawn.

use glam::Vec2;

use super::buffer::FrameBuffer;
use super::targets::{FORMAT, SAMPLES};
use super::transfer::Transfer;

/// Averages the samples of a multisampled texture.
pub(super) struct Resolve {
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
    corners: FrameBuffer,
    /// How many corners.
    count: u32,
}

impl Resolve {
    pub(super) fn new(device: &wgpu::Device) -> Self {
        // The shader adds up four.
        const { assert!(SAMPLES == 4) };
        let transfer = Transfer {
            label: "resolve",
            source: wgpu::include_wgsl!("../../shaders/resolve.wgsl"),
            multisampled: true,
            buffers: &[Some(wgpu::VertexBufferLayout {
                array_stride: size_of::<Vec2>() as u64,
                step_mode: wgpu::VertexStepMode::Vertex,
                attributes: &wgpu::vertex_attr_array![0 => Float32x2],
            })],
            constants: &[],
            format: FORMAT,
        };
        let (pipeline, layout) = transfer.pipeline(device);
        Self { pipeline, layout, corners: FrameBuffer::new("resolved parts", wgpu::BufferUsages::VERTEX), count: 0 }
    }

    /// Notes the parts of a picture of this size that are to be resolved: low and high corners (pixels).
    pub(super) fn upload(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, parts: &[[Vec2; 2]], picture: Vec2) {
        let ndc = |pixel: Vec2| (pixel / picture * 2.0 - 1.0) * Vec2::new(1.0, -1.0);
        let corners: Vec<Vec2> = parts
            .iter()
            .flat_map(|[low, high]| {
                let [a, b, c, d] = [*low, Vec2::new(high.x, low.y), *high, Vec2::new(low.x, high.y)].map(ndc);
                [a, b, c, a, c, d]
            })
            .collect();
        self.count = corners.len() as u32;
        self.corners.write(device, queue, bytemuck::cast_slice(&corners));
    }

    /// Takes the samples' means to `target`, of the same size; what is not resolved gets this colour.
    pub(super) fn draw(
        &self,
        device: &wgpu::Device,
        encoder: &mut wgpu::CommandEncoder,
        samples: &wgpu::TextureView,
        target: &wgpu::TextureView,
        ground: wgpu::Color,
    ) {
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("samples"),
            layout: &self.layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(samples) }],
        });
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("resolve"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: target,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load: wgpu::LoadOp::Clear(ground), store: wgpu::StoreOp::Store },
            })],
            depth_stencil_attachment: None,
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        });
        let Some(corners) = self.corners.get().filter(|_| self.count > 0) else { return };
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &group, &[]);
        pass.set_vertex_buffer(0, corners.slice(..));
        pass.draw(0..self.count, 0..1);
    }
}
