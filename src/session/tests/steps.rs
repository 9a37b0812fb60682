//! Scenes told in steps: gone through, changed and answered.

use super::Driven;
use crate::scene::{Layout, SceneError, SceneFile, Theme};
use crate::session::{Effect, Slide};
use crate::ui::{Command, Pixels};

/// A scene told in three steps.
const TOLD: &str = r"
title = 'Told'
text = 'whole'
question = 'why?'
answer = 'because'
[[step]]
text = 'one'
hide = ['all']
show = ['body']
layout = 'world'
time = 2
speed = 0.25
[[step]]
show = ['momentum']
world_camera = { azimuth_deg = 10 }
[[step]]
text = 'three'
layout = 'both'
pause = true
speed = 1
";

#[test]
fn a_scene_is_gone_through_step_by_step_and_then_scene_by_scene() -> Result<(), SceneError> {
    let mut driven = Driven::new("tilt")?;
    let read = |text: &str| SceneFile::parse(text).map_err(|error| error.to_string());
    let slide = |name: &str, text: &str| Slide { name: name.to_owned(), file: read(text) };
    let slides = vec![slide("talk/a.toml", TOLD), slide("talk/b.toml", "title = 'B'")];
    driven.session.open_slides("talk", Ok(slides));
    let at = |driven: &Driven| (driven.session.opened.place, driven.session.scene.at);
    assert_eq!(at(&driven), (Some(0), Some(0)));
    assert_eq!((driven.session.time(), driven.session.sim.clock.speed), (2.0, 0.25));
    assert_eq!(driven.session.scene.view.layout, Layout::World);
    // What a step leaves out stays: the time that runs, the camera that was turned.
    driven.run(0.4);
    driven.apply(Command::Orbit { at: Pixels::new(10.0, 10.0), by: Pixels::new(30.0, 0.0) });
    let turned = driven.session.cameras;
    driven.apply(Command::NextStep);
    assert_eq!(at(&driven), (Some(0), Some(1)));
    assert!((driven.session.time() - 2.1).abs() < 0.0011, "{}", driven.session.time());
    assert!((driven.session.cameras.world.azimuth.to_degrees() - 10.0).abs() < 1e-3);
    assert_eq!(driven.session.cameras.momentum, turned.momentum);
    driven.apply(Command::NextStep);
    assert_eq!((at(&driven), driven.session.is_playing()), ((Some(0), Some(2)), false));
    assert_eq!(driven.session.sim.clock.speed, 1.0);
    driven.apply(Command::NextStep);
    assert_eq!((at(&driven), driven.session.is_playing()), ((Some(1), None), true));
    // Back to where one came from.
    driven.apply(Command::PreviousStep);
    assert_eq!(at(&driven), (Some(0), Some(2)));
    driven.apply(Command::PreviousStep);
    driven.apply(Command::PreviousStep);
    assert_eq!((at(&driven), driven.session.time(), driven.session.is_playing()), ((Some(0), Some(0)), 2.0, true));
    driven.apply(Command::PreviousStep);
    assert_eq!(at(&driven), (Some(0), Some(0)));
    driven.apply(Command::GoToStep(1));
    driven.apply(Command::GoToStep(7));
    assert_eq!(
        (at(&driven), driven.message()),
        ((Some(0), Some(1)), "step 8 does not exist: this scene has the steps 1 to 3")
    );
    driven.apply(Command::NextScene);
    driven.apply(Command::PreviousScene);
    assert_eq!(at(&driven), (Some(0), Some(0)));
    // Who writes a step sees that step.
    driven.apply(Command::GoToStep(2));
    let changed = TOLD.replace("'three'", "'drei'");
    driven.session.refresh("talk", Ok(vec![slide("talk/a.toml", &changed)]), driven.now);
    assert_eq!((at(&driven), driven.file().text_at(Some(2))), ((Some(0), Some(2)), "drei"));
    Ok(())
}

