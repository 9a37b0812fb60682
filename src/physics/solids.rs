//! Bodies put together from solids: boxes, cylinders and ellipsoids of uniform density, anywhere and any way round.

use glam::{DMat3, DVec3};

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
/// Where solids overlap, both count. Whether they touch is not asked.
///
/// # Errors
/// No solid, a size or a density that is not finite and positive, a position that is not finite, an orientation that is no rotation, or
/// moments beyond the range of f64.
pub fn assemble(solids: &[Solid]) -> Result<Assembly, SolidError> {
    let first = solids.first().ok_or(SolidError::None)?;
    for solid in solids {
        solid.check()?;
    }
    let mass: f64 = solids.iter().map(Solid::mass).sum();
    // From the first solid, so that a body of one piece has its centre without rounding.
    let offset: DVec3 = solids.iter().map(|solid| solid.mass() / mass * (solid.position - first.position)).sum();
    let centre = first.position + offset;
    let mut inertia = DMat3::ZERO;
    for solid in solids {
        let hat = so3::hat((solid.position - first.position) - offset);
        inertia += solid.inertia() - hat * hat * solid.mass();
    }
    let body = Body::from_tensor(0.5 * inertia + 0.5 * inertia.transpose())?;
    Ok(Assembly { mass, centre, body })
}
