//! Triangles of the simple bodies.

use std::f32::consts::TAU;

use glam::{Mat3, Vec2, Vec3};

use crate::frame::{Color, Mesh, Vertex};

/// Adds a flat four-cornered face; the corners counter-clockwise seen from outside.
pub(super) fn add_quad(mesh: &mut Mesh, corners: [Vec3; 4], normal: Vec3, color: Color) {
    let base = mesh.vertices.len() as u32;
    mesh.vertices.extend(corners.map(|position| Vertex { position, normal, color }));
    mesh.indices.extend([0, 1, 2, 0, 2, 3].map(|index| base + index));
}

/// The cube of half edge 1 under a linear map (which may shear) about a centre; one colour for each of the
/// faces +x, +y, +z and −x, −y, −z.
pub(super) fn add_box(mesh: &mut Mesh, centre: Vec3, map: Mat3, colors: [[Color; 3]; 2]) {
    // Normals go by the inverse transpose, which for normals to be scaled anyway is the cofactor matrix.
    let cofactors = cofactors(map);
    for (side, sign) in colors.into_iter().zip([1.0, -1.0]) {
        for (axis, color) in side.into_iter().enumerate() {
            let unit = |i: usize| Vec3::AXES[(axis + i) % 3];
            let (outward, u, v) = (unit(0) * sign, unit(1), unit(2) * sign);
            let corners = [-u - v, u - v, u + v, v - u].map(|c| centre + map * (outward + c));
            let normal = (cofactors * outward).normalize_or_zero();
            add_quad(mesh, corners, normal, color);
        }
    }
}

/// A round body about the z axis of `map`, through rings of (radius, height), bottom first, of `round` corners each; smooth
/// where the rings lie on the unit sphere.
pub(super) fn add_lathe(
    mesh: &mut Mesh,
    centre: Vec3,
    map: Mat3,
    profile: &[Vec2],
    smooth: bool,
    round: u32,
    color: impl Fn(Vec3) -> Color,
) {
    let cofactors = cofactors(map);
    for pair in profile.windows(2) {
        let (low, high) = (pair[0], pair[1]);
        let slope = Vec2::new(high.y - low.y, low.x - high.x).normalize_or_zero();
        let base = mesh.vertices.len() as u32;
        for i in 0..=round {
            let (sin, cos) = (TAU * i as f32 / round as f32).sin_cos();
            for ring in [low, high] {
                let at = Vec3::new(cos * ring.x, sin * ring.x, ring.y);
                let local = if smooth { at } else { Vec3::new(cos * slope.x, sin * slope.x, slope.y) };
                let normal = (cofactors * local).normalize_or_zero();
                mesh.vertices.push(Vertex { position: centre + map * at, normal, color: color(local) });
            }
        }
        for i in 0..round {
            let at = base + 2 * i;
            mesh.indices.extend([at, at + 2, at + 3, at, at + 3, at + 1]);
        }
    }
}

/// Takes normals where the matrix takes points.
fn cofactors(map: Mat3) -> Mat3 {
    Mat3::from_cols(map.y_axis.cross(map.z_axis), map.z_axis.cross(map.x_axis), map.x_axis.cross(map.y_axis))
}
