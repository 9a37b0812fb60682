//! A whole session driven with no window: every command at least once.

use web_time::{Duration, Instant};

use super::{Effect, Remembered, Session, built_in};
use crate::objects;
use crate::physics::{METHODS, MotionClass, poinsot, so3};
use crate::scene::{BodyFile, Layout, Scene, SceneError, SceneFile, Theme, link, preset};
use crate::ui::{Command, Pixels};

mod fingers;
mod kept;
mod pointer;
mod starts;
mod steps;

/// A session with its own clock: each command comes a second after the one before.
struct Driven {
    session: Session,
    now: Instant,
}

impl Driven {
    fn new(name: &str) -> Result<Self, SceneError> {
        let now = Instant::now();
        let scene = objects::check(&preset(name)?.read()?)?;
        let mut session = Session::new(scene, vec![], &Remembered::default(), now);
        session.apply(Command::Resize(Pixels::new(960.0, 480.0)), now);
        Ok(Self { session, now })
    }

    fn apply(&mut self, command: Command) -> Vec<Effect> {
        self.now += Duration::from_secs(1);
        self.session.apply(command, self.now)
    }

    fn run(&mut self, seconds: f64) {
        for _ in 0..(seconds * 60.0) as u32 {
            self.now += Duration::from_micros(16_667);
            self.session.advance(1.0 / 60.0, self.now);
        }
    }

    fn file(&self) -> &SceneFile {
        &self.session.scene.file
    }

    fn message(&self) -> &str {
        self.session.message.as_ref().map_or("", |(text, _)| text)
    }

    /// Whether a command makes the picture another one.
    fn redraws(&mut self, command: Command) -> bool {
        let before = self.session.revision();
        self.apply(command);
        self.session.revision() != before
    }
}

#[test]
fn time_runs_stands_steps_and_goes_anywhere() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.run(0.5);
    // Whole steps of a millisecond: the last one may still be under way.
    assert!((driven.session.time() - 0.5).abs() < 0.0011);
    driven.apply(Command::PlayPause);
    assert!(!driven.session.is_playing());
    let stood = driven.session.time();
    driven.run(0.5);
    assert_eq!(driven.session.time(), stood);
    driven.apply(Command::Step(3));
    assert!((driven.session.time() - stood - 0.003).abs() < 1e-12);
    driven.apply(Command::GoTo(7.25));
    assert_eq!(driven.session.time(), 7.25);
    driven.apply(Command::GoTo(1e9));
    assert!(driven.message().ends_with("or the closed form, which goes anywhere at once"), "{}", driven.message());
    assert_eq!(driven.session.time(), 7.25);
    let jumps = driven.session.jumps();
    driven.apply(Command::Reverse);
    assert_ne!(driven.session.jumps(), jumps);
    driven.apply(Command::PlayPause);
    driven.run(1.0);
    assert!((driven.session.time() - 6.25).abs() < 0.0011);
    // The scrub bar reaches twice as far back as one has been, and no further for its own end.
    for (time, low) in [(-1.5, -3.0), (-3.0, -3.0), (-4.0, -8.0)] {
        driven.apply(Command::GoTo(time));
        assert_eq!(driven.session.timeline.low, low);
    }
    driven.apply(Command::GoTo(6.25));
    driven.apply(Command::Faster);
    driven.apply(Command::Faster);
    driven.apply(Command::Slower);
    assert_eq!(driven.session.sim.clock.speed, -2.0);
    driven.apply(Command::SetSpeed(1e9));
    assert_eq!(driven.session.sim.clock.speed, -8.0);
    driven.apply(Command::Restart);
    assert_eq!((driven.session.time(), driven.session.sim.clock.speed), (0.0, 8.0));
    driven.session.show_time(12.0);
    assert_eq!((driven.session.time(), driven.session.is_playing()), (12.0, false));
    Ok(())
}

#[test]
fn a_time_too_many_steps_away_is_refused_in_words() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::SetMethod("buss"));
    driven.apply(Command::GoTo(1e9));
    assert!(driven.session.time() < 1.0 && driven.message().contains("closed form"), "{}", driven.message());
    driven.apply(Command::SetMethod("closed-form"));
    driven.apply(Command::GoTo(1e9));
    assert_eq!(driven.session.time(), 1e9);
    Ok(())
}

