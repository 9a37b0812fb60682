//! What is kept of changes, scenes and files, and what the panels are told of it.

use web_time::Duration;

use super::Driven;
use crate::scene::{Layout, SceneError, SceneFile, Theme};
use crate::session::{Effect, Slide, built_in};
use crate::ui::{Command, Pixels};

fn slide(name: &str, text: &str) -> Slide {
    Slide { name: name.to_owned(), file: SceneFile::parse(text).map_err(|error| error.to_string()) }
}

#[test]
fn two_hundred_changes_are_kept_and_no_more() -> Result<(), SceneError> {
    for (changes, kept) in [(199, 199), (200, 200), (203, 200)] {
        let mut driven = Driven::new("flip")?;
        for change in 0..changes {
            driven.apply(Command::SetMethod(["buss", "rk4"][change % 2]));
        }
        let mut taken_back = 0;
        while driven.session.look(None, false).can_undo.0 {
            driven.apply(Command::Undo);
            taken_back += 1;
        }
        assert_eq!(taken_back, kept);
    }
    Ok(())
}

#[test]
fn what_can_be_taken_back_and_made_again_is_shown() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let can = |driven: &Driven| driven.session.look(None, false).can_undo;
    assert_eq!(can(&driven), (false, false));
    driven.apply(Command::SetMethod("rk4"));
    assert_eq!(can(&driven), (true, false));
    driven.apply(Command::SetMethod("buss"));
    driven.apply(Command::Undo);
    assert_eq!(can(&driven), (true, true));
    driven.apply(Command::Undo);
    assert_eq!(can(&driven), (false, true));
    // Another change, and what was taken back is gone.
    driven.apply(Command::SetMethod("lie-euler"));
    assert_eq!(can(&driven), (true, false));
    Ok(())
}

#[test]
fn changes_of_one_kind_are_one_only_while_they_follow_closely() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let tilt = |driven: &Driven| driven.file().spin.tilt_deg;
    let first = tilt(&driven);
    for (pause, value) in [(1000, 10.0), (799, 11.0), (801, 12.0), (100, 13.0)] {
        driven.now += Duration::from_millis(pause);
        driven.session.apply(Command::SetTilt(value), driven.now);
    }
    // Another kind ends it, and so does taking back.
    driven.session.apply(Command::SetRate(2.0), driven.now);
    driven.session.apply(Command::SetTilt(14.0), driven.now);
    for (wanted, rate) in [(Some(13.0), 2.0), (Some(13.0), 8.0), (Some(11.0), 8.0), (first, 8.0)] {
        driven.session.apply(Command::Undo, driven.now);
        let before = driven.file().spin.rate == Some(2.0);
        assert_eq!((tilt(&driven), before), (wanted, rate == 2.0));
    }
    driven.session.apply(Command::SetTilt(20.0), driven.now);
    driven.session.apply(Command::Undo, driven.now);
    driven.session.apply(Command::SetTilt(21.0), driven.now);
    driven.session.apply(Command::Undo, driven.now);
    assert_eq!(tilt(&driven), first);
    Ok(())
}

#[test]
fn a_change_that_is_taken_back_brings_back_its_time() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::PlayPause);
    driven.apply(Command::GoTo(1.25));
    driven.apply(Command::SetRate(2.0));
    assert_eq!(driven.session.time(), 0.0, "another motion begins at its start");
    driven.apply(Command::Undo);
    assert_eq!(driven.session.time(), 1.25);
    // Where it is that time already nothing jumps.
    driven.apply(Command::ToggleTheme);
    let jumps = driven.session.jumps();
    driven.apply(Command::Undo);
    assert_eq!((driven.session.time(), driven.session.jumps()), (1.25, jumps));
    // One that is too many steps away is not caught up with.
    driven.apply(Command::SetMethod("closed-form"));
    driven.apply(Command::GoTo(1e6));
    driven.apply(Command::SetMethod("buss"));
    assert_eq!(driven.session.time(), 0.0);
    driven.apply(Command::SetMethod("closed-form"));
    driven.apply(Command::GoTo(150.0));
    driven.apply(Command::SetMethod("buss"));
    assert_eq!(driven.session.time(), 150.0, "150 000 steps of 1 ms are caught up with");
    Ok(())
}

