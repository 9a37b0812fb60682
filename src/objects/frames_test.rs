//! Whole frames: every scene with everything that can be drawn, and where things stand in the picture.

use glam::{Vec2, Vec3};

use super::{Cameras, OBJECTS, build_frame, check, word_of};
use crate::frame::{Dash, Frame, Pane};
use crate::scene::{Layout, Scene, SceneError, SceneFile, Theme, preset, presets};
use crate::sim::Simulation;

/// The frame of a scene at a time (s).
fn frame_of(scene: &Scene, time: f64, aspect: f32) -> Frame {
    let mut simulation = Simulation::new(scene);
    simulation.go_to(time);
    build_frame(scene, &simulation, &Cameras::new(&scene.view), aspect)
}

/// Every place in a pane at which something is drawn.
fn places(pane: &Pane) -> impl Iterator<Item = Vec3> + '_ {
    let vertices = pane.meshes.iter().flat_map(|mesh| mesh.vertices.iter().map(|vertex| vertex.position));
    let on_lines = pane.lines.iter().flat_map(|line| line.points.iter().map(|point| point.position));
    let marks = pane.markers.iter().map(|marker| marker.position);
    let marks = marks.chain(pane.dots.iter().map(|dot| dot.position));
    vertices.chain(on_lines).chain(marks).chain(pane.labels.iter().map(|label| label.anchor))
}

/// Where a place is seen: 0 in the middle of the pane, 1 at its right and upper rims.
fn seen(pane: &Pane, at: Vec3, aspect: f32) -> Vec2 {
    let clip = pane.camera.clip_from_world(aspect) * at.extend(1.0);
    Vec2::new(clip.x, clip.y) / clip.w
}

#[test]
fn everything_is_drawn_of_every_scene_and_stays_finite() -> Result<(), SceneError> {
    for preset in presets() {
        let mut file = preset.read()?;
        file.view.layout = Some(Layout::Both);
        file.view.hide.clear();
        file.view.show = OBJECTS.iter().map(|object| object.name.to_owned()).collect();
        for theme in [Theme::Dark, Theme::Light] {
            file.view.theme = Some(theme);
            let frame = frame_of(&check(&file)?, 0.5, 16.0 / 9.0);
            assert_eq!(frame.panes.len(), 2, "{}", preset.name);
            for pane in &frame.panes {
                let is_filled = !pane.meshes.is_empty() && !pane.lines.is_empty() && !pane.labels.is_empty();
                assert!(is_filled && !pane.quadrics.is_empty() && !pane.notes.is_empty(), "{}", preset.name);
                assert!(places(pane).all(Vec3::is_finite), "{} has a place that is none", preset.name);
                assert!(pane.quadrics.iter().all(|pair| pair.first.unit_from_world.is_finite()), "{}", preset.name);
            }
        }
    }
    Ok(())
}

/// Names of the picture that are no words of the field.
const PLAIN: [&str; 4] = ["spins this way round, always", "top", "bottom", "after T"];

#[test]
fn every_name_in_the_picture_is_said_in_a_sentence() -> Result<(), SceneError> {
    for preset in presets() {
        let mut file = preset.read()?;
        file.view.layout = Some(Layout::Both);
        file.view.hide.clear();
        // Without the moments the axes have their numbers alone.
        for left_out in ["moments", "axis-names", "body-axes"] {
            let shown = OBJECTS.iter().map(|object| object.name.to_owned()).filter(|name| name != left_out);
            file.view.show = shown.collect();
            file.view.hide = vec![left_out.to_owned()];
            let frame = frame_of(&check(&file)?, 0.5, 16.0 / 9.0);
            for label in frame.panes.iter().flat_map(|pane| &pane.labels) {
                let is_said = word_of(&label.text).is_some() || PLAIN.contains(&label.text.as_str());
                assert!(is_said, "{}: nothing says what “{}” is", preset.name, label.text);
            }
        }
    }
    Ok(())
}

#[test]
fn the_ring_of_the_floor_is_whole_in_a_pane_of_any_shape() -> Result<(), SceneError> {
    let mut file = SceneFile::default();
    file.view.layout = Some(Layout::World);
    file.view.hide = OBJECTS.iter().map(|object| object.name.to_owned()).filter(|name| name != "plane").collect();
    let scene = check(&file)?;
    for aspect in [0.5, 0.89, 1.0, 1.78] {
        let frame = frame_of(&scene, 0.0, aspect);
        let pane = &frame.panes[0];
        assert!(places(pane).count() > 100);
        for at in places(pane) {
            // A hundredth of the pane stays free.
            assert!(seen(pane, at, aspect).abs().max_element() < 0.98, "{at} in {aspect}");
        }
    }
    Ok(())
}