#[test]
fn the_next_flip_is_gone_to_and_the_one_after_it() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let start = driven.session.scene.start;
    let first = poinsot::next_flip_of(&driven.session.scene.body, &start).unwrap_or_default();
    let period = poinsot::flip_period_of(&driven.session.scene.body, &start).unwrap_or_default();
    for flip in 0..3 {
        driven.apply(Command::NextFlip);
        let wanted = first + f64::from(flip) * period;
        assert!((driven.session.time() - wanted).abs() < 1e-9, "flip {flip}: {}", driven.session.time());
    }
    // Again and again through the one that is under way, also backwards.
    driven.apply(Command::Restart);
    driven.apply(Command::LoopFlip);
    for direction in [1.0, -1.0] {
        let (mut earliest, mut latest, mut turns) = (f64::INFINITY, f64::NEG_INFINITY, 0);
        let mut before = driven.session.time();
        for _ in 0..10 {
            driven.run(0.5);
            let time = driven.session.time();
            (earliest, latest) = (earliest.min(time), latest.max(time));
            turns += u32::from((time - before) * direction < 0.0);
            before = time;
        }
        assert!(earliest > first - 0.5 * period && latest < first + 0.5 * period, "{earliest} {latest}");
        assert!(driven.session.look(None, false).is_looping && turns >= 2, "{turns}");
        driven.apply(Command::Reverse);
    }
    driven.apply(Command::GoTo(first + 0.9 * period));
    assert!(!driven.session.look(None, false).is_looping);
    // Slow motion: the time that it takes through a flip is the integral of 1/factor.
    driven.apply(Command::ToggleSlow);
    driven.apply(Command::GoTo(first));
    let before = driven.session.time();
    driven.run(0.05);
    // Level at the flip, where the factor is a fifth: 0.05 s come to 0.01 s and less than a step on each side.
    assert!((driven.session.time() - before - 0.01).abs() < 0.0011, "{}", driven.session.time() - before);
    assert!(driven.session.look(None, false).slowed < 0.25);
    driven.apply(Command::SetTilt(0.0));
    driven.apply(Command::LoopFlip);
    assert!(driven.message().contains("No flip") && driven.session.look(None, false).slowed == 1.0);
    driven.apply(Command::NextFlip);
    assert!(driven.message().contains("No flip"), "{}", driven.message());
    Ok(())
}

#[test]
fn two_changes_in_one_frame_both_hold() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let body = BodyFile { edges: Some([0.3, 0.2, 0.1]), ..BodyFile::default() };
    driven.session.apply(Command::SetBody(Box::new(body.clone())), driven.now);
    driven.session.apply(Command::SetMethod("buss"), driven.now);
    driven.session.apply(Command::SetRate(3.0), driven.now);
    driven.session.apply(Command::SetTilt(2.0), driven.now);
    let file = driven.file();
    assert_eq!((&file.body, file.motion.method.as_deref()), (&body, Some("buss")));
    assert_eq!((file.spin.rate, file.spin.tilt_deg, file.spin.axis), (Some(3.0), Some(2.0), Some(2)));
    Ok(())
}

#[test]
fn a_slider_changes_one_thing_in_scenes_of_every_kind() -> Result<(), SceneError> {
    for name in ["t-handle", "racket", "symmetric-top", "toutatis", "phone"] {
        let mut driven = Driven::new(name)?;
        let before = driven.session.scene.clone();
        let axes = before.body.body_from_principal().transpose();
        let omega = |scene: &Scene| axes * scene.start.body_angular_velocity(&scene.body);
        driven.apply(Command::SetRate(2.5));
        let after = &driven.session.scene;
        assert_eq!(
            (&after.file.body, &after.file.motion, &after.file.view),
            (&before.file.body, &before.file.motion, &before.file.view)
        );
        // The direction is that of before to rounding.
        let turned = omega(&before).normalize().cross(omega(after).normalize()).length();
        assert!(turned < 4.0 * f64::EPSILON && (omega(after).length() - 2.5).abs() < 1e-15 * 4.0, "{name}: {turned}");

        driven.apply(Command::SetTilt(12.0));
        let tilted = &driven.session.scene;
        assert!((omega(tilted).length() - 2.5).abs() < 1e-14, "{name}");
        assert_eq!(tilted.file.body, before.file.body);
        let spin = crate::ui::Spin::of(tilted);
        assert!(
            (spin.tilt_deg - 12.0).abs() < 1e-12 && spin.axis == crate::ui::Spin::of(&before).axis,
            "{name}: {spin:?}"
        );

        driven.apply(Command::SetStep(0.002));
        assert_eq!(driven.file().motion.step, Some(0.002));
        assert_eq!(driven.file().body, before.file.body);
    }
    Ok(())
}

