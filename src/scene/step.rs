//! A scene told step by step: what each step says, and how the scene is looked at once it is reached.

use super::check::{BODY_CAMERA, SPEEDS, WORLD_CAMERA, check_camera, finite};
use super::{CameraFile, Layout, SceneError, SceneFile, ViewFile};

/// The name that stands for every object in a list of those shown or hidden.
pub const ALL: &str = "all";

/// A step of a scene. What it leaves out stays as it was: in the step before, or in the scene before the first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StepFile {
    /// What it is called, after the scene's title.
    pub title: String,
    /// What is said, in place of the scene's text.
    pub text: String,
    /// Objects shown from here on.
    pub show: Vec<String>,
    /// Objects hidden from here on; what the step shows goes before.
    pub hide: Vec<String>,
    /// Which spaces are shown.
    pub layout: Option<Layout>,
    /// The camera of the world.
    pub world_camera: CameraFile,
    /// The camera of momentum space.
    pub body_camera: CameraFile,
    /// The time (s) that is gone to.
    pub time: Option<f64>,
    /// Simulated seconds a real second.
    pub speed: Option<f64>,
    /// Whether time stands.
    pub pause: Option<bool>,
    /// Whether the clock slows round each flip.
    pub slow_at_flip: Option<bool>,
}

/// How time runs at a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// The time (s) that the steps so far have gone to last, where one has.
    pub time: Option<f64>,
    /// Simulated seconds a real second.
    pub speed: f64,
    /// Whether time stands.
    pub is_paused: bool,
}

/// Where what is seen at a step is written: what both a step and the scene before its first can say.
#[derive(Debug)]
pub struct Written<'a> {
    /// Objects shown.
    pub show: &'a mut Vec<String>,
    /// Objects hidden.
    pub hide: &'a mut Vec<String>,
    /// Which spaces are shown.
    pub layout: &'a mut Option<Layout>,
    /// Whether the clock slows round each flip.
    pub slow_at_flip: &'a mut Option<bool>,
}

impl SceneFile {
    /// Where a change seen from this step on is written: in the step, or in the scene as a whole where it is none.
    pub fn written_at(&mut self, step: Option<usize>) -> Written<'_> {
        if let Some(step) = step.and_then(|step| self.steps.get_mut(step)) {
            let StepFile { show, hide, layout, slow_at_flip, .. } = step;
            Written { show, hide, layout, slow_at_flip }
        } else {
            let ViewFile { show, hide, layout, slow_at_flip, .. } = &mut self.view;
            Written { show, hide, layout, slow_at_flip }
        }
    }

    /// The steps up to this one, counted from 0; none before the first.
    fn steps_to(&self, step: Option<usize>) -> &[StepFile] {
        let count = step.map_or(0, |step| step + 1).min(self.steps.len());
        self.steps.get(..count).unwrap_or_default()
    }

    /// The step at which its telling begins; none where it is shown as a whole.
    #[must_use]
    pub fn first_step(&self) -> Option<usize> {
        (!self.steps.is_empty()).then_some(0)
    }

    /// How the scene is looked at once this step (counted from 0) is reached; as a whole where it is none.
    #[must_use]
    pub fn view_at(&self, step: Option<usize>) -> ViewFile {
        let mut view = self.view.clone();
        for step in self.steps_to(step) {
            step.change(&mut view);
        }
        view
    }

    /// How time runs once this step is reached.
    #[must_use]
    pub fn pace_at(&self, step: Option<usize>) -> Pace {
        let start = Pace { time: None, speed: 1.0, is_paused: false };
        self.steps_to(step).iter().fold(start, |pace, step| Pace {
            time: step.time.or(pace.time),
            speed: step.speed.unwrap_or(pace.speed),
            is_paused: step.pause.unwrap_or(pace.is_paused),
        })
    }

    /// What is said at this step: its text, or that of the last step before that has one, or the scene's.
    #[must_use]
    pub fn text_at(&self, step: Option<usize>) -> &str {
        let said = self.steps_to(step).iter().rev().map(|step| &*step.text).find(|text| !text.trim().is_empty());
        said.unwrap_or(&self.text)
    }

    /// What is seen at this step is called: the scene's title, and after it that of the step, or of the last step before that has one.
    #[must_use]
    pub fn title_at(&self, step: Option<usize>) -> String {
        let of_step = self.steps_to(step).iter().rev().map(|step| step.title.trim()).find(|title| !title.is_empty());
        let titles = [Some(self.title.trim()).filter(|title| !title.is_empty()), of_step];
        titles.into_iter().flatten().collect::<Vec<_>>().join(": ")
    }

    /// Whether the question is asked at this step: at the last one, when all has been shown.
    #[must_use]
    pub fn asks_at(&self, step: Option<usize>) -> bool {
        step.is_none_or(|step| step + 1 >= self.steps.len())
    }
}

