//! Arrows as lit bodies.

use glam::{Mat3, Vec2, Vec3};

use super::mesh::add_lathe;
use crate::frame::{Color, Mesh, Pane};

/// Radius of an arrow's shaft.
const SHAFT: f32 = 0.020;
/// Corners of the outline of its head, and of its shaft, two of which lie on the rim that the eye sees.
const ROUND: u32 = 28;
const ROUND_OF_SHAFT: u32 = 12;

/// Adds an arrow from one point to another; nothing where it would have no length.
pub(super) fn add(pane: &mut Pane, from: Vec3, to: Vec3, color: Color) {
    let length = from.distance(to);
    if !(length.is_finite() && length > 1e-3) {
        return;
    }
    let (head_radius, head_length) = (3.0 * SHAFT, (8.5 * SHAFT).min(0.6 * length));
    let along = (to - from) / length;
    let aside = along.cross(pane.camera.eye() - from).normalize_or(along.any_orthonormal_vector());
    let map = Mat3::from_cols(aside, along.cross(aside), along);
    let neck = length - head_length;
    let shaft = [Vec2::ZERO, Vec2::new(SHAFT, 0.0), Vec2::new(SHAFT, neck)];
    let barbs = Vec2::new(head_radius, neck - 0.2 * head_length);
    let head = [Vec2::new(SHAFT, neck), barbs, Vec2::new(0.0, length)];
    let mut mesh = Mesh { opaque: true, ..Mesh::default() };
    add_lathe(&mut mesh, from, map, &shaft, false, ROUND_OF_SHAFT, |_| color);
    add_lathe(&mut mesh, from, map, &head, false, ROUND, |_| color);
    pane.meshes.push(mesh);
}
