//! The rigid body: its moment of inertia about the centre of mass and its principal axes.

use glam::{DMat3, DVec3};

use super::double_double::power_of_two_of;
use super::dyadic::Dyadic;
use super::number;
use super::principal::{self, Principal, Tensor};

/// A body's inertia (kg m²) about its centre of mass, with the principal moments `I₁ ≤ I₂ ≤ I₃` and axes.
///
/// Always valid: every entry finite, the tensor symmetric and positive definite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    inertia: DMat3,
    principal_moments: DVec3,
    axes: DMat3,
    /// Moments and axes with all the digits that a long time asks for.
    principal: Principal,
}

/// Why no body has the inertia that was asked for.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BodyError {
    /// An edge length is not finite and positive.
    #[error("edge {} m is not a length: every edge must be finite and above 0", number(*.0))]
    Edge(f64),
    /// The mass is not finite and positive.
    #[error("mass {} kg is not a mass: it must be finite and above 0", number(*.0))]
    Mass(f64),
    /// A principal moment is not finite and positive.
    #[error("moment {} kg m² is not a moment of inertia: every moment must be finite and above 0", number(*.0))]
    Moment(f64),
    /// An entry of the tensor is not finite.
    #[error("the inertia entry {} is not finite", number(*.0))]
    NotFinite(f64),
    /// Two mirrored entries of the tensor differ.
    #[error("the inertia is not symmetric: {} on one side of the diagonal, {} on the other", number(*.0), number(*.1))]
    NotSymmetric(f64, f64),
    /// A principal moment of the tensor is zero or negative.
    #[error("the inertia is not positive definite: its smallest principal moment is {}; all three must be above 0", number(*.0))]
    NotPositiveDefinite(f64),
}

impl Body {
    /// A solid box of uniform density, edges `(a, b, c)` in m along the body's axes, mass in kg:
    /// `I = m/12 diag(b² + c², c² + a², a² + b²)`.
    ///
    /// # Errors
    /// An edge or a mass that is not finite and positive, or moments beyond the range of f64.
    pub fn solid_box(edges: DVec3, mass: f64) -> Result<Self, BodyError> {
        for edge in edges.to_array() {
            if !(edge.is_finite() && edge > 0.0) {
                return Err(BodyError::Edge(edge));
            }
        }
        if !(mass.is_finite() && mass > 0.0) {
            return Err(BodyError::Mass(mass));
        }
        // The mass first, lest a square leave the range that the moment itself is in.
        let squared = (mass / 12.0) * edges * edges;
        let moments = DVec3::new(squared.y + squared.z, squared.z + squared.x, squared.x + squared.y);
        check_moments(moments)?;
        Ok(Self::from_principal(DMat3::from_diagonal(moments), &Principal::from_edges(edges.to_array(), mass)))
    }

    /// A body whose own axes are principal axes, moments (kg m²) in the order of the axes, sorted or not.
    ///
    /// # Errors
    /// A moment that is not finite and positive.
    pub fn from_moments(moments: DVec3) -> Result<Self, BodyError> {
        check_moments(moments)?;
        Ok(Self::from_principal(DMat3::from_diagonal(moments), &Principal::from_moments(moments.to_array())))
    }

