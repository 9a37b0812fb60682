//! Principal moments and axes to 106 bits, and the numbers that they came from without any rounding.
//!
//! A phase after 10¹² turns has 26 digits less than the rates it is made of, and those hang on the moments' differences. So each
//! difference here has a relative error of some `2⁻¹⁰⁰` of its own, however close the moments are, and so has the moment of a needle.

use glam::{DMat3, DVec3};

use super::double_double::{DoubleDouble, Wide, exponent_of, power_of_two_of};
use super::dyadic::Dyadic;
use super::so3;

/// Digits carried while axes are found: 320 bits at least, of which a needle or a pair of nearly equal moments may take two thirds.
pub(crate) const LIMBS: usize = 6;
/// The square of a turn by less than `2⁻⁵⁶` is nothing to 106 bits.
const SMALL_TURN: f64 = 1.387_778_780_781_445_7e-17;
/// What rounding leaves where there is nothing, in units of the largest entry: below `2⁻²⁵⁰`.
const NOTHING: f64 = 5.527_147_875_260_445e-76;

/// See the module. Moments are in units of `2^exponent`, so that `1 ≤ I₃ < 2`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Principal {
    /// `I₁ ≤ I₂ ≤ I₃`, and to f64 in kg m².
    pub(crate) moments: [DoubleDouble; 3],
    pub(crate) rounded_moments: DVec3,
    /// `I₂ − I₁`, `I₃ − I₁`, `I₃ − I₂`.
    pub(crate) differences: [DoubleDouble; 3],
    pub(crate) exponent: i32,
    /// Each principal axis in the body frame; right-handed.
    pub(crate) axes: [[DoubleDouble; 3]; 3],
    pub(crate) given: Given,
}

/// What a body was given by: exactly, but for solids, which are good to 159 bits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Given {
    /// Principal moments, each a sum of three.
    Moments([[f64; 3]; 3]),
    /// Edges of a box along the principal axes.
    Edges([f64; 3]),
    /// A tensor's `xx, yy, zz, xy, xz, yz`, and the principal moments found from it, each a sum of three.
    Tensor([[f64; 3]; 6], [[f64; 3]; 3]),
}

/// A symmetric tensor, `xx, yy, zz, xy, xz, yz`.
pub(crate) type Tensor = [Dyadic; 6];

impl Principal {
    /// From moments along the body's axes, any one above 0.
    pub(crate) fn from_moments(moments: [f64; 3]) -> Self {
        let order = ordered(|a, b| moments[a].total_cmp(&moments[b]));
        let sorted = order.map(|i| moments[i]);
        let exponent = exponent_of(sorted[2]);
        let scaled = sorted.map(|moment| in_unit(moment, exponent));
        let difference = |a: usize, b: usize| DoubleDouble::sum(scaled[b], -scaled[a]);
        Self {
            moments: scaled.map(DoubleDouble::from),
            rounded_moments: DVec3::from_array(sorted),
            differences: [difference(0, 1), difference(0, 2), difference(1, 2)],
            exponent,
            axes: right_handed(order.map(unit_axis)),
            given: Given::Moments(scaled.map(|moment| [moment, 0.0, 0.0])),
        }
    }

    /// From the edges of a box along the body's axes and its mass: `m/12 (b² + c²)`, the differences as `m/12 (b − c)(b + c)`.
    pub(crate) fn from_edges(edges: [f64; 3], mass: f64) -> Self {
        let order = ordered(|a, b| edges[b].total_cmp(&edges[a]));
        let given = order.map(|i| edges[i]);
        let (length, weight) = (exponent_of(given[0]), exponent_of(mass));
        let edges = given.map(|edge| in_unit(edge, length));
        // The mass first, lest a square leave the range that the moment itself is in.
        let [a2, b2, c2] = given.map(|edge| (mass / 12.0) * edge * edge);
        let factor = DoubleDouble::from(in_unit(mass, weight)) / DoubleDouble::from(12.0);
        let pair =
            |i: usize, j: usize| DoubleDouble::product(edges[i], edges[i]) + DoubleDouble::product(edges[j], edges[j]);
        let difference =
            |i: usize, j: usize| DoubleDouble::sum(edges[i], -edges[j]) * DoubleDouble::sum(edges[i], edges[j]);
        let largest = Wide::new(pair(0, 1) * factor, 2 * length + weight);
        let unit = largest.exponent - 2 * length - weight;
        let [first, second] = power_of_two_of(-unit);
        let scaled = |x: DoubleDouble| (x * factor).scaled(first).scaled(second);
        Self {
            moments: [pair(1, 2), pair(2, 0), pair(0, 1)].map(scaled),
            rounded_moments: DVec3::new(b2 + c2, c2 + a2, a2 + b2),
            differences: [difference(0, 1), difference(0, 2), difference(1, 2)].map(scaled),
            exponent: largest.exponent,
            axes: right_handed(order.map(unit_axis)),
            given: Given::Edges(edges),
        }
    }

