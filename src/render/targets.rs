//! The textures that are drawn into.

/// The format of what is drawn into: 8 bits a channel that hold sRGB values, blended as they are. (Blending in linear light
/// took half as long again with no GPU, and a transparent picture then looked another on a slide.)
pub const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// Samples a pixel of solids. All else knows how much of a pixel it covers.
pub(super) const SAMPLES: u32 = 4;
/// Reversed depth: 1 at the near plane, 0 at infinity, for which f32 is nearly uniform in precision.
pub(super) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// A texture to be drawn into and then read.
pub(super) fn target(
    device: &wgpu::Device,
    label: &'static str,
    size: [u32; 2],
    format: wgpu::TextureFormat,
    sample_count: u32,
    is_read: bool,
) -> wgpu::TextureView {
    let read = if is_read { wgpu::TextureUsages::TEXTURE_BINDING } else { wgpu::TextureUsages::empty() };
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: extent(size),
        mip_level_count: 1,
        sample_count,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | read,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

/// Width and height as wgpu wants them.
pub(super) fn extent([width, height]: [u32; 2]) -> wgpu::Extent3d {
    wgpu::Extent3d { width, height, depth_or_array_layers: 1 }
}

/// A colour attachment.
pub(super) fn color_attachment<'a>(
    view: &'a wgpu::TextureView,
    resolve_target: Option<&'a wgpu::TextureView>,
    load: wgpu::LoadOp<wgpu::Color>,
    store: wgpu::StoreOp,
) -> wgpu::RenderPassColorAttachment<'a> {
    wgpu::RenderPassColorAttachment { view, depth_slice: None, resolve_target, ops: wgpu::Operations { load, store } }
}

/// A depth attachment, at first all far away where it is not loaded.
pub(super) fn depth_attachment(
    view: &wgpu::TextureView,
    is_new: bool,
    store: wgpu::StoreOp,
) -> wgpu::RenderPassDepthStencilAttachment<'_> {
    let load = if is_new { wgpu::LoadOp::Clear(0.0) } else { wgpu::LoadOp::Load };
    wgpu::RenderPassDepthStencilAttachment {
        view,
        depth_ops: Some(wgpu::Operations { load, store }),
        stencil_ops: None,
    }
}