#[test]
fn a_scene_that_is_left_and_come_back_to_by_undo_has_its_own_cameras() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let own = driven.session.cameras;
    driven.apply(Command::Orbit { at: Pixels::new(100.0, 100.0), by: Pixels::new(40.0, 0.0) });
    let turned = driven.session.cameras;
    assert_ne!(own, turned);
    driven.apply(Command::SetRate(2.0));
    driven.apply(Command::Undo);
    assert_eq!(driven.session.cameras, turned, "the same scene is seen from where one was");
    driven.apply(Command::NextScene);
    driven.apply(Command::Undo);
    assert_eq!(driven.session.cameras, own);

    // Another scene with no steps, as this is none of them; and another step of the same scene.
    let plain = [slide("a.toml", "title = 'A'"), slide("b.toml", "[view]\nworld_camera = { azimuth_deg = 10 }")];
    let told = slide("told.toml", "[[step]]\ntext = 'one'\n[[step]]\nworld_camera = { azimuth_deg = 10 }");
    for (place, slides, there) in [("plain", plain.to_vec(), 1), ("told", vec![told], 0)] {
        driven.session.open_slides(place, Ok(slides));
        let own = driven.session.cameras;
        driven.apply(Command::Orbit { at: Pixels::new(100.0, 100.0), by: Pixels::new(40.0, 0.0) });
        driven.apply(Command::NextStep);
        assert_eq!(driven.session.opened.place, Some(there), "{place}");
        driven.apply(Command::Undo);
        assert_eq!((driven.session.opened.place, driven.session.cameras), (Some(0), own), "{place}");
    }
    Ok(())
}

#[test]
fn the_switches_of_the_panels_switch() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let shown = |driven: &Driven| {
        let shown = driven.session.look(None, false).shown;
        [shown.panel, shown.slide, shown.charts, shown.help, shown.answer]
    };
    let mut before = shown(&driven);
    assert_eq!(before, [true, true, false, false, false]);
    driven.open_answered();
    let commands =
        [Command::TogglePanel, Command::ToggleSlide, Command::ToggleCharts, Command::ToggleHelp, Command::ToggleAnswer];
    for (index, command) in commands.into_iter().enumerate() {
        for _ in 0..2 {
            driven.apply(command.clone());
            before[index] = !before[index];
            assert_eq!(shown(&driven), before, "{command:?}");
        }
    }
    driven.apply(Command::TogglePanel);
    driven.apply(Command::FocusPanel);
    assert!(shown(&driven)[0]);
    // Text between half and three times its size, and back to its own.
    for (factor, size) in [(1.5, 1.5), (10.0, 3.0), (0.01, 0.5), (0.0, 1.0), (-1.0, 1.0)] {
        driven.apply(Command::TextSize(factor));
        assert_eq!(driven.session.text_size(), size);
    }
    Ok(())
}

impl Driven {
    fn open_answered(&mut self) {
        let text = "title = 'T'\nquestion = 'Why?'\nanswer = 'Because.'".to_owned();
        self.apply(Command::OpenText { name: "t.toml".to_owned(), text });
    }
}

