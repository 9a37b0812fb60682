//! What the pointer does: it turns the view that it is over, and points at places of the momentum sphere.

use glam::{Vec2, Vec3};

use super::Driven;
use crate::camera::Camera;
use crate::physics::{poinsot, so3};
use crate::scene::{Layout, SceneError};
use crate::ui::{Command, Pixels};

/// Pictures from wide to high.
const SIZES: [[f32; 2]; 4] = [[1300.0, 480.0], [960.0, 480.0], [700.0, 700.0], [480.0, 900.0]];

/// Where a point lies in the picture by central projection, worked out from the camera's eye and axes alone.
fn seen_at(camera: &Camera, corner: Vec2, extent: Vec2, point: Vec3) -> Pixels {
    let (right, up, forward) = camera.axes();
    let from_eye = point - camera.eye();
    // 13° from the middle to the nearer edges.
    let per_tangent = 0.5 * extent.min_element() / 13f32.to_radians().tan();
    let place = Vec2::new(from_eye.dot(right), -from_eye.dot(up)) / from_eye.dot(forward);
    corner + 0.5 * extent + per_tangent * place
}

/// The camera and the part of the picture (pixels: corner, extent) of the momentum sphere.
fn momentum_view(driven: &Driven) -> Result<(Camera, Vec2, Vec2), SceneError> {
    let size = driven.session.picture_size;
    let frame = driven.session.frame(size.x / size.y);
    let pane = frame.panes.last().ok_or(missing("a view"))?;
    Ok((pane.camera, pane.area.corner * size, pane.area.extent * size))
}

fn missing(what: &str) -> SceneError {
    SceneError::NotAScene { line: 0, message: format!("{what} is missing") }
}

/// The start's direction of the momentum in principal axes.
fn start(driven: &Driven) -> Vec3 {
    let scene = &driven.session.scene;
    (scene.body.body_from_principal().transpose() * scene.start.body_momentum).normalize().as_vec3()
}

#[test]
fn a_point_picked_on_the_sphere_is_the_one_seen_there() -> Result<(), SceneError> {
    for size in SIZES {
        let mut driven = Driven::new("flip")?;
        driven.apply(Command::PlayPause);
        driven.apply(Command::Resize(Pixels::from_array(size)));
        let (_, corner, extent) = momentum_view(&driven)?;
        for share in [Vec2::ZERO, Vec2::new(0.2, 0.1), Vec2::new(-0.1, 0.2), Vec2::new(0.1, -0.15)] {
            let at = corner + 0.5 * extent + share * extent.min_element();
            let (camera, ..) = momentum_view(&driven)?;
            driven.apply(Command::Hover(Some(at)));
            let preview = driven.session.look(None, false).preview.cloned().ok_or(missing("a preview"))?;
            assert!(preview.at.distance(at) < 0.05, "{size:?}: {} for {at}", preview.at);
            let length = so3::norm(driven.session.scene.start.body_momentum);
            driven.apply(Command::Pick(at));
            // The sphere is that of |L|. A few roundings of a momentum that is made an angular velocity, and read again.
            let kept = so3::norm(driven.session.scene.start.body_momentum);
            assert!((kept / length - 1.0).abs() < 8.0 * f64::EPSILON, "{kept} of {length}");
            let seen = seen_at(&camera, corner, extent, start(&driven));
            // A twentieth of a pixel: f32 through a projection and back.
            assert!(seen.distance(at) < 0.05, "{size:?}: {seen} for {at}");
            // The picture makes room for the ellipsoid of the new start: there the tip is where it is seen.
            let (camera, ..) = momentum_view(&driven)?;
            let (seen, tip) = (seen_at(&camera, corner, extent, start(&driven)), driven.session.tip());
            assert!(seen.distance(tip.unwrap_or_default()) < 0.05, "{size:?}: {tip:?} for {seen}");
            driven.apply(Command::Undo);
        }
    }
    Ok(())
}

