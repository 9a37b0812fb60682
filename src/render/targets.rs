//! The textures that are drawn into before they are resolved.

/// The format of what is drawn into: 8 bits a channel that hold sRGB values, blended as they are. (Blending in linear light
/// took half as long again with no GPU, and a transparent picture then looked another on a slide.)
pub const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// Samples a pixel.
pub(super) const SAMPLES: u32 = 4;
/// Reversed depth: 1 at the near plane, 0 at infinity, for which f32 is nearly uniform in precision.
pub(super) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

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
