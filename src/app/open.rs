//! The window while it is open: its events, its panels, its screen.

use std::path::Path;
use std::sync::Arc;

use egui_winit::accesskit_winit;
use web_time::Duration;
use winit::dpi::{LogicalSize, PhysicalSize};
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, EventLoopProxy};
use winit::window::{Fullscreen, Window, WindowAttributes};

use super::clipboard::Clipboard;
use super::files;
use super::mapping::Mapping;
use super::{Wake, WindowError, WindowOptions};
use crate::render::{GpuError, adapters};
use crate::session::{Remembered, Session};
use crate::stage::{self, Around, Presented, SMALLEST, Stage};
use crate::ui::{Command, Panels};

/// What the bars of a desktop and the frame of a window take of a monitor (points).
const BARS: f64 = 80.0;

/// Size (points) of a window where nothing is known of the monitor, and the share of each side of one that a first window takes.
const USUAL: [f64; 2] = [1280.0, 720.0];
const FIRST_SHARE: f64 = 0.8;

/// What desktops call the program.
#[cfg(all(unix, not(target_vendor = "apple")))]
const NAME: &str = "dzhanibekov";

/// An open window.
pub(super) struct OpenWindow {
    // Dropped first: it lives on the window.
    stage: Stage,
    instance: wgpu::Instance,
    egui: egui_winit::State,
    clipboard: Option<Clipboard>,
    window: Arc<Window>,
    is_occluded: bool,
    is_unmapped: bool,
    mapping: Option<Mapping>,
    title: String,
}

/// What came of a frame.
pub(super) struct Drawn {
    /// What the user asked for.
    pub(super) commands: Vec<Command>,
    /// When the panels want to be drawn again; never where there is none.
    pub(super) repaint_after: Option<Duration>,
    /// Whether the frame came onto the screen.
    pub(super) is_shown: bool,
    /// How long the panels took, the picture, and presenting both.
    pub(super) spent: [Duration; 3],
}

impl OpenWindow {
    pub(super) fn new(
        event_loop: &ActiveEventLoop,
        options: &WindowOptions,
        remembered: &Remembered,
        proxy: &EventLoopProxy<Wake>,
        session: &Session,
    ) -> Result<Self, WindowError> {
        let title = stage::title(session);
        // Hidden until there is something to see; the screen reader's part also wants it so.
        let smallest = LogicalSize::new(SMALLEST[0], SMALLEST[1]);
        let attributes =
            Window::default_attributes().with_title(&title).with_min_inner_size(smallest).with_visible(false);
        let attributes = if let Some([width, height]) = options.size {
            attributes.with_inner_size(PhysicalSize::new(width, height))
        } else {
            let size = within_monitor(event_loop, remembered.size);
            attributes.with_inner_size(size).with_maximized(remembered.maximized)
        };
        let attributes = named(attributes);
        let window = event_loop.create_window(attributes).map_err(|error| WindowError::Display(error.to_string()))?;
        let window = Arc::new(window);
        let (instance, stage) = open_stage(&window, event_loop, options, proxy)?;
        let clipboard = Clipboard::open(event_loop);
        let mut egui = events(&stage, &window, clipboard.is_none());
        egui.init_accesskit(event_loop, &window, proxy.clone());
        window.set_visible(true);
        let mapping = Mapping::of(&window);
        Ok(Self { stage, instance, egui, clipboard, window, is_occluded: false, is_unmapped: false, mapping, title })
    }

    /// The window with everything on the device made anew.
    pub(super) fn recovered(
        self,
        event_loop: &ActiveEventLoop,
        options: &WindowOptions,
        proxy: &EventLoopProxy<Wake>,
    ) -> Result<Self, WindowError> {
        let Self { stage, mut egui, clipboard, window, is_occluded, is_unmapped, mapping, title, .. } = self;
        // A window holds one surface at a time.
        drop(stage);
        let (instance, stage) = open_stage(&window, event_loop, options, proxy)?;
        let access = egui.accesskit.take();
        // The panels' textures are gone with the device: those of a new stage are sent again.
        egui = events(&stage, &window, clipboard.is_none());
        egui.accesskit = access;
        Ok(Self { stage, instance, egui, clipboard, window, is_occluded, is_unmapped, mapping, title })
    }

    /// Takes the device away, as a driver might.
    pub(super) fn lose_device(&self) {
        self.stage.lose_device();
    }

    pub(super) fn is_lost(&self) -> bool {
        self.stage.is_lost()
    }

    /// Whether drawing can be seen at all.
    pub(super) fn is_visible(&self) -> bool {
        let size = self.window.inner_size();
        !self.is_occluded && !self.is_unmapped && size.width > 0 && size.height > 0
    }

