//! The window: events become commands, commands change the session, the session becomes a picture.
//!
//! Nothing is drawn unless something changed, and nothing at all while the window cannot be seen.

mod clipboard;
mod console;
mod files;
mod mapping;
mod open;
mod remember;
mod startup;
mod trial;
mod watch;

use std::path::{Path, PathBuf};

use winit::application::ApplicationHandler;
use winit::event::WindowEvent;
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoopProxy};
use winit::window::WindowId;

use web_time::Instant;

pub use files::read_slides;
pub use startup::WindowError;

use crate::objects;
use crate::scene::Scene;
use crate::session::{Effect, Remembered, Session, Slide};
use crate::stage::Pacer;
use crate::ui::{Command, Panels};
use open::OpenWindow;
use trial::{Frame, Trial};
use watch::Watch;

/// How the window is opened.
#[derive(Clone, Debug)]
pub struct WindowOptions {
    /// Its size in pixels.
    pub size: Option<[u32; 2]>,
    /// A part of the name of the graphics adapter to draw with.
    pub adapter: Option<String>,
    /// The scenes to go through before those built in.
    pub slides: Vec<Slide>,
    /// The file or folder that they came from, which is followed.
    pub place: Option<PathBuf>,
    /// The time (s) that is gone to at first, as a link says it.
    pub time: Option<f64>,
    /// Whether time stands there, as in a picture.
    pub paused: bool,
}

/// Opens the window on a scene and returns when it is closed.
///
/// # Errors
/// No display, no graphics adapter, or a library missing: one sentence that says what to do about it.
pub fn run(scene: Scene, mut options: WindowOptions) -> Result<(), WindowError> {
    let event_loop = startup::connect()?;
    // What is told in steps begins with the first, where no other one is asked for; a picture shows what it shows.
    let at = if options.paused { scene.at } else { scene.at.or(scene.file.first_step()) };
    let scene = objects::check_at(&scene.file, at).unwrap_or(scene);
    let remembered = remember::load();
    let slides = std::mem::take(&mut options.slides);
    let mut app = App {
        options,
        remembered,
        proxy: event_loop.create_proxy(),
        session: Session::new(scene, slides, &remembered, Instant::now()),
        jumps: 0,
        panels: Panels::default(),
        pacer: Pacer::new(Instant::now()),
        window: None,
        repaint_at: None,
        error: None,
        watch: None,
        recoveries: 0,
        trial: Trial::from_environment(),
    };
    if let Some(time) = app.options.time {
        app.session.apply(Command::GoTo(time), Instant::now());
        if app.options.paused {
            app.session.show_time(time);
        }
    }
    app.watch = app
        .options
        .place
        .take()
        .and_then(|place| Some((place.display().to_string(), Watch::new(&place, event_loop.create_proxy())?)));
    let outcome = startup::while_displayed(|| event_loop.run_app(&mut app));
    let outcome = match outcome {
        Ok(outcome) => outcome,
        Err(gone) => {
            // To clean up would be to ask the display again.
            std::mem::forget(app);
            return Err(gone);
        }
    };
    match app.error.take() {
        Some(error) => Err(error),
        None => outcome.map_err(|error| startup::ended(&error)),
    }
}

/// Devices made anew without a frame between after which it is given up.
const MOST_RECOVERIES: u32 = 3;

/// What wakes the event loop from outside.
#[derive(Debug)]
enum Wake {
    /// A screen reader asks for something.
    Access(egui_winit::accesskit_winit::Event),
    /// The graphics device is gone.
    DeviceLost,
    /// Scenes on the disk are others.
    FilesChanged,
}

impl From<egui_winit::accesskit_winit::Event> for Wake {
    fn from(event: egui_winit::accesskit_winit::Event) -> Self {
        Self::Access(event)
    }
}