#[test]
fn a_folder_of_one_scene_is_a_folder_and_a_file_is_itself() -> Result<(), SceneError> {
    let mut driven = Driven::new("tilt")?;
    driven.session.open_slides("talk", Ok(vec![slide("talk/a.toml", "title = 'A'")]));
    assert_eq!((driven.session.title(), driven.message()), ("A", "1 scene of talk"));
    assert_eq!((driven.session.slides.len(), driven.session.opened.place), (1 + built_in().len(), Some(0)));
    driven.session.open_slides("b.toml", Ok(vec![slide("b.toml", "title = 'B'")]));
    assert_eq!((driven.session.title(), driven.message()), ("B", "b.toml"));
    assert_eq!((driven.session.slides.len(), driven.session.opened.place), (1 + built_in().len(), None));
    // Both can be taken back, one after the other.
    driven.apply(Command::Undo);
    assert_eq!(driven.session.title(), "A");
    driven.apply(Command::Undo);
    assert_eq!(driven.session.opened.name, "tilt");
    // A broken file says why, and nothing else happens.
    driven.session.open_slides("c.toml", Ok(vec![slide("c.toml", "titel = 3")]));
    assert!(driven.message().starts_with("c.toml: ") && driven.session.opened.name == "tilt", "{}", driven.message());
    Ok(())
}

#[test]
fn a_changed_file_brings_its_title_and_keeps_its_step() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let steps = |count: usize| "\n[[step]]\ntext = 's'".repeat(count);
    driven.session.open_slides("talk", Ok(vec![slide("talk/a.toml", &format!("title = 'One'{}", steps(3)))]));
    driven.apply(Command::GoToStep(1));
    let changed = |title: &str, count| vec![slide("talk/a.toml", &format!("title = '{title}'{}", steps(count)))];
    driven.session.refresh("talk", Ok(changed("Two", 3)), driven.now);
    assert_eq!((driven.session.title(), driven.session.scene.at), ("Two", Some(1)));
    // A step that is gone is not stood at.
    driven.session.refresh("talk", Ok(changed("Three", 1)), driven.now);
    assert_eq!((driven.session.title(), driven.session.scene.at), ("Three", Some(0)));
    driven.apply(Command::Undo);
    assert_eq!(driven.session.title(), "Two");
    // What has not changed is left alone, with what was done to it.
    driven.apply(Command::Redo);
    driven.apply(Command::SetRate(3.5));
    driven.session.refresh("talk", Ok(changed("Three", 1)), driven.now);
    assert_eq!(driven.file().spin.rate, Some(3.5));
    // A single file that is followed, and is none of those gone through, leaves the list alone.
    let titles = driven.session.titles.clone();
    driven.session.refresh("elsewhere.toml", Ok(vec![slide("elsewhere.toml", "title = 'E'")]), driven.now);
    assert_eq!((driven.session.title(), &driven.session.titles), ("Three", &titles));
    Ok(())
}

/// What a folder gains does not move what is open to another scene.
#[test]
fn a_folder_that_changes_keeps_the_place() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let folder = |names: &[&str]| Ok(names.iter().map(|name| slide(&format!("talk/{name}.toml"), "")).collect());
    driven.session.open_slides("talk", folder(&["b", "d"]));
    driven.apply(Command::NextScene);
    driven.session.refresh("talk", folder(&["a", "b", "c", "d"]), driven.now);
    assert_eq!((driven.session.opened.name.as_str(), driven.session.opened.place), ("talk/d.toml", Some(3)));
    driven.apply(Command::PreviousScene);
    assert_eq!(driven.session.opened.name, "talk/c.toml");
    // What is open and gone from the folder has no place in it.
    driven.session.refresh("talk", folder(&["a", "b"]), driven.now);
    assert_eq!((driven.session.opened.name.as_str(), driven.session.opened.place), ("talk/c.toml", None));
    Ok(())
}

#[test]
fn what_is_pasted_is_a_scene_a_place_or_nothing() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::Paste("[spin]\nrate = 3.25".to_owned()));
    assert_eq!((driven.file().spin.rate, driven.message()), (Some(3.25), "pasted"));
    driven.apply(Command::Paste("title = 'only'".to_owned()));
    assert_eq!(driven.session.title(), "only");
    driven.session.say_nothing();
    let before = driven.file().clone();
    driven.apply(Command::Paste("a line of a letter".to_owned()));
    assert_eq!((driven.file(), driven.message()), (&before, ""));
    Ok(())
}

