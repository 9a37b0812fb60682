//! Starts that follow from the present one, and what the time line says of them.

use std::f64::consts::PI;

use glam::DVec3;

use super::Driven;
use crate::physics::{poinsot, so3};
use crate::scene::SceneError;
use crate::session::Remembered;
use crate::ui::{Command, Spin};

impl Driven {
    /// The open scene's text with these lines behind it.
    fn open(&mut self, text: &str) {
        self.apply(Command::OpenText { name: "mine.toml".to_owned(), text: text.to_owned() });
    }
}

#[test]
fn another_rate_or_tilt_leaves_the_attitude_and_the_side() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven
        .open("[body]\nmoments = [0.5, 0.85, 1.0]\n[spin]\nomega = [0.1, -2.0, 0.3]\nattitude = [0.6, 0.8, 0.0, 0.0]");
    let given = driven.file().spin.clone();
    driven.apply(Command::SetRate(1.0));
    assert_eq!(driven.file().spin.attitude, given.attitude);
    driven.apply(Command::SetTilt(30.0));
    let spin = driven.file().spin.clone();
    assert_eq!(spin.attitude, given.attitude);
    let omega = DVec3::from_array(spin.omega.unwrap_or_default());
    let side = DVec3::new(0.1, 0.0, 0.3).normalize();
    let wanted = side * 30f64.to_radians().sin() - DVec3::Y * 30f64.to_radians().cos();
    assert!((omega - wanted).length() < 1e-15 * 4.0, "{omega}");
    // Exactly on the axis it is said by the axis, about it the same way round.
    driven.apply(Command::SetTilt(0.0));
    let spin = driven.file().spin.clone();
    assert_eq!((spin.axis, spin.tilt_deg, spin.omega, spin.attitude), (Some(2), Some(0.0), None, given.attitude));
    assert!((spin.rate.unwrap_or_default() + 1.0).abs() < 1e-15 * 4.0, "{spin:?}");
    driven.apply(Command::SpinAxis(3));
    let spin = driven.file().spin.clone();
    assert_eq!((spin.axis, spin.tilt_deg, spin.attitude), (Some(3), Some(0.0), given.attitude));
    driven.apply(Command::SetRate(-4.0));
    assert_eq!(Spin::of(&driven.session.scene), Spin { axis: 3, tilt_deg: 0.0, rate: -4.0 });
    assert_eq!(driven.file().spin.attitude, given.attitude);
    // At rest there is no line to keep.
    driven.open("[spin]\nomega = [0.0, 0.0, 0.0]");
    driven.apply(Command::SetRate(2.0));
    assert!(
        (so3::norm(driven.session.scene.start.body_angular_velocity(&driven.session.scene.body)) - 2.0).abs() < 1e-14
    );
    Ok(())
}

#[test]
fn a_poke_turns_the_body_by_a_degree_where_it_is() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::PlayPause);
    driven.apply(Command::GoTo(1.3));
    let before = *driven.session.sim.state();
    driven.apply(Command::Poke);
    let after = *driven.session.sim.state();
    let turn = so3::log(before.world_from_body.transpose() * after.world_from_body);
    assert!((so3::norm(turn).to_degrees() - 1.0).abs() < 1e-9, "{turn}");
    assert!((after.world_momentum - before.world_momentum).length() < 1e-14 * so3::norm(before.world_momentum));
    Ok(())
}

#[test]
fn what_has_no_energy_or_separatrix_to_choose_says_so() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    for text in
        ["[body]\nmoments = [1.0, 1.0, 0.5]\n[spin]\nomega = [0.1, 2.0, 0.3]", "[spin]\nomega = [0.0, 0.0, 0.0]"]
    {
        driven.open(text);
        let before = driven.file().clone();
        driven.apply(Command::SetEnergy(1.0));
        assert!(driven.message().starts_with("The energy is given by the momentum alone"), "{}", driven.message());
        driven.apply(Command::ToSeparatrix);
        assert!(driven.message().starts_with("There is no separatrix"), "{}", driven.message());
        assert_eq!(*driven.file(), before);
    }
    Ok(())
}

