//! Jacobi's elliptic functions by the descending Landen transformation, real arithmetic and no amplitude (DLMF 22.7(i)), from
//! modulus and complementary modulus that are each given to all digits.

use super::real::{Real, exponent, real, root};

/// The modulus k and the complementary modulus k′.
#[derive(Clone, Debug)]
pub(crate) struct Modulus {
    pub(crate) k2: Real,
    pub(crate) k1: Real,
}

impl Modulus {
    /// From the complementary parameter `k′²` in (0, 1].
    pub(crate) fn from_complementary(parameter: &Real) -> Self {
        Self { k2: Real::from(1) - parameter, k1: root(parameter) }
    }

    /// `K = π/(2 M(1, k′))`.
    pub(crate) fn quarter_period(&self) -> Real {
        let bits = self.k1.precision();
        let (mut a, mut g) = (real(1.0, bits), self.k1.clone());
        while exponent(&(&a - &g)) > exponent(&a) - bits.cast_signed() / 2 - 2 {
            (a, g) = ((&a + &g) >> 1, root(&(&a * &g)));
        }
        Real::pi(bits) / (a + g)
    }

    /// `[sn, cn, dn]` of `|u| ≤ K`. cn and dn keep their digits however small they are.
    pub(crate) fn at(&self, u: &Real) -> [Real; 3] {
        let bits = self.k1.precision();
        if exponent(&self.k2) < -bits.cast_signed() {
            let (sine, cosine) = u.sin_cos();
            return [sine, cosine, real(1.0, bits)];
        }
        let sum = Real::from(1) + &self.k1;
        let lower = Self { k2: (&self.k2 / (&sum * &sum)).sqr(), k1: (root(&self.k1) << 1) / &sum };
        let [s, c, d] = lower.at(&((u * &sum) >> 1));
        // The lower modulus, from whose square it is known without cancellation.
        let k = &self.k2 / (&sum * &sum);
        let inverse = Real::from(1) / (Real::from(1) + &k * &s * &s);
        let sine = (Real::from(1) + &k) * &s * &inverse;
        let cosine = c * d * inverse;
        let delta = root(&(&self.k1 * &self.k1 + &self.k2 * &cosine * &cosine));
        [sine, cosine, delta]
    }
}
