//! Which adapter is tried next: a GPU before the processor, and another one where one cannot be opened.

use super::gpu::GpuError;

/// What is known of an adapter before it is opened, and the adapter.
#[derive(Debug)]
struct Candidate<A> {
    info: wgpu::AdapterInfo,
    adapter: A,
}

/// The adapters found so far and not yet tried, and those that could not be opened.
#[derive(Debug)]
pub(super) struct Attempts<A> {
    /// A part of the name that is asked for, in small letters.
    wanted: Option<String>,
    left: Vec<Candidate<A>>,
    /// Of all that were found, those not asked for too.
    names: Vec<String>,
    /// What could not be opened, and why.
    failed: Vec<String>,
}

impl<A> Attempts<A> {
    /// None yet, of those whose name contains `wanted` (any case).
    pub(super) fn new(wanted: Option<&str>) -> Self {
        Self { wanted: wanted.map(str::to_lowercase), left: vec![], names: vec![], failed: vec![] }
    }

    /// Adds adapters that were found, those that are not asked for left aside.
    pub(super) fn add(&mut self, found: impl IntoIterator<Item = (wgpu::AdapterInfo, A)>) {
        for (info, adapter) in found {
            self.names.push(info.name.clone());
            if self.wanted.as_deref().is_none_or(|wanted| info.name.to_lowercase().contains(wanted)) {
                self.left.push(Candidate { info, adapter });
            }
        }
    }

    /// The best of those not yet tried; of equals the one found first. Where a GPU could not be opened and more may be found,
    /// none that draws on the processor: the same GPU may be reached by another way.
    pub(super) fn next(&mut self, more_to_come: bool) -> Option<(wgpu::AdapterInfo, A)> {
        let (place, best) = self.left.iter().enumerate().min_by_key(|(_, candidate)| rank(&candidate.info))?;
        let is_last_resort = best.info.device_type == wgpu::DeviceType::Cpu;
        if is_last_resort && more_to_come && !self.failed.is_empty() {
            return None;
        }
        let Candidate { info, adapter } = self.left.remove(place);
        Some((info, adapter))
    }

    /// Notes that one could not be opened.
    pub(super) fn note_failure(&mut self, info: &wgpu::AdapterInfo, cause: &str) {
        self.failed.push(format!("{} by {} ({cause})", info.name, backend_name(info.backend)));
    }

    /// What is worth saying once of the one that was opened: what was passed over for it, and that it is the processor
    /// where nobody asked for that.
    pub(super) fn remark(&self, opened: &wgpu::AdapterInfo) -> Option<String> {
        let is_processor = opened.device_type == wgpu::DeviceType::Cpu;
        let drawn_on = if is_processor { "drawing on the processor" } else { "drawing on another adapter" };
        let drawn_on = format!("{drawn_on} ({})", opened.name);
        if !self.failed.is_empty() {
            return Some(format!("{drawn_on}, since no better one could be opened: {}", self.failed.join("; ")));
        }
        (is_processor && self.wanted.is_none()).then(|| format!("{drawn_on}: no GPU was found"))
    }

    /// Why none was opened.
    pub(super) fn error(self) -> GpuError {
        match self.wanted {
            _ if !self.failed.is_empty() => GpuError::NoneOpens(self.failed.join("; ")),
            Some(wanted) if !self.names.is_empty() => GpuError::NoSuchAdapter { wanted, found: self.names.join(", ") },
            _ => GpuError::NoAdapter,
        }
    }
}

/// The place of an adapter among others, the best first: by what it is, and of equals OpenGL last.
fn rank(info: &wgpu::AdapterInfo) -> (u8, bool) {
    let kind = match info.device_type {
        wgpu::DeviceType::DiscreteGpu => 0,
        wgpu::DeviceType::IntegratedGpu => 1,
        wgpu::DeviceType::Other => 2,
        wgpu::DeviceType::VirtualGpu => 3,
        wgpu::DeviceType::Cpu => 4,
    };
    (kind, info.backend == wgpu::Backend::Gl)
}

/// What people call a backend.
pub(super) fn backend_name(backend: wgpu::Backend) -> &'static str {
    match backend {
        wgpu::Backend::Vulkan => "Vulkan",
        wgpu::Backend::Gl => "OpenGL",
        wgpu::Backend::Metal => "Metal",
        wgpu::Backend::Dx12 => "Direct3D 12",
        wgpu::Backend::BrowserWebGpu => "WebGPU",
        wgpu::Backend::Noop => "nothing",
    }
}

#[cfg(test)]
mod tests {
    use super::Attempts;
    use wgpu::{AdapterInfo, Backend, DeviceType};

