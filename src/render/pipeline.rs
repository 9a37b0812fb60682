//! The one place where pipelines are described.

use super::targets::{DEPTH_FORMAT, FORMAT, SAMPLES};

/// What all shaders begin with.
const PANE_SOURCE: &str = include_str!("../../shaders/pane.wgsl");

/// Makes shader modules and pipelines of one device.
pub(super) struct PipelineMaker<'a> {
    pub(super) device: &'a wgpu::Device,
    pub(super) pane_layout: &'a wgpu::BindGroupLayout,
}

/// What one pipeline differs in from another.
pub(super) struct Recipe<'a> {
    pub(super) label: &'static str,
    pub(super) module: &'a wgpu::ShaderModule,
    pub(super) vertex: &'static str,
    pub(super) buffer: Option<wgpu::VertexBufferLayout<'a>>,
    /// The layout of bind group 1, after the pane's.
    pub(super) group: Option<&'a wgpu::BindGroupLayout>,
    pub(super) cull: Option<wgpu::Face>,
    /// Which depths are drawn, seen from the buffer's; nearer is greater.
    pub(super) depth: wgpu::CompareFunction,
    pub(super) writes_depth: bool,
}

impl PipelineMaker<'_> {
    /// Of quads laid over what is drawn: from the entry `vertex`, where the depth of the buffer allows.
    pub(super) fn overlay<T>(
        &self,
        label: &'static str,
        module: &wgpu::ShaderModule,
        attributes: &[wgpu::VertexAttribute],
        vertex: &'static str,
        depth: wgpu::CompareFunction,
    ) -> wgpu::RenderPipeline {
        let buffer = Some(wgpu::VertexBufferLayout {
            array_stride: size_of::<T>() as u64,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes,
        });
        self.pipeline(&Recipe { label, module, vertex, buffer, group: None, cull: None, depth, writes_depth: false })
    }

    pub(super) fn module(&self, label: &'static str, source: &str) -> wgpu::ShaderModule {
        self.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(label),
            source: wgpu::ShaderSource::Wgsl([PANE_SOURCE, source].concat().into()),
        })
    }

    pub(super) fn pipeline(&self, recipe: &Recipe<'_>) -> wgpu::RenderPipeline {
        let groups: Vec<_> = [Some(self.pane_layout), recipe.group].into_iter().take_while(Option::is_some).collect();
        let layout = self.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some(recipe.label),
            bind_group_layouts: &groups,
            immediate_size: 0,
        });
        let buffers: Vec<_> = recipe.buffer.iter().cloned().map(Some).collect();
        self.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(recipe.label),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: recipe.module,
                entry_point: Some(recipe.vertex),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &buffers,
            },
            primitive: wgpu::PrimitiveState { cull_mode: recipe.cull, ..Default::default() },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(recipe.writes_depth),
                depth_compare: Some(recipe.depth),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState { count: SAMPLES, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module: recipe.module,
                entry_point: Some("fragment"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(wgpu::ColorTargetState {
                    format: FORMAT,
                    blend: Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
                    write_mask: wgpu::ColorWrites::ALL,
                })],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}
