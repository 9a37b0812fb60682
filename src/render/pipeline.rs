//! The one place where pipelines are described.

use super::gpu::Gpu;
use super::targets::DEPTH_FORMAT;

/// What the shaders of surfaces begin with.
const PANE_SOURCE: &str = include_str!("../../shaders/pane.wgsl");

/// Makes shader modules and pipelines of one device.
pub(super) struct PipelineMaker<'a> {
    pub(super) gpu: &'a Gpu,
    pub(super) pane_layout: &'a wgpu::BindGroupLayout,
}

/// What one pipeline differs in from another.
#[derive(Clone)]
pub(super) struct Recipe<'a> {
    pub(super) label: &'static str,
    pub(super) module: &'a wgpu::ShaderModule,
    /// The entry of its fragments; that of its vertices is `vertex`.
    pub(super) fragment: &'static str,
    pub(super) buffer: Option<wgpu::VertexBufferLayout<'a>>,
    /// The layouts of the bind groups.
    pub(super) groups: &'a [&'a wgpu::BindGroupLayout],
    pub(super) cull: Option<wgpu::Face>,
    /// Which depths are drawn, seen from the buffer's (nearer is greater), and whether its own is left there; none where there
    /// is no such buffer.
    pub(super) depth: Option<(wgpu::CompareFunction, bool)>,
    pub(super) samples: u32,
    /// What is drawn to, pictures where it is not said, blended into it unless the shader's values replace what is there.
    pub(super) format: Option<wgpu::TextureFormat>,
    pub(super) blend: Option<wgpu::BlendState>,
    /// Only depths are left.
    pub(super) is_colourless: bool,
    /// Values of the shader's constants.
    pub(super) constants: &'a [(&'a str, f64)],
}

impl<'a> Recipe<'a> {
    /// Blended over what is drawn, in one sample a pixel, with no depth.
    pub(super) fn new(label: &'static str, module: &'a wgpu::ShaderModule) -> Self {
        Self {
            label,
            module,
            fragment: "fragment",
            buffer: None,
            groups: &[],
            cull: None,
            depth: None,
            samples: 1,
            format: None,
            blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
            is_colourless: false,
            constants: &[],
        }
    }

    /// Makes it.
    pub(super) fn pipeline(&self, gpu: &Gpu) -> wgpu::RenderPipeline {
        let device = &gpu.device;
        let format = self.format.unwrap_or(gpu.format());
        let groups: Vec<_> = self.groups.iter().copied().map(Some).collect();
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(self.label),
            bind_group_layouts: &groups,
            immediate_size: 0,
        });
        let compilation_options = wgpu::PipelineCompilationOptions { constants: self.constants, ..Default::default() };
        let buffers: Vec<_> = self.buffer.iter().cloned().map(Some).collect();
        let write_mask = if self.is_colourless { wgpu::ColorWrites::empty() } else { wgpu::ColorWrites::ALL };
        device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(self.label),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: self.module,
                entry_point: Some("vertex"),
                compilation_options: compilation_options.clone(),
                buffers: &buffers,
            },
            primitive: wgpu::PrimitiveState { cull_mode: self.cull, ..Default::default() },
            depth_stencil: self.depth.map(|(compare, writes)| wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(writes),
                depth_compare: Some(compare),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState { count: self.samples, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module: self.module,
                entry_point: Some(self.fragment),
                compilation_options,
                targets: &[Some(wgpu::ColorTargetState { format, blend: self.blend, write_mask })],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

impl PipelineMaker<'_> {
    /// A shader after what all shaders of surfaces begin with.
    pub(super) fn module(&self, label: &'static str, source: &str) -> wgpu::ShaderModule {
        self.gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(label),
            source: wgpu::ShaderSource::Wgsl([PANE_SOURCE, source].concat().into()),
        })
    }
}

/// A pipeline that is made when it is first wanted: where there is no GPU each costs as much as a frame, and few pictures
/// show everything.
#[derive(Default)]
pub(super) struct Lazy(Option<wgpu::RenderPipeline>);

impl Lazy {
    /// Makes it, where it is wanted and not there yet.
    pub(super) fn want(&mut self, is_wanted: bool, make: impl FnOnce() -> wgpu::RenderPipeline) {
        if is_wanted {
            self.0.get_or_insert_with(make);
        }
    }

    /// Makes it the one that the next draws use; false where it was never wanted.
    pub(super) fn set(&self, pass: &mut wgpu::RenderPass<'_>) -> bool {
        if let Some(pipeline) = &self.0 {
            pass.set_pipeline(pipeline);
        }
        self.0.is_some()
    }
}