    const LOST: &str = "Parent device is lost";

    fn adapter(name: &str, kind: DeviceType, backend: Backend) -> (AdapterInfo, ()) {
        (AdapterInfo { name: name.to_owned(), ..AdapterInfo::new(kind, backend) }, ())
    }

    fn processor() -> (AdapterInfo, ()) {
        adapter("llvmpipe", DeviceType::Cpu, Backend::Vulkan)
    }

    /// What is opened of these, found in so many rounds, where those of this backend cannot be; and what is said of it.
    fn opened(
        wanted: Option<&str>,
        rounds: Vec<Vec<(AdapterInfo, ())>>,
        broken: &[Backend],
    ) -> Result<(String, Option<String>), String> {
        let mut attempts = Attempts::new(wanted);
        let mut to_come = rounds.len();
        for found in rounds {
            to_come -= 1;
            attempts.add(found);
            while let Some((info, ())) = attempts.next(to_come > 0) {
                if !broken.contains(&info.backend) {
                    return Ok((info.name.clone(), attempts.remark(&info)));
                }
                attempts.note_failure(&info, LOST);
            }
        }
        Err(attempts.error().to_string())
    }

    #[test]
    fn the_best_adapter_is_opened_and_the_processor_is_named() {
        let card = adapter("a card", DeviceType::DiscreteGpu, Backend::Vulkan);
        let chip = adapter("a chip", DeviceType::IntegratedGpu, Backend::Vulkan);
        let rounds = vec![vec![processor(), chip.clone(), card]];
        assert_eq!(opened(None, rounds, &[]), Ok(("a card".to_owned(), None)));
        // Of equals the one that was found first, but not by OpenGL.
        let old = adapter("by OpenGL", DeviceType::IntegratedGpu, Backend::Gl);
        assert_eq!(opened(None, vec![vec![old, chip]], &[]), Ok(("a chip".to_owned(), None)));
        let said = "drawing on the processor (llvmpipe): no GPU was found".to_owned();
        assert_eq!(opened(None, vec![vec![processor()], vec![]], &[]), Ok(("llvmpipe".to_owned(), Some(said))));
        // Whoever asks for it by name knows.
        assert_eq!(opened(Some("LLVM"), vec![vec![processor()], vec![]], &[]), Ok(("llvmpipe".to_owned(), None)));
    }

    #[test]
    fn where_one_cannot_be_opened_the_next_one_is_and_that_is_said() {
        let card = |backend| adapter("a card", DeviceType::DiscreteGpu, backend);
        let rounds = vec![vec![card(Backend::Dx12), processor()], vec![]];
        let said = "drawing on the processor (llvmpipe), since no better one could be opened: a card by Direct3D 12 (Parent device is lost)";
        let found = opened(None, rounds, &[Backend::Dx12]);
        assert_eq!(found, Ok(("llvmpipe".to_owned(), Some(said.to_owned()))));
        // A later round may still reach the GPU: it is waited for before the processor is taken.
        let rounds = vec![vec![card(Backend::Dx12), processor()], vec![card(Backend::Gl)]];
        let found = opened(None, rounds, &[Backend::Dx12]).map(|(name, _)| name);
        assert_eq!(found, Ok("a card".to_owned()));
        // One that is asked for is not replaced by one that is not.
        let rounds = vec![vec![card(Backend::Dx12), processor()], vec![]];
        let tried = "none of the graphics adapters could be opened: a card by Direct3D 12 (Parent device is lost)";
        assert_eq!(opened(Some("card"), rounds, &[Backend::Dx12]), Err(tried.to_owned()));
    }

    #[test]
    fn where_none_opens_all_that_were_tried_are_told() {
        let card = adapter("a card", DeviceType::DiscreteGpu, Backend::Dx12);
        let rounds = vec![vec![processor(), card.clone()], vec![]];
        let tried = "none of the graphics adapters could be opened: a card by Direct3D 12 (Parent device is lost); \
                     llvmpipe by Vulkan (Parent device is lost)";
        assert_eq!(opened(None, rounds, &[Backend::Dx12, Backend::Vulkan]), Err(tried.to_owned()));
        let missing = "no adapter's name contains 'nosuch'; there is: llvmpipe, a card";
        assert_eq!(opened(Some("nosuch"), vec![vec![processor(), card], vec![]], &[]), Err(missing.to_owned()));
        let none = opened(None, vec![vec![], vec![]], &[]).err().unwrap_or_default();
        assert!(none.starts_with("no graphics adapter was found; install a driver"), "{none}");
    }
}