    /// A body with a full inertia tensor (kg m²) in the body frame; its principal axes are found by Jacobi rotations, to 106 bits.
    ///
    /// # Errors
    /// An entry that is not finite, mirrored entries that differ by more than rounding (8ε of the largest entry),
    /// a tensor that is not positive definite, which is decided without rounding.
    pub fn from_tensor(inertia: DMat3) -> Result<Self, BodyError> {
        let entries = inertia.to_cols_array();
        if let Some(&entry) = entries.iter().find(|entry| !entry.is_finite()) {
            return Err(BodyError::NotFinite(entry));
        }
        let largest = entries.iter().fold(0.0, |m: f64, e| m.max(e.abs()));
        let mirrored = inertia.transpose();
        for (a, b) in entries.iter().zip(mirrored.to_cols_array()) {
            if (a - b).abs() > 8.0 * f64::EPSILON * largest {
                return Err(BodyError::NotSymmetric(*a, b));
            }
        }
        // The mean of two equal entries is that entry, were it the smallest number there is.
        let [x, y, z] = [0, 1, 2].map(|i| inertia.col(i));
        let mean = |a: f64, b: f64| if a == b { a } else { 0.5 * a + 0.5 * b };
        let (xy, xz, yz) = (mean(x.y, y.x), mean(x.z, z.x), mean(y.z, z.y));
        let inertia = DMat3::from_cols(DVec3::new(x.x, xy, xz), DVec3::new(xy, y.y, yz), DVec3::new(xz, yz, z.z));
        if [xy, xz, yz] == [0.0; 3] {
            let diagonal = DVec3::new(x.x, y.y, z.z);
            if diagonal.min_element() <= 0.0 {
                return Err(BodyError::NotPositiveDefinite(diagonal.min_element()));
            }
            return Self::from_moments(diagonal);
        }
        Self::from_exact_tensor(inertia, &[x.x, y.y, z.z, xy, xz, yz].map(Dyadic::from))
    }

    /// A body with a tensor of which the first one is what is left after rounding.
    pub(super) fn from_exact_tensor(inertia: DMat3, exact: &Tensor) -> Result<Self, BodyError> {
        // A body too small for numbers, not one that cannot be.
        let diagonal = DVec3::new(inertia.x_axis.x, inertia.y_axis.y, inertia.z_axis.z);
        if exact[..3].iter().zip(diagonal.to_array()).any(|(exact, rounded)| exact.sign() > 0 && rounded == 0.0) {
            return Err(BodyError::Moment(0.0));
        }
        if !principal::is_positive_definite(exact) {
            // Scaled by the largest entry, so that no square overflows.
            let largest = inertia.to_cols_array().iter().fold(f64::MIN_POSITIVE, |m: f64, e| m.max(e.abs()));
            let (moments, _) = symmetric_eigen(inertia * (1.0 / largest));
            let smallest = moments.iter().copied().fold(f64::MAX, f64::min);
            return Err(BodyError::NotPositiveDefinite(smallest.min(0.0) * largest));
        }
        Ok(Self::from_principal(inertia, &Principal::from_tensor(exact)))
    }

    fn from_principal(inertia: DMat3, principal: &Principal) -> Self {
        let (principal_moments, axes) = (principal.rounded_moments, principal.rounded_axes());
        Self { inertia, principal_moments, axes, principal: *principal }
    }

    /// Moments and axes to 106 bits.
    pub(crate) fn principal(&self) -> &Principal {
        &self.principal
    }

    /// `I₂ − I₁`, `I₃ − I₁`, `I₃ − I₂` (kg m²), each with all its digits.
    pub(crate) fn moment_differences(&self) -> [f64; 3] {
        let [first, second] = power_of_two_of(self.principal.exponent);
        self.principal.differences.map(|difference| difference.value() * first * second)
    }

    /// The inertia tensor in the body frame (kg m²).
    #[must_use]
    pub fn inertia(&self) -> DMat3 {
        self.inertia
    }

    /// The principal moments `I₁ ≤ I₂ ≤ I₃` (kg m²).
    #[must_use]
    pub fn principal_moments(&self) -> DVec3 {
        self.principal_moments
    }

    /// The rotation whose columns are the principal axes 1, 2, 3 in the body frame. A signed permutation,
    /// without rounding, where the body's own axes are principal.
    #[must_use]
    pub fn body_from_principal(&self) -> DMat3 {
        self.axes
    }

    /// Body momentum `M = IΩ` (kg m²/s) of a body angular velocity (rad/s).
    #[must_use]
    pub fn momentum(&self, body_angular_velocity: DVec3) -> DVec3 {
        self.inertia * body_angular_velocity
    }

