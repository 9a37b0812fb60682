//! From one texture to another of the same scale, by a shader that reads it pixel by pixel.

/// What one transfer differs in from another.
#[derive(Debug)]
pub(super) struct Transfer<'a> {
    /// Its name.
    pub(super) label: &'static str,
    /// The shader: the texture is at binding 0 of group 0, the entries are `vertex` and `fragment`.
    pub(super) source: wgpu::ShaderModuleDescriptor<'a>,
    /// Whether the texture has several samples a pixel.
    pub(super) multisampled: bool,
    /// What the vertices are, where they are any.
    pub(super) buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    /// Values of the shader's constants.
    pub(super) constants: &'a [(&'a str, f64)],
    /// What is drawn to.
    pub(super) format: wgpu::TextureFormat,
}

impl Transfer<'_> {
    /// Makes its pipeline, and the layout of its one bind group.
    pub(super) fn pipeline(self, device: &wgpu::Device) -> (wgpu::RenderPipeline, wgpu::BindGroupLayout) {
        let label = Some(self.label);
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label,
            entries: &[wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: wgpu::ShaderStages::FRAGMENT,
                ty: wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Float { filterable: false },
                    view_dimension: wgpu::TextureViewDimension::D2,
                    multisampled: self.multisampled,
                },
                count: None,
            }],
        });
        let module = device.create_shader_module(self.source);
        let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label,
            bind_group_layouts: &[Some(&layout)],
            immediate_size: 0,
        });
        let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label,
            layout: Some(&pipeline_layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("vertex"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: self.buffers,
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("fragment"),
                compilation_options: wgpu::PipelineCompilationOptions {
                    constants: self.constants,
                    ..Default::default()
                },
                targets: &[Some(self.format.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        (pipeline, layout)
    }
}
