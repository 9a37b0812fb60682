//! Commands about how the scene is looked at.

use super::Session;
use super::pick::Pane;
use crate::camera::Camera;
use crate::frame::Area;
use crate::objects::{self, Space, areas};
use crate::scene::{Layout, ViewFile};
use crate::ui::Pixels;

impl Session {
    /// Changes how the scene is looked at.
    pub(super) fn edit_view(&mut self, change: impl FnOnce(&mut ViewFile)) {
        self.edit(|file| change(&mut file.view));
    }

    pub(super) fn next_layout(&mut self) {
        let layout = match self.scene.view.layout {
            Layout::Both => Layout::World,
            Layout::World => Layout::Body,
            Layout::Body => Layout::Both,
        };
        self.set_layout(layout);
    }

    /// Shows these spaces: at a step from there on.
    pub(super) fn set_layout(&mut self, layout: Layout) {
        let at = self.scene.at;
        self.edit(|file| *file.written_at(at).layout = Some(layout));
    }

    /// Shows the panel or hides it; a presenter who asks for it wants the usual window back.
    pub(super) fn toggle_panel(&mut self) {
        let was_presenting = std::mem::take(&mut self.shown.presenting);
        self.shown.panel = was_presenting || !self.shown.panel;
    }

    /// Opens the answer, or closes it again.
    pub(super) fn toggle_answer(&mut self) {
        if self.scene.file.answer.trim().is_empty() {
            self.say("This scene has no answer to show.");
        } else {
            self.shown.answer = !self.shown.answer;
        }
    }

    /// Draws an object, or leaves it out: at a step from there on.
    pub(super) fn show_object(&mut self, name: &'static str, is_shown: bool) {
        let Some(object) = objects::object_named(name) else { return };
        let at = self.scene.at;
        self.edit(|file| {
            let written = file.written_at(at);
            written.show.retain(|shown| shown != name);
            written.hide.retain(|hidden| hidden != name);
            // Named only where it would be otherwise without.
            let Ok(without) = objects::check_at(file, at) else { return };
            if objects::is_shown(object, &without.view) != is_shown {
                let written = file.written_at(at);
                if is_shown { written.show } else { written.hide }.push(name.to_owned());
            }
        });
    }

    /// Moves the camera of the view under a point; it is also told that view's smaller side (pixels).
    pub(super) fn move_camera(&mut self, at: Pixels, change: impl FnOnce(&mut Camera, f32) -> bool) {
        let size = self.picture_size;
        let views = self.areas();
        let found = views.iter().find(|(_, area)| area.contains(at / size)).or(views.first());
        if let Some((space, area)) = found {
            let side = (area.extent * size).min_element().max(1.0);
            if change(self.cameras.of_mut(*space), side) {
                self.preview = None;
            }
        }
    }

    pub(super) fn hover(&mut self, at: Option<Pixels>) {
        self.preview = at.and_then(|at| {
            let pane = self.momentum_pane()?;
            Some(pane.preview(&self.scene.body, pane.sphere_under(at)?))
        });
    }

    /// The view of momentum space, where it is shown.
    pub(super) fn momentum_pane(&self) -> Option<Pane> {
        let (_, area) = self.areas().into_iter().find(|(space, _)| *space == Space::Momentum)?;
        let camera = objects::camera(&self.scene, &self.sim, &self.cameras, Space::Momentum);
        Some(Pane::new(&area, self.picture_size, camera))
    }

    /// Where the tip of M is in the picture, where it is on the near side of the sphere.
    pub(super) fn tip(&self) -> Option<Pixels> {
        let is_drawn = objects::is_shown(&objects::TIP, &self.scene.view);
        let axes = self.scene.body.body_from_principal();
        self.momentum_pane().filter(|_| is_drawn)?.near_side(axes.transpose() * self.sim.state().body_momentum)
    }

    fn areas(&self) -> Vec<(Space, Area)> {
        areas(self.scene.view.layout, self.picture_size.x / self.picture_size.y)
    }
}
