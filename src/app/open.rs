//! The window while it is open: its events, its panels, its screen.

use std::sync::Arc;

use egui_winit::accesskit_winit;
use web_time::{Duration, Instant};
use winit::dpi::{LogicalSize, PhysicalSize};
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, EventLoopProxy};
use winit::window::{Fullscreen, Window, WindowAttributes};

use super::files;
use super::mapping::Mapping;
use super::screen::{Presented, Screen};
use super::stale::Shown;
use super::{Wake, WindowError, WindowOptions};
use crate::objects::PAGE;
use crate::render::{png, point_size};
use crate::session::{Remembered, Session};
use crate::ui::{Command, Panels, Pixels, keys, style};

/// Smallest size that still holds the panels (points).
const SMALLEST: LogicalSize<f32> = LogicalSize::new(640.0, 400.0);

/// What the bars of a desktop and the frame of a window take of a monitor (points).
const BARS: f64 = 80.0;

/// Size (points) of a window where nothing is known of the monitor, and the share of each side of one that a first window takes.
const USUAL: [f64; 2] = [1280.0, 720.0];
const FIRST_SHARE: f64 = 0.8;

/// What desktops call the program.
#[cfg(all(unix, not(target_vendor = "apple")))]
const NAME: &str = "dzhanibekov";

/// A wait for a repaint longer than this is one without end.
const LONG: Duration = Duration::from_mins(10);

/// How much larger than usual the panels are in a window of this size (points): they grow with the window, as what is
/// projected does, by the user's own factor too, and never past what leaves room for them. A presenter's words are as large a
/// part of any window.
pub(super) fn zoom(width: f32, height: f32, own: f32, presenting: bool) -> f32 {
    let power = if presenting { 1.0 } else { 0.7 };
    let grown = (width / 1280.0).min(height / 720.0).max(1.0).powf(power) * own;
    grown.min(width / SMALLEST.width).min(height / SMALLEST.height).max(0.4)
}

/// Pixels a point in a picture of this size (pixels), where the panels have `panels` of them: in a small picture the names
/// are smaller than the panels' text, so that they do not cover it.
pub(super) fn picture_point(panels: f32, (width, height): (u32, u32)) -> f32 {
    const MOST: f32 = 2.0;
    const LEAST: f32 = 0.6;
    panels.min(MOST * point_size([width, height])).max(LEAST * panels)
}

/// Where the picture lies in a window of this size (pixels), from what the panels left of it (points): its corner and
/// its size, which is 0 where there is no room.
pub(super) fn place(picture: egui::Rect, pixels_per_point: f32, window: (u32, u32)) -> ((u32, u32), (u32, u32)) {
    let pixel = |points: f32, most: u32| ((points * pixels_per_point).round().max(0.0) as u32).min(most);
    let corner = (pixel(picture.min.x, window.0), pixel(picture.min.y, window.1));
    let far = (pixel(picture.max.x, window.0), pixel(picture.max.y, window.1));
    (corner, (far.0.saturating_sub(corner.0), far.1.saturating_sub(corner.1)))
}

