//! Every allowed error, in one table: what tests hold the physics to, and what its documentation promises.
//!
//! A bound covers every body that can be written down (edges, moments, a tensor, solids) and every start, taken as the exact numbers given, unless
//! its domain says less.

/// How an allowed error is counted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Limit {
    /// This much.
    Fixed(f64),
    /// So many times `ε = 2⁻⁵²`.
    Epsilons(f64),
    /// So many times `ε(1 + x)`, x the angle `|Ω|t` that the body turns by (rad), |Ω| as large as it gets on the orbit, or the argument of a function.
    Growing(f64),
}

/// A row of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// The function or method.
    pub of: &'static str,
    /// What the error is of, and how it is measured.
    pub quantity: &'static str,
    /// Where the bound holds.
    pub domain: &'static str,
    /// The bound.
    pub limit: Limit,
    /// Why it is what it is.
    pub why: &'static str,
}

impl Bound {
    /// The allowed error; what it grows with is looked at only where it grows.
    #[must_use]
    pub fn allowed(&self, grows_with: f64) -> f64 {
        match self.limit {
            Limit::Fixed(error) => error,
            Limit::Epsilons(count) => count * f64::EPSILON,
            Limit::Growing(count) => count * f64::EPSILON * (1.0 + grows_with.abs()),
        }
    }
}

/// How large `(I₃ − I₁)(I₃ − I₂)/(I₁I₂)` may be: up to 1 for a solid. The body momentum runs faster than the body turns by the root of
/// it, and the attitude has so many digits less of the 30 that the rates have.
pub const FARTHEST_FROM_SOLID: f64 = 1e11;

/// How far apart the moments may be: `2¹⁸⁰`.
pub const LARGEST_RATIO: f64 = 1_532_495_540_865_888_858_358_347_027_150_309_183_618_739_122_183_602_176.0;

/// [`Motion`](super::Motion): the attitude.
pub const CLOSED_FORM_ATTITUDE: Bound = Bound {
    of: "Motion::attitude, closed-form",
    quantity: "angle to the exact attitude (rad)",
    domain: "|t| ≤ 10¹² s at some rad/s: up to 10¹³ rad; moments of a solid, or (I₃ − I₁)(I₃ − I₂) ≤ 10¹¹ I₁I₂; none 2¹⁸⁰ times another",
    limit: Limit::Fixed(1e-13),
    why: "both rates to 100 bits, phases reduced before use: some ten roundings of numbers up to 1, at any time",
};

/// [`Motion`](super::Motion): the body momentum.
pub const CLOSED_FORM_MOMENTUM: Bound = Bound {
    of: "Motion::momentum, closed-form",
    quantity: "distance to the exact body momentum over ℓ",
    domain: CLOSED_FORM_ATTITUDE.domain,
    limit: Limit::Fixed(1e-13),
    why: CLOSED_FORM_ATTITUDE.why,
};

/// The exact step: the attitude.
pub const EXACT_STEP_ATTITUDE: Bound = Bound {
    of: "exact-step",
    quantity: "angle to the exact attitude (rad)",
    domain: "steps of any length and number; moments of a solid, or (I₃ − I₁)(I₃ − I₂) ≤ 10¹¹ I₁I₂; none 2¹⁸⁰ times another",
    limit: Limit::Growing(8.0),
    why: "the changes that a step adds are good to a few ε of themselves, and to the same side",
};

/// The exact step: the body momentum.
pub const EXACT_STEP_MOMENTUM: Bound = Bound {
    of: "exact-step",
    quantity: "distance to the exact body momentum over ℓ",
    domain: EXACT_STEP_ATTITUDE.domain,
    limit: Limit::Growing(8.0),
    why: EXACT_STEP_ATTITUDE.why,
};

/// Closed form and exact step: the world momentum as attitude and body momentum have it.
pub const WORLD_MOMENTUM: Bound = Bound {
    of: "momentum_error of closed-form, exact-step",
    quantity: "|R M − L₀|/ℓ",
    domain: "any time and number of steps",
    limit: Limit::Epsilons(32.0),
    why: "R and M come from the same functions, each good to a few ε; the exact step's attitude is set upright when it is read",
};

/// Closed form: the energy.
pub const CLOSED_FORM_ENERGY: Bound = Bound {
    of: "energy_error of closed-form",
    quantity: "|K/K₀ − 1|",
    domain: "any time",
    limit: Limit::Epsilons(32.0),
    why: "the momentum lies on its polhode to a few ε, and K is conditioned by 2; moments rounded to f64 add 2ε",
};

/// Exact step: the energy.
pub const EXACT_STEP_ENERGY: Bound = Bound {
    of: "energy_error of exact-step",
    quantity: "|K/K₀ − 1|",
    domain: "any number of steps",
    limit: Limit::Fixed(1e-13),
    why: "the momentum is drawn back to its polhode every step",
};

