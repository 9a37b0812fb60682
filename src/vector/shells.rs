//! Translucent ellipsoids as their outlines, filled by what their walls show from the middle to the rim.
//!
//! Seen from o (in the space where the ellipsoid is the unit sphere) the ray d meets it where (o·d)² > (|o|² − 1) |d|². With d linear
//! in the pixel (x, y, 1) that is a quadratic form: its zeros are the outline, an ellipse wherever all of it is before the eye.

use std::f64::consts::TAU;

use glam::{DMat2, DMat3, DMat4, DVec2, DVec3, Vec3};

use super::drawing::{Paint, Path, Shape};
use super::lines::Projection;
use crate::frame::{Color, Pane, Quadric, QuadricPair};
use crate::render::light::{INNER_SIDE, Light, SLANTED, WALL_GLOSS};

/// Distances from the middle at which the walls are looked at (1: the rim), and the directions that are averaged over.
const DISTANCES: [f64; 12] = [0.0, 0.2, 0.35, 0.5, 0.62, 0.72, 0.8, 0.87, 0.92, 0.96, 0.985, 1.0];
const DIRECTIONS: usize = 24;

/// Which walls are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wall {
    /// Those away from the eye, of hollow ones.
    Far,
    /// Those towards the eye, of hollow ones; of the others all.
    Near,
}

/// Adds the walls of a pane's ellipsoids.
pub(super) fn draw(pane: &Pane, projection: &Projection, wall: Wall, shapes: &mut Vec<Shape>) {
    for pair in pane.quadrics.iter().filter(|pair| pair.hollow || wall == Wall::Near) {
        for quadric in [Some(pair.first), pair.second].into_iter().flatten() {
            shapes.extend(shell(&quadric, pair, pane, projection, wall));
        }
    }
}

/// The ray through a pixel as a matrix that takes (x, y, 1) to it, seen from the eye.
fn rays(pane: &Pane, projection: &Projection) -> DMat3 {
    let inverse = projection.clip.inverse();
    let eye = pane.camera.eye().as_dvec3();
    let through = |pixel: DVec2| {
        let ndc = ((pixel - projection.corner) / projection.pixels - 0.5) * DVec2::new(2.0, -2.0);
        inverse.project_point3(ndc.extend(1.0)) - eye
    };
    let first = through(DVec2::ZERO);
    // Over a thousand pixels: the near plane is flat, so the ray is linear in the pixel.
    let step = |way: DVec2| (through(way * 1000.0) - first) / 1000.0;
    DMat3::from_cols(step(DVec2::X), step(DVec2::Y), first)
}

fn shell(quadric: &Quadric, pair: &QuadricPair, pane: &Pane, projection: &Projection, wall: Wall) -> Option<Shape> {
    let rays = rays(pane, projection);
    let unit_from_world = quadric.unit_from_world.as_dmat4();
    let eye = unit_from_world.transform_point3(pane.camera.eye().as_dvec3());
    let axes = outline(unit_from_world, eye, rays)?;
    let light = Light::of(&pane.camera);
    let mut stops = vec![];
    for distance in DISTANCES {
        let mut sum = [0.0; 4];
        for number in 0..DIRECTIONS {
            let flat = DVec2::from_angle(TAU * number as f64 / DIRECTIONS as f64) * distance;
            let pixel = axes[2] + axes[0] * flat.x + axes[1] * flat.y;
            let ray = rays * pixel.extend(1.0);
            let near = (!pair.hollow || wall == Wall::Near).then(|| seen(quadric, eye, ray, true, &light));
            let far = (!pair.hollow || wall == Wall::Far).then(|| seen(quadric, eye, ray, false, &light));
            let [near, far] = [near, far].map(Option::unwrap_or_default);
            for (channel, value) in sum.iter_mut().enumerate() {
                *value += (near[channel] + (1.0 - near[3]) * far[channel]) / DIRECTIONS as f32;
            }
        }
        let [r, g, b, alpha] = sum;
        let straight = [r, g, b].map(|channel| (channel / alpha.max(1e-6)).clamp(0.0, 1.0));
        stops.push((distance, Color([straight[0], straight[1], straight[2], alpha])));
    }
    Some(Shape::Fill { path: Path::ellipse(axes), even_odd: false, paint: Paint::Around { axes, stops } })
}

/// The outline of an ellipsoid on the screen: its half axes and its middle (pixels). None where the eye is inside, or it reaches
/// behind the eye.
fn outline(unit_from_world: DMat4, eye: DVec3, rays: DMat3) -> Option<[DVec2; 3]> {
    let c = eye.length_squared() - 1.0;
    if c <= 0.0 {
        return None;
    }
    // d = D (x, y, 1), and the form (Dᵀo)(Dᵀo)ᵀ − c DᵀD.
    let d = DMat3::from_mat4(unit_from_world) * rays;
    let w = d.transpose() * eye;
    let squares = d.transpose() * d;
    let form = DMat3::from_cols(w * w.x, w * w.y, w * w.z) - squares * c;
    let block = -DMat2::from_cols(form.x_axis.truncate(), form.y_axis.truncate());
    let linear = form.z_axis.truncate();
    if block.determinant() <= 0.0 || block.x_axis.x <= 0.0 {
        return None;
    }
    let middle = block.inverse() * linear;
    let height = form.z_axis.z + linear.dot(middle);
    // Half axes along the eigenvectors of the block, √(height/λ) long.
    let (a, b, e) = (block.x_axis.x, block.x_axis.y, block.y_axis.y);
    let angle = 0.5 * (2.0 * b).atan2(a - e);
    let direction = DVec2::from_angle(angle);
    let half = |direction: DVec2| direction * (height / direction.dot(block * direction)).max(0.0).sqrt();
    Some([half(direction), half(direction.perp()), middle])
}

/// What one wall shows along a ray: premultiplied.
fn seen(quadric: &Quadric, eye: DVec3, ray: DVec3, is_outer: bool, light: &Light) -> [f32; 4] {
    let unit_from_world = quadric.unit_from_world.as_dmat4();
    let d = unit_from_world.transform_vector3(ray);
    let squared = d.length_squared();
    let middle = -eye.dot(d) / squared;
    let miss = (eye + d * middle).length_squared();
    let half = ((1.0 - miss).max(0.0) / squared).sqrt();
    let unit = eye + d * if is_outer { middle - half } else { middle + half };
    let outward = unit_from_world.transpose().transform_vector3(unit).normalize().as_vec3();
    let to_eye = -ray.normalize().as_vec3();
    let facing = outward.dot(to_eye).abs();
    let [r, g, b, alpha] = quadric.color.0;
    let opacity = alpha / (alpha + (1.0 - alpha) * facing.max(SLANTED));
    let (normal, gloss, shade) = if is_outer { (outward, WALL_GLOSS, 1.0) } else { (-outward, 0.0, INNER_SIDE) };
    let color = light.lit(Vec3::new(r, g, b), normal, to_eye, gloss) * (shade * opacity);
    [color.x, color.y, color.z, opacity]
}
