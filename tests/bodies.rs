//! Bodies: boxes, tensors, principal axes, what is refused and what is let pass.
#![allow(clippy::expect_used, reason = "a test fails by it")]

mod common;

use common::{EPS, Random, assert_at_most, random_motion};
use dzhanibekov::physics::{Body, BodyError, State, so3};
use glam::{DMat3, DVec3};

/// `I = ∫ (r² 1 − r rᵀ) dm` by Simpson's rule in each direction, which is exact for squares.
#[test]
fn a_box_is_its_integral() {
    let mut random = Random::new(31);
    for _ in 0..200 {
        let edges = random.vector().abs() + 0.1;
        let mass = random.between(0.1, 10.0);
        let mut inertia = DMat3::ZERO;
        for (x, p) in [(-0.5, 1.0), (0.0, 4.0), (0.5, 1.0)] {
            for (y, q) in [(-0.5, 1.0), (0.0, 4.0), (0.5, 1.0)] {
                for (z, r) in [(-0.5, 1.0), (0.0, 4.0), (0.5, 1.0)] {
                    let at = edges * DVec3::new(x, y, z);
                    let hat = so3::hat(at);
                    inertia -= hat * hat * (mass * p * q * r / 216.0);
                }
            }
        }
        let body = Body::solid_box(edges, mass).expect("a box");
        let size = so3::frobenius_norm(inertia);
        assert_at_most(so3::frobenius_norm(body.inertia() - inertia) / size, 16.0 * EPS, "box");
        let sorted = body.principal_moments();
        assert!(sorted.x <= sorted.y && sorted.y <= sorted.z);
        assert_eq!(body.triangle_excess(), None);
        // And back: the box of these moments is this one, its edges sorted the other way round.
        let mut expected = edges.to_array();
        expected.sort_by(|a, b| b.total_cmp(a));
        assert_at_most((body.equivalent_box(mass) - DVec3::from_array(expected)).length(), 1e-13, "its edges");
    }
}

/// The tensor is rebuilt from its principal axes, and these are a rotation; at any scale.
#[test]
fn principal_axes() {
    let mut random = Random::new(32);
    for n in 0..20_000 {
        let (moments, _) = random_motion(&mut random);
        let scale = [1.0, 1e-150, 1e150][n % 3];
        let moments = moments.max(DVec3::splat(1e-6)) * scale;
        let tilt = random.rotation();
        let tensor = tilt * DMat3::from_diagonal(moments) * tilt.transpose();
        let tensor = 0.5 * (tensor + tensor.transpose());
        let body = Body::from_tensor(tensor).expect("a body");
        let axes = body.body_from_principal();
        assert_at_most(so3::orthogonality_error(axes), 16.0 * EPS, "axes");
        assert_at_most((axes.determinant() - 1.0).abs(), 16.0 * EPS, "right-handed");
        let rebuilt = axes * DMat3::from_diagonal(body.principal_moments()) * axes.transpose();
        let error = (rebuilt * (1.0 / scale) - tensor * (1.0 / scale)).to_cols_array();
        let error = error.iter().fold(0.0, |m: f64, e| m.max(e.abs()));
        assert_at_most(error, 16.0 * EPS * moments.z / scale, &format!("rebuilt {moments}"));
        assert_eq!(body.inertia(), tensor);
    }
}

/// Where the body's own axes are principal nothing is rounded, in whatever order they come.
#[test]
fn a_diagonal_tensor_is_exact() {
    for moments in [[1.0, 2.0, 3.0], [3.0, 1.0, 2.0], [0.3, 0.2, 0.1], [2.0, 2.0, 1.0]] {
        let moments = DVec3::from_array(moments);
        let body = Body::from_tensor(DMat3::from_diagonal(moments)).expect("a body");
        assert_eq!(body, Body::from_moments(moments).expect("a body"));
        let axes = body.body_from_principal();
        assert!(axes.to_cols_array().iter().all(|entry| [0.0, 1.0].contains(&entry.abs())));
        assert_eq!(axes * DMat3::from_diagonal(body.principal_moments()) * axes.transpose(), body.inertia());
        assert_eq!(axes.determinant(), 1.0);
    }
}

