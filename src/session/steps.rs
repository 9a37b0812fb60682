//! Going through a scene that is told in steps, and changing one of them.

use super::time::MOST_STEPS;
use super::{Origin, Session};
use crate::frame::Frame;
use crate::objects::{self, Cameras};
use crate::scene::{Scene, StepFile};
use crate::sim::Simulation;

impl Session {
    /// The scene's steps as pages, with the answer where it is open. Each at its own time, or at this one where it is told as a whole.
    ///
    /// # Errors
    /// A step that is none, or is too far away: one sentence.
    pub fn pages(&self) -> Result<Vec<Frame>, String> {
        let pages = objects::pages(&self.scene.file).map_err(|error| error.to_string())?;
        let frames = pages.iter().map(|scene| {
            let mut simulation = Simulation::new(scene);
            let time = if scene.at.is_none() { self.sim.time() } else { objects::page_time(scene) };
            if simulation.steps_to(time) > MOST_STEPS {
                let time = crate::ui::numbers::significant(time, 4);
                return Err(format!("A page at {time} s is too many steps away: the closed form goes there at once."));
            }
            simulation.go_to(time);
            Ok(objects::build_page(scene, &simulation, self.shown.answer))
        });
        frames.collect()
    }

    /// The next step; after the last the next scene.
    pub(super) fn next_step(&mut self) {
        let next = self.scene.at.map_or(0, |step| step + 1);
        if next < self.scene.file.steps.len() {
            self.go_to_step(next);
        } else {
            self.next_scene();
        }
    }

    /// The step before; before the first the last one of the scene before.
    pub(super) fn previous_step(&mut self) {
        match self.scene.at {
            Some(step) if step > 0 => self.go_to_step(step - 1),
            _ if self.opened.place == Some(0) => {}
            _ => {
                self.previous_scene();
                if let Some(last) = self.scene.file.steps.len().checked_sub(1).filter(|last| *last > 0) {
                    self.go_to_step(last);
                }
            }
        }
    }

    pub(super) fn next_scene(&mut self) {
        self.open_slide(self.opened.place.map_or(0, |place| place + 1));
    }

    pub(super) fn previous_scene(&mut self) {
        // From a scene that is none of them, back is the last.
        self.open_slide(self.opened.place.unwrap_or(self.slides.len()).saturating_sub(1));
    }

    /// Shows a step of the open scene, counted from 0. The motion goes on, unless the step sets its time.
    pub(super) fn go_to_step(&mut self, step: usize) {
        let before = self.scene.clone();
        let seen = match &self.origin {
            Some(origin) => Cameras::between(&origin.cameras, &self.cameras, self.glided()),
            None => self.cameras,
        };
        let file = before.file.clone();
        if let Err(error) = self.set_at(&file, Some(step)) {
            return self.say(error.to_string());
        }
        // A question may name what this step has yet to show.
        self.shown.answer &= self.scene.file.asks_at(Some(step));
        self.origin = self.glides.then(|| Origin { view: before.view.clone(), cameras: seen, begun: self.now });
        self.follow_cameras(&before);
        self.follow_pace(&before);
    }

    /// Turns the cameras that the step sees from elsewhere; the others stay as the user has them.
    fn follow_cameras(&mut self, before: &Scene) {
        let (was, is) = (Cameras::new(&before.view), Cameras::new(&self.scene.view));
        if was.world != is.world {
            self.cameras.world = is.world;
        }
        if was.momentum != is.momentum {
            self.cameras.momentum = is.momentum;
        }
    }

    /// Lets time run as the step says; what it leaves out stays as the user has it.
    fn follow_pace(&mut self, before: &Scene) {
        let step = self.step_file().cloned().unwrap_or_default();
        let (was, is) = (before.file.pace_at(before.at), self.scene.file.pace_at(self.scene.at));
        if was.speed != is.speed || step.speed.is_some() {
            self.sim.clock.speed = is.speed;
            self.jumps += 1;
        }
        if was.is_paused != is.is_paused || step.pause.is_some() {
            self.sim.clock.paused = is.is_paused;
        }
        if let Some(time) = step.time {
            self.go_to(time);
        }
    }

    /// Lets time run as it does at the step at which a scene was opened.
    pub(super) fn begin_pace(&mut self) {
        let pace = self.scene.file.pace_at(self.scene.at);
        self.sim.clock.speed = pace.speed;
        self.sim.clock.paused = pace.is_paused;
        if let Some(time) = pace.time {
            self.go_to(time);
        }
    }

    /// The step at which the scene stands.
    fn step_file(&self) -> Option<&StepFile> {
        self.scene.file.steps.get(self.scene.at?)
    }
}
