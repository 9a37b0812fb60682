//! The textures that are drawn into before they are resolved.

use super::pipeline::{DEPTH_FORMAT, SAMPLES};
use super::renderer::FORMAT;

/// The multisampled colours and depths of one size.
pub(super) struct Targets {
    pub(super) size: [u32; 2],
    pub(super) color: wgpu::TextureView,
    pub(super) depth: wgpu::TextureView,
}

impl Targets {
    /// Of this width and height; the samples can be read by a shader where that is wanted.
    pub(super) fn new(device: &wgpu::Device, size: [u32; 2], are_read: bool) -> Self {
        let attachment = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let read = if are_read { wgpu::TextureUsages::TEXTURE_BINDING } else { wgpu::TextureUsages::empty() };
        let view = |format, usage, label| {
            device
                .create_texture(&wgpu::TextureDescriptor {
                    label: Some(label),
                    size: extent(size),
                    mip_level_count: 1,
                    sample_count: SAMPLES,
                    dimension: wgpu::TextureDimension::D2,
                    format,
                    usage,
                    view_formats: &[],
                })
                .create_view(&wgpu::TextureViewDescriptor::default())
        };
        Self {
            size,
            color: view(FORMAT, attachment | read, "colours"),
            depth: view(DEPTH_FORMAT, attachment, "depths"),
        }
    }
}

/// Width and height as wgpu wants them.
pub(super) fn extent([width, height]: [u32; 2]) -> wgpu::Extent3d {
    wgpu::Extent3d { width, height, depth_or_array_layers: 1 }
}
