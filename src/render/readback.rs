//! A picture that is drawn to no window, and how it comes back from the device.

use std::sync::{Arc, OnceLock};

use super::gpu::{Gpu, GpuError};
use super::part::{Part, rows_of_band};
use super::targets::extent;

/// A texture to draw into and to read back from: a picture at a time.
pub struct Canvas {
    texture: wgpu::Texture,
    view: wgpu::TextureView,
    staging: wgpu::Buffer,
    size: [u32; 2],
    /// How many rows the texture has: the picture's, or those of one of its bands.
    rows: u32,
}

/// A picture on its way back from the device.
#[derive(Debug)]
pub struct Reading {
    submission: wgpu::SubmissionIndex,
    /// Filled by the device when the picture has arrived or cannot.
    arrived: Arc<OnceLock<Result<(), wgpu::BufferAsyncError>>>,
}

/// A picture in memory: sRGB bytes, red, green, blue, opacity, by rows from the top; premultiplied where it
/// was drawn transparent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pixels {
    /// Width and height.
    pub size: [u32; 2],
    /// Four bytes a pixel.
    pub rgba: Vec<u8>,
}

impl Reading {
    /// Waits for it, and for nothing drawn after it.
    fn wait(&self, gpu: &Gpu) -> Result<(), GpuError> {
        let submission_index = Some(self.submission.clone());
        let polled = gpu.device.poll(wgpu::PollType::Wait { submission_index, timeout: None });
        if self.has_arrived(gpu)? {
            return Ok(());
        }
        let cause = polled.err().map_or_else(|| "the picture did not come back".to_owned(), |cause| cause.to_string());
        Err(GpuError::Drawing(cause))
    }

    /// Whether the picture has arrived.
    fn has_arrived(&self, gpu: &Gpu) -> Result<bool, GpuError> {
        gpu.check()?;
        match self.arrived.get() {
            None => Ok(false),
            Some(Err(cause)) => Err(GpuError::Drawing(cause.to_string())),
            Some(Ok(())) => Ok(true),
        }
    }
}

impl Canvas {
    /// The most pixels of a picture, whatever its shape, that the device gives back in one piece.
    #[must_use]
    pub fn most_pixels(gpu: &Gpu) -> u64 {
        gpu.device.limits().max_buffer_size / 4
    }

    /// Whether a picture of this size can be drawn: within [`Gpu::largest_side`] and in one piece.
    #[must_use]
    pub fn fits(gpu: &Gpu, [width, height]: [u32; 2]) -> bool {
        width.max(height) <= gpu.largest_side()
            && u64::from(row_bytes(width)) * u64::from(height) <= gpu.device.limits().max_buffer_size
    }

    /// A canvas of this width and height, which must be such that it [fits](Self::fits), for frames that are drawn band by band.
    #[must_use]
    pub fn new(gpu: &Gpu, size: [u32; 2]) -> Self {
        Self::with_rows(gpu, size, rows_of_band(size))
    }

    /// One that is drawn at once, whatever draws on it.
    #[must_use]
    pub fn whole(gpu: &Gpu, size: [u32; 2]) -> Self {
        Self::with_rows(gpu, size, size[1])
    }

    fn with_rows(gpu: &Gpu, size: [u32; 2], rows: u32) -> Self {
        let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("canvas"),
            size: extent([size[0], rows]),
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: gpu.format(),
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let staging = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("canvas read-back"),
            size: u64::from(row_bytes(size[0])) * u64::from(size[1]),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        Self { texture, view, staging, size, rows }
    }

    /// What a renderer draws into.
    #[must_use]
    pub fn view(&self) -> &wgpu::TextureView {
        &self.view
    }

    /// Width and height.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// The parts of the picture that are drawn one after the other.
    pub(super) fn bands(&self) -> impl Iterator<Item = Part> + use<> {
        let ([width, height], rows) = (self.size, self.rows);
        (0..height).step_by(rows.max(1) as usize).map(move |top| Part { low: [0, top], size: [width, rows] })
    }

    /// Waits for the drawing and copies the picture out; not in a browser, where nothing may wait.
    ///
    /// # Errors
    /// What the device has reported since the last call.
    pub fn read(&self, gpu: &Gpu) -> Result<Pixels, GpuError> {
        let reading = self.begin_read(gpu);
        self.finish_read(gpu, &reading)
    }