/// The share of M along each axis of a body, and whether it is said to flip.
#[test]
fn a_body_flips_where_its_momentum_comes_near_the_middle_axis() -> Result<(), SceneError> {
    let moments = DVec3::new(0.5, 0.85, 1.0);
    // With one outer component naught M₂ is at its largest: the start's own share is that of the whole motion.
    for (outer, middle, flips) in
        [(0, 0.79_f64, false), (0, 0.81, true), (2, 0.79, false), (2, 0.81, true), (0, 0.1, false), (2, 0.99, true)]
    {
        let mut momentum = DVec3::ZERO;
        momentum[outer] = (1.0 - middle * middle).sqrt();
        momentum.y = middle;
        let omega = momentum / moments;
        let mut driven = Driven::new("flip")?;
        driven.open(&format!(
            "[body]\nmoments = [0.5, 0.85, 1.0]\n[spin]\nomega = [{:?}, {:?}, {:?}]",
            omega.x, omega.y, omega.z
        ));
        let timeline = driven.session.timeline;
        assert_eq!(timeline.first_flip.is_some(), flips, "{outer} {middle}");
        let high = match (timeline.first_flip, timeline.period) {
            (Some(first), Some(period)) => first + 5.0 * period,
            // Ten turns where none is to be seen.
            _ => 20.0 * PI / so3::norm(omega),
        };
        assert!((timeline.high / high - 1.0).abs() < 1e-14, "{timeline:?} {high}");
        assert_eq!(timeline.low, 0.0);
    }
    Ok(())
}

#[test]
fn the_time_line_is_as_long_as_what_there_is_to_see() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let (body, start) = (driven.session.scene.body, driven.session.scene.start);
    let first = poinsot::next_flip_of(&body, &start).unwrap_or_default();
    let period = poinsot::flip_period_of(&body, &start).unwrap_or_default();
    let line = driven.session.timeline;
    assert_eq!((line.first_flip, line.period), (Some(first), Some(period)));
    assert!((line.high - first - 5.0 * period).abs() < 1e-12 * line.high);
    // On the separatrix one flip, in the middle: M₁²(1/I₁ − 1/I₂) = M₃²(1/I₂ − 1/I₃) to the last bit, since 1/3 − 1/4 = 1/4 − 1/6.
    driven.open("[body]\nmoments = [3, 4, 6]\n[spin]\nomega = [-0.5, 1, 0.25]");
    let line = driven.session.timeline;
    let first = poinsot::next_flip_of(&driven.session.scene.body, &driven.session.scene.start).unwrap_or_default();
    assert_eq!((line.first_flip, line.period), (Some(first), None));
    assert!((line.high - 2.0 * first).abs() < 1e-12 * line.high);
    // Ten turns where none comes, ten seconds at rest.
    driven.open("[spin]\naxis = 3\nrate = 4.0");
    assert!((driven.session.timeline.high - 5.0 * PI).abs() < 1e-13, "{:?}", driven.session.timeline);
    driven.open("[spin]\nomega = [0.0, 0.0, 0.0]");
    assert_eq!(driven.session.timeline.high, 10.0);
    // With loss: six e-folds of the slower wobble, by the rates at which small ones grow and die away.
    driven.open("[body]\nmoments = [0.5, 0.85, 1.0]\n[spin]\naxis = 1\nrate = 2.0\n[motion]\nenergy_loss = 0.1");
    let inverse = DVec3::new(0.5, 0.85, 1.0).recip();
    let slower = (inverse.x - 0.5 * (inverse.y + inverse.z)).min(0.5 * (inverse.x + inverse.y) - inverse.z);
    let wanted = 6.0 / (0.1 * (0.5 * 2.0) * slower);
    assert!((driven.session.timeline.high / wanted - 1.0).abs() < 1e-13, "{:?} {wanted}", driven.session.timeline);
    assert_eq!((driven.session.timeline.first_flip, driven.session.timeline.period), (None, None));
    Ok(())
}

#[test]
fn the_time_line_grows_with_the_time_that_is_reached() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::PlayPause);
    let high = driven.session.timeline.high;
    for (time, low, top) in [
        (high, 0.0, high),
        (high * 1.001, 0.0, 2.0 * high),
        (high * 7.0, 0.0, 8.0 * high),
        (-1.0, -2.0, 8.0 * high),
        (-1.5, -2.0, 8.0 * high),
        (-6.0 * high, -8.0 * high, 8.0 * high),
        (-9.0 * high, -9.0 * high, 8.0 * high),
    ] {
        driven.apply(Command::GoTo(time));
        let line = driven.session.timeline;
        assert_eq!((line.low, line.high), (low, top), "{time}");
    }
    Ok(())
}

