//! What the window shows: a scene, its simulation and how they are looked at; and what each command does to them.

mod edit;
mod time;

use std::path::{Path, PathBuf};

use web_time::{Duration, Instant};

use super::Slide;
use super::command_line::{self, Base};
use super::pick::Pane;
use super::remember::Remembered;
use crate::objects::{self, Cameras, Palette, Space, areas};
use crate::physics::Motion;
use crate::scene::{Layout, Preset, Scene, SceneFile, Theme, View, presets};
use crate::sim::{FlipWatch, History, Simulation};
use crate::ui::{Command, Item, Look, Pixels, Preview, Shown, Spin, Timeline};

/// How long a message stays, and how much longer for each of its characters.
const MESSAGE_TIME: Duration = Duration::from_secs(3);
const READING_TIME: Duration = Duration::from_millis(60);

/// The state behind the window.
#[derive(Debug)]
pub(super) struct Session {
    pub(super) scene: Scene,
    pub(super) sim: Simulation,
    pub(super) cameras: Cameras,
    /// The exact motion from the scene's start.
    motion: Motion,
    history: History,
    flips: FlipWatch,
    timeline: Timeline,
    preview: Option<Preview>,
    slides: Vec<Slide>,
    titles: Vec<String>,
    /// What the open scene is called.
    pub(super) name: String,
    open: Option<usize>,
    base: Base,
    shown: Shown,
    message: Option<(String, Instant)>,
    /// Factor on the size of the panels' text.
    pub(super) text_size: f32,
    /// Something in the picture changed since it was drawn.
    pub(super) picture_changed: bool,
    /// Simulated time was set anew, so that its speed cannot be measured across.
    pub(super) time_jumped: bool,
    /// Size of the picture (pixels).
    pub(super) picture_size: Pixels,
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
    /// Puts the command that draws this picture on the clipboard.
    CopyCommand,
    /// Reads a scene, or a folder of them, and opens it.
    Open(PathBuf),
    /// Moves the keyboard's focus into the panel.
    FocusPanel,
}

impl Session {
    pub(super) fn new(scene: Scene, slides: Vec<Slide>, remembered: &Remembered) -> Self {
        let slides = if slides.is_empty() { built_in() } else { slides };
        let open = slides.iter().position(|slide| slide.file.title == scene.file.title);
        let base = slides.get(open.unwrap_or(0)).map_or_else(
            || Base { name: "flip".to_owned(), file: SceneFile::default() },
            |slide| Base { name: slide.name.clone(), file: slide.file.clone() },
        );
        let motion = Motion::new(&scene.body, &scene.start);
        let mut session = Self {
            sim: Simulation::new(&scene),
            cameras: Cameras::new(&scene.view),
            motion,
            history: History::default(),
            flips: FlipWatch::default(),
            timeline: Timeline { low: 0.0, high: 10.0, first_flip: None, period: None },
            preview: None,
            titles: slides.iter().map(title_of).collect(),
            name: open.and_then(|open| slides.get(open)).map_or_else(|| scene.file.title.clone(), title_of),
            slides,
            open,
            base,
            scene,
            shown: Shown { panel: remembered.panel, slide: remembered.slide, charts: remembered.charts, help: false },
            message: None,
            text_size: remembered.text_size,
            picture_changed: true,
            time_jumped: true,
            picture_size: Pixels::ONE,
        };
        session.forget_the_past();
        session
    }