struct App {
    options: WindowOptions,
    remembered: Remembered,
    proxy: EventLoopProxy<Wake>,
    session: Session,
    /// What was last seen of the session's jumps in time.
    jumps: u64,
    panels: Panels,
    pacer: Pacer,
    window: Option<OpenWindow>,
    /// When something is to be drawn although simulated time stands.
    repaint_at: Option<Instant>,
    error: Option<WindowError>,
    /// What is followed on the disk, under the name by which it was opened.
    watch: Option<(String, Watch)>,
    /// Devices made anew since the last frame on the screen.
    recoveries: u32,
    trial: Trial,
}

impl App {
    /// Asks for a frame at the next beat.
    fn wake(&mut self) {
        self.repaint_at = Some(Instant::now());
    }

    fn fail(&mut self, event_loop: &ActiveEventLoop, error: WindowError) {
        self.error = Some(error);
        event_loop.exit();
    }

    /// The device is gone: everything on it is made anew.
    fn recover(&mut self, event_loop: &ActiveEventLoop) {
        // A device may tell of its loss more than once.
        let Some(window) = self.window.take_if(|window| window.is_lost()) else { return };
        self.recoveries += 1;
        if self.recoveries > MOST_RECOVERIES {
            self.fail(event_loop, WindowError::DeviceGone);
            return;
        }
        match window.recovered(event_loop, &self.options, &self.proxy) {
            Ok(window) => self.window = Some(window),
            Err(error) => {
                self.fail(event_loop, error);
                return;
            }
        }
        self.wake();
    }

    fn draw(&mut self, event_loop: &ActiveEventLoop) {
        let Some(window) = &mut self.window else { return };
        window.look_around();
        if !window.is_visible() {
            return;
        }
        let now = Instant::now();
        if self.trial.loses_device(now) {
            window.lose_device();
        }
        self.pacer.begin(now);
        self.repaint_at = None;
        if self.session.is_playing() {
            let passed = self.pacer.tick(now);
            self.session.advance(passed, now);
            let has_jumped = std::mem::replace(&mut self.jumps, self.session.jumps()) != self.session.jumps();
            self.pacer.measure(now, self.session.time(), has_jumped);
        } else {
            self.session.advance(0.0, now);
            self.pacer.stand();
        }
        let simulation = now.elapsed();
        let factor = self.pacer.real_time_factor();
        let drawn = window.draw(event_loop, &mut self.session, &mut self.panels, factor);
        if drawn.is_shown {
            self.recoveries = 0;
        }
        let [panels, picture, present] = drawn.spent;
        let spent = [simulation, panels, picture, present];
        self.trial.note(Frame { at: now, simulated: self.session.time(), spent });
        self.repaint_at = drawn.repaint_after.and_then(|delay| now.checked_add(delay));
        let has_commands = !drawn.commands.is_empty();
        self.apply(drawn.commands);
        if has_commands {
            self.wake();
        }
    }

    fn apply(&mut self, commands: Vec<Command>) {
        for command in commands {
            for effect in self.session.apply(command, Instant::now()) {
                self.take_effect(effect);
            }
        }
    }

    /// Does what the session leaves to the window.
    fn take_effect(&mut self, effect: Effect) {
        match effect {
            Effect::Open(place) => {
                let read = files::read_slides(Path::new(&place));
                if read.is_ok() {
                    self.watch = Watch::new(Path::new(&place), self.proxy.clone()).map(|watch| (place.clone(), watch));
                }
                let moment = files::moment_shown(Path::new(&place), &read);
                self.session.open_slides(&place, read);
                if let Some((step, time)) = moment {
                    self.session.show_moment(step, time);
                }
            }
            Effect::SaveText { place, title, text } => {
                let written = match place {
                    Some(place) => files::write_whole(Path::new(&place), text.as_bytes()).map(|()| place.into()),
                    None => files::write_new(&title, "toml", text.as_bytes()),
                };
                match written {
                    Ok(path) => self.session.saved(&path.display().to_string()),
                    Err(why) => self.session.say(why),
                }
            }
            Effect::WritePicture { transparent } => {
                if let Some(window) = &mut self.window {
                    let outcome = window.write_picture(&self.session, transparent);
                    self.session.say(outcome.unwrap_or_else(|why| why));
                }
            }
            Effect::WriteHandout => {
                if let Some(window) = &mut self.window {
                    let outcome = window.write_handout(&self.session);
                    self.session.say(outcome.unwrap_or_else(|why| why));
                }
            }
            Effect::CopyText(text) | Effect::CopyLink(text) => {
                if let Some(window) = &mut self.window
                    && let Err(why) = window.copy(text.clone())
                {
                    self.session.say(format!("Not copied ({why}); it is: {text}"));
                }
            }
            // Only a page offers it: to a window files are given by dropping them.
            Effect::ChooseFile => {}
            Effect::FocusPanel => self.panels.take_focus(),
            Effect::ToggleFullscreen => {
                if let Some(window) = &self.window {
                    window.toggle_fullscreen();
                }
            }
        }
    }
}

