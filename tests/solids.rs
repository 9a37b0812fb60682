//! Bodies of several solids.
#![allow(clippy::expect_used, reason = "a test fails by it")]

mod common;

use std::f64::consts::{FRAC_PI_2, PI};

use common::{EPS, Random, assert_at_most};
use dzhanibekov::physics::{
    Body, so3,
    solids::{Shape, Solid, SolidError, assemble},
};
use glam::{DMat3, DVec3};

fn solid(shape: Shape) -> Solid {
    Solid { shape, density: 1.0, position: DVec3::ZERO, body_from_solid: DMat3::IDENTITY }
}

fn distance(a: DMat3, b: DMat3) -> f64 {
    so3::frobenius_norm(a - b) / so3::frobenius_norm(b)
}

/// The textbook's moments, and one piece of any kind is at its own centre wherever that is.
#[test]
fn one_solid() {
    let at = DVec3::new(0.3, -7.0, 1e3);
    let edges = DVec3::new(1.0, 2.0, 3.0);
    let cuboid = assemble(&[Solid { position: at, density: 2.0, ..solid(Shape::Box { edges }) }]).expect("a body");
    assert_eq!((cuboid.mass, cuboid.centre), (12.0, at));
    let expected = Body::solid_box(edges, 12.0).expect("a box");
    assert_at_most(distance(cuboid.body.inertia(), expected.inertia()), 8.0 * EPS, "box");
    assert_eq!(cuboid.body.body_from_principal(), expected.body_from_principal());

    let rod = assemble(&[solid(Shape::Cylinder { radius: 0.5, length: 4.0 })]).expect("a body");
    assert_at_most((rod.mass - PI).abs(), 4.0 * EPS, "π r² l");
    let across = PI * (3.0 * 0.25 + 16.0) / 12.0;
    let expected = DMat3::from_diagonal(DVec3::new(across, across, PI * 0.125));
    assert_at_most(distance(rod.body.inertia(), expected), 8.0 * EPS, "cylinder");

    let ball = assemble(&[solid(Shape::Ellipsoid { semi_axes: DVec3::splat(2.0) })]).expect("a body");
    let expected = DMat3::from_diagonal(DVec3::splat(0.4 * ball.mass * 4.0));
    assert_at_most(distance(ball.body.inertia(), expected), 8.0 * EPS, "2/5 m r²");
    assert_at_most((ball.mass / (32.0 / 3.0 * PI) - 1.0).abs(), 4.0 * EPS, "4/3 π r³");
}

/// Volume and mean squares of every shape, by counting the midpoints of a fine grid that lie inside.
#[test]
fn shapes_by_counting() {
    let inside = |shape: &Shape, r: DVec3| match *shape {
        Shape::Box { edges } => (2.0 * r.abs() - edges).max_element() <= 0.0,
        Shape::Cylinder { radius, length } => r.truncate().length() <= radius && 2.0 * r.z.abs() <= length,
        Shape::Ellipsoid { semi_axes } => (r / semi_axes).length() <= 1.0,
    };
    for shape in [
        Shape::Box { edges: DVec3::new(1.0, 1.5, 0.7) },
        Shape::Cylinder { radius: 0.6, length: 1.4 },
        Shape::Ellipsoid { semi_axes: DVec3::new(0.5, 0.9, 0.7) },
    ] {
        let cells = 120;
        let (mut volume, mut squares) = (0.0, DVec3::ZERO);
        let side = 2.0 / f64::from(cells);
        let middle = |n: i32| (f64::from(n) + 0.5) * side - 1.0;
        for x in 0..cells {
            for y in 0..cells {
                for z in 0..cells {
                    let r = DVec3::new(middle(x), middle(y), middle(z));
                    if inside(&shape, r) {
                        volume += side.powi(3);
                        squares += side.powi(3) * r * r;
                    }
                }
            }
        }
        // A grid of 1/60 errs by a few thousandths at the surface.
        assert_at_most((volume / shape.volume() - 1.0).abs(), 0.03, "volume");
        let error = (squares / volume / shape.mean_squares() - 1.0).abs().max_element();
        assert_at_most(error, 0.03, "mean squares");
    }
}

/// A box cut in two along a plane is the box: parallel-axis theorem, exact.
#[test]
fn a_box_of_two_halves() {
    let half =
        |x| Solid { position: DVec3::new(x, 0.0, 0.0), ..solid(Shape::Box { edges: DVec3::new(1.0, 3.0, 0.5) }) };
    let halves = assemble(&[half(2.0), half(3.0)]).expect("a body");
    let whole = Body::solid_box(DVec3::new(2.0, 3.0, 0.5), 3.0).expect("a box");
    assert_at_most(distance(halves.body.inertia(), whole.inertia()), 8.0 * EPS, "halves");
    assert_at_most((halves.centre - DVec3::new(2.5, 0.0, 0.0)).length(), 8.0 * EPS, "centre");
}