    /// From a positive definite tensor in the body frame.
    pub(crate) fn from_tensor(tensor: &Tensor) -> Self {
        let is_diagonal = tensor[3..].iter().all(Dyadic::is_zero);
        let exponent = tensor.iter().filter(|entry| !entry.is_zero()).map(|entry| entry.wide().exponent).max();
        let exponent = exponent.unwrap_or(0);
        let scaled = tensor.each_ref().map(|entry| entry.scaled(-exponent));
        let (mut moments, mut axes) = if is_diagonal {
            ([0, 1, 2].map(|i| scaled[i].clone()), [0, 1, 2].map(unit_axis))
        } else {
            diagonalize(&scaled)
        };
        let order = ordered(|a, b| (&moments[a] - &moments[b]).sign().cmp(&0));
        moments = order.map(|i| moments[i].clone());
        axes = order.map(|i| axes[i]);
        if !is_diagonal && moments[0].value() < NOTHING.sqrt() {
            // A needle beyond the digits carried: from the determinant.
            let others = (&moments[1] * &moments[2]).rounded(LIMBS);
            moments[0] = (&determinant(&scaled) * &others.reciprocal(LIMBS)).rounded(LIMBS);
        }
        let own = moments[2].wide().exponent;
        let wide = |x: &Dyadic| x.wide().in_unit(own);
        let difference = |a: usize, b: usize| {
            let difference = wide(&(&moments[b] - &moments[a]));
            if !is_diagonal && difference.high.abs() < NOTHING { DoubleDouble::ZERO } else { difference }
        };
        Self {
            moments: moments.each_ref().map(wide),
            // A moment whose ratio to the others is beyond all measure is still above 0.
            rounded_moments: DVec3::from_array(
                moments.each_ref().map(|moment| moment.scaled(exponent).value().max(5e-324)),
            ),
            differences: [difference(0, 1), difference(0, 2), difference(1, 2)],
            exponent: exponent + own,
            axes: right_handed(axes),
            given: if is_diagonal {
                Given::Moments(moments.each_ref().map(|moment| moment.scaled(-own).parts()))
            } else {
                let parts = |x: &Dyadic| x.scaled(-own).parts();
                Given::Tensor(scaled.each_ref().map(parts), moments.each_ref().map(parts))
            },
        }
    }

    /// The axes to f64, as columns.
    pub(crate) fn rounded_axes(&self) -> DMat3 {
        let [first, second, third] = self.axes.map(|axis| DVec3::from_array(axis.map(DoubleDouble::value)));
        DMat3::from_cols(first, second, third)
    }

    /// Components along the principal axes; exact where these are the body's own.
    pub(crate) fn components(&self, vector: [f64; 3]) -> [Wide; 3] {
        let largest = vector.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        if largest == 0.0 {
            return [Wide::ZERO; 3];
        }
        if let Given::Tensor(..) = self.given {
            let exponent = exponent_of(largest);
            let vector = vector.map(|x| in_unit(x, exponent));
            return self.axes.map(|axis| {
                let sum = axis[0] * vector[0] + axis[1] * vector[1] + axis[2] * vector[2];
                Wide::new(sum, exponent)
            });
        }
        self.axes.map(|axis| {
            let (i, sign) = (0..3).find(|&i| axis[i].high != 0.0).map_or((0, 0.0), |i| (i, axis[i].high));
            Wide::from(sign * vector[i])
        })
    }

    /// A principal moment in the unit of the others, however small beside them.
    pub(crate) fn wide_moment(&self, i: usize) -> Wide {
        if self.moments[i].high > 1e-200 {
            return Wide::new(self.moments[i], 0);
        }
        let moment = Wide::from(self.rounded_moments[i]);
        Wide { exponent: moment.exponent - self.exponent, ..moment }
    }

