//! Commands that change the scene.

use std::path::Path;

use glam::DVec3;

use super::{Base, Session, Slide, keep_choices, title_of};
use crate::app::{files, start};
use crate::objects::Cameras;
use crate::physics::{Motion, so3};
use crate::scene::{Scene, SceneFile, SpinFile};
use crate::sim::Simulation;
use crate::ui::Pixels;

/// Steps that a change of method or step may take to come back to the same time; past that it starts over.
const MOST_CATCHING_UP: f64 = 2e5;

impl Session {
    /// Takes a changed scene where it is a scene, and says what is wrong with it where it is not.
    pub(super) fn edit(&mut self, file: &SceneFile) {
        match Scene::check(file) {
            Ok(scene) => {
                let is_same_motion = scene.file.body == self.scene.file.body && scene.file.spin == self.scene.file.spin;
                let time = self.sim.time();
                self.start(scene);
                if is_same_motion && self.sim.steps_to(time) <= MOST_CATCHING_UP {
                    self.sim.go_to(time);
                    self.time_was_set();
                }
            }
            Err(error) => self.say(error.to_string()),
        }
    }

    /// Sets a scene in motion; paused or running, and how fast, as before.
    fn start(&mut self, scene: Scene) {
        let clock = self.sim.clock;
        self.sim = Simulation::new(&scene);
        self.sim.clock = clock;
        self.sim.clock.clear();
        self.motion = Motion::new(&scene.body, &scene.start);
        self.scene = scene;
        self.forget_the_past();
    }

    /// A start with this momentum (principal axes, kg m²/s); the attitude stays.
    fn start_with(&mut self, principal: DVec3) {
        let body = &self.scene.body;
        let omega = body.angular_velocity(body.body_from_principal() * principal);
        let spin =
            SpinFile { omega: Some(omega.to_array()), attitude: self.scene.file.spin.attitude, ..SpinFile::default() };
        let file = SceneFile { spin, ..self.scene.file.clone() };
        self.begin(&file);
    }

    /// Begins a changed scene at its start.
    fn begin(&mut self, file: &SceneFile) {
        match Scene::check(file) {
            Ok(scene) => self.start(scene),
            Err(error) => self.say(error.to_string()),
        }
    }

    fn principal_momentum(&self) -> DVec3 {
        self.scene.body.body_from_principal().transpose() * self.scene.start.body_momentum
    }

    pub(super) fn set_energy(&mut self, energy: f64) {
        if let Some(momentum) = start::with_energy(&self.scene.body, self.principal_momentum(), energy) {
            self.start_with(momentum);
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
        self.edit(&file);
        self.say("Poked: a new motion begins here, with the same momentum.");
    }

    pub(super) fn pick(&mut self, at: Pixels) {
        if let Some(point) = self.body_pane().and_then(|pane| pane.sphere_under(at)) {
            self.start_at(point);
        }
    }

    pub(super) fn drag_tip(&mut self, to: Pixels) {
        if let Some(point) = self.body_pane().and_then(|pane| pane.sphere_nearest(to)) {
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

    pub(super) fn open_slide(&mut self, index: usize) {
        let Some(slide) = self.slides.get(index) else { return };
        let base = Base { name: slide.name.clone(), file: slide.file.clone() };
        match Scene::check(&base.file) {
            Ok(scene) => {
                self.open_scene(scene);
                self.name.clone_from(&self.titles[index]);
                self.base = base;
                self.open = Some(index);
            }
            Err(error) => self.say(error.to_string()),
        }
    }

    /// Opens what was read of a path: a scene, or a folder of them to go through.
    pub(in crate::app) fn open_files(&mut self, path: &Path, read: Result<Vec<Slide>, String>) {
        let slides = match read {
            Ok(slides) => slides,
            Err(why) => return self.say(why),
        };
        if path.is_dir() {
            self.titles = slides.iter().map(title_of).collect();
            self.slides = slides;
            self.open_slide(0);
            return self.say(format!("{} scenes of {}", self.slides.len(), path.display()));
        }
        let Some(slide) = slides.into_iter().next() else { return };
        match Scene::check(&slide.file) {
            Ok(scene) => {
                let warning = scene.warnings().into_iter().next();
                self.name = title_of(&slide);
                self.base = Base { name: slide.name.clone(), file: slide.file };
                self.open_scene(scene);
                self.open = None;
                self.say(warning.unwrap_or(slide.name));
            }
            Err(error) => self.say(format!("{}: {error}", slide.name)),
        }
    }

    /// The scene as it was opened.
    pub(super) fn reopen(&mut self) {
        match Scene::check(&self.base.file) {
            Ok(scene) => self.open_scene(scene),
            Err(error) => self.say(error.to_string()),
        }
    }

    fn open_scene(&mut self, mut scene: Scene) {
        self.say_nothing();
        keep_choices(&mut scene.view, &mut scene.file, &self.scene.file);
        self.cameras = Cameras::new(&scene.view);
        self.sim.clock.speed = 1.0;
        self.sim.clock.paused = false;
        self.start(scene);
    }

    pub(super) fn save(&mut self) {
        let mut file = self.scene.file.clone();
        self.cameras.write(&self.scene.view, &mut file.view);
        let written = file
            .to_toml()
            .map_err(|error| error.to_string())
            .and_then(|text| files::write_new(&file.title, "toml", text.as_bytes()));
        match written {
            Ok(path) => {
                // From here on a command can name the file, whatever is in it.
                self.base = Base { name: path.display().to_string(), file };
                self.say(format!("Saved as {}", path.display()));
            }
            Err(why) => self.say(why),
        }
    }
}
