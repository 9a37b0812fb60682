//! Changes of one thing about the start, which leave the others as they are.

use glam::DVec3;

use crate::physics::so3;
use crate::scene::{Scene, SpinFile};
use crate::ui::Spin;

/// The spin about another principal axis, its tilt and rate as they are.
pub(super) fn about(scene: &Scene, axis: u8) -> SpinFile {
    let spin = Spin::of(scene);
    on_axis(scene, Spin { axis, ..spin })
}

/// The spin tilted this far (degrees) from its axis. Where it is given by its components it stays on the side that it is
/// tilted to; exactly on the axis there is no side, and it is given by the axis.
pub(super) fn tilted(scene: &Scene, tilt_deg: f64) -> SpinFile {
    let spin = Spin { tilt_deg, ..Spin::of(scene) };
    let Some(principal) = given_components(scene) else { return on_axis(scene, spin) };
    let axis = DVec3::AXES[usize::from(spin.axis.clamp(1, 3)) - 1];
    let along = axis * axis.dot(principal).signum();
    let Some(side) = (principal - principal.dot(axis) * axis).try_normalize() else { return on_axis(scene, spin) };
    if tilt_deg == 0.0 {
        return on_axis(scene, Spin { rate: spin.rate.copysign(axis.dot(principal)), ..spin });
    }
    let (sine, cosine) = tilt_deg.to_radians().sin_cos();
    with_components(scene, (along * cosine + side * sine) * spin.rate)
}

/// The spin at this rate (rad/s) about the same line.
pub(super) fn at_rate(scene: &Scene, rate: f64) -> SpinFile {
    let Some(principal) = given_components(scene) else { return on_axis(scene, Spin { rate, ..Spin::of(scene) }) };
    let before = so3::norm(principal);
    if before == 0.0 {
        return on_axis(scene, Spin { rate, ..Spin::of(scene) });
    }
    with_components(scene, principal / before * rate)
}

/// The angular velocity (principal components, rad/s) of a start that is given by components and not by an axis.
fn given_components(scene: &Scene) -> Option<DVec3> {
    let omega = DVec3::from_array(scene.file.spin.omega?);
    Some(scene.body.body_from_principal().transpose() * omega)
}

fn with_components(scene: &Scene, principal: DVec3) -> SpinFile {
    let omega = scene.body.body_from_principal() * principal;
    SpinFile { omega: Some(omega.to_array()), attitude: scene.file.spin.attitude, ..SpinFile::default() }
}

fn on_axis(scene: &Scene, spin: Spin) -> SpinFile {
    SpinFile {
        axis: Some(spin.axis),
        tilt_deg: Some(spin.tilt_deg),
        rate: Some(spin.rate),
        attitude: scene.file.spin.attitude,
        omega: None,
    }
}
