//! Bodies put together from solids: boxes, cylinders and ellipsoids of uniform density, anywhere and any way round.

use glam::{DMat3, DVec3};

use super::double_double::{DoubleDouble, power_of_two};
use super::dyadic::{self, Dyadic};
use super::principal::{self, LIMBS, Tensor};
use super::{Body, BodyError, number, so3};

/// A shape about its own centre, in its own frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// A box with these edges (m).
    Box {
        /// Along x, y, z.
        edges: DVec3,
    },
    /// A cylinder about the z axis.
    Cylinder {
        /// Radius (m).
        radius: f64,
        /// Length along z (m).
        length: f64,
    },
    /// An ellipsoid with these semi-axes (m).
    Ellipsoid {
        /// Along x, y, z.
        semi_axes: DVec3,
    },
}

/// A shape filled with matter, placed in the body's frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solid {
    /// What it is.
    pub shape: Shape,
    /// Density (kg/m³).
    pub density: f64,
    /// Where its centre is (m).
    pub position: DVec3,
    /// The rotation that takes its frame to the body's.
    pub body_from_solid: DMat3,
}

/// Solids that move as one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assembly {
    /// Mass (kg).
    pub mass: f64,
    /// Centre of mass in the frame the positions were given in (m): the point the body turns about.
    pub centre: DVec3,
    /// The body: inertia about the centre of mass, along the axes of that same frame.
    pub body: Body,
}

/// Why solids make no body.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SolidError {
    /// There are none.
    #[error("a body needs one solid at least")]
    None,
    /// A length is not finite and positive.
    #[error("{} m is not the size of a solid: it must be finite and above 0", number(*.0))]
    Size(f64),
    /// A density is not finite and positive.
    #[error("{} kg/m³ is not a density: it must be finite and above 0", number(*.0))]
    Density(f64),
    /// A coordinate is not finite.
    #[error("{} m is not a position: it must be finite", number(*.0))]
    Position(f64),
    /// An orientation is not a rotation.
    #[error("the orientation of a solid is not a rotation: it is off by {}, and 1e-9 is allowed", number(*.0))]
    Orientation(f64),
    /// The whole is no body.
    #[error(transparent)]
    Body(#[from] BodyError),
}

impl Shape {
    /// Volume (m³): `abc`, `πr²l`, `4/3 πabc`.
    #[must_use]
    pub fn volume(&self) -> f64 {
        use std::f64::consts::PI;
        match *self {
            Self::Box { edges } => edges.x * edges.y * edges.z,
            Self::Cylinder { radius, length } => PI * radius * radius * length,
            Self::Ellipsoid { semi_axes } => 4.0 / 3.0 * PI * semi_axes.x * semi_axes.y * semi_axes.z,
        }
    }

    /// Mean squares `⟨x²⟩, ⟨y²⟩, ⟨z²⟩` (m²) of the points of the shape: `a²/12` of an edge, `r²/4` and `l²/12` of a
    /// cylinder, `a²/5` of a semi-axis. The moment about x is `m(⟨y²⟩ + ⟨z²⟩)`.
    #[must_use]
    pub fn mean_squares(&self) -> DVec3 {
        match *self {
            Self::Box { edges } => edges * edges / 12.0,
            Self::Cylinder { radius, length } => {
                let across = 0.25 * radius * radius;
                DVec3::new(across, across, length * length / 12.0)
            }
            Self::Ellipsoid { semi_axes } => semi_axes * semi_axes / 5.0,
        }
    }

    fn sizes(&self) -> [f64; 3] {
        match *self {
            Self::Box { edges } => edges.to_array(),
            Self::Cylinder { radius, length } => [radius, radius, length],
            Self::Ellipsoid { semi_axes } => semi_axes.to_array(),
        }
    }
}

impl Solid {
    /// Mass (kg).
    #[must_use]
    pub fn mass(&self) -> f64 {
        self.density * self.shape.volume()
    }