#[test]
fn a_tip_behind_the_sphere_cannot_be_taken_hold_of() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::PlayPause);
    let mut sides = [0, 0];
    for step in 0..40 {
        driven.apply(Command::GoTo(f64::from(step) * 0.2));
        let (camera, ..) = momentum_view(&driven)?;
        let axes = driven.session.scene.body.body_from_principal().transpose();
        let tip = (axes * driven.session.sim.state().body_momentum).normalize().as_vec3();
        let height = camera.eye().dot(tip);
        if (height - 1.0).abs() > 0.01 {
            assert_eq!(driven.session.tip().is_some(), height > 1.0, "{step}");
        }
        sides[usize::from(height > 1.0)] += 1;
    }
    assert!(sides[0] > 5 && sides[1] > 5, "{sides:?}");
    driven.apply(Command::Show { name: "tip", is_shown: false });
    assert_eq!(driven.session.tip(), None, "what is not drawn is not taken hold of");
    Ok(())
}

#[test]
fn the_previewed_path_is_the_polhode_and_its_far_side_is_known() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::PlayPause);
    let at = Pixels::new(760.0, 200.0);
    let (camera, corner, extent) = momentum_view(&driven)?;
    driven.apply(Command::Hover(Some(at)));
    let preview = driven.session.look(None, false).preview.cloned().ok_or(missing("a preview"))?;
    driven.apply(Command::Pick(at));
    let scene = &driven.session.scene;
    let path = poinsot::polhode(&scene.body, scene.start.body_momentum, preview.path.len());
    assert_eq!(preview.words, poinsot::classify(&scene.body, scene.start.body_momentum).label());
    let axes = scene.body.body_from_principal().transpose();
    let mut sides = [0, 0];
    for ((pixel, is_near), momentum) in preview.path.iter().zip(path) {
        let point = (axes * momentum).normalize().as_vec3();
        let seen = seen_at(&camera, corner, extent, point);
        assert!(seen.distance(*pixel) < 0.1, "{seen} for {pixel}");
        // The near side ends where the line of sight touches: eye · point = 1.
        let height = camera.eye().dot(point);
        if (height - 1.0).abs() > 0.01 {
            assert_eq!(*is_near, height > 1.0, "{point}");
        }
        sides[usize::from(*is_near)] += 1;
    }
    assert!(sides[0] > 10 && sides[1] > 10, "{sides:?}");
    Ok(())
}

#[test]
fn outside_of_the_sphere_nothing_is_picked_but_a_drag_follows_its_outline() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::PlayPause);
    let before = driven.file().clone();
    // Left of the view of momentum lies the world's.
    for outside in [Pixels::new(470.0, 240.0), Pixels::new(490.0, 10.0), Pixels::new(950.0, 470.0)] {
        driven.apply(Command::Pick(outside));
        assert_eq!(*driven.file(), before, "{outside}");
        driven.apply(Command::Hover(Some(outside)));
        assert!(driven.session.preview.is_none(), "{outside}");
    }
    for outside in [Pixels::new(950.0, 240.0), Pixels::new(720.0, 5.0), Pixels::new(500.0, 470.0)] {
        let (camera, corner, extent) = momentum_view(&driven)?;
        driven.apply(Command::DragTip(outside));
        let point = start(&driven);
        // On the way from the sphere's middle to the pointer, where the sphere turns away from the eye.
        let middle = seen_at(&camera, corner, extent, Vec3::ZERO);
        let seen = seen_at(&camera, corner, extent, point);
        assert!((seen - middle).angle_to(outside - middle).abs() < 1e-3, "{seen}");
        let height = camera.eye().dot(point);
        assert!((height - 1.0).abs() < 1e-5, "{height}");
    }
    // Nothing that is at rest is set turning by a click.
    let text = "title = 'rest'\n[spin]\nomega = [0.0, 0.0, 0.0]".to_owned();
    driven.apply(Command::OpenText { name: "rest.toml".to_owned(), text });
    driven.apply(Command::GoTo(1.5));
    let before = driven.file().clone();
    driven.apply(Command::Pick(Pixels::new(720.0, 240.0)));
    assert_eq!((driven.file(), driven.session.time()), (&before, 1.5));
    // The attitude at the start is its own.
    let text = "[spin]\naxis = 2\ntilt_deg = 20\nrate = 6\nattitude = [0.8, 0.6, 0.0, 0.0]".to_owned();
    driven.apply(Command::OpenText { name: "turned.toml".to_owned(), text });
    driven.apply(Command::Pick(Pixels::new(720.0, 240.0)));
    assert!(driven.file().spin.omega.is_some());
    assert_eq!(driven.file().spin.attitude, Some([0.8, 0.6, 0.0, 0.0]));
    // Without a view of momentum there is nothing to pick.
    driven.apply(Command::SetLayout(Layout::World));
    let before = driven.file().clone();
    driven.apply(Command::Pick(Pixels::new(720.0, 240.0)));
    assert_eq!((driven.file(), driven.session.tip()), (&before, None));
    Ok(())
}

