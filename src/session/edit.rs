//! Commands that change the scene, open another one, or keep it.

use glam::DVec3;

use super::command_line::rounded_time;
use super::slides::{Opened, Slide};
use super::undo::{Kind, Moment};
use super::{Effect, Session, command_line, keep_choices, start};
use crate::objects::{self, Cameras};
use crate::physics::{Motion, methods::LOSS_METHOD, so3};
use crate::scene::carried::{self, Saying};
use crate::scene::{SceneFile, SpinFile, ViewFile, link};
use crate::sim::Simulation;
use crate::ui::{Pixels, path_in};
use web_time::Instant;

/// Steps that a change of method or step may take to come back to the same time; past that it starts over.
const MOST_CATCHING_UP: f64 = 2e5;

impl Session {
    /// Changes the scene's text, and says what is wrong with it where it then is no scene.
    pub(super) fn edit(&mut self, change: impl FnOnce(&mut SceneFile)) {
        let mut file = self.scene.file.clone();
        change(&mut file);
        if file != self.scene.file
            && let Err(error) = self.set(&file)
        {
            self.say(error.to_string());
        }
    }

    /// Sets the scene in motion: from its start, or from this time (s) where that is near enough. Paused or running, and how
    /// fast, as before.
    pub(super) fn begin(&mut self, time: Option<f64>) {
        let clock = self.sim.clock;
        self.sim = Simulation::new(&self.scene);
        self.sim.clock = clock;
        self.sim.clock.clear();
        self.motion = Motion::new(&self.scene.body, &self.scene.start);
        self.forget_the_past();
        if let Some(time) = time.filter(|time| self.sim.steps_to(*time) <= MOST_CATCHING_UP) {
            self.sim.go_to(time);
            self.time_was_set();
        }
    }

    /// Another start.
    pub(super) fn set_spin(&mut self, spin: SpinFile) {
        self.edit(|file| file.spin = spin);
    }

    /// A start with this momentum (principal axes, kg m²/s); the attitude stays.
    fn start_with(&mut self, principal: DVec3) {
        let body = &self.scene.body;
        let omega = body.angular_velocity(body.body_from_principal() * principal);
        let attitude = self.scene.file.spin.attitude;
        let spin = SpinFile { omega: Some(omega.to_array()), attitude, ..SpinFile::default() };
        let file = SceneFile { spin, ..self.scene.file.clone() };
        match self.set(&file) {
            Ok(()) => self.restart_time(),
            Err(error) => self.say(error.to_string()),
        }
    }

    fn principal_momentum(&self) -> DVec3 {
        self.scene.body.body_from_principal().transpose() * self.scene.start.body_momentum
    }

    pub(super) fn set_energy(&mut self, energy: f64) {
        match start::with_energy(&self.scene.body, self.principal_momentum(), energy) {
            Some(momentum) => self.start_with(momentum),
            None => self.say("The energy is given by the momentum alone: two moments are equal, or nothing turns."),
        }
    }

    pub(super) fn go_to_separatrix(&mut self) {
        match start::on_separatrix(&self.scene.body, self.principal_momentum()) {
            Some(momentum) => self.start_with(momentum),
            None => self.say("There is no separatrix: two moments are equal, or nothing turns."),
        }
    }

    pub(super) fn poke(&mut self) {
        let poked = start::poked(&self.scene.body, self.sim.state());
        let attitude = so3::quaternion(poked.world_from_body);
        let spin = SpinFile {
            omega: Some(poked.body_angular_velocity(&self.scene.body).to_array()),
            attitude: Some([attitude.w, attitude.x, attitude.y, attitude.z]),
            ..SpinFile::default()
        };
        let file = SceneFile { spin, ..self.scene.file.clone() };
        match self.set(&file) {
            Ok(()) => {
                self.restart_time();
                self.say("Turned by 1° under its momentum: L is the same, and another motion begins here.");
            }
            Err(error) => self.say(error.to_string()),
        }
    }

    /// Loses energy, or none. Where some is lost the method that knows it follows, alone.
    pub(super) fn set_energy_loss(&mut self, loss: f64) {
        self.edit(|file| {
            let motion = &mut file.motion;
            motion.energy_loss = (loss != 0.0).then_some(loss);
            if loss > 0.0 {
                motion.method = motion.method.take().filter(|method| method == LOSS_METHOD);
                motion.compare.clear();
            }
        });
    }