    /// Looks whether the window is on the screen at all, where no event tells.
    pub(super) fn look_around(&mut self) {
        self.is_unmapped = self.mapping.as_ref().is_some_and(|mapping| !mapping.is_mapped());
    }

    /// Of the monitor that the window is on (millihertz).
    pub(super) fn refresh_rate(&self) -> Option<u32> {
        self.window.current_monitor()?.refresh_rate_millihertz()
    }

    pub(super) fn request_redraw(&self) {
        self.window.request_redraw();
    }

    pub(super) fn toggle_fullscreen(&self) {
        let fullscreen = self.window.fullscreen().is_none().then_some(Fullscreen::Borderless(None));
        self.window.set_fullscreen(fullscreen);
    }

    /// Takes an event; true where it asks for a frame.
    pub(super) fn on_event(&mut self, event: &WindowEvent) -> bool {
        let response = self.egui.on_window_event(&self.window, event);
        match event {
            WindowEvent::Resized(size) => {
                self.stage.resize(size.width, size.height);
                true
            }
            WindowEvent::Occluded(is_occluded) => {
                self.is_occluded = *is_occluded;
                true
            }
            WindowEvent::RedrawRequested => false,
            _ => response.repaint,
        }
    }

    /// Takes what a screen reader asks for.
    pub(super) fn on_access(&mut self, event: accesskit_winit::WindowEvent) {
        match event {
            accesskit_winit::WindowEvent::InitialTreeRequested => self.egui.egui_ctx().enable_accesskit(),
            accesskit_winit::WindowEvent::ActionRequested(request) => self.egui.on_accesskit_action_request(request),
            accesskit_winit::WindowEvent::AccessibilityDeactivated => self.egui.egui_ctx().disable_accesskit(),
        }
    }

    /// Shows the panels, redraws the picture where it changed, presents both.
    pub(super) fn draw(
        &mut self,
        event_loop: &ActiveEventLoop,
        session: &mut Session,
        panels: &mut Panels,
        real_time_factor: Option<f64>,
    ) -> Drawn {
        let title = stage::title(session);
        if title != self.title {
            self.window.set_title(&title);
            self.title = title;
        }
        self.scale_text(session.text_size(), session.is_presenting());
        let mut input = self.egui.take_egui_input(&self.window);
        if let Some(clipboard) = &mut self.clipboard {
            clipboard.translate(&mut input);
        }
        let fullscreen = self.window.fullscreen().is_some();
        let around = Around { title: &self.title, real_time_factor, fullscreen };
        let window = &self.window;
        let mut drawn = self.stage.draw(input, session, panels, around, || window.pre_present_notify());
        if let Some(clipboard) = &mut self.clipboard {
            clipboard.take(&mut drawn.platform);
        }
        self.egui.handle_platform_output_with_event_loop(&self.window, event_loop, drawn.platform);
        if drawn.presented == Presented::SurfaceLost
            && let Ok(surface) = self.instance.create_surface(Arc::clone(&self.window))
        {
            self.stage.replace_surface(surface);
        }
        Drawn {
            commands: drawn.commands,
            repaint_after: drawn.repaint_after,
            is_shown: drawn.presented == Presented::Shown,
            spent: drawn.spent,
        }
    }

    /// Legible from the last row at any resolution.
    fn scale_text(&self, text_size: f32, presenting: bool) {
        let size = self.window.inner_size().to_logical::<f32>(self.window.scale_factor());
        self.stage.context().set_zoom_factor(stage::zoom(size.width, size.height, text_size, presenting));
    }

    /// Writes the picture as it is, as large as the window; says where.
    pub(super) fn write_picture(&mut self, session: &Session, transparent: bool) -> Result<String, String> {
        let bytes = self.stage.begin_picture(session, transparent).wait(&self.stage)?;
        let path = files::write_new(session.title(), "png", &bytes)?;
        Ok(format!("Written to {}", path.display()))
    }

    /// Writes the scene's pages, each to a new file; says where.
    pub(super) fn write_handout(&mut self, session: &Session) -> Result<String, String> {
        let mut last = None;
        let pages = self.stage.begin_pages(session)?;
        for (number, page) in pages.iter().enumerate() {
            let bytes = page.wait(&self.stage)?;
            last = Some(files::write_new(&format!("{} page {}", session.title(), number + 1), "png", &bytes)?);
        }
        let place = last.ok_or("There is no page to write.")?;
        Ok(format!("{} pages, the last one: {}", pages.len(), place.display()))
    }

    /// Puts a text on the clipboard.
    ///
    /// # Errors
    /// Why the desktop does not take it.
    pub(super) fn copy(&mut self, text: String) -> Result<(), String> {
        if let Some(clipboard) = &mut self.clipboard {
            return clipboard.copy(text);
        }
        self.egui.set_clipboard_text(text);
        Ok(())
    }

