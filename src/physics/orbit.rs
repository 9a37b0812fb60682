//! The orbit of the momentum on its sphere, put in standard position: the start of everything that is exact.
//!
//! The axes are relabelled, by signed permutations that round nothing, so that the momentum circles axis 3 on the side
//! `M₃ > 0` and starts with `M₁ ≥ 0`. Then `M = (B₁ cn u, s₂B₂ sn u, B₃ dn u)` with `u = λt + u₀`. After
//! relabelling `I₁ < I₂ < I₃` or `I₁ > I₂ > I₃`; only the sizes of the differences enter here, and `s₂` is the sign.
//! Every quantity is a sum or a product of positive terms but for one difference, `Δ₂`, which decides between
//! the two families of orbits; that one is taken in double-double.

use std::f64::consts::FRAC_PI_2;

use glam::{DMat3, DVec3};

use super::double_double::DoubleDouble;
use super::{Body, elliptic};

/// What the momentum does on its sphere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// It stays where it is: `M × Ω = 0`, at rest included.
    Steady,
    /// It goes round axis 3.
    Circling,
    /// It runs from one end of the middle axis to the other, once, in infinite time.
    Separatrix,
}

/// See the module. Moments and momenta are in units of their own size (powers of two), time in `moment_unit/momentum_unit`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Orbit {
    pub(crate) kind: Kind,
    /// Takes components in standard position to principal components: a signed permutation.
    pub(crate) principal_from_standard: DMat3,
    pub(crate) moments: DVec3,
    /// The momentum at the start.
    pub(crate) momentum: DVec3,
    /// `ℓ = |M|`.
    pub(crate) ell: DoubleDouble,
    /// `B₁, B₂, B₃`.
    pub(crate) amplitudes: DVec3,
    /// `s₂`: 1 about the largest moment, −1 about the smallest.
    pub(crate) handedness: f64,
    /// `λ`, the rate of u.
    pub(crate) rate: DoubleDouble,
    /// `λk′`.
    pub(crate) complementary_rate: DoubleDouble,
    /// The modulus `k` and the complementary modulus `k′`, each from its own product.
    pub(crate) modulus: f64,
    pub(crate) complementary_modulus: f64,
    /// The units; that of time is their quotient, which may be out of the range of f64.
    pub(crate) moment_unit: f64,
    pub(crate) momentum_unit: f64,
}

/// Moments further apart than this are taken as this far apart, so that no product here leaves the range of f64: `2⁻¹⁸⁰`.
const SMALLEST_RATIO: f64 = 6.525_304_467_998_525e-55;

/// Components of the momentum below this share of it are taken as 0.
const SMALLEST_SHARE: f64 = 1e-280;

/// Two powers of two whose product is `a/b`, for powers of two a and b: the quotient itself may be out of range.
pub(crate) fn split_quotient(a: f64, b: f64) -> [f64; 2] {
    let exponent = |x: f64| (x.to_bits() >> 52).cast_signed() - 1023;
    let power = |e: i64| f64::from_bits((e.clamp(-1022, 1023) + 1023).cast_unsigned() << 52);
    let whole = exponent(a) - exponent(b);
    let half = whole.div_euclid(2);
    [power(half), power(whole - half)]
}

/// The power of two at or below a positive number.
pub(crate) fn power_of_two(x: f64) -> f64 {
    f64::from_bits(x.max(f64::MIN_POSITIVE).to_bits() & 0x7ff0_0000_0000_0000)
}

/// Exactly `√(a²f + b²g)` for `f, g ≥ 0`, at any size of a and b.
fn weighted_length(a: DoubleDouble, f: DoubleDouble, b: DoubleDouble, g: DoubleDouble) -> DoubleDouble {
    let unit = power_of_two(a.high.abs().max(b.high.abs()));
    let (a, b) = (a.scaled(unit.recip()), b.scaled(unit.recip()));
    (a * a * f + b * b * g).sqrt().scaled(unit)
}

