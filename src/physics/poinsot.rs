//! The geometry of the free motion: Poinsot's ellipsoids, curves and times, as pure functions.
//!
//! In momentum space (body frame) the tip of M runs along the polhode, where the momentum sphere `|M| = ℓ` cuts the energy
//! ellipsoid `½ M·I⁻¹M = K`. In the space of angular velocities the inertia ellipsoid `½ Ω·IΩ = K` rolls without slipping on
//! the invariable plane `ω·L/ℓ = 2K/ℓ`; the contact point is ω, its track on the ellipsoid the polhode again, on the
//! plane the herpolhode. Source: Poinsot, Théorie nouvelle de la rotation des corps (1834); Landau & Lifshitz, Mechanics, §37.
//!
//! Points are in the body frame unless a name says otherwise, whether or not its axes are principal. SI units.

use std::f64::consts::TAU;

use glam::{DMat3, DVec3};

use super::double_double::DoubleDouble;
use super::orbit::{Kind, Orbit};
use super::start::Start;
use super::{Body, Motion, State, so3};

/// What kind of motion a momentum is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionClass {
    /// No momentum.
    AtRest,
    /// Three equal moments: every spin is steady.
    Sphere,
    /// Two equal moments: steady precession about the third axis, which has this number (1 or 3). A spin exactly
    /// about an axis in the plane of the equal two belongs here as well.
    Symmetric {
        /// The axis of symmetry.
        axis: u8,
    },
    /// A steady spin about principal axis 1, 2 or 3, exactly.
    PureSpin {
        /// The axis.
        axis: u8,
    },
    /// The momentum circles axis 1, of the smallest moment.
    AboutAxis1,
    /// The momentum circles axis 3, of the largest moment.
    AboutAxis3,
    /// Between the two: one flip in all time.
    Separatrix,
}

impl MotionClass {
    /// In plain words.
    #[must_use]
    pub fn label(self) -> &'static str {
        match self {
            Self::AtRest => "at rest",
            Self::Sphere => "steady spin: all axes are alike",
            Self::Symmetric { .. } => "steady precession of a symmetric body",
            Self::PureSpin { axis: 2 } => "pure spin about axis 2, unstable",
            Self::PureSpin { axis: 1 } => "pure spin about axis 1, stable",
            Self::PureSpin { .. } => "pure spin about axis 3, stable",
            Self::AboutAxis1 => "momentum circles axis 1",
            Self::AboutAxis3 => "momentum circles axis 3",
            Self::Separatrix => "on the separatrix: it flips once",
        }
    }

    /// Whether a small disturbance stays small. (In the plane of two equal moments it grows, though not exponentially.)
    #[must_use]
    pub fn is_stable(self) -> bool {
        !matches!(self, Self::PureSpin { axis: 2 } | Self::Separatrix)
    }
}

/// The class of the motion that starts here: that of the numbers the start was given by, so that it never contradicts the motion.
///
/// Moments are equal, spins pure and starts on the separatrix only when they are so exactly.
#[must_use]
pub fn class_of(body: &Body, start: &State) -> MotionClass {
    let start = Start::new(body, start);
    let [i21, _, i32] = start.differences;
    let nonzero = start.momentum.map(|component| component.value.high != 0.0);
    let axis = match nonzero {
        [false, false, false] => return MotionClass::AtRest,
        [true, false, false] => 1,
        [false, true, false] => 2,
        [false, false, true] => 3,
        _ => 0,
    };
    match (i21.high == 0.0, i32.high == 0.0) {
        (true, true) => return MotionClass::Sphere,
        (true, false) if axis != 3 => return MotionClass::Symmetric { axis: 3 },
        (false, true) if axis != 1 => return MotionClass::Symmetric { axis: 1 },
        _ if axis != 0 => return MotionClass::PureSpin { axis },
        _ => {}
    }
    match start.difference.value.high {
        0.0 => MotionClass::Separatrix,
        above if above > 0.0 => MotionClass::AboutAxis3,
        _ => MotionClass::AboutAxis1,
    }
}

/// [`class_of`] the motion with this body momentum, as it is rounded: on the separatrix then means to rounding, `Δ₂` within 16ε of
/// the two terms whose difference it is.
#[must_use]
pub fn classify(body: &Body, body_momentum: DVec3) -> MotionClass {
    let class = class_of(body, &of_momentum(body_momentum));
    if !matches!(class, MotionClass::AboutAxis1 | MotionClass::AboutAxis3) {
        return class;
    }
    // Δ₂ = M₃²(I₃−I₂)/I₃ − M₁²(I₂−I₁)/I₁.
    let (i, m) = (body.principal_moments(), body.body_from_principal().transpose() * body_momentum);
    let [i21, _, i32] = body.moment_differences();
    let size = m.x.abs().max(m.z.abs());
    let about_3 = (m.z / size).powi(2) * (i32 / i.z);
    let about_1 = (m.x / size).powi(2) * (i21 / i.x);
    let is_near = (about_3 - about_1).abs() <= 16.0 * f64::EPSILON * (about_3 + about_1);
    if is_near { MotionClass::Separatrix } else { class }
}

