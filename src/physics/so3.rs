//! Rotations: the group SO(3), its Lie algebra of cross products, and the maps between them.
//!
//! A rotation vector `v` (rad) turns by the angle `|v|` about the axis `v/|v|`.

use glam::{DMat3, DQuat, DVec3};

use super::double_double::{self, DoubleDouble};

/// The matrix `[v×]` of the cross product: `hat(a) * b = a × b`.
///
/// Lie algebra notation: `ad_a`. Its bracket is the cross product, `[a×][b×] − [b×][a×] = [(a×b)×]`.
#[must_use]
pub fn hat(v: DVec3) -> DMat3 {
    DMat3::from_cols(DVec3::new(0.0, v.z, -v.y), DVec3::new(-v.z, 0.0, v.x), DVec3::new(v.y, -v.x, 0.0))
}

/// The vector of the skew part of a matrix: the inverse of [`hat`] on skew matrices.
#[must_use]
pub fn vee(m: DMat3) -> DVec3 {
    0.5 * DVec3::new(m.y_axis.z - m.z_axis.y, m.z_axis.x - m.x_axis.z, m.x_axis.y - m.y_axis.x)
}

/// Euclidean length that neither overflows nor underflows: `s |v/s|` with `s` a power of two near the largest entry.
#[must_use]
pub fn norm(v: DVec3) -> f64 {
    let largest = v.abs().max_element();
    if (1e-140..1e140).contains(&largest) {
        v.length()
    } else if largest == 0.0 || !largest.is_finite() {
        largest
    } else {
        (v / largest).length() * largest
    }
}

/// The rotation `exp([v×])` of a rotation vector (rad), by Rodrigues' formula
/// `1 + sin θ/θ [v×] + (1 − cos θ)/θ² [v×]²`, `θ = |v|`.
///
/// Near `θ = 0` both factors come from their power series, so that the error stays near ε; a vector of any
/// finite length is accepted, with the error `ε(1 + θ)` that its own rounding implies.
#[must_use]
pub fn exp(v: DVec3) -> DMat3 {
    DMat3::from_quat(exp_quaternion(v))
}

/// The unit quaternion `(cos θ/2, sin(θ/2) v/θ)` of a rotation vector (rad). See [`exp`].
///
/// Up to a turn of 1 rad by the power series of cos x and sin x/x in `x² = θ²/4`, which needs no root and no quotient; the first terms
/// left out are `x¹⁴/15! < 5e-17` and `x¹⁶/16! < 1e-18`.
#[must_use]
pub fn exp_quaternion(v: DVec3) -> DQuat {
    let half = 0.5 * v;
    let x = half.length_squared();
    if x < 0.25 {
        let (x2, x4) = (x * x, (x * x) * (x * x));
        let sinc = ((1.0 - x * (1.0 / 6.0)) + x2 * (1.0 / 120.0 - x * (1.0 / 5_040.0)))
            + x4 * ((1.0 / 362_880.0 - x * (1.0 / 39_916_800.0)) + x2 * (1.0 / 6_227_020_800.0));
        let cosine = ((1.0 - x * (1.0 / 2.0)) + x2 * (1.0 / 24.0 - x * (1.0 / 720.0)))
            + x4 * ((1.0 / 40_320.0 - x * (1.0 / 3_628_800.0))
                + x2 * (1.0 / 479_001_600.0 - x * (1.0 / 87_178_291_200.0)));
        return DQuat::from_xyzw(sinc * half.x, sinc * half.y, sinc * half.z, cosine);
    }
    let angle = norm(half);
    let (sine, cosine) = angle.sin_cos();
    let axis = half / angle;
    DQuat::from_xyzw(sine * axis.x, sine * axis.y, sine * axis.z, cosine)
}

/// Sine and cosine of an angle in degrees: exact where they are 0, ±½ or ±1, else within ε.
#[must_use]
pub fn sine_and_cosine_of_degrees(degrees: f64) -> (f64, f64) {
    let (sine, cosine) = exact_sine_and_cosine(DoubleDouble::from(degrees));
    (sine.value(), cosine.value())
}

