//! The exact step: Moser and Veselov's discrete body, its moments calibrated so that one step is the motion itself.

use glam::{DMat3, DQuat, DVec3};

use super::{Failure, Keeps, Method, Order, Problem, Stepper};
use crate::physics::exact::Path;
use crate::physics::orbit::Orbit;
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
    cost: "three square roots, two divisions, no trigonometric function",
    source: "Moser & Veselov, Comm. Math. Phys. 139 (1991) 217, calibrated on the closed form",
    start: |problem| Box::new(ExactStep::new(problem)),
};

/// A step that would turn the body, or its momentum's phase, by this angle (rad) or more is taken by the closed form instead:
/// from a quarter turn on the half-turn quaternion of a step has a second branch.
const LARGEST_TURN: f64 = 1.2;

/// The body in the standard position of its orbit.
///
/// With the step's rotation `RₙᵀRₙ₊₁` as the quaternion `f = (f₀, 𝐟)` the discrete body obeys
/// `(h/2)(Mₙ + Mₙ₊₁) = 2f₀ Ĩ𝐟`. On one orbit there is `Ĩ⁻¹ = αI⁻¹ + β` with which its steps are those of the body, not for
/// small h alone but exactly. A step:
///
/// 1. `Mₙ₊₁ = (B₁ cn, s₂B₂ sn, B₃ dn)(u + λh)` by the addition theorem;
/// 2. `𝐠 = f₀𝐟 = (h/4) Ĩ⁻¹(Mₙ + Mₙ₊₁)`;
/// 3. `f₀² = (1 + √(1 − 4|𝐠|²))/2`, `𝐟 = 𝐠/f₀`, `R ← R f`.
///
/// A steady motion, and a step of [`LARGEST_TURN`] or more, is taken by the closed form, which the same object holds.
#[derive(Clone)]
struct ExactStep {
    path: Path,
    orbit: Orbit,
    attitude: DQuat,
    /// `[cn, sn, dn]`.
    functions: [f64; 3],
    /// The time is `origin + count |step|`, so that no rounding piles up.
    origin: f64,
    count: i64,
    calibration: Calibration,
}

/// What a step of one length needs.
#[derive(Clone, Copy)]
struct Calibration {
    step: f64,
    /// `[cn, sn, dn]` of λh; `None` where the closed form takes the step.
    increment: Option<[f64; 3]>,
    /// `(h/4) Ĩ⁻¹ (B₁, s₂B₂, B₃)`.
    weights: DVec3,
}

impl ExactStep {
    fn new(problem: &Problem) -> Self {
        let orbit = Orbit::new(problem.moments, problem.momentum, problem.momentum_tail);
        let path = Path::new(&orbit);
        Self {
            path,
            orbit,
            attitude: DQuat::IDENTITY,
            functions: path.functions(0.0),
            origin: 0.0,
            count: 0,
            calibration: Calibration { step: 0.0, increment: None, weights: DVec3::ZERO },
        }
    }

    fn time(&self) -> f64 {
        self.origin + self.count as f64 * self.calibration.step.abs()
    }

    /// The attitude, turned the shortest way so that it takes M to L: the two recurrences drift apart by their rounding, and
    /// this leaves of it only what turns about L.
    fn upright(&self) -> DQuat {
        let ell = self.orbit.ell.value();
        if ell == 0.0 {
            return self.attitude;
        }
        let now = self.attitude * (self.path.momentum_of(self.functions) / ell);
        let start = self.orbit.momentum / ell;
        let axis = now.cross(start);
        (DQuat::from_xyzw(axis.x, axis.y, axis.z, 1.0 + now.dot(start)) * self.attitude).normalize()
    }

    fn calibrate(&mut self, step: f64) {
        if step.abs() != self.calibration.step.abs() {
            self.origin = self.time();
            self.count = 0;
        }
        if step != self.calibration.step {
            self.calibration = Calibration::new(&self.orbit, &self.path, step);
        }
    }
}

impl Stepper for ExactStep {
    fn advance(&mut self, step: f64, count: u64) -> Result<(), Failure> {
        self.calibrate(step);
        let signed = count.min(i64::MAX as u64).cast_signed();
        self.count += if step < 0.0 { -signed } else { signed };
        let Some(increment) = self.calibration.increment else {
            self.attitude = self.path.at(self.time()).0;
            self.functions = self.path.functions(self.time());
            return Ok(());
        };
        let weights = self.calibration.weights;
        let (k2, k1_2) = (self.orbit.modulus.powi(2), self.orbit.complementary_modulus.powi(2));
        let mut now = self.functions;
        let mut attitude = self.attitude;
        for _ in 0..count {
            let next = add(now, increment, k2, k1_2);
            let g = weights * (DVec3::from_array(now) + DVec3::from_array(next));
            let square = 0.5 + 0.5 * (1.0 - 4.0 * g.length_squared()).sqrt();
            let inverse = 1.0 / square.sqrt();
            let turn = DQuat::from_xyzw(g.x * inverse, g.y * inverse, g.z * inverse, square * inverse);
            attitude = so3::renormalize(attitude * turn);
            now = next;
        }
        self.functions = now;
        self.attitude = attitude;
        Ok(())
    }