/// Semi-axes `√(2K I_i)` (kg m²/s) of the energy ellipsoid in momentum space, along the principal axes.
#[must_use]
pub fn energy_semi_axes(body: &Body, energy: f64) -> DVec3 {
    body.principal_moments().map(f64::sqrt) * (2.0 * energy).sqrt()
}

/// Semi-axes `√(2K/I_i)` (rad/s) of the inertia ellipsoid in the space of angular velocities, along the principal axes.
#[must_use]
pub fn inertia_semi_axes(body: &Body, energy: f64) -> DVec3 {
    (2.0 * energy).sqrt() / body.principal_moments().map(f64::sqrt)
}

/// Distance `2K/ℓ` (rad/s) of the invariable plane from the fixed point; 0 at rest.
#[must_use]
pub fn invariable_plane_distance(body: &Body, body_momentum: DVec3) -> f64 {
    let ell = so3::norm(body_momentum);
    if ell == 0.0 { 0.0 } else { (body_momentum / ell).dot(body.angular_velocity(body_momentum)) }
}

/// The polhode in momentum space (kg m²/s): `points` points evenly in arc, the last one the first again.
///
/// `M = (B₁ cos φ, s₂B₂ sin φ, B₃ √(cos²φ + k′² sin²φ))`, φ the amplitude: no elliptic functions needed. Where the momentum
/// stays put all points are that momentum; on the separatrix the curve is the limit of its neighbours, two half great circles.
#[must_use]
pub fn polhode(body: &Body, body_momentum: DVec3, points: usize) -> Vec<DVec3> {
    sampled_polhode(body, body_momentum, points, |orbit| {
        orbit.with_momentum_unit(body.body_from_principal() * orbit.principal_from_standard)
    })
}

/// The polhode in the space of angular velocities (rad/s): [`polhode`] through `Ω = I⁻¹M`, again evenly in arc.
#[must_use]
pub fn angular_velocity_polhode(body: &Body, body_momentum: DVec3, points: usize) -> Vec<DVec3> {
    sampled_polhode(body, body_momentum, points, |orbit| {
        let inverse = DMat3::from_diagonal(orbit.moments.recip());
        orbit.with_rate_unit(body.body_from_principal() * orbit.principal_from_standard * inverse)
    })
}

/// Samples the polhode, mapped linearly, evenly in the arc of its image.
fn sampled_polhode(body: &Body, body_momentum: DVec3, points: usize, map: impl Fn(&Orbit) -> DMat3) -> Vec<DVec3> {
    let orbit = Orbit::of(body, body_momentum);
    let map = map(&orbit);
    if orbit.kind == Kind::Steady {
        return vec![map * orbit.momentum; points];
    }
    let at = |angle: f64| {
        let (sine, cosine) = angle.sin_cos();
        let slack = cosine.hypot(orbit.complementary_modulus * sine);
        map * (orbit.amplitudes * DVec3::new(cosine, orbit.handedness * sine, slack))
    };
    // Arc length to each of the nodes; eight to a point make the spacing even to about 1 %.
    let nodes = 8 * points.max(16);
    let node = |i: usize| at(TAU * i as f64 / nodes as f64);
    let mut arc = vec![0.0];
    let mut length = 0.0;
    let mut last = node(0);
    for i in 1..=nodes {
        let next = node(i % nodes);
        length += so3::norm(next - last);
        arc.push(length);
        last = next;
    }
    let mut result: Vec<DVec3> = (1..points)
        .map(|i| {
            let wanted = length * (i - 1) as f64 / (points - 1) as f64;
            let right = arc.partition_point(|&a| a <= wanted).clamp(1, nodes);
            let span = arc[right] - arc[right - 1];
            let part = if span > 0.0 { (wanted - arc[right - 1]) / span } else { 0.0 };
            at(TAU * ((right - 1) as f64 + part) / nodes as f64)
        })
        .collect();
    if let Some(&first) = result.first() {
        result.push(first);
    }
    result
}

/// The separatrix on the momentum sphere of radius ℓ (kg m²/s): two great circles `M₁ = ±κM₃` of `points` points each, the
/// last one the first again; `κ² = I₁(I₃−I₂)/(I₃(I₂−I₁))`. `None` where two moments are equal.
#[must_use]
pub fn separatrix(body: &Body, ell: f64, points: usize) -> Option<[Vec<DVec3>; 2]> {
    let [across, along] = separatrix_direction(body)?;
    let circle = |sign: f64| {
        let direction = DVec3::new(sign * across, 0.0, along);
        (0..points)
            .map(|n| {
                let turns = if n + 1 == points { 0.0 } else { n as f64 / (points - 1) as f64 };
                let (sine, cosine) = (TAU * turns).sin_cos();
                body.body_from_principal() * (ell * (cosine * direction + sine * DVec3::Y))
            })
            .collect()
    };
    Some([circle(1.0), circle(-1.0)])
}