impl ApplicationHandler<Wake> for App {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        if self.window.is_some() {
            return;
        }
        match OpenWindow::new(event_loop, &self.options, &self.remembered, &self.proxy, &self.session) {
            Ok(window) => {
                self.pacer.set_refresh_rate(window.refresh_rate());
                self.window = Some(window);
                // Not before: what is in the window's way is said there.
                console::leave_own();
                self.wake();
            }
            Err(error) => self.fail(event_loop, error),
        }
    }

    fn user_event(&mut self, event_loop: &ActiveEventLoop, event: Wake) {
        match event {
            Wake::DeviceLost => self.recover(event_loop),
            Wake::FilesChanged => {
                if let Some((name, _)) = &self.watch {
                    let read = files::read_slides(Path::new(name));
                    self.session.refresh(&name.clone(), read, Instant::now());
                    self.wake();
                }
            }
            Wake::Access(event) => {
                if let Some(window) = &mut self.window {
                    window.on_access(event.window_event);
                }
                self.wake();
            }
        }
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let Some(window) = &mut self.window else { return };
        let wants_repaint = window.on_event(&event);
        match event {
            WindowEvent::CloseRequested => event_loop.exit(),
            WindowEvent::RedrawRequested => {
                self.draw(event_loop);
                return;
            }
            WindowEvent::Moved(_) | WindowEvent::ScaleFactorChanged { .. } => {
                self.pacer.set_refresh_rate(window.refresh_rate());
            }
            WindowEvent::HoveredFile(path) => self.session.say(files::offer(&path)),
            WindowEvent::HoveredFileCancelled => self.session.say_nothing(),
            WindowEvent::DroppedFile(path) => {
                self.apply(vec![Command::OpenPlace(path.to_string_lossy().into_owned())]);
            }
            _ => {}
        }
        if wants_repaint {
            self.wake();
        }
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        // Before anything waits: nothing else may come that would wake the loop.
        if self.window.as_ref().is_some_and(OpenWindow::is_lost) {
            self.recover(event_loop);
        }
        let Some(window) = &self.window else { return };
        if !window.is_visible() {
            self.pacer.stand();
            event_loop.set_control_flow(ControlFlow::Wait);
            return;
        }
        let wanted = if self.session.is_moving() {
            Some(self.pacer.due())
        } else {
            // However often events ask, frames keep their beat.
            self.repaint_at.into_iter().chain(self.session.message_ends()).min().map(|at| at.max(self.pacer.due()))
        };
        match wanted {
            None => event_loop.set_control_flow(ControlFlow::Wait),
            Some(at) if at <= Instant::now() => {
                window.request_redraw();
                event_loop.set_control_flow(ControlFlow::Wait);
            }
            Some(at) => event_loop.set_control_flow(ControlFlow::WaitUntil(at)),
        }
    }

    fn exiting(&mut self, _: &ActiveEventLoop) {
        // While the display still stands: surface and device outlive nothing.
        if let Some(window) = self.window.take() {
            window.remember(&mut self.remembered);
            self.session.remember(&mut self.remembered);
            remember::save(&self.remembered);
        }
        if let Err(why) = self.trial.write() {
            self.error.get_or_insert(WindowError::Trial(why));
        }
    }
}
