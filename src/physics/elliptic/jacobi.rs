//! Jacobi's elliptic functions by theta series: of the nome `q` where `k′² ≥ ½`, else of the complementary nome `q′`.
//! Either is then at most `e^{−π} = 0.043`, and four terms of `q^{n²}` reach 53 bits.

use std::f64::consts::{FRAC_PI_2, PI};

use super::{complete_first_kind, root_of_nome};

/// `sn`, `cn`, `dn` and the amplitude for one modulus, prepared for many arguments.
#[derive(Clone, Copy, Debug)]
pub struct Jacobi {
    series: Series,
    /// `K`, infinite at `k′ = 0`.
    quarter_period: f64,
}

/// The series that serves a modulus.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Series {
    Real(Real),
    Complementary(Complementary),
    /// `k′ = 0`: tanh, sech, sech.
    Hyperbolic,
}

/// Series in the real nome, for `k′² ≥ ½`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Real {
    /// `2q, 2q⁴, 2q⁹` and `q², q⁶`.
    even: [f64; 3],
    odd: [f64; 2],
    pub(crate) factors: [f64; 3],
}

/// Series in the complementary nome, for `k′² < ½`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Complementary {
    /// `q′`.
    pub(crate) nome: f64,
    /// `√q′` and minus its logarithm, `πK/2K′`.
    pub(crate) root_of_nome: f64,
    pub(crate) decay: f64,
    pub(crate) factors: [f64; 3],
}

impl Series {
    /// From `k` and `k′`, each given with all its digits, and `−ln k′`, which counts where k′ is too small a number to be one;
    /// infinite on the separatrix.
    pub(crate) fn new(modulus: f64, complementary_modulus: f64, logarithm: f64) -> Self {
        if logarithm == f64::INFINITY {
            Self::Hyperbolic
        } else if complementary_modulus >= modulus {
            Self::Real(Real::new(root_of_nome(modulus, complementary_modulus)))
        } else {
            Self::Complementary(Complementary::new(root_of_nome(complementary_modulus, modulus), logarithm))
        }
    }
}

impl Real {
    fn new(root_of_nome: f64) -> Self {
        let q = root_of_nome * root_of_nome;
        let q4 = q.powi(4);
        let q9 = q4 * q4 * q;
        let third = 1.0 + 2.0 * (q + q4 + q9);
        let fourth = 1.0 - 2.0 * (q - q4 + q9);
        // θ₂(0)/2q^¼.
        let second = 1.0 + q * q + q.powi(6);
        Self {
            even: [2.0 * q, 2.0 * q4, 2.0 * q9],
            odd: [q * q, q.powi(6)],
            factors: [third / second, fourth / second, fourth / third],
        }
    }

    /// `q`.
    pub(crate) fn nome(&self) -> f64 {
        0.5 * self.even[0]
    }

    /// `[sn, cn, dn]` from sine and cosine of `x = πu/2K`:
    /// `sn = θ₃ θ₁(x)/(θ₂ θ₄(x))`, `cn = θ₄ θ₂(x)/(θ₂ θ₄(x))`, `dn = θ₄ θ₃(x)/(θ₃ θ₄(x))`. DLMF 22.2.
    pub(crate) fn at(&self, sine: f64, cosine: f64) -> [f64; 3] {
        let c2 = 1.0 - 2.0 * sine * sine;
        let c4 = 2.0 * c2 * c2 - 1.0;
        let c6 = c2 * (2.0 * c4 - 1.0);
        let same = 1.0 + self.even[1] * c4;
        let other = self.even[0] * c2 + self.even[2] * c6;
        // θ₁ and θ₂ divided by 2q^¼ sin x and 2q^¼ cos x.
        let first = 1.0 - self.odd[0] * (1.0 + 2.0 * c2) + self.odd[1] * (1.0 + 2.0 * c2 + 2.0 * c4);
        let second = 1.0 - self.odd[0] * (1.0 - 2.0 * c2) + self.odd[1] * (1.0 - 2.0 * c2 + 2.0 * c4);
        let inverse = 1.0 / (same - other);
        [
            self.factors[0] * sine * first * inverse,
            self.factors[1] * cosine * second * inverse,
            self.factors[2] * (same + other) * inverse,
        ]
    }
}

impl Complementary {
    fn new(root_of_nome: f64, logarithm: f64) -> Self {
        let q = root_of_nome * root_of_nome;
        let (q4, q9) = (q.powi(4), q.powi(9));
        let third = 1.0 + 2.0 * (q + q4 + q9);
        let fourth = 1.0 - 2.0 * (q - q4 + q9);
        let second = 2.0 * (1.0 + q * q + q.powi(6));
        Self {
            nome: q,
            root_of_nome,
            // √q′ is k′/4 to 53 bits long before k′ runs out of digits.
            decay: if logarithm > 100.0 { logarithm + 4f64.ln() } else { -root_of_nome.ln() },
            factors: [third / fourth, second / fourth, second / third],
        }
    }

    /// `√q′ exp(v)` for `v = πu/2K′`, `0 ≤ u ≤ K`, from `exp(−v)` and `u/K`.
    pub(crate) fn rise(&self, e: f64, quarters: f64) -> f64 {
        if self.decay < 600.0 { self.root_of_nome / e } else { (self.decay * (quarters - 1.0)).exp() }
    }