#[test]
fn where_energy_is_lost_one_method_follows_and_no_flip_is_promised() -> Result<(), SceneError> {
    let mut driven = Driven::new("methods")?;
    assert!(driven.session.timeline.first_flip.is_some());
    // No loss takes nothing away; with some a method that does not know it goes, whoever chose it.
    let ghosts = driven.session.scene.compare.len();
    driven.apply(Command::SetEnergyLoss(0.0));
    assert!(ghosts > 0 && driven.session.scene.compare.len() == ghosts);
    driven.apply(Command::SetMethod("rk4"));
    driven.apply(Command::SetEnergyLoss(0.05));
    let scene = &driven.session.scene;
    assert_eq!((scene.energy_loss, scene.method.name, scene.compare.len()), (0.05, "magnus4", 0));
    assert_eq!(driven.session.timeline.first_flip, None);
    driven.apply(Command::NextFlip);
    assert_eq!(driven.message(), "Where energy is lost no flip is known beforehand: let it run.");
    // What goes anywhere at once knows of no loss: it is no way out.
    driven.apply(Command::GoTo(1e9));
    assert!(driven.message().ends_with("ms away: take a longer step"), "{}", driven.message());
    for refused in [Command::SetMethod("buss"), Command::Compare { method: "closed-form", is_on: true }] {
        driven.apply(refused);
        assert!(driven.message().contains("does not know the energy loss of 0.05"), "{}", driven.message());
        assert_eq!(driven.session.scene.method.name, "magnus4");
    }
    // It falls as time runs, and rises where time runs backwards, by the same way.
    driven.run(2.0);
    let lost = driven.session.sim.energy_error();
    assert!(lost < -0.01, "{lost}");
    driven.apply(Command::Reverse);
    driven.run(1.0);
    assert!(driven.session.sim.energy_error() > lost);
    driven.apply(Command::GoTo(0.0));
    assert_eq!(driven.session.sim.energy_error(), 0.0);
    driven.apply(Command::SetEnergyLoss(-1.0));
    assert!(driven.message().contains("energy_loss -1 is not valid"), "{}", driven.message());
    driven.apply(Command::SetEnergyLoss(0.0));
    assert_eq!((driven.file().motion.energy_loss, driven.session.scene.method.name), (None, "exact-step"));
    // The one that knows it stays where it was chosen.
    driven.apply(Command::SetMethod("magnus4"));
    driven.apply(Command::SetEnergyLoss(0.05));
    driven.apply(Command::SetEnergyLoss(0.0));
    assert_eq!(driven.session.scene.method.name, "magnus4");
    Ok(())
}

#[test]
fn spin_energy_separatrix_and_poke_begin_other_motions_of_the_same_momentum() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::SpinAxis(3));
    assert_eq!(driven.file().spin.axis, Some(3));
    driven.apply(Command::SetTilt(20.0));
    let length = so3::norm(driven.session.scene.start.body_momentum);
    let body = driven.session.scene.body;
    let energy = 0.5 * (length * length) / body.principal_moments().y;
    driven.apply(Command::SetEnergy(energy * 1.1));
    let start = driven.session.scene.start;
    assert!((start.energy(&body) / energy / 1.1 - 1.0).abs() < 1e-13);
    assert!((so3::norm(start.body_momentum) / length - 1.0).abs() < 1e-14);
    driven.apply(Command::ToSeparatrix);
    let momentum = driven.session.scene.start.body_momentum;
    assert_eq!(poinsot::classify(&body, momentum), MotionClass::Separatrix);
    driven.run(0.7);
    let world = driven.session.sim.state().world_momentum;
    driven.apply(Command::Poke);
    assert_eq!(driven.session.time(), 0.0);
    assert!(driven.message().contains("L is the same"), "{}", driven.message());
    assert!((driven.session.scene.start.world_momentum - world).length() < 1e-14 * length);
    Ok(())
}

