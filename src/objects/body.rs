//! The body itself, its faces told apart: each principal axis has a hue, each end of it a lightness.

use glam::{Mat3, Vec2, Vec3};

use super::{Context, mesh};
use crate::frame::{Color, Line, Mesh, Pane, Vertex, single, single_matrix};
use crate::physics::State;
use crate::scene::PartKind;

/// Corners of a round outline.
const ROUND: u32 = 72;
/// Rings of an ellipsoid from pole to pole.
const RINGS: usize = 48;

/// How large the body is that stands still in momentum space, beside the one in the world.
const STILL: f64 = 0.5;

/// How a body stands in a picture.
#[derive(Clone, Copy, Debug)]
struct Pose {
    picture_from_body: Mat3,
    per_metre: f64,
}

impl Pose {
    /// In the world, in this state.
    fn of(context: &Context<'_>, state: &State) -> Self {
        Self { picture_from_body: context.world_from_body(state), per_metre: context.per_metre() }
    }
}

pub(super) fn draw(context: &Context<'_>, pane: &mut Pane) {
    let pose = Pose::of(context, context.simulation.state());
    draw_posed(context, pane, pose);
}

/// As one sees it who sits on it: it stands still, its axes along those of momentum space.
pub(super) fn still(context: &Context<'_>, pane: &mut Pane) {
    let principal_from_body = single_matrix(context.simulation.body().body_from_principal().transpose());
    draw_posed(context, pane, Pose { picture_from_body: principal_from_body, per_metre: STILL * context.per_metre() });
}

fn draw_posed(context: &Context<'_>, pane: &mut Pane, pose: Pose) {
    let mut mesh = mesh_posed(context, pose, context.palette.faces);
    add_marks(context, pose, &mut mesh);
    mesh.opaque = true;
    pane.meshes.push(mesh);
    edges_posed(context, pose, pane, context.palette.background.alpha(0.55), 1.6);
}

/// The triangles of the body in this state.
pub(super) fn mesh_of(context: &Context<'_>, state: &State, colors: [[Color; 3]; 2]) -> Mesh {
    mesh_posed(context, Pose::of(context, state), colors)
}

fn mesh_posed(context: &Context<'_>, pose: Pose, colors: [[Color; 3]; 2]) -> Mesh {
    let mut mesh = Mesh::default();
    let principal_from_body = single_matrix(context.simulation.body().body_from_principal().transpose());
    for (centre, map, kind, body_from_part) in parts_posed(context, pose) {
        let principal_from_part = principal_from_body * body_from_part;
        let color = |local: Vec3| color_towards(principal_from_part * local, colors);
        match kind {
            PartKind::Box => {
                let of = |sign: f32| Vec3::AXES.map(|axis| color(axis * sign));
                mesh::add_box(&mut mesh, centre, map, [of(1.0), of(-1.0)]);
            }
            PartKind::Cylinder => {
                let rim = [Vec2::new(0.0, -1.0), Vec2::new(1.0, -1.0), Vec2::new(1.0, 1.0), Vec2::new(0.0, 1.0)];
                mesh::add_lathe(&mut mesh, centre, map, &rim, false, ROUND, color);
            }
            PartKind::Ellipsoid => {
                let profile: Vec<Vec2> = (0..=RINGS)
                    .map(|i| Vec2::from_angle(std::f32::consts::PI * (i as f32 / RINGS as f32 - 0.5)))
                    .collect();
                let color = |local: Vec3| soft_color_towards(principal_from_part * local, colors);
                mesh::add_lathe(&mut mesh, centre, map, &profile, true, ROUND, color);
            }
        }
    }
    mesh
}

