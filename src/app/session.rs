//! What the window shows: a scene, its simulation and how they are looked at; and what each command does to them.

use std::path::Path;

use web_time::{Duration, Instant};

use crate::frame::Area;
use crate::objects::{Cameras, Space, areas};
use crate::scene::{Layout, Scene, SceneFile, Theme, presets};
use crate::sim::{Simulation, Tick};
use crate::ui::{Command, Look, Pixels, SPEED_POWERS, Spin};

/// How long a message stays.
const MESSAGE_TIME: Duration = Duration::from_secs(4);
/// Steps that a change of method or step may take to come back to the same time; past that it starts over.
const MOST_CATCHING_UP: f64 = 2e5;
/// Longest scene file read (bytes).
const LARGEST_FILE: u64 = 1 << 20;

/// The state behind the window.
#[derive(Debug)]
pub(super) struct Session {
    pub(super) scene: Scene,
    pub(super) sim: Simulation,
    pub(super) cameras: Cameras,
    slides: Vec<Slide>,
    open: Option<usize>,
    titles: Vec<String>,
    shown: Shown,
    message: Option<(String, Instant)>,
    /// Something in the picture changed since it was drawn.
    pub(super) picture_changed: bool,
    /// Simulated time was set anew, so that its speed cannot be measured across.
    pub(super) time_jumped: bool,
    /// Size of the picture (pixels).
    pub(super) picture_size: Pixels,
}

/// What is shown besides the picture.
#[derive(Clone, Copy, Debug)]
struct Shown {
    panel: bool,
    help: bool,
}

/// A scene that can be gone to.
#[derive(Debug)]
struct Slide {
    file: SceneFile,
}

/// What only the window itself can do.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Request {
    /// Full screen or back.
    ToggleFullscreen,
    /// Writes the picture.
    Picture {
        /// With no background.
        transparent: bool,
    },
    /// Moves the keyboard's focus into the panel.
    FocusPanel,
}

impl Session {
    pub(super) fn new(scene: Scene) -> Self {
        let slides: Vec<Slide> =
            presets().into_iter().filter_map(|preset| Some(Slide { file: preset.read().ok()? })).collect();
        let open = slides.iter().position(|slide| slide.file.title == scene.file.title);
        Self {
            sim: Simulation::new(&scene),
            cameras: Cameras::new(&scene.view),
            titles: slides.iter().map(|slide| slide.file.title.clone()).collect(),
            scene,
            slides,
            open,
            shown: Shown { panel: true, help: false },
            message: None,
            picture_changed: true,
            time_jumped: true,
            picture_size: Pixels::ONE,
        }
    }

