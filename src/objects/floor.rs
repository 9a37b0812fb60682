//! Under the body: its soft shadow, and the invariable plane with what Poinsot's construction draws on it.
//!
//! The plane of the contact point is ω·L/ℓ = 2K/ℓ. The inertia ellipsoid touches it at ω above and, being symmetric about
//! its centre, its mirror image at −ω below. The one below is drawn, so that the ellipsoid rolls on a floor.

use std::f32::consts::TAU;

use glam::{Mat2, Mat3, Vec2, Vec3};

use super::{Context, Role, body, labels};
use crate::frame::{
    Color, Dash, Label, LabelStyle, Line, LinePoint, Mark, Marker, Mesh, Pane, Quadric, QuadricPair, Vertex, halved,
};
use crate::frame::{single, single_matrix};
use crate::physics::poinsot;

/// Radius of the drawn part of the plane.
const PLANE_RADIUS: f32 = 0.9;
/// Corners of a circle.
const POINTS: u32 = 128;
/// Flips before and after now that the herpolhode is drawn for.
const FLIPS: f64 = 3.0;
const HERPOLHODE_POINTS: u32 = 1600;
/// Closest points of a drawn path; nearer ones are left out.
const SPACING: f32 = 0.004;

/// The body's soft shadow: the spread of the body's parts over the floor, blurred.
pub(super) fn shadow(context: &Context<'_>, pane: &mut Pane) {
    let floor = Vec3::new(0.0, 0.0, -context.plane_height());
    let (mut weight, mut mean, mut spread) = (0.0, Vec3::ZERO, Mat3::ZERO);
    for (centre, map, ..) in body::placed_parts(context, context.simulation.state()) {
        let volume = map.determinant().abs().max(1e-9);
        weight += volume;
        mean += centre * volume;
        // A uniform cube of half edge 1 has variance 1/3 each way.
        let own = map * map.transpose() * (1.0 / 3.0);
        let apart = Mat3::from_cols(centre * centre.x, centre * centre.y, centre * centre.z);
        spread += (own + apart) * volume;
    }
    if !(weight > 0.0 && spread.is_finite()) {
        return;
    }
    let middle = mean / weight;
    let cov = spread * (1.0 / weight);
    let blur = 0.02;
    let (a, b, d) = (cov.x_axis.x + blur, cov.x_axis.y, cov.y_axis.y + blur);
    // The square root of a symmetric 2×2 matrix A: (A + √det 1)/√(tr + 2√det).
    let root = (a * d - b * b).max(1e-12).sqrt();
    let scale = (a + d + 2.0 * root).sqrt().recip();
    let map = Mat2::from_cols_array(&[a + root, b, b, d + root]) * scale * 2.4;
    let shade = context.palette.shadow;
    let centre = Vec3::new(middle.x, middle.y, floor.z + 0.004);
    disc(pane, centre, map, 6, |r| shade.fade((1.0 - r * r).powi(2)));
}

/// The invariable plane itself, with its name.
pub(super) fn plane(context: &Context<'_>, pane: &mut Pane) {
    let centre = Vec3::new(0.0, 0.0, -context.plane_height());
    let ink = context.palette.ink;
    let corner = |position| Vertex { position, normal: Vec3::ZERO, color: ink.alpha(0.05) };
    let vertices: Vec<Vertex> = circle(centre, PLANE_RADIUS).take(POINTS as usize).map(corner).collect();
    pane.meshes.push(Mesh { opaque: false, vertices, indices: halved(POINTS).concat() });
    pane.lines.push(Line::new(circle(centre, PLANE_RADIUS), 1.4, ink.alpha(0.5)));
    // Without Poinsot's construction on it it is the floor, and nobody asks for its name.
    if !context.shows_any(|role| matches!(role, Role::OnPlane | Role::RollingEllipsoid)) {
        return;
    }
    let anchor = centre + nearside(pane) * PLANE_RADIUS;
    name(pane, "invariable plane", anchor, Vec2::new(0.4, -1.0), ink.alpha(0.8), labels::FLOOR);
}

/// The level direction towards the lower right of the picture.
fn nearside(pane: &Pane) -> Vec3 {
    let (right, _, forward) = pane.camera.axes();
    Vec2::new(right.x - forward.x, right.y - forward.y).normalize_or(Vec2::X).extend(0.0)
}

fn name(pane: &mut Pane, text: &str, anchor: Vec3, toward: Vec2, color: Color, style: LabelStyle) {
    pane.labels.push(Label::new(anchor, toward, text, color, style));
}

