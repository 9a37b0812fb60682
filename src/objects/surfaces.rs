//! The sphere of constant |M| and the ellipsoid of constant energy. They cut each other along the polhode, and
//! neither encloses the other.

use glam::{DVec3, Mat3, Vec2, Vec3};

use super::{Context, labels};
use crate::frame::{Color, Label, Pane, Quadric, single};
use crate::physics::{Body, poinsot, so3};

/// Directions of the picture among which the labels choose.
const DIRECTIONS: u32 = 24;
/// How far a name's colour is moved from its surface's towards the ink, to be read on the background.
const READABLE: f32 = 0.3;

/// |M| = ℓ: the unit sphere of the picture.
pub(super) fn sphere(context: &Context<'_>, pane: &mut Pane) {
    if context.unit_momentum().is_none() {
        return;
    }
    let color = context.palette.sphere;
    pane.add_cutting(Quadric::ellipsoid(Vec3::ZERO, Mat3::IDENTITY, Vec3::ONE, color));
    if context.shows(&super::HEIGHTS) {
        // A map, with names enough at its rim.
        return;
    }
    // Its name stands where it is farthest outside the ellipsoid.
    let semi_axes = single(semi_axes(context));
    label(context, pane, "same length |L|", color, |direction| {
        (-support(semi_axes, direction).dot(direction), direction)
    });
}

/// ½ Σ Mᵢ²/Iᵢ = K: semi-axes √(2K Iᵢ).
pub(super) fn ellipsoid(context: &Context<'_>, pane: &mut Pane) {
    if context.unit_momentum().is_none() {
        return;
    }
    let color = context.palette.ellipsoid;
    let semi_axes = single(semi_axes(context));
    pane.add_cutting(Quadric::ellipsoid(Vec3::ZERO, Mat3::IDENTITY, semi_axes, color));
    let name = if context.simulation.energy_loss() > 0.0 { "energy K now" } else { "same energy K" };
    label(context, pane, name, color, |direction| {
        let point = support(semi_axes, direction);
        (point.dot(direction), point)
    });
}

/// Semi-axes of the energy ellipsoid of the state now, in units of ℓ.
pub(super) fn semi_axes(context: &Context<'_>) -> DVec3 {
    let body = context.simulation.body();
    let unit = context.unit_momentum().unwrap_or_default();
    poinsot::energy_semi_axes(body, body.energy(unit))
}

/// The point of an ellipsoid farthest in a direction: S²d/|Sd|.
fn support(semi_axes: Vec3, direction: Vec3) -> Vec3 {
    let scaled = semi_axes * direction;
    semi_axes * scaled / scaled.length().max(1e-12)
}

/// Factor on the camera's distance that makes room for an ellipsoid that stands out of the sphere, as far as that leaves the
/// sphere large enough.
pub(super) fn room(context: &Context<'_>) -> f32 {
    let scene = context.scene;
    let ell = so3::norm(scene.start.body_momentum);
    let longest = if ell > 0.0 { energy_reach(&scene.body, scene.start.body_momentum / ell) } else { 1.0 };
    (longest / 1.3).clamp(1.0, 1.7)
}

/// The longest semi-axis of the energy ellipsoid through a momentum.
fn energy_reach(body: &Body, momentum: DVec3) -> f32 {
    single(poinsot::energy_semi_axes(body, body.energy(momentum))).max_element()
}

/// Writes a name at the outline, in the direction that is fittest.
fn label(context: &Context<'_>, pane: &mut Pane, text: &str, color: Color, place: impl Fn(Vec3) -> (f32, Vec3)) {
    let (right, up, _) = pane.camera.axes();
    let best = (0..DIRECTIONS)
        .map(|n| Vec2::from_angle(std::f32::consts::TAU * n as f32 / DIRECTIONS as f32))
        .map(|flat| (flat, place(right * flat.x + up * flat.y)))
        .max_by(|a, b| a.1.0.total_cmp(&b.1.0));
    if let Some((toward, (_, anchor))) = best {
        let color = color.alpha(1.0).mix(context.palette.ink, READABLE);
        pane.labels.push(Label::new(anchor, toward, text, color, labels::SURFACE));
    }
}
