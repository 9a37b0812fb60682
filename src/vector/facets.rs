//! Bodies as flat areas: their faces in light, each drawn over those behind it.
//!
//! Of two faces that cover each other on the screen the planes tell which is nearer: at every corner of what they have in common.
//! Where that differs from corner to corner they pierce each other, and one is cut in two along the plane of the other. What is left
//! is a partial order, and any list that keeps it draws the picture.

use std::collections::BinaryHeap;

use glam::{DVec2, DVec3, Vec3};

use super::drawing::{Paint, Path, Shape};
use super::lines::Projection;
use super::sight::Sight;
use crate::frame::{Color, Mesh, Pane, Vertex};
use crate::render::light::{BODY_GLOSS, Light};

/// Areas smaller than this (square pixels) have nothing in common.
const LEAST: f64 = 0.02;
/// Depths that differ by less than this part are one: twice what f32 leaves of them at most.
const SAME: f64 = 2e-6;
/// Most faces that cutting may come to.
const MOST: usize = 30_000;
/// Opaque faces are drawn larger by this (pixels) on all sides: no gap shines between neighbours.
const OVERLAP: f64 = 0.25;

/// A flat, convex face before the eye.
#[derive(Clone, Debug)]
pub(super) struct Facet {
    corners: Vec<DVec3>,
    pixels: Vec<DVec2>,
    /// Its plane, seen from the eye: normal·p = distance, both such that the distance is above 0.
    normal: DVec3,
    distance: f64,
    depth: f64,
    color: Color,
    is_opaque: bool,
}

/// The faces of the lit bodies of a pane, the farthest first.
pub(super) fn facets(pane: &Pane, sight: &Sight, projection: &Projection) -> Vec<Facet> {
    let eye = pane.camera.eye();
    let light = Light::of(&pane.camera);
    let mut facets = vec![];
    for mesh in &pane.meshes {
        for (corners, vertices) in faces(mesh) {
            let Some(mut facet) = Facet::new(corners, eye.as_dvec3(), projection) else { continue };
            let count = vertices.len() as f32;
            let outward = vertices.iter().map(|vertex| vertex.normal).sum::<Vec3>() / count;
            if outward.length_squared() < 0.25 {
                continue;
            }
            let middle = vertices.iter().map(|vertex| vertex.position).sum::<Vec3>() / count;
            let to_eye = (eye - middle).normalize_or_zero();
            let is_away = facet.normal.as_vec3().dot(outward) > 0.0;
            // What looks away is mostly behind the rest of its body.
            if is_away && mesh.opaque && facet.is_hidden(sight) {
                continue;
            }
            let normal = if is_away { -outward } else { outward }.normalize_or_zero();
            let color = vertices.iter().map(|vertex| Vec3::from_slice(&vertex.color.0)).sum::<Vec3>() / count;
            let alpha = vertices.iter().map(|vertex| vertex.color.0[3]).sum::<f32>() / count;
            let [r, g, b] = light.lit(color, normal, to_eye, BODY_GLOSS).min(Vec3::ONE).to_array();
            facet.color = Color([r, g, b, alpha]);
            facet.is_opaque = mesh.opaque;
            facets.push(facet);
        }
    }
    in_order(facets, eye.as_dvec3(), projection)
}

/// The faces of a mesh: its triangles, two that follow each other and lie in one plane made one.
fn faces(mesh: &Mesh) -> Vec<(Vec<DVec3>, Vec<Vertex>)> {
    let corner = |index: &u32| mesh.vertices.get(*index as usize).copied();
    let triangles = mesh.indices.chunks_exact(3).filter_map(|indices| {
        let corners: Vec<Vertex> = indices.iter().filter_map(corner).collect();
        (corners.len() == 3).then_some(corners)
    });
    let mut faces: Vec<Vec<Vertex>> = vec![];
    for triangle in triangles {
        let merged = faces.last().filter(|last| last.len() == 3).and_then(|last| quadrangle(last, &triangle));
        match merged {
            Some(face) => {
                faces.pop();
                faces.push(face);
            }
            None => faces.push(triangle),
        }
    }
    let placed = faces.into_iter().map(|face| (face.iter().map(|vertex| vertex.position.as_dvec3()).collect(), face));
    placed.collect()
}