/// Poinsot's ellipsoid ½ ω·Iω = K, semi-axes √(2K/Iᵢ): it rolls on the plane without slipping.
pub(super) fn rolling_ellipsoid(context: &Context<'_>, pane: &mut Pane) {
    let (simulation, body) = (context.simulation, context.simulation.body());
    let state = simulation.state();
    let semi_axes = single(poinsot::inertia_semi_axes(body, state.energy(body)) * context.per_radian());
    let world_from_body = context.world_from_body(state);
    let axes = world_from_body * single_matrix(body.body_from_principal());
    if !(semi_axes.min_element() > 0.0 && semi_axes.is_finite() && axes.is_finite()) {
        return;
    }
    let first = Quadric::ellipsoid(Vec3::ZERO, axes, semi_axes, context.palette.ellipsoid);
    pane.quadrics.push(QuadricPair::one(first, true));
    // The polhode as it lies on the ellipsoid: the points that have been or will be in contact.
    let color = context.palette.polhode;
    let curve = poinsot::angular_velocity_polhode(body, state.body_momentum, super::polhode::POINTS);
    let points = curve.into_iter().map(|omega| world_from_body * single(omega * -context.per_radian()));
    let points: Vec<Vec3> = points.collect();
    let (right, up, _) = pane.camera.axes();
    let fitness = |point: &Vec3| point.dot(up) + 0.5 * point.dot(right);
    let is_line = points.iter().any(|point| point.distance(points[0]) > 0.05);
    if let Some(&anchor) = points.iter().filter(|_| is_line).max_by(|a, b| fitness(a).total_cmp(&fitness(b))) {
        name(pane, "polhode", anchor, Vec2::new(1.0, 0.5), color, labels::ROLLING);
    }
    pane.lines.push(Line::new(points, 3.0, color).through(0.6));
    let position = -context.world_angular_velocity(state.world_angular_velocity(body));
    let rim = context.palette.background;
    let color = context.palette.omega;
    // The line of ω, on to where it meets the plane.
    pane.lines.push(Line::new([Vec3::ZERO, position], 1.6, color).dashed(Dash::Dashed(0.06)).through(0.6));
    pane.markers.push(Marker { position, size: 15.0, mark: Mark::Disc, color, rim, hidden: 0.6, moves: true });
}

/// The path of the contact point on the plane, before and after now.
pub(super) fn herpolhode(context: &Context<'_>, pane: &mut Pane) {
    let simulation = context.simulation;
    let body = simulation.body();
    if context.unit_momentum().is_none() {
        return;
    }
    let reach = FLIPS * context.period();
    let color = context.palette.omega;
    let mut points: Vec<LinePoint> = vec![];
    for (n, state) in simulation.around(-reach, reach, HERPOLHODE_POINTS).iter().enumerate() {
        let part = 2.0 * n as f32 / HERPOLHODE_POINTS as f32 - 1.0;
        let position = -context.world_angular_velocity(state.world_angular_velocity(body));
        let strength = if part > 0.0 { 0.35 } else { 1.0 } * (1.0 - part.abs());
        if points.last().is_none_or(|last| last.position.distance(position) > SPACING) && position.is_finite() {
            points.push(LinePoint { position, color: color.fade(strength) });
        }
    }
    pane.lines.push(Line { points, ..Line::new([], 2.2, color).through(0.6) });
    // Its name stands at the outer circle of its annulus, which does not move.
    let (_, outer) = poinsot::herpolhode_radii(body, simulation.state().body_momentum);
    let radius = (outer * context.per_radian()) as f32;
    if radius > 0.02 && radius < PLANE_RADIUS {
        let anchor = Vec3::new(0.0, 0.0, -context.plane_height()) + nearside(pane) * radius;
        name(pane, "path of ω (herpolhode)", anchor, Vec2::new(1.0, -0.3), color, labels::FLOOR);
    }
}

/// The two circles that the herpolhode touches in turn.
pub(super) fn annulus(context: &Context<'_>, pane: &mut Pane) {
    let state = context.simulation.state();
    let (inner, outer) = poinsot::herpolhode_radii(context.simulation.body(), state.body_momentum);
    let centre = Vec3::new(0.0, 0.0, -context.plane_height());
    for radius in [inner, outer] {
        let radius = (radius * context.per_radian()) as f32;
        if radius > 1e-3 && radius < 20.0 {
            let line = Line::new(circle(centre, radius), 1.6, context.palette.ink.alpha(0.7));
            pane.lines.push(line.dashed(Dash::Dashed(0.06)).through(0.3));
        }
    }
}

fn circle(centre: Vec3, radius: f32) -> impl Iterator<Item = Vec3> {
    (0..=POINTS)
        .map(move |n| centre + (Vec2::from_angle(TAU * (n % POINTS) as f32 / POINTS as f32) * radius).extend(0.0))
}

/// A level disc under a linear map, coloured in so many rings by the distance from its middle (0 to 1), and nothing at its rim.
fn disc(pane: &mut Pane, centre: Vec3, map: Mat2, rings: u32, color: impl Fn(f32) -> Color) {
    const SPOKES: u32 = 24;
    let mut mesh = Mesh::default();
    for ring in 0..=rings {
        let r = ring as f32 / rings as f32;
        for spoke in 0..SPOKES {
            let position = centre + (map * Vec2::from_angle(TAU * spoke as f32 / SPOKES as f32) * r).extend(0.0);
            mesh.vertices.push(Vertex { position, normal: Vec3::ZERO, color: color(r) });
        }
    }
    for ring in 0..rings {
        for spoke in 0..SPOKES {
            let (a, b) = (ring * SPOKES + spoke, ring * SPOKES + (spoke + 1) % SPOKES);
            mesh.indices.extend([a, a + SPOKES, b + SPOKES]);
            // The innermost ring has no inner side.
            if ring > 0 {
                mesh.indices.extend([a, b + SPOKES, b]);
            }
        }
    }
    pane.meshes.push(mesh);
}
