//! Many bodies, or many starts of one body, at a time.

mod block;
mod closed;
mod column;
mod functions;
mod steps;

use fearless_simd::Level;
use glam::{DMat3, DVec3};

use closed::Closed;
use steps::Steps;

use super::exact::Motion;
use super::orbit::Orbit;
use super::{Body, State};

/// Many motions, taken side by side: [`Batch::advance`] steps along all of them by exact steps, and [`Batch::states_at`] goes to any
/// time at once.
///
/// ```
/// use dzhanibekov::glam::{DMat3, DVec3};
/// use dzhanibekov::physics::{Batch, Body, State};
///
/// fn main() -> Result<(), dzhanibekov::physics::BodyError> {
///     // A thousand starts that differ by a thousandth of a degree in all.
///     let body = Body::solid_box(DVec3::new(0.20, 0.12, 0.04), 1.0)?;
///     let start = |n: u32| State::new(&body, DMat3::IDENTITY, DVec3::new(0.0, 6.0, 1e-7 * f64::from(n)));
///     let starts: Vec<State> = (1..=1000).map(start).collect();
///     let mut batch = Batch::of_starts(&body, &starts);
///
///     // Ten seconds later they are all over the place.
///     let momenta = batch.momenta_at(10.0);
///     assert!(momenta.iter().any(|m| m.y < 0.0) && momenta.iter().any(|m| m.y > 0.0));
///
///     // By a thousand steps they come to the same.
///     batch.advance(0.01, 1000);
///     let size = starts[0].body_momentum.length();
///     let reached = batch.states();
///     assert!(reached.iter().zip(&momenta).all(|(state, m)| state.body_momentum.distance(*m) < 1e-7 * size));
///     Ok(())
/// }
/// ```
///
/// The results are those of [`Motion`] and of the exact step for each body alone, within the same bounds: attitudes within
/// `8ε(1 + |Ω|t)` by steps of any length, and within some ε at any time in closed form. They are the same bits from run to
/// run on one machine; on another, whose processor multiplies and adds in one operation where this one does not, they may differ within
/// those bounds.
///
/// Several bodies are held in each register, as many as the processor has room for, which is found out as the program runs.
#[derive(Clone, Debug)]
pub struct Batch {
    level: Level,
    members: Vec<Member>,
    closed: Closed,
    steps: Steps,
}

/// One of the motions.
#[derive(Clone, Debug)]
struct Member {
    motion: Motion,
    orbit: Orbit,
}

impl Batch {
    /// Many starts of one body.
    #[must_use]
    pub fn of_starts(body: &Body, starts: &[State]) -> Self {
        Self::of_members(starts.iter().map(|start| (body, start)))
    }

    /// Many bodies, each with its start.
    #[must_use]
    pub fn of_bodies(bodies: &[(Body, State)]) -> Self {
        Self::of_members(bodies.iter().map(|(body, start)| (body, start)))
    }

    fn of_members<'a>(bodies: impl Iterator<Item = (&'a Body, &'a State)>) -> Self {
        let member = |(body, start)| {
            let (motion, orbit) = Motion::with_orbit(body, start);
            Member { motion, orbit }
        };
        let members: Vec<Member> = bodies.map(member).collect();
        Self { level: Level::new(), closed: Closed::new(&members), members, steps: Steps::default() }
    }

    /// The same, but with no more of the processor than every one of its kind has: to see what the rest is worth.
    #[must_use]
    pub fn on_any_processor(mut self) -> Self {
        self.level = Level::baseline();
        self
    }

    /// How many motions there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.members.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.members.is_empty()
    }

    /// Takes `count` exact steps (s, finite and above 0) with every body, backwards where `count` is negative.
    ///
    /// The first step of a length, or of the other direction, prepares its constants: 1 to 2 µs a body.
    pub fn advance(&mut self, step: f64, count: i64) {
        let signed_step = if count < 0 { -step } else { step };
        self.steps.advance(self.level, &self.members, signed_step, count.unsigned_abs());
    }

    /// Time to which the steps have led (s).
    #[must_use]
    pub fn time(&self) -> f64 {
        self.steps.time()
    }

    /// The states to which the steps have led.
    #[must_use]
    pub fn states(&self) -> Vec<State> {
        (0..self.members.len()).map(|index| self.steps.state(&self.members, index)).collect()
    }

    /// The states at a time (s), in closed form: no step is moved.
    #[must_use]
    pub fn states_at(&self, time: f64) -> Vec<State> {
        let mut states = Vec::new();
        self.states_into(time, &mut states);
        states
    }

    /// The same in a vector of one's own, which need not be made anew for each time.
    pub fn states_into(&self, time: f64, states: &mut Vec<State>) {
        states.resize(self.len(), State::from_parts(DMat3::IDENTITY, DVec3::ZERO, DVec3::ZERO));
        if time == 0.0 {
            for (state, member) in states.iter_mut().zip(&self.members) {
                *state = *member.motion.start();
            }
        } else {
            self.closed.states(self.level, &self.members, time, states);
        }
    }

    /// The body momenta (kg m²/s) at a time (s), in closed form: no step is moved.
    #[must_use]
    pub fn momenta_at(&self, time: f64) -> Vec<DVec3> {
        let mut momenta = Vec::new();
        self.momenta_into(time, &mut momenta);
        momenta
    }

    /// The same in a vector of one's own, which need not be made anew for each time.
    pub fn momenta_into(&self, time: f64, momenta: &mut Vec<DVec3>) {
        momenta.resize(self.len(), DVec3::ZERO);
        self.closed.momenta(self.level, &self.members, time, momenta);
    }
}