    /// What the panels see.
    pub(super) fn look(&self, real_time_factor: Option<f64>, fullscreen: bool) -> Look<'_> {
        Look {
            sim: &self.sim,
            scene: &self.scene,
            view: &self.scene.view,
            titles: &self.titles,
            open: self.open,
            real_time_factor,
            panel_shown: self.shown.panel,
            help_shown: self.shown.help,
            fullscreen,
            message: self.message.as_ref().map(|(text, _)| text.as_str()),
        }
    }

    /// Lets real time (s) pass.
    pub(super) fn advance(&mut self, real_seconds: f64) {
        if self.sim.advance_frame(real_seconds) != Tick::Still {
            self.picture_changed = true;
        }
        if let (Some(failure), true) = (self.sim.main().failure(), self.sim.clock.paused) {
            let text = failure.to_string();
            self.say(text);
        }
    }

    /// Whether simulated time runs.
    pub(super) fn is_playing(&self) -> bool {
        !self.sim.clock.paused
    }

    /// Shows a sentence for a while.
    pub(super) fn say(&mut self, text: impl Into<String>) {
        self.message = Some((text.into(), Instant::now() + MESSAGE_TIME));
    }

    /// When the message goes.
    pub(super) fn message_ends(&self) -> Option<Instant> {
        self.message.as_ref().map(|(_, end)| *end)
    }

    /// Drops a message that has been there long enough.
    pub(super) fn drop_old_message(&mut self, now: Instant) {
        if self.message_ends().is_some_and(|end| end <= now) {
            self.message = None;
        }
    }

    /// Does what a command says; what is left for the window is given back.
    pub(super) fn apply(&mut self, command: Command) -> Option<Request> {
        match command {
            Command::PlayPause => self.sim.clock.paused = !self.sim.clock.paused,
            Command::Step(count) => {
                self.sim.clock.paused = true;
                self.sim.step(count);
                self.picture_changed = true;
            }
            Command::Reverse => {
                self.sim.clock.speed = -self.sim.clock.speed;
                self.time_jumped = true;
            }
            Command::Faster => self.set_speed(self.sim.clock.speed.abs() * 2.0),
            Command::Slower => self.set_speed(self.sim.clock.speed.abs() / 2.0),
            Command::SetSpeed(speed) => self.set_speed(speed),
            Command::Restart => {
                self.sim.restart();
                self.moved_in_time();
            }
            Command::GoTo(time) => {
                self.sim.go_to(time);
                self.moved_in_time();
            }
            Command::Edit(file) => self.edit(&file),
            Command::SpinAxis(axis) => {
                let file = Spin { axis, ..Spin::of(&self.scene) }.write(&self.scene.file);
                self.edit(&file);
            }
            Command::NextScene => self.open_slide(self.open.map_or(0, |index| index + 1)),
            // From a scene that is none of them, back is the last.
            Command::PreviousScene => self.open_slide(self.open.unwrap_or(self.slides.len()).saturating_sub(1)),
            Command::OpenScene(index) => self.open_slide(index),
            Command::OpenFile(path) => self.open_file(&path),
            Command::Orbit { at, by } => self.move_camera(at, |camera, side| camera.orbit(by / side)),
            Command::Pan { at, by } => self.move_camera(at, |camera, side| camera.pan(by / side)),
            // A notch of the wheel is ten per cent.
            Command::Zoom { at, by } => self.move_camera(at, |camera, _| camera.zoom(by.ln() * 10.0)),
            Command::Home => {
                self.cameras = Cameras::new(&self.scene.view);
                self.picture_changed = true;
            }
            Command::SetLayout(layout) => self.set_layout(layout),
            Command::NextLayout => self.set_layout(match self.scene.view.layout {
                Layout::Both => Layout::World,
                Layout::World => Layout::Body,
                Layout::Body => Layout::Both,
            }),
            Command::ToggleTheme => {
                let theme = match self.scene.view.theme {
                    Theme::Dark => Theme::Light,
                    Theme::Light => Theme::Dark,
                };
                self.scene.view.theme = theme;
                self.scene.file.view.theme = Some(theme);
                self.picture_changed = true;
            }
            Command::TogglePanel => self.shown.panel = !self.shown.panel,
            Command::ToggleHelp => self.shown.help = !self.shown.help,
            Command::ToggleFullscreen => return Some(Request::ToggleFullscreen),
            Command::Picture { transparent } => return Some(Request::Picture { transparent }),
            Command::FocusPanel => {
                self.shown.panel = true;
                return Some(Request::FocusPanel);
            }
        }
        None
    }

    fn moved_in_time(&mut self) {
        self.time_jumped = true;
        self.picture_changed = true;
    }

    fn set_speed(&mut self, speed: f64) {
        let (low, high) = SPEED_POWERS;
        let speed = speed.clamp(f64::from(low).exp2(), f64::from(high).exp2());
        self.sim.clock.speed = speed.copysign(self.sim.clock.speed);
        self.time_jumped = true;
    }

    fn set_layout(&mut self, layout: Layout) {
        self.scene.view.layout = layout;
        self.scene.file.view.layout = Some(layout);
        self.picture_changed = true;
    }

    /// The smaller side (pixels) of the view under a point, and its camera.
    fn move_camera(&mut self, at: Pixels, change: impl FnOnce(&mut crate::camera::Camera, f32) -> bool) {
        let size = self.picture_size;
        let views: Vec<(Space, Area)> = areas(self.scene.view.layout, size.x / size.y);
        let found = views.iter().find(|(_, area)| area.contains(at / size)).or(views.first());
        if let Some((space, area)) = found {
            let side = (area.extent * size).min_element().max(1.0);
            self.picture_changed |= change(self.cameras.of_mut(*space), side);
        }
    }

    /// Takes a changed scene where it is a scene, and says what is wrong with it where it is not.
    fn edit(&mut self, file: &SceneFile) {
        match Scene::check(file) {
            Ok(scene) => {
                let is_same_motion = scene.file.body == self.scene.file.body && scene.file.spin == self.scene.file.spin;
                let time = self.sim.time();
                let clock = self.sim.clock;
                self.sim = Simulation::new(&scene);
                self.sim.clock = clock;
                self.sim.clock.clear();
                if is_same_motion && (time / scene.step).abs() <= MOST_CATCHING_UP {
                    self.sim.go_to(time);
                }
                self.scene = scene;
                self.moved_in_time();
            }
            Err(error) => self.say(error.to_string()),
        }
    }

    fn open_slide(&mut self, index: usize) {
        let Some(file) = self.slides.get(index).map(|slide| slide.file.clone()) else { return };
        match Scene::check(&file) {
            Ok(scene) => {
                self.open_scene(scene);
                self.open = Some(index);
            }
            Err(error) => self.say(error.to_string()),
        }
    }

    fn open_file(&mut self, path: &Path) {
        let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
        match read_scene(path) {
            Ok(scene) => {
                let warning = scene.warnings().into_iter().next();
                self.open_scene(scene);
                self.open = None;
                self.say(warning.unwrap_or(name));
            }
            Err(why) => self.say(format!("{name}: {why}")),
        }
    }

    /// Starts a scene. Theme and labels stay as the presenter has them, unless the scene sets them.
    fn open_scene(&mut self, mut scene: Scene) {
        if scene.file.view.theme.is_none() {
            scene.view.theme = self.scene.view.theme;
            scene.file.view.theme = self.scene.file.view.theme;
        }
        self.sim = Simulation::new(&scene);
        self.cameras = Cameras::new(&scene.view);
        self.scene = scene;
        self.moved_in_time();
    }
}

fn read_scene(path: &Path) -> Result<Scene, String> {
    let length = std::fs::metadata(path).map_err(|error| error.to_string())?.len();
    if length > LARGEST_FILE {
        return Err(format!("it is {length} bytes long, and a scene has at most {LARGEST_FILE}"));
    }
    let text = std::fs::read_to_string(path).map_err(|error| error.to_string())?;
    let file = SceneFile::parse(&text).map_err(|error| error.to_string())?;
    Scene::check(&file).map_err(|error| error.to_string())
}
