//! The sphere of constant |M| and the ellipsoid of constant energy. They cut each other along the polhode, and
//! neither encloses the other.

use glam::{DVec3, Mat3, Vec3};

use super::Context;
use crate::frame::{Quadric, QuadricPair, View, single};

/// |M| = ℓ: the unit sphere of the picture.
pub(super) fn sphere(context: &Context<'_>, view: &mut View) {
    if context.momentum_length() > 0.0 {
        add(view, Quadric::ellipsoid(Vec3::ZERO, Mat3::IDENTITY, Vec3::ONE, context.palette.sphere));
    }
}

/// ½ Σ Mᵢ²/Iᵢ = K: semi-axes √(2K Iᵢ).
pub(super) fn ellipsoid(context: &Context<'_>, view: &mut View) {
    if context.momentum_length() > 0.0 {
        let semi_axes = single(semi_axes(context));
        add(view, Quadric::ellipsoid(Vec3::ZERO, Mat3::IDENTITY, semi_axes, context.palette.ellipsoid));
    }
}

/// Semi-axes of the energy ellipsoid of the state now, in units of ℓ.
pub(super) fn semi_axes(context: &Context<'_>) -> DVec3 {
    let body = context.simulation.body();
    let unit = context.simulation.state().body_momentum / context.momentum_length();
    let twice_energy = 2.0 * body.energy(unit);
    (body.principal_moments() * twice_energy).map(f64::sqrt)
}

fn add(view: &mut View, quadric: Quadric) {
    match view.quadrics.last_mut() {
        Some(pair) if pair.second.is_none() && !pair.hollow => pair.second = Some(quadric),
        _ => view.quadrics.push(QuadricPair { first: quadric, second: None, hollow: false }),
    }
}