#[test]
fn the_bodies_stand_under_the_legend() -> Result<(), SceneError> {
    let file = preset("methods")?.read()?;
    let scene = check(&file)?;
    let frame = frame_of(&scene, 0.0, 16.0 / 9.0);
    let pane = &frame.panes[0];
    let ghosts = scene.compare.len();
    assert!(ghosts >= 4 && pane.notes.len() == ghosts + 2);
    // In a picture 720 points high: the caption, then two methods a row.
    let rows = (ghosts + 1).div_ceil(2) as f32;
    let bottom = 9.0 + 1.35 * (20.0 + 17.0 * rows);
    let highest = pane.meshes.iter().filter(|mesh| mesh.opaque).flat_map(|mesh| &mesh.vertices);
    let highest = highest.map(|vertex| seen(pane, vertex.position, 8.0 / 9.0).y).fold(-1.0, f32::max);
    assert!(highest < 1.0 - 2.0 * bottom / 720.0, "{highest} under {bottom}");
    Ok(())
}

/// Lines below the caption make room for themselves: each moves the top of L down by some thirtieth of the picture's height.
#[test]
fn the_world_stands_under_what_is_written() -> Result<(), SceneError> {
    for (name, rows, lines) in [("turn", "turn", 2.0), ("flat-spin", "", 1.0)] {
        let highest = |file: &SceneFile| -> Result<f32, SceneError> {
            let frame = frame_of(&check(file)?, 0.0, 16.0 / 9.0);
            let pane = &frame.panes[0];
            let places = pane.meshes.iter().filter(|mesh| mesh.opaque).flat_map(|mesh| &mesh.vertices);
            Ok(places.map(|vertex| seen(pane, vertex.position, 8.0 / 9.0).y).fold(-1.0, f32::max))
        };
        let file = preset(name)?.read()?;
        let mut without = file.clone();
        without.view.show.retain(|object| object != rows);
        without.motion.energy_loss = None;
        let moved = 0.5 * (highest(&without)? - highest(&file)?);
        assert!((0.03 * lines..0.1 * lines).contains(&moved), "{name}: {moved}");
    }
    Ok(())
}

#[test]
fn on_the_momentum_sphere_the_arrow_of_the_momentum_ends() -> Result<(), SceneError> {
    let mut file = preset("momentum-sphere")?.read()?;
    let label_of = |file: &SceneFile| {
        let frame = frame_of(&check(file)?, 1.7, 16.0 / 9.0);
        let labels = frame.panes.iter().flat_map(|pane| &pane.labels);
        Ok::<_, SceneError>(
            labels.filter(|label| label.text == "L").map(|label| label.anchor).next().unwrap_or_default(),
        )
    };
    // f32 carries 24 bits; a few roundings of a vector of length 1.
    assert!((label_of(&file)?.length() - 1.0).abs() < 1e-6);
    file.view.show.retain(|name| name != "rolling-sphere");
    assert!(label_of(&file)?.length() > 1.3);
    Ok(())
}

#[test]
fn the_ellipsoid_touches_the_plane_opposite_the_tip_of_the_angular_velocity() -> Result<(), SceneError> {
    let scene = check(&preset("rolling")?.read()?)?;
    for time in [0.0, 1.3, 2.0] {
        let frame = frame_of(&scene, time, 16.0 / 9.0);
        let pane = &frame.panes[0];
        let contact = pane.markers.iter().find(|marker| marker.moves).map(|marker| marker.position).unwrap_or_default();
        let tip = pane.labels.iter().find(|label| label.text == "ω").map(|label| label.anchor).unwrap_or_default();
        assert!((contact + tip).length() < 1e-6, "{contact} {tip}");
        // It lies on the ellipsoid, and the ellipsoid's normal there is that of the plane.
        let pair = pane.quadrics[0];
        let unit = pair.first.unit_from_world.transform_point3(contact);
        assert!((unit.length() - 1.0).abs() < 1e-5, "{unit}");
        let normal = (pair.first.unit_from_world.transpose() * unit.extend(0.0)).truncate().normalize();
        assert!(normal.z < -1.0 + 1e-6, "{normal}");
    }
    Ok(())
}