    /// Inertia about its own centre, along the body's axes (kg m²).
    #[must_use]
    pub fn inertia(&self) -> DMat3 {
        let squares = self.shape.mean_squares();
        let moments = DVec3::new(squares.y + squares.z, squares.z + squares.x, squares.x + squares.y);
        let own = DMat3::from_diagonal(self.mass() * moments);
        self.body_from_solid * own * self.body_from_solid.transpose()
    }

    fn check(&self) -> Result<(), SolidError> {
        let is_positive = |x: &f64| x.is_finite() && *x > 0.0;
        if let Some(&size) = self.shape.sizes().iter().find(|size| !is_positive(size)) {
            return Err(SolidError::Size(size));
        }
        if !is_positive(&self.density) {
            return Err(SolidError::Density(self.density));
        }
        if let Some(&coordinate) = self.position.to_array().iter().find(|x| !x.is_finite()) {
            return Err(SolidError::Position(coordinate));
        }
        let off = so3::orthogonality_error(self.body_from_solid);
        let is_rotation = off <= 1e-9 && self.body_from_solid.determinant() > 0.0;
        if is_rotation { Ok(()) } else { Err(SolidError::Orientation(off)) }
    }
}

/// Mass, centre of mass and body of solids that move as one, by the parallel-axis theorem
/// `I = Σ (R I_own Rᵀ + m (d² 1 − d dᵀ))`, d from the common centre to the solid's own.
///
/// All sums are taken without rounding, so that a light solid far from the others, a thin one and nearly equal moments keep their digits.
/// Where solids overlap, both count. Whether they touch is not asked.
///
/// # Errors
/// No solid, a size or a density that is not finite and positive, a position that is not finite, an orientation that is no rotation, or
/// moments beyond the range of f64.
pub fn assemble(solids: &[Solid]) -> Result<Assembly, SolidError> {
    let orientations: Vec<_> = solids.iter().map(|solid| exact_columns(solid.body_from_solid)).collect();
    put_together(solids, &orientations)
}

/// [`assemble`] with orientations by rotation vectors in degrees, which a matrix would round: 90° is a quarter turn exactly.
///
/// # Errors
/// See [`assemble`]; also where there is not one rotation to each solid.
pub fn assemble_turned(solids: &[Solid], rotations_deg: &[DVec3]) -> Result<Assembly, SolidError> {
    if solids.len() != rotations_deg.len() {
        return Err(SolidError::None);
    }
    let orientations: Vec<_> = rotations_deg.iter().map(|&vector| turned_columns(vector)).collect();
    put_together(solids, &orientations)
}

type Columns = [[Dyadic; 3]; 3];

fn exact_columns(matrix: DMat3) -> Columns {
    [0, 1, 2].map(|i| matrix.col(i).to_array().map(Dyadic::from))
}

/// The rotation of a rotation vector in degrees, by its quaternion to 106 bits.
fn turned_columns(rotation_deg: DVec3) -> Columns {
    let largest = rotation_deg.abs().max_element();
    if largest == 0.0 {
        return exact_columns(DMat3::IDENTITY);
    }
    let vector = rotation_deg / power_of_two(largest);
    let length =
        vector.to_array().into_iter().fold(DoubleDouble::ZERO, |sum, x| sum + DoubleDouble::product(x, x)).sqrt();
    let (sine, cosine) = so3::exact_sine_and_cosine(length.scaled(0.5 * power_of_two(largest)));
    let [x, y, z] = vector.to_array().map(|component| Dyadic::from(DoubleDouble::from(component) / length * sine));
    principal::rotation([x, y, z, Dyadic::from(cosine)])
}

