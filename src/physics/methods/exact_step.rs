//! The exact step: Moser and Veselov's discrete body, its moments calibrated so that one step is the motion itself.

use std::f64::consts::PI;

use glam::{DMat3, DQuat, DVec3};

use super::{Dash, Failure, Hue, Keeps, Mark, Method, Order, Problem, Stepper};
use crate::physics::double_double::power_of_two;
use crate::physics::exact::Path;
use crate::physics::orbit::{Kind, Orbit};
use crate::physics::so3;

pub(super) const METHOD: Method = Method {
    name: "exact-step",
    label: "Exact step",
    order: Order::Exact,
    explicit: true,
    symplectic: true,
    keeps_momentum: Keeps::Exactly,
    keeps_rotation: Keeps::Exactly,
    keeps_energy: Keeps::Exactly,
    is_direct: false,
    cost: "one square root, one or two divisions, no trigonometric function",
    source: "Moser & Veselov, Comm. Math. Phys. 139 (1991) 217, calibrated on the closed form",
    hue: Hue { on_dark: 0x00f0_e442, on_light: 0x008f_8a00 },
    dash: Dash::Long,
    mark: Mark::Star,
    start: |problem| Box::new(ExactStep::new(problem)),
};

/// A step that would turn the body, or its momentum's phase, by this angle (rad) or more is taken by the closed form instead:
/// beyond a half turn a step no longer shows which way round the body went.
const LARGEST_TURN: f64 = PI;

/// Where dn is, or can become, smaller than this and grow again, the closed form takes the step: the squares underflow.
const SMALLEST: f64 = 1e-140;

/// Steps whose momenta are found side by side: each of them waits for a division, a square root and a dozen products in a row,
/// which several at a time hide.
const LANES: usize = 4;

/// Steps after which the attitude's quaternion is brought back to a length from 1 to 2. A step shortens it by `sech(π/2) = 0.4` at most, and
/// lengthens it by `1/cos ½ = 1.14`.
const STEPS_TO_UNIT: usize = 64;

/// An increment of the phase, or a turn (rad), below this is taken as a small change of what it is added to.
const SHORT: f64 = 1.0;

const NOTHING: DQuat = DQuat::from_xyzw(0.0, 0.0, 0.0, 0.0);

/// The body in the standard position of its orbit.
///
/// With the step's rotation `RₙᵀRₙ₊₁` as the quaternion `f = (f₀, 𝐟)` the discrete body obeys
/// `(h/2)(Mₙ + Mₙ₊₁) = 2f₀ Ĩ𝐟`. On one orbit there is `Ĩ⁻¹ = αI⁻¹ + β` with which its steps are those of the body, not for
/// small h alone but exactly. Solved for f that would be `𝐠 = f₀𝐟 = (h/4)Ĩ⁻¹(Mₙ + Mₙ₊₁)`, `f₀² = ½ ± √(¼ − |𝐠|²)`, with a double
/// root at a quarter turn. But let u be the phase halfway through the step, from `u − w` to `u + w`, `w = λh/2`. By the addition theorem
///
/// ```text
/// 𝐠 = (c₁ cn u, c₂ sn u, c₃ dn u)/D,   D = 1 − k² sn²w sn²u
/// ```
///
/// so that `f₀²D (D − f₀²D) = |𝐠|²D²` is linear in sn²u, and of the two factors one is constant on the whole orbit. It is the
/// first, `f₀² = A/D`, since with the second |Ω| would be constant as `h → 0`. A step is therefore linear in the three functions, has no
/// branch, and is as well-conditioned at a quarter turn as anywhere:
///
/// 1. `R ← R F` with the quaternion `F = √D f = (p₀, p₁ cn u, p₂ sn u, p₃ dn u)`, whose length does not matter;
/// 2. `u ← u + λh` by the addition theorem.
///
/// M itself is needed only where it is asked for, half a step back from u. The phases of [`LANES`] steps are held at once, and each is
/// moved on by as many steps; the closed form gives the first ones, and gives them anew when the length of the step or its sign changes.
///
/// The functions of the increment and F are close to 1 where the step is short. Rounded as they are they would turn each step by ε too
/// much or too little, always to the same side, `ε/h` in a unit of time. So both recurrences are sums, old plus change: [`ShortIncrement`]
/// makes the change of cn and sn from small quantities, and the attitude's is `q(F − 1)` of the whole round, with `F/p₀` for F where
/// turns are short. Rounding of the constants is then `ε` of the change, and what rounding leaves out of the sum goes into the next one
/// (Kahan, Comm. ACM 8 (1965) 40).
///
/// A steady motion, a step of [`LARGEST_TURN`] or more, and an orbit within [`SMALLEST`] of the separatrix are taken by the closed form,
/// which the same object holds. Error: functions and `F − 1` are good to a few ε, relatively, at any such step however short,
/// and what rounding takes from the phase does not grow by itself: `8ε(1 + |Ω|t)` in the attitude, `1e-13` in the energy.
///
/// Source: the step is Moser and Veselov's, the addition theorem DLMF 22.8; `f₀² = A/D` is derived here, and a test measures it.
#[derive(Clone)]
struct ExactStep {
    path: Path,
    orbit: Orbit,
    rounds: Rounds,
    /// The time is `origin + count |step|`, so that no rounding piles up.
    origin: f64,
    count: i64,
    calibration: Calibration,
}

