//! The two rates of the exact motion, to the 100 bits that a long time asks for.

use crate::physics::double_double::DoubleDouble;
use crate::physics::orbit::Orbit;

/// `(ν, ψ̄)`: the rate of `x = πu/2K`, which is `M(λ, λk′)`, and the mean rate of ψ.
///
/// `ψ̇ = (2E + ℓM₃/I₃)/(ℓ + M₃)` has the mean
/// `ψ̄ = ℓ/I₃ + ℓ(1/I₁ − 1/I₃) Π/K − s₂ν`, with `Π/K = ⟨1/(cn² + p sn²)⟩`, `p = (B₂/B₁)²`: expand the fraction by `ℓ − M₃`; the part
/// with `M₃ = B₃ dn u` integrates to one turn of the amplitude a period. `Π/K` comes out of the same
/// arithmetic–geometric mean (DLMF 19.8.6): `½(2 + (1−p)/p ΣQₙ)`.
pub(super) fn rates(orbit: &Orbit) -> (DoubleDouble, DoubleDouble) {
    let [i1, i2, i3] = orbit.moments.to_array().map(DoubleDouble::from);
    let difference = |a: f64, b: f64| DoubleDouble::sum(a, -b);
    let i31 = difference(orbit.moments.z, orbit.moments.x);
    let i32 = difference(orbit.moments.z, orbit.moments.y);
    let p = i2 * i31 / (i1 * i32);

    let (mut a, mut g) = (orbit.rate, orbit.complementary_rate);
    let mut pole = p.sqrt() * a;
    let mut term = DoubleDouble::from(1.0);
    let mut sum = term;
    // Quadratic convergence: 1e-17 now is 1e-34 after one more mean. A large p first falls by halves.
    for _ in 0..1100 {
        let product = a * g;
        let square = pole * pole;
        let both = square + product;
        let asymmetry = (square - product) / both;
        let distance = (a.high - g.high).abs();
        term = (term * asymmetry).scaled(0.5);
        sum = sum + term;
        pole = (both / pole).scaled(0.5);
        (a, g) = ((a + g).scaled(0.5), product.sqrt());
        if asymmetry.high.abs() < 1e-17 && distance < 1e-17 * a.high {
            break;
        }
    }
    let one = DoubleDouble::from(1.0);
    let mean = one + ((one - p) / p * sum).scaled(0.5);
    let precession = orbit.ell / i3 + orbit.ell * i31 / (i1 * i3) * mean;
    (a, if orbit.handedness > 0.0 { precession - a } else { precession + a })
}
