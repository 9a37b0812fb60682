//! What hides what: the parts of a line that surfaces hide, solved.
//!
//! A place of the pane is hidden where, along its ray from the eye, a surface is met before it: before the place drawn towards
//! the eye by the pane's lift, since a line may lie on a surface. With e the eye, p the place seen from there and k = 1/(1+lift):
//!
//! - A triangle with corners v₁, v₂, v₃ (seen from the eye) and normal n is met by the ray of p where p lies within the three
//!   planes through the eye and its sides, at n·v₁/n·p parts of p; it hides p where that is below k. All four conditions are
//!   linear in p, so on a straight piece of a line they cut out one interval.
//! - An ellipsoid |U(e + s p)| = 1 is met first at the smaller root s₁ of a quadratic in s, and hides p where s₁ < k. On a
//!   straight piece that changes only where the ray touches the outline (discriminant 0) or where s₁ or the other root is k:
//!   both are quadratics in the parameter of the piece. Between their roots one look decides.

use glam::{DMat4, DVec3, DVec4};

use crate::frame::{Pane, Quadric};

/// Parameters of a piece that are nearer than this are one: sides that two triangles share leave no gap.
const SAME: f64 = 1e-6;

/// The surfaces of a pane that hide what is behind them.
#[derive(Debug, Default)]
pub(super) struct Sight {
    eye: DVec3,
    /// Takes places to clip space.
    clip: DMat4,
    /// 1 + lift.
    lift: f64,
    triangles: Vec<Triangle>,
    hulls: Vec<Hull>,
}

/// A triangle of an opaque surface.
#[derive(Debug)]
struct Triangle {
    /// Normals of the planes through the eye and the sides, towards the inside.
    sides: [DVec3; 3],
    /// Its own normal, away from the eye, and its distance from the eye times the normal's length.
    normal: DVec3,
    distance: f64,
    /// Where it is on the screen: low x, low y, high x, high y.
    bounds: DVec4,
}

/// The near wall of an ellipsoid.
#[derive(Debug)]
struct Hull {
    unit_from_world: DMat4,
    /// The eye, in its space.
    eye: DVec3,
}

/// Which surfaces are looked at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Before {
    /// All.
    All,
    /// Opaque ones: what is inside of hollow ones is looked at through their walls.
    Opaque,
}

impl Sight {
    /// Of a pane with this projection.
    pub(super) fn new(pane: &Pane, clip: DMat4) -> Self {
        let eye = pane.camera.eye().as_dvec3();
        let mut triangles = vec![];
        for mesh in pane.meshes.iter().filter(|mesh| mesh.opaque) {
            for corners in mesh.indices.chunks_exact(3) {
                let corner = |n: usize| mesh.vertices.get(corners[n] as usize).map(|vertex| vertex.position.as_dvec3());
                let (Some(a), Some(b), Some(c)) = (corner(0), corner(1), corner(2)) else { continue };
                triangles.extend(Triangle::new([a, b, c], eye, clip));
            }
        }
        let quadrics = pane.quadrics.iter().flat_map(|pair| [Some(pair.first), pair.second]).flatten();
        let hulls = quadrics.map(|quadric| Hull::new(&quadric, eye)).collect();
        Self { eye, clip, lift: 1.0 + f64::from(pane.lift), triangles, hulls }
    }

    /// The parameters (0 to 1) between which a straight piece is hidden, in order and apart from each other.
    pub(super) fn hidden(&self, from: DVec3, to: DVec3, before: Before) -> Vec<[f64; 2]> {
        let (p, way) = (from - self.eye, to - from);
        let mut hidden: Vec<[f64; 2]> = vec![];
        let bounds = bounds([from, to].into_iter(), self.clip);
        for triangle in &self.triangles {
            let apart = bounds.x > triangle.bounds.z || bounds.z < triangle.bounds.x;
            if apart || bounds.y > triangle.bounds.w || bounds.w < triangle.bounds.y {
                continue;
            }
            hidden.extend(triangle.hides(p, way, self.lift));
        }
        if before == Before::All {
            for hull in &self.hulls {
                hull.hides(p, way, self.lift, &mut hidden);
            }
        }
        merged(hidden)
    }

    /// The parameters between which walls are before a straight piece.
    pub(super) fn behind_walls(&self, from: DVec3, to: DVec3) -> Vec<[f64; 2]> {
        let mut parts = vec![];
        for hull in &self.hulls {
            hull.hides(from - self.eye, to - from, 1.0, &mut parts);
        }
        merged(parts)
    }

    /// Whether a wall is before a place.
    pub(super) fn is_behind_walls(&self, place: DVec3) -> bool {
        self.hulls.iter().any(|hull| hull.is_before(place - self.eye, 1.0))
    }

    /// Whether the ray of a place meets any wall, before it or behind.
    pub(super) fn is_within_walls(&self, place: DVec3) -> bool {
        self.hulls.iter().any(|hull| hull.is_met(place - self.eye))
    }

    /// Whether a place is hidden that is drawn this far towards the eye beyond the pane's own lift.
    pub(super) fn hides(&self, place: DVec3, lift: f64) -> bool {
        self.is_behind_bodies(place, lift) || self.hulls.iter().any(|hull| hull.is_before(place - self.eye, lift))
    }

    /// Whether an opaque body hides it.
    pub(super) fn is_behind_bodies(&self, place: DVec3, lift: f64) -> bool {
        let p = place - self.eye;
        self.triangles.iter().any(|triangle| triangle.hides(p, DVec3::ZERO, lift).is_some())
    }
}

