//! What was before each change, so that every one of them can be taken back.

use std::mem::Discriminant;

use web_time::{Duration, Instant};

use super::slides::Opened;
use crate::scene::SceneFile;
use crate::ui::Command;

/// Most changes that can be taken back.
const MOST: usize = 200;
/// Changes of one kind that follow each other faster than this are one: a drag of a slider.
const ONE_CHANGE: Duration = Duration::from_millis(800);

/// What kind of change a command is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A change of its own, however fast the next one follows.
    Whole,
    /// Part of a change that goes on for as long as commands of this kind follow each other.
    Part(Discriminant<Command>),
}

impl Kind {
    /// The kind of a command's change; none for those that take changes back or make them again.
    pub(super) fn of(command: &Command) -> Option<Self> {
        match command {
            Command::Undo | Command::Redo => None,
            Command::SetBody(_)
            | Command::SetTilt(_)
            | Command::SetRate(_)
            | Command::SetEnergy(_)
            | Command::SetStep(_)
            | Command::SetEnergyLoss(_)
            | Command::DragTip(_) => Some(Self::Part(std::mem::discriminant(command))),
            _ => Some(Self::Whole),
        }
    }
}

/// What a change is taken back to.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Moment {
    /// The scene's text.
    pub(super) file: SceneFile,
    /// What it came from.
    pub(super) opened: Opened,
    /// The step of its telling.
    pub(super) at: Option<usize>,
    /// Simulated time (s).
    pub(super) time: f64,
}

/// The moments before and after.
#[derive(Clone, Debug, Default)]
pub(super) struct Undo {
    past: Vec<Moment>,
    future: Vec<Moment>,
    last: Option<(Kind, Instant)>,
}

impl Undo {
    /// Notes how it stood before a change.
    pub(super) fn note(&mut self, kind: Kind, before: Moment, now: Instant) {
        let goes_on = self
            .last
            .is_some_and(|(last, at)| kind != Kind::Whole && last == kind && now.duration_since(at) < ONE_CHANGE);
        self.last = Some((kind, now));
        self.future.clear();
        if goes_on {
            return;
        }
        self.past.push(before);
        if self.past.len() > MOST {
            self.past.remove(0);
        }
    }

    /// The moment to go back to, from how it stands now.
    pub(super) fn back(&mut self, now: Moment) -> Option<Moment> {
        let moment = self.past.pop()?;
        self.future.push(now);
        self.last = None;
        Some(moment)
    }

    /// The moment to go on to again, from how it stands now.
    pub(super) fn on(&mut self, now: Moment) -> Option<Moment> {
        let moment = self.future.pop()?;
        self.past.push(now);
        self.last = None;
        Some(moment)
    }

    /// Whether there is anything to take back, and to make again.
    pub(super) fn can(&self) -> (bool, bool) {
        (!self.past.is_empty(), !self.future.is_empty())
    }
}