/// What a step changes.
#[derive(Clone)]
struct Rounds {
    /// At the start of this round, of any length.
    attitude: DQuat,
    /// What the sum left out of the attitude.
    attitude_rest: DQuat,
    /// The steps of this round that were taken turn by `1 + this`.
    turn: DQuat,
    /// Halfway through each of the steps of this round.
    lanes: Lanes,
    /// Steps of this round that were taken.
    lane: usize,
    /// Steps since the attitude had such a length, a round that was broken off counted as a whole one.
    steps_from_unit: usize,
}

/// cn, sn and dn of several phases, and what the sums left out of the first two.
#[derive(Clone, Copy, Default)]
struct Lanes {
    cn: [f64; LANES],
    sn: [f64; LANES],
    dn: [f64; LANES],
    cn_rest: [f64; LANES],
    sn_rest: [f64; LANES],
}

/// What a step of one length needs.
#[derive(Clone, Copy)]
struct Calibration {
    step: f64,
    /// `None` where the closed form takes the step.
    constants: Option<Constants>,
}

#[derive(Clone, Copy)]
struct Constants {
    /// `p₀ − 1` and `(p₁, p₂, p₃)`.
    scalar: f64,
    weights: DVec3,
    /// By [`LANES`] steps, the second where they are short, and by half a step back.
    round: Increment,
    short_round: Option<ShortIncrement>,
    half_back: Increment,
}

/// cn, sn, dn of what is to be added to a phase, in the products in which they are needed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Increment {
    pub(crate) cn: f64,
    pub(crate) sn: f64,
    pub(crate) cn_dn: f64,
    pub(crate) sn_dn: f64,
    pub(crate) cn_squared: f64,
    pub(crate) sn_squared: f64,
    pub(crate) dn_squared: f64,
    /// `k′² sn²`.
    pub(crate) least: f64,
    /// `k²` and `k′²`.
    pub(crate) k2: f64,
    pub(crate) k1_2: f64,
}

/// The same for an increment of [`SHORT`] at most: all of these are as small as it, with a small relative error.
#[derive(Clone, Copy)]
pub(crate) struct ShortIncrement {
    pub(crate) sn: f64,
    pub(crate) sn_dn: f64,
    /// `k² sn²`, `1 − cn` and `1 − cn dn`.
    pub(crate) squared: f64,
    pub(crate) beyond_cn: f64,
    pub(crate) beyond_cn_dn: f64,
    pub(crate) k2: f64,
    pub(crate) k1_2: f64,
}

/// The rotation of a step, for steps of any number at a time.
pub(crate) struct StepRotation {
    /// `p₀ − 1` and `(p₁, p₂, p₃)`.
    pub(crate) scalar: f64,
    pub(crate) weights: DVec3,
    /// Half of what a step adds to the phase: [cn, sn, dn].
    half: [f64; 3],
    /// Whether the turn is below [`SHORT`].
    pub(crate) is_short: bool,
}

/// Whether an orbit can be stepped along from where dn is the given one: its squares do not underflow.
pub(crate) fn can_step(orbit: &Orbit, dn: f64) -> bool {
    let comes_back = orbit.kind == Kind::Circling || dn < SMALLEST;
    !(orbit.complementary_modulus < SMALLEST && comes_back)
}

