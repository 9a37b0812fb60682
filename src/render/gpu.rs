//! Finding an adapter and opening a device on it.

use std::sync::{Arc, Mutex, PoisonError};

/// What to install where no driver is found.
const INSTALL: &str = "install a driver, on Debian or Ubuntu: apt-get install libvulkan1 mesa-vulkan-drivers";

/// Why nothing can be drawn on this machine.
#[derive(Debug, thiserror::Error)]
pub enum GpuError {
    /// No adapter at all.
    #[error("no graphics adapter was found ({0}); {INSTALL}")]
    NoAdapter(String),
    /// No adapter of the asked name.
    #[error("no adapter's name contains '{wanted}'; there is: {found}")]
    NoSuchAdapter {
        /// The asked name.
        wanted: String,
        /// The names there are.
        found: String,
    },
    /// The adapter gave no device.
    #[error("the adapter {adapter} could not be opened: {cause}")]
    Device {
        /// Its name.
        adapter: String,
        /// What the driver said.
        cause: wgpu::RequestDeviceError,
    },
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
    /// Vulkan, OpenGL, Metal or Direct3D 12.
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
        let backend = match info.backend {
            wgpu::Backend::Vulkan => "Vulkan",
            wgpu::Backend::Gl => "OpenGL",
            wgpu::Backend::Metal => "Metal",
            wgpu::Backend::Dx12 => "Direct3D 12",
            _ => "other",
        };
        let driver = [info.driver.trim(), info.driver_info.trim()].join(" ").trim().to_owned();
        Self { name: info.name.clone(), kind, backend, driver }
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

/// What to say on a machine with no adapter at all.
#[must_use]
pub fn no_adapter() -> String {
    GpuError::NoAdapter("no driver".to_owned()).to_string()
}

/// Every adapter of this machine.
#[must_use]
pub fn adapters() -> Vec<AdapterDescription> {
    backend_rounds()
        .into_iter()
        .flat_map(|backends| pollster::block_on(instance(backends).enumerate_adapters(backends)))
        .map(|adapter| AdapterDescription::new(&adapter.get_info()))
        .collect()
}

impl Gpu {
    /// A device for drawing with no window: the adapter whose name contains `name` (any case), or the best one.
    ///
    /// # Errors
    /// No adapter, none of that name, or one that cannot be opened.
    pub fn headless(name: Option<&str>) -> Result<Self, GpuError> {
        let mut cause = String::from("no backend");
        let mut found = vec![];
        for backends in backend_rounds() {
            let instance = instance(backends);
            match choose(&instance, backends, None, name) {
                Ok(adapter) => return Self::open(adapter),
                Err(GpuError::NoSuchAdapter { found: names, .. }) => found.push(names),
                Err(GpuError::NoAdapter(why)) => cause = why,
                Err(other) => return Err(other),
            }
        }
        match name {
            Some(wanted) if !found.is_empty() => {
                Err(GpuError::NoSuchAdapter { wanted: wanted.to_owned(), found: found.join(", ") })
            }
            _ => Err(GpuError::NoAdapter(cause)),
        }
    }

    /// A device that can present to this surface.
    ///
    /// # Errors
    /// As [`Gpu::headless`].
    pub fn for_surface(
        instance: &wgpu::Instance,
        surface: &wgpu::Surface<'_>,
        name: Option<&str>,
    ) -> Result<Self, GpuError> {
        Self::open(choose(instance, wgpu::Backends::all(), Some(surface), name)?)
    }

    fn open(adapter: wgpu::Adapter) -> Result<Self, GpuError> {
        let descriptor = wgpu::DeviceDescriptor {
            label: None,
            required_features: wgpu::Features::empty(),
            required_limits: wgpu::Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits()),
            experimental_features: wgpu::ExperimentalFeatures::disabled(),
            memory_hints: wgpu::MemoryHints::MemoryUsage,
            trace: wgpu::Trace::Off,
        };
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))
            .map_err(|cause| GpuError::Device { adapter: adapter.get_info().name, cause })?;
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
        Ok(Self { adapter, device, queue, error })
    }

    /// What the adapter is.
    #[must_use]
    pub fn description(&self) -> AdapterDescription {
        AdapterDescription::new(&self.adapter.get_info())
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

fn choose(
    instance: &wgpu::Instance,
    backends: wgpu::Backends,
    surface: Option<&wgpu::Surface<'_>>,
    name: Option<&str>,
) -> Result<wgpu::Adapter, GpuError> {
    let Some(name) = name else {
        let options = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            compatible_surface: surface,
            ..Default::default()
        };
        return pollster::block_on(instance.request_adapter(&options))
            .map_err(|cause| GpuError::NoAdapter(cause.to_string()));
    };
    let wanted = name.to_lowercase();
    let mut found = vec![];
    for adapter in pollster::block_on(instance.enumerate_adapters(backends)) {
        if surface.is_some_and(|surface| !adapter.is_surface_supported(surface)) {
            continue;
        }
        let info = adapter.get_info();
        if info.name.to_lowercase().contains(&wanted) {
            return Ok(adapter);
        }
        found.push(info.name);
    }
    if found.is_empty() {
        return Err(GpuError::NoAdapter(String::from("no backend offers one")));
    }
    Err(GpuError::NoSuchAdapter { wanted: name.to_owned(), found: found.join(", ") })
}