    /// Notes the window's size for the next time.
    pub(super) fn remember(&self, remembered: &mut Remembered) {
        remembered.maximized = self.window.is_maximized();
        if !remembered.maximized && self.window.fullscreen().is_none() {
            let size = self.window.inner_size().to_logical::<f64>(self.window.scale_factor());
            remembered.size = Some([size.width, size.height]);
        }
    }
}

/// Opens a device that draws into the window. OpenGL is slow to load, and where the kernel knows no graphics card it would draw on the
/// processor too: there it is tried only where nothing else draws.
fn open_stage(
    window: &Arc<Window>,
    event_loop: &ActiveEventLoop,
    options: &WindowOptions,
    proxy: &EventLoopProxy<Wake>,
) -> Result<(wgpu::Instance, Stage), WindowError> {
    let open = |backends| open_stage_by(backends, window, event_loop, options, proxy);
    let all = wgpu::Backends::all();
    let is_chosen = wgpu::Backends::from_env().is_some();
    if is_chosen || may_have_cards() {
        return open(all);
    }
    open(all - wgpu::Backends::GL).or_else(|_| open(all))
}

/// Whether the kernel may know a graphics card: Linux shows each as a file.
fn may_have_cards() -> bool {
    const PLACES: [&str; 3] = ["/dev/dri", "/dev/nvidiactl", "/dev/dxg"];
    !cfg!(target_os = "linux") || PLACES.iter().any(|place| Path::new(place).exists())
}

/// The same by some backends, or by those that the environment names.
fn open_stage_by(
    backends: wgpu::Backends,
    window: &Arc<Window>,
    event_loop: &ActiveEventLoop,
    options: &WindowOptions,
    proxy: &EventLoopProxy<Wake>,
) -> Result<(wgpu::Instance, Stage), WindowError> {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = backends;
    descriptor.display = Some(Box::new(event_loop.owned_display_handle()));
    let instance = wgpu::Instance::new(descriptor.with_env());
    let surface = instance.create_surface(Arc::clone(window)).map_err(|error| {
        // Without a driver there is nothing to make one by, and the window system is not to blame.
        let has_none = pollster::block_on(adapters()).is_empty();
        if has_none { GpuError::NoAdapter.into() } else { WindowError::Display(error.to_string()) }
    })?;
    let proxy = proxy.clone();
    let on_lost = move || {
        // The loop may have ended: then there is nothing to recover.
        let _ = proxy.send_event(Wake::DeviceLost);
    };
    let size = window.inner_size();
    let size = (size.width, size.height);
    let stage = pollster::block_on(Stage::open(&instance, surface, options.adapter.as_deref(), size, on_lost))?;
    Ok((instance, stage))
}

/// What turns the window's events into the panels', the keys that copy and paste only where it `has_clipboard`.
fn events(stage: &Stage, window: &Window, has_clipboard: bool) -> egui_winit::State {
    let scale = window.scale_factor() as f32;
    let side = Some(stage.gpu().largest_side() as usize);
    let mut state =
        egui_winit::State::new(stage.context().clone(), egui::ViewportId::ROOT, window, Some(scale), None, side);
    state.set_clipboard_shortcuts(has_clipboard);
    state
}

/// A size (points) that fits the monitor a window will most likely open on.
fn within_monitor(event_loop: &ActiveEventLoop, remembered: Option<[f64; 2]>) -> LogicalSize<f64> {
    let monitor = event_loop.primary_monitor().or_else(|| event_loop.available_monitors().next());
    let Some(monitor) = monitor.filter(|monitor| monitor.size().width > 0) else {
        let [width, height] = remembered.unwrap_or(USUAL);
        return LogicalSize::new(width, height);
    };
    let room = monitor.size().to_logical::<f64>(monitor.scale_factor());
    // The first time it is large enough to be seen and small enough to leave the desktop in sight.
    let share = [FIRST_SHARE * room.width, FIRST_SHARE * room.height];
    let [width, height] = remembered.unwrap_or([share[0].max(USUAL[0]), share[1].max(USUAL[1])]);
    LogicalSize::new(width.min(room.width - BARS), height.min(room.height - BARS))
}

/// The name by which desktops know the program's windows.
#[cfg(all(unix, not(target_vendor = "apple")))]
fn named(attributes: WindowAttributes) -> WindowAttributes {
    use winit::platform::{wayland, x11};
    let attributes = x11::WindowAttributesExtX11::with_name(attributes, NAME, NAME);
    wayland::WindowAttributesExtWayland::with_name(attributes, NAME, NAME)
}

/// Elsewhere a program's file is its name.
#[cfg(not(all(unix, not(target_vendor = "apple"))))]
fn named(attributes: WindowAttributes) -> WindowAttributes {
    attributes
}