impl ExactStep {
    fn new(problem: &Problem) -> Self {
        let orbit = Orbit::new(&problem.start);
        Self {
            path: Path::new(&orbit),
            orbit,
            rounds: Rounds {
                attitude: DQuat::IDENTITY,
                attitude_rest: NOTHING,
                turn: NOTHING,
                lanes: Lanes::default(),
                lane: 0,
                steps_from_unit: 0,
            },
            origin: 0.0,
            count: 0,
            calibration: Calibration { step: 0.0, constants: None },
        }
    }

    fn time(&self) -> f64 {
        self.origin + self.count as f64 * self.calibration.step.abs()
    }

    /// In units of the orbit.
    fn standard_momentum(&self) -> DVec3 {
        let Some(constants) = &self.calibration.constants else { return self.path.momentum(self.time()) };
        self.path.momentum_of(constants.half_back.add(self.rounds.lanes.get(self.rounds.lane)))
    }

    /// The attitude, turned the shortest way so that it takes M to L: the two recurrences drift apart by their rounding, and
    /// this leaves of it only what turns about L.
    fn upright(&self, momentum: DVec3) -> DQuat {
        let ell = self.orbit.ell.value();
        let rounds = &self.rounds;
        let attitude = rounds.attitude + (rounds.attitude * rounds.turn + rounds.attitude_rest);
        if ell == 0.0 {
            return attitude.normalize();
        }
        // All of it times ℓ² and the squared length of the attitude; what is left is brought to unit length once.
        let unit = attitude.length_squared();
        let now = so3::rotate_scaled(attitude, momentum);
        let start = self.orbit.momentum;
        let axis = now.cross(start);
        let upright = DQuat::from_xyzw(axis.x, axis.y, axis.z, unit * ell * ell + now.dot(start));
        (upright * attitude).normalize()
    }

    fn calibrate(&mut self, step: f64) {
        if step == self.calibration.step {
            return;
        }
        if step.abs() != self.calibration.step.abs() {
            self.origin = self.time();
            self.count = 0;
        }
        self.calibration.step = step;
        let now = self.time();
        self.calibration = Calibration::new(&self.orbit, &self.path, step);
        if !can_step(&self.orbit, self.path.functions(now)[2]) {
            self.calibration.constants = None;
        }
        self.rounds.lane = 0;
        self.rounds.end_turn();
        for lane in 0..LANES {
            self.rounds.lanes.set(lane, self.path.functions(now + (lane as f64 + 0.5) * step));
        }
    }
}

impl Rounds {
    fn advance(&mut self, constants: &Constants, count: u64) {
        let mut left = count;
        while left > 0 {
            if self.lane == 0 && left >= LANES as u64 {
                for lane in 0..LANES {
                    self.turn(constants, lane);
                }
                self.next_round(constants);
                left -= LANES as u64;
                continue;
            }
            self.turn(constants, self.lane);
            self.lane += 1;
            if self.lane == LANES {
                self.lane = 0;
                self.next_round(constants);
            }
            left -= 1;
        }
    }

    /// One step; always the same bits, however many are asked for at a time.
    #[inline]
    fn turn(&mut self, constants: &Constants, lane: usize) {
        let [cn, sn, dn] = self.lanes.get(lane);
        let weights = constants.weights;
        let step = DQuat::from_xyzw(weights.x * cn, weights.y * sn, weights.z * dn, constants.scalar);
        self.turn = if lane == 0 { step } else { self.turn + (step + self.turn * step) };
    }

    /// The attitude by the turns of this round.
    #[inline]
    fn end_turn(&mut self) {
        self.add_to_attitude(self.attitude * self.turn);
        self.turn = NOTHING;
        self.steps_from_unit += LANES;
        if self.steps_from_unit >= STEPS_TO_UNIT {
            // By a power of two, which rounds nothing.
            let unit = power_of_two(self.attitude.length()).recip();
            self.attitude *= unit;
            self.attitude_rest *= unit;
            self.steps_from_unit = 0;
        }
    }

    #[inline]
    fn add_to_attitude(&mut self, change: DQuat) {
        let change = change + self.attitude_rest;
        let sum = self.attitude + change;
        self.attitude_rest = change - (sum - self.attitude);
        self.attitude = sum;
    }