#[test]
fn what_is_changed_at_a_step_is_that_steps() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::OpenText { name: "told".to_owned(), text: TOLD.to_owned() });
    let before = driven.file().clone();
    driven.apply(Command::GoToStep(1));
    driven.apply(Command::Show { name: "momentum", is_shown: false });
    driven.apply(Command::Show { name: "shadow", is_shown: true });
    driven.apply(Command::SetLayout(Layout::Body));
    driven.apply(Command::ToggleTheme);
    let file = driven.file();
    assert_eq!((&file.steps[0], &file.steps[2]), (&before.steps[0], &before.steps[2]));
    // The step alone showed it: there it is no longer named at all.
    assert_eq!((&file.steps[1].show[..], &file.steps[1].hide[..]), (&["shadow".to_owned()][..], &[][..]));
    assert_eq!((file.steps[1].layout, file.view.theme), (Some(Layout::Body), Some(Theme::Light)));
    driven.apply(Command::Show { name: "body", is_shown: false });
    assert_eq!(driven.file().steps[1].hide, ["body"]);
    driven.apply(Command::Zoom { at: Pixels::new(10.0, 10.0), by: 1.1 });
    let copied = driven.apply(Command::CopyCommand);
    assert!(matches!(&copied[..], [Effect::CopyText(line)] if line.contains(" --scene-step 2 ")), "{copied:?}");
    let saved = driven.apply(Command::SaveTo(None));
    let [Effect::SaveText { text, .. }] = &saved[..] else { return Err(SceneError::NotTaken(format!("{saved:?}"))) };
    let read = SceneFile::parse(text)?;
    assert!(read.steps[1].body_camera.distance.is_some() && read.view.body_camera.distance.is_none());
    // What is taken back is seen where it was changed.
    driven.apply(Command::GoToStep(2));
    driven.apply(Command::Undo);
    assert_eq!((driven.session.scene.at, driven.file().steps[1].hide.len()), (Some(1), 0));
    Ok(())
}

#[test]
fn the_picture_glides_to_a_step_also_while_time_stands() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::OpenText { name: "told".to_owned(), text: TOLD.to_owned() });
    driven.apply(Command::PlayPause);
    assert!(!driven.session.is_moving());
    let eye = |driven: &Driven| driven.session.frame(2.0).panes.first().map(|pane| pane.camera.azimuth.to_degrees());
    let before = eye(&driven).unwrap_or_default();
    driven.apply(Command::NextStep);
    assert!(driven.session.is_moving() && eye(&driven) == Some(before));
    let revision = driven.session.revision();
    driven.run(0.25);
    let half = eye(&driven).unwrap_or_default();
    // From 300° the shorter way to 10°.
    assert!((half - 335.0).abs() < 2.0 && driven.session.revision() > revision, "{before} {half}");
    driven.run(0.3);
    assert!(!driven.session.is_moving() && (eye(&driven).unwrap_or_default() - 10.0).abs() < 1e-3);
    let revision = driven.session.revision();
    driven.run(0.1);
    assert_eq!(driven.session.revision(), revision);
    // What has glided there is what is there at once.
    let glided = driven.session.frame(2.0);
    driven.session.set_gliding(false);
    driven.apply(Command::PreviousStep);
    assert!((eye(&driven).unwrap_or_default() - before).abs() < 1e-3);
    driven.apply(Command::NextStep);
    assert!(driven.session.frame(2.0) == glided);
    Ok(())
}

#[test]
fn an_answer_is_shown_when_it_is_asked_for() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::OpenText { name: "told".to_owned(), text: TOLD.to_owned() });
    assert!(!driven.session.shown.answer);
    driven.apply(Command::ToggleAnswer);
    assert!(driven.session.shown.answer);
    driven.apply(Command::NextScene);
    assert!(!driven.session.shown.answer);
    // At the last step it stays open; one before has yet to show what it names.
    driven.apply(Command::OpenText { name: "told".to_owned(), text: TOLD.to_owned() });
    driven.apply(Command::ToggleAnswer);
    driven.apply(Command::GoToStep(2));
    assert!(driven.session.shown.answer);
    driven.apply(Command::PreviousStep);
    assert!(!driven.session.shown.answer);
    driven.apply(Command::OpenText { name: "bare".to_owned(), text: "title = 'Bare'".to_owned() });
    driven.apply(Command::ToggleAnswer);
    assert!(!driven.session.shown.answer && driven.message().contains("no answer"), "{}", driven.message());
    Ok(())
}