/// Two triangles that share a side and lie in one plane as one face, where it is convex.
fn quadrangle(one: &[Vertex], other: &[Vertex]) -> Option<Vec<Vertex>> {
    let is_same = |a: &Vertex, b: &Vertex| a.position == b.position;
    let shared = |vertex: &Vertex| other.iter().any(|own| is_same(own, vertex));
    let apart = one.iter().position(|vertex| !shared(vertex))?;
    let opposite = other.iter().find(|vertex| !one.iter().any(|own| is_same(own, vertex)))?;
    let face = [one[apart], one[(apart + 1) % 3], *opposite, one[(apart + 2) % 3]];
    if !(shared(&face[1]) && shared(&face[3])) {
        return None;
    }
    let side = |n: usize| face[(n + 1) % 4].position - face[n % 4].position;
    let turns: Vec<Vec3> = (0..4).map(|n| side(n).cross(side(n + 1))).collect();
    let is_flat = turns.iter().all(|turn| {
        let (turn, first) = (turn.normalize_or_zero(), turns[0].normalize_or_zero());
        turn == Vec3::ZERO || turn.dot(first) > 1.0 - 1e-5
    });
    is_flat.then(|| face.to_vec())
}

impl Facet {
    /// None for one that is not wholly before the eye, or seen edge on.
    fn new(corners: Vec<DVec3>, eye: DVec3, projection: &Projection) -> Option<Self> {
        let pixels: Option<Vec<DVec2>> = corners.iter().map(|corner| projection.pixel(*corner)).collect();
        let pixels = pixels?;
        // Newell's normal: of all corners alike.
        let sides = (0..corners.len()).map(|n| (corners[n] - eye, corners[(n + 1) % corners.len()] - eye));
        let normal = sides.fold(DVec3::ZERO, |sum, (a, b)| sum + a.cross(b)).normalize_or_zero();
        let distance = normal.dot(corners[0] - eye);
        if distance.abs() < 1e-9 || area(&pixels).abs() < LEAST * 0.1 {
            return None;
        }
        let depth = corners.iter().map(|corner| corner.distance(eye)).sum::<f64>() / corners.len() as f64;
        let (normal, distance) = (normal * distance.signum(), distance.abs());
        Some(Self { corners, pixels, normal, distance, depth, color: Color([0.0; 4]), is_opaque: true })
    }

    fn middle(&self) -> DVec3 {
        self.corners.iter().sum::<DVec3>() / self.corners.len() as f64
    }

    /// Whether bodies hide its middle and all its corners, a little inwards.
    fn is_hidden(&self, sight: &Sight) -> bool {
        let middle = self.middle();
        let inner = self.corners.iter().map(|corner| corner.lerp(middle, 0.002));
        inner.chain([middle]).all(|place| sight.is_behind_bodies(place, 1.0 + 1e-4))
    }

    /// Whether it lies before walls that would be drawn over it.
    pub(super) fn stands_out_of_walls(&self, sight: &Sight) -> bool {
        let middle = self.middle();
        let mut places = self.corners.iter().copied().chain([middle]);
        self.is_opaque && !sight.is_behind_walls(middle) && places.any(|place| sight.is_within_walls(place))
    }

    /// Cut where walls begin to be before it: straight between the places where they do on its border.
    pub(super) fn cut_at_walls(self, sight: &Sight, eye: DVec3, projection: &Projection) -> Vec<Self> {
        let count = self.corners.len();
        let mut places: Vec<(DVec3, bool)> = vec![];
        for n in 0..count {
            let (from, to) = (self.corners[n], self.corners[(n + 1) % count]);
            places.push((from, false));
            for [low, high] in sight.behind_walls(from, to) {
                let cuts = [low, high].into_iter().filter(|t| *t > 1e-6 && *t < 1.0 - 1e-6);
                places.extend(cuts.map(|t| (from.lerp(to, t), true)));
            }
        }
        let cuts: Vec<usize> = (0..places.len()).filter(|n| places[*n].1).collect();
        let [first, second] = cuts[..] else { return vec![self] };
        let corners: Vec<DVec3> = places.into_iter().map(|place| place.0).collect();
        let inner = corners[first..=second].to_vec();
        let outer = corners[second..].iter().chain(&corners[..=first]).copied().collect();
        self.parts([inner, outer], eye, projection)
    }

