//! What window and page do alike: the session's panels and its picture on a surface, whoever owns the screen behind it.
//!
//! Events go in as egui's own, commands come out; what only a window or a page can do is left to them.

mod fit;
mod kept_pixels;
mod offscreen;
mod pacing;
mod screen;
mod stale;
mod surface;

use web_time::{Duration, Instant};

pub use fit::{SMALLEST, zoom, zoom_on_page};
pub use offscreen::with_panels;
pub use pacing::Pacer;
pub use screen::Presented;

use crate::frame::Frame;
use crate::render::{Canvas, Gpu, GpuError, Pixels as Picture, Reading, png};
use crate::scene::Theme;
use crate::session::{PAGE, Session};
use crate::ui::{Command, Panels, Pixels, keys, style};
use fit::{picture_point, place};
use screen::Screen;
use stale::Shown;

/// A wait for a repaint longer than this is one without end.
const LONG: Duration = Duration::from_mins(10);

/// Why there is nothing to draw on.
#[derive(Debug, thiserror::Error)]
pub enum StageError {
    /// Nothing to draw with.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The adapter, by its name, cannot draw to the surface.
    #[error("the adapter {0} cannot draw to this surface")]
    Surface(String),
}

/// The panels and the picture on a surface, with everything that lives on the graphics device: made anew as a whole where
/// that is lost.
pub struct Stage {
    screen: Screen,
    context: egui::Context,
    theme: Option<Theme>,
    /// The revision that the picture shows.
    drawn: Option<u64>,
    /// Where it is (points).
    picture: egui::Rect,
}

/// What the panels are told besides the session.
#[derive(Clone, Copy, Debug)]
pub struct Around<'a> {
    /// What a screen reader calls the whole.
    pub title: &'a str,
    /// Simulated seconds a real second, as measured while playing.
    pub real_time_factor: Option<f64>,
    /// Whether the screen is filled.
    pub fullscreen: bool,
}

/// What came of a frame.
pub struct Drawn {
    /// What the user asked for.
    pub commands: Vec<Command>,
    /// What the panels ask of the system: the pointer's form, the clipboard, the tree for screen readers.
    pub platform: egui::PlatformOutput,
    /// When the panels want to be drawn again; never where there is none.
    pub repaint_after: Option<Duration>,
    /// What came of presenting it.
    pub presented: Presented,
    /// How long the panels took, the picture, and presenting both.
    pub spent: [Duration; 3],
}

/// A picture that is on its way back from the device.
pub struct Pending {
    canvas: Canvas,
    reading: Reading,
    transparent: bool,
    /// What the file says of its scene.
    remarks: Vec<(&'static str, String)>,
}

impl Stage {
    /// Opens a device for a surface of this size (pixels); `on_lost` is called where that device is gone.
    ///
    /// # Errors
    /// No adapter for it, or none that can draw to it.
    pub async fn open(
        instance: &wgpu::Instance,
        surface: wgpu::Surface<'static>,
        adapter: Option<&str>,
        size: (u32, u32),
        on_lost: impl Fn() + Send + 'static,
    ) -> Result<Self, StageError> {
        let screen = Screen::open(instance, surface, adapter, size, on_lost).await?;
        let context = egui::Context::default();
        style::install(&context);
        Ok(Self { screen, context, theme: None, drawn: None, picture: egui::Rect::NOTHING })
    }

    /// The panels' own state, which whoever feeds events needs.
    #[must_use]
    pub fn context(&self) -> &egui::Context {
        &self.context
    }

    /// The device.
    #[must_use]
    pub fn gpu(&self) -> &Gpu {
        self.screen.gpu()
    }

    /// Takes the device away, as a driver might.
    pub fn lose_device(&self) {
        self.screen.lose();
    }

    /// Whether the device is gone and everything on it.
    #[must_use]
    pub fn is_lost(&self) -> bool {
        self.screen.is_lost()
    }

    /// Takes another surface of the same screen.
    pub fn replace_surface(&mut self, surface: wgpu::Surface<'static>) {
        self.screen.replace_surface(surface);
    }

    /// Width and height in pixels.
    #[must_use]
    pub fn size(&self) -> (u32, u32) {
        self.screen.size()
    }

    /// Where the picture is (points).
    #[must_use]
    pub fn picture(&self) -> egui::Rect {
        self.picture
    }

    /// Follows the screen's size (pixels).
    pub fn resize(&mut self, width: u32, height: u32) {
        self.screen.resize(width, height);
    }