    /// What the panels see.
    pub(super) fn look(&self, real_time_factor: Option<f64>, fullscreen: bool) -> Look<'_> {
        Look {
            sim: &self.sim,
            scene: &self.scene,
            view: &self.scene.view,
            motion: &self.motion,
            history: &self.history,
            flips: &self.flips,
            timeline: &self.timeline,
            ground: color(Palette::new(self.scene.view.theme).background),
            axis_colors: Palette::new(self.scene.view.theme).axes.map(color),
            own_color: color(Palette::new(self.scene.view.theme).momentum),
            method_color: |method, theme| color(objects::method_color(method, theme)),
            items,
            tip: self.tip(),
            preview: self.preview.as_ref(),
            titles: &self.titles,
            name: &self.name,
            open: self.open,
            real_time_factor,
            shown: self.shown,
            fullscreen,
            message: self.message.as_ref().map(|(text, _)| text.as_str()),
        }
    }

    /// What is kept for the next time, but for the window's own size.
    pub(super) fn remember(&self, remembered: &mut Remembered) {
        remembered.text_size = self.text_size;
        remembered.panel = self.shown.panel;
        remembered.slide = self.shown.slide;
        remembered.charts = self.shown.charts;
    }

    /// Shows a sentence for a while.
    pub(super) fn say(&mut self, text: impl Into<String>) {
        let text = text.into();
        let time = MESSAGE_TIME + READING_TIME * text.chars().count() as u32;
        self.message = Some((text, Instant::now() + time));
    }

    /// Takes back what was said.
    pub(super) fn say_nothing(&mut self) {
        self.message = None;
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

    /// The command that draws this picture with no window, in a picture of this size.
    pub(super) fn as_command(&self, size: [u32; 2]) -> Option<String> {
        command_line::shot(&self.base, &self.scene.file, &self.cameras, self.sim.time(), size)
    }

    /// Does what a command says; what is left for the window is given back.
    pub(super) fn apply(&mut self, command: Command) -> Option<Request> {
        match command {
            Command::PlayPause => self.sim.clock.paused = !self.sim.clock.paused,
            Command::Step(count) => self.step(count),
            Command::Reverse => self.reverse(),
            Command::Faster => self.set_speed(self.sim.clock.speed.abs() * 2.0),
            Command::Slower => self.set_speed(self.sim.clock.speed.abs() / 2.0),
            Command::SetSpeed(speed) => self.set_speed(speed),
            Command::Restart => self.restart(),
            Command::GoTo(time) => self.go_to(time),
            Command::NextFlip => self.go_to_next_flip(),
            Command::Edit(file) => self.edit(&file),
            Command::SpinAxis(axis) => {
                let file = Spin { axis, ..Spin::of(&self.scene) }.write(&self.scene.file);
                self.edit(&file);
            }
            Command::SetEnergy(energy) => self.set_energy(energy),
            Command::ToSeparatrix => self.go_to_separatrix(),
            Command::Poke => self.poke(),
            Command::Hover(at) => self.hover(at),
            Command::Pick(at) => self.pick(at),
            Command::DragTip(to) => self.drag_tip(to),
            Command::Reopen => self.reopen(),
            Command::NextScene => self.open_slide(self.open.map_or(0, |index| index + 1)),
            // From a scene that is none of them, back is the last.
            Command::PreviousScene => self.open_slide(self.open.unwrap_or(self.slides.len()).saturating_sub(1)),
            Command::OpenScene(index) => self.open_slide(index),
            Command::OpenFile(path) => return Some(Request::Open(path)),
            Command::SaveScene => self.save(),
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
            Command::Show { name, is_shown } => self.show_object(name, is_shown),
            Command::ToggleTheme => {
                let theme = match self.scene.view.theme {
                    Theme::Dark => Theme::Light,
                    Theme::Light => Theme::Dark,
                };
                self.scene.view.theme = theme;
                self.scene.file.view.theme = Some(theme);
                self.picture_changed = true;
            }
            Command::ToggleLabels => {
                let labels = !self.scene.view.labels;
                self.scene.view.labels = labels;
                self.scene.file.view.labels = Some(labels);
                self.picture_changed = true;
            }
            Command::TextSize(factor) => {
                self.text_size = if factor > 0.0 { (self.text_size * factor).clamp(0.5, 3.0) } else { 1.0 };
            }
            Command::TogglePanel => self.shown.panel = !self.shown.panel,
            Command::ToggleSlide => self.shown.slide = !self.shown.slide,
            Command::ToggleCharts => self.shown.charts = !self.shown.charts,
            Command::ToggleHelp => self.shown.help = !self.shown.help,
            Command::ToggleFullscreen => return Some(Request::ToggleFullscreen),
            Command::Picture { transparent } => return Some(Request::Picture { transparent }),
            Command::CopyCommand => return Some(Request::CopyCommand),
            Command::FocusPanel => {
                self.shown.panel = true;
                return Some(Request::FocusPanel);
            }
        }
        None
    }

    fn set_layout(&mut self, layout: Layout) {
        self.scene.view.layout = layout;
        self.scene.file.view.layout = Some(layout);
        self.preview = None;
        self.picture_changed = true;
    }

    fn show_object(&mut self, name: &'static str, is_shown: bool) {
        let by_default = objects::object_named(name).is_some_and(|object| object.shown);
        let lists = |show: &mut Vec<String>, hide: &mut Vec<String>| {
            show.retain(|shown| shown != name);
            hide.retain(|hidden| hidden != name);
            if is_shown != by_default {
                if is_shown { show } else { hide }.push(name.to_owned());
            }
        };
        lists(&mut self.scene.view.show, &mut self.scene.view.hide);
        lists(&mut self.scene.file.view.show, &mut self.scene.file.view.hide);
        self.picture_changed = true;
    }

    /// Moves the camera of the view under a point; it is also told that view's smaller side (pixels).
    fn move_camera(&mut self, at: Pixels, change: impl FnOnce(&mut crate::camera::Camera, f32) -> bool) {
        let size = self.picture_size;
        let views = areas(self.scene.view.layout, size.x / size.y);
        let found = views.iter().find(|(_, area)| area.contains(at / size)).or(views.first());
        if let Some((space, area)) = found {
            let side = (area.extent * size).min_element().max(1.0);
            self.picture_changed |= change(self.cameras.of_mut(*space), side);
            self.preview = None;
        }
    }

    /// The view of momentum space, where it is shown.
    fn body_pane(&self) -> Option<Pane> {
        let size = self.picture_size;
        let views = areas(self.scene.view.layout, size.x / size.y);
        let (_, area) = views.into_iter().find(|(space, _)| *space == Space::Body)?;
        let camera = objects::camera(&self.sim, &self.scene.view, &self.cameras, Space::Body);
        Some(Pane::new(&area, size, camera))
    }

    /// Where the tip of M is in the picture, where it is on the near side of the sphere.
    fn tip(&self) -> Option<Pixels> {
        let is_drawn = objects::object_named("tip").is_some_and(|tip| objects::is_shown(tip, &self.scene.view));
        let axes = self.scene.body.body_from_principal();
        self.body_pane().filter(|_| is_drawn)?.near_side(axes.transpose() * self.sim.state().body_momentum)
    }

    fn hover(&mut self, at: Option<Pixels>) {
        let found = at.and_then(|at| {
            let pane = self.body_pane()?;
            Some(pane.preview(&self.scene.body, pane.sphere_under(at)?))
        });
        self.preview = found;
    }
}

