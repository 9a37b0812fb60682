//! Principal moments and axes of a body, from the exact values of the numbers that describe it.

use dzhanibekov::physics::solids::{Shape, Solid};
use dzhanibekov::physics::{Body, solids};
use glam::{DMat3, DVec3};

use super::real::{
    Matrix, Real, Vector, dot, exponent, identity, is_negative, product, real, root, transposed, vector,
};

/// What a body is given by.
#[derive(Clone, Debug)]
pub(crate) enum Inertia {
    /// Principal moments along the body's own axes.
    Moments([f64; 3]),
    /// xx, yy, zz, xy, xz, yz.
    Tensor([f64; 6]),
    /// A solid box.
    Box { edges: [f64; 3], mass: f64 },
    /// Solids that move as one.
    Solids(Vec<Solid>),
}

/// Moments in ascending order, and the rotation into their frame.
#[derive(Clone, Debug)]
pub(crate) struct Principal {
    pub(crate) moments: Vector,
    pub(crate) principal_from_body: Matrix,
}

impl Inertia {
    /// The crate's body.
    pub(crate) fn body(&self) -> Result<Body, String> {
        match self {
            Self::Moments(moments) => Body::from_moments(DVec3::from_array(*moments)).map_err(|e| e.to_string()),
            Self::Tensor(entries) => Body::from_tensor(tensor(*entries)).map_err(|e| e.to_string()),
            Self::Box { edges, mass } => Body::solid_box(DVec3::from_array(*edges), *mass).map_err(|e| e.to_string()),
            Self::Solids(parts) => solids::assemble(parts).map(|whole| whole.body).map_err(|e| e.to_string()),
        }
    }

    /// In numbers of so many bits.
    pub(crate) fn principal(&self, bits: usize) -> Principal {
        match self {
            Self::Moments(moments) => sorted(&vector(*moments, bits), &identity(bits)),
            Self::Box { edges, mass } => {
                let share = real(*mass, bits) / Real::from(12);
                let [a, b, c] = vector(*edges, bits).map(|edge| edge.sqr());
                sorted(&[&b + &c, &c + &a, &a + &b].map(|sum| sum * &share), &identity(bits))
            }
            Self::Tensor([xx, yy, zz, xy, xz, yz]) => {
                let rows = [[*xx, *xy, *xz], [*xy, *yy, *yz], [*xz, *yz, *zz]];
                diagonalized(rows.map(|row| vector(row, bits)))
            }
            Self::Solids(parts) => diagonalized(assembled(parts, bits)),
        }
    }
}

/// The tensor of the six entries.
pub(crate) fn tensor([xx, yy, zz, xy, xz, yz]: [f64; 6]) -> DMat3 {
    DMat3::from_cols(DVec3::new(xx, xy, xz), DVec3::new(xy, yy, yz), DVec3::new(xz, yz, zz))
}

/// `Σ (B I_own Bᵀ + m (d² 1 − d dᵀ))` about the common centre.
fn assembled(parts: &[Solid], bits: usize) -> Matrix {
    let mass = |solid: &Solid| real(solid.density, bits) * volume(&solid.shape, bits);
    let position = |solid: &Solid| vector(solid.position.to_array(), bits);
    let mut total = real(0.0, bits);
    let mut moment = vector([0.0; 3], bits);
    for part in parts {
        let (m, r) = (mass(part), position(part));
        total += &m;
        moment = [0, 1, 2].map(|i| &moment[i] + &m * &r[i]);
    }
    let centre = moment.map(|x| x / &total);
    let mut sum = [0, 1, 2].map(|_| vector([0.0; 3], bits));
    for part in parts {
        let (m, r) = (mass(part), position(part));
        let d = [0, 1, 2].map(|i| &r[i] - &centre[i]);
        let [x, y, z] = mean_squares(&part.shape, bits);
        let own = [&y + &z, &z + &x, &x + &y];
        let columns = part.body_from_solid.to_cols_array_2d().map(|column| vector(column, bits));
        let rows = transposed(&columns);
        let scaled: Matrix = [0, 1, 2].map(|i| [0, 1, 2].map(|j| &rows[i][j] * &own[j]));
        let turned = product(&scaled, &columns);
        let square = dot(&d, &d);
        for i in 0..3 {
            for j in 0..3 {
                let parallel = if i == j { &square - &d[i] * &d[j] } else { -(&d[i] * &d[j]) };
                sum[i][j] += &m * (&turned[i][j] + parallel);
            }
        }
    }
    sum
}

