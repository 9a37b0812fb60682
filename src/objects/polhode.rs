//! The path of M in the body: where the sphere and the ellipsoid meet.

use glam::{DVec3, Vec3};

use super::Context;
use crate::frame::{Line, View, single};

const POINTS: usize = 512;

pub(super) fn draw(context: &Context<'_>, view: &mut View) {
    if context.momentum_length() == 0.0 {
        return;
    }
    let body = context.simulation.body();
    let unit = context.simulation.state().body_momentum / context.momentum_length();
    let principal = body.body_from_principal().transpose() * unit;
    view.lines.push(Line::new(points(body.principal_moments(), principal), 4.0, context.palette.polhode).through(0.35));
}

/// The closed curve through a momentum, in principal components.
fn points(i: DVec3, m: DVec3) -> Vec<Vec3> {
    let twice_energy = m.dot(m / i);
    let squared = m.length_squared();
    // It circles the axis of the moment that its mean moment ℓ²/2K is nearer to.
    let around_third = squared > twice_energy * i.y;
    let (pole, one) = if around_third { (2, 0) } else { (0, 2) };
    let level = (twice_energy - squared / i[pole]).abs();
    let radius = |axis: usize| (level / (1.0 / i[axis] - 1.0 / i[pole]).abs()).sqrt();
    let (a, b) = (radius(one), radius(1));
    (0..=POINTS)
        .map(|n| {
            let (sin, cos) = (std::f64::consts::TAU * (n % POINTS) as f64 / POINTS as f64).sin_cos();
            let mut point = DVec3::ZERO;
            point[one] = a * cos;
            point[1] = b * sin;
            point[pole] = (squared - point.length_squared()).max(0.0).sqrt().copysign(m[pole]);
            single(point)
        })
        .collect()
}