impl Orbit {
    /// The orbit of a momentum (kg m²/s, principal components, as a sum of two f64) under principal moments (ascending).
    pub(crate) fn new(moments: DVec3, momentum: DVec3, momentum_tail: DVec3) -> Self {
        let moment_unit = power_of_two(moments.z);
        let momentum_unit = power_of_two(momentum.abs().max_element());
        let moments = (moments / moment_unit).max(DVec3::splat(SMALLEST_RATIO));
        // A share this small moves nothing else, and its products would leave the range of f64.
        let momentum = (momentum / momentum_unit).map(|m| if m.abs() < SMALLEST_SHARE { 0.0 } else { m });
        let tail = momentum_tail / momentum_unit;
        let pair = |i: usize| DoubleDouble::sum(momentum[i], tail[i]);

        // Δ₂ = M₃²(I₃−I₂)/I₃ − M₁²(I₂−I₁)/I₁, times I₁I₃.
        let unit = power_of_two(momentum.x.abs().max(momentum.z.abs()));
        let (m1, m3) = (pair(0).scaled(unit.recip()), pair(2).scaled(unit.recip()));
        let difference = m3 * m3 * DoubleDouble::sum(moments.z, -moments.y) * moments.x
            - m1 * m1 * DoubleDouble::sum(moments.y, -moments.x) * moments.z;
        let about_largest = difference.high >= 0.0;

        // Signed permutations into standard position; each column is a principal axis.
        let mut axes = if about_largest { [DVec3::X, DVec3::Y, DVec3::Z] } else { [DVec3::Z, DVec3::NEG_Y, DVec3::X] };
        if axes[2].dot(momentum) < 0.0 {
            axes = [axes[0], -axes[1], -axes[2]];
        }
        if axes[0].dot(momentum) < 0.0 {
            axes = [-axes[0], -axes[1], axes[2]];
        }
        let principal_from_standard = DMat3::from_cols(axes[0], axes[1], axes[2]);
        let orbit_from_principal = principal_from_standard.transpose();
        let moments = if about_largest { moments } else { DVec3::new(moments.z, moments.y, moments.x) };
        let momentum = orbit_from_principal * momentum;
        let tail = orbit_from_principal * tail;
        let [m1, m2, m3] = [0, 1, 2].map(|i| DoubleDouble::sum(momentum[i], tail[i]));

        let one = DoubleDouble::from(1.0);
        let ell = weighted_length(weighted_length(m1, one, m2, one), one, m3, one);
        let [i1, i2, i3] = moments.to_array().map(DoubleDouble::from);
        let size = |a: f64, b: f64| DoubleDouble::sum(a.max(b), -a.min(b));
        let i21 = size(moments.y, moments.x);
        let i31 = size(moments.z, moments.x);
        let i32 = size(moments.z, moments.y);

        // (M × Ω) has the components M_i M_j (1/I_j − 1/I_i); the products themselves may underflow.
        let is_pair_steady = |i: usize, j: usize| momentum[i] == 0.0 || momentum[j] == 0.0 || moments[i] == moments[j];
        let mut kind = if is_pair_steady(0, 1) && is_pair_steady(1, 2) && is_pair_steady(0, 2) {
            Kind::Steady
        } else if difference.high == 0.0 {
            Kind::Separatrix
        } else {
            Kind::Circling
        };

        let mut orbit = Self {
            kind,
            principal_from_standard,
            moments,
            momentum,
            ell,
            amplitudes: momentum,
            handedness: if about_largest { 1.0 } else { -1.0 },
            rate: DoubleDouble::ZERO,
            complementary_rate: DoubleDouble::ZERO,
            modulus: 0.0,
            complementary_modulus: 1.0,
            moment_unit,
            momentum_unit,
        };
        if kind == Kind::Steady {
            return orbit;
        }

        // λ² = Δ₁(I₃−I₂)/(I₁I₂I₃), (λk′)² = Δ₂(I₃−I₁)/(I₁I₂I₃), (λk)² = −Δ₃(I₂−I₁)/(I₁I₂I₃).
        let common = i32 / (i1 * i3);
        let rate = weighted_length(m2, i21 / i2 * common / i2, m3, i31 / i3 * common / i2);
        let complementary_rate =
            (if about_largest { difference } else { -difference } * i31 / (i1 * i2) / (i1 * i3) / i3)
                .sqrt()
                .scaled(unit);
        let root = |x: DoubleDouble| x.value().max(0.0).sqrt();
        let over = root(i21) / moments.y.sqrt() / root(i1 * i3);
        let modulus_rate = (momentum.x * root(i31 / i1) * over).hypot(momentum.y * root(i32 / i2) * over);
        let is_usable = rate.high > 0.0 && rate.high.is_finite();
        if !is_usable {
            orbit.kind = Kind::Steady;
            return orbit;
        }
        orbit.rate = rate;
        orbit.complementary_rate = complementary_rate;
        orbit.modulus = (modulus_rate / rate.high).min(1.0);
        orbit.complementary_modulus = (complementary_rate.high / rate.high).min(1.0);
        if orbit.complementary_modulus == 0.0 {
            kind = Kind::Separatrix;
            orbit.kind = kind;
        }

        // B₂/B₁ = √(I₂(I₃−I₁)/(I₁(I₃−I₂))).
        let ratio = root(i2 / i1 * (i31 / i32));
        orbit.amplitudes = DVec3::new(
            momentum.x.hypot(momentum.y / ratio),
            momentum.y.hypot(momentum.x * ratio),
            momentum.z.hypot(momentum.y * root(i3 / i2 * (i21 / i31))),
        );
        orbit
    }

    /// Two factors that take seconds to the orbit's units of time.
    pub(crate) fn units_from_seconds(&self) -> [f64; 2] {
        split_quotient(self.momentum_unit, self.moment_unit)
    }

    /// A time in the orbit's units in seconds.
    pub(crate) fn seconds(&self, time: f64) -> f64 {
        let [first, second] = split_quotient(self.moment_unit, self.momentum_unit);
        time * first * second
    }

    /// `u₀`, in `[−K, K]`, where `M₁ ≥ 0`.
    pub(crate) fn start_phase(&self) -> f64 {
        let [x, y, z] = (self.momentum / self.amplitudes).to_array();
        match self.kind {
            Kind::Steady => 0.0,
            Kind::Separatrix => (y * self.handedness / z).asinh(),
            Kind::Circling => elliptic::incomplete_by_modulus(y * self.handedness, x, self.complementary_modulus),
        }
    }

    /// `K(k)`, infinite on the separatrix.
    pub(crate) fn quarter_period(&self) -> f64 {
        FRAC_PI_2 / elliptic::arithmetic_geometric_mean(1.0, self.complementary_modulus)
    }

    /// `ν`, the rate of `πu/2K`, to f64.
    pub(crate) fn phase_rate(&self) -> f64 {
        elliptic::arithmetic_geometric_mean(self.rate.value(), self.complementary_rate.value())
    }

    /// The orbit of a body momentum of a body.
    pub(crate) fn of(body: &Body, body_momentum: DVec3) -> Self {
        let principal = body.body_from_principal().transpose() * body_momentum;
        Self::new(body.principal_moments(), principal, DVec3::ZERO)
    }
}