/// Attitudes of all methods that keep rotations.
pub const ROTATION: Bound = Bound {
    of: "so3::orthogonality_error of methods that keep rotations",
    quantity: "|RᵀR − 1|, the root of the sum of squares",
    domain: "any time and number of steps",
    limit: Limit::Epsilons(32.0),
    why: "a unit quaternion's matrix between two rotations that are rounded themselves",
};

/// [`flip_period_of`](super::poinsot::flip_period_of).
pub const FLIP_PERIOD: Bound = Bound {
    of: "poinsot::flip_period_of",
    quantity: "relative error",
    domain: "every start",
    limit: Limit::Epsilons(2.0),
    why: "found to 100 bits and rounded",
};

/// [`next_flip_of`](super::poinsot::next_flip_of).
pub const NEXT_FLIP: Bound = Bound {
    of: "poinsot::next_flip_of",
    quantity: "relative error",
    domain: "every start",
    limit: Limit::Epsilons(16.0),
    why: "the phase of the start is a quotient of components and an incomplete integral",
};

/// [`class_of`](super::poinsot::class_of).
pub const CLASS: Bound = Bound {
    of: "poinsot::class_of, and the side of the separatrix that Motion and exact-step take",
    quantity: "wrong answers",
    domain: "given by edges, moments or a tensor: exact; by solids: to 159 bits",
    limit: Limit::Fixed(0.0),
    why: "Δ₂ is found without rounding where its two terms agree to ten bits or more",
};

/// [`Body`](super::Body): principal moments.
pub const PRINCIPAL_MOMENTS: Bound = Bound {
    of: "Body::principal_moments",
    quantity: "relative error of each, however small beside the others",
    domain: "edges, moments, tensor, solids",
    limit: Limit::Epsilons(2.0),
    why: "those of tensors and solids are rounded once from 106 bits or more; edges take two squares and a sum",
};

/// [`Body`](super::Body): principal axes.
pub const PRINCIPAL_AXES: Bound = Bound {
    of: "Body::body_from_principal",
    quantity: "absolute error of each entry",
    domain: "a tensor whose moments differ",
    limit: Limit::Epsilons(1.0),
    why: "rounded once from 106 bits",
};

/// Gauss' mean.
pub const ARITHMETIC_GEOMETRIC_MEAN: Bound = Bound {
    of: "elliptic::arithmetic_geometric_mean",
    quantity: "relative error",
    domain: "a, b ≥ 0",
    limit: Limit::Epsilons(2.0),
    why: "means of positive numbers; convergence is quadratic",
};

/// `K`.
pub const COMPLETE_FIRST_KIND: Bound = Bound {
    of: "elliptic::complete_first_kind",
    quantity: "relative error",
    domain: "0 ≤ k′² < ∞",
    limit: Limit::Epsilons(4.0),
    why: "a root, the mean and a quotient",
};

/// `E`; grows with K.
pub const COMPLETE_SECOND_KIND: Bound = Bound {
    of: "elliptic::complete_second_kind",
    quantity: "relative error; x is K",
    domain: "0 ≤ k′² ≤ 1",
    limit: Limit::Growing(4.0),
    why: "1 − Σ falls to 1/K",
};

/// `F`.
pub const INCOMPLETE_FIRST_KIND: Bound = Bound {
    of: "elliptic::incomplete_first_kind",
    quantity: "relative error",
    domain: "−π/2 ≤ φ ≤ π/2 by sine and cosine, 0 ≤ k′² < ∞",
    limit: Limit::Epsilons(8.0),
    why: "up to five doublings of an angle; below k′ = 1e-9 one inverse of sinh",
};

/// `sn, cn, dn`; grows with u.
pub const JACOBI: Bound = Bound {
    of: "elliptic::Jacobi::at",
    quantity: "absolute error; x is u",
    domain: "any finite u, 0 ≤ k′² ≤ 1",
    limit: Limit::Growing(4.0),
    why: "the rounding of u and of K, and theta series of four terms",
};

/// Sine and cosine of degrees.
pub const DEGREES: Bound = Bound {
    of: "so3::sine_and_cosine_of_degrees",
    quantity: "absolute error; exact at multiples of 90°, and at 30° and 60° where they are ½",
    domain: "any finite angle",
    limit: Limit::Epsilons(1.0),
    why: "quarter turns are taken off without rounding, the rest is summed to 100 bits",
};

/// All of them.
pub static BOUNDS: &[Bound] = &[
    CLOSED_FORM_ATTITUDE,
    CLOSED_FORM_MOMENTUM,
    CLOSED_FORM_ENERGY,
    EXACT_STEP_ATTITUDE,
    EXACT_STEP_MOMENTUM,
    EXACT_STEP_ENERGY,
    WORLD_MOMENTUM,
    ROTATION,
    CLASS,
    FLIP_PERIOD,
    NEXT_FLIP,
    PRINCIPAL_MOMENTS,
    PRINCIPAL_AXES,
    ARITHMETIC_GEOMETRIC_MEAN,
    COMPLETE_FIRST_KIND,
    COMPLETE_SECOND_KIND,
    INCOMPLETE_FIRST_KIND,
    JACOBI,
    DEGREES,
];