/// The same to 100 bits. Whole quarter turns go first; what is left, 45° at most, by the power series.
pub(crate) fn exact_sine_and_cosine(degrees: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let whole = degrees.high % 360.0;
    let quarters = (whole / 90.0).round();
    let angle =
        (DoubleDouble::sum(whole - 90.0 * quarters, degrees.low) * double_double::PI) / DoubleDouble::from(180.0);
    let square = -(angle * angle);
    // Σ (−x²)ⁿ/(2n+1)! and Σ (−x²)ⁿ/(2n)!, from the smallest term: (π/4)²⁸/28! < 1e-32.
    let one = DoubleDouble::from(1.0);
    let (mut sine, mut cosine) = (one, one);
    for n in (1..=14).rev() {
        let n = f64::from(n);
        sine = one + square * sine / DoubleDouble::from(2.0 * n * (2.0 * n + 1.0));
        cosine = one + square * cosine / DoubleDouble::from(2.0 * n * (2.0 * n - 1.0));
    }
    // Halfway the two are the same to the last bit: twice such a turn is a quarter turn.
    let is_halfway = (whole - 90.0 * quarters).abs() == 45.0 && degrees.low == 0.0;
    let sine = if is_halfway { cosine.scaled(angle.high.signum()) } else { angle * sine };
    match quarters.rem_euclid(4.0) as u8 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

/// `R⁻¹v` for the rotation of a unit quaternion: `v + 2(q₀ v×q + (v×q)×q)`.
pub(crate) fn rotate_back(q: DQuat, v: DVec3) -> DVec3 {
    let axis = DVec3::new(q.x, q.y, q.z);
    let twice = 2.0 * v.cross(axis);
    v + q.w * twice + twice.cross(axis)
}

/// `|q|² R v` for the rotation R of a quaternion of any length: `(q₀² − |𝐪|²)v + 2(𝐪·v)𝐪 + 2q₀ 𝐪×v`.
pub(crate) fn rotate_scaled(q: DQuat, v: DVec3) -> DVec3 {
    let axis = DVec3::new(q.x, q.y, q.z);
    (q.w * q.w - axis.length_squared()) * v + 2.0 * (axis.dot(v) * axis + q.w * axis.cross(v))
}

/// Takes a quaternion of almost unit length back to it: `q(3 − |q|²)/2`, which squares the error of the length.
pub(crate) fn renormalize(q: DQuat) -> DQuat {
    q * (1.5 - 0.5 * q.length_squared())
}

/// The unit quaternion of a rotation matrix, by Shepperd's choice of the largest component (no cancellation
/// at any angle). Of the two quaternions the one with `w ≥ 0` is returned.
#[must_use]
pub fn quaternion(r: DMat3) -> DQuat {
    let (xx, yy, zz) = (r.x_axis.x, r.y_axis.y, r.z_axis.z);
    // Four times the squares of the components.
    let squares = [1.0 + xx + yy + zz, 1.0 + xx - yy - zz, 1.0 - xx + yy - zz, 1.0 - xx - yy + zz];
    let skew = 2.0 * vee(r);
    let (xy, xz, yz) = (r.y_axis.x + r.x_axis.y, r.z_axis.x + r.x_axis.z, r.z_axis.y + r.y_axis.z);
    let largest = squares.iter().copied().fold(f64::MIN, f64::max);
    let (w, x, y, z) = if largest == squares[0] {
        (squares[0], skew.x, skew.y, skew.z)
    } else if largest == squares[1] {
        (skew.x, squares[1], xy, xz)
    } else if largest == squares[2] {
        (skew.y, xy, squares[2], yz)
    } else {
        (skew.z, xz, yz, squares[3])
    };
    let q = DQuat::from_xyzw(x, y, z, w).normalize();
    if q.w < 0.0 { -q } else { q }
}

/// The rotation vector (rad) of a rotation matrix, `|log R| ≤ π`: the inverse of [`exp`].
///
/// By the quaternion, `2 atan2(|q|, q₀) q/|q|`, which is accurate at 0 and at π alike; at exactly π, where
/// both signs are right, one of them is returned.
#[must_use]
pub fn log(r: DMat3) -> DVec3 {
    let q = quaternion(r);
    let v = q.xyz();
    let sine = v.length();
    if sine < 1e-8 {
        // 2 asin(s)/s = 2 + s²/3 + …, the next term is below 1e-16.
        return v * 2.0;
    }
    v * (2.0 * sine.atan2(q.w) / sine)
}

/// The angle (rad) of the rotation that takes attitude `a` to `b`, from `|A − B|_F = 2√2 sin(θ/2)`:
/// accurate down to the rounding of the entries, where `acos` of a trace would lose half the digits.
#[must_use]
pub fn angle_between(a: DMat3, b: DMat3) -> f64 {
    let frobenius = frobenius_norm(a - b);
    2.0 * (frobenius / 8f64.sqrt()).min(1.0).asin()
}

/// How far a matrix is from a rotation: `|RᵀR − 1|_F` (0 for an exact rotation).
#[must_use]
pub fn orthogonality_error(r: DMat3) -> f64 {
    frobenius_norm(r.transpose() * r - DMat3::IDENTITY)
}

/// Square root of the sum of the squares of all entries.
#[must_use]
pub fn frobenius_norm(m: DMat3) -> f64 {
    (m.x_axis.length_squared() + m.y_axis.length_squared() + m.z_axis.length_squared()).sqrt()
}