/// A ghost that lies on the body is not drawn over it, one that has left it is; its edges are there all along.
#[test]
fn ghosts_are_drawn_where_they_differ_from_the_body() -> Result<(), SceneError> {
    let mut file = preset("flip")?.read()?;
    file.motion.compare = vec!["rk4".to_owned(), "lie-euler".to_owned()];
    let scene = check(&file)?;
    let ghosts = |time: f64| {
        let pane = &frame_of(&scene, time, 16.0 / 9.0).panes[0];
        let boxes = pane.meshes.iter().filter(|mesh| !mesh.opaque && mesh.vertices.len() == 24).count();
        (boxes, pane.lines.iter().filter(|line| line.dash != Dash::Solid).count())
    };
    // Runge–Kutta keeps to it for long, Lie–Euler not beyond the first flip.
    assert_eq!(ghosts(0.0), (0, 24));
    assert_eq!(ghosts(4.0), (1, 24));
    Ok(())
}

#[test]
fn a_cloud_is_dots_of_the_sphere_and_a_few_bodies_and_says_where_it_knows_nothing() -> Result<(), SceneError> {
    let mut file = preset("cloud")?.read()?;
    let frame = frame_of(&check(&file)?, 3.0, 16.0 / 9.0);
    let dots = &frame.panes[1].dots;
    let count = check(&file)?.cloud.count;
    // Few lie so close that one hides another.
    assert!(dots.len() <= count && dots.len() > count / 2, "{} of {count}", dots.len());
    assert!(dots.iter().all(|dot| (dot.position.length() - 1.0).abs() < 1e-5));
    assert_eq!(frame.panes[0].meshes.iter().filter(|mesh| !mesh.opaque && mesh.vertices.len() == 24).count(), 6);
    file.motion.energy_loss = Some(0.1);
    let frame = frame_of(&check(&file)?, 3.0, 16.0 / 9.0);
    assert!(frame.panes[1].dots.is_empty());
    assert!(frame.panes[1].notes.iter().any(|note| note.text == "the cloud of starts knows no energy loss"));
    Ok(())
}

/// The frame of a scene in which nothing but these is drawn.
fn alone(name: &str, shown: &[&str], time: f64) -> Result<Frame, SceneError> {
    let mut file = preset(name)?.read()?;
    file.view.show = shown.iter().map(|name| (*name).to_owned()).collect();
    file.view.hide =
        OBJECTS.iter().map(|object| object.name).filter(|name| !shown.contains(name)).map(str::to_owned).collect();
    Ok(frame_of(&check(&file)?, time, 16.0 / 9.0))
}

/// Every arrowhead points along the rate of M there, and goes that way as fast as M would.
#[test]
fn the_flow_is_that_of_the_motion() -> Result<(), SceneError> {
    for name in ["flip", "symmetric-top", "t-handle"] {
        let scene = check(&preset(name)?.read()?)?;
        let body = &scene.body;
        let ell = crate::physics::so3::norm(scene.start.body_momentum);
        let heads = |time: f64| -> Result<Vec<[Vec3; 3]>, SceneError> {
            let frame = alone(name, &["flow"], time)?;
            let points = |line: &crate::frame::Line| [0, 1, 2].map(|n| line.points[n].position);
            Ok(frame.panes[1].lines.iter().map(points).collect())
        };
        let (now, later) = (heads(0.700)?, heads(0.701)?);
        assert!(now.len() >= 40 && now.len() == later.len(), "{name}: {} and {}", now.len(), later.len());
        let mut slow = 0;
        for (now, later) in now.iter().zip(&later) {
            let [place, then] = [now, later].map(|[one, tip, other]| at(*one, *tip, *other));
            let momentum = body.body_from_principal() * (0.5 * (place + then)).as_dvec3().normalize() * ell;
            let rate = crate::physics::motion::momentum_rate(body, momentum) / ell;
            let rate = (body.body_from_principal().transpose() * rate).as_vec3();
            let along = now[1] - 0.5 * (now[0] + now[2]);
            // An arrowhead spans 0.06 rad, over which the rate turns by some such angle; beside an axis, where it is small, by any.
            let is_slow = rate.length() < 0.5;
            slow += usize::from(is_slow);
            assert!(is_slow || along.normalize().dot(rate.normalize_or_zero()) > 0.9, "{name}: {along} {rate}");
            let moved = (then - place) / 0.001;
            // In so short a time the rate itself turns by some thousandths, and f32 is good to 1e-4 of it.
            assert!((moved - rate).length() < 0.02 * rate.length() + 0.01, "{name}: {moved} {rate}");
        }
        assert!(slow < now.len() / 2, "{name}: {slow} of {}", now.len());
    }
    Ok(())
}

