//! Finding an adapter and opening a device on it.

use std::sync::{Arc, Mutex, PoisonError};

use super::attempts::{Attempts, backend_name};
use super::targets::FORMAT;

/// What to install where no driver is found.
const INSTALL: &str = "install a driver, on Debian or Ubuntu: apt-get install libvulkan1 mesa-vulkan-drivers";

/// Why nothing can be drawn on this machine.
#[derive(Debug, thiserror::Error)]
pub enum GpuError {
    /// No adapter at all.
    #[error("no graphics adapter was found; {INSTALL}")]
    NoAdapter,
    /// No adapter of the asked name.
    #[error("no adapter's name contains '{wanted}'; there is: {found}")]
    NoSuchAdapter {
        /// The asked name.
        wanted: String,
        /// The names there are.
        found: String,
    },
    /// Adapters, and none that gives a device: all that were tried, with what their drivers said.
    #[error("none of the graphics adapters could be opened: {0}")]
    NoneOpens(String),
    /// The device was lost, ran out of memory or reported an error while drawing.
    #[error("the graphics driver gave up drawing: {0}")]
    Drawing(String),
}

/// An adapter, in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AdapterDescription {
    /// Its name, to be chosen by.
    pub name: String,
    /// Discrete, integrated, virtual, or software (CPU).
    pub kind: &'static str,
    /// Vulkan, OpenGL, Metal, Direct3D 12 or WebGPU.
    pub backend: &'static str,
    /// The driver and its version.
    pub driver: String,
}

impl AdapterDescription {
    fn new(info: &wgpu::AdapterInfo) -> Self {
        let kind = match info.device_type {
            wgpu::DeviceType::DiscreteGpu => "discrete GPU",
            wgpu::DeviceType::IntegratedGpu => "integrated GPU",
            wgpu::DeviceType::VirtualGpu => "virtual GPU",
            wgpu::DeviceType::Cpu => "software (CPU)",
            wgpu::DeviceType::Other => "other",
        };
        let driver = [info.driver.trim(), info.driver_info.trim()].join(" ").trim().to_owned();
        Self { name: info.name.clone(), kind, backend: backend_name(info.backend), driver }
    }
}

/// An open device and its queue.
#[derive(Debug)]
pub struct Gpu {
    /// Where it was found.
    pub adapter: wgpu::Adapter,
    /// Makes pipelines, buffers and textures.
    pub device: wgpu::Device,
    /// Takes the work.
    pub queue: wgpu::Queue,
    /// What pictures are drawn in.
    format: wgpu::TextureFormat,
    remark: Option<String>,
    error: Arc<Mutex<Option<String>>>,
}

/// The backends in the order they are tried: OpenGL only where nothing newer is, since it is slow to load.
/// `WGPU_BACKEND` in the environment overrides both.
fn backend_rounds() -> Vec<wgpu::Backends> {
    wgpu::Backends::from_env().map_or_else(
        || vec![wgpu::Backends::VULKAN | wgpu::Backends::METAL | wgpu::Backends::DX12, wgpu::Backends::GL],
        |backends| vec![backends],
    )
}

fn instance(backends: wgpu::Backends) -> wgpu::Instance {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle_from_env();
    descriptor.backends = backends;
    wgpu::Instance::new(descriptor)
}

/// The adapters of some backends, those that can present to the surface where there is one.
#[cfg(not(target_arch = "wasm32"))]
async fn found(
    instance: &wgpu::Instance,
    backends: wgpu::Backends,
    surface: Option<&wgpu::Surface<'_>>,
) -> Vec<(wgpu::AdapterInfo, wgpu::Adapter)> {
    let adapters = instance.enumerate_adapters(backends).await.into_iter();
    let adapters = adapters.filter(|adapter| surface.is_none_or(|surface| adapter.is_surface_supported(surface)));
    adapters.map(|adapter| (adapter.get_info(), adapter)).collect()
}

/// The one adapter that a browser gives: it lists none, and WebGL's is had only by a surface.
#[cfg(target_arch = "wasm32")]
async fn found(
    instance: &wgpu::Instance,
    _: wgpu::Backends,
    surface: Option<&wgpu::Surface<'_>>,
) -> Vec<(wgpu::AdapterInfo, wgpu::Adapter)> {
    let options = wgpu::RequestAdapterOptions { compatible_surface: surface, ..Default::default() };
    let adapter = instance.request_adapter(&options).await.ok();
    adapter.map(|adapter| (adapter.get_info(), adapter)).into_iter().collect()
}

/// What to say on a machine with no adapter at all.
#[must_use]
pub fn no_adapter() -> String {
    GpuError::NoAdapter.to_string()
}

/// Every adapter of this machine.
pub async fn adapters() -> Vec<AdapterDescription> {
    let mut descriptions = vec![];
    for backends in backend_rounds() {
        let found = found(&instance(backends), backends, None).await;
        descriptions.extend(found.iter().map(|(info, _)| AdapterDescription::new(info)));
    }
    descriptions
}

