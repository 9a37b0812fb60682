//! Vertex and uniform buffers that grow with what is drawn.

/// A buffer on the device, written anew for every frame and replaced by a larger one when it must be.
pub(super) struct FrameBuffer {
    label: &'static str,
    usage: wgpu::BufferUsages,
    buffer: Option<wgpu::Buffer>,
}

impl FrameBuffer {
    pub(super) fn new(label: &'static str, usage: wgpu::BufferUsages) -> Self {
        Self { label, usage: usage | wgpu::BufferUsages::COPY_DST, buffer: None }
    }

    /// Writes the bytes; true where the buffer is another one than before.
    pub(super) fn write(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, bytes: &[u8]) -> bool {
        let size = bytes.len() as u64;
        if size == 0 {
            return false;
        }
        let fits = self.buffer.as_ref().is_some_and(|buffer| buffer.size() >= size);
        if !fits {
            self.buffer = Some(device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(self.label),
                size: size.next_power_of_two(),
                usage: self.usage,
                mapped_at_creation: false,
            }));
        }
        if let Some(buffer) = &self.buffer {
            queue.write_buffer(buffer, 0, bytes);
        }
        !fits
    }

    pub(super) fn get(&self) -> Option<&wgpu::Buffer> {
        self.buffer.as_ref()
    }
}

/// Quads. Every corner holds all that its quad is: drivers without a GPU spend far longer on an instance than on four corners.
pub(super) struct QuadBuffer {
    corners: FrameBuffer,
    indices: FrameBuffer,
    /// How many quads the indices hold.
    indexed: usize,
}

impl QuadBuffer {
    pub(super) fn new(label: &'static str) -> Self {
        Self {
            corners: FrameBuffer::new(label, wgpu::BufferUsages::VERTEX),
            indices: FrameBuffer::new("quad indices", wgpu::BufferUsages::INDEX),
            indexed: 0,
        }
    }

    /// Takes the corners of the quads, four after four.
    pub(super) fn write<T: bytemuck::Pod>(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, corners: &[T]) {
        self.corners.write(device, queue, bytemuck::cast_slice(corners));
        let quads = corners.len() / 4;
        if quads > self.indexed {
            self.indexed = quads.next_power_of_two();
            let indices: Vec<u32> =
                (0..self.indexed as u32).flat_map(|quad| [0, 1, 2, 2, 1, 3].map(|corner| 4 * quad + corner)).collect();
            self.indices.write(device, queue, bytemuck::cast_slice(&indices));
        }
    }

    /// Makes the quads those that the next draws draw; false where there are none.
    pub(super) fn bind(&self, pass: &mut wgpu::RenderPass<'_>) -> bool {
        let (Some(corners), Some(indices)) = (self.corners.get(), self.indices.get()) else { return false };
        pass.set_vertex_buffer(0, corners.slice(..));
        pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
        true
    }

    /// Draws the bound quads of these numbers.
    pub(super) fn draw(pass: &mut wgpu::RenderPass<'_>, quads: std::ops::Range<u32>) {
        pass.draw_indexed(6 * quads.start..6 * quads.end, 0, 0..1);
    }
}

/// Uniforms read one at a time through a dynamic offset.
pub(super) struct UniformBuffer {
    buffer: FrameBuffer,
    layout: wgpu::BindGroupLayout,
    group: Option<wgpu::BindGroup>,
    size: u64,
    stride: usize,
}

impl UniformBuffer {
    /// For values of this many bytes; a shader that declares a larger struct is refused with its pipeline.
    pub(super) fn new(device: &wgpu::Device, label: &'static str, size: usize) -> Self {
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some(label),
            entries: &[wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
                ty: wgpu::BindingType::Buffer {
                    ty: wgpu::BufferBindingType::Uniform,
                    has_dynamic_offset: true,
                    min_binding_size: std::num::NonZeroU64::new(size as u64),
                },
                count: None,
            }],
        });
        Self {
            buffer: FrameBuffer::new(label, wgpu::BufferUsages::UNIFORM),
            layout,
            group: None,
            size: size as u64,
            stride: stride(device, size),
        }
    }

    pub(super) fn layout(&self) -> &wgpu::BindGroupLayout {
        &self.layout
    }

    pub(super) fn write<T: bytemuck::Pod>(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, values: &[T]) {
        let mut bytes = vec![0; self.stride * values.len()];
        for (slot, value) in bytes.chunks_exact_mut(self.stride).zip(values) {
            let value = bytemuck::bytes_of(value);
            slot[..value.len()].copy_from_slice(value);
        }
        let replaced = self.buffer.write(device, queue, &bytes);
        let Some(buffer) = self.buffer.get().filter(|_| replaced || self.group.is_none()) else { return };
        self.group = Some(device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &self.layout,
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::Buffer(wgpu::BufferBinding {
                    buffer,
                    offset: 0,
                    size: std::num::NonZeroU64::new(self.size),
                }),
            }],
        }));
    }

    /// Binds the value of this number.
    pub(super) fn bind(&self, pass: &mut wgpu::RenderPass<'_>, group: u32, number: usize) {
        pass.set_bind_group(group, self.group.as_ref(), &[(self.stride * number) as u32]);
    }
}

/// Bytes from one uniform of this size to the next one in a buffer.
pub(super) fn stride(device: &wgpu::Device, size: usize) -> usize {
    size.next_multiple_of(device.limits().min_uniform_buffer_offset_alignment as usize)
}