/// The two lines on the floor are Δψ apart, and the body's mark is at the second when M has come round.
#[test]
fn on_the_floor_stands_how_far_the_body_has_turned() -> Result<(), SceneError> {
    for name in ["turn", "axis-1", "flip"] {
        let scene = check(&preset(name)?.read()?)?;
        let period = crate::physics::period::period_of(&scene.body, &scene.start).ok_or(SceneError::TooFast(0.0))?;
        let lines = |time: f64| -> Result<[Vec2; 2], SceneError> {
            let frame = alone(name, &["turn"], time)?;
            let of = |n: usize| {
                let line = &frame.panes[0].lines[n];
                (line.points[1].position - line.points[0].position).truncate().normalize()
            };
            Ok([of(0), of(1)])
        };
        let [first, second] = lines(0.0)?;
        let turned = Vec2::from_angle((period.turn % std::f64::consts::TAU) as f32).rotate(first);
        assert!(turned.distance(second) < 1e-4, "{name}: {turned} {second}");
        // They do not move.
        let later = lines(0.4 * period.time)?;
        assert!(later[0].distance(first) < 1e-4 && later[1].distance(second) < 1e-4, "{name}");
    }
    Ok(())
}

/// The shaded part of the sphere has the area that is written beside it.
#[test]
fn the_shaded_part_of_the_sphere_is_the_solid_angle() -> Result<(), SceneError> {
    for name in ["turn", "axis-1", "axis-3", "flip"] {
        let scene = check(&preset(name)?.read()?)?;
        let period = crate::physics::period::period_of(&scene.body, &scene.start).ok_or(SceneError::TooFast(0.0))?;
        let frame = alone(name, &["solid-angle"], 0.3)?;
        let mesh = &frame.panes[1].meshes[0];
        let at = |n: u32| mesh.vertices[n as usize].position;
        let areas = mesh.indices.chunks_exact(3).map(|corners| {
            let [a, b, c] = [at(corners[0]), at(corners[1]), at(corners[2])];
            let across = (b - a).cross(c - a);
            // Seen from outside they are counter-clockwise.
            assert!(across.dot(a + b + c) > -1e-6, "{name}");
            0.5 * across.length()
        });
        let area: f32 = areas.sum();
        // Flat triangles of a rim of 145 points and 12 rings leave out a part of (2π/145)²/6 and (π/24)²/6 or so.
        assert!((f64::from(area) / period.solid_angle.abs() - 1.0).abs() < 0.005, "{name}: {area} {period:?}");
    }
    Ok(())
}

/// The place on the sphere of an arrowhead with these corners, which is nearer to its foot than to its tip.
fn at(one: Vec3, tip: Vec3, other: Vec3) -> Vec3 {
    (0.5 * (one + other)).lerp(tip, 0.031 / 0.071).normalize()
}

/// The place of an arrowhead, and the way that it points.
fn place_and_way(line: &crate::frame::Line) -> (Vec3, Vec3) {
    let [one, tip, other] = [0, 1, 2].map(|n| line.points[n].position);
    (at(one, tip, other), (tip - 0.5 * (one + other)).normalize())
}

/// At an end of axis 2 arrowheads come in along one line and go out along another, and fade before they cover the end.
#[test]
fn arrowheads_show_the_saddles() -> Result<(), SceneError> {
    for time in [0.0, 0.35, 0.8] {
        let frame = alone("flip", &["flow"], time)?;
        for end in [Vec3::Y, Vec3::NEG_Y] {
            let mut ways = [[0; 2]; 4];
            for line in &frame.panes[1].lines {
                let (place, way) = place_and_way(line);
                let aside = 1.0 - place.dot(end);
                assert!(line.points[0].color.0[3] == 0.0 || aside > 0.012, "{place}");
                if aside < 0.3 {
                    let quarter = 2 * usize::from(place.x > 0.0) + usize::from(place.z > 0.0);
                    ways[quarter][usize::from(way.dot(end) > 0.0)] += 1;
                }
            }
            // The separatrix goes through all four quarters: out of two of them, and into the other two.
            let [low, right, left, high] = ways;
            for (one, opposite) in [(low, high), (right, left)] {
                assert!(one[0] > 0 && opposite[0] > 0 || one[1] > 0 && opposite[1] > 0, "{ways:?}");
            }
            assert!((low[0] > low[1]) != (right[0] > right[1]) && (low[0] > low[1]) == (high[0] > high[1]), "{ways:?}");
        }
    }
    Ok(())
}