#[test]
fn a_step_is_changed_where_one_stands() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let text = "title = 'T'\n[[step]]\ntext = 'a'\n[[step]]\ntext = 'b'\n[[step]]\ntext = 'c'".to_owned();
    driven.apply(Command::OpenText { name: "t.toml".to_owned(), text });
    driven.apply(Command::GoToStep(1));
    driven.apply(Command::SetLayout(Layout::Body));
    driven.apply(Command::Show { name: "body", is_shown: false });
    let file = driven.file();
    assert_eq!((file.steps[0].layout, file.steps[1].layout, file.view.layout), (None, Some(Layout::Body), None));
    assert_eq!((file.steps[1].hide.as_slice(), file.view.hide.len()), (["body".to_owned()].as_slice(), 0));
    // Shown again it needs no word.
    driven.apply(Command::Show { name: "body", is_shown: true });
    assert_eq!((driven.file().steps[1].hide.len(), driven.file().steps[1].show.len()), (0, 0));
    // The cameras are kept at the step.
    driven.apply(Command::Orbit { at: Pixels::new(100.0, 100.0), by: Pixels::new(40.0, 10.0) });
    let effects = driven.apply(Command::SaveScene);
    let [Effect::SaveText { text, .. }] = effects.as_slice() else {
        return Err(SceneError::NotAScene { line: 0, message: format!("{effects:?}") });
    };
    let written = SceneFile::parse(text)?;
    let (step, whole) = (&written.steps[1], &written.view);
    assert!(step.body_camera.azimuth_deg.is_some() || step.world_camera.azimuth_deg.is_some(), "{step:?}");
    assert!(whole.world_camera.azimuth_deg.is_none() && whole.body_camera.azimuth_deg.is_none(), "{whole:?}");
    Ok(())
}

#[test]
fn a_message_stays_as_long_as_it_takes_to_read() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    for (text, milliseconds) in [("", 3000), ("ten-letter", 3600), ("ä→ω", 3180)] {
        driven.session.say(text);
        let ends = driven.session.message_ends().map(|end| end.duration_since(driven.session.now));
        assert_eq!(ends, Some(Duration::from_millis(milliseconds)));
        driven.now = driven.session.now + Duration::from_millis(milliseconds - 1);
        driven.session.advance(0.0, driven.now);
        assert_eq!(driven.message(), text);
        driven.now += Duration::from_millis(1);
        driven.session.advance(0.0, driven.now);
        assert!(driven.session.message_ends().is_none());
    }
    Ok(())
}

#[test]
fn every_change_can_be_taken_back_and_made_again() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::Undo);
    assert!(driven.message().contains("nothing to take back"));
    let mut states = vec![(driven.session.title().to_owned(), driven.file().clone())];
    for command in [
        Command::SpinAxis(1),
        Command::SetMethod("rk4"),
        Command::Compare { method: "buss", is_on: true },
        Command::ToggleTheme,
        Command::Show { name: "herpolhode", is_shown: true },
        Command::SetLayout(Layout::World),
        Command::NextScene,
        Command::SetRate(1.0),
        Command::Reopen,
        Command::OpenScene(4),
        Command::Paste("title = \"mine\"\n[spin]\nrate = 3.0".to_owned()),
    ] {
        driven.apply(command.clone());
        let now = (driven.session.title().to_owned(), driven.file().clone());
        assert_ne!(states.last(), Some(&now), "{command:?} changed nothing");
        states.push(now);
    }
    for state in states.iter().rev().skip(1) {
        driven.apply(Command::Undo);
        assert_eq!((driven.session.title(), driven.file()), (state.0.as_str(), &state.1));
    }
    for state in states.iter().skip(1) {
        driven.apply(Command::Redo);
        assert_eq!((driven.session.title(), driven.file()), (state.0.as_str(), &state.1));
    }
    driven.apply(Command::Redo);
    assert!(driven.message().contains("nothing to make again"));
    Ok(())
}

