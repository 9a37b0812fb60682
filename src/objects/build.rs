//! A whole picture: every object that is shown, added to the pane of its space.

use glam::Vec2;

use super::glide::Held;
use super::{Cameras, Context, Glide, OBJECTS, Palette, Space, is_shown, notes, surfaces};
use crate::camera::Camera;
use crate::frame::{Frame, Pane};
use crate::scene::Scene;
use crate::sim::Simulation;

/// The camera of a space as pictures of it are drawn: with room for what stands out of the sphere.
#[must_use]
pub fn camera(scene: &Scene, simulation: &Simulation, cameras: &Cameras, space: Space) -> Camera {
    let palette = Palette::new(scene.view.theme);
    camera_of(&Context::new(scene, simulation, &palette), cameras, space)
}

fn camera_of(context: &Context<'_>, cameras: &Cameras, space: Space) -> Camera {
    let mut camera = *cameras.of(space);
    if space == Space::Momentum {
        camera.distance *= surfaces::room(context);
    }
    // Under the words.
    let words = notes::height(context, space);
    camera.distance /= 1.0 - words;
    camera.pan(Vec2::new(0.0, 0.5 * words));
    camera
}

/// The picture of a scene as its simulation is now, in a picture of this aspect (width over height).
#[must_use]
pub fn build_frame(scene: &Scene, simulation: &Simulation, cameras: &Cameras, aspect: f32) -> Frame {
    build_frame_scaled(scene, simulation, cameras, aspect, 1.0)
}

/// As [`build_frame`], with type and lines larger by a factor.
#[must_use]
pub fn build_frame_scaled(
    scene: &Scene,
    simulation: &Simulation,
    cameras: &Cameras,
    aspect: f32,
    type_scale: f32,
) -> Frame {
    build_frame_on_the_way(scene, simulation, cameras, aspect, type_scale, None)
}

/// The same, on the way from another view.
#[must_use]
pub fn build_frame_on_the_way(
    scene: &Scene,
    simulation: &Simulation,
    cameras: &Cameras,
    aspect: f32,
    type_scale: f32,
    glide: Option<Glide<'_>>,
) -> Frame {
    let settings = &scene.view;
    let palette = Palette::new(settings.theme);
    let mut context = Context::new(scene, simulation, &palette);
    (context.type_scale, context.aspect) = (type_scale, aspect);
    let glide = glide.unwrap_or(Glide { from: settings, part: 1.0 });
    let panes = glide
        .areas(settings.layout, aspect)
        .into_iter()
        .map(|(space, area)| {
            let mut pane = Pane::new(area, camera_of(&context, cameras, space), space.lift());
            for object in OBJECTS.iter().filter(|object| object.space == space) {
                let weight = glide.weight(object, settings);
                // At the very beginning all that comes is drawn unseen: its labels have their places.
                if weight > 0.0 || is_shown(object, settings) {
                    let held = Held::by(&pane);
                    (object.draw)(&context, &mut pane);
                    if weight < 1.0 {
                        held.fade_since(&mut pane, weight);
                    }
                }
            }
            if !settings.labels {
                pane.labels.clear();
                pane.notes.clear();
            }
            pane
        })
        .collect();
    Frame {
        background: palette.background,
        transparent: false,
        font_scale: settings.font_scale as f32 * type_scale,
        panes,
    }
}