/// Where two moments are equal, M stands still on the circle between: no arrowhead is there.
#[test]
fn no_arrowhead_is_where_m_stands_still() -> Result<(), SceneError> {
    let frame = alone("symmetric-top", &["flow"], 0.7)?;
    let lowest = frame.panes[1].lines.iter().map(|line| place_and_way(line).0.z.abs()).fold(1.0, f32::min);
    assert!(lowest > 0.3, "{lowest}");
    Ok(())
}

/// Where rings are shown, arrowheads run along them; and round a small ring they are small.
#[test]
fn arrowheads_are_on_the_paths_that_are_shown() -> Result<(), SceneError> {
    for (shown, name) in [(["flow", "rings"], "axis-1"), (["flow", "level-sets"], "axis-1")] {
        let frame = alone(name, &shown, 0.4)?;
        let (heads, paths): (Vec<_>, Vec<_>) = frame.panes[1].lines.iter().partition(|line| line.points.len() == 3);
        let separatrix = alone(name, &["separatrix", "polhode"], 0.4)?;
        let paths: Vec<_> = paths.into_iter().chain(&separatrix.panes[1].lines).collect();
        assert!(heads.len() > 60 && paths.len() > 8);
        for line in heads {
            let place = place_and_way(line).0;
            let from_piece = |pair: &[crate::frame::LinePoint]| {
                let (a, b) = (pair[0].position, pair[1].position);
                let part = ((place - a).dot(b - a) / (b - a).length_squared().max(1e-12)).clamp(0.0, 1.0);
                place.distance(a.lerp(b, part))
            };
            let nearest = paths.iter().flat_map(|path| path.points.windows(2)).map(from_piece).fold(1.0, f32::min);
            // Of a bent path an arrowhead is straight: a tenth of its length off.
            assert!(nearest < 0.007, "{shown:?}: {nearest} at {place}");
        }
    }
    // Each path has its own, round either end.
    let frame = alone("axis-1", &["flow", "rings"], 0.4)?;
    let (heads, rings): (Vec<_>, Vec<_>) = frame.panes[1].lines.iter().partition(|line| line.points.len() == 3);
    for ring in rings {
        let is_near = |head: &&&crate::frame::Line| {
            let place = place_and_way(head).0;
            ring.points.iter().any(|point| point.position.distance(place) < 0.06)
        };
        assert!(heads.iter().filter(is_near).count() >= 8);
    }
    let size = |frame: &Frame| {
        let own = frame.panes[1].lines.last().map(|line| line.points[0].position.distance(line.points[2].position));
        own.unwrap_or_default()
    };
    let (small, large) = (size(&alone("axis-1", &["flow"], 0.4)?), size(&alone("flip", &["flow"], 0.4)?));
    assert!(small < 0.7 * large, "{small} {large}");
    Ok(())
}

/// From one moment to the next no arrowhead jumps, or comes or goes where it can be seen.
#[test]
fn arrowheads_run_on() -> Result<(), SceneError> {
    let places = |time: f64| -> Result<Vec<(Vec3, f32)>, SceneError> {
        let frame = alone("flip", &["flow"], time)?;
        Ok(frame.panes[1].lines.iter().map(|line| (place_and_way(line).0, line.points[0].color.0[3])).collect())
    };
    let mut before = places(0.0)?;
    for n in 1..120 {
        let now = places(0.005 * f64::from(n))?;
        for (place, strength) in &before {
            // Ṁ/ℓ is at most ℓ/2 (1/I₁ − 1/I₃), here 5.5 rad/s: in so short a time none goes farther than this.
            let nearest = now.iter().map(|(other, _)| place.distance(*other)).fold(1.0, f32::min);
            assert!(*strength < 0.2 || nearest < 0.03, "{n}: {place} {strength} {nearest}");
        }
        before = now;
    }
    Ok(())
}