    /// The principal moments without rounding, in a unit of their own.
    pub(crate) fn exact_moments(&self) -> [Dyadic; 3] {
        match self.given {
            Given::Moments(moments) | Given::Tensor(_, moments) => moments.map(Dyadic::of_parts),
            Given::Edges(edges) => {
                let [a, b, c] = edges.map(|edge| &Dyadic::from(edge) * &Dyadic::from(edge));
                [&b + &c, &c + &a, &a + &b]
            }
        }
    }
}

/// `x / 2^exponent`.
fn in_unit(x: f64, exponent: i32) -> f64 {
    let [first, second] = power_of_two_of(-exponent);
    x * first * second
}

fn ordered(compare: impl Fn(usize, usize) -> std::cmp::Ordering) -> [usize; 3] {
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| compare(a, b));
    order
}

fn unit_axis(i: usize) -> [DoubleDouble; 3] {
    let mut axis = [DoubleDouble::ZERO; 3];
    axis[i] = DoubleDouble::from(1.0);
    axis
}

/// Turns the third axis round where the three are left-handed.
fn right_handed(axes: [[DoubleDouble; 3]; 3]) -> [[DoubleDouble; 3]; 3] {
    let [first, second, third] = axes.map(|axis| DVec3::from_array(axis.map(|x| x.high)));
    let is_left_handed = first.cross(second).dot(third) < 0.0;
    [axes[0], axes[1], if is_left_handed { axes[2].map(|x| -x) } else { axes[2] }]
}

/// `det I`.
pub(crate) fn determinant([xx, yy, zz, xy, xz, yz]: &Tensor) -> Dyadic {
    let minor = |a: &Dyadic, b: &Dyadic, c: &Dyadic, d: &Dyadic| &(a * b) - &(c * d);
    let first = xx * &minor(yy, zz, yz, yz);
    let second = xy * &minor(yz, xz, xy, zz);
    let third = xz * &minor(xy, yz, yy, xz);
    &(&first + &second) + &third
}

/// Whether all principal moments are above 0, without rounding: by the leading minors.
pub(crate) fn is_positive_definite(tensor: &Tensor) -> bool {
    let [xx, yy, _, xy, ..] = tensor;
    xx.sign() > 0 && (&(xx * yy) - &(xy * xy)).sign() > 0 && determinant(tensor).sign() > 0
}

/// `IΩ`.
pub(crate) fn product([xx, yy, zz, xy, xz, yz]: &Tensor, v: &[Dyadic; 3]) -> [Dyadic; 3] {
    let row = |a: &Dyadic, b: &Dyadic, c: &Dyadic| &(&(a * &v[0]) + &(b * &v[1])) + &(c * &v[2]);
    [row(xx, xy, xz), row(xy, yy, yz), row(xz, yz, zz)]
}

/// Eigenvalues and axes of a tensor with entries near 1.
///
/// Jacobi's rotations in f64 come first. The rotation they end with, as a quaternion, is a rotation without error once it is divided by its
/// squared length; so is one by the angle whose half has the tangent τ, for any τ. A cycle or two of rotations of that kind, τ from f64 and all else in
/// [`LIMBS`], leave turns so small that their squares are nothing, and those are taken to first order.
fn diagonalize(tensor: &Tensor) -> ([Dyadic; 3], [[DoubleDouble; 3]; 3]) {
    let [xx, yy, zz, xy, xz, yz] = tensor.each_ref().map(Dyadic::value);
    let rough = super::body::symmetric_eigen(DMat3::from_cols_array(&[xx, xy, xz, xy, yy, yz, xz, yz, zz])).1;
    let [first, second, third] = rough;
    let third = if first.cross(second).dot(third) < 0.0 { -third } else { third };
    // Columns are axes; `a` is the tensor in them.
    let mut axes = rotation(so3::quaternion(DMat3::from_cols(first, second, third)).to_array().map(Dyadic::from));
    let mut a = [0, 1, 2].map(|_| [0, 1, 2].map(|_| Dyadic::default()));
    for j in 0..3 {
        let column = product(tensor, &axes[j]).map(|x| x.rounded(LIMBS));
        for i in 0..=j {
            a[i][j] = super::dyadic::dot(&axes[i], &column).rounded(LIMBS);
            a[j][i] = a[i][j].clone();
        }
    }
    for _sweep in 0..16 {
        let mut is_done = true;
        for (p, q) in PAIRS {
            let tangent = tangent_of_turn(&a, p, q);
            if tangent.abs() >= SMALL_TURN {
                is_done = false;
                rotate(&mut a, &mut axes, p, q, tangent / (1.0 + tangent.hypot(1.0)));
            }
        }
        if is_done {
            break;
        }
    }
    let mut axes = axes.each_ref().map(|axis| axis.each_ref().map(|x| x.wide().in_unit(0)));
    for (p, q) in PAIRS {
        let tangent = tangent_of_turn(&a, p, q);
        let shift = &Dyadic::from(tangent) * &a[p][q];
        a[p][p] = &a[p][p] - &shift;
        a[q][q] = &a[q][q] + &shift;
        let turned = [0, 1, 2].map(|i| (axes[p][i] - axes[q][i] * tangent, axes[q][i] + axes[p][i] * tangent));
        (axes[p], axes[q]) = (turned.map(|(x, _)| x), turned.map(|(_, y)| y));
    }
    ([0, 1, 2].map(|i| a[i][i].clone()), axes)
}