fn volume(shape: &Shape, bits: usize) -> Real {
    match *shape {
        Shape::Box { edges } => edges.to_array().iter().fold(real(1.0, bits), |v, &edge| v * real(edge, bits)),
        Shape::Cylinder { radius, length } => Real::pi(bits) * real(radius, bits).sqr() * real(length, bits),
        Shape::Ellipsoid { semi_axes } => {
            let of_unit = Real::pi(bits) * Real::from(4) / Real::from(3);
            semi_axes.to_array().iter().fold(of_unit, |v, &axis| v * real(axis, bits))
        }
    }
}

fn mean_squares(shape: &Shape, bits: usize) -> Vector {
    let squares = |sizes: DVec3, share: i32| sizes.to_array().map(|x| real(x, bits).sqr() / Real::from(share));
    match *shape {
        Shape::Box { edges } => squares(edges, 12),
        Shape::Cylinder { radius, length } => {
            let across = real(radius, bits).sqr() / Real::from(4);
            [across.clone(), across, real(length, bits).sqr() / Real::from(12)]
        }
        Shape::Ellipsoid { semi_axes } => squares(semi_axes, 5),
    }
}

/// In ascending order; `axes` are rows.
fn sorted(moments: &Vector, axes: &Matrix) -> Principal {
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| moments[a].partial_cmp(&moments[b]).expect("numbers"));
    let mut rows = order.map(|i| axes[i].clone());
    // An odd order turns one axis round.
    if order == [0, 2, 1] || order == [1, 0, 2] || order == [2, 1, 0] {
        rows[2] = rows[2].clone().map(|x| -x);
    }
    Principal { moments: order.map(|i| moments[i].clone()), principal_from_body: rows }
}

/// Jacobi's rotations to all digits.
fn diagonalized(mut a: Matrix) -> Principal {
    let bits = a[0][0].precision();
    let mut axes = identity(bits);
    loop {
        let largest = (0..3).map(|i| exponent(&a[i][i])).max().expect("three");
        let mut turned = false;
        for (p, q, r) in [(0, 1, 2), (0, 2, 1), (1, 2, 0)] {
            if exponent(&a[p][q]) < largest - bits.cast_signed() {
                continue;
            }
            turned = true;
            let theta = (&a[q][q] - &a[p][p]) / (a[p][q].clone() << 1);
            let size = Real::from(1) + &theta * &theta;
            let t = if is_negative(&theta) {
                -(Real::from(1) / (root(&size) - &theta))
            } else {
                Real::from(1) / (root(&size) + &theta)
            };
            let c = Real::from(1) / root(&(Real::from(1) + &t * &t));
            let s = &t * &c;
            let change = &t * &a[p][q];
            a[p][p] -= &change;
            a[q][q] += &change;
            let (rp, rq) = (&c * &a[r][p] - &s * &a[r][q], &s * &a[r][p] + &c * &a[r][q]);
            a[p][q] = real(0.0, bits);
            a[q][p] = real(0.0, bits);
            (a[r][p], a[p][r]) = (rp.clone(), rp);
            (a[r][q], a[q][r]) = (rq.clone(), rq);
            let (x, y) = (axes[p].clone(), axes[q].clone());
            axes[p] = [0, 1, 2].map(|i| &c * &x[i] - &s * &y[i]);
            axes[q] = [0, 1, 2].map(|i| &s * &x[i] + &c * &y[i]);
        }
        if !turned {
            return sorted(&[a[0][0].clone(), a[1][1].clone(), a[2][2].clone()], &axes);
        }
    }
}