    fn attitude(&self) -> DMat3 {
        let principal_from_standard = self.orbit.principal_from_standard;
        principal_from_standard * DMat3::from_quat(self.upright()) * principal_from_standard.transpose()
    }

    fn momentum(&self) -> DVec3 {
        let momentum = self.path.momentum_of(self.functions);
        self.orbit.principal_from_standard * (momentum * self.orbit.momentum_unit)
    }

    fn duplicate(&self) -> Box<dyn Stepper> {
        Box::new(self.clone())
    }
}

/// `[cn, sn, dn](u + v)` by the addition theorem (DLMF 22.8), `sn = (s c₁d₁ + c s₁d)/D`, `cn = (c c₁ − s s₁ d d₁)/D`.
///
/// The squares of the two numerators add up to `(c₁² + s₁²d²)(c² + s²d₁²)` whatever the numbers, and both factors are D; with
/// their mean in its place `sn² + cn² = 1` keeps itself. dn is taken from `dn² = k′² + k² cn²`, relatively exact however
/// small it is: by a recurrence of its own it would leave that curve exponentially beside the separatrix.
fn add([c, s, d]: [f64; 3], [c1, s1, d1]: [f64; 3], k2: f64, k1_2: f64) -> [f64; 3] {
    let inverse = 2.0 / (((c1 * c1) + (s1 * s1) * (d * d)) + (c * c + (d1 * d1) * (s * s)));
    let cosine = (c * c1 - (s1 * d1) * s * d) * inverse;
    let sine = ((c1 * d1) * s + s1 * (c * d)) * inverse;
    [cosine, sine, (k1_2 + k2 * (cosine * cosine)).sqrt()]
}

impl Calibration {
    /// Finds `Ĩ⁻¹ = αI⁻¹ + β` from the step that is symmetric about `u = 0`, from −w to w, `w = λh/2`.
    ///
    /// Its rotation has `𝐟 = (c m₂ + s m₁, 0, (s(a² + m₂² − m₁²) − 2c m₁m₂)/2a)`, `m = M(w)/ℓ`, `a = 1 + m₃`, with
    /// `(c, s)` cosine and sine of `ψ/2 = ∫₀^w ψ̇ du/λ`. The change of M in a step gives `α = f₀² sn w/(w cn w dn w)`; β is then linear
    /// in 𝐟. Everything that a step adds up comes out with a small relative error: ψ by quadrature of the
    /// positive ψ̇, not as a difference of phases.
    fn new(orbit: &Orbit, path: &Path, step: f64) -> Self {
        let closed = Self { step, increment: None, weights: DVec3::ZERO };
        let rate = orbit.rate.value();
        let (b, i) = (orbit.amplitudes * DVec3::new(1.0, orbit.handedness, 1.0), orbit.moments);
        // |Ω|² is linear in sn²: largest at one of the two ends of a quarter period.
        let at_0 = (b / i * DVec3::new(1.0, 0.0, 1.0)).length();
        let at_quarter = (b / i * DVec3::new(0.0, 1.0, orbit.complementary_modulus)).length();
        let turn = at_0.max(at_quarter).max(rate) * step.abs();
        // Not so for a turn that is not a number.
        if !(rate > 0.0 && turn < LARGEST_TURN && turn > 0.0) {
            return closed;
        }
        let w = 0.5 * rate * step;
        let [cn, sn, dn] = path.small(w);
        let ell = orbit.ell.value();
        let m = b * DVec3::new(cn, sn, dn) / ell;
        let half_angle = half_angle(orbit, path, w) / rate;
        let (s, c) = half_angle.sin_cos();
        let a = 1.0 + m.z;
        let f = DVec3::new(
            c * m.y + s * m.x,
            0.0,
            (s * (a * a + (m.y - m.x) * (m.y + m.x)) - 2.0 * c * m.x * m.y) / (2.0 * a),
        );
        let f0_squared = 1.0 - f.length_squared();
        let alpha = f0_squared * sn / (w * cn * dn);
        let sum = 2.0 * b * DVec3::new(cn, 0.0, dn);
        let wanted = 4.0 / step * f0_squared.sqrt() * f;
        let beta = sum.dot(wanted - alpha * sum / i) / sum.length_squared();
        let weights = 0.25 * step * (alpha / i + beta) * b;
        let increment = path.small(rate * step);
        if weights.is_finite() { Self { increment: Some(increment), weights, ..closed } } else { closed }
    }
}

/// `∫₀^w ψ̇ du` with `ψ̇ = ℓ/I₃ + (2E − ℓ²/I₃)/(ℓ + M₃)`, by Gauss' rule of ten points. The nearest singularity is `K′ ≥ π/2` off the real
/// line, w at most 0.6, so that the rule's error is below 1e-19.
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
        let m3 = orbit.amplitudes.z * path.small(u)[2];
        (twice_energy + ell * m3 / i.z) / (ell + m3)
    };
    let half = 0.5 * w;
    half * NODES.iter().map(|(x, weight)| weight * (rate(half * (1.0 - x)) + rate(half * (1.0 + x)))).sum::<f64>()
}