    /// After the last step of a round.
    #[inline]
    fn next_round(&mut self, constants: &Constants) {
        match &constants.short_round {
            Some(increment) => self.lanes.add_short(increment),
            None => self.lanes.add(&constants.round),
        }
        self.end_turn();
    }
}

impl Stepper for ExactStep {
    fn advance(&mut self, step: f64, count: u64) -> Result<(), Failure> {
        self.calibrate(step);
        let signed = count.min(i64::MAX as u64).cast_signed();
        self.count += if step < 0.0 { -signed } else { signed };
        if let Some(constants) = &self.calibration.constants {
            self.rounds.advance(constants, count);
        } else {
            self.rounds.attitude = self.path.at(self.time()).0;
            self.rounds.attitude_rest = NOTHING;
        }
        Ok(())
    }

    fn attitude(&self) -> DMat3 {
        self.now().0
    }

    fn momentum(&self) -> DVec3 {
        self.standard_momentum()
    }

    fn now(&self) -> (DMat3, DVec3) {
        let momentum = self.standard_momentum();
        (DMat3::from_quat(self.upright(momentum)), momentum)
    }

    fn principal_from_own(&self) -> DMat3 {
        self.orbit.principal_from_standard
    }

    fn duplicate(&self) -> Box<dyn Stepper> {
        Box::new(self.clone())
    }
}

impl Lanes {
    fn get(&self, lane: usize) -> [f64; 3] {
        [self.cn[lane], self.sn[lane], self.dn[lane]]
    }

    fn set(&mut self, lane: usize, [cn, sn, dn]: [f64; 3]) {
        (self.cn[lane], self.sn[lane], self.dn[lane]) = (cn, sn, dn);
        (self.cn_rest[lane], self.sn_rest[lane]) = (0.0, 0.0);
    }

    #[inline]
    fn add(&mut self, increment: &Increment) {
        for lane in 0..LANES {
            self.set(lane, increment.add(self.get(lane)));
        }
    }

    #[inline]
    fn add_short(&mut self, increment: &ShortIncrement) {
        for lane in 0..LANES {
            let [c, s, _] = self.get(lane);
            let [cn_change, sn_change] = increment.change(self.get(lane));
            let (cn_change, sn_change) = (cn_change + self.cn_rest[lane], sn_change + self.sn_rest[lane]);
            // Back to their circle, to first order.
            let (cosine, sine) = (c + cn_change, s + sn_change);
            let beyond = 0.5 * ((1.0 - sine * sine) - cosine * cosine);
            let (cn_change, sn_change) = (cn_change + cosine * beyond, sn_change + sine * beyond);
            let (cosine, sine) = (c + cn_change, s + sn_change);
            self.set(lane, [cosine, sine, (increment.k1_2 + increment.k2 * (cosine * cosine)).sqrt()]);
            (self.cn_rest[lane], self.sn_rest[lane]) = (cn_change - (cosine - c), sn_change - (sine - s));
        }
    }
}

impl Increment {
    pub(crate) fn new(orbit: &Orbit, [cn, sn, dn]: [f64; 3]) -> Self {
        let (k2, k1_2) = (orbit.modulus.powi(2), orbit.complementary_modulus.powi(2));
        Self {
            cn,
            sn,
            cn_dn: cn * dn,
            sn_dn: sn * dn,
            cn_squared: cn * cn,
            sn_squared: sn * sn,
            dn_squared: dn * dn,
            least: k1_2 * (sn * sn),
            k2,
            k1_2,
        }
    }