/// The whole moved and turned: the same moments, the axes and centre turned with it.
#[test]
fn frames_do_not_matter() {
    let mut random = Random::new(61);
    for _ in 0..500 {
        let parts: Vec<Solid> = (0..=random.below(4))
            .map(|_| {
                let size = random.vector().abs() + 0.1;
                let shape = match random.below(3) {
                    0 => Shape::Box { edges: size },
                    1 => Shape::Cylinder { radius: size.x, length: size.y },
                    _ => Shape::Ellipsoid { semi_axes: size },
                };
                Solid {
                    shape,
                    density: random.between(0.1, 3.0),
                    position: 2.0 * random.vector(),
                    body_from_solid: random.rotation(),
                }
            })
            .collect();
        let (turn, shift) = (random.rotation(), random.vector());
        let moved: Vec<Solid> = parts
            .iter()
            .map(|part| Solid {
                position: turn * part.position + shift,
                body_from_solid: turn * part.body_from_solid,
                ..*part
            })
            .collect();
        let (a, b) = (assemble(&parts).expect("a body"), assemble(&moved).expect("a body"));
        assert_eq!(a.mass, b.mass);
        assert_at_most((b.centre - (turn * a.centre + shift)).length(), 64.0 * EPS, "centre");
        let error = distance(b.body.inertia(), turn * a.body.inertia() * turn.transpose());
        assert_at_most(error, 64.0 * EPS, "inertia");
        assert_eq!(a.body.triangle_excess(), None);
    }
}

/// A T of two rods turns about its symmetry axis with the middle moment or not, as the lengths are: by hand.
#[test]
fn a_t_handle() {
    let rod = |length: f64, position, body_from_solid| Solid {
        shape: Shape::Cylinder { radius: 0.1, length },
        density: 100.0,
        position,
        body_from_solid,
    };
    let along_x = so3::exp(DVec3::new(0.0, FRAC_PI_2, 0.0));
    let bar = rod(2.0, DVec3::ZERO, along_x);
    let stem = rod(1.0, DVec3::new(0.0, 0.0, -0.6), DMat3::IDENTITY);
    let handle = assemble(&[bar, stem]).expect("a body");
    let (m1, m2) = (2.0 * PI, PI);
    assert_at_most((handle.mass - 3.0 * PI).abs(), 8.0 * EPS * handle.mass, "mass");
    assert_at_most((handle.centre - DVec3::new(0.0, 0.0, -0.2)).length(), 4.0 * EPS, "centre");
    let (thin, d1, d2) = (0.01, 0.2, 0.4);
    let shift = m1 * d1 * d1 + m2 * d2 * d2;
    let expected = DVec3::new(
        m1 * thin / 2.0 + m2 * (3.0 * thin + 1.0) / 12.0 + shift,
        m1 * (3.0 * thin + 4.0) / 12.0 + m2 * (3.0 * thin + 1.0) / 12.0 + shift,
        m1 * (3.0 * thin + 4.0) / 12.0 + m2 * thin / 2.0,
    );
    assert_at_most(distance(handle.body.inertia(), DMat3::from_diagonal(expected)), 16.0 * EPS, "inertia");
}

#[test]
fn every_refusal() {
    let good = solid(Shape::Box { edges: DVec3::ONE });
    assert_eq!(assemble(&[]), Err(SolidError::None));
    for wrong in [0.0, -1.0, f64::INFINITY] {
        let with = |shape| assemble(&[good, solid(shape)]);
        assert_eq!(with(Shape::Box { edges: DVec3::new(1.0, wrong, 1.0) }), Err(SolidError::Size(wrong)));
        assert_eq!(with(Shape::Cylinder { radius: wrong, length: 1.0 }), Err(SolidError::Size(wrong)));
        assert_eq!(with(Shape::Cylinder { radius: 1.0, length: wrong }), Err(SolidError::Size(wrong)));
        assert_eq!(with(Shape::Ellipsoid { semi_axes: DVec3::new(1.0, 1.0, wrong) }), Err(SolidError::Size(wrong)));
        assert_eq!(assemble(&[Solid { density: wrong, ..good }]), Err(SolidError::Density(wrong)));
    }
    let far = DVec3::new(0.0, f64::INFINITY, 0.0);
    assert_eq!(assemble(&[Solid { position: far, ..good }]), Err(SolidError::Position(f64::INFINITY)));
    for orientation in [DMat3::ZERO, DMat3::IDENTITY * 1.1, -DMat3::IDENTITY] {
        let turned = assemble(&[Solid { body_from_solid: orientation, ..good }]);
        assert!(matches!(turned, Err(SolidError::Orientation(_))), "{orientation}");
    }
    let tiny = solid(Shape::Box { edges: DVec3::splat(1e-120) });
    assert!(matches!(assemble(&[tiny]), Err(SolidError::Body(_))));
}