#[test]
fn scenes_are_gone_through_to_the_ends() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let count = built_in().len();
    driven.apply(Command::PreviousScene);
    assert_eq!(driven.session.opened.place, Some(0));
    let mut titles = vec![driven.session.title().to_owned()];
    for _ in 0..count + 2 {
        driven.apply(Command::NextScene);
        titles.push(driven.session.title().to_owned());
    }
    assert_eq!(driven.session.opened.place, Some(count - 1));
    titles.dedup();
    assert_eq!(titles.len(), count);
    assert!(driven.session.is_playing());
    Ok(())
}

#[test]
fn what_is_no_scene_changes_nothing_and_is_said() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let before = driven.file().clone();
    let text = "[body]\nbox = [1.0, 2.0, -3.0]".to_owned();
    driven.apply(Command::OpenText { name: "odd.toml".to_owned(), text });
    assert_eq!(*driven.file(), before);
    assert!(driven.message().contains("odd.toml") && driven.message().contains("-3"), "{}", driven.message());
    driven.apply(Command::SetStep(-1.0));
    assert_eq!(*driven.file(), before);
    assert!(driven.message().contains("step"), "{}", driven.message());
    assert_eq!(driven.apply(Command::Paste("/tmp/x.toml".to_owned())), [Effect::Open("/tmp/x.toml".to_owned())]);
    assert_eq!(driven.apply(Command::Paste("hello".to_owned())), []);
    Ok(())
}

#[test]
fn a_scene_is_kept_and_comes_back_as_it_was_opened() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::SetRate(2.0));
    driven.apply(Command::Orbit { at: Pixels::new(100.0, 100.0), by: Pixels::new(40.0, 10.0) });
    let effects = driven.apply(Command::SaveScene);
    let [Effect::SaveText { place: None, title, text }] = effects.as_slice() else {
        return Err(SceneError::NotAScene { line: 0, message: format!("{effects:?}") });
    };
    assert_eq!(title, "The flip");
    let written = SceneFile::parse(text)?;
    assert_eq!(written.spin.rate, Some(2.0));
    assert!(written.view.world_camera.target.is_some());
    driven.session.saved("the-flip-1.toml");
    let copied = driven.apply(Command::CopyCommand);
    assert!(matches!(&copied[..], [Effect::CopyText(line)] if line.contains("the-flip-1.toml")), "{copied:?}");
    // The file that it is in by now is offered, and nothing is written before an answer.
    assert_eq!(driven.apply(Command::SaveScene), []);
    assert_eq!(driven.session.shown.saving.as_deref(), Some("the-flip-1.toml"));
    assert_eq!(driven.apply(Command::SaveNothing), []);
    assert_eq!(driven.session.shown.saving, None);
    let there = Some("the-flip-1.toml".to_owned());
    assert!(
        matches!(&driven.apply(Command::SaveTo(there.clone()))[..], [Effect::SaveText { place, .. }] if *place == there)
    );
    driven.apply(Command::Reopen);
    assert_eq!(driven.file().spin, preset("flip")?.read()?.spin);
    Ok(())
}

#[test]
fn the_command_that_is_copied_draws_what_is_shown() -> Result<(), SceneError> {
    let mut driven = Driven::new("methods")?;
    driven.apply(Command::PlayPause);
    driven.apply(Command::GoTo(1.25));
    for method in ["forward-euler", "backward-euler", "rk4", "lie-euler"] {
        driven.apply(Command::Compare { method, is_on: false });
    }
    driven.apply(Command::Poke);
    let effects = driven.apply(Command::CopyCommand);
    let [Effect::CopyText(line)] = effects.as_slice() else {
        return Err(SceneError::NotAScene { line: 0, message: format!("{effects:?}") });
    };
    for words in ["dzhanibekov shot methods ", "--time 0 ", "--size 960x480", "-o adding-matrices"] {
        assert!(line.contains(words), "{line} lacks {words}");
    }
    assert!(driven.message().contains(line));
    Ok(())
}

