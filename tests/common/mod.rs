//! What the tests of the physics share: the reference cases, a seeded generator, random bodies, an independent integrator.
#![allow(dead_code, clippy::expect_used, reason = "each test file uses its own part and fails by its own asserts")]

pub(crate) mod taylor;

use dzhanibekov::physics::{Body, State, so3};
use glam::{DMat3, DVec3};

pub(crate) const EPS: f64 = f64::EPSILON;

/// A case of the reference file: attitudes from 60-digit arithmetic.
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) body: Body,
    pub(crate) start: State,
    /// `(t, R, M)`.
    pub(crate) samples: Vec<(f64, DMat3, DVec3)>,
}

impl Case {
    /// `|Ω|` at the start (rad/s).
    pub(crate) fn rate(&self) -> f64 {
        self.start.body_angular_velocity(&self.body).length()
    }
}

/// A vector of the reference files.
pub(crate) fn vector(value: &serde_json::Value) -> DVec3 {
    DVec3::from_array([0, 1, 2].map(|i| value[i].as_f64().expect("the reference file has numbers here")))
}

pub(crate) fn reference_cases() -> Vec<Case> {
    let text = include_str!("../free_rigid_body.json");
    let file: serde_json::Value = serde_json::from_str(text).expect("the reference file is JSON");
    let cases = file["cases"].as_array().expect("a list of cases").iter().map(|case| {
        let body = Body::from_moments(vector(&case["moments"])).expect("a body");
        let start = State::new(&body, DMat3::IDENTITY, vector(&case["omega"]));
        let samples = case["samples"].as_array().expect("samples").iter().map(|sample| {
            let rows = DMat3::from_cols(vector(&sample["R"][0]), vector(&sample["R"][1]), vector(&sample["R"][2]));
            (sample["t"].as_f64().expect("a time"), rows.transpose(), vector(&sample["L"]))
        });
        Case { name: case["name"].as_str().expect("a name").to_owned(), body, start, samples: samples.collect() }
    });
    cases.collect()
}

pub(crate) fn reference_case(name: &str) -> Case {
    reference_cases().into_iter().find(|case| case.name == name).expect("a case of that name")
}

/// `SplitMix64`: the same numbers on every machine.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In `[0, 1)`.
    pub(crate) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * 2f64.powi(-53)
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub(crate) fn below(&mut self, count: u64) -> u64 {
        self.bits() % count
    }

    pub(crate) fn vector(&mut self) -> DVec3 {
        DVec3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0))
    }

    pub(crate) fn rotation(&mut self) -> DMat3 {
        so3::exp(3.0 * self.vector())
    }
}

/// What an adversary would choose: moments of every ratio, equal, almost equal, impossible, and momenta anywhere, near and on the
/// axes and the separatrix. Sizes stay near 1.
pub(crate) fn random_motion(random: &mut Random) -> (DVec3, DVec3) {
    let tiny = |random: &mut Random| 10f64.powf(random.between(-16.0, -1.0));
    let mut moments = match random.below(6) {
        0 => {
            let edges = DVec3::new(random.between(0.1, 1.0), random.between(0.1, 1.0), random.between(0.1, 1.0));
            let s = edges * edges;
            DVec3::new(s.y + s.z, s.z + s.x, s.x + s.y)
        }
        1 => DVec3::new(10f64.powf(random.between(-8.0, 0.0)), 10f64.powf(random.between(-8.0, 0.0)), 1.0),
        2 => DVec3::new(random.between(0.1, 1.0), 1.0, 1.0 + tiny(random)),
        3 => DVec3::new(1.0, 1.0 + tiny(random), random.between(1.1, 2.0)),
        4 => DVec3::new(1.0, 1.0, 1.0 + random.unit()),
        _ => DVec3::new(1.0, 1.0 + tiny(random), 1.0 + 2.0 * tiny(random)),
    };
    let mut sorted = moments.to_array();
    sorted.sort_by(f64::total_cmp);
    moments = DVec3::from_array(sorted);
    let sign = |random: &mut Random| if random.below(2) == 0 { 1.0 } else { -1.0 };
    let mut momentum = match random.below(6) {
        0 | 1 => random.vector(),
        2 => {
            let mut m = random.vector() * tiny(random);
            m[random.below(3) as usize] = sign(random);
            m
        }
        3 | 4 => {
            // M₁ = κM₃ (1 + tiny).
            let slope =
                (moments.x * (moments.z - moments.y) / (moments.z * (moments.y - moments.x).max(1e-300))).sqrt();
            let m3 = random.unit() * if random.below(2) == 0 { 1.0 } else { tiny(random) };
            let off = if random.below(4) == 0 { 0.0 } else { tiny(random) };
            DVec3::new(m3 * slope.min(1e3) * (1.0 + off), sign(random), m3 * sign(random))
        }
        _ => {
            let mut m = random.vector();
            m[random.below(3) as usize] = 0.0;
            m
        }
    };
    if random.below(2) == 0 {
        momentum = -momentum;
    }
    (moments, momentum)
}

/// The state with a given body momentum.
pub(crate) fn state_of(body: &Body, attitude: DMat3, momentum: DVec3) -> State {
    State::new(body, attitude, body.angular_velocity(momentum))
}

/// Distance of two matrices that are nearly rotations, as an angle (rad).
pub(crate) fn attitude_error(a: DMat3, b: DMat3) -> f64 {
    so3::frobenius_norm(a - b) / 2f64.sqrt()
}

pub(crate) fn assert_at_most(value: f64, bound: f64, what: &str) {
    assert!(value <= bound, "{what}: {value:e} is above {bound:e}");
}
