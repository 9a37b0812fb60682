//! The exact motion in the standard position of its orbit, relative to the start.

use std::f64::consts::{PI, TAU};

use glam::{DQuat, DVec3};

use super::rates::rates;
use crate::physics::double_double::{self, DoubleDouble, Wide};
use crate::physics::elliptic::{self, Complementary, Real, Series};
use crate::physics::orbit::{Kind, Orbit};
use crate::physics::so3;

/// Attitude relative to the start, and momentum in units of the orbit, at any time in seconds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Path {
    shape: Shape,
    /// `B₁, s₂B₂, B₃`.
    amplitudes: DVec3,
    inverse_ell: f64,
    /// `σ = s₂`.
    handedness: f64,
    /// Two factors that take seconds to the orbit's units of time.
    units_from_seconds: [f64; 2],
    /// `u₀/4K`.
    start_turns: DoubleDouble,
    /// `λ/4K`, per unit of time.
    turn_rate: DoubleDouble,
    /// `ψ̄/4π`, per unit of time: turns of the half angle.
    half_angle_rate: DoubleDouble,
    /// `π/2K`, or `π/2K′` where the complementary nome serves.
    slope: f64,
    /// What is to be multiplied from the left: `(R_z(2σχ(u₀)) P(0))⁻¹`.
    start_inverse: DQuat,
}

#[derive(Clone, Copy, Debug)]
enum Shape {
    /// The momentum stays; the body turns about this axis by the half angle.
    Steady { axis: DVec3, momentum: DVec3 },
    /// χ by the real nome: coefficients of `sin 2nx` and `cos 2nx`, n = 1, 2.
    Real { series: Real, sines: [f64; 2], cosines: [f64; 2] },
    /// χ by the complementary nome: coefficients of `sinh(2n+1)b` and `cosh(2n+1)b`, n = 0…4, and `πη/4K′`.
    Complementary { series: Complementary, sines: [f64; 5], cosines: [f64; 5], slope: f64 },
    /// `k′ = 0`, with λ and u₀; χ is `−atan(tan(η/2) tanh(u/2))`.
    Hyperbolic { rate: DoubleDouble, start: DoubleDouble, sine: f64, cosine: f64 },
}

/// The numbers of a [`Path`] for an evaluation elsewhere, of many at a time.
pub(crate) struct PathNumbers {
    /// `λ/4K` and `ψ̄/4π`, per second.
    pub(crate) turn_rate: DoubleDouble,
    pub(crate) half_angle_rate: DoubleDouble,
    /// `u₀/4K`.
    pub(crate) start_turns: f64,
    /// `B₁, s₂B₂, B₃`, and the same over ℓ.
    pub(crate) amplitudes: DVec3,
    pub(crate) directions: DVec3,
    pub(crate) handedness: f64,
    pub(crate) series: SeriesNumbers,
}

/// Those of its series.
pub(crate) enum SeriesNumbers {
    Real { series: Real, sines: [f64; 2], cosines: [f64; 2] },
    Complementary { series: Complementary, slope: f64 },
}

/// Where the flips are this many e-folds apart, or more, the phase near them is a small difference that wants more digits than f64 has.
const LINGERING: f64 = 64.0;

/// Momentum over amplitudes, `[cn, sn, dn]`, and χ: a linear part and the angle of the vector `(x, y)`, of any length.
struct Point {
    functions: [f64; 3],
    linear: f64,
    chi: (f64, f64),
}

