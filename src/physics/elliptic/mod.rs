//! Elliptic integrals and Jacobi's elliptic functions from the COMPLEMENTARY parameter `k′² = 1 − k²`.
//!
//! A body that turns near the separatrix has `k′²` of 1e-16 or 1e-30. From `k²`, which is then 1 to the last digit,
//! nothing can be had; from `k′²` everything keeps its digits.

mod jacobi;

use std::f64::consts::{FRAC_PI_2, PI};

pub use jacobi::Jacobi;
pub(crate) use jacobi::{Complementary, Real, Series, hyperbolic, reduce};

/// The arithmetic–geometric mean `M(a, b)` of two numbers that are not negative:
/// `a ← (a+b)/2, b ← √(ab)` until they meet.
///
/// 0 where either is 0. Convergence is quadratic; error 2ε relative. Source: Gauss; DLMF 19.8(i).
#[must_use]
pub fn arithmetic_geometric_mean(a: f64, b: f64) -> f64 {
    let (mut a, mut b) = (a, b);
    if a == 0.0 || b == 0.0 {
        return 0.0;
    }
    // The distance squares itself: 1e-8 now is 1e-17 after the next mean.
    while (a - b).abs() > 1e-8 * a {
        (a, b) = (0.5 * (a + b), a.sqrt() * b.sqrt());
    }
    0.5 * (a + b)
}

/// Legendre's complete integral of the first kind, `K = ∫₀^{π/2} dφ/√(cos²φ + k′² sin²φ) = π/(2 M(1, k′))`.
///
/// Domain `0 ≤ k′² < ∞`; infinite at `k′² = 0`; π/2 at 1. Error 4ε relative. Source: DLMF 19.8.5.
#[must_use]
pub fn complete_first_kind(complementary_parameter: f64) -> f64 {
    FRAC_PI_2 / arithmetic_geometric_mean(1.0, complementary_parameter.sqrt())
}

/// Legendre's complete integral of the second kind, `E = ∫₀^{π/2} √(cos²φ + k′² sin²φ) dφ`.
///
/// Domain `0 ≤ k′² ≤ 1`: 1 at 0, π/2 at 1. `E = K (1 − Σ 2^{n−1} cₙ²)` with `cₙ₊₁ = (aₙ − gₙ)/2` of the
/// arithmetic–geometric mean; written `E/K = k′² + Σ…` would lose nothing, but here `1 − Σ` cancels to `1/K` at worst, so that
/// the error is `4ε(1 + K)` relative. Source: DLMF 19.8.6.
#[must_use]
pub fn complete_second_kind(complementary_parameter: f64) -> f64 {
    if complementary_parameter == 0.0 {
        return 1.0;
    }
    let (mut a, mut g) = (1.0, complementary_parameter.sqrt());
    let mut weight = 0.5;
    let mut sum = weight * (1.0 - complementary_parameter);
    while (a - g).abs() > 1e-9 * a {
        let c = 0.5 * (a - g);
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
        weight *= 2.0;
        sum += weight * c * c;
    }
    FRAC_PI_2 / (0.5 * (a + g)) * (1.0 - sum)
}

/// Legendre's incomplete integral of the first kind, `F(φ, k) = ∫₀^φ dφ/√(cos²φ + k′² sin²φ)`, for an angle
/// `−π/2 ≤ φ ≤ π/2` that is given by its sine and cosine (or any positive multiple of the pair).
///
/// Given so, angles near a right angle keep their digits, and those are what an orbit near the separatrix consists of.
/// Inverse of the amplitude: `am F(φ) = φ`. `asinh tan φ` at `k′ = 0` (infinite at ±π/2); φ at `k′ = 1`.
/// Error 8ε relative. Source: descending Landen transformation, DLMF 19.8(ii), with the tangents in homogeneous form; from
/// `k′ = 1e-9` down `sinh F = 2s/(c + √(c² + k′²s²))`, of which what is left out is below `k′² ln k′`.
#[must_use]
pub fn incomplete_first_kind(sine: f64, cosine: f64, complementary_parameter: f64) -> f64 {
    incomplete_by_modulus(sine, cosine, complementary_parameter.sqrt())
}

/// Below this k′ the integral is that of the separatrix, joined in the middle of the quarter period to its mirror image.
const SMALL_COMPLEMENT: f64 = 1e-9;

/// [`incomplete_first_kind`] by the complementary modulus `k′`, which may be too small to be squared.
pub(crate) fn incomplete_by_modulus(sine: f64, cosine: f64, complementary_modulus: f64) -> f64 {
    if complementary_modulus < SMALL_COMPLEMENT {
        let sum = cosine + cosine.hypot(complementary_modulus * sine);
        let ratio = 2.0 * sine / sum;
        // Beyond the range of sinh's inverse that is the logarithm of twice the number, which itself may be out of range.
        let is_far = sine.abs() > 1e150 * sum;
        return if is_far { (sine.abs().ln() - sum.ln() + 4f64.ln()).copysign(sine) } else { ratio.asinh() };
    }
    let (mut s, mut c) = (sine, cosine);
    let (mut a, mut g) = (1.0, complementary_modulus);
    let mut angle = s.atan2(c);
    let mut doubling = 1.0;
    while (a - g).abs() > 1e-8 * a {
        let ratio = g / a;
        // The next angle is φ + atan((g/a) tan φ), the branch being the one nearest to φ.
        let part = (ratio * s).atan2(c);
        let part = part + PI * ((angle - part) / PI).round();
        (s, c) = (s * c * (1.0 + ratio), c * c - ratio * s * s);
        let size = s.abs().max(c.abs());
        (s, c) = (s / size, c / size);
        angle += part;
        doubling *= 2.0;
        (a, g) = (0.5 * (a + g), a.sqrt() * g.sqrt());
    }
    // The last doubling to first order in 1 − g/a; its square is lost in rounding.
    let last = 2.0 * angle - (1.0 - g / a) * s * c / (s * s + c * c);
    last / (doubling * (a + g))
}

/// Jacobi's nome `exp(−πK′/K)` from modulus `k ≤ 1/√2` and complementary modulus, by its power series in
/// `l = ½ (1 − √k′)/(1 + √k′)`: `q = l + 2l⁵ + 15l⁹ + 150l¹³ + …`, where `l ≤ 0.0433` and the first term left
/// out is below 1e-19 of the sum. Returned as a square root, which does not underflow where the nome does.
pub(crate) fn root_of_nome(modulus: f64, complementary_modulus: f64) -> f64 {
    let root = complementary_modulus.sqrt();
    let root_of_l = modulus * (0.5 / (1.0 + complementary_modulus)).sqrt() / (1.0 + root);
    let l4 = root_of_l.powi(8);
    root_of_l * (1.0 + l4 * (2.0 + l4 * (15.0 + l4 * 150.0))).sqrt()
}
