//! The two rates of the exact motion, to the 100 bits that a long time asks for.

use crate::physics::double_double::{DoubleDouble, Wide};
use crate::physics::orbit::Orbit;

/// A `λk′` further below λ than this power of two is brought near by means that need no sum.
const FAR_BELOW: i32 = -400;

/// `(ν, ψ̄)`: the rate of `x = πu/2K`, which is `M(λ, λk′)`, and the mean rate of ψ.
///
/// `ψ̇ = (2E + ℓM₃/I₃)/(ℓ + M₃)` is `φ̇` less what `M₃ = B₃ dn u` makes, one turn of the amplitude a period; `φ̇ = ℓ (M₁²/I₁ + M₂²/I₂)/(M₁² + M₂²)`
/// is the rate of precession. So `ψ̄ = ℓ⟨(cn²/I₁ + p sn²/I₂)/(cn² + p sn²)⟩ − s₂ν`, `p = (B₂/B₁)²`.
///
/// The mean, a complete integral of the third kind over K, comes out of the same arithmetic–geometric mean. Nothing is subtracted in it, so that it keeps
/// its digits for needles, whose p may be 10²⁶. Source: Bulirsch, Numer. Math. 7 (1965) 78 and 13 (1969) 305, `cel`, in halves.
pub(crate) fn rates(orbit: &Orbit) -> (DoubleDouble, DoubleDouble) {
    let [i1, i2, _] = orbit.exact_moments;
    let [_, i31, i32] = orbit.differences;
    let one = DoubleDouble::from(1.0);
    // In units of λ, that is of a power of two near it.
    let rate = Wide::new(orbit.rate, 0);
    let pole = (i2 * i31 / (i1 * i32)).sqrt() * rate.value;
    let mut means = Means { a: rate.value, pole, alpha: one / i1, beta: pole / i2 };
    let mut g = Wide { exponent: orbit.complementary_rate.exponent - rate.exponent, ..orbit.complementary_rate };
    while g.exponent < FAR_BELOW {
        let product = Wide::new(means.a, 0) * g;
        means.advance(DoubleDouble::ZERO, product.in_unit(0));
        g = product.sqrt();
    }
    let mut g = g.in_unit(0);
    // Quadratic convergence: 1e-17 now is 1e-34 after one more mean.
    for _ in 0..64 {
        let distance = (means.a.high - g.high).abs();
        let product = means.a * g;
        let is_last = distance < 1e-17 * means.a.high;
        means.advance(g, product);
        if is_last {
            break;
        }
        g = product.sqrt();
    }
    let Means { a, pole, alpha, beta } = means;
    let precession = orbit.ell * ((alpha * a + beta) / (a + pole));
    let phase_rate = Wide { value: a, ..rate }.in_unit(0);
    (phase_rate, if orbit.handedness > 0.0 { precession - phase_rate } else { precession + phase_rate })
}

/// `⟨(α cn² + …)⟩ = (αa + β)/(a + pole)` at the end.
struct Means {
    a: DoubleDouble,
    pole: DoubleDouble,
    alpha: DoubleDouble,
    beta: DoubleDouble,
}

impl Means {
    /// From one pair a, g of the arithmetic–geometric mean to the next.
    fn advance(&mut self, g: DoubleDouble, product: DoubleDouble) {
        let other = product / self.pole;
        let alpha = self.alpha;
        self.alpha = (alpha + self.beta / self.pole).scaled(0.5);
        self.beta = (self.beta + alpha * other).scaled(0.5);
        self.pole = (self.pole + other).scaled(0.5);
        self.a = (self.a + g).scaled(0.5);
    }
}
