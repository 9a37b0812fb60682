//! What the panels see.

use egui::Color32;

use crate::frame::{Color, PlacedName};
use crate::objects::{self, Palette};
use crate::physics::{Method, Motion};
use crate::scene::{Scene, SceneFile, TimeUnit};
use crate::sim::{FlipWatch, History, Simulation};

use super::{Pixels, Timeline, numbers};

/// Everything that the panels read.
#[derive(Clone, Copy, Debug)]
pub struct Look<'a> {
    /// The running simulation.
    pub sim: &'a Simulation,
    /// The scene.
    pub scene: &'a Scene,
    /// The scene's text as it was opened.
    pub opened: &'a SceneFile,
    /// The exact motion from the same start.
    pub motion: &'a Motion,
    /// What the methods have strayed so far.
    pub history: &'a History,
    /// The flips seen so far.
    pub flips: &'a FlipWatch,
    /// The flips that come, and how far the scrub bar reaches.
    pub timeline: &'a Timeline,
    /// How fast the clock runs beside its own speed: below 1 in slow motion.
    pub slowed: f64,
    /// Whether one flip is run through again and again.
    pub is_looping: bool,
    /// Where the tip of M is in the picture (pixels), where it can be taken hold of.
    pub tip: Option<Pixels>,
    /// The labels of the picture, where they stand.
    pub names: &'a [PlacedName],
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
    pub shown: &'a Shown,
    /// Whether a change can be taken back, and whether one can be made again.
    pub can_undo: (bool, bool),
    /// Whether the window fills the screen.
    pub fullscreen: bool,
    /// What all this is shown by.
    pub front: Front,
    /// A sentence for the user about what was last done or refused.
    pub message: Option<&'a str>,
}

impl Look<'_> {
    /// What the scene is called.
    pub(super) fn title(&self) -> &str {
        if self.name.is_empty() { "Own scene" } else { self.name }
    }

    /// Whether body, start or method are no longer those that the scene's words speak of.
    #[must_use]
    pub fn is_edited(&self) -> bool {
        let (now, then) = (&self.scene.file, self.opened);
        now.body != then.body || now.spin != then.spin || now.motion != then.motion
    }

    /// Whether energy is lost inside the body, of which the exact motion and what is predicted from it know nothing.
    pub(super) fn loses_energy(&self) -> bool {
        self.scene.energy_loss > 0.0
    }

    /// The sign of the scene's unit of time.
    pub(super) fn time_unit(&self) -> &'static str {
        self.scene.view.time_unit.sign()
    }

    /// Which step of the scene it is, where it is told in steps.
    pub(super) fn step_words(&self) -> Option<String> {
        let count = self.scene.file.steps.len();
        self.scene.at.map(|step| format!("step {} of {count}", step + 1))
    }

    /// That the clock runs slowly, where it does.
    pub(super) fn slow_words(&self) -> Option<String> {
        // Two digits: it changes all the time.
        (self.slowed < 0.995).then(|| format!("slow motion {:.2}×", self.slowed))
    }

    /// Factor on the size of the scene's words.
    pub(super) fn words_scale(&self) -> f32 {
        if self.shown.presenting { super::presenter::LARGER } else { 1.0 }
    }

    /// The unit of energies, with a space before it.
    pub(super) fn energy_unit(&self) -> &'static str {
        match self.scene.view.time_unit {
            TimeUnit::Second => " J",
            TimeUnit::Day => " kg m²/d²",
        }
    }

    /// A length of the scene's time in words.
    pub(super) fn duration(&self, time: f64) -> String {
        match self.scene.view.time_unit {
            TimeUnit::Second => numbers::duration(time),
            TimeUnit::Day if time.abs() < 1000.0 => format!("{time:.1} d").replace('-', "−"),
            TimeUnit::Day => numbers::duration(time * numbers::DAY),
        }
    }

    /// The colours of the picture.
    fn palette(&self) -> Palette {
        Palette::new(self.scene.view.theme)
    }

    /// The ground of the picture, for what is written over it.
    pub(super) fn ground(&self) -> Color32 {
        drawn(self.palette().background)
    }

    /// Colours of the principal axes 1, 2, 3 in the picture.
    pub(super) fn axis_colors(&self) -> [Color32; 3] {
        self.palette().axes.map(drawn)
    }

    /// A method's colour: as a ghost, or the body's own, which is that of M.
    pub(super) fn color_of(&self, method: &Method) -> Color32 {
        let is_own = *method == *self.scene.method;
        let color = if is_own { self.palette().momentum } else { objects::method_color(method, self.scene.view.theme) };
        drawn(color)
    }

    /// A method's name in its colour.
    pub(super) fn method_text(&self, method: &Method) -> egui::RichText {
        egui::RichText::new(method.short_label()).color(self.color_of(method))
    }
}

/// A colour of the picture, as the panels draw colours.
fn drawn(color: Color) -> Color32 {
    let [r, g, b, _] = color.0.map(|channel| (channel * 255.0).round() as u8);
    Color32::from_rgb(r, g, b)
}

/// What the panels are shown by: only what it can do is offered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Front {
    /// A window of its own, with files around it.
    #[default]
    Window,
    /// A page in a browser, which has keys of its own, downloads and an address.
    Page,
}

/// What is shown besides the picture.
#[derive(Clone, Debug, PartialEq, Eq)]
#[allow(clippy::struct_excessive_bools, reason = "each is shown or not, whatever the others are")]
pub struct Shown {
    /// Large words and a slim strip, and no panel: presenter's mode.
    pub presenting: bool,
    /// The panel and the strip of time.
    pub panel: bool,
    /// The scene's title, text and question.
    pub slide: bool,
    /// The answer to the scene's question.
    pub answer: bool,
    /// The charts.
    pub charts: bool,
    /// The field for a time to go to.
    pub asking_time: bool,
    /// The sheet of keys.
    pub help: bool,
    /// Whether all this is part of another page: without the panel, time is there only for as long as someone points.
    pub embedded: bool,
    /// The file about which it is asked whether the scene is to be written there.
    pub saving: Option<String>,
}

impl Shown {
    /// As it was the last time, with nothing asked.
    #[must_use]
    pub fn remembered(panel: bool, slide: bool, charts: bool) -> Self {
        Self {
            presenting: false,
            panel,
            slide,
            charts,
            answer: false,
            asking_time: false,
            help: false,
            embedded: false,
            saving: None,
        }
    }
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