/// The components 1 and 3 of a point of the separatrix, of length 1: `M₁/M₃ = κ` as in [`separatrix`]. With `|M|` the energy is a function of
/// `M₁² − κ²M₃²` alone: seen along axis 2 every path is a hyperbola about the separatrix. `None` where two moments are equal.
#[must_use]
pub fn separatrix_direction(body: &Body) -> Option<[f64; 2]> {
    let i = body.principal_moments();
    let [i21, _, i32] = body.moment_differences();
    if i21 == 0.0 || i32 == 0.0 {
        return None;
    }
    let (rise, run) = ((i.x / i.z * i32).sqrt(), i21.sqrt());
    let size = rise.hypot(run);
    Some([rise / size, run / size])
}

/// The herpolhode: world angular velocity `ω = RΩ` (rad/s) at `points` times from 0 to a duration (s), evenly in time. It lies in
/// the invariable plane and, unlike the polhode, need not close.
#[must_use]
pub fn herpolhode(body: &Body, start: &State, duration: f64, points: usize) -> Vec<DVec3> {
    let motion = Motion::new(body, start);
    let last = points.saturating_sub(1).max(1) as f64;
    (0..points).map(|n| motion.state(duration * (n as f64 / last)).world_angular_velocity(body)).collect()
}

/// Inner and outer radius (rad/s) of the annulus in the invariable plane that the herpolhode touches in turn, about the
/// foot of the momentum. `|M × Ω|/ℓ` where the polhode crosses its planes of symmetry, as products that do not cancel.
/// Equal for a symmetric body, 0 for a steady spin; on the separatrix the inner one is 0.
#[must_use]
pub fn herpolhode_radii(body: &Body, body_momentum: DVec3) -> (f64, f64) {
    let orbit = Orbit::of(body, body_momentum);
    if orbit.kind == Kind::Steady {
        return (0.0, 0.0);
    }
    let (b, i) = (orbit.amplitudes, orbit.moments);
    let [_, i31, i32] = orbit.differences.map(DoubleDouble::value);
    let ell = orbit.ell.value();
    let [first, second] = orbit.units_from_seconds();
    let through_1 = b.x * b.z / ell * (i31 / (i.x * i.z)) * first * second;
    let through_2 = b.y * b.z / ell * orbit.complementary_modulus * (i32 / (i.y * i.z)) * first * second;
    (through_1.min(through_2), through_1.max(through_2))
}

/// Time (s) between flips, the reversals of `M₂`: `2K(k)/λ = π/M(λ, λk′)`, of the motion that starts here.
///
/// `None` where it never reverses, or only once: a steady spin, the separatrix, a body with two equal moments (it has
/// no middle axis). Relative error some ε.
#[must_use]
pub fn flip_period_of(body: &Body, start: &State) -> Option<f64> {
    let orbit = Orbit::new(&Start::new(body, start));
    orbit.half_period().filter(|_| flips(&orbit))
}

/// [`flip_period_of`] the motion that starts with this momentum, as it is rounded.
#[must_use]
pub fn flip_period(body: &Body, body_momentum: DVec3) -> Option<f64> {
    flip_period_of(body, &of_momentum(body_momentum))
}

/// Time (s) from the start to the middle of the next flip, where `M₂` passes through 0.
///
/// `None` where no flip comes: where there are none at all, and on the separatrix after its one.
#[must_use]
pub fn next_flip_of(body: &Body, start: &State) -> Option<f64> {
    let orbit = Orbit::new(&Start::new(body, start));
    orbit.next_passage().filter(|_| flips(&orbit))
}

/// [`next_flip_of`] the motion that starts with this momentum, as it is rounded.
#[must_use]
pub fn next_flip(body: &Body, body_momentum: DVec3) -> Option<f64> {
    next_flip_of(body, &of_momentum(body_momentum))
}

/// Growth rate (1/s) of a small tilt from the middle axis at momentum ℓ: `σ = Ω₂ √((I₃−I₂)(I₂−I₁)/(I₁I₃))`, `Ω₂ = ℓ/I₂`.
/// The tilt grows as `e^{σt}`, so that one ten times smaller delays the flip by about `2 ln 10/σ`.
/// 0 where two moments are equal.
#[must_use]
pub fn growth_rate(body: &Body, ell: f64) -> f64 {
    let i = body.principal_moments();
    let [i21, _, i32] = body.moment_differences();
    ell / i.y * (i32 / i.z).sqrt() * (i21 / i.x).sqrt()
}

fn flips(orbit: &Orbit) -> bool {
    let [i21, _, i32] = orbit.differences;
    orbit.kind != Kind::Steady && i21.high != 0.0 && i32.high != 0.0
}

fn of_momentum(body_momentum: DVec3) -> State {
    State::from_parts(DMat3::IDENTITY, body_momentum, body_momentum)
}
