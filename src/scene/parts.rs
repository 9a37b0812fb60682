//! What the body looks like.

use glam::{DMat3, DVec3};

use super::{SceneError, SolidFile};
use crate::physics::solids::{Shape, Solid, SolidError, assemble_turned};
use crate::physics::{Body, BodyError, number, so3};

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

/// A box of these edges (m) and this mass (kg).
pub(super) fn of_box(edges: DVec3, mass: f64) -> Result<(Body, Vec<Part>), SceneError> {
    let body = Body::solid_box(edges, mass).map_err(|error| match error {
        BodyError::Moment(moment) => {
            let [a, b, c] = edges.to_array().map(number);
            SceneError::MomentOutOfRange { what: format!("a box of {a} x {b} x {c} m and {} kg", number(mass)), moment }
        }
        other => other.into(),
    })?;
    Ok((body, vec![Part::centred(PartKind::Box, edges, DMat3::IDENTITY)]))
}

/// The body that solids make, and how they lie about its centre of mass.
pub(super) fn of_solids(files: &[SolidFile]) -> Result<(Body, Vec<Part>), SceneError> {
    let solids: Vec<Solid> = files.iter().map(solid).collect::<Result<_, _>>()?;
    let turns: Vec<DVec3> = files.iter().map(|file| DVec3::from_array(file.rotation_deg)).collect();
    let assembly = assemble_turned(&solids, &turns).map_err(|error| match error {
        SolidError::Body(BodyError::Moment(moment)) => {
            SceneError::MomentOutOfRange { what: "the body of these solids".to_owned(), moment }
        }
        other => other.into(),
    })?;
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
        return Err(SceneError::OutOfRange { name: "rotation_deg", value, wanted: "a finite number" });
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

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use crate::physics::so3;
    use crate::scene::{Part, PartKind, Scene, SceneError, SceneFile};

    fn parts(text: &str) -> Result<Vec<Part>, SceneError> {
        Ok(Scene::check(&SceneFile::parse(text)?)?.parts)
    }

    fn near(one: DVec3, other: DVec3) -> bool {
        // A few sums, products and roots of numbers up to their length.
        (one - other).length() <= 16.0 * f64::EPSILON * other.length().max(1.0)
    }

    #[test]
    fn solids_lie_about_their_centre_of_mass() -> Result<(), SceneError> {
        let text = r#"[[body.solids]]
kind = "box"
size = [1, 2, 3]
position = [1, 0, 0]
density = 2
[[body.solids]]
kind = "cylinder"
size = [2, 2, 4]
rotation_deg = [0, 90, 0]
position = [-3, 0, 1]
density = 1e-9
[[body.solids]]
kind = "ellipsoid"
size = [2, 4, 6]
density = 1e-9
"#;
        // The other two weigh nothing beside the box, so that its centre is the body's.
        let parts = parts(text)?;
        let [cube, cylinder, ellipsoid] = parts.as_slice() else {
            return Err(SceneError::NotTaken("three parts".to_owned()));
        };
        let kinds = [cube, cylinder, ellipsoid].map(|part| part.kind);
        assert_eq!(kinds, [PartKind::Box, PartKind::Cylinder, PartKind::Ellipsoid]);
        assert_eq!([cube.size, ellipsoid.size], [DVec3::new(1.0, 2.0, 3.0), DVec3::new(2.0, 4.0, 6.0)]);
        // To the share of the weight of the others.
        assert!(cube.centre.length() < 1e-7 && (cylinder.centre - DVec3::new(-4.0, 0.0, 1.0)).length() < 1e-7);
        assert!(near(cylinder.body_from_part * DVec3::Z, DVec3::X), "its axis is turned from z to x");
        Ok(())
    }

    #[test]
    fn a_cylinder_and_an_ellipsoid_have_the_inertia_of_books() -> Result<(), SceneError> {
        let inertia = |text: &str| Ok::<_, SceneError>(Scene::check(&SceneFile::parse(text)?)?.body.inertia());
        // A mass of 4/3 π abc: m/5 (b² + c²) with the semi-axes 1, 2, 3.
        let mass = 4.0 / 3.0 * std::f64::consts::PI * 6.0;
        let found = inertia("body.solids = [{ kind = 'ellipsoid', size = [2, 4, 6], density = 1 }]")?;
        assert!(near(found.x_axis / mass, DVec3::new(13.0 / 5.0, 0.0, 0.0)));
        // π r² l, and m r²/2 about its own axis.
        let mass = std::f64::consts::PI * 4.0 * 3.0;
        let found = inertia("body.solids = [{ kind = 'cylinder', size = [4, 4, 3], density = 1 }]")?;
        assert!(near(found.z_axis / mass, DVec3::new(0.0, 0.0, 2.0)));
        Ok(())
    }

    #[test]
    fn moments_are_drawn_as_the_solid_that_has_them() -> Result<(), SceneError> {
        let drawn = |form: &str, moments: &str| -> Result<(PartKind, DVec3), SceneError> {
            let parts = parts(&format!("body = {{ moments = {moments}, form = '{form}' }}"))?;
            Ok(parts.first().map(|part| (part.kind, part.size)).unwrap_or_default())
        };
        // m/12 (b² + c²) of 1 kg with the edges 3, 2, 1, and m/5 (b² + c²) of the semi-axes 3, 2, 1.
        let (kind, size) = drawn("box", "[0.4166666666666667, 0.8333333333333334, 1.0833333333333333]")?;
        assert!(kind == PartKind::Box && near(size, DVec3::new(3.0, 2.0, 1.0)), "{size}");
        let (kind, size) = drawn("ellipsoid", "[1, 2, 2.6]")?;
        assert!(kind == PartKind::Ellipsoid && near(size, DVec3::new(6.0, 4.0, 2.0)), "{size}");
        assert_eq!(drawn("cylinder", "[1, 2, 3]")?, drawn("box", "[1, 2, 3]")?);
        // Where no solid has them it is thin, a fiftieth of its length.
        let (_, size) = drawn("box", "[1, 1, 5]")?;
        assert_eq!(size.min_element(), 0.02 * size.max_element());
        Ok(())
    }

    #[test]
    fn what_is_drawn_of_a_tensor_lies_along_its_axes() -> Result<(), SceneError> {
        let scene = Scene::check(&SceneFile::parse("body.inertia = [2, 2, 3, 0.5, 0, 0]")?)?;
        let turned = scene.parts.first().map(|part| part.body_from_part).unwrap_or_default();
        assert_eq!(turned, scene.body.body_from_principal());
        assert!(so3::angle_between(turned, glam::DMat3::IDENTITY) > 0.1);
        Ok(())
    }
}