    /// `[sn, cn, dn]` for `0 ≤ u ≤ K` from `e = exp(−v)` and `p = √q′ exp(v)`, `v = πu/2K′`. Jacobi's imaginary
    /// transformation (DLMF 22.6(iv)) of the theta functions, whose terms of growing `cosh 2nv` are written in p, at most 1.
    pub(crate) fn at(&self, e: f64, p: f64) -> [f64; 3] {
        let q = self.nome;
        let (q2, e2, p2) = (q * q, e * e, p * p);
        let (q4, e4, p4) = (q2 * q2, e2 * e2, p2 * p2);
        let same = 1.0 + q2 * (p4 + q2 * e4);
        let other = p2 + q * e2 + q4 * q2 * (p4 * p2 + q2 * q * e4 * e2);
        let up = 1.0 + q4 * p4;
        let up_odd = q * p2 + q4 * q4 * q * p4 * p2;
        let down = e2 * (1.0 + q4 * q2 * e4);
        let down_odd = q2 * e4;
        let inverse = 1.0 / (up + up_odd + down + down_odd);
        [
            self.factors[0] * (up - up_odd - down + down_odd) * inverse,
            self.factors[1] * e * (same - other) * inverse,
            self.factors[2] * e * (same + other) * inverse,
        ]
    }
}

impl Complementary {
    /// `[sn, cn, dn]` from `v = πu/2K′` of at most 2 or so: the same series by sinh and cosh, so that sn keeps all its digits at small u.
    pub(crate) fn at_small(&self, v: f64) -> [f64; 3] {
        let q = self.nome;
        let (q2, q4) = (q * q, q.powi(4));
        let same = 1.0 + 2.0 * q4 * (4.0 * v).cosh();
        let other = 2.0 * q * ((2.0 * v).cosh() + q4 * q4 * (6.0 * v).cosh());
        let odd = |f: fn(f64) -> f64, sign: f64| {
            f(v) + sign * q2 * f(3.0 * v) + q4 * q2 * f(5.0 * v) + sign * q4 * q4 * q4 * f(7.0 * v)
        };
        // The factors hold θ₂(0)/q^¼, which is 2(…); so does θ₂(iv)/q^¼ = 2 Σ cosh.
        let inverse = 1.0 / odd(f64::cosh, 1.0);
        [
            self.factors[0] * odd(f64::sinh, -1.0) * inverse,
            0.5 * self.factors[1] * (same - other) * inverse,
            0.5 * self.factors[2] * (same + other) * inverse,
        ]
    }
}

impl Jacobi {
    /// Prepares the functions of complementary parameter `k′²`, `0 ≤ k′² ≤ 1`.
    #[must_use]
    pub fn new(complementary_parameter: f64) -> Self {
        let modulus = (1.0 - complementary_parameter).max(0.0).sqrt();
        Self {
            series: Series::new(modulus, complementary_parameter.sqrt(), -0.5 * complementary_parameter.ln()),
            quarter_period: complete_first_kind(complementary_parameter),
        }
    }

    /// `K`, a quarter of the period of sn and cn, half that of dn.
    #[must_use]
    pub fn quarter_period(&self) -> f64 {
        self.quarter_period
    }

    /// `[sn u, cn u, dn u]`: `sn = sin am u`, `cn = cos am u`, `dn = √(cn² + k′² sn²)`.
    ///
    /// Circular functions at `k′² = 1`, tanh and sech at 0. Any finite u; error `4ε(1 + |u|)`, absolute, of which the part in
    /// |u| is the rounding of the argument and of K. Source: theta series, DLMF 20.2, 22.2.
    #[must_use]
    pub fn at(&self, u: f64) -> [f64; 3] {
        let quarters = u / self.quarter_period;
        match &self.series {
            Series::Real(series) => {
                let (sine, cosine) = (FRAC_PI_2 * (quarters - 4.0 * (0.25 * quarters).round())).sin_cos();
                series.at(sine, cosine)
            }
            Series::Complementary(series) => {
                let (half_periods, rest) = reduce(quarters);
                let [sn, cn, dn] =
                    series.at((-series.decay * rest.abs()).exp(), (series.decay * (rest.abs() - 1.0)).exp());
                [half_periods * sn.copysign(rest), half_periods * cn, dn]
            }
            Series::Hyperbolic => hyperbolic(u),
        }
    }

    /// Jacobi's amplitude `am u = ∫₀^u dn`, continuous and odd: the inverse of the
    /// [incomplete integral](super::incomplete_first_kind). The Gudermannian at `k′² = 0`.
    #[must_use]
    pub fn amplitude(&self, u: f64) -> f64 {
        let [sn, cn, _] = self.at(u);
        let turns = (0.25 * u / self.quarter_period).round();
        sn.atan2(cn) + 2.0 * PI * turns
    }
}

/// `[tanh u, sech u, sech u]`.
pub(crate) fn hyperbolic(u: f64) -> [f64; 3] {
    let e = (-u.abs()).exp();
    let sech = 2.0 * e / (1.0 + e * e);
    [u.tanh(), sech, sech]
}

/// Splits `u/K` in whole half periods, of which the sign `(−1)^n` is returned, and a rest within ±1.
pub(crate) fn reduce(quarters: f64) -> (f64, f64) {
    let half_periods = (0.5 * quarters).round();
    let sign = 1.0 - 2.0 * (half_periods.abs() % 2.0);
    (sign, quarters - 2.0 * half_periods)
}