    /// Runs a method beside the scene's own, or no longer.
    pub(super) fn compare(&mut self, method: &str, is_on: bool) {
        // What is the body's own method is no ghost beside it: of the names only those that run are kept.
        let mut compare: Vec<String> = self.scene.compare.iter().map(|other| other.name.to_owned()).collect();
        compare.retain(|other| other != method);
        if is_on {
            compare.push(method.to_owned());
        }
        self.edit(|file| file.motion.compare = compare);
    }

    pub(super) fn pick(&mut self, at: Pixels) {
        if let Some(point) = self.momentum_pane().and_then(|pane| pane.sphere_under(at)) {
            self.start_at(point);
        }
    }

    pub(super) fn drag_tip(&mut self, to: Pixels) {
        if let Some(point) = self.momentum_pane().and_then(|pane| pane.sphere_nearest(to)) {
            self.start_at(point);
        }
    }

    /// A start with the body momentum at this point of the sphere.
    fn start_at(&mut self, point: glam::Vec3) {
        let length = so3::norm(self.scene.start.body_momentum);
        if length > 0.0 {
            self.start_with(point.as_dvec3().normalize() * length);
        }
    }

    pub(super) fn take_back(&mut self) {
        let now = self.moment();
        match self.undo.back(now) {
            Some(moment) => self.return_to(moment),
            None => self.say("There is nothing to take back."),
        }
    }

    pub(super) fn make_again(&mut self) {
        let now = self.moment();
        match self.undo.on(now) {
            Some(moment) => self.return_to(moment),
            None => self.say("There is nothing to make again."),
        }
    }

    fn return_to(&mut self, moment: Moment) {
        let is_other = moment.opened != self.opened || moment.at != self.scene.at;
        if let Err(error) = self.set_at(&moment.file, moment.at) {
            return self.say(error.to_string());
        }
        self.opened = moment.opened;
        if is_other {
            self.cameras = Cameras::new(&self.scene.view);
        }
        if moment.time != self.sim.time() && self.sim.steps_to(moment.time) <= MOST_CATCHING_UP {
            self.sim.go_to(moment.time);
            self.time_was_set();
        }
    }

    pub(super) fn open_slide(&mut self, place: usize) {
        let Some(slide) = self.slides.get(place) else { return };
        let (name, title) = (slide.name.clone(), slide.title());
        // A slide that cannot be shown is gone to all the same: its words say why, and one goes on from there.
        let file = slide.file.clone().unwrap_or_else(|why| SceneFile {
            title: title.clone(),
            text: why,
            ..SceneFile::default()
        });
        self.open(Opened { name, title, file, base: None, place: Some(place) });
    }

    /// Opens what was read at a place: a scene, or a folder of them to go through, followed by those built in.
    pub fn open_slides(&mut self, place: &str, read: Result<Vec<Slide>, String>) {
        let before = self.moment();
        let seen = self.seen();
        match read {
            Err(why) => self.say(why),
            Ok(slides) if slides.len() == 1 && slides[0].name == place => self.open_alone(slides[0].clone()),
            Ok(mut slides) => {
                let count = slides.len();
                slides.extend(super::built_in());
                self.set_slides(slides);
                self.open_slide(0);
                let noun = if count == 1 { "scene" } else { "scenes" };
                self.say(format!("{count} {noun} of {place}"));
            }
        }
        if self.scene.file != before.file {
            self.undo.note(Kind::Whole, before, self.now);
        }
        self.note_change(seen);
    }