impl Triangle {
    /// None where the eye sees it edge on.
    fn new(corners: [DVec3; 3], eye: DVec3, clip: DMat4) -> Option<Self> {
        let [a, b, c] = corners.map(|corner| corner - eye);
        let turn = a.cross(b).dot(c);
        let normal = (b - a).cross(c - a);
        let distance = normal.dot(a);
        // Both are six times the volume of the pyramid with the eye as its tip.
        if turn == 0.0 || distance == 0.0 {
            return None;
        }
        let sides = [a.cross(b), b.cross(c), c.cross(a)].map(|side| side * turn.signum());
        let (normal, distance) = (normal * distance.signum(), distance.abs());
        Some(Self { sides, normal, distance, bounds: bounds(corners.into_iter(), clip) })
    }

    /// The part of the piece p + t way, seen from the eye, that it hides.
    fn hides(&self, p: DVec3, way: DVec3, lift: f64) -> Option<[f64; 2]> {
        let mut part = [0.0, 1.0];
        let conditions = self.sides.iter().map(|side| (side.dot(p), side.dot(way)));
        let depth = (self.normal.dot(p) - self.distance * lift, self.normal.dot(way));
        for (value, slope) in conditions.chain([depth]) {
            // value + t slope > 0
            if slope == 0.0 {
                if value <= 0.0 {
                    return None;
                }
            } else if slope > 0.0 {
                part[0] = f64::max(part[0], -value / slope);
            } else {
                part[1] = f64::min(part[1], -value / slope);
            }
            if part[0] > part[1] {
                return None;
            }
        }
        Some(part)
    }
}

impl Hull {
    fn new(quadric: &Quadric, eye: DVec3) -> Self {
        let unit_from_world = quadric.unit_from_world.as_dmat4();
        Self { unit_from_world, eye: unit_from_world.transform_point3(eye) }
    }

    /// Whether the ray of a place p, seen from the eye, meets it.
    fn is_met(&self, p: DVec3) -> bool {
        let d = self.unit_from_world.transform_vector3(p);
        let (a, b, c) = (d.length_squared(), self.eye.dot(d), self.eye.length_squared() - 1.0);
        c <= 0.0 || b < 0.0 && b * b > a * c
    }

    /// Whether its near wall lies before a place p, seen from the eye.
    fn is_before(&self, p: DVec3, lift: f64) -> bool {
        let d = self.unit_from_world.transform_vector3(p);
        let (a, b, c) = (d.length_squared(), self.eye.dot(d), self.eye.length_squared() - 1.0);
        // An eye inside sees nothing but the wall round it.
        if c <= 0.0 {
            return true;
        }
        let discriminant = b * b - a * c;
        // The smaller root as c/(−b + √…): no difference of what is nearly the same.
        discriminant > 0.0 && b < 0.0 && c * lift < discriminant.sqrt() - b
    }

    /// Adds the parts of the piece p + t way, seen from the eye, that it hides.
    fn hides(&self, p: DVec3, way: DVec3, lift: f64, parts: &mut Vec<[f64; 2]>) {
        let (d, f) = (self.unit_from_world.transform_vector3(p), self.unit_from_world.transform_vector3(way));
        let c = self.eye.length_squared() - 1.0;
        // (o·(d + t f))² − c |d + t f|² and |o + k (d + t f)|² − 1.
        let [b, e] = [self.eye.dot(d), self.eye.dot(f)];
        let outline = [e * e - c * f.dot(f), 2.0 * (b * e - c * d.dot(f)), b * b - c * d.dot(d)];
        let k = lift.recip();
        let wall = [k * k * f.dot(f), 2.0 * k * (e + k * d.dot(f)), c + 2.0 * k * b + k * k * d.dot(d)];
        let mut cuts = vec![0.0, 1.0];
        cuts.extend([outline, wall].into_iter().flat_map(roots).flatten().filter(|t| *t > 0.0 && *t < 1.0));
        cuts.sort_by(f64::total_cmp);
        let between = cuts.windows(2).filter(|pair| self.is_before(p + way * (0.5 * (pair[0] + pair[1])), lift));
        parts.extend(between.map(|pair| [pair[0], pair[1]]));
    }
}

/// The real roots of a t² + b t + c.
fn roots([a, b, c]: [f64; 3]) -> [Option<f64>; 2] {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return [None; 2];
    }
    // Both without a difference of what is nearly the same.
    let q = -0.5 * (b + discriminant.sqrt().copysign(b));
    [(a != 0.0).then(|| q / a), (q != 0.0).then(|| c / q)]
}

/// Where points are on the screen (normalised device coordinates): low x, low y, high x, high y. Everywhere where one is
/// behind the eye.
fn bounds(points: impl Iterator<Item = DVec3>, clip: DMat4) -> DVec4 {
    let (mut low, mut high) = (DVec4::INFINITY, DVec4::NEG_INFINITY);
    for point in points {
        let at = clip * point.extend(1.0);
        if at.w <= f64::from(crate::camera::NEAR) {
            let everywhere = f64::INFINITY;
            return DVec4::new(-everywhere, -everywhere, everywhere, everywhere);
        }
        (low, high) = (low.min(at / at.w), high.max(at / at.w));
    }
    DVec4::new(low.x, low.y, high.x, high.y)
}

/// Intervals in order, those that meet made one.
fn merged(mut parts: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    parts.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut merged: Vec<[f64; 2]> = vec![];
    for part in parts {
        match merged.last_mut() {
            Some(last) if part[0] <= last[1] + SAME => last[1] = last[1].max(part[1]),
            _ => merged.push(part),
        }
    }
    merged.retain(|part| part[1] - part[0] > SAME);
    merged
}