fn put_together(solids: &[Solid], orientations: &[Columns]) -> Result<Assembly, SolidError> {
    let first = solids.first().ok_or(SolidError::None)?;
    for solid in solids {
        solid.check()?;
    }
    // Everything from the first solid, so that a body of one piece has its centre without rounding.
    let origin = first.position.to_array().map(Dyadic::from);
    let mut mass = Dyadic::default();
    let mut moment = [Dyadic::default(), Dyadic::default(), Dyadic::default()];
    let mut tensor: Tensor = Default::default();
    for (solid, columns) in solids.iter().zip(orientations) {
        let weight = solid.exact_mass();
        let at = subtract(&solid.position.to_array().map(Dyadic::from), &origin);
        let [x2, y2, z2] = solid.shape.exact_mean_squares();
        let own = [&y2 + &z2, &z2 + &x2, &x2 + &y2];
        for (entry, ((i, j), steiner)) in tensor.iter_mut().zip(ENTRIES.into_iter().zip(parallel_axes(&at))) {
            let turned = (0..3).map(|k| &own[k] * &(&columns[k][i] * &columns[k][j]));
            let all = turned.fold(steiner, |sum, term| &sum + &term);
            *entry = &*entry + &(&weight * &all);
        }
        for (sum, x) in moment.iter_mut().zip(&at) {
            *sum = &*sum + &(&weight * x);
        }
        mass = &mass + &weight;
    }
    let inverse_mass = mass.reciprocal(LIMBS);
    for (entry, steiner) in tensor.iter_mut().zip(parallel_axes(&moment)) {
        *entry = (&*entry - &(&steiner * &inverse_mass)).rounded(LIMBS);
    }
    let [xx, yy, zz, xy, xz, yz] = tensor.each_ref().map(Dyadic::value);
    let inertia = DMat3::from_cols_array(&[xx, xy, xz, xy, yy, yz, xz, yz, zz]);
    if let Some(entry) = inertia.to_cols_array().into_iter().find(|entry| !entry.is_finite()) {
        return Err(BodyError::NotFinite(entry).into());
    }
    let centre = [0, 1, 2].map(|i| (&origin[i] + &(&moment[i] * &inverse_mass)).value());
    let body = Body::from_exact_tensor(inertia, &tensor)?;
    Ok(Assembly { mass: mass.value(), centre: DVec3::from_array(centre), body })
}

/// The entries of a symmetric tensor in their order.
const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// `d² 1 − d dᵀ`.
fn parallel_axes(d: &[Dyadic; 3]) -> Tensor {
    let square = dyadic::dot(d, d);
    ENTRIES.map(|(i, j)| {
        let product = &d[i] * &d[j];
        if i == j { &square - &product } else { -product }
    })
}

fn subtract(a: &[Dyadic; 3], b: &[Dyadic; 3]) -> [Dyadic; 3] {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

impl Shape {
    /// [`Shape::volume`] without rounding, but for π.
    fn exact_volume(&self) -> Dyadic {
        let [a, b, c] = self.sizes().map(Dyadic::from);
        let product = &(&a * &b) * &c;
        match self {
            Self::Box { .. } => product,
            Self::Cylinder { .. } => &product * &dyadic::pi(),
            Self::Ellipsoid { .. } => (&(&product * &dyadic::pi()) * &Dyadic::ratio(4.0, 3.0, LIMBS)).rounded(LIMBS),
        }
    }

    /// [`Shape::mean_squares`] to as many digits.
    fn exact_mean_squares(&self) -> [Dyadic; 3] {
        let square = |x: f64, divisor: f64| {
            let x = Dyadic::from(x);
            (&(&x * &x) * &Dyadic::ratio(1.0, divisor, LIMBS)).rounded(LIMBS)
        };
        match *self {
            Self::Box { edges } => edges.to_array().map(|edge| square(edge, 12.0)),
            Self::Cylinder { radius, length } => [square(radius, 4.0), square(radius, 4.0), square(length, 12.0)],
            Self::Ellipsoid { semi_axes } => semi_axes.to_array().map(|axis| square(axis, 5.0)),
        }
    }
}

impl Solid {
    fn exact_mass(&self) -> Dyadic {
        &Dyadic::from(self.density) * &self.shape.exact_volume()
    }
}