const PAIRS: [(usize, usize); 3] = [(0, 1), (0, 2), (1, 2)];

/// Of the turn in the plane of axes p and q that leaves nothing beside the diagonal there.
fn tangent_of_turn(a: &[[Dyadic; 3]; 3], p: usize, q: usize) -> f64 {
    let beside = a[p][q].value();
    if beside.abs() < NOTHING {
        return 0.0;
    }
    let theta = (&a[q][q] - &a[p][p]).value() / (2.0 * beside);
    1f64.copysign(theta) / (theta.abs() + theta.hypot(1.0))
}

/// Turns axes p and q by the angle whose half has the tangent τ.
fn rotate(a: &mut [[Dyadic; 3]; 3], axes: &mut [[Dyadic; 3]; 3], p: usize, q: usize, tau: f64) {
    let (one, tau) = (Dyadic::from(1.0), Dyadic::from(tau));
    let square = &tau * &tau;
    let inverse = (&one + &square).reciprocal(LIMBS);
    let c = (&(&one - &square) * &inverse).rounded(LIMBS);
    let s = (&(&tau + &tau) * &inverse).rounded(LIMBS);
    let turned = |x: &Dyadic, y: &Dyadic| {
        let first = (&(&c * x) - &(&s * y)).rounded(LIMBS);
        [first, (&(&s * x) + &(&c * y)).rounded(LIMBS)]
    };
    // What the two axes share with the third, then with each other.
    let r = 3 - p - q;
    [a[r][p], a[r][q]] = turned(&a[r][p], &a[r][q]);
    (a[p][r], a[q][r]) = (a[r][p].clone(), a[r][q].clone());
    let first = turned(&a[p][p], &a[p][q]);
    let second = turned(&a[q][p], &a[q][q]);
    let [pp, pq] = turned(&first[0], &second[0]);
    let [_, qq] = turned(&first[1], &second[1]);
    (a[p][p], a[q][q], a[p][q]) = (pp, qq, pq.clone());
    a[q][p] = pq;
    let columns = [0, 1, 2].map(|column| turned(&axes[p][column], &axes[q][column]));
    [axes[p], axes[q]] = [0, 1].map(|i| columns.each_ref().map(|pair| pair[i].clone()));
}

/// The columns of the rotation of a quaternion `x, y, z, w` of any length.
pub(crate) fn rotation([x, y, z, w]: [Dyadic; 4]) -> [[Dyadic; 3]; 3] {
    let square = |a: &Dyadic| a * a;
    let (xx, yy, zz, ww) = (square(&x), square(&y), square(&z), square(&w));
    let inverse = (&(&xx + &yy) + &(&zz + &ww)).reciprocal(LIMBS);
    let twice = |a: Dyadic| &a + &a;
    let diagonal = |a: &Dyadic, b: &Dyadic, c: &Dyadic| &(&ww + a) - &(b + c);
    let [xy, xz, yz] = [(&x, &y), (&x, &z), (&y, &z)].map(|(a, b)| a * b);
    let [wx, wy, wz] = [(&w, &x), (&w, &y), (&w, &z)].map(|(a, b)| a * b);
    let columns = [
        [diagonal(&xx, &yy, &zz), twice(&xy + &wz), twice(&xz - &wy)],
        [twice(&xy - &wz), diagonal(&yy, &zz, &xx), twice(&yz + &wx)],
        [twice(&xz + &wy), twice(&yz - &wx), diagonal(&zz, &xx, &yy)],
    ];
    columns.map(|column| column.map(|x| (&x * &inverse).rounded(LIMBS)))
}
