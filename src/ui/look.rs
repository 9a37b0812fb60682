//! What the panels see.

use crate::physics::{Method, Motion};
use crate::scene::{Scene, Theme, View};
use crate::sim::{FlipWatch, History, Simulation};

use super::{Pixels, Timeline};

/// Everything that the panels read.
#[derive(Clone, Copy, Debug)]
pub struct Look<'a> {
    /// The running simulation.
    pub sim: &'a Simulation,
    /// Its scene.
    pub scene: &'a Scene,
    /// How it is looked at.
    pub view: &'a View,
    /// The exact motion from the same start.
    pub motion: &'a Motion,
    /// What the methods have strayed so far.
    pub history: &'a History,
    /// The flips seen so far.
    pub flips: &'a FlipWatch,
    /// The flips that come, and how far the scrub bar reaches.
    pub timeline: &'a Timeline,
    /// The ground of the picture, for what is written over it.
    pub ground: egui::Color32,
    /// Colours of the principal axes 1, 2, 3 in the picture.
    pub axis_colors: [egui::Color32; 3],
    /// Colour of a method in the picture.
    pub method_color: fn(&Method, Theme) -> egui::Color32,
    /// Colour of the scene's own method in the picture: that of M.
    pub own_color: egui::Color32,
    /// Everything that can be drawn, and whether it is.
    pub items: fn(&View) -> Vec<Item>,
    /// Where the tip of M is in the picture (pixels), where it can be taken hold of.
    pub tip: Option<Pixels>,
    /// What a click on the sphere would start.
    pub preview: Option<&'a Preview>,
    /// What the open scene is called.
    pub name: &'a str,
    /// Titles of the scenes that can be gone through.
    pub titles: &'a [String],
    /// Which of them is open, if any.
    pub open: Option<usize>,
    /// Simulated seconds a real second, as measured while playing.
    pub real_time_factor: Option<f64>,
    /// What is shown besides the picture.
    pub shown: Shown,
    /// Whether the window fills the screen.
    pub fullscreen: bool,
    /// A sentence for the user about what was last done or refused.
    pub message: Option<&'a str>,
}

impl Look<'_> {
    /// What the scene is called.
    pub(super) fn title(&self) -> &str {
        if self.name.is_empty() { "Own scene" } else { self.name }
    }

    /// A method's colour: as a ghost, or the body's own.
    pub(super) fn color_of(&self, method: &Method) -> egui::Color32 {
        let is_own = method.name == self.scene.method.name;
        if is_own { self.own_color } else { (self.method_color)(method, self.view.theme) }
    }

    /// A method's name in its colour.
    pub(super) fn method_text(&self, method: &Method) -> egui::RichText {
        egui::RichText::new(method.short_label()).color(self.color_of(method))
    }
}

/// Something that can be drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Item {
    /// Name in scene files.
    pub name: &'static str,
    /// Name for people.
    pub label: &'static str,
    /// Drawn in the world, and not in momentum space.
    pub is_of_world: bool,
    /// Whether it is drawn now.
    pub is_shown: bool,
}

/// What is shown besides the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(clippy::struct_excessive_bools, reason = "each is shown or not, whatever the others are")]
pub struct Shown {
    /// The panel and the strip of time.
    pub panel: bool,
    /// The scene's title, text and question.
    pub slide: bool,
    /// The charts.
    pub charts: bool,
    /// The sheet of keys.
    pub help: bool,
}

/// A start on the momentum sphere under the pointer.
#[derive(Clone, Debug, PartialEq)]
pub struct Preview {
    /// Where on the picture (pixels).
    pub at: Pixels,
    /// Its polhode on the picture (pixels), and whether each point is on the near side.
    pub path: Vec<(Pixels, bool)>,
    /// What kind of motion it is.
    pub words: &'static str,
}