#[test]
fn the_link_that_is_copied_opens_what_is_shown() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::GoToStep(3));
    driven.apply(Command::SetRate(3.25));
    driven.apply(Command::GoTo(1.25));
    let effects = driven.apply(Command::CopyLink);
    let [Effect::CopyLink(text)] = effects.as_slice() else {
        return Err(SceneError::NotAScene { line: 0, message: format!("{effects:?}") });
    };
    assert!(text.starts_with("#flip?"), "{text}");
    let read = link::read(text)?;
    assert_eq!((read.file.spin.rate, read.step, read.time), (Some(3.25), Some(3), Some(1.25)));
    // So does a picture that is written of it, whole.
    let remarks = driven.session.remarks([640, 360]);
    let said = |keyword| remarks.iter().find(|(of, _)| *of == keyword).map_or("", |(_, text)| text.as_str());
    assert_eq!((said("Software"), said("Title"), said("Description")), ("dzhanibekov", "The flip", "t = 1.25 s"));
    assert!(said("Comment").contains("--rate 3.25") && said("Comment").contains("--size 640x360"), "{remarks:?}");
    let read = link::read(said("Scene"))?;
    assert_eq!((read.file.spin.rate, read.step, read.time), (Some(3.25), Some(3), Some(1.25)));
    Ok(())
}

#[test]
fn only_what_changes_the_picture_redraws_it() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::PlayPause);
    let at = Pixels::new(100.0, 100.0);
    for command in [
        Command::Orbit { at, by: Pixels::new(9.0, 3.0) },
        Command::Pan { at, by: Pixels::new(9.0, 3.0) },
        Command::Zoom { at, by: 1.2 },
        Command::Home,
        Command::SetLayout(Layout::Body),
        Command::NextLayout,
        Command::NextLayout,
        Command::ToggleTheme,
        Command::ToggleLabels,
        Command::Show { name: "body", is_shown: false },
        Command::Step(1),
        Command::SetTilt(3.0),
        Command::Resize(Pixels::new(500.0, 400.0)),
        Command::TogglePresenter,
        Command::TogglePresenter,
    ] {
        assert!(driven.redraws(command.clone()), "{command:?}");
    }
    for command in [
        Command::TogglePanel,
        Command::ToggleSlide,
        Command::ToggleCharts,
        Command::ToggleHelp,
        Command::TextSize(1.2),
        Command::Hover(Some(at)),
        Command::PlayPause,
        Command::SetSpeed(2.0),
        Command::Home,
        Command::Picture { transparent: true },
    ] {
        assert!(!driven.redraws(command.clone()), "{command:?}");
    }
    assert_eq!(driven.apply(Command::Picture { transparent: true }), [Effect::WritePicture { transparent: true }]);
    assert_eq!(driven.apply(Command::ToggleFullscreen), [Effect::ToggleFullscreen]);
    assert_eq!(driven.apply(Command::FocusPanel), [Effect::FocusPanel]);
    assert!(driven.session.shown.panel, "the panel is shown where the keyboard goes into it");
    let frame = driven.session.frame(1.25);
    assert_eq!(frame.panes.len(), 1);
    Ok(())
}

#[test]
fn a_presenters_choices_stay_from_scene_to_scene() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::ToggleTheme);
    driven.apply(Command::ToggleLabels);
    driven.apply(Command::TextSize(1.1));
    driven.apply(Command::NextScene);
    assert_eq!(driven.session.theme(), Theme::Light);
    assert!(!driven.session.scene.view.labels);
    driven.apply(Command::ToggleCharts);
    let mut remembered = Remembered::default();
    driven.session.remember(&mut remembered);
    assert!(remembered.charts && remembered.panel && remembered.slide);
    assert_eq!(Remembered::read(&remembered.text()), remembered);
    assert!(!remembered.presenting && !driven.session.is_presenting());
    driven.apply(Command::TogglePresenter);
    assert!(driven.session.is_presenting());
    driven.session.remember(&mut remembered);
    assert!(remembered.presenting && Remembered::read(&remembered.text()) == remembered);
    // Words in the picture are larger by the factor by which the scene's are.
    let frame = driven.session.frame(1.25);
    driven.apply(Command::NextScene);
    assert!(driven.session.shown.presenting);
    driven.apply(Command::PreviousScene);
    // The panel is asked back as it was before.
    driven.apply(Command::TogglePanel);
    assert!(driven.session.shown.panel && !driven.session.shown.presenting);
    assert_eq!(frame.font_scale, crate::ui::LARGER * driven.session.frame(1.25).font_scale);
    assert_eq!(Remembered::read("size = [1.0, 1.0]"), Remembered::default());
    driven.apply(Command::TextSize(0.0));
    assert_eq!(driven.session.text_size(), 1.0);
    Ok(())
}