impl Gpu {
    /// A device for drawing with no window, on an adapter whose name contains `name` (any case) or on any: a GPU before the
    /// processor, and the next one where one cannot be opened.
    ///
    /// # Errors
    /// No adapter, none of that name, or none that can be opened.
    pub async fn headless(name: Option<&str>) -> Result<Self, GpuError> {
        let mut attempts = Attempts::new(name);
        let rounds = backend_rounds();
        let last = rounds.len().saturating_sub(1);
        for (round, backends) in rounds.into_iter().enumerate() {
            attempts.add(found(&instance(backends), backends, None).await);
            if let Some(gpu) = Self::open_next(&mut attempts, round < last).await {
                return Ok(gpu);
            }
        }
        Err(attempts.error())
    }

    /// A device that can present to this surface, chosen likewise.
    ///
    /// # Errors
    /// As [`Gpu::headless`].
    pub async fn for_surface(
        instance: &wgpu::Instance,
        surface: &wgpu::Surface<'_>,
        name: Option<&str>,
    ) -> Result<Self, GpuError> {
        let mut attempts = Attempts::new(name);
        attempts.add(found(instance, wgpu::Backends::all(), Some(surface)).await);
        Self::open_next(&mut attempts, false).await.ok_or_else(|| attempts.error())
    }

    /// Tries one adapter after the other.
    async fn open_next(attempts: &mut Attempts<wgpu::Adapter>, more_to_come: bool) -> Option<Self> {
        while let Some((info, adapter)) = attempts.next(more_to_come) {
            match Self::open(adapter).await {
                Ok(gpu) => return Some(Self { remark: attempts.remark(&info), ..gpu }),
                Err(cause) => attempts.note_failure(&info, &one_line(&cause.to_string())),
            }
        }
        None
    }

    async fn open(adapter: wgpu::Adapter) -> Result<Self, wgpu::RequestDeviceError> {
        let descriptor = wgpu::DeviceDescriptor {
            label: None,
            required_features: wgpu::Features::empty(),
            required_limits: wgpu::Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits()),
            experimental_features: wgpu::ExperimentalFeatures::disabled(),
            memory_hints: wgpu::MemoryHints::MemoryUsage,
            trace: wgpu::Trace::Off,
        };
        let (device, queue) = adapter.request_device(&descriptor).await?;
        let error = Arc::new(Mutex::new(None));
        let slot = Arc::clone(&error);
        // Without a handler a driver's complaint would end the program; the first one is kept for the caller.
        device.on_uncaptured_error(Arc::new(move |complaint: wgpu::Error| {
            slot.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert_with(|| one_line(&complaint.to_string()));
        }));
        let slot = Arc::clone(&error);
        // A window sets its own. What fails after the loss only follows from it, so the loss is what is told.
        device.set_device_lost_callback(move |_, reason| {
            let reason = one_line(&reason);
            let separator = if reason.is_empty() { "" } else { ": " };
            let told = format!("the device was lost{separator}{reason}");
            *slot.lock().unwrap_or_else(PoisonError::into_inner) = Some(told);
        });
        Ok(Self { adapter, device, queue, format: FORMAT, remark: None, error })
    }

    /// What the adapter is.
    #[must_use]
    pub fn description(&self) -> AdapterDescription {
        AdapterDescription::new(&self.adapter.get_info())
    }

    /// The format that pictures are drawn in.
    #[must_use]
    pub fn format(&self) -> wgpu::TextureFormat {
        self.format
    }

    /// From now on pictures are drawn as a window is, so that they can be copied there as they are: in red, green, blue and
    /// opacity of a byte each in either order. What was made to draw with before draws no longer.
    pub fn draw_as(&mut self, format: wgpu::TextureFormat) {
        self.format = format;
    }

    /// Whether blue comes first in a pixel.
    pub(super) fn is_blue_first(&self) -> bool {
        self.format == wgpu::TextureFormat::Bgra8Unorm
    }

    /// What is worth saying once of how it was chosen: that the processor draws though nobody asked for it, or that others
    /// could not be opened.
    #[must_use]
    pub fn remark(&self) -> Option<&str> {
        self.remark.as_deref()
    }

    /// Whether it draws on the processor.
    #[must_use]
    pub fn is_software(&self) -> bool {
        self.adapter.get_info().device_type == wgpu::DeviceType::Cpu
    }

    /// Whether it draws on the processor by Vulkan, where textures with several samples can be read, as not everywhere.
    pub(super) fn is_software_vulkan(&self) -> bool {
        self.is_software() && self.adapter.get_info().backend == wgpu::Backend::Vulkan
    }

    /// The first error that the device has reported since the last call.
    ///
    /// # Errors
    /// That error.
    pub fn check(&self) -> Result<(), GpuError> {
        // That the device was lost is told only to who asks how it goes.
        let _ = self.device.poll(wgpu::PollType::Poll);
        let reported = self.error.lock().unwrap_or_else(PoisonError::into_inner).take();
        reported.map_or(Ok(()), |complaint| Err(GpuError::Drawing(complaint)))
    }

    /// The largest width or height of a picture.
    #[must_use]
    pub fn largest_side(&self) -> u32 {
        self.device.limits().max_texture_dimension_2d
    }
}

/// The driver's words without their line breaks.
fn one_line(words: &str) -> String {
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}
