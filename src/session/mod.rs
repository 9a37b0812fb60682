//! The state behind any front end: a scene's text, the motion that follows from it, how it is looked at, and what each
//! [`Command`] does to them.
//!
//! The text of the scene is the one truth: every change is a change of that text, from which scene, simulation, exact motion
//! and time line are derived again. What only a window or a page can do comes back as an [`Effect`]. No file, clock, window
//! or thread is known here: the present moment comes in with each call.

mod command_line;
mod edit;
mod effect;
mod pick;
mod remember;
mod slides;
mod spin;
mod start;
mod steps;
#[cfg(test)]
mod tests;
mod time;
mod undo;
mod view;

use web_time::{Duration, Instant};

use crate::frame::{Frame, PlacedName};
use crate::objects::{self, Cameras, Glide};
use crate::physics::Motion;
use crate::scene::{Scene, SceneError, SceneFile, Theme, View, ViewFile};
use crate::sim::{FlipWatch, History, Simulation, Slowing};
use crate::ui::{Command, Front, LARGER, Look, Pixels, Preview, Shown, Timeline};

pub use crate::objects::PAGE;
pub use command_line::slug;
pub use effect::Effect;
pub use remember::Remembered;
pub use slides::{Slide, built_in};

use slides::Opened;
use undo::{Kind, Moment, Undo};

/// How long a message stays, and how much longer for each of its characters.
const MESSAGE_TIME: Duration = Duration::from_secs(3);
const READING_TIME: Duration = Duration::from_millis(60);

/// How long a picture glides from one step to the next.
const GLIDE_TIME: Duration = Duration::from_millis(500);

/// How to go on, said once at the beginning.
const FIRST_WORDS: &str = "PageDown goes on · Space plays and pauses · drag to turn · H all keys";

/// The state behind a front end.
#[derive(Debug)]
pub struct Session {
    /// Derived from its text by [`Session::set`] and changed nowhere else.
    scene: Scene,
    sim: Simulation,
    /// The exact motion from the scene's start.
    motion: Motion,
    cameras: Cameras,
    /// From where the picture glides to what it is to be.
    origin: Option<Origin>,
    /// Whether pictures glide from step to step.
    glides: bool,
    history: History,
    flips: FlipWatch,
    timeline: Timeline,
    /// Where the clock slows, if it does.
    slowing: Option<Slowing>,
    /// The flip (s) that is run through again and again.
    looped: Option<f64>,
    preview: Option<Preview>,
    slides: Vec<Slide>,
    titles: Vec<String>,
    opened: Opened,
    /// The file that the scene was last written to, and what was written.
    saved: Option<(String, SceneFile)>,
    undo: Undo,
    shown: Shown,
    /// The labels of the picture, where the front end has drawn them.
    names: Vec<PlacedName>,
    message: Option<(String, Instant)>,
    text_size: f32,
    front: Front,
    /// Dark or light, where a scene does not say.
    preferred_theme: Option<Theme>,
    picture_size: Pixels,
    now: Instant,
    /// Scenes set so far.
    scenes: u64,
    revision: u64,
    jumps: u64,
}

/// From where a picture glides to another step.
#[derive(Clone, Debug)]
struct Origin {
    view: View,
    cameras: Cameras,
    begun: Instant,
}

/// What the picture depends on: it is drawn again where this has changed.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Seen {
    scenes: u64,
    time: f64,
    cameras: Cameras,
    size: Pixels,
    glided: f32,
    is_presented: bool,
}

impl Session {
    /// A session with a checked scene open; the slides are the scenes to go through, those built in where there are none.
    #[must_use]
    pub fn new(scene: Scene, slides: Vec<Slide>, remembered: &Remembered, now: Instant) -> Self {
        // Those built in stay within reach of scenes of one's own.
        let slides: Vec<Slide> = slides.into_iter().chain(built_in()).collect();
        let place = slides.iter().position(|slide| slide.file.as_ref().is_ok_and(|f| f.title == scene.file.title));
        let opened = match place.and_then(|place| Some((place, slides.get(place)?))) {
            Some((place, slide)) => Opened {
                name: slide.name.clone(),
                title: slide.title(),
                file: slide.file.clone().unwrap_or_default(),
                base: None,
                place: Some(place),
            },
            // Of a scene that is none of them only what differs from the first can be said.
            None => Opened {
                name: slides.first().map_or_else(|| "flip".to_owned(), |slide| slide.name.clone()),
                title: scene.file.title.clone(),
                file: scene.file.clone(),
                base: slides.first().and_then(|slide| slide.file.clone().ok()),
                place: None,
            },
        };
        let mut session = Self {
            sim: Simulation::new(&scene),
            motion: Motion::new(&scene.body, &scene.start),
            cameras: Cameras::new(&scene.view),
            origin: None,
            glides: true,
            history: History::default(),
            flips: FlipWatch::default(),
            timeline: Timeline { low: 0.0, high: 10.0, first_flip: None, period: None },
            slowing: None,
            looped: None,
            preview: None,
            titles: slides.iter().map(Slide::title).collect(),
            slides,
            opened,
            saved: None,
            undo: Undo::default(),
            scene,
            shown: Shown {
                presenting: remembered.presenting,
                ..Shown::remembered(remembered.panel, remembered.slide, remembered.charts)
            },
            names: vec![],
            message: None,
            text_size: remembered.text_size,
            front: Front::Window,
            preferred_theme: None,
            picture_size: Pixels::ONE,
            now,
            scenes: 1,
            revision: 1,
            jumps: 0,
        };
        session.forget_the_past();
        session.begin_pace();
        session.say(FIRST_WORDS);
        session
    }