#[test]
fn every_refusal() {
    let edges = |x, y, z, mass| Body::solid_box(DVec3::new(x, y, z), mass);
    for wrong in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(edges(wrong, 1.0, 1.0, 1.0), Err(BodyError::Edge(wrong)));
        assert_eq!(edges(1.0, wrong, 1.0, 1.0), Err(BodyError::Edge(wrong)));
        assert_eq!(edges(1.0, 1.0, wrong, 1.0), Err(BodyError::Edge(wrong)));
        assert_eq!(edges(1.0, 1.0, 1.0, wrong), Err(BodyError::Mass(wrong)));
        assert_eq!(Body::from_moments(DVec3::new(1.0, wrong, 1.0)), Err(BodyError::Moment(wrong)));
    }
    assert!(matches!(edges(f64::NAN, 1.0, 1.0, 1.0), Err(BodyError::Edge(_))));
    assert!(matches!(edges(1.0, 1.0, 1.0, f64::NAN), Err(BodyError::Mass(_))));
    assert!(matches!(Body::from_moments(DVec3::splat(f64::NAN)), Err(BodyError::Moment(_))));
    // Moments beyond the range of f64.
    assert!(matches!(edges(1e200, 1e200, 1e200, 1.0), Err(BodyError::Moment(_))));
    assert!(matches!(edges(1e-200, 1e-200, 1e-200, 1.0), Err(BodyError::Moment(_))));
    // Squares beyond it are no matter.
    assert!(edges(1e160, 2e160, 3e160, 1e-200).is_ok());

    let tensor =
        |xx, yy, zz, xy, yx| Body::from_tensor(DMat3::from_cols_array(&[xx, yx, 0.0, xy, yy, 0.0, 0.0, 0.0, zz]));
    assert_eq!(tensor(1.0, f64::INFINITY, 1.0, 0.0, 0.0), Err(BodyError::NotFinite(f64::INFINITY)));
    assert!(matches!(tensor(1.0, 1.0, f64::NAN, 0.0, 0.0), Err(BodyError::NotFinite(_))));
    assert!(matches!(tensor(1.0, 2.0, 3.0, 0.1, 0.2), Err(BodyError::NotSymmetric(..))));
    assert!(matches!(tensor(1.0, 2.0, 3.0, 0.1, 0.1 + 1e-13), Err(BodyError::NotSymmetric(..))));
    assert!(tensor(1.0, 2.0, 3.0, 0.1, 0.1 + EPS).is_ok());
    for (tensor, smallest) in [
        (tensor(1.0, -2.0, 3.0, 0.0, 0.0), -2.0),
        (tensor(1.0, 0.0, 3.0, 0.0, 0.0), 0.0),
        (tensor(1.0, 1.0, 3.0, 1.0, 1.0), 0.0),
        (tensor(1.0, 1.0, 3.0, 2.0, 2.0), -1.0),
    ] {
        let Err(BodyError::NotPositiveDefinite(found)) = tensor else {
            assert!(tensor.is_err(), "{smallest} was let pass");
            continue;
        };
        assert_at_most((found - smallest).abs(), 8.0 * EPS, "its smallest moment");
    }
    let said = BodyError::Edge(-1.0).to_string();
    assert!(said.contains("-1") && said.contains("above 0"), "{said}");
}

#[test]
fn moments_no_solid_has() {
    let excess = |x, y, z| Body::from_moments(DVec3::new(x, y, z)).expect("a body").triangle_excess();
    assert_eq!(excess(1.0, 2.0, 6.0), Some(2.0));
    assert_eq!(excess(1.0, 2.0, 3.0), None);
    assert_eq!(excess(0.1, 0.2, 0.1 + 0.2), None);
}

/// `ω = RΩ`, `I_world = R I Rᵀ`, `L = I_world ω = RM`, and the energy in three ways.
#[test]
fn body_and_world() {
    let mut random = Random::new(33);
    for _ in 0..1_000 {
        let tilt = random.rotation();
        let tensor = tilt * DMat3::from_diagonal(DVec3::new(1.0, 2.0, 2.5)) * tilt.transpose();
        let body = Body::from_tensor(0.5 * (tensor + tensor.transpose())).expect("a body");
        let velocity = random.vector();
        let state = State::new(&body, random.rotation(), velocity);
        let bound = 64.0 * EPS;
        let world_velocity = state.world_angular_velocity(&body);
        assert_at_most((state.body_angular_velocity(&body) - velocity).length(), bound, "Ω");
        assert_at_most((world_velocity - state.world_from_body * velocity).length(), bound, "ω");
        let world_inertia = state.world_inertia(&body);
        assert_at_most((world_inertia * world_velocity - state.world_momentum).length(), bound, "L");
        assert_at_most((state.world_from_body * state.body_momentum - state.world_momentum).length(), bound, "RM");
        let energy = state.energy(&body);
        assert_at_most((energy - 0.5 * velocity.dot(body.inertia() * velocity)).abs(), bound, "body energy");
        assert_at_most(
            (energy - 0.5 * world_velocity.dot(world_inertia * world_velocity)).abs(),
            bound,
            "world energy",
        );
    }
}

/// Solids, most of what only looks like one, and what the bounds say nothing of.
#[test]
fn the_bounds_hold_for_solids_and_not_for_whatever_can_be_written_down() -> Result<(), BodyError> {
    for (moments, is_within) in [
        ([1.0, 2.0, 3.0], true),
        ([1e-50, 1.0, 1.0], true),
        ([1.0, 1.0, 3.16e5], true),
        ([1.0, 1.0, 3.17e5], false),
        ([1e-60, 1.0, 1.0], false),
        ([1e-300, 1.0, 1e300], false),
    ] {
        let body = Body::from_moments(DVec3::from(moments))?;
        assert_eq!(body.is_within_bounds(), is_within, "{moments:?}");
    }
    Ok(())
}
