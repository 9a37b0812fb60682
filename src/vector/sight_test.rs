//! What is hidden by solving, against rays that are followed by themselves.

use glam::{DVec3, Mat3, Vec3};

use super::sight::{Before, Sight};
use crate::camera::Camera;
use crate::frame::{Area, Color, Mesh, Pane, Quadric, QuadricPair, Vertex};

/// Evenly spread numbers from 0 to 1 (Knuth's MMIX), the same in every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Within a cube of half edge 1.6.
    fn place(&mut self) -> DVec3 {
        DVec3::new(self.next(), self.next(), self.next()) * 3.2 - 1.6
    }
}

/// Part of the way to a place at which its ray first meets the triangle (Möller and Trumbore).
fn meets_triangle(eye: DVec3, place: DVec3, [a, b, c]: [DVec3; 3]) -> Option<f64> {
    let (ray, u, v) = (place - eye, b - a, c - a);
    let normal = ray.cross(v);
    let determinant = u.dot(normal);
    let from = eye - a;
    let x = from.dot(normal) / determinant;
    let across = from.cross(u);
    let y = ray.dot(across) / determinant;
    (x >= 0.0 && y >= 0.0 && x + y <= 1.0).then(|| v.dot(across) / determinant).filter(|s| *s > 0.0)
}

/// The same of an ellipsoid, by halving: the ray is outside at the eye, and at `inside` where any of it is within.
fn meets_ellipsoid(eye: DVec3, place: DVec3, quadric: &Quadric) -> Option<f64> {
    let size = |s: f64| {
        let at = eye + (place - eye) * s;
        quadric.unit_from_world.as_dmat4().transform_point3(at).length_squared() - 1.0
    };
    // The least of the size, which is a parabola along the ray.
    let (before, middle, after) = (size(0.0), size(0.5), size(1.0));
    let curve = 2.0 * (before - 2.0 * middle + after);
    let least = (3.0 * before - 4.0 * middle + after) / (2.0 * curve);
    if size(least) >= 0.0 || least <= 0.0 {
        return None;
    }
    let (mut low, mut high) = (0.0, least);
    for _ in 0..60 {
        let half = 0.5 * (low + high);
        if size(half) > 0.0 { low = half } else { high = half }
    }
    Some(low)
}