impl Path {
    pub(crate) fn new(orbit: &Orbit) -> Self {
        let two_pi = double_double::PI.scaled(2.0);
        let half_angle_rate = |rate: DoubleDouble| rate / two_pi.scaled(2.0);
        let ell = orbit.ell.value();
        let mut path = Self {
            shape: Shape::Steady { axis: DVec3::Z, momentum: orbit.momentum },
            amplitudes: orbit.amplitudes * DVec3::new(1.0, orbit.handedness, 1.0),
            inverse_ell: 1.0 / ell,
            handedness: orbit.handedness,
            units_from_seconds: orbit.units_from_seconds(),
            start_turns: DoubleDouble::ZERO,
            turn_rate: DoubleDouble::ZERO,
            half_angle_rate: DoubleDouble::ZERO,
            slope: 0.0,
            start_inverse: DQuat::IDENTITY,
        };
        if orbit.kind == Kind::Steady {
            if ell > 0.0 {
                // Every axis with a share of the momentum has the same moment; the largest share names it.
                let size = orbit.momentum.abs();
                let largest = (0..3).max_by(|&a, &b| size[a].total_cmp(&size[b])).unwrap_or(0);
                path.half_angle_rate = half_angle_rate(orbit.ell / orbit.exact_moments[largest]);
                path.shape = Shape::Steady { axis: orbit.momentum / ell, momentum: orbit.momentum };
            }
            return path;
        }

        let (k, k1) = (orbit.modulus, orbit.complementary_modulus);
        let [i1, _, i3] = orbit.moments.to_array();
        let [i21, _, i32] = orbit.differences.map(DoubleDouble::value);
        // κ, the slope of the separatrix: am(η, k′) = atan κ.
        let (rise, run) = ((i1 * i32).sqrt(), (i3 * i21).sqrt());
        if orbit.kind == Kind::Separatrix {
            path.half_angle_rate = half_angle_rate(orbit.ell / orbit.exact_moments[1]);
            let half = 0.5 * rise.atan2(run);
            let (sine, cosine) = half.sin_cos();
            path.shape = Shape::Hyperbolic { rate: orbit.rate, start: orbit.start_phase(), sine, cosine };
        } else {
            let (phase_rate, angle_rate) = rates(orbit);
            let quarter = orbit.quarter_period(phase_rate);
            path.turn_rate = phase_rate / two_pi;
            path.half_angle_rate = half_angle_rate(angle_rate);
            path.start_turns = orbit.start_phase() / quarter.scaled(4.0);
            path.slope = elliptic::arithmetic_geometric_mean(1.0, k.max(k1));
            let logarithm = -(orbit.complementary_rate / Wide::new(orbit.rate, 0)).logarithm();
            path.shape = match Series::new(k, k1, logarithm) {
                Series::Real(series) => real_shape(series, rise, run, k, quarter.value()),
                Series::Complementary(series) => {
                    let eta = elliptic::incomplete_by_modulus(rise, run, k);
                    complementary_shape(series, 0.5 * eta * elliptic::arithmetic_geometric_mean(1.0, k))
                }
                Series::Hyperbolic => path.shape,
            };
        }
        let start = path.point(0.0);
        path.start_inverse = path.frame(&start, 0.0, orbit.momentum).conjugate();
        path
    }

    /// Attitude relative to the start and momentum at a time (s).
    pub(crate) fn at(&self, time: f64) -> (DQuat, DVec3) {
        let (frame, momentum) = self.frame_at(time);
        (so3::renormalize(self.start_inverse * frame), momentum)
    }

    /// What stands to the left of [`Path::frame_at`] in the attitude.
    pub(crate) fn start_inverse(&self) -> DQuat {
        self.start_inverse
    }

    /// `R_z(ψ) P(M)` but for the value at the start, and momentum, at a time (s).
    pub(crate) fn frame_at(&self, time: f64) -> (DQuat, DVec3) {
        let time = self.in_units(time);
        let angle = TAU * phase(self.half_angle_rate, time);
        if let Shape::Steady { axis, momentum } = self.shape {
            let (sine, cosine) = angle.sin_cos();
            return (DQuat::from_xyzw(sine * axis.x, sine * axis.y, sine * axis.z, cosine), momentum);
        }
        let point = self.point(time);
        let momentum = self.amplitudes * DVec3::from_array(point.functions);
        (self.frame(&point, angle, momentum), momentum)
    }

    /// `[cn, sn, dn]` at a time (s).
    pub(crate) fn functions(&self, time: f64) -> [f64; 3] {
        self.point(self.in_units(time)).functions
    }

    /// Momentum where the functions are `[cn, sn, dn]`.
    pub(crate) fn momentum_of(&self, functions: [f64; 3]) -> DVec3 {
        match self.shape {
            Shape::Steady { momentum, .. } => momentum,
            _ => self.amplitudes * DVec3::from_array(functions),
        }
    }