#[test]
fn a_picture_opens_at_what_it_shows() -> Result<(), SceneError> {
    let mut driven = Driven::new("tilt")?;
    let slide = Slide { name: "told.png".to_owned(), file: Ok(SceneFile::parse(TOLD)?) };
    assert!(!slide.is_file());
    driven.session.open_slides("told.png", Ok(vec![slide]));
    for (step, layout, azimuth) in
        [(None, Layout::Both, None), (Some(0), Layout::World, None), (Some(1), Layout::World, Some(10.0))]
    {
        driven.apply(Command::Orbit { at: Pixels::new(10.0, 10.0), by: Pixels::new(30.0, 0.0) });
        driven.session.show_moment(step, -1.5);
        assert_eq!((driven.session.scene.at, driven.session.time(), driven.session.is_playing()), (step, -1.5, false));
        assert_eq!(driven.session.scene.view.layout, layout);
        if let Some(azimuth) = azimuth {
            assert!((driven.session.cameras.world.azimuth.to_degrees() - azimuth).abs() < 1e-3);
        }
        assert_eq!(driven.session.cameras, crate::objects::Cameras::new(&driven.session.scene.view));
    }
    Ok(())
}

#[test]
fn a_handout_has_a_page_a_step_and_the_answer_where_it_is_open() -> Result<(), SceneError> {
    let mut driven = Driven::new("tilt")?;
    driven.apply(Command::OpenText { name: "told.toml".to_owned(), text: TOLD.to_owned() });
    assert_eq!(driven.apply(Command::Handout), [Effect::WriteHandout]);
    let said = |driven: &Driven| -> Vec<String> {
        let pages = driven.session.pages().unwrap_or_default();
        let words = |page: &crate::frame::Frame| {
            let notes = page.panes.iter().flat_map(|pane| &pane.notes);
            notes.map(|note| note.text.as_str()).collect::<Vec<_>>().join("|")
        };
        pages.iter().map(words).collect()
    };
    let pages = said(&driven);
    assert_eq!(pages.len(), 3);
    assert!(pages[0].contains("one") && pages[1].contains("one") && pages[2].contains("three"), "{pages:?}");
    // The first step says its time, which holds until another one does.
    assert!(pages.iter().all(|page| page.contains("t = 2.00")), "{pages:?}");
    assert!(pages[2].contains("why?") && !pages[1].contains("why?") && !pages[2].contains("because"), "{pages:?}");
    driven.apply(Command::ToggleAnswer);
    assert!(said(&driven)[2].contains("because"));
    Ok(())
}

/// A step's own words hold also where they are those of the step before; what it leaves out is as it was told last.
#[test]
fn a_step_says_how_time_runs_whatever_was_done_before() -> Result<(), SceneError> {
    let text = "[[step]]\ntext = 'a'\n[[step]]\npause = true\nspeed = 0.5\n[[step]]\npause = true\nspeed = 0.5\n[[step]]\ntext = 'd'";
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::OpenText { name: "pace".to_owned(), text: text.to_owned() });
    let pace = |driven: &Driven| (driven.session.sim.clock.paused, driven.session.sim.clock.speed);
    driven.apply(Command::GoToStep(1));
    assert_eq!(pace(&driven), (true, 0.5));
    driven.apply(Command::PlayPause);
    driven.apply(Command::SetSpeed(2.0));
    driven.apply(Command::GoToStep(2));
    assert_eq!(pace(&driven), (true, 0.5));
    // The next one leaves it out: so it stays, as the user has it.
    driven.apply(Command::PlayPause);
    driven.apply(Command::SetSpeed(2.0));
    driven.apply(Command::GoToStep(3));
    assert_eq!(pace(&driven), (false, 2.0));
    // Back at the first, which nothing was said before.
    driven.apply(Command::GoToStep(1));
    driven.apply(Command::GoToStep(0));
    assert_eq!(pace(&driven), (false, 1.0));
    Ok(())
}