    /// Parts of it with these corners.
    fn parts<const N: usize>(&self, parts: [Vec<DVec3>; N], eye: DVec3, projection: &Projection) -> Vec<Self> {
        let made = parts.into_iter().filter(|corners| corners.len() >= 3).filter_map(|corners| {
            let part = Self::new(corners, eye, projection)?;
            Some(Self {
                color: self.color,
                is_opaque: self.is_opaque,
                normal: self.normal,
                distance: self.distance,
                ..part
            })
        });
        made.collect()
    }

    /// Cut in two along the plane of another.
    fn cut(&self, other: &Self, eye: DVec3, projection: &Projection) -> Vec<Self> {
        let side = |corner: DVec3| other.normal.dot(corner - eye) - other.distance;
        let mut parts = [vec![], vec![]];
        let count = self.corners.len();
        for n in 0..count {
            let (from, to) = (self.corners[n], self.corners[(n + 1) % count]);
            let (a, b) = (side(from), side(to));
            if a >= 0.0 {
                parts[0].push(from);
            }
            if a <= 0.0 {
                parts[1].push(from);
            }
            if a * b < 0.0 {
                let on = from.lerp(to, a / (a - b));
                parts[0].push(on);
                parts[1].push(on);
            }
        }
        self.parts(parts, eye, projection)
    }

    /// The shape of it.
    pub(super) fn shape(&self) -> Shape {
        let outline = if self.is_opaque { grown(&self.pixels, OVERLAP) } else { self.pixels.clone() };
        Shape::Fill { path: Path::through(outline, true), even_odd: false, paint: Paint::Flat(self.color) }
    }
}

/// How two faces lie to each other on the screen.
enum Relation {
    Apart,
    /// The first one is before the second.
    Before,
    Behind,
    Pierced,
}

fn relation(one: &Facet, other: &Facet, ray: impl Fn(DVec2) -> DVec3) -> Relation {
    let common = intersection(&one.pixels, &other.pixels);
    if common.len() < 3 || area(&common).abs() < LEAST {
        return Relation::Apart;
    }
    let middle = common.iter().sum::<DVec2>() / common.len() as f64;
    let (mut before, mut behind) = (false, false);
    for corner in common {
        let ray = ray(corner.lerp(middle, 0.01));
        let depth = |facet: &Facet| facet.distance / facet.normal.dot(ray);
        let (a, b) = (depth(one), depth(other));
        before |= a < b * (1.0 - SAME);
        behind |= a > b * (1.0 + SAME);
    }
    match (before, behind) {
        (false, false) => Relation::Apart,
        (true, false) => Relation::Before,
        (false, true) => Relation::Behind,
        (true, true) => Relation::Pierced,
    }
}

/// Faces so that none comes before one that it covers.
fn in_order(facets: Vec<Facet>, eye: DVec3, projection: &Projection) -> Vec<Facet> {
    let inverse = projection.clip.inverse();
    let ray = |pixel: DVec2| {
        let ndc = ((pixel - projection.corner) / projection.pixels - 0.5) * DVec2::new(2.0, -2.0);
        inverse.project_point3(ndc.extend(1.0)) - eye
    };
    let mut placed: Vec<(Facet, [DVec2; 2])> = vec![];
    // Of each, those that are to be drawn before it can be.
    let mut waits: Vec<Vec<usize>> = vec![];
    let mut open: Vec<Facet> = facets;
    open.reverse();
    while let Some(facet) = open.pop() {
        let [low, high] = bounds(&facet.pixels);
        let (mut behind, mut before) = (vec![], vec![]);
        let mut pieces = None;
        for (number, (other, [other_low, other_high])) in placed.iter().enumerate() {
            if low.cmpgt(*other_high).any() || high.cmplt(*other_low).any() {
                continue;
            }
            match relation(&facet, other, ray) {
                Relation::Apart => {}
                Relation::Before => behind.push(number),
                Relation::Behind => before.push(number),
                Relation::Pierced => {
                    let parts = facet.cut(other, eye, projection);
                    if parts.len() == 2 && placed.len() + open.len() < MOST {
                        pieces = Some(parts);
                        break;
                    }
                }
            }
        }
        if let Some(pieces) = pieces {
            open.extend(pieces);
            continue;
        }
        let number = placed.len();
        for other in before {
            waits[other].push(number);
        }
        waits.push(behind);
        placed.push((facet, [low, high]));
    }
    let placed: Vec<Facet> = placed.into_iter().map(|(facet, _)| facet).collect();
    sorted(&placed, &waits)
}