#[test]
fn a_drag_of_a_slider_is_one_change() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let before = driven.file().clone();
    for tilt in 1..50 {
        driven.now += Duration::from_millis(30);
        driven.session.apply(Command::SetTilt(f64::from(tilt)), driven.now);
    }
    driven.apply(Command::Undo);
    assert_eq!(*driven.file(), before);
    assert!(!driven.session.look(None, false).can_undo.0);
    Ok(())
}

#[test]
fn a_file_that_changes_is_read_again() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let slide =
        |text: &str| Slide { name: "talk/a.toml".to_owned(), file: SceneFile::parse(text).map_err(|e| e.to_string()) };
    driven.session.open_slides("talk", Ok(vec![slide("title = 'One'")]));
    driven.session.refresh("talk", Ok(vec![slide("title = 'One'\n[spin]\nrate = 2.0")]), driven.now);
    assert_eq!((driven.file().spin.rate, driven.message()), (Some(2.0), "talk/a.toml was changed, and read again."));
    // One that is broken for a moment says so and leaves what is shown.
    driven.session.refresh("talk", Ok(vec![slide("titel = 'One'")]), driven.now);
    assert!(driven.message().contains("talk/a.toml: ") && driven.file().spin.rate == Some(2.0), "{}", driven.message());
    let new = Slide {
        name: "talk/b.toml".to_owned(),
        file: Ok(SceneFile { title: "New".to_owned(), ..SceneFile::default() }),
    };
    driven.session.refresh("talk", Ok(vec![slide("title = 'One'\n[spin]\nrate = 2.0"), new]), driven.now);
    assert_eq!(driven.session.titles[..2], ["One".to_owned(), "New".to_owned()]);
    assert_eq!(driven.session.opened.place, Some(0));
    driven.session.refresh("talk", Err("talk: gone".to_owned()), driven.now);
    assert_eq!(driven.message(), "talk: gone");
    Ok(())
}

#[test]
fn a_folder_is_opened_with_what_is_broken_in_it() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let good = Slide {
        name: "talk/a.toml".to_owned(),
        file: Ok(SceneFile { title: "One".to_owned(), ..SceneFile::default() }),
    };
    let bad = Slide { name: "talk/b.toml".to_owned(), file: Err("line 3: no number".to_owned()) };
    assert_eq!(driven.apply(Command::OpenPlace("talk".to_owned())), [Effect::Open("talk".to_owned())]);
    driven.session.open_slides("talk", Ok(vec![good.clone(), bad]));
    assert_eq!((driven.session.title(), driven.message()), ("One", "2 scenes of talk"));
    driven.apply(Command::NextScene);
    assert_eq!((driven.session.title(), driven.file().text.as_str()), ("b", "line 3: no number"));
    assert_eq!(driven.file().title, "b");
    // Those built in follow.
    driven.apply(Command::NextScene);
    assert_eq!(driven.session.opened.name, built_in()[0].name);
    driven.session.open_slides("nowhere", Err("nowhere: there is nothing".to_owned()));
    assert_eq!(driven.message(), "nowhere: there is nothing");
    driven.session.open_slides("talk/a.toml", Ok(vec![good]));
    assert_eq!((driven.session.title(), driven.session.opened.place), ("One", Some(0)));
    Ok(())
}

#[test]
fn a_preferred_theme_is_worn_where_the_scene_names_none() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let before = driven.session.revision();
    driven.session.prefer_theme(Theme::Light);
    assert_eq!((driven.session.scene.view.theme, driven.session.revision()), (Theme::Light, before + 1));
    driven.session.prefer_theme(Theme::Light);
    assert_eq!(driven.session.revision(), before + 1, "nothing to draw again");
    assert_eq!(driven.file().view.theme, None, "what is saved does not say it");
    driven.session.open_slides("named", Ok(vec![slide("named", "[view]\ntheme = 'dark'")]));
    driven.session.prefer_theme(Theme::Light);
    assert_eq!(driven.session.scene.view.theme, Theme::Dark);
    Ok(())
}
