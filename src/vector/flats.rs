//! Surfaces that take no light, as the floor and the shadow on it: of one colour, their opacity changing from place to place.
//!
//! They are drawn as the areas where their opacity is at least so much, one in the other, each adding what brings the one before it
//! to its own: no seams shine between neighbours, which areas side by side would show. Readers round to whole levels after each,
//! so that each changes what is seen by one: roundings to the same side would add up.

use std::collections::HashMap;

use glam::{DVec2, DVec3, Vec3};

use super::drawing::{Paint, Path, Shape};
use super::lines::{Projection, simplified};
use crate::frame::{Color, Mesh, Pane, Vertex};

/// Most steps from nothing to the most of the opacity.
const MOST_STEPS: f64 = 64.0;
/// Places nearer than this part of a pixel are one.
const GRID: f64 = 1e-3;
/// Farthest (pixels) that a border passes a point that is left out.
const TOLERANCE: f64 = 0.05;

/// Adds those of a pane that lie beyond its bodies, seen from the eye, or before them, over a ground of this colour.
pub(super) fn draw(pane: &Pane, projection: &Projection, ground: Color, are_before: bool, shapes: &mut Vec<Shape>) {
    let eye = pane.camera.eye();
    let opaque = pane.meshes.iter().filter(|mesh| mesh.opaque);
    let bodies: Vec<Vec3> = opaque.flat_map(|mesh| &mesh.vertices).map(|vertex| vertex.position).collect();
    let middle = bodies.iter().sum::<Vec3>() / bodies.len().max(1) as f32;
    for mesh in pane.meshes.iter().filter(|mesh| !mesh.opaque && takes_no_light(mesh)) {
        let Some(plane) = plane(mesh) else { continue };
        // On the other side of it than the eye.
        let covers = plane.0.dot(middle - plane.1) * plane.0.dot(eye - plane.1) < 0.0;
        if (covers && !bodies.is_empty()) == are_before {
            flat(mesh, projection, ground, shapes);
        }
    }
}

fn takes_no_light(mesh: &Mesh) -> bool {
    mesh.vertices.iter().all(|vertex| vertex.normal.length_squared() < 0.25)
}

/// Normal and a point of the plane of a flat mesh.
fn plane(mesh: &Mesh) -> Option<(Vec3, Vec3)> {
    mesh.indices.chunks_exact(3).find_map(|indices| {
        let corner = |n: usize| mesh.vertices.get(indices[n] as usize).map(|vertex| vertex.position);
        let (a, b, c) = (corner(0)?, corner(1)?, corner(2)?);
        let normal = (b - a).cross(c - a);
        (normal.length_squared() > 0.0).then_some((normal, a))
    })
}

/// A corner on the screen with its opacity.
type Spot = (DVec2, f64);

fn flat(mesh: &Mesh, projection: &Projection, ground: Color, shapes: &mut Vec<Shape>) {
    let spot = |vertex: &Vertex| {
        let at: DVec3 = vertex.position.as_dvec3();
        projection.pixel(at).map(|pixel| (pixel, f64::from(vertex.color.0[3])))
    };
    let spots: Vec<Option<Spot>> = mesh.vertices.iter().map(spot).collect();
    let triangles = mesh.indices.chunks_exact(3).filter_map(|indices| {
        let corner = |n: usize| spots.get(indices[n] as usize).copied().flatten();
        Some([corner(0)?, corner(1)?, corner(2)?])
    });
    let triangles: Vec<[Spot; 3]> = triangles.collect();
    let opacities = || triangles.iter().flatten().map(|spot| spot.1);
    let (least, most) = (opacities().fold(f64::INFINITY, f64::min), opacities().fold(0.0, f64::max));
    let Some(color) = mesh.vertices.first().map(|vertex| vertex.color).filter(|_| most > 0.0) else { return };
    let contrast = color.0.iter().zip(ground.0).take(3).map(|(own, ground)| (own - ground).abs()).fold(0.0, f32::max);
    let levels = (255.0 * f64::from(contrast) * (most - least)).round();
    let steps = if most - least < 1e-3 { 1 } else { levels.clamp(1.0, MOST_STEPS) as usize };
    let mut covered = 0.0;
    for step in 0..steps {
        let threshold = least + (most - least) * step as f64 / steps as f64;
        // What is drawn from this threshold to the next: what lies in their middle.
        let wanted = if steps == 1 { most } else { least + (most - least) * (step as f64 + 0.5) / steps as f64 };
        let added = 1.0 - (1.0 - wanted) / (1.0 - covered);
        covered = wanted;
        let area = triangles.iter().map(|triangle| above(triangle, threshold));
        let path = outline(area);
        if !path.0.is_empty() {
            shapes.push(Shape::Fill { path, even_odd: true, paint: Paint::Flat(Color(color.0).alpha(added as f32)) });
        }
    }
}

/// What of a triangle has at least this opacity.
fn above(triangle: &[Spot; 3], threshold: f64) -> Vec<DVec2> {
    let mut kept = vec![];
    for n in 0..3 {
        let (a, b) = (triangle[n], triangle[(n + 1) % 3]);
        if a.1 >= threshold {
            kept.push(a.0);
        }
        if (a.1 >= threshold) != (b.1 >= threshold) {
            // The same place, whichever way round its neighbour goes.
            let (low, high) = if a.1 < b.1 { (a, b) } else { (b, a) };
            kept.push(low.0.lerp(high.0, (threshold - low.1) / (high.1 - low.1)));
        }
    }
    kept
}

/// The border of areas side by side: the sides that no two of them share.
fn outline(areas: impl Iterator<Item = Vec<DVec2>>) -> Path {
    type Key = (i64, i64);
    let key = |at: DVec2| ((at.x / GRID).round() as i64, (at.y / GRID).round() as i64);
    let mut sides: Vec<(Key, Key)> = vec![];
    let mut places: HashMap<Key, DVec2> = HashMap::new();
    for area in areas.filter(|area| area.len() >= 3) {
        for n in 0..area.len() {
            let (from, to) = (area[n], area[(n + 1) % area.len()]);
            let (a, b) = (key(from), key(to));
            places.insert(a, from);
            if a != b {
                sides.push((a, b));
            }
        }
    }
    let mut times: HashMap<(Key, Key), usize> = HashMap::new();
    for side in &sides {
        *times.entry(*side).or_default() += 1;
    }
    let mut next: HashMap<Key, Vec<Key>> = HashMap::new();
    let mut starts = vec![];
    for (a, b) in sides {
        if !times.contains_key(&(b, a)) {
            next.entry(a).or_default().push(b);
            starts.push(a);
        }
    }
    let mut path = Path::default();
    for start in starts {
        let mut ring = vec![];
        let mut at = start;
        while let Some(to) = next.get_mut(&at).and_then(Vec::pop) {
            ring.extend(places.get(&at));
            at = to;
            if at == start {
                break;
            }
        }
        if ring.len() >= 3 {
            ring.push(ring[0]);
            let mut kept = simplified(&ring, TOLERANCE);
            kept.pop();
            path.append(Path::through(kept, true));
        }
    }
    path
}
