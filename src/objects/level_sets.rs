//! The energy over the whole momentum sphere: the paths of the other motions with the same |M|, faint.

use glam::{DVec3, Vec3};

use super::Context;
use super::curve::simplified;
use crate::frame::{Line, Pane};
use crate::physics::{Body, poinsot};

/// Paths round each stable pole.
pub(super) const PATHS: u32 = 2;
const POINTS: usize = 120;
/// Less than a pixel in a picture 2160 pixels high: these lines are faint, and each point is paid for where there is no GPU.
const TOLERANCE: f32 = 1e-3;

pub(super) fn draw(context: &Context<'_>, pane: &mut Pane) {
    let body = context.simulation.body();
    if context.unit_momentum().is_none() {
        return;
    }
    let color = context.palette.ink.alpha(0.3);
    for momentum in momenta(body, PATHS) {
        let curve = poinsot::polhode(body, body.body_from_principal() * momentum, POINTS);
        let points: Vec<Vec3> = curve.into_iter().map(|m| context.principal(m)).collect();
        let points = simplified(&points, TOLERANCE);
        // The same path round the other end of the axis.
        for sign in [1.0, -1.0] {
            pane.lines.push(Line::new(points.iter().map(|point| point * sign), 1.3, color).through(0.3));
        }
    }
}

/// A momentum of each of so many paths round axis 3 and round axis 1 in turn, in principal components: evenly in angle between the
/// poles and the separatrix.
pub(super) fn momenta(body: &Body, paths: u32) -> impl Iterator<Item = DVec3> {
    let i = body.principal_moments();
    // The separatrix's angle from axis 3: tan² = κ² = I₁(I₃−I₂)/(I₃(I₂−I₁)).
    let slope = (i.x / i.z * (i.z - i.y)).sqrt().atan2((i.y - i.x).sqrt());
    let quarter = std::f64::consts::FRAC_PI_2;
    (1..=paths).flat_map(move |n| {
        let part = f64::from(n) / f64::from(paths + 1);
        [slope * part, quarter - (quarter - slope) * part].map(|angle| DVec3::new(angle.sin(), 0.0, angle.cos()))
    })
}
