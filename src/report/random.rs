//! Bodies at random.

use glam::{DMat3, DVec3};

use crate::physics::{Body, State};

/// `SplitMix64` (Steele, Lea & Flood 2014).
pub(super) struct Random(u64);

impl Random {
    /// From a seed: the same ones each time.
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Evenly in `low..high`.
    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.next() >> 11) as f64 * f64::EPSILON * 0.5)
    }

    /// A box with edges between 0.1 and 1 m, turning about a random direction of momentum.
    pub(super) fn body_in_motion(&mut self) -> (Body, State) {
        loop {
            if let Some(found) = self.try_body_in_motion() {
                return found;
            }
        }
    }

    fn try_body_in_motion(&mut self) -> Option<(Body, State)> {
        let edges = DVec3::new(self.between(0.1, 1.0), self.between(0.1, 1.0), self.between(0.1, 1.0));
        let side = DVec3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0));
        if side.length_squared() > 1.0 || side.length_squared() < 1e-3 {
            return None;
        }
        // The box's moments in ascending order, so that body and principal frame are one.
        let moments = Body::solid_box(edges, 12.0).ok()?.principal_moments();
        let body = Body::from_moments(moments).ok()?;
        let start = State::new(&body, DMat3::IDENTITY, side.normalize() / moments);
        Some((body, start))
    }
}