    /// What is followed on the disk has changed: what is open of it is opened again where its text is another one, and the list
    /// shows what there is now.
    pub fn refresh(&mut self, place: &str, read: Result<Vec<Slide>, String>, now: Instant) {
        self.now = now;
        let slides = match read {
            Ok(slides) => slides,
            Err(why) => return self.say(why),
        };
        let open = slides.iter().find(|slide| slide.name == self.opened.name).cloned();
        let is_folder = slides.first().is_none_or(|slide| slide.name != place);
        if is_folder || self.slides.iter().any(|slide| slide.name == place) {
            self.set_slides(slides.into_iter().chain(super::built_in()).collect());
        }
        let Some(open) = open else { return };
        match open.file {
            Ok(file) if file != self.opened.file => {
                let (before, seen) = (self.moment(), self.seen());
                let opened = Opened {
                    name: open.name.clone(),
                    title: String::new(),
                    file,
                    base: None,
                    place: self.opened.place,
                };
                let title = Slide { name: open.name.clone(), file: Ok(opened.file.clone()) }.title();
                // Who writes a step sees that step.
                let at = self.scene.at.filter(|step| *step < opened.file.steps.len());
                let at = at.or(opened.file.first_step());
                if self.open_at(Opened { title, ..opened }, at) {
                    self.undo.note(Kind::Whole, before, now);
                    self.say(format!("{} was changed, and read again.", open.name));
                }
                self.note_change(seen);
            }
            Ok(_) => {}
            Err(why) => self.say(format!("{}: {why}", open.name)),
        }
    }

    /// Takes other scenes to go through; the open one stays open, in its new place where it is there.
    pub fn set_slides(&mut self, slides: Vec<Slide>) {
        self.titles = slides.iter().map(Slide::title).collect();
        let is_named = self.opened.base.is_none();
        self.opened.place = slides.iter().position(|slide| is_named && slide.name == self.opened.name);
        self.slides = slides;
    }

    /// A scene that is none of those gone through.
    fn open_alone(&mut self, slide: Slide) {
        let title = slide.title();
        match slide.file {
            Err(why) => self.say(format!("{}: {why}", slide.name)),
            Ok(file) => {
                let place = self.slides.iter().position(|other| other.name == slide.name);
                let name = slide.name.clone();
                if self.open(Opened { name: slide.name, title, file, base: None, place }) {
                    let warning = self.scene.warnings().into_iter().next();
                    self.say(warning.unwrap_or(name));
                }
            }
        }
    }

    pub(super) fn open_text(&mut self, name: String, text: &str) {
        let file = match SceneFile::parse(text).and_then(|file| objects::check(&file).map(|_| file)) {
            Ok(file) => file,
            Err(error) => return self.say(format!("{name}: {error}")),
        };
        self.open_unnamed(name, file);
    }

    /// A scene that came from nowhere with a name.
    fn open_unnamed(&mut self, name: String, file: SceneFile) {
        let slide = Slide { name, file: Ok(file.clone()) };
        // No command line can name it: it is said by what differs from a scene that one can.
        let named = super::built_in().into_iter().find_map(|slide| Some((slide.name, slide.file.ok()?)));
        let Some((name, base)) = named else { return };
        if self.open(Opened { name, title: slide.title(), file, base: Some(base), place: None }) {
            let warning = self.scene.warnings().into_iter().next();
            let words = warning.unwrap_or(slide.name);
            if !words.is_empty() {
                self.say(words);
            }
        }
    }

    /// Opens the scene of a link at its step and its time, running or not as before.
    pub(super) fn open_link(&mut self, words: &str) {
        let checked = link::read(words).and_then(|read| {
            let at = read.step.or(read.file.first_step());
            objects::check_at(&read.file, at).map(|_| (read, at))
        });
        let (read, at) = match checked {
            Ok(checked) => checked,
            Err(error) => return self.say(error.to_string()),
        };
        let is_paused = self.sim.clock.paused;
        match read.name.as_ref().and_then(|name| self.slides.iter().position(|slide| slide.name == *name)) {
            Some(place) => self.open_slide(place),
            None => self.open_unnamed(String::new(), read.file.clone()),
        }
        if let Err(error) = self.set_at(&read.file, at) {
            return self.say(error.to_string());
        }
        self.cameras = Cameras::new(&self.scene.view);
        self.begin_pace();
        if let Some(time) = read.time {
            self.go_to(time);
        }
        self.sim.clock.paused = is_paused;
    }

    /// The link of the scene as it is seen now, from its `#` on.
    #[must_use]
    pub fn link(&self) -> String {
        let name = (self.opened.base.is_none() && !self.slide_is_file()).then_some(self.opened.name.as_str());
        link::write_at(name, &self.file_as_seen(), self.scene.at, Some(rounded_time(self.sim.time())))
    }

    pub(super) fn copy_link(&mut self) -> Vec<Effect> {
        self.say("Copied the link of the scene as it is.");
        vec![Effect::CopyLink(self.link())]
    }