    /// Shows the panels, redraws the picture where it changed, presents both; `before_presenting` is called right before
    /// that.
    pub fn draw(
        &mut self,
        mut input: egui::RawInput,
        session: &mut Session,
        panels: &mut Panels,
        around: Around<'_>,
        before_presenting: impl FnOnce(),
    ) -> Drawn {
        let context = self.context.clone();
        let theme = session.theme();
        if self.theme != Some(theme) {
            style::set_theme(&context, theme);
            self.theme = Some(theme);
        }
        let began = Instant::now();
        let has_focus = context.memory(|memory| memory.focused().is_some());
        let mut commands = keys::take_commands(&mut input, has_focus);
        let mut picture = egui::Rect::NOTHING;
        let look = session.look(around.real_time_factor, around.fullscreen);
        let output = context.run_ui(input, |ui| {
            ui.ctx().accesskit_node_builder(egui::accesskit_root_id(), |node| node.set_label(around.title));
            let shown = panels.ui(ui, &look);
            commands.extend(shown.commands);
            picture = shown.picture;
        });
        let repaint_after = output
            .viewport_output
            .get(&egui::ViewportId::ROOT)
            .map(|viewport| viewport.repaint_delay)
            .filter(|delay| *delay < LONG);

        self.picture = picture;
        let panels_done = Instant::now();
        let picture = self.draw_picture(session, picture, output.pixels_per_point);
        let picture_done = Instant::now();
        let shown = Shown {
            shapes: output.shapes,
            pixels_per_point: output.pixels_per_point,
            background: context.global_style().visuals.panel_fill,
            picture,
        };
        let presented = self.screen.present(&context, shown, output.textures_delta, before_presenting);
        let is_to_be_tried_again = matches!(presented, Presented::Again | Presented::SurfaceLost);
        Drawn {
            commands,
            platform: output.platform_output,
            repaint_after: if is_to_be_tried_again { Some(Duration::ZERO) } else { repaint_after },
            presented,
            spent: [panels_done - began, picture_done - panels_done, picture_done.elapsed()],
        }
    }

    /// Asks for the picture as it is, as large as the screen, without waiting for it.
    #[must_use]
    pub fn begin_picture(&mut self, session: &Session, transparent: bool) -> Pending {
        let (width, height) = self.screen.size();
        let mut frame = session.frame(width as f32 / height as f32);
        frame.transparent = transparent;
        let canvas = Canvas::new(self.gpu(), [width, height]);
        let reading = self.screen.draw_on(&canvas, &frame);
        Pending { canvas, reading, transparent, remarks: session.remarks([width, height]) }
    }

    /// Likewise for the pages of the scene's handout.
    ///
    /// # Errors
    /// What keeps the session from having them.
    pub fn begin_pages(&mut self, session: &Session) -> Result<Vec<Pending>, String> {
        let begin = |frame: &Frame| {
            let canvas = Canvas::new(self.gpu(), PAGE);
            let reading = self.screen.draw_on(&canvas, frame);
            Pending { canvas, reading, transparent: false, remarks: vec![] }
        };
        Ok(session.pages()?.iter().map(begin).collect())
    }

    /// Redraws the picture where something in it changed since it was drawn. Gives its place on the screen (pixels).
    fn draw_picture(&mut self, session: &mut Session, picture: egui::Rect, pixels_per_point: f32) -> egui::Rect {
        let (corner, size) = place(picture, pixels_per_point, self.screen.size());
        if size.0 == 0 || size.1 == 0 {
            return on_screen(corner, size);
        }
        let pixels = Pixels::new(size.0 as f32, size.1 as f32);
        session.apply(Command::Resize(pixels), Instant::now());
        let is_new = self.screen.resize_picture(size);
        if is_new || self.drawn != Some(session.revision()) {
            self.drawn = Some(session.revision());
            self.screen.draw_picture(&session.frame(pixels.x / pixels.y), picture_point(pixels_per_point, size));
            session.set_names(self.screen.names());
        }
        on_screen(corner, size)
    }
}

/// A place of this corner and size (pixels).
fn on_screen(corner: (u32, u32), size: (u32, u32)) -> egui::Rect {
    let corner = egui::pos2(corner.0 as f32, corner.1 as f32);
    egui::Rect::from_min_size(corner, egui::vec2(size.0 as f32, size.1 as f32))
}

impl Pending {
    /// The file of the picture, where it has arrived: asked once a frame, it waits for nothing.
    ///
    /// # Errors
    /// What the device has reported.
    pub fn poll(&self, stage: &Stage) -> Result<Option<Vec<u8>>, String> {
        let arrived = self.canvas.try_read(stage.gpu(), &self.reading).map_err(|error| error.to_string())?;
        arrived.map(|picture| self.encoded(&picture)).transpose()
    }

    /// The file of the picture, waited for; not in a browser, where nothing may wait.
    ///
    /// # Errors
    /// What the device has reported.
    pub fn wait(&self, stage: &Stage) -> Result<Vec<u8>, String> {
        let arrived = self.canvas.finish_read(stage.gpu(), &self.reading).map_err(|error| error.to_string())?;
        self.encoded(&arrived)
    }

    fn encoded(&self, picture: &Picture) -> Result<Vec<u8>, String> {
        png::encode(picture, self.transparent, &self.remarks).map_err(|error| error.to_string())
    }
}

/// What window and page call themselves.
#[must_use]
pub fn title(session: &Session) -> String {
    let title = session.title();
    if title.is_empty() { "Dzhanibekov".to_owned() } else { format!("{title} — Dzhanibekov") }
}
