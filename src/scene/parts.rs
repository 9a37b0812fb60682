//! What the body looks like.

use glam::{DMat3, DVec3};

use super::{SceneError, SolidFile};
use crate::physics::solids::{Shape, Solid, assemble_turned};
use crate::physics::{Body, so3};

/// Thinnest part drawn, as a fraction of its longest extent, where no solid has the moments.
const THINNEST: f64 = 0.02;

/// A form that a part of the body has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PartKind {
    /// A rectangular box.
    #[default]
    Box,
    /// A cylinder along its own z axis.
    Cylinder,
    /// An ellipsoid.
    Ellipsoid,
}

/// A part of the body, as it is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// Its form.
    pub kind: PartKind,
    /// Full extents (m) along its own axes.
    pub size: DVec3,
    /// Its centre (m) in the body frame, from the body's centre of mass.
    pub centre: DVec3,
    /// Its orientation: takes the part's own axes to the body's.
    pub body_from_part: DMat3,
}

impl Part {
    /// A body of one part.
    pub(super) fn centred(kind: PartKind, size: DVec3, body_from_part: DMat3) -> Self {
        Self { kind, size, centre: DVec3::ZERO, body_from_part }
    }
}

/// The body that solids make, and how they lie about its centre of mass.
pub(super) fn of_solids(files: &[SolidFile]) -> Result<(Body, Vec<Part>), SceneError> {
    let solids: Vec<Solid> = files.iter().map(solid).collect::<Result<_, _>>()?;
    let turns: Vec<DVec3> = files.iter().map(|file| DVec3::from_array(file.rotation_deg)).collect();
    let assembly = assemble_turned(&solids, &turns)?;
    let parts = files
        .iter()
        .zip(&solids)
        .map(|(file, solid)| Part {
            kind: file.kind,
            size: DVec3::from_array(file.size),
            centre: solid.position - assembly.centre,
            body_from_part: solid.body_from_solid,
        })
        .collect();
    Ok((assembly.body, parts))
}

fn solid(file: &SolidFile) -> Result<Solid, SceneError> {
    let size = DVec3::from_array(file.size);
    let shape = match file.kind {
        PartKind::Box => Shape::Box { edges: size },
        PartKind::Ellipsoid => Shape::Ellipsoid { semi_axes: 0.5 * size },
        PartKind::Cylinder if size.x == size.y => Shape::Cylinder { radius: 0.5 * size.x, length: size.z },
        PartKind::Cylinder => return Err(SceneError::NotRound(size.x, size.y)),
    };
    let rotation = DVec3::from_array(file.rotation_deg);
    if !rotation.is_finite() {
        let value = rotation.to_array().into_iter().find(|angle| !angle.is_finite()).unwrap_or_default();
        return Err(SceneError::Number { name: "rotation_deg", value, wanted: "a finite number" });
    }
    Ok(Solid {
        shape,
        density: file.density,
        position: DVec3::from_array(file.position),
        body_from_solid: so3::exp(rotation.map(f64::to_radians)),
    })
}

/// Of all bodies with these moments, the solid of this form: extents along the principal axes. A form that cannot have
/// them (a cylinder has two equal moments) is drawn as a box, and an extent that would be imaginary is drawn thin.
pub(super) fn equivalent(body: &Body, form: PartKind) -> Part {
    let edges = body.equivalent_box(1.0);
    // An ellipsoid has m/5 of its squared semi-axes where a box has m/12 of its squared edges.
    let (kind, size) = match form {
        PartKind::Ellipsoid => (form, edges * (2.0 * (5.0_f64 / 12.0).sqrt())),
        PartKind::Box | PartKind::Cylinder => (PartKind::Box, edges),
    };
    Part::centred(kind, size.max(DVec3::splat(THINNEST * size.max_element())), body.body_from_principal())
}