    /// `[cn, sn, dn](u + v)` by the addition theorem (DLMF 22.8), `sn = (s c₁d₁ + c s₁d)/D`, `cn = (c c₁ − s s₁ d d₁)/D`,
    /// `D = c₁² + s₁²d²`.
    ///
    /// Beside the separatrix c, d and D are small, and a long increment towards the middle axis would leave no digit of the difference in
    /// cn; from `(c c₁)² − (s s₁ d d₁)² = D (c²d₁² − k′²s₁²)` it is a quotient that keeps them. But that has a difference too, of which nothing
    /// is left where an increment of a quarter period starts at `sn = 0`. With Σ the sum of the two products and Σ′ that of the two squares, the
    /// quotient is wrong by `εΣ′/Σ` and the plain difference by `εΣ/D`: the better is taken. As neither square is above D, it is below `√2 ε`,
    /// and what matters beside the separatrix, the error over dn, is some ε too.
    ///
    /// sn and cn are brought back to their circle to first order, and dn is taken from `dn² = k′² + k² cn²`, relatively exact however
    /// small it is: by a recurrence of its own it would leave that curve exponentially.
    #[inline]
    pub(crate) fn add(&self, [c, s, d]: [f64; 3]) -> [f64; 3] {
        let denominator = self.cn_squared + self.sn_squared * (d * d);
        let inverse = 1.0 / denominator;
        let (minuend, subtrahend) = (c * self.cn, (s * d) * self.sn_dn);
        let first = (c * c) * self.dn_squared;
        let (sum, rest) = (minuend + subtrahend, minuend - subtrahend);
        // Where all are too small to be squared the quotient is taken, and is 0.
        let is_quotient = sum.abs() > rest.abs() && sum * sum >= denominator * (first + self.least);
        let cosine = if is_quotient { (first - self.least) / sum } else { rest * inverse };
        let sine = (s * self.cn_dn + (c * d) * self.sn) * inverse;
        let scale = 1.5 - 0.5 * (cosine * cosine + sine * sine);
        let cosine = cosine * scale;
        [cosine, sine * scale, (self.k1_2 + self.k2 * (cosine * cosine)).sqrt()]
    }
}

impl ShortIncrement {
    pub(crate) fn new(orbit: &Orbit, [cn, sn, dn]: [f64; 3]) -> Self {
        let (k2, k1_2) = (orbit.modulus.powi(2), orbit.complementary_modulus.powi(2));
        let squared = k2 * (sn * sn);
        let beyond_cn = sn * sn / (1.0 + cn);
        let beyond_dn = squared / (1.0 + dn);
        let beyond_cn_dn = beyond_cn + beyond_dn * cn;
        Self { sn, sn_dn: sn * dn, squared, beyond_cn, beyond_cn_dn, k2, k1_2 }
    }

    /// What the addition theorem, with `D = 1 − k²s²s₁²`, adds to cn and sn:
    /// `D Δsn = s(k²s²s₁² − (1 − c₁d₁)) + c d s₁`, `D Δcn = c(k²s²s₁² − (1 − c₁)) − s d s₁d₁`.
    ///
    /// No digit is lost here as the increment gets small, and D is above `sech² 1 = 0.4`.
    #[inline]
    fn change(&self, [c, s, d]: [f64; 3]) -> [f64; 2] {
        let common = self.squared * (s * s);
        let inverse = 1.0 / (1.0 - common);
        let cn_change = (c * (common - self.beyond_cn) - (s * d) * self.sn_dn) * inverse;
        let sn_change = (s * (common - self.beyond_cn_dn) + (c * d) * self.sn) * inverse;
        [cn_change, sn_change]
    }
}