    /// The text of a scene, a link, or a place where one is; anything else is not meant for this program.
    pub(super) fn paste(&mut self, text: &str) -> Vec<Effect> {
        if link::is_link(text.trim()) {
            self.open_link(text.trim());
            return vec![];
        }
        if let Some(place) = path_in(text) {
            return vec![Effect::Open(place)];
        }
        if text.lines().any(|line| line.trim_start().starts_with('[') || line.contains('=')) {
            self.open_text("pasted".to_owned(), text);
        }
        vec![]
    }

    /// The scene as it was opened.
    pub(super) fn reopen(&mut self) {
        self.open(self.opened.clone());
    }

    /// Opens a scene at the beginning of its telling, running at its own pace; false where it is none.
    fn open(&mut self, opened: Opened) -> bool {
        let at = opened.file.first_step();
        self.open_at(opened, at)
    }

    /// The same, at this step.
    fn open_at(&mut self, opened: Opened, at: Option<usize>) -> bool {
        let mut file = opened.file.clone();
        keep_choices(&mut file.view, &self.scene.file.view);
        if let Err(error) = self.set_at(&file, at) {
            self.say(format!("{}: {error}", opened.name));
            return false;
        }
        self.say_nothing();
        self.cameras = Cameras::new(&self.scene.view);
        self.origin = None;
        self.opened = opened;
        self.saved = None;
        self.shown.answer = false;
        self.restart_time();
        self.begin_pace();
        true
    }

    /// The scene's text with the cameras as they are.
    fn file_as_seen(&self) -> SceneFile {
        let mut file = self.scene.file.clone();
        match self.scene.at.and_then(|step| file.steps.get_mut(step)) {
            None => self.cameras.write(&self.scene.view, &mut file.view),
            Some(step) => {
                let mut seen = ViewFile::default();
                self.cameras.write(&self.scene.view, &mut seen);
                step.world_camera = seen.world_camera.over(&step.world_camera);
                step.body_camera = seen.body_camera.over(&step.body_camera);
            }
        }
        file
    }

    pub(super) fn save(&mut self) -> Vec<Effect> {
        let place = match &self.saved {
            Some((place, _)) => Some(place.clone()),
            None => self.slide_is_file().then(|| self.opened.name.clone()),
        };
        match place {
            // The file that it came from is offered first, and not written without a word.
            Some(place) => {
                self.shown.saving = Some(place);
                vec![]
            }
            None => self.save_to(None),
        }
    }

    fn slide_is_file(&self) -> bool {
        Slide { name: self.opened.name.clone(), file: Err(String::new()) }.is_file()
            && self.scene.file.title == self.opened.file.title
    }

    pub(super) fn save_to(&mut self, place: Option<String>) -> Vec<Effect> {
        self.shown.saving = None;
        let file = self.file_as_seen();
        vec![Effect::SaveText { place, text: file.to_toml(), title: file.title }]
    }

    /// The scene was written to a file: from here on a command can name it, whatever is in it.
    pub fn saved(&mut self, place: &str) {
        self.saved = Some((place.to_owned(), self.file_as_seen()));
        self.say(format!("Saved as {place}"));
    }

    /// What the file of a picture of this size says of itself, opened as the scene and the moment that it shows.
    #[must_use]
    pub fn remarks(&self, size: [u32; 2]) -> Vec<(&'static str, String)> {
        let (file, time) = (self.file_as_seen(), command_line::rounded_time(self.sim.time()));
        let title = self.opened.title.trim().to_owned();
        carried::remarks(Saying::Plain, title, &file, self.scene.at, time, self.command(size))
    }

    /// The command that draws this picture with no window, in a picture of this size.
    fn command(&self, size: [u32; 2]) -> String {
        let (name, base) = match &self.saved {
            Some((name, base)) => (name, base),
            None => (&self.opened.name, self.opened.base.as_ref().unwrap_or(&self.opened.file)),
        };
        command_line::shot(name, base, &self.file_as_seen(), self.scene.at, self.sim.time(), size)
    }

    /// Copies that command.
    pub(super) fn copy_command(&mut self) -> Vec<Effect> {
        let line = self.command(self.picture_size.as_uvec2().to_array());
        self.say(format!("Copied: {line}"));
        vec![Effect::CopyText(line)]
    }
}