    /// Body angular velocity `Ω = I⁻¹M` (rad/s) of a body momentum, by the principal axes (no 3×3 inverse).
    #[must_use]
    pub fn angular_velocity(&self, body_momentum: DVec3) -> DVec3 {
        let principal = self.axes.transpose() * body_momentum;
        self.axes * (principal / self.principal_moments)
    }

    /// Kinetic energy `K = ½ M·I⁻¹M` (J) of a body momentum.
    #[must_use]
    pub fn energy(&self, body_momentum: DVec3) -> f64 {
        let principal = self.axes.transpose() * body_momentum;
        0.5 * principal.dot(principal / self.principal_moments)
    }

    /// By what factor `I₃` exceeds `I₁ + I₂`, if it does: no distribution of mass has such moments. Published
    /// test cases do, so it is a warning and no error. Rounding of a flat plate (`I₃ = I₁ + I₂`) is let pass.
    #[must_use]
    pub fn triangle_excess(&self) -> Option<f64> {
        let ratio = self.principal_moments.z / (self.principal_moments.x + self.principal_moments.y);
        (ratio > 1.0 + 4.0 * f64::EPSILON).then_some(ratio)
    }

    /// Whether the moments are some that the [`bounds`](super::bounds) of attitudes hold for: those of solids, but for the most extreme
    /// needles and plates, and others that are not too far from one's.
    #[must_use]
    pub fn is_within_bounds(&self) -> bool {
        let i = self.principal_moments / self.principal_moments.z;
        let from_solid = (1.0 - i.x) * (1.0 - i.y) / i.x / i.y;
        i.x >= super::bounds::LARGEST_RATIO.recip() && from_solid <= super::bounds::FARTHEST_FROM_SOLID
    }

    /// Edges (m) of the solid box of this mass (kg) with the body's principal moments, along the principal axes:
    /// `a² = 6 (I₂ + I₃ − I₁)/m` and so on round. Where no solid has the moments the edge that would be
    /// imaginary is 0.
    #[must_use]
    pub fn equivalent_box(&self, mass: f64) -> DVec3 {
        let i = self.principal_moments;
        let squared = DVec3::new(i.y + i.z - i.x, i.z + i.x - i.y, i.x + i.y - i.z) * (6.0 / mass);
        squared.max(DVec3::ZERO).map(f64::sqrt)
    }
}

fn check_moments(moments: DVec3) -> Result<(), BodyError> {
    let wrong = moments.to_array().into_iter().find(|moment| !(moment.is_finite() && *moment > 0.0));
    wrong.map_or(Ok(()), |moment| Err(BodyError::Moment(moment)))
}

/// Eigenvalues and orthonormal eigenvectors of a symmetric matrix, by cyclic Jacobi rotations: each turns one
/// off-diagonal entry to zero; convergence is quadratic, five sweeps reach rounding (Golub & Van Loan, §8.5).
pub(super) fn symmetric_eigen(matrix: DMat3) -> ([f64; 3], [DVec3; 3]) {
    let mut a: [[f64; 3]; 3] = matrix.to_cols_array_2d();
    let mut v = [DVec3::X, DVec3::Y, DVec3::Z];
    for _sweep in 0..12 {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if a[p][q] == 0.0 {
                continue;
            }
            let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let t = 1f64.copysign(theta) / (theta.abs() + theta.hypot(1.0));
            let c = 1.0 / t.hypot(1.0);
            let s = t * c;
            let apq = a[p][q];
            a[p][p] -= t * apq;
            a[q][q] += t * apq;
            a[p][q] = 0.0;
            a[q][p] = 0.0;
            let r = 3 - p - q;
            let (arp, arq) = (a[r][p], a[r][q]);
            a[r][p] = c * arp - s * arq;
            a[p][r] = a[r][p];
            a[r][q] = s * arp + c * arq;
            a[q][r] = a[r][q];
            let (vp, vq) = (v[p], v[q]);
            v[p] = c * vp - s * vq;
            v[q] = s * vp + c * vq;
        }
    }
    ([a[0][0], a[1][1], a[2][2]], v.map(DVec3::normalize))
}