impl StepRotation {
    /// Finds F from the step that is symmetric about `u = 0`, from −w to w, and from `Ĩ⁻¹ = αI⁻¹ + β`.
    ///
    /// Its rotation is `P(−w)ᵀ R_z(ψ) P(w)`, by the shortest rotations P that take M to axis 3:
    /// `f₀ = (c(a² + m₁² − m₂²) − 2s m₁m₂)/2a`, `𝐟 = (c m₂ + s m₁, 0, (s(a² + m₂² − m₁²) − 2c m₁m₂)/2a)`, with `m = M(w)/ℓ`, `a = 1 + m₃` and
    /// `(c, s)` cosine and sine of `ψ/2 = ∫₀^w ψ̇ du/λ`. There `D = 1`, so that `p₀ = f₀`, `p₁ = f₁`, `p₃ = f₃`. The change of M in a step
    /// gives `α = f₀² sn w/(w cn w dn w)`, f₁ and f₃ give β, and both give p₂. Everything that a step adds up comes out
    /// with a small relative error: ψ by quadrature of the positive ψ̇, not as a difference of phases.
    ///
    /// `None` where the closed form is to take the step.
    pub(crate) fn new(orbit: &Orbit, path: &Path, step: f64) -> Option<Self> {
        let rate = orbit.rate.value();
        let (b, i) = (orbit.amplitudes * DVec3::new(1.0, orbit.handedness, 1.0), orbit.moments);
        // |Ω|² is linear in sn²: largest at one of the two ends of a quarter period.
        let at_0 = (b / i * DVec3::new(1.0, 0.0, 1.0)).length();
        let at_quarter = (b / i * DVec3::new(0.0, 1.0, orbit.complementary_modulus)).length();
        let turn = at_0.max(at_quarter).max(rate) * step.abs();
        // Not so for a turn that is not a number.
        if !(rate > 0.0 && turn < LARGEST_TURN && turn > 0.0) {
            return None;
        }
        let w = 0.5 * rate * step;
        let [cn, sn, dn] = path.functions_at_phase(w);
        let m = b * DVec3::new(cn, sn, dn) / orbit.ell.value();
        let (s, c) = (half_angle(orbit, path, w) / rate).sin_cos();
        let a = 1.0 + m.z;
        let (difference, twice_product) = ((m.y - m.x) * (m.y + m.x), 2.0 * m.x * m.y);
        let f0 = (c * (a * a - difference) - s * twice_product) / (2.0 * a);
        let f1 = c * m.y + s * m.x;
        let f3 = (s * (a * a + difference) - c * twice_product) / (2.0 * a);
        // α and β times cn w dn w/f₀.
        let alpha = f0 * sn / w;
        let both = 2.0 / step * DVec3::new(f1 * dn, 0.0, f3 * cn) - alpha * b / i;
        let beta = (b.x * both.x + b.z * both.z) / (b.x * b.x + b.z * b.z);
        let weights = DVec3::new(f1, 0.5 * step * b.y * (alpha / i.y + beta), f3);
        // Where the step is short the length of F is chosen so that nothing is left of `p₀ − 1` to be rounded.
        let is_short = turn < SHORT;
        let (scalar, weights) = if is_short { (0.0, weights / f0) } else { (f0 - 1.0, weights) };
        (weights.is_finite() && f0.is_finite()).then_some(Self { scalar, weights, half: [cn, sn, dn], is_short })
    }

    /// What is to be added to the phase halfway through a step for that at its start.
    pub(crate) fn half_back(&self, orbit: &Orbit) -> Increment {
        let [cn, sn, dn] = self.half;
        Increment::new(orbit, [cn, -sn, dn])
    }

    /// What adds this to a phase, and the same in small quantities where it is short.
    pub(crate) fn increment(orbit: &Orbit, path: &Path, phase: f64) -> (Increment, Option<ShortIncrement>) {
        let functions = path.functions_at_phase(phase);
        let short = (phase.abs() < SHORT).then(|| ShortIncrement::new(orbit, functions));
        (Increment::new(orbit, functions), short)
    }
}

impl Calibration {
    fn new(orbit: &Orbit, path: &Path, step: f64) -> Self {
        let constants = StepRotation::new(orbit, path, step).map(|rotation| {
            let (round, short_round) = StepRotation::increment(orbit, path, LANES as f64 * orbit.rate.value() * step);
            let StepRotation { scalar, weights, .. } = rotation;
            Constants { scalar, weights, round, short_round, half_back: rotation.half_back(orbit) }
        });
        Self { step, constants }
    }
}

/// `∫₀^w ψ̇ du` with `ψ̇ = ℓ/I₃ + (2E − ℓ²/I₃)/(ℓ + M₃)`, by Gauss' rule of ten points. The nearest singularity is `K′ ≥ π/2` off the real
/// line, so that the rule's error is below 1e-18 over π/4; w is at most twice that.
fn half_angle(orbit: &Orbit, path: &Path, w: f64) -> f64 {
    const NODES: [(f64, f64); 5] = [
        (0.148_874_338_981_631_2, 0.295_524_224_714_752_87),
        (0.433_395_394_129_247_2, 0.269_266_719_309_996_35),
        (0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
        (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
        (0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
    ];
    let ell = orbit.ell.value();
    let (m, i) = (orbit.momentum, orbit.moments);
    let twice_energy = m.dot(m / i);
    let rate = |u: f64| {
        let m3 = orbit.amplitudes.z * path.functions_at_phase(u)[2];
        (twice_energy + ell * m3 / i.z) / (ell + m3)
    };
    let panels = if w.abs() > 0.6 { 2 } else { 1 };
    let half = 0.5 * w / f64::from(panels);
    let panel = |n: i32| {
        let middle = f64::from(2 * n + 1);
        NODES.iter().map(|(x, weight)| weight * (rate(half * (middle - x)) + rate(half * (middle + x)))).sum::<f64>()
    };
    half * (0..panels).map(panel).sum::<f64>()
}