impl StepFile {
    /// Checks what it says, but for the names of objects.
    pub(super) fn check(&self) -> Result<(), SceneError> {
        check_camera(&self.world_camera, WORLD_CAMERA)?;
        check_camera(&self.body_camera, BODY_CAMERA)?;
        self.time.map_or(Ok(0.0), |time| finite("time of a step", time))?;
        let speed = self.speed.unwrap_or(1.0);
        if !(SPEEDS.0..=SPEEDS.1).contains(&speed.abs()) {
            let wanted = "between 1/64 and 8, with a minus to run backwards";
            return Err(SceneError::OutOfRange { name: "speed of a step", value: speed, wanted });
        }
        Ok(())
    }

    /// Says what it says over the settings of a view.
    fn change(&self, view: &mut ViewFile) {
        // Names of their own go before that of all.
        for is_all in [true, false] {
            name(&self.hide, is_all, &mut view.hide, &mut view.show);
            name(&self.show, is_all, &mut view.show, &mut view.hide);
        }
        view.layout = self.layout.or(view.layout);
        view.slow_at_flip = self.slow_at_flip.or(view.slow_at_flip);
        view.world_camera = self.world_camera.over(&view.world_camera);
        view.body_camera = self.body_camera.over(&view.body_camera);
    }
}

impl CameraFile {
    /// What this says, and where it says nothing what the other one says.
    #[must_use]
    pub fn over(&self, other: &Self) -> Self {
        Self {
            azimuth_deg: self.azimuth_deg.or(other.azimuth_deg),
            elevation_deg: self.elevation_deg.or(other.elevation_deg),
            distance: self.distance.or(other.distance),
            target: self.target.or(other.target),
        }
    }
}

/// Puts names into a list, and takes them out of its opposite: that of all, which empties the opposite, or the others.
fn name(names: &[String], is_all: bool, list: &mut Vec<String>, opposite: &mut Vec<String>) {
    for name in names.iter().filter(|name| (*name == ALL) == is_all) {
        opposite.retain(|other| !is_all && other != name);
        if !list.contains(name) {
            list.push(name.clone());
        }
    }
}

/// How many steps a scene has, in words.
pub(super) fn steps(count: usize) -> String {
    match count {
        0 => "this scene has no steps".to_owned(),
        1 => "this scene has one step, number 1".to_owned(),
        count => format!("this scene has the steps 1 to {count}"),
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::{CameraFile, Layout, Pace, SceneError, SceneFile};

    #[test]
    fn a_step_leaves_what_it_does_not_say_as_it_was() -> Result<(), SceneError> {
        let file = SceneFile::parse(
            r"
text = 'whole'
question = 'why?'
[view]
show = ['annulus']
azimuth_deg = 3
[[step]]
text = 'one'
hide = ['all']
show = ['body']
layout = 'world'
world_camera = { distance = 2 }
time = 4
speed = 0.25
slow_at_flip = true
[[step]]
show = ['momentum']
world_camera = { azimuth_deg = 7 }
pause = true
[[step]]
text = 'three'
show = ['all']
hide = ['momentum']
layout = 'both'
speed = 1
pause = false",
        )?;
        let names = |step| {
            let view = file.view_at(step);
            format!("{} − {}", view.show.join(" "), view.hide.join(" "))
        };
        assert_eq!(
            [None, Some(0), Some(1), Some(2), Some(9)].map(names),
            ["annulus − ", "body − all", "body momentum − all", "body all − momentum", "body all − momentum"]
        );
        let second = file.view_at(Some(1));
        let camera = CameraFile { azimuth_deg: Some(7.0), distance: Some(2.0), ..CameraFile::default() };
        assert_eq!((second.layout, second.world_camera, second.azimuth_deg), (Some(Layout::World), camera, Some(3.0)));
        assert_eq!((second.slow_at_flip, file.view_at(None).slow_at_flip), (Some(true), None));
        assert_eq!([None, Some(0), Some(1), Some(2)].map(|step| file.text_at(step)), ["whole", "one", "one", "three"]);
        assert_eq!([None, Some(0), Some(1), Some(2)].map(|step| file.asks_at(step)), [true, false, false, true]);
        let pace = |time, speed, is_paused| Pace { time, speed, is_paused };
        assert_eq!(
            [None, Some(0), Some(1), Some(2)].map(|step| file.pace_at(step)),
            [
                pace(None, 1.0, false),
                pace(Some(4.0), 0.25, false),
                pace(Some(4.0), 0.25, true),
                pace(Some(4.0), 1.0, false)
            ]
        );
        Ok(())
    }
}
