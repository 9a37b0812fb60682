//! The surface that frames are drawn to and presented by.

use super::StageError;
use crate::render::Gpu;

/// A surface with its configuration.
#[derive(Debug)]
pub(super) struct Surface {
    inner: wgpu::Surface<'static>,
    config: wgpu::SurfaceConfiguration,
    /// Faults since the last frame that was had.
    faults: u32,
}

/// What came of asking for a frame.
#[derive(Debug)]
pub(super) enum Acquired {
    /// Draw to this and present it.
    Frame {
        /// The frame.
        texture: wgpu::SurfaceTexture,
        /// Configure anew after presenting.
        is_suboptimal: bool,
    },
    /// Nothing to draw to: try again at the next occasion.
    Skip,
    /// Nothing yet, but what was wrong has been mended: try again at once.
    Again,
    /// Nothing yet: the surface is gone, and whoever owns the screen must give another one.
    Lost,
    /// No frame is to be had from this device any more.
    Gone,
}

/// Faults in a row after which mending the surface is given up.
const MOST_FAULTS: u32 = 5;

impl Surface {
    /// Fits a surface to this size (pixels).
    pub(super) fn new(surface: wgpu::Surface<'static>, gpu: &Gpu, size: (u32, u32)) -> Result<Self, StageError> {
        let refused = || StageError::Surface(gpu.description().name);
        let most = gpu.largest_side();
        let mut config = surface
            .get_default_config(&gpu.adapter, size.0.clamp(1, most), size.1.clamp(1, most))
            .ok_or_else(refused)?;
        let formats = surface.get_capabilities(&gpu.adapter).formats;
        // The panels blend in encoded values: a format that encodes by itself would blend them wrongly.
        let plain = [wgpu::TextureFormat::Bgra8Unorm, wgpu::TextureFormat::Rgba8Unorm];
        if let Some(format) = plain.into_iter().find(|format| formats.contains(format)) {
            config.format = format;
        }
        // Where there is no GPU a frame is a copy of pixels that are kept.
        let usages = surface.get_capabilities(&gpu.adapter).usages;
        if gpu.is_software() && plain.contains(&config.format) && usages.contains(wgpu::TextureUsages::COPY_DST) {
            config.usage |= wgpu::TextureUsages::COPY_DST;
        }
        config.present_mode = wgpu::PresentMode::AutoVsync;
        config.desired_maximum_frame_latency = 1;
        surface.configure(&gpu.device, &config);
        Ok(Self { inner: surface, config, faults: 0 })
    }

    /// Whether frames are made by copying to them.
    pub(super) fn takes_copies(&self) -> bool {
        self.config.usage.contains(wgpu::TextureUsages::COPY_DST)
    }

    /// Format of the frames.
    pub(super) fn format(&self) -> wgpu::TextureFormat {
        self.config.format
    }

    /// Width and height in pixels.
    pub(super) fn size(&self) -> (u32, u32) {
        (self.config.width, self.config.height)
    }

    /// Takes another surface of the same screen.
    pub(super) fn replace(&mut self, surface: wgpu::Surface<'static>, gpu: &Gpu) {
        self.inner = surface;
        self.configure(gpu);
    }

    /// Follows the screen's size; a size of 0 (minimised) is left alone.
    pub(super) fn resize(&mut self, gpu: &Gpu, width: u32, height: u32) {
        let most = gpu.largest_side();
        let (width, height) = (width.min(most), height.min(most));
        if width > 0 && height > 0 && (width, height) != self.size() {
            self.config.width = width;
            self.config.height = height;
            self.configure(gpu);
        }
    }

    /// Configures anew.
    pub(super) fn configure(&self, gpu: &Gpu) {
        self.inner.configure(&gpu.device, &self.config);
    }

    /// The next frame.
    pub(super) fn acquire(&mut self, gpu: &Gpu) -> Acquired {
        use wgpu::CurrentSurfaceTexture as Current;
        let current = self.inner.get_current_texture();
        match current {
            Current::Success(_) | Current::Suboptimal(_) => self.faults = 0,
            // A device that is gone shows itself as one of these, again and again.
            Current::Outdated | Current::Lost | Current::Validation => self.faults += 1,
            Current::Timeout | Current::Occluded => {}
        }
        if self.faults > MOST_FAULTS {
            return Acquired::Gone;
        }
        match current {
            Current::Success(texture) => Acquired::Frame { texture, is_suboptimal: false },
            // To be presented all the same: dropped, it would come back for ever.
            Current::Suboptimal(texture) => Acquired::Frame { texture, is_suboptimal: true },
            Current::Outdated => {
                self.configure(gpu);
                Acquired::Again
            }
            Current::Lost => Acquired::Lost,
            Current::Validation => {
                gpu.queue.submit([]);
                Acquired::Again
            }
            Current::Timeout | Current::Occluded => {
                // Uploads that wait for a submission would pile up.
                gpu.queue.submit([]);
                Acquired::Skip
            }
        }
    }
}