/// The farthest first of those that wait for no other.
fn sorted(facets: &[Facet], waits: &[Vec<usize>]) -> Vec<Facet> {
    let mut left: Vec<usize> = waits.iter().map(Vec::len).collect();
    let mut wait_for: Vec<Vec<usize>> = vec![vec![]; facets.len()];
    for (number, others) in waits.iter().enumerate() {
        for other in others {
            wait_for[*other].push(number);
        }
    }
    // Distances as whole numbers, so that they can be compared.
    let key = |number: usize| ((facets[number].depth * 1e9) as u64, number);
    let mut ready: BinaryHeap<(u64, usize)> = (0..facets.len()).filter(|n| left[*n] == 0).map(key).collect();
    let mut order = vec![];
    let mut is_drawn = vec![false; facets.len()];
    loop {
        // A ring of faces, each over the next one: the farthest begins.
        let next = ready.pop().or_else(|| (0..facets.len()).filter(|n| !is_drawn[*n]).map(key).max());
        let Some((_, number)) = next else { break };
        if std::mem::replace(&mut is_drawn[number], true) {
            continue;
        }
        order.push(number);
        for &other in &wait_for[number] {
            left[other] = left[other].saturating_sub(1);
            if left[other] == 0 {
                ready.push(key(other));
            }
        }
    }
    order.into_iter().map(|number| facets[number].clone()).collect()
}

fn bounds(pixels: &[DVec2]) -> [DVec2; 2] {
    let start = [DVec2::INFINITY, DVec2::NEG_INFINITY];
    pixels.iter().fold(start, |[low, high], at| [low.min(*at), high.max(*at)])
}

/// Area of a polygon, its sign that of its turn.
fn area(corners: &[DVec2]) -> f64 {
    let count = corners.len();
    0.5 * (0..count).map(|n| corners[n].perp_dot(corners[(n + 1) % count])).sum::<f64>()
}

/// What two convex polygons have in common (Sutherland and Hodgman).
fn intersection(one: &[DVec2], other: &[DVec2]) -> Vec<DVec2> {
    let turn = area(other).signum();
    let mut common = one.to_vec();
    for n in 0..other.len() {
        let (from, to) = (other[n], other[(n + 1) % other.len()]);
        let side = |at: DVec2| (to - from).perp_dot(at - from) * turn;
        let mut kept = vec![];
        for m in 0..common.len() {
            let (a, b) = (common[m], common[(m + 1) % common.len()]);
            let (x, y) = (side(a), side(b));
            if x >= 0.0 {
                kept.push(a);
            }
            if x * y < 0.0 {
                kept.push(a.lerp(b, x / (x - y)));
            }
        }
        common = kept;
        if common.len() < 3 {
            return vec![];
        }
    }
    common
}

/// A convex polygon with its sides moved outwards by so many pixels.
fn grown(corners: &[DVec2], by: f64) -> Vec<DVec2> {
    let turn = area(corners).signum();
    let mut distinct = corners.to_vec();
    distinct.dedup_by(|a, b| a.distance(*b) < 1e-6);
    if distinct.len() > 1 && distinct[0].distance(distinct[distinct.len() - 1]) < 1e-6 {
        distinct.pop();
    }
    let count = distinct.len();
    let outward = |from: DVec2, to: DVec2| -(to - from).normalize_or_zero().perp() * turn;
    (0..count)
        .map(|n| {
            let (before, at, after) = (distinct[(n + count - 1) % count], distinct[n], distinct[(n + 1) % count]);
            let (a, b) = (outward(before, at), outward(at, after));
            // Where the two sides meet, and no farther out than three times as much at a sharp corner.
            let reach = (a + b) / (1.0 + a.dot(b)).max(1e-9);
            at + reach.clamp_length_max(3.0) * by
        })
        .collect()
}
