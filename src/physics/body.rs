//! The rigid body: its moment of inertia about the centre of mass and its principal axes.

use glam::{DMat3, DVec3};

use super::number;

/// A body's inertia (kg m²) about its centre of mass, with the principal moments `I₁ ≤ I₂ ≤ I₃` and axes.
///
/// Always valid: every entry finite, the tensor symmetric and positive definite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    inertia: DMat3,
    principal_moments: DVec3,
    axes: DMat3,
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
        Self::from_moments(DVec3::new(squared.y + squared.z, squared.z + squared.x, squared.x + squared.y))
    }

    /// A body whose own axes are principal axes, moments (kg m²) in the order of the axes, sorted or not.
    ///
    /// # Errors
    /// A moment that is not finite and positive.
    pub fn from_moments(moments: DVec3) -> Result<Self, BodyError> {
        for moment in moments.to_array() {
            if !(moment.is_finite() && moment > 0.0) {
                return Err(BodyError::Moment(moment));
            }
        }
        let axes = [DVec3::X, DVec3::Y, DVec3::Z];
        Ok(Self::from_principal(DMat3::from_diagonal(moments), moments.to_array(), axes))
    }

    /// A body with a full inertia tensor (kg m²) in the body frame; its principal axes are found by Jacobi rotations.
    ///
    /// # Errors
    /// An entry that is not finite, mirrored entries that differ by more than rounding (8ε of the largest entry),
    /// a tensor that is not positive definite (smallest eigenvalue not above the eigenvalues' own rounding error,
    /// 8ε of the largest entry).
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
        let inertia = 0.5 * inertia + 0.5 * mirrored;
        let off_diagonal = [inertia.y_axis.x, inertia.z_axis.x, inertia.z_axis.y];
        let diagonal = DVec3::new(inertia.x_axis.x, inertia.y_axis.y, inertia.z_axis.z);
        if off_diagonal == [0.0; 3] {
            if diagonal.min_element() <= 0.0 {
                return Err(BodyError::NotPositiveDefinite(diagonal.min_element()));
            }
            return Self::from_moments(diagonal);
        }
        // Scaled by the largest entry, so that no square overflows.
        let (moments, axes) = symmetric_eigen(inertia * (1.0 / largest));
        let smallest = moments.iter().copied().fold(f64::MAX, f64::min);
        if smallest <= 8.0 * f64::EPSILON {
            return Err(BodyError::NotPositiveDefinite(smallest * largest));
        }
        Ok(Self::from_principal(inertia, moments.map(|moment| moment * largest), axes))
    }

    /// Sorts the principal moments, keeping the axes right-handed.
    fn from_principal(inertia: DMat3, moments: [f64; 3], axes: [DVec3; 3]) -> Self {
        let mut order = [0, 1, 2];
        order.sort_by(|&a, &b| moments[a].total_cmp(&moments[b]));
        let [first, second, third] = order.map(|i| axes[i]);
        let third = if first.cross(second).dot(third) < 0.0 { -third } else { third };
        Self {
            inertia,
            principal_moments: DVec3::from_array(order.map(|i| moments[i])),
            axes: DMat3::from_cols(first, second, third),
        }
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

    /// `IΩ − M` for the rounded momentum `M` of a body angular velocity, where the body's own axes are principal;
    /// elsewhere the principal axes themselves are rounded, and nothing is gained.
    pub(crate) fn momentum_tail(&self, body_angular_velocity: DVec3, body_momentum: DVec3) -> DVec3 {
        let off_diagonal = [self.inertia.y_axis.x, self.inertia.z_axis.x, self.inertia.z_axis.y];
        if off_diagonal != [0.0; 3] {
            return DVec3::ZERO;
        }
        let diagonal = DVec3::new(self.inertia.x_axis.x, self.inertia.y_axis.y, self.inertia.z_axis.z);
        // One rounding at the end of the fused product: exact but where it underflows.
        let tail = |i: usize| diagonal[i].mul_add(body_angular_velocity[i], -body_momentum[i]);
        DVec3::new(tail(0), tail(1), tail(2))
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

/// Eigenvalues and orthonormal eigenvectors of a symmetric matrix, by cyclic Jacobi rotations: each turns one
/// off-diagonal entry to zero; convergence is quadratic, five sweeps reach rounding (Golub & Van Loan, §8.5).
fn symmetric_eigen(matrix: DMat3) -> ([f64; 3], [DVec3; 3]) {
    let mut a: [[f64; 3]; 3] = matrix.to_cols_array_2d();
    let mut v = [DVec3::X, DVec3::Y, DVec3::Z];
    for _sweep in 0..12 {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if a[p][q] == 0.0 {
                continue;
            }
            let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
            let t = theta.signum() / (theta.abs() + theta.hypot(1.0));
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