#[test]
fn a_drag_turns_the_view_that_it_begins_in_by_its_share_of_the_smaller_side() -> Result<(), SceneError> {
    for size in SIZES {
        let mut driven = Driven::new("flip")?;
        driven.apply(Command::PlayPause);
        driven.apply(Command::Resize(Pixels::from_array(size)));
        let areas: Vec<_> = driven.session.frame(size[0] / size[1]).panes.iter().map(|pane| pane.area).collect();
        for (view, area) in areas.iter().enumerate() {
            let middle = (area.corner + 0.5 * area.extent) * Vec2::from_array(size);
            let side = (area.extent * Vec2::from_array(size)).min_element();
            let before = driven.session.cameras;
            driven.apply(Command::Hover(Some(middle)));
            driven.apply(Command::Orbit { at: middle, by: Pixels::new(0.1 * side, 0.0) });
            assert!(driven.session.preview.is_none(), "what was pointed at has moved away");
            let after = driven.session.cameras;
            let turned = [before.world.azimuth - after.world.azimuth, before.momentum.azimuth - after.momentum.azimuth];
            for (index, turned) in turned.into_iter().enumerate() {
                let wanted = if index == view { 0.1 * std::f32::consts::PI } else { 0.0 };
                assert!((turned - wanted).abs() < 1e-5, "{size:?} {view} {index}: {turned}");
            }
        }
    }
    Ok(())
}

#[test]
fn the_pointer_picks_starts_on_the_sphere() -> Result<(), SceneError> {
    let mut driven = Driven::new("flip")?;
    driven.apply(Command::PlayPause);
    let (middle, outside) = (Pixels::new(720.0, 240.0), Pixels::new(500.0, 20.0));
    driven.apply(Command::Hover(Some(middle)));
    assert!(driven.session.look(None, false).preview.is_some_and(|preview| !preview.path.is_empty()));
    driven.apply(Command::Hover(Some(outside)));
    assert!(driven.session.preview.is_none());
    let before = driven.file().spin.clone();
    driven.apply(Command::Pick(outside));
    assert_eq!(driven.file().spin, before);
    driven.session.say_nothing();
    driven.apply(Command::Pick(middle));
    assert!(driven.file().spin.omega.is_some() && driven.message().is_empty());
    // The tip is now where the click was, to a pixel.
    let tip = driven.session.tip().unwrap_or_default();
    assert!(tip.distance(middle) < 1.0, "{tip}");
    driven.apply(Command::DragTip(outside));
    let dragged = driven.session.tip().unwrap_or_default();
    assert!(dragged.distance(middle) > 50.0, "{dragged}");
    driven.apply(Command::Undo);
    driven.apply(Command::Undo);
    assert_eq!(driven.file().spin, before);
    Ok(())
}