/// A triangle on each of the two largest faces of a single box, pointing along the middle axis: the eye sees it turn over.
fn add_marks(context: &Context<'_>, pose: Pose, mesh: &mut Mesh) {
    let principal_from_body = single_matrix(context.simulation.body().body_from_principal().transpose());
    let mut parts = parts_posed(context, pose);
    let (Some((centre, map, PartKind::Box, body_from_part)), None) = (parts.next(), parts.next()) else { return };
    let half = Vec3::new(map.x_axis.length(), map.y_axis.length(), map.z_axis.length());
    let thin = half.min_position();
    let principal_from_part = principal_from_body * body_from_part;
    let middle = principal_from_part.transpose().y_axis;
    let along = middle.abs().max_position();
    if along == thin {
        return;
    }
    let aside = 3 - along - thin;
    let reach = half[along].min(half[aside]);
    let direction = map.col(along) * (reach / half[along] * middle[along].signum());
    let across = map.col(aside) * (reach / half[aside]);
    for sign in [1.0, -1.0] {
        // Just off the face, so that it is not lost in it.
        let face = centre + map.col(thin) * (sign * (1.0 + 0.003 / half[thin]));
        let normal = (map.col(thin) * sign).normalize_or_zero();
        let base = mesh.vertices.len() as u32;
        let corners = [direction * 0.52, across * 0.45 - direction * 0.3, across * -0.45 - direction * 0.3];
        // Light on the dark face and dark on the light one: the two sides are told apart by it too.
        let color = color_towards(principal_from_part * Vec3::AXES[thin] * -sign, context.palette.faces);
        mesh.vertices.extend(corners.map(|corner| Vertex { position: face + corner, normal, color }));
        let outward = (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(normal) > 0.0;
        mesh.indices.extend(if outward { [base, base + 1, base + 2] } else { [base, base + 2, base + 1] });
    }
}

/// The edges of the boxes of the body in this state.
pub(super) fn edges(context: &Context<'_>, state: &State, pane: &mut Pane, color: Color, width: f32) {
    edges_posed(context, Pose::of(context, state), pane, color, width);
}

fn edges_posed(context: &Context<'_>, pose: Pose, pane: &mut Pane, color: Color, width: f32) {
    for (centre, map, kind, _) in parts_posed(context, pose) {
        if kind != PartKind::Box {
            continue;
        }
        for axis in 0..3 {
            let (along, u, v) = (Vec3::AXES[axis], Vec3::AXES[(axis + 1) % 3], Vec3::AXES[(axis + 2) % 3]);
            for side in [u + v, u - v, v - u, -u - v] {
                pane.lines.push(Line::new([side - along, side + along].map(|p| centre + map * p), width, color));
            }
        }
    }
}

/// Of each part: its centre, the map from its unit shape (half extents 1) to the picture, its kind, its orientation.
pub(super) fn placed_parts<'a>(
    context: &'a Context<'_>,
    state: &State,
) -> impl Iterator<Item = (Vec3, Mat3, PartKind, Mat3)> + use<'a> {
    parts_posed(context, Pose::of(context, state))
}

fn parts_posed<'a>(
    context: &'a Context<'_>,
    pose: Pose,
) -> impl Iterator<Item = (Vec3, Mat3, PartKind, Mat3)> + use<'a> {
    let Pose { picture_from_body, per_metre } = pose;
    context.scene.parts.iter().map(move |part| {
        let body_from_part = single_matrix(part.body_from_part);
        let half = single(part.size * (0.5 * per_metre));
        let map = picture_from_body * body_from_part * Mat3::from_diagonal(half);
        (picture_from_body * single(part.centre * per_metre), map, part.kind, body_from_part)
    })
}

/// The colour of a place on a round surface: as of a face that looks that way, the borders softened over a few corners of the
/// mesh, which does not follow them.
fn soft_color_towards(normal: Vec3, colors: [[Color; 3]; 2]) -> Color {
    let normal = normal.normalize_or_zero();
    let weights = Vec3::from_array(normal.to_array().map(|n| n.abs().powi(24)));
    let weights = weights / weights.element_sum().max(f32::MIN_POSITIVE);
    let of = |axis: usize| colors[usize::from(normal[axis] < 0.0)][axis];
    let first = of(0).mix(of(1), weights.y / (weights.x + weights.y).max(f32::MIN_POSITIVE));
    first.mix(of(2), weights.z)
}

/// The colour of a face by the principal axis that it looks along most.
fn color_towards(normal: Vec3, colors: [[Color; 3]; 2]) -> Color {
    let axis = normal.abs().max_position();
    colors[usize::from(normal[axis] < 0.0)][axis]
}