/// Everything that can be drawn, what is usually shown first.
fn items(view: &View) -> Vec<Item> {
    let usual = objects::OBJECTS.iter().filter(|object| object.shown);
    usual
        .chain(objects::OBJECTS.iter().filter(|object| !object.shown))
        .map(|object| Item {
            name: object.name,
            label: object.label,
            is_of_world: object.space == Space::World,
            is_shown: objects::is_shown(object, view),
        })
        .collect()
}

/// The scenes built into the program.
fn built_in() -> Vec<Slide> {
    let slide = |preset: Preset| Some(Slide { name: preset.name.to_owned(), file: preset.read().ok()? });
    presets().into_iter().filter_map(slide).collect()
}

/// What the list of scenes calls it: its title, or else its file.
fn title_of(slide: &Slide) -> String {
    let title = slide.file.title.trim();
    let stem = Path::new(&slide.name).file_stem().map_or(slide.name.clone().into(), std::ffi::OsStr::to_string_lossy);
    if title.is_empty() { stem.into_owned() } else { title.to_owned() }
}

/// A colour of the picture, as the panels draw colours.
fn color(of: crate::frame::Color) -> egui::Color32 {
    let [r, g, b, _] = of.0.map(|channel| (channel * 255.0).round() as u8);
    egui::Color32::from_rgb(r, g, b)
}

/// What a presenter has chosen stays from scene to scene, unless the scene itself sets it.
fn keep_choices(view: &mut View, file: &mut SceneFile, before: &SceneFile) {
    if file.view.theme.is_none()
        && let Some(theme) = before.view.theme
    {
        view.theme = theme;
        file.view.theme = Some(theme);
    }
    if file.view.labels.is_none()
        && let Some(labels) = before.view.labels
    {
        view.labels = labels;
        file.view.labels = Some(labels);
    }
}
