//! Commands about time.

use super::Session;
use crate::objects::Cameras;
use crate::physics::poinsot;
use crate::physics::so3;
use crate::sim::{Slowing, Tick};
use crate::ui::{SPEED_POWERS, Timeline};

/// Most steps that going to another time may take: a few tenths of a second of work.
pub(super) const MOST_STEPS: f64 = 4e6;
/// E-folds of a wobble that the scrub bar shows where energy is lost.
const E_FOLDS: f64 = 6.0;
/// Flips that the scrub bar shows from the start.
const FLIPS_AHEAD: f64 = 5.0;
/// How far before a flip the loop of one begins and after it ends, in reaches of slow motion.
const LOOPS_REACH: f64 = 1.8;
/// What is said of the flips of a body that loses energy.
const FLIPS_UNKNOWN: &str = "Where energy is lost no flip is known beforehand: let it run.";
/// Share of the momentum that must lie along the middle axis at times for the body to be seen turning over.
const TURNS_OVER: f64 = 0.8;

impl Session {
    /// Lets real time (s) pass.
    pub(super) fn run(&mut self, real_seconds: f64) {
        if self.sim.advance_frame(real_seconds * self.slowed()) != Tick::Still {
            self.time_has_passed();
            self.come_round();
        }
    }

    /// How fast the clock runs beside its own speed.
    pub(super) fn slowed(&self) -> f64 {
        let slowing = self.slowing.filter(|_| self.scene.view.slow_at_flip);
        slowing.map_or(1.0, |slowing| slowing.factor(self.sim.time()))
    }

    pub(super) fn toggle_slow(&mut self) {
        let is_slow = !self.scene.view.slow_at_flip;
        let at = self.scene.at;
        self.edit(|file| *file.written_at(at).slow_at_flip = Some(is_slow));
        self.say(if is_slow { "Slow motion at each flip." } else { "No slow motion." });
    }

    /// Begins to run through the flip that comes next, or the one that is under way, again and again; or ends it.
    pub(super) fn loop_flip(&mut self) {
        if self.looped.take().is_some() {
            return self.say("The loop has ended.");
        }
        let time = self.sim.time();
        let near = self.slowing.map(|slowing| (slowing.nearest_flip(time), slowing.reach()));
        let under_way = near.filter(|(flip, reach)| (time - flip).abs() < *reach).map(|(flip, _)| flip);
        let next = || self.timeline.next_flip(time, self.sim.clock.speed < 0.0);
        match under_way.or_else(next) {
            Some(flip) if self.slowing.is_some() => {
                self.looped = Some(flip);
                self.sim.clock.paused = false;
                self.go_to_loops_start();
                self.say("One flip, again and again (Shift+N ends it).");
            }
            _ => self.say("No flip comes any more."),
        }
    }

    /// The times (s) between which the loop runs.
    fn loops_ends(&self) -> Option<(f64, f64)> {
        let half = LOOPS_REACH * self.slowing?.reach();
        let half = self.timeline.period.map_or(half, |period| half.min(0.5 * period));
        self.looped.map(|flip| (flip - half, flip + half))
    }

    fn go_to_loops_start(&mut self) {
        let Some((from, to)) = self.loops_ends() else { return };
        let time = if self.sim.clock.speed < 0.0 { to } else { from };
        if self.sim.steps_to(time) <= MOST_STEPS {
            self.sim.go_to(time);
            self.time_was_set();
        }
    }

    /// Back to the beginning of the loop where its end is passed; one who has gone elsewhere has left it.
    fn come_round(&mut self) {
        let Some((from, to)) = self.loops_ends() else { return };
        let (time, is_backwards) = (self.sim.time(), self.sim.clock.speed < 0.0);
        if (time > to && !is_backwards) || (time < from && is_backwards) {
            self.go_to_loops_start();
        }
    }

    /// Ends the loop where a time (s) outside of it is gone to.
    fn leave_loop(&mut self, time: f64) {
        self.looped = self.looped.filter(|_| self.loops_ends().is_some_and(|(from, to)| (from..=to).contains(&time)));
    }

    /// Notes what came of steps taken.
    fn time_has_passed(&mut self) {
        self.flips.watch(&self.sim);
        self.history.record(&self.sim, &self.motion);
        self.stretch_timeline();
        if let (Some(failure), true) = (self.sim.main().failure(), self.sim.clock.paused) {
            let text = failure.to_string();
            self.say(text);
        }
    }

    /// Time was set: nothing is measured across the gap.
    pub(super) fn time_was_set(&mut self) {
        self.jumps += 1;
        self.flips.jump();
        self.history.jump();
        self.time_has_passed();
    }

    /// A new motion begins: what was seen and measured was another one.
    pub(super) fn forget_the_past(&mut self) {
        self.history.clear();
        self.flips = crate::sim::FlipWatch::default();
        self.preview = None;
        self.looped = None;
        self.timeline = timeline_of(&self.scene);
        let rate = poinsot::growth_rate(&self.scene.body, so3::norm(self.scene.start.body_momentum));
        let Timeline { first_flip, period, .. } = self.timeline;
        self.slowing = first_flip.and_then(|first| Slowing::new(first, period, rate));
        self.time_was_set();
    }

    /// Shows a moment as a picture does: the scene's step, counted from 0, or the scene as a whole, and the time (s), paused.
    pub fn show_moment(&mut self, step: Option<usize>, time: f64) {
        let file = self.scene.file.clone();
        if let Err(error) = self.set_at(&file, step) {
            return self.say(error.to_string());
        }
        self.cameras = Cameras::new(&self.scene.view);
        self.origin = None;
        self.show_time(time);
    }

