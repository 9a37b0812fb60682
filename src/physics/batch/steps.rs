//! The exact step of many bodies: which of them lies where, and where the closed form takes the step.
#![allow(clippy::inline_always, reason = "what is not inlined has not the instructions of its caller")]

use fearless_simd::{Level, dispatch};
use glam::{DMat3, DQuat, DVec3};

use super::Member;
use super::block::{Attitude, BLOCK, Block};
use crate::physics::State;
use crate::physics::methods::{Increment, StepRotation, can_step};

/// Steps after which the attitudes are brought back to unit length: as the exact step of a single body does.
const STEPS_TO_UNIT: u32 = 64;

/// Where the steps have led.
#[derive(Clone, Debug, Default)]
pub(super) struct Steps {
    /// Of this length (s), forwards or backwards; 0 before the first.
    step: f64,
    /// The time is `origin + count |step|`, so that no rounding piles up.
    origin: f64,
    count: i64,
    /// Steps since the attitudes had a length near 1.
    since_unit: u32,
    blocks: Vec<Block>,
    places: Vec<Place>,
}

/// Where a body is.
#[derive(Clone, Debug)]
enum Place {
    /// The closed form takes its steps.
    Closed,
    /// In a lane of a block, with what leads half a step back to where it is.
    Lane { block: usize, lane: usize, half_back: Box<Increment> },
}

impl Steps {
    pub(super) fn time(&self) -> f64 {
        self.origin + self.count as f64 * self.step.abs()
    }

    /// Takes `count` steps (s, negative backwards).
    pub(super) fn advance(&mut self, level: Level, members: &[Member], step: f64, count: u64) {
        if step != self.step {
            self.prepare(members, step);
        }
        let signed = count.min(i64::MAX as u64).cast_signed();
        self.count += if step < 0.0 { -signed } else { signed };
        let first = self.since_unit;
        for block in &mut self.blocks {
            dispatch!(level, simd => run(simd, block, first, count));
        }
        self.since_unit = ((u64::from(first) + count) % u64::from(STEPS_TO_UNIT)) as u32;
    }

    /// Puts every body where steps of this length are taken with it.
    fn prepare(&mut self, members: &[Member], step: f64) {
        let now = self.time();
        let attitudes: Vec<Attitude> = (0..members.len()).map(|index| self.attitude(members, index)).collect();
        if step.abs() != self.step.abs() {
            (self.origin, self.count) = (now, 0);
        }
        self.step = step;
        self.blocks.clear();
        self.places.clear();
        // The block that is being filled, and how far, for either kind of step.
        let mut open = [(0, BLOCK); 2];
        for (member, attitude) in members.iter().zip(attitudes) {
            let (orbit, path) = (&member.orbit, member.motion.path());
            let [first, second] = orbit.units_from_seconds();
            let units = step * first * second;
            let rotation = StepRotation::new(orbit, path, units);
            let Some(rotation) = rotation.filter(|_| can_step(orbit, path.functions(now)[2])) else {
                self.places.push(Place::Closed);
                continue;
            };
            let (long, short) = StepRotation::increment(orbit, path, orbit.rate.value() * units);
            let short = short.filter(|_| rotation.is_short);
            let (block, lane) = &mut open[usize::from(short.is_some())];
            if *lane == BLOCK {
                (*block, *lane) = (self.blocks.len(), 0);
                self.blocks.push(Block::new(short.is_some()));
            }
            self.blocks[*block].put(*lane, path.functions(now + 0.5 * step), attitude, &rotation);
            match &short {
                Some(short) => self.blocks[*block].put_short(*lane, short),
                None => self.blocks[*block].put_long(*lane, &long),
            }
            let half_back = Box::new(rotation.half_back(orbit));
            self.places.push(Place::Lane { block: *block, lane: *lane, half_back });
            *lane += 1;
        }
    }

    fn attitude(&self, members: &[Member], index: usize) -> Attitude {
        if let Some(Place::Lane { block, lane, .. }) = self.places.get(index) {
            return self.blocks[*block].attitude(*lane);
        }
        let turned = members[index].motion.path().at(self.time()).0;
        Attitude { value: turned.to_array(), rest: [0.0; 4] }
    }

    /// The state of a body.
    pub(super) fn state(&self, members: &[Member], index: usize) -> State {
        let member = &members[index];
        let Some(Place::Lane { block, lane, half_back }) = self.places.get(index) else {
            return member.motion.state(self.time());
        };
        if self.count == 0 && self.origin == 0.0 {
            return *member.motion.start();
        }
        let block = &self.blocks[*block];
        let momentum = member.motion.path().momentum_of(half_back.add(block.functions(*lane)));
        let Attitude { value, rest } = block.attitude(*lane);
        let attitude = (DQuat::from_array(value) + DQuat::from_array(rest)).normalize();
        member.motion.state_of(DMat3::from_quat(upright(member, attitude, momentum)), momentum)
    }
}

/// Steps of one block, from so many steps after it had unit length.
#[inline(always)]
fn run<S: fearless_simd::Simd>(simd: S, block: &mut Block, first: u32, count: u64) {
    let mut since = first;
    let mut left = count;
    while left > 0 {
        let steps = left.min(u64::from(STEPS_TO_UNIT - since)) as u32;
        block.advance(simd, steps);
        left -= u64::from(steps);
        since += steps;
        if since == STEPS_TO_UNIT {
            block.restore_length();
            since = 0;
        }
    }
}

/// The attitude, turned the shortest way so that it takes M to L: the two recurrences drift apart by their rounding, and this
/// leaves of it only what turns about L.
fn upright(member: &Member, attitude: DQuat, momentum: DVec3) -> DQuat {
    let ell = member.orbit.ell.value();
    if ell == 0.0 {
        return attitude;
    }
    let now = attitude * (momentum / ell);
    let start = member.orbit.momentum / ell;
    let axis = now.cross(start);
    (DQuat::from_xyzw(axis.x, axis.y, axis.z, 1.0 + now.dot(start)) * attitude).normalize()
}