    /// What the panels see.
    #[must_use]
    pub fn look(&self, real_time_factor: Option<f64>, fullscreen: bool) -> Look<'_> {
        Look {
            sim: &self.sim,
            scene: &self.scene,
            opened: &self.opened.file,
            motion: &self.motion,
            history: &self.history,
            flips: &self.flips,
            timeline: &self.timeline,
            slowed: self.slowed(),
            is_looping: self.looped.is_some(),
            tip: self.tip(),
            preview: self.preview.as_ref(),
            titles: &self.titles,
            name: &self.opened.title,
            open: self.opened.place,
            real_time_factor,
            shown: &self.shown,
            names: &self.names,
            can_undo: self.undo.can(),
            fullscreen,
            front: self.front,
            message: self.message.as_ref().map(|(text, _)| text.as_str()),
        }
    }

    /// The picture as it is now, in a picture of this aspect (width over height).
    #[must_use]
    pub fn frame(&self, aspect: f32) -> Frame {
        let part = self.glided();
        let type_scale = if self.shown.presenting { LARGER } else { 1.0 };
        match &self.origin {
            Some(origin) if part < 1.0 => {
                let cameras = Cameras::between(&origin.cameras, &self.cameras, part);
                let glide = Glide { from: &origin.view, part };
                objects::build_frame_on_the_way(&self.scene, &self.sim, &cameras, aspect, type_scale, Some(glide))
            }
            _ => objects::build_frame_scaled(&self.scene, &self.sim, &self.cameras, aspect, type_scale),
        }
    }

    /// How far the picture has glided from the step before to this one, from 0 to 1: slow at both ends.
    fn glided(&self) -> f32 {
        let Some(origin) = &self.origin else { return 1.0 };
        let part = self.now.saturating_duration_since(origin.begun).as_secs_f32() / GLIDE_TIME.as_secs_f32();
        let part = part.min(1.0);
        part * part * (3.0 - 2.0 * part)
    }

    /// Whether pictures glide from step to step; those who want less motion have each at once.
    pub fn set_gliding(&mut self, is_gliding: bool) {
        self.glides = is_gliding;
        self.origin = self.origin.take().filter(|_| is_gliding);
    }

    /// Whether the picture changes by itself: time runs, or it glides to another step.
    #[must_use]
    pub fn is_moving(&self) -> bool {
        self.is_playing() || self.glided() < 1.0
    }

    /// Another number where the picture is another one.
    #[must_use]
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Another number where simulated time was set anew, so that its speed cannot be measured across.
    #[must_use]
    pub fn jumps(&self) -> u64 {
        self.jumps
    }

    /// The scene.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The title of what is open.
    #[must_use]
    pub fn title(&self) -> &str {
        self.opened.title.trim()
    }

    /// Simulated time (s).
    #[must_use]
    pub fn time(&self) -> f64 {
        self.sim.time()
    }

    /// Whether simulated time runs.
    #[must_use]
    pub fn is_playing(&self) -> bool {
        !self.sim.clock.paused
    }

    /// Dark or light.
    #[must_use]
    pub fn theme(&self) -> Theme {
        self.scene.view.theme
    }

    /// Takes dark or light where a scene does not say, as the system has it.
    pub fn prefer_theme(&mut self, theme: Theme) {
        self.preferred_theme = Some(theme);
        let before = self.scene.view.theme;
        wear(&mut self.scene, self.preferred_theme);
        if self.scene.view.theme != before {
            self.scenes += 1;
            self.revision += 1;
        }
    }

    /// Takes the place of a part of another page.
    pub fn embed(&mut self) {
        self.shown.embedded = true;
        self.shown.panel = false;
        self.shown.slide = false;
        self.say_nothing();
    }

    /// What the session is shown by: only what that can do is offered.
    pub fn shown_by(&mut self, front: Front) {
        self.front = front;
    }

    /// Factor on the size of the panels' text.
    #[must_use]
    pub fn text_size(&self) -> f32 {
        self.text_size
    }

    /// Takes where the labels of the picture stand: those who hover over one are told what its word means.
    pub fn set_names(&mut self, names: &[PlacedName]) {
        names.clone_into(&mut self.names);
    }

    /// Whether it is in presenter's mode.
    #[must_use]
    pub fn is_presenting(&self) -> bool {
        self.shown.presenting
    }

    /// What is kept for the next time, but for what the front end itself keeps.
    pub fn remember(&self, remembered: &mut Remembered) {
        remembered.text_size = self.text_size;
        remembered.panel = self.shown.panel;
        remembered.presenting = self.shown.presenting;
        remembered.slide = self.shown.slide;
        remembered.charts = self.shown.charts;
    }

    /// Shows a sentence for a while.
    pub fn say(&mut self, text: impl Into<String>) {
        let text = text.into();
        let time = MESSAGE_TIME + READING_TIME * text.chars().count() as u32;
        self.message = Some((text, self.now + time));
    }

    /// Takes back what was said.
    pub fn say_nothing(&mut self) {
        self.message = None;
    }

    /// When the message goes.
    #[must_use]
    pub fn message_ends(&self) -> Option<Instant> {
        self.message.as_ref().map(|(_, end)| *end)
    }

    /// Lets real time (s) pass until now.
    pub fn advance(&mut self, real_seconds: f64, now: Instant) {
        if self.message_ends().is_some_and(|end| end <= now) {
            self.message = None;
        }
        let seen = self.seen();
        self.now = now;
        self.run(real_seconds);
        self.note_change(seen);
    }

    /// Does what a command says; what is left for the front end is given back.
    pub fn apply(&mut self, command: Command, now: Instant) -> Vec<Effect> {
        self.now = now;
        let seen = self.seen();
        let before = self.moment();
        let kind = Kind::of(&command);
        let effects = self.obey(command);
        if let Some(kind) = kind
            && (self.scene.file != before.file || self.opened.place != before.opened.place)
        {
            self.undo.note(kind, before, now);
        }
        self.note_change(seen);
        effects
    }

    fn obey(&mut self, command: Command) -> Vec<Effect> {
        match command {
            Command::PlayPause => self.sim.clock.paused = !self.sim.clock.paused,
            Command::Step(count) => self.step(count),
            Command::Reverse => self.reverse(),
            Command::Faster => self.set_speed(self.sim.clock.speed.abs() * 2.0),
            Command::Slower => self.set_speed(self.sim.clock.speed.abs() / 2.0),
            Command::SetSpeed(speed) => self.set_speed(speed),
            Command::Restart => self.restart(),
            Command::GoTo(time) => {
                self.shown.asking_time = false;
                self.go_to(time);
            }
            Command::AskTime => {
                // The field comes where words stand.
                self.say_nothing();
                self.shown.asking_time = true;
            }
            Command::AskNothing => self.shown.asking_time = false,
            Command::NextFlip => self.go_to_next_flip(),
            Command::LoopFlip => self.loop_flip(),
            Command::ToggleSlow => self.toggle_slow(),
            Command::SetBody(body) => self.edit(|file| file.body = *body),
            Command::SpinAxis(axis) => self.set_spin(spin::about(&self.scene, axis)),
            Command::SetTilt(tilt_deg) => self.set_spin(spin::tilted(&self.scene, tilt_deg)),
            Command::SetRate(rate) => self.set_spin(spin::at_rate(&self.scene, rate)),
            Command::SetEnergy(energy) => self.set_energy(energy),
            Command::ToSeparatrix => self.go_to_separatrix(),
            Command::Poke => self.poke(),
            Command::SetMethod(method) => self.edit(|file| file.motion.method = Some(method.to_owned())),
            Command::SetStep(step) => self.edit(|file| file.motion.step = Some(step)),
            Command::SetEnergyLoss(loss) => self.set_energy_loss(loss),
            Command::Compare { method, is_on } => self.compare(method, is_on),
            Command::Hover(at) => self.hover(at),
            Command::Pick(at) => self.pick(at),
            Command::DragTip(to) => self.drag_tip(to),
            Command::Undo => self.take_back(),
            Command::Redo => self.make_again(),
            Command::Reopen => self.reopen(),
            Command::NextStep => self.next_step(),
            Command::PreviousStep => self.previous_step(),
            Command::GoToStep(step) => self.go_to_step(step),
            Command::NextScene => self.next_scene(),
            Command::PreviousScene => self.previous_scene(),
            Command::OpenScene(place) => self.open_slide(place),
            Command::OpenPlace(place) => return vec![Effect::Open(place)],
            Command::OpenText { name, text } => self.open_text(name, &text),
            Command::OpenLink(link) => self.open_link(&link),
            Command::ChooseFile => return vec![Effect::ChooseFile],
            Command::Paste(text) => return self.paste(&text),
            Command::Resize(size) => self.picture_size = size.max(Pixels::ONE),
            Command::Orbit { at, by } => self.move_camera(at, |camera, side| camera.orbit(by / side)),
            Command::Pan { at, by } => self.move_camera(at, |camera, side| camera.pan(by / side)),
            // A notch of the wheel is ten per cent.
            Command::Zoom { at, by } => self.move_camera(at, |camera, _| camera.zoom(by.ln() * 10.0)),
            Command::Home => self.cameras = Cameras::new(&self.scene.view),
            Command::SetLayout(layout) => self.set_layout(layout),
            Command::NextLayout => self.next_layout(),
            Command::Show { name, is_shown } => self.show_object(name, is_shown),
            Command::ToggleTheme => {
                let theme = if self.theme() == Theme::Dark { Theme::Light } else { Theme::Dark };
                self.edit_view(|view| view.theme = Some(theme));
            }
            Command::ToggleLabels => {
                let labels = !self.scene.view.labels;
                self.edit_view(|view| view.labels = Some(labels));
            }
            Command::TextSize(factor) => {
                self.text_size = if factor > 0.0 { (self.text_size * factor).clamp(0.5, 3.0) } else { 1.0 };
            }
            Command::TogglePresenter => self.shown.presenting = !self.shown.presenting,
            Command::TogglePanel => self.toggle_panel(),
            Command::ToggleSlide => self.shown.slide = !self.shown.slide,
            Command::ToggleAnswer => self.toggle_answer(),
            Command::ToggleCharts => self.shown.charts = !self.shown.charts,
            Command::ToggleHelp => self.shown.help = !self.shown.help,
            Command::ToggleFullscreen => return vec![Effect::ToggleFullscreen],
            Command::Picture { transparent } => return vec![Effect::WritePicture { transparent }],
            Command::Handout => return vec![Effect::WriteHandout],
            Command::CopyCommand => return self.copy_command(),
            Command::CopyLink => return self.copy_link(),
            Command::SaveScene => return self.save(),
            Command::SaveTo(place) => return self.save_to(place),
            Command::SaveNothing => self.shown.saving = None,
            Command::Say(text) => self.say(text),
            Command::FocusPanel => {
                self.shown.presenting = false;
                self.shown.panel = true;
                return vec![Effect::FocusPanel];
            }
        }
        vec![]
    }

    /// Takes a text as the scene, at the step at which it stands.
    fn set(&mut self, file: &SceneFile) -> Result<(), SceneError> {
        let last = file.steps.len().checked_sub(1);
        self.set_at(file, self.scene.at.and_then(|step| Some(step.min(last?))))
    }

    /// Takes a text as the scene and derives everything from it; what is no scene is refused in a sentence, and nothing changes.
    /// A motion that stays the same goes on from where it is.
    fn set_at(&mut self, file: &SceneFile, at: Option<usize>) -> Result<(), SceneError> {
        let mut scene = objects::check_at(file, at)?;
        wear(&mut scene, self.preferred_theme);
        let before = std::mem::replace(&mut self.scene, scene);
        self.scenes += 1;
        let (now, then) = (&self.scene.file, &before.file);
        let is_same_motion = now.body == then.body && now.spin == then.spin;
        if !(is_same_motion && now.motion == then.motion && now.cloud == then.cloud) {
            self.begin(is_same_motion.then(|| self.sim.time()));
        }
        self.preview = None;
        Ok(())
    }

    fn moment(&self) -> Moment {
        let (file, opened) = (self.scene.file.clone(), self.opened.clone());
        Moment { file, opened, at: self.scene.at, time: self.sim.time() }
    }

    fn seen(&self) -> Seen {
        Seen {
            scenes: self.scenes,
            time: self.sim.time(),
            cameras: self.cameras,
            size: self.picture_size,
            glided: self.glided(),
            is_presented: self.shown.presenting,
        }
    }

    fn note_change(&mut self, before: Seen) {
        if self.seen() != before {
            self.revision += 1;
        }
    }
}

/// What a presenter has chosen stays from scene to scene, unless the scene itself sets it.
fn keep_choices(view: &mut ViewFile, before: &ViewFile) {
    view.theme = view.theme.or(before.theme);
    view.labels = view.labels.or(before.labels);
}

/// The theme that the front end prefers, where the scene's file names none.
fn wear(scene: &mut Scene, preferred: Option<Theme>) {
    if let (None, Some(theme)) = (scene.file.view.theme, preferred) {
        scene.view.theme = theme;
    }
}