    /// Shows a time (s), paused, however long the way to it.
    pub fn show_time(&mut self, time: f64) {
        let seen = self.seen();
        self.sim.clock.paused = true;
        self.sim.go_to(time);
        self.time_was_set();
        self.note_change(seen);
    }

    pub(super) fn step(&mut self, count: i64) {
        self.sim.clock.paused = true;
        self.sim.step(count);
        self.time_has_passed();
    }

    pub(super) fn reverse(&mut self) {
        self.sim.clock.speed = -self.sim.clock.speed;
        self.jumps += 1;
        self.flips.jump();
    }

    pub(super) fn set_speed(&mut self, speed: f64) {
        let (low, high) = SPEED_POWERS;
        let speed = speed.clamp(f64::from(low).exp2(), f64::from(high).exp2());
        self.sim.clock.speed = speed.copysign(self.sim.clock.speed);
        self.jumps += 1;
    }

    pub(super) fn restart(&mut self) {
        self.sim.clock.speed = self.sim.clock.speed.abs();
        self.restart_time();
    }

    /// Back to the start; which way time runs, and whether, stays.
    pub(super) fn restart_time(&mut self) {
        self.sim.restart();
        self.forget_the_past();
    }

    pub(super) fn go_to(&mut self, time: f64) {
        if self.sim.steps_to(time) > MOST_STEPS {
            let direct =
                if self.scene.energy_loss > 0.0 { "" } else { ", or the closed form, which goes anywhere at once" };
            self.say(format!(
                "{} is too many steps of {} ms away: take a longer step{direct}",
                crate::ui::numbers::significant(time, 4) + " s",
                self.scene.step * 1e3
            ));
            return;
        }
        self.leave_loop(time);
        self.sim.go_to(time);
        self.time_was_set();
    }

    pub(super) fn go_to_next_flip(&mut self) {
        match self.timeline.next_flip(self.sim.time(), self.sim.clock.speed < 0.0) {
            Some(flip) => self.go_to(flip),
            None if self.scene.energy_loss > 0.0 => self.say(FLIPS_UNKNOWN),
            None => self.say("No flip comes any more."),
        }
    }

    /// The scrub bar grows with the time that has been reached.
    fn stretch_timeline(&mut self) {
        let time = self.sim.time();
        let line = &mut self.timeline;
        while time > line.high && line.high.is_normal() {
            line.high *= 2.0;
        }
        if time < line.low {
            line.low = (2.0 * time).max(-line.high).min(time);
        }
    }
}

/// What can be said of a scene's motion before it is run.
fn timeline_of(scene: &crate::scene::Scene) -> Timeline {
    if scene.energy_loss > 0.0 {
        return losing_timeline(scene);
    }
    // A momentum that stays far from the middle axis circles; nobody would say that the body flips.
    let first_flip = poinsot::next_flip_of(&scene.body, &scene.start).filter(|_| nearest_to_middle(scene) > TURNS_OVER);
    let period = poinsot::flip_period_of(&scene.body, &scene.start).filter(|_| first_flip.is_some());
    let rate = so3::norm(scene.start.body_angular_velocity(&scene.body));
    // Where it never flips: ten turns, or ten seconds at rest.
    let turns = if rate > 0.0 { 20.0 * std::f64::consts::PI / rate } else { 10.0 };
    let seen = match (first_flip, period) {
        (Some(first), Some(period)) => first + FLIPS_AHEAD * period,
        (Some(first), None) => 2.0 * first,
        _ => turns,
    };
    let high = if seen.is_finite() { seen.clamp(1e-3, 1e9) } else { turns };
    Timeline { low: 0.0, high, first_flip, period }
}

/// Where energy is lost flips are not predicted; the time line is about as long as it takes: a wobble about axis 1 grows, and one about axis 3
/// dies away, at the rates that are told in `magnus4`, here those of the slower of the two.
fn losing_timeline(scene: &crate::scene::Scene) -> Timeline {
    let inverse = scene.body.principal_moments().recip();
    let ell = so3::norm(scene.start.body_momentum);
    let growth = inverse.x - 0.5 * (inverse.y + inverse.z);
    let decay = 0.5 * (inverse.x + inverse.y) - inverse.z;
    let time = E_FOLDS / (scene.energy_loss * ell * growth.min(decay));
    let turns = 20.0 * std::f64::consts::PI / so3::norm(scene.start.body_angular_velocity(&scene.body));
    let high = [time, turns, 10.0].into_iter().find(|time| (1e-3..1e9).contains(time)).unwrap_or(10.0);
    Timeline { low: 0.0, high, first_flip: None, period: None }
}

/// Largest share of the momentum along the middle axis, `max |M₂|/ℓ`, over the whole motion.
fn nearest_to_middle(scene: &crate::scene::Scene) -> f64 {
    let inverse = scene.body.principal_moments().recip();
    let momentum = scene.start.body_momentum;
    let ell = so3::norm(momentum);
    // Σ sᵢ = 1 and Σ sᵢ/Iᵢ = e with s₁ = 0 or s₃ = 0, whichever side of the separatrix it is.
    let e = 2.0 * scene.start.energy(&scene.body) / ell / ell;
    let outer = if e < inverse.y { inverse.z } else { inverse.x };
    ((e - outer) / (inverse.y - outer)).clamp(0.0, 1.0).sqrt()
}