    /// `[cn u, sn u, dn u]`, with the relative error of sn some ε however small u is.
    pub(crate) fn functions_at_phase(&self, u: f64) -> [f64; 3] {
        match &self.shape {
            Shape::Steady { .. } => [1.0, 0.0, 1.0],
            Shape::Real { series, .. } => {
                let (sine, cosine) = (self.slope * u).sin_cos();
                let [sn, cn, dn] = series.at(sine, cosine);
                [cn, sn, dn]
            }
            Shape::Complementary { series, .. } => {
                let v = self.slope * u;
                if v.abs() < 1.5 {
                    let [sn, cn, dn] = series.at_small(v);
                    return [cn, sn, dn];
                }
                let (sign, quarters) = elliptic::reduce(v / series.decay);
                let e = (-series.decay * quarters.abs()).exp();
                let [sn, cn, dn] = series.at(e, series.rise(e, quarters.abs()));
                [sign * cn, sign * sn.copysign(quarters), dn]
            }
            Shape::Hyperbolic { .. } => {
                let [_, cn, dn] = elliptic::hyperbolic(u);
                [cn, u.tanh(), dn]
            }
        }
    }

    /// Momentum at a time (s).
    pub(crate) fn momentum(&self, time: f64) -> DVec3 {
        self.momentum_of(self.functions(time))
    }

    /// Its numbers, where the momentum circles and no rate is at the end of the range of f64.
    pub(crate) fn numbers(&self) -> Option<PathNumbers> {
        let series = match self.shape {
            Shape::Real { series, sines, cosines } => SeriesNumbers::Real { series, sines, cosines },
            Shape::Complementary { series, slope, .. } if series.decay <= LINGERING => {
                SeriesNumbers::Complementary { series, slope }
            }
            _ => return None,
        };
        let [first, second] = self.units_from_seconds;
        let a_second = |rate: DoubleDouble| rate.scaled(first).scaled(second);
        let (turn_rate, half_angle_rate) = (a_second(self.turn_rate), a_second(self.half_angle_rate));
        let is_usual = |rate: DoubleDouble| (1e-100..1e100).contains(&rate.high.abs());
        (is_usual(turn_rate) && is_usual(half_angle_rate)).then_some(PathNumbers {
            turn_rate,
            half_angle_rate,
            start_turns: self.start_turns.high,
            amplitudes: self.amplitudes,
            directions: self.amplitudes * self.inverse_ell,
            handedness: self.handedness,
            series,
        })
    }

    /// `R_z(ψ) P(M)` with the half angle `ψ/2` as the given one and σχ.
    fn frame(&self, point: &Point, half_angle: f64, momentum: DVec3) -> DQuat {
        let m = momentum * self.inverse_ell;
        let (sine, cosine) = (half_angle + self.handedness * point.linear).sin_cos();
        let (chi_cosine, chi_sine) = (point.chi.0, self.handedness * point.chi.1);
        let (c, s) = (cosine * chi_cosine - sine * chi_sine, sine * chi_cosine + cosine * chi_sine);
        // P = (1 + m₃; m₂, −m₁, 0), the shortest rotation from m to e₃, is brought to unit length together with χ; m₃ ≥ 0.
        let w = 1.0 + m.z;
        let chi_square = chi_cosine * chi_cosine + chi_sine * chi_sine;
        let scale = 1.0 / ((w * w + m.x * m.x + m.y * m.y) * chi_square).sqrt();
        let (w, x, y) = (w * scale, m.y * scale, -m.x * scale);
        DQuat::from_xyzw(c * x - s * y, c * y + s * x, s * w, c * w)
    }

    fn in_units(&self, time: f64) -> f64 {
        (time * self.units_from_seconds[0] * self.units_from_seconds[1]).clamp(f64::MIN, f64::MAX)
    }

