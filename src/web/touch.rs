//! Fingers: one orbits, taps and slides as a pointer does, two move and zoom, one that is held takes M along.

use egui::{Event, Modifiers, PointerButton, Pos2, Rect, TouchDeviceId, TouchId, TouchPhase, Vec2};

use crate::ui::{Command, Pixels};

/// How long (ms) a finger rests before it takes M along.
const LONG_PRESS: f64 = 450.0;
/// How far (points) it may stray while it rests.
const STILL: f32 = 10.0;

/// What a finger did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Phase {
    /// It came down.
    Down,
    /// It moved.
    Moved,
    /// It went up, or was taken away by the browser.
    Up,
}

/// A finger.
#[derive(Clone, Copy, Debug)]
pub(super) struct Finger {
    /// Which one.
    pub(super) id: i32,
    /// Where, in CSS pixels of the canvas.
    pub(super) at: [f32; 2],
    /// What it did.
    pub(super) phase: Phase,
}

/// Where the picture is, for fingers over it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// The picture (points).
    pub(super) picture: Rect,
    /// CSS pixels a point.
    pub(super) zoom: f32,
    /// Device pixels a point.
    pub(super) pixels_per_point: f32,
}

impl Place {
    fn point(&self, at: [f32; 2]) -> Pos2 {
        Pos2::new(at[0], at[1]) / self.zoom
    }

    fn pixels(&self, by: Vec2) -> Pixels {
        Pixels::new(by.x, by.y) * self.pixels_per_point
    }

    fn within(&self, point: Pos2) -> Pixels {
        self.pixels(point - self.picture.min)
    }
}

/// What the fingers are about.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum About {
    /// None is down.
    #[default]
    Nothing,
    /// One is a pointer: since when (ms) it rests where it came down over the picture.
    Pointer { rests: Option<(f64, Pos2)> },
    /// One takes M along.
    Momentum,
    /// Two move and zoom.
    View { middle: Pos2, apart: f32 },
    /// What they were about is over; they are still to go up.
    Over,
}

/// The fingers on the canvas.
#[derive(Debug, Default)]
pub(super) struct Fingers {
    down: Vec<(i32, Pos2)>,
    about: About,
    /// The pointer was taken from the panels in this frame: what it seems to have asked for it has not.
    is_taken: bool,
}

impl Fingers {
    /// Takes what a finger did at a time (ms); it becomes events of a pointer, or commands.
    pub(super) fn take(
        &mut self,
        finger: Finger,
        now: f64,
        place: &Place,
        (events, commands): (&mut Vec<Event>, &mut Vec<Command>),
    ) {
        let at = place.point(finger.at);
        match finger.phase {
            Phase::Down => {
                self.down.retain(|(id, _)| *id != finger.id);
                self.down.push((finger.id, at));
            }
            Phase::Moved => match self.down.iter_mut().find(|(id, _)| *id == finger.id) {
                Some((_, old)) => *old = at,
                None => return,
            },
            Phase::Up => self.down.retain(|(id, _)| *id != finger.id),
        }
        match (self.about, finger.phase, self.down.as_slice()) {
            (About::Nothing, Phase::Down, _) => {
                let is_over_picture = place.picture.contains(at);
                self.about = About::Pointer { rests: is_over_picture.then_some((now, at)) };
                events.extend([touched(at), Event::PointerMoved(at), button(at, true)]);
            }
            (About::Pointer { .. }, Phase::Down, [(_, first), (_, second)])
                if place.picture.contains(*first) && place.picture.contains(*second) =>
            {
                let (first, second) = (*first, *second);
                self.take_pointer(first, events);
                self.about = About::View { middle: first + (second - first) / 2.0, apart: first.distance(second) };
            }
            (About::Pointer { rests }, Phase::Moved, [(id, _), ..]) if *id == finger.id => {
                if rests.is_some_and(|(_, from)| from.distance(at) > STILL) {
                    self.about = About::Pointer { rests: None };
                }
                events.push(Event::PointerMoved(at));
            }
            (About::Pointer { .. }, Phase::Up, []) => {
                self.about = About::Nothing;
                events.extend([Event::PointerMoved(at), button(at, false), Event::PointerGone]);
            }
            (About::Momentum, Phase::Moved, _) => commands.push(Command::DragTip(place.within(at))),
            (About::View { middle, apart }, Phase::Moved, [(_, first), (_, second)]) => {
                let (new, now_apart) = (*first + (*second - *first) / 2.0, first.distance(*second));
                let at = place.within(middle);
                commands.push(Command::Pan { at, by: place.pixels(new - middle) });
                if apart > 0.0 && now_apart > 0.0 {
                    commands.push(Command::Zoom { at, by: now_apart / apart });
                }
                self.about = About::View { middle: new, apart: now_apart };
            }
            (About::Momentum | About::View { .. } | About::Over, Phase::Up, rest) => {
                self.about = if rest.is_empty() { About::Nothing } else { About::Over };
                self.is_taken = true;
            }
            _ => {}
        }
    }

    /// Looks whether a finger has rested long enough; says how long (ms) it still has to.
    pub(super) fn rest(
        &mut self,
        now: f64,
        place: &Place,
        (events, commands): (&mut Vec<Event>, &mut Vec<Command>),
    ) -> Option<f64> {
        let About::Pointer { rests: Some((since, at)) } = self.about else { return None };
        let left = since + LONG_PRESS - now;
        if left > 0.0 {
            return Some(left);
        }
        self.take_pointer(at, events);
        self.about = About::Momentum;
        commands.push(Command::DragTip(place.within(at)));
        None
    }

    /// Whether a command of the panels comes from a pointer that no longer was one.
    pub(super) fn refuse(&self, command: &Command) -> bool {
        let is_pointers = matches!(
            command,
            Command::Pick(_)
                | Command::Orbit { .. }
                | Command::Pan { .. }
                | Command::DragTip(_)
                | Command::Hover(Some(_))
        );
        is_pointers && (self.is_taken || !matches!(self.about, About::Nothing | About::Pointer { .. }))
    }

    /// A frame is over.
    pub(super) fn end_frame(&mut self) {
        self.is_taken = false;
    }

    /// Ends the pointer that the first finger was.
    fn take_pointer(&mut self, at: Pos2, events: &mut Vec<Event>) {
        self.is_taken = true;
        events.extend([button(at, false), Event::PointerGone]);
    }
}

/// That there are fingers, for without one egui lets nothing be scrolled by dragging what it holds. It is gone at once: what fingers do
/// is a pointer's doing.
fn touched(pos: Pos2) -> Event {
    Event::Touch { device_id: TouchDeviceId(0), id: TouchId(0), phase: TouchPhase::Cancel, pos, force: None }
}

fn button(pos: Pos2, pressed: bool) -> Event {
    Event::PointerButton { pos, button: PointerButton::Primary, pressed, modifiers: Modifiers::NONE }
}