#[test]
fn lines_are_hidden_where_a_ray_says_so_and_to_a_millionth_of_their_length() {
    const PIECES: usize = 300;
    const LOOKS: usize = 200;
    let mut random = Random(7);
    let camera = Camera::new(0.7, 0.4, 6.6);
    let eye = camera.eye().as_dvec3();
    let mut pane = Pane::new(Area::WHOLE, camera, 0.014);
    let color = Color::hex(0);
    let mut triangles = vec![];
    let mut mesh = Mesh { opaque: true, ..Mesh::default() };
    for _ in 0..12 {
        let corners = [(); 3].map(|()| random.place().as_vec3());
        let base = mesh.vertices.len() as u32;
        mesh.vertices.extend(corners.map(|position| Vertex { position, normal: Vec3::Z, color }));
        mesh.indices.extend([base, base + 1, base + 2]);
        triangles.push(corners.map(glam::Vec3::as_dvec3));
    }
    pane.meshes.push(mesh);
    let turned = Mat3::from_rotation_x(0.4) * Mat3::from_rotation_z(1.1);
    let first = Quadric::ellipsoid(Vec3::ZERO, Mat3::IDENTITY, Vec3::ONE, color);
    let second = Quadric::ellipsoid(Vec3::new(0.2, 0.0, 0.1), turned, Vec3::new(0.5, 0.9, 1.4), color);
    pane.quadrics.push(QuadricPair::two(first, second, false));
    let sight = Sight::new(&pane, camera.clip_from_world(1.0).as_dmat4());

    let lift = 1.0 + f64::from(pane.lift);
    let mut looks_hidden = 0;
    let mut borders = 0;
    for number in 0..PIECES {
        let (from, to) = (random.place(), random.place());
        let before = if number % 2 == 0 { Before::All } else { Before::Opaque };
        let is_hidden = |t: f64| {
            let place = from.lerp(to, t);
            let by_triangle = triangles.iter().filter_map(|corners| meets_triangle(eye, place, *corners));
            let walls = [first, second].into_iter().filter(|_| before == Before::All);
            let by_wall = walls.filter_map(|quadric| meets_ellipsoid(eye, place, &quadric));
            by_triangle.chain(by_wall).any(|s| s * lift < 1.0)
        };
        let parts = sight.hidden(from, to, before);
        let found = |t: f64| parts.iter().any(|[low, high]| *low <= t && t <= *high);
        // Nearer than this to a border the two may differ: places are rounded to f32, 1e-7 of a length of 3, and slanting sides
        // multiply it.
        let near = |t: f64| parts.iter().flatten().any(|border| (t - border).abs() < 1e-4);
        for look in 0..LOOKS {
            let t = (look as f64 + 0.5) / LOOKS as f64;
            assert!(found(t) == is_hidden(t) || near(t), "piece {number} at {t}: {parts:?}");
            looks_hidden += usize::from(found(t));
        }
        // Each border is where it says.
        for border in parts.iter().flatten().filter(|border| **border > 1e-3 && **border < 1.0 - 1e-3) {
            let is_inner = |t: f64| parts.iter().any(|[low, high]| *low + 2e-6 < t && t < *high - 2e-6);
            let sides = [border - 1e-5, border + 1e-5];
            if is_inner(sides[0]) != is_inner(sides[1]) {
                assert_ne!(is_hidden(border - 1e-5), is_hidden(border + 1e-5), "piece {number} at {border}");
                borders += 1;
            }
        }
    }
    // Neither nothing nor all is hidden.
    let part = looks_hidden as f64 / (PIECES * LOOKS) as f64;
    assert!(part > 0.2 && part < 0.9 && borders > 100, "{part}, {borders}");
}

#[test]
fn what_lies_on_a_surface_is_seen_and_what_lies_behind_it_is_not() {
    let camera = Camera::new(0.0, 0.0, 6.7);
    let mut pane = Pane::new(Area::WHOLE, camera, 0.014);
    pane.add_cutting(Quadric::ellipsoid(Vec3::ZERO, Mat3::IDENTITY, Vec3::ONE, Color::hex(0)));
    let sight = Sight::new(&pane, camera.clip_from_world(1.0).as_dmat4());
    // Along the axis towards the eye, from its far end to its near end: hidden to where it comes within 1.4 % of the distance
    // to the near pole, 6.7 − x = (6.7 − 1) · 1.014.
    let parts = sight.hidden(DVec3::new(-1.0, 0.0, 0.0), DVec3::new(1.0, 0.0, 0.0), Before::All);
    assert_eq!(parts.len(), 1);
    assert!(parts[0][0] == 0.0 && (2.0 * parts[0][1] - 1.0 - (6.7 - 5.7 * 1.014)).abs() < 1e-6, "{parts:?}");
    assert_eq!(sight.hidden(DVec3::X, DVec3::new(1.3, 0.0, 0.0), Before::All), Vec::<[f64; 2]>::new());
    assert_eq!(sight.hidden(-DVec3::X, DVec3::X, Before::Opaque), Vec::<[f64; 2]>::new());
    // Across behind it: the outline's shadow, tan of the angle of the ray that touches the sphere.
    let behind = sight.hidden(DVec3::new(-2.0, -3.0, 0.0), DVec3::new(-2.0, 3.0, 0.0), Before::All);
    let edge = 8.7 / (6.7_f64.powi(2) - 1.0).sqrt();
    assert!((behind[0][0] * 6.0 - 3.0 + edge).abs() < 1e-5 && (behind[0][1] * 6.0 - 3.0 - edge).abs() < 1e-5);
}