    /// At a time in the orbit's units.
    fn point(&self, time: f64) -> Point {
        let turns = double_double::beyond_whole(phase(self.turn_rate, time) + self.start_turns.high);
        match &self.shape {
            Shape::Steady { .. } => Point { functions: [1.0, 0.0, 1.0], chi: (1.0, 0.0), linear: 0.0 },
            Shape::Real { series, sines, cosines } => {
                let (sine, cosine) = (TAU * turns).sin_cos();
                let (s2, c2) = (2.0 * sine * cosine, 1.0 - 2.0 * sine * sine);
                let numerator = s2 * (sines[0] + 2.0 * sines[1] * c2);
                let denominator = 0.5 + cosines[0] * c2 + cosines[1] * (2.0 * c2 * c2 - 1.0);
                let [sn, cn, dn] = series.at(sine, cosine);
                Point { functions: [cn, sn, dn], chi: (denominator, numerator), linear: 0.0 }
            }
            Shape::Complementary { series, sines, cosines, slope } => {
                // u/K within ±1, half a period being 2K.
                let (rest, is_behind) = if series.decay > LINGERING {
                    turns_beyond_half(self.turn_rate, time, self.start_turns)
                } else if turns.abs() > 0.25 {
                    (turns - 0.5f64.copysign(turns), true)
                } else {
                    (turns, false)
                };
                let (sign, quarters) = (if is_behind { -1.0 } else { 1.0 }, 4.0 * rest);
                let e = (-series.decay * quarters.abs()).exp();
                let p = series.rise(e, quarters.abs());
                let [sn, cn, dn] = series.at(e, p);
                let (mut numerator, mut denominator) = (0.0, 0.0);
                let (mut power, mut odd) = (1.0, e);
                let e2 = e * e;
                for (sine, cosine) in sines.iter().zip(cosines) {
                    numerator += sine * power * (1.0 - odd);
                    denominator += cosine * power * (1.0 + odd);
                    power *= p;
                    odd *= e2;
                }
                // χ = slope u/K − atan2(…), odd in u.
                let numerator = if quarters < 0.0 { numerator } else { -numerator };
                Point {
                    functions: [sign * cn, sign * sn.copysign(quarters), dn],
                    chi: (denominator, numerator),
                    linear: slope * quarters,
                }
            }
            Shape::Hyperbolic { rate, start, sine, cosine } => {
                let u = hyperbolic_phase(*rate, time, *start);
                let [sn, cn, dn] = elliptic::hyperbolic(u);
                Point { functions: [cn, sn, dn], chi: (*cosine, -sine * (0.5 * u).tanh()), linear: 0.0 }
            }
        }
    }
}

/// The fraction of a turn that is left of rate × time; 0 where no digit of it is left.
fn phase(rate: DoubleDouble, time: f64) -> f64 {
    // Lest the splitting of a factor overflow.
    let (rate, time) = if time.abs() > 1e280 { (rate.scaled(1e32), time * 1e-32) } else { (rate, time) };
    let turns = rate.high * time;
    if turns.abs() < 1e32 { rate.fraction_of_product(time) } else { 0.0 }
}

/// [`phase`] plus the start's, beyond the nearest half turn, and whether that is an odd one.
fn turns_beyond_half(rate: DoubleDouble, time: f64, start: DoubleDouble) -> (f64, bool) {
    let is_lost = time.abs() > 1e280 || (rate.high * time).abs() >= 1e32;
    rate.beyond_half(if is_lost { 0.0 } else { time }, start)
}

/// `λt + u₀`. A start far from the flip wants more digits of it than f64 has; beyond some 700 on either side nothing is left of the flip.
fn hyperbolic_phase(rate: DoubleDouble, time: f64, start: DoubleDouble) -> f64 {
    let rough = rate.high * time;
    if start.high.abs() < 16.0 || rough.abs() > 1e4 { rough + start.high } else { (rate * time + start).value() }
}

/// `(−1)ⁿ q^(2n²)` times `sinh 2ny` and `cosh 2ny`, `y = πη/2K`.
fn real_shape(series: Real, rise: f64, run: f64, k: f64, quarter: f64) -> Shape {
    let q = series.nome();
    let (mut sines, mut cosines) = ([0.0; 2], [0.0; 2]);
    if q > 0.0 {
        // e^(2y) = e^(−π(K′−η)/K)/q: the growing part is taken with its small factor.
        let eta = elliptic::incomplete_by_modulus(rise, run, k);
        let rest = elliptic::incomplete_by_modulus(run, rise * k, k);
        let grow = (-PI * rest / quarter).exp();
        let shrink = (-PI * eta / quarter).exp();
        let up = [q * grow, q.powi(6) * grow * grow];
        let down = [q * q * shrink, q.powi(8) * shrink * shrink];
        for n in 0..2 {
            let sign = if n == 0 { -0.5 } else { 0.5 };
            sines[n] = sign * (up[n] - down[n]);
            cosines[n] = sign * (up[n] + down[n]);
        }
    }
    Shape::Real { series, sines, cosines }
}

/// `Q^(n²)` times the sine and cosine of `(2n+1)a`.
fn complementary_shape(series: Complementary, slope: f64) -> Shape {
    let nome = series.root_of_nome;
    let (mut sines, mut cosines) = ([0.0; 5], [0.0; 5]);
    for n in 0..5 {
        let (sine, cosine) = (f64::from(2 * n + 1) * slope).sin_cos();
        let weight = nome.powi(n * n);
        sines[n as usize] = sine * weight;
        cosines[n as usize] = cosine * weight;
    }
    Shape::Complementary { series, sines, cosines, slope }
}