/// An open window.
pub(super) struct OpenWindow {
    // Dropped first: it lives on the window.
    screen: Screen,
    egui: egui_winit::State,
    window: Arc<Window>,
    is_occluded: bool,
    is_unmapped: bool,
    mapping: Option<Mapping>,
    theme: Option<crate::scene::Theme>,
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
        let title = title(session);
        // Hidden until there is something to see; the screen reader's part also wants it so.
        let attributes =
            Window::default_attributes().with_title(&title).with_min_inner_size(SMALLEST).with_visible(false);
        let attributes = if let Some([width, height]) = options.size {
            attributes.with_inner_size(PhysicalSize::new(width, height))
        } else {
            let size = within_monitor(event_loop, remembered.size);
            attributes.with_inner_size(size).with_maximized(remembered.maximized)
        };
        let attributes = named(attributes);
        let window = event_loop.create_window(attributes).map_err(|error| WindowError::Display(error.to_string()))?;
        let window = Arc::new(window);
        let context = egui::Context::default();
        style::install(&context);
        let scale = window.scale_factor() as f32;
        let mut egui = egui_winit::State::new(context, egui::ViewportId::ROOT, &*window, Some(scale), None, None);
        egui.init_accesskit(event_loop, &window, proxy.clone());
        let screen = open_screen(&window, event_loop, options, proxy)?;
        egui.set_max_texture_side(screen.gpu().largest_side() as usize);
        window.set_visible(true);
        let mapping = Mapping::of(&window);
        Ok(Self { screen, egui, window, is_occluded: false, is_unmapped: false, mapping, theme: None, title })
    }

    /// The window with everything on the device made anew.
    pub(super) fn recovered(
        self,
        event_loop: &ActiveEventLoop,
        options: &WindowOptions,
        proxy: &EventLoopProxy<Wake>,
    ) -> Result<Self, WindowError> {
        let Self { screen, mut egui, window, is_occluded, is_unmapped, mapping, title, .. } = self;
        // A window holds one surface at a time.
        drop(screen);
        let screen = open_screen(&window, event_loop, options, proxy)?;
        // The panels' textures are gone with the device: a new context sends them again.
        let context = egui::Context::default();
        style::install(&context);
        let scale = window.scale_factor() as f32;
        let side = Some(screen.gpu().largest_side() as usize);
        let access = egui.accesskit.take();
        egui = egui_winit::State::new(context, egui::ViewportId::ROOT, &*window, Some(scale), None, side);
        egui.accesskit = access;
        Ok(Self { screen, egui, window, is_occluded, is_unmapped, mapping, theme: None, title })
    }

    /// Takes the device away, as a driver might.
    pub(super) fn lose_device(&self) {
        self.screen.lose();
    }

    pub(super) fn is_lost(&self) -> bool {
        self.screen.is_lost()
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
                self.screen.resize(size.width, size.height);
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
        drawn: &mut Option<u64>,
    ) -> Drawn {
        let context = self.egui.egui_ctx().clone();
        let theme = session.theme();
        if self.theme != Some(theme) {
            style::set_theme(&context, theme);
            self.theme = Some(theme);
        }
        let title = title(session);
        if title != self.title {
            self.window.set_title(&title);
            self.title = title;
        }
        let began = Instant::now();
        self.scale_text(&context, session.text_size(), session.is_presenting());
        let fullscreen = self.window.fullscreen().is_some();
        let mut input = self.egui.take_egui_input(&self.window);
        let has_focus = context.memory(|memory| memory.focused().is_some());
        let mut commands = keys::take_commands(&mut input, has_focus);
        let mut picture = egui::Rect::NOTHING;
        let look = session.look(real_time_factor, fullscreen);
        let output = context.run_ui(input, |ui| {
            // What a screen reader calls the window.
            ui.ctx().accesskit_node_builder(egui::accesskit_root_id(), |node| node.set_label(&*self.title));
            let shown = panels.ui(ui, &look);
            commands.extend(shown.commands);
            picture = shown.picture;
        });
        self.egui.handle_platform_output_with_event_loop(&self.window, event_loop, output.platform_output);
        let repaint_after = output
            .viewport_output
            .get(&egui::ViewportId::ROOT)
            .map(|viewport| viewport.repaint_delay)
            .filter(|delay| *delay < LONG);

        let panels_done = Instant::now();
        let picture = self.draw_picture(session, picture, output.pixels_per_point, drawn);
        let picture_done = Instant::now();
        let shown = Shown {
            shapes: output.shapes,
            pixels_per_point: output.pixels_per_point,
            background: context.global_style().visuals.panel_fill,
            picture,
        };
        let presented = self.screen.present(&self.window, &context, shown, output.textures_delta);
        Drawn {
            commands,
            repaint_after: if presented == Presented::Again { Some(Duration::ZERO) } else { repaint_after },
            is_shown: presented == Presented::Shown,
            spent: [panels_done - began, picture_done - panels_done, picture_done.elapsed()],
        }
    }

    /// Legible from the last row at any resolution.
    fn scale_text(&self, context: &egui::Context, text_size: f32, presenting: bool) {
        let size = self.window.inner_size().to_logical::<f32>(self.window.scale_factor());
        context.set_zoom_factor(zoom(size.width, size.height, text_size, presenting));
    }

    /// Writes the picture as it is, as large as the window; says where.
    pub(super) fn write_picture(&mut self, session: &Session, transparent: bool) -> Result<String, String> {
        let (width, height) = self.screen.size();
        let aspect = width as f32 / height as f32;
        let mut frame = session.frame(aspect);
        frame.transparent = transparent;
        let pixels = self.screen.picture(&frame, [width, height])?;
        let bytes =
            png::encode(&pixels, transparent, &session.remarks([width, height])).map_err(|error| error.to_string())?;
        let path = files::write_new(session.title(), "png", &bytes)?;
        Ok(format!("Written to {}", path.display()))
    }

    /// Writes the scene's pages, each to a new file; says where.
    pub(super) fn write_handout(&mut self, session: &Session) -> Result<String, String> {
        let mut last = None;
        let frames = session.pages()?;
        for (number, frame) in frames.iter().enumerate() {
            let pixels = self.screen.picture(frame, PAGE)?;
            let bytes = png::encode(&pixels, false, &[]).map_err(|error| error.to_string())?;
            last = Some(files::write_new(&format!("{} page {}", session.title(), number + 1), "png", &bytes)?);
        }
        let place = last.ok_or("There is no page to write.")?;
        Ok(format!("{} pages, the last one: {}", frames.len(), place.display()))
    }

    /// Puts a text on the clipboard.
    pub(super) fn copy(&mut self, text: String) {
        self.egui.set_clipboard_text(text);
    }

    /// Notes the window's size for the next time.
    pub(super) fn remember(&self, remembered: &mut Remembered) {
        remembered.maximized = self.window.is_maximized();
        if !remembered.maximized && self.window.fullscreen().is_none() {
            let size = self.window.inner_size().to_logical::<f64>(self.window.scale_factor());
            remembered.size = Some([size.width, size.height]);
        }
    }

    /// Redraws the picture where something in it changed since the revision that was drawn. Gives its place in the window
    /// (pixels).
    fn draw_picture(
        &mut self,
        session: &mut Session,
        picture: egui::Rect,
        pixels_per_point: f32,
        drawn: &mut Option<u64>,
    ) -> egui::Rect {
        let (corner, size) = place(picture, pixels_per_point, self.screen.size());
        if size.0 == 0 || size.1 == 0 {
            return in_window(corner, size);
        }
        let pixels = Pixels::new(size.0 as f32, size.1 as f32);
        session.apply(Command::Resize(pixels), Instant::now());
        let is_new = self.screen.resize_picture(size);
        if is_new || *drawn != Some(session.revision()) {
            *drawn = Some(session.revision());
            self.screen.draw_picture(&session.frame(pixels.x / pixels.y), picture_point(pixels_per_point, size));
            session.set_names(self.screen.names());
        }
        in_window(corner, size)
    }
}

/// A place of this corner and size (pixels).
fn in_window(corner: (u32, u32), size: (u32, u32)) -> egui::Rect {
    let corner = egui::pos2(corner.0 as f32, corner.1 as f32);
    egui::Rect::from_min_size(corner, egui::vec2(size.0 as f32, size.1 as f32))
}

fn open_screen(
    window: &Arc<Window>,
    event_loop: &ActiveEventLoop,
    options: &WindowOptions,
    proxy: &EventLoopProxy<Wake>,
) -> Result<Screen, WindowError> {
    let proxy = proxy.clone();
    let on_lost = move || {
        // The loop may have ended: then there is nothing to recover.
        let _ = proxy.send_event(Wake::DeviceLost);
    };
    Screen::new(window, event_loop.owned_display_handle(), options.adapter.as_deref(), on_lost)
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

fn title(session: &Session) -> String {
    let title = session.title();
    if title.is_empty() { "Dzhanibekov".to_owned() } else { format!("{title} — Dzhanibekov") }
}