    /// Asks for what was drawn so far at once, without waiting: the device goes on while another canvas is prepared.
    #[must_use]
    pub fn begin_read(&self, gpu: &Gpu) -> Reading {
        self.ask(self.take_band(gpu, 0))
    }

    /// Has the band that was drawn copied to its place, `top` rows from the picture's first.
    pub(super) fn take_band(&self, gpu: &Gpu, top: u32) -> wgpu::SubmissionIndex {
        let [width, height] = self.size;
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_texture_to_buffer(
            self.texture.as_image_copy(),
            wgpu::TexelCopyBufferInfo {
                buffer: &self.staging,
                layout: wgpu::TexelCopyBufferLayout {
                    offset: u64::from(row_bytes(width)) * u64::from(top),
                    bytes_per_row: Some(row_bytes(width)),
                    rows_per_image: None,
                },
            },
            extent([width, self.rows.min(height - top)]),
        );
        gpu.queue.submit([encoder.finish()])
    }

    /// Asks for the picture, of which this was the last to be submitted.
    pub(super) fn ask(&self, submission: wgpu::SubmissionIndex) -> Reading {
        let arrived = Arc::new(OnceLock::new());
        let slot = Arc::clone(&arrived);
        self.staging.map_async(wgpu::MapMode::Read, .., move |outcome| {
            // It is called once.
            let _ = slot.set(outcome);
        });
        Reading { submission, arrived }
    }

    /// The picture that [`Self::begin_read`] asked for, where it has arrived; asked once a frame, it waits for nothing.
    ///
    /// # Errors
    /// What the device has reported since the last call.
    pub fn try_read(&self, gpu: &Gpu, reading: &Reading) -> Result<Option<Pixels>, GpuError> {
        if reading.has_arrived(gpu)? { self.copied_out(gpu, vec![]).map(Some) } else { Ok(None) }
    }

    /// Waits for the picture that [`Self::begin_read`] asked for, and for nothing drawn after it.
    ///
    /// # Errors
    /// What the device has reported since the last call.
    pub fn finish_read(&self, gpu: &Gpu, reading: &Reading) -> Result<Pixels, GpuError> {
        self.finish_read_into(gpu, reading, vec![])
    }

    /// As [`Self::finish_read`], into memory that was used before: fresh memory costs the kernel's time.
    ///
    /// # Errors
    /// What the device has reported since the last call.
    pub fn finish_read_into(&self, gpu: &Gpu, reading: &Reading, memory: Vec<u8>) -> Result<Pixels, GpuError> {
        reading.wait(gpu)?;
        self.copied_out(gpu, memory)
    }

    /// Waits for the picture that [`Self::begin_read`] asked for, and hands over so many of its rows as they lie in memory, in the device's
    /// format.
    ///
    /// # Errors
    /// What the device has reported since the last call, or what `take` returns.
    pub(super) fn finish_rows<E: From<GpuError>>(
        &self,
        gpu: &Gpu,
        reading: &Reading,
        rows: u32,
        mut take: impl FnMut(&[u8]) -> Result<(), E>,
    ) -> Result<(), E> {
        reading.wait(gpu)?;
        let bytes = self.staging.get_mapped_range(..).map_err(|cause| GpuError::Drawing(cause.to_string()))?;
        let width = self.size[0];
        let mut rows = bytes.chunks_exact(row_bytes(width) as usize).take(rows as usize);
        let outcome = rows.try_for_each(|row| take(&row[..4 * width as usize]));
        drop(bytes);
        self.staging.unmap();
        outcome
    }

    /// The picture, which has arrived.
    fn copied_out(&self, gpu: &Gpu, mut rgba: Vec<u8>) -> Result<Pixels, GpuError> {
        let [width, height] = self.size;
        let rows = self.staging.get_mapped_range(..).map_err(|cause| GpuError::Drawing(cause.to_string()))?;
        rgba.clear();
        rgba.reserve_exact(4 * width as usize * height as usize);
        for row in rows.chunks_exact(row_bytes(width) as usize) {
            rgba.extend_from_slice(&row[..4 * width as usize]);
        }
        drop(rows);
        self.staging.unmap();
        if gpu.is_blue_first() {
            rgba.chunks_exact_mut(4).for_each(|pixel| pixel.swap(0, 2));
        }
        Ok(Pixels { size: self.size, rgba })
    }
}

/// Bytes of a row in a buffer that a texture is copied to.
fn row_bytes(width: u32) -> u32 {
    (4 * width).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT)
}
