//! The picture's own texture, and the copy of it into the window. The picture is redrawn only when something in it
//! changed; the panels around it come and go without it.

use super::gpu::Gpu;
use super::pipeline::Recipe;
use super::targets::extent;

/// The picture's texture and what copies it.
#[derive(Debug)]
pub(super) struct Compose {
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
    picture: Option<Picture>,
}

#[derive(Debug)]
struct Picture {
    size: (u32, u32),
    texture: wgpu::Texture,
    target: wgpu::TextureView,
    source: wgpu::BindGroup,
}

impl Compose {
    pub(super) fn new(gpu: &Gpu, window_format: wgpu::TextureFormat) -> Self {
        let device = &gpu.device;
        let label = Some("picture in window");
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label,
            entries: &[wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: wgpu::ShaderStages::FRAGMENT,
                ty: wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Float { filterable: false },
                    view_dimension: wgpu::TextureViewDimension::D2,
                    multisampled: false,
                },
                count: None,
            }],
        });
        let module = device.create_shader_module(wgpu::include_wgsl!("../../shaders/blit.wgsl"));
        let pipeline = Recipe {
            groups: &[&layout],
            format: Some(window_format),
            blend: None,
            constants: &[("decode", f64::from(u8::from(window_format.is_srgb())))],
            ..Recipe::new("picture in window", &module)
        }
        .pipeline(gpu);
        Self { pipeline, layout, picture: None }
    }

    /// Gives the picture this size; true where its content is thereby lost.
    pub(super) fn resize(&mut self, gpu: &Gpu, size: (u32, u32)) -> bool {
        if self.picture.as_ref().is_some_and(|picture| picture.size == size) {
            return false;
        }
        let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("picture"),
            size: wgpu::Extent3d { width: size.0, height: size.1, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: gpu.format(),
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT
                | wgpu::TextureUsages::TEXTURE_BINDING
                | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let target = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let source = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("picture in window"),
            layout: &self.layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&target) }],
        });
        self.picture = Some(Picture { size, texture, target, source });
        true
    }

    /// What the picture is drawn to, and its size.
    pub(super) fn target(&self) -> Option<(&wgpu::TextureView, (u32, u32))> {
        self.picture.as_ref().map(|picture| (&picture.target, picture.size))
    }

    /// Copies the part of the picture (pixels of the window: corner and size) that lies in it to a window of the picture's format;
    /// false where there is no picture at this corner and of at least that size.
    pub(super) fn copy(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        window: &wgpu::Texture,
        corner: [u32; 2],
        (low, size): ([u32; 2], [u32; 2]),
    ) -> bool {
        let Some(picture) = &self.picture else { return false };
        let [x, y] = [low[0].wrapping_sub(corner[0]), low[1].wrapping_sub(corner[1])];
        let fits = |at: u32, size: u32, whole: u32| at.checked_add(size).is_some_and(|end| end <= whole);
        if !fits(x, size[0], picture.size.0) || !fits(y, size[1], picture.size.1) {
            return false;
        }
        let at = |texture, [x, y]: [u32; 2]| wgpu::TexelCopyTextureInfo {
            texture,
            mip_level: 0,
            origin: wgpu::Origin3d { x, y, z: 0 },
            aspect: wgpu::TextureAspect::All,
        };
        encoder.copy_texture_to_texture(at(&picture.texture, [x, y]), at(window, low), extent(size));
        true
    }

    /// Copies the picture to its place, `corner` in pixels of the window.
    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, corner: (u32, u32), window: (u32, u32)) {
        let Some(picture) = &self.picture else { return };
        let (x, y) = corner;
        let (width, height) = picture.size;
        if x + width > window.0 || y + height > window.1 {
            return;
        }
        pass.set_viewport(x as f32, y as f32, width as f32, height as f32, 0.0, 1.0);
        pass.set_scissor_rect(x, y, width, height);
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &picture.source, &[]);
        pass.draw(0..3, 0..1);
    }
}