#[test]
fn a_time_is_asked_for_until_one_is_gone_to() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::PlayPause);
    driven.session.say("Words where the field will be.");
    driven.apply(Command::AskTime);
    assert!(driven.message().is_empty());
    assert!(driven.session.shown.asking_time && !driven.redraws(Command::AskTime));
    driven.apply(Command::AskNothing);
    assert!(!driven.session.shown.asking_time);
    driven.apply(Command::AskTime);
    let jumps = driven.session.jumps();
    driven.apply(Command::GoTo(-2.5));
    // Whoever draws it in between is told that nothing lies between.
    assert_eq!(driven.session.jumps(), jumps + 1);
    assert_eq!((driven.session.time(), driven.session.shown.asking_time), (-2.5, false));
    Ok(())
}

#[test]
fn methods_beside_each_other_come_and_go() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    for method in METHODS {
        driven.apply(Command::Compare { method: method.name, is_on: true });
    }
    // The scene's own method is no ghost beside itself.
    assert_eq!(driven.session.sim.ghosts().len(), METHODS.len() - 1);
    driven.run(0.2);
    let time = driven.session.time();
    driven.apply(Command::Compare { method: "rk4", is_on: false });
    assert_eq!(driven.session.sim.ghosts().len(), METHODS.len() - 2);
    // The motion goes on from where it was.
    assert_eq!(driven.session.time(), time);
    Ok(())
}

#[test]
fn messages_go_by_themselves() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.session.say("A word.");
    let ends = driven.session.message_ends().unwrap_or(driven.now);
    driven.session.advance(0.0, ends);
    assert!(driven.session.message_ends().is_none());
    driven.session.say("Another.");
    driven.session.say_nothing();
    assert!(driven.message().is_empty());
    Ok(())
}

/// A part of another page is the picture alone, and greets nobody.
#[test]
fn embedded_it_is_the_picture_alone() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.session.say("Welcome.");
    driven.session.embed();
    let shown = &driven.session.shown;
    assert!(shown.embedded && !shown.panel && !shown.slide && driven.message().is_empty());
    Ok(())
}

#[test]
fn a_scene_without_a_name_comes_back_and_is_said_by_what_differs() -> Result<(), SceneError> {
    let now = Instant::now();
    let file = SceneFile::parse("title = 'Mine'\n[spin]\nrate = 4.0")?;
    let mut session = Session::new(objects::check(&file)?, vec![], &Remembered::default(), now);
    assert!(!session.look(None, false).is_edited());
    session.apply(Command::SetRate(5.0), now);
    assert!(session.look(None, false).is_edited());
    session.apply(Command::Reopen, now);
    assert_eq!(session.scene().file, file);
    let copied = session.apply(Command::CopyCommand, now);
    assert!(
        matches!(&copied[..], [Effect::CopyText(line)] if line.starts_with("dzhanibekov shot flip ") && line.contains("--rate 4")),
        "{copied:?}"
    );
    Ok(())
}

#[test]
fn a_notch_of_the_wheel_is_a_tenth_and_undo_leaves_the_camera_of_its_scene() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::PlayPause);
    let at = Pixels::new(100.0, 100.0);
    let before = driven.session.cameras.world.distance;
    driven.apply(Command::Zoom { at, by: 1.1 });
    let after = driven.session.cameras.world.distance;
    assert!((before / after - 1.1).abs() < 1e-5, "{before} {after}");
    // A change of the same scene that is taken back leaves the camera where it is; another scene has its own.
    driven.apply(Command::SetRate(2.0));
    driven.apply(Command::Undo);
    assert_eq!(driven.session.cameras.world.distance, after);
    driven.apply(Command::NextScene);
    driven.apply(Command::Undo);
    assert_eq!(driven.session.cameras.world.distance, before);
    Ok(())
}