#[test]
fn a_loop_reaches_as_far_to_both_sides_and_is_left_by_going_elsewhere() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let line = driven.session.timeline;
    let (first, period) = (line.first_flip.unwrap_or_default(), line.period.unwrap_or_default());
    let reach = driven.session.slowing.map(|slowing| slowing.reach()).unwrap_or_default();
    let half = (1.8 * reach).min(0.5 * period);
    driven.apply(Command::PlayPause);
    driven.apply(Command::LoopFlip);
    assert!((driven.session.time() - (first - half)).abs() < 1e-9, "{}", driven.session.time());
    assert!(driven.session.is_playing(), "a loop runs");
    driven.apply(Command::LoopFlip);
    assert_eq!(driven.message(), "The loop has ended.");
    // Under way it is this one, backwards it begins at its end.
    driven.apply(Command::GoTo(first + 0.9 * reach));
    driven.apply(Command::Reverse);
    driven.apply(Command::LoopFlip);
    assert!((driven.session.time() - (first + half)).abs() < 1e-9, "{}", driven.session.time());
    driven.apply(Command::GoTo(first));
    assert!(driven.session.look(None, false).is_looping);
    driven.apply(Command::GoTo(first - 1.01 * half));
    assert!(!driven.session.look(None, false).is_looping);
    // Past its reach the next one counts.
    driven.apply(Command::Restart);
    driven.apply(Command::GoTo(first + 1.1 * reach));
    driven.apply(Command::LoopFlip);
    assert!((driven.session.time() - (first + period - half)).abs() < 1e-9, "{}", driven.session.time());
    Ok(())
}

#[test]
fn slow_motion_is_that_of_the_flip_and_of_nothing_else() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    let first = driven.session.timeline.first_flip.unwrap_or_default();
    driven.apply(Command::PlayPause);
    driven.apply(Command::GoTo(first));
    assert_eq!(driven.session.look(None, false).slowed, 1.0, "not asked for");
    driven.apply(Command::ToggleSlow);
    assert_eq!((driven.message(), driven.session.scene.view.slow_at_flip), ("Slow motion at each flip.", true));
    assert!((driven.session.look(None, false).slowed - 0.2).abs() < 1e-12);
    driven.apply(Command::GoTo(first + 0.5 * driven.session.timeline.period.unwrap_or_default()));
    assert_eq!(driven.session.look(None, false).slowed, 1.0, "half-way to the next");
    driven.apply(Command::ToggleSlow);
    assert_eq!((driven.message(), driven.session.scene.view.slow_at_flip), ("No slow motion.", false));
    Ok(())
}

#[test]
fn what_is_remembered_is_what_can_be() {
    let sound = Remembered { size: Some([200.0, 19_999.0]), text_size: 0.4, ..Remembered::default() };
    assert_eq!(Remembered::read(&sound.text()), sound);
    for odd in ["size = [199.0, 300.0]", "size = [300.0, 20000.0]", "text_size = 0.3", "text_size = 4.1", "panel = 3"] {
        assert_eq!(Remembered::read(&format!("charts = true\n{odd}")), Remembered::default(), "{odd}");
    }
    assert!(Remembered::read("charts = true").charts);
}

/// Where energy is lost a wobble about axis 1 grows at the rate loss · ℓ (1/I₁ − (1/I₂ + 1/I₃)/2), and one about axis 3 dies away at
/// loss · ℓ ((1/I₁ + 1/I₂)/2 − 1/I₃): the time line shows six times as long as the slower of them takes to e times or a part in e.
#[test]
fn the_time_line_of_a_loss_is_as_long_as_the_loss_takes() -> Result<(), SceneError> {
    for (moments, slower) in
        [([1.0, 1.05, 2.0], 1.0 - 0.5 * (1.0 / 1.05 + 0.5)), ([1.0, 1.9, 2.0], 0.5 * (1.0 + 1.0 / 1.9) - 0.5)]
    {
        let mut driven = Driven::new("flip")?;
        let text = format!("body.moments = {moments:?}\nspin = {{ axis = 1, rate = 3.0 }}\nmotion.energy_loss = 0.05");
        driven.apply(Command::OpenText { name: "loss.toml".to_owned(), text });
        // ℓ = I₁ω = 3 kg m²/s.
        let expected = 6.0 / (0.05 * 3.0 * slower);
        let high = driven.session.timeline.high;
        assert!((high / expected - 1.0).abs() < 1e-14, "{high} {expected}");
    }
    // Where the loss takes longer than anyone looks, ten turns.
    let mut driven = Driven::new("flip")?;
    let text = "body.moments = [1, 2, 3]\nspin = { axis = 1, rate = 4.0 }\nmotion.energy_loss = 1e-12".to_owned();
    driven.apply(Command::OpenText { name: "loss.toml".to_owned(), text });
    let high = driven.session.timeline.high;
    assert!((high - 10.0 * std::f64::consts::TAU / 4.0).abs() < 1e-14 * high, "{high}");
    Ok(())
}
