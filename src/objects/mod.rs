//! What is drawn: one file an object, each a pure function of the simulation that adds primitives to a view.
//!
//! To draw something new: one file here, and one row of [`OBJECTS`].

mod arrow;
mod axes;
mod body;
mod body_axes;
mod context;
mod curve;
mod floor;
mod ghosts;
mod layout;
mod level_sets;
mod mesh;
mod notes;
mod polhode;
mod separatrix;
mod surfaces;
mod theme;
mod tip;
mod vectors;

use crate::camera::Camera;
use crate::frame::{Frame, View};
use crate::scene::{self, Scene, SceneError, SceneFile};
use crate::sim::Simulation;

pub use context::Context;
pub use ghosts::method_color;
pub use layout::{Cameras, Space, areas};
pub use theme::Palette;

/// A row of the table of drawn things.
pub struct Object {
    /// Name on the command line and in scene files.
    pub name: &'static str,
    /// Name for people.
    pub label: &'static str,
    /// In which space it is drawn.
    pub space: Space,
    /// Whether it is shown where nobody says otherwise.
    pub shown: bool,
    /// Adds it to a view of that space.
    draw: fn(&Context<'_>, &mut View),
}

const fn object(
    name: &'static str,
    label: &'static str,
    space: Space,
    shown: bool,
    draw: fn(&Context<'_>, &mut View),
) -> Object {
    Object { name, label, space, shown, draw }
}

/// All objects, in the order in which they are added.
pub static OBJECTS: &[Object] = &[
    object("shadow", "Shadow", Space::World, true, floor::shadow),
    object("plane", "Invariable plane", Space::World, true, floor::plane),
    object("annulus", "Annulus of the herpolhode", Space::World, false, floor::annulus),
    object("herpolhode", "Herpolhode", Space::World, false, floor::herpolhode),
    object("rolling-ellipsoid", "Poinsot's rolling ellipsoid", Space::World, false, floor::rolling_ellipsoid),
    object("rolling-sphere", "Rolling momentum sphere", Space::World, false, body_axes::carried_sphere),
    object("axis-trail", "Trail of the spin axis", Space::World, false, body_axes::trail),
    object("axis-1-trail", "Trail of axis 1", Space::World, false, body_axes::trail_of_axis::<0>),
    object("axis-2-trail", "Trail of axis 2", Space::World, false, body_axes::trail_of_axis::<1>),
    object("axis-3-trail", "Trail of axis 3", Space::World, false, body_axes::trail_of_axis::<2>),
    object("body", "Body", Space::World, true, body::draw),
    object("axis-names", "Numbers of the axes", Space::World, true, body_axes::names),
    object("body-axes", "Axes of the body", Space::World, false, body_axes::axes),
    object("ghosts", "Bodies of the other methods", Space::World, true, ghosts::bodies),
    object("momentum", "Angular momentum L", Space::World, true, vectors::momentum),
    object("omega", "Angular velocity ω", Space::World, true, vectors::angular_velocity),
    object("world-notes", "Words about the world", Space::World, true, notes::world),
    object("sphere", "Sphere |M| = |L|", Space::Body, true, surfaces::sphere),
    object("ellipsoid", "Energy ellipsoid", Space::Body, true, surfaces::ellipsoid),
    object("axes", "Principal axes", Space::Body, true, axes::axes),
    object("level-sets", "Levels of the energy", Space::Body, true, level_sets::draw),
    object("separatrix", "Separatrix", Space::Body, true, separatrix::draw),
    object("poles", "Steady spins", Space::Body, true, axes::poles),
    object("polhode", "Polhode", Space::Body, true, polhode::draw),
    object("ghost-marks", "M of the other methods", Space::Body, true, ghosts::marks),
    object("tail", "Tail of M", Space::Body, true, tip::tail),
    object("tip", "Tip of M", Space::Body, true, tip::tip),
    object("body-notes", "Words about the momentum sphere", Space::Body, true, notes::body),
];

/// Checks a scene: the one way in for every text that becomes a picture.
///
/// # Errors
/// See [`SceneError`].
pub fn check(file: &SceneFile) -> Result<Scene, SceneError> {
    Scene::check(file)
}

/// Looks an object up by its name.
#[must_use]
pub fn object_named(name: &str) -> Option<&'static Object> {
    OBJECTS.iter().find(|object| object.name == name)
}

/// Whether a view's settings show an object. What is hidden by name stays hidden, whatever else is said.
#[must_use]
pub fn is_shown(object: &Object, view: &scene::View) -> bool {
    let named = |names: &[String]| names.iter().any(|name| name == object.name);
    (object.shown || named(&view.show)) && !named(&view.hide)
}

/// The camera of a space as pictures of it are drawn: with room for what stands out of the sphere.
#[must_use]
pub fn camera(scene: &Scene, simulation: &Simulation, cameras: &Cameras, space: Space) -> Camera {
    let palette = Palette::new(scene.view.theme);
    camera_of(&Context::new(scene, simulation, &palette), cameras, space)
}

fn camera_of(context: &Context<'_>, cameras: &Cameras, space: Space) -> Camera {
    let mut camera = *cameras.of(space);
    if space == Space::Body {
        camera.distance *= surfaces::room(context);
    }
    camera
}

/// The picture of a scene as its simulation is now, in a picture of this aspect (width over height).
#[must_use]
pub fn build_frame(scene: &Scene, simulation: &Simulation, cameras: &Cameras, aspect: f32) -> Frame {
    let settings = &scene.view;
    let palette = Palette::new(settings.theme);
    let context = Context::new(scene, simulation, &palette);
    let views = areas(settings.layout, aspect)
        .into_iter()
        .map(|(space, area)| {
            let mut view = View::new(area, camera_of(&context, cameras, space));
            for object in OBJECTS.iter().filter(|object| object.space == space && is_shown(object, settings)) {
                (object.draw)(&context, &mut view);
            }
            if space == Space::Body {
                // On the round surfaces of momentum space a flat stroke dips in near the outline; no thin body is there
                // for it to shine through.
                for line in &mut view.lines {
                    line.lift = 0.014;
                }
            }
            if !settings.labels {
                view.labels.clear();
                view.notes.clear();
            }
            view
        })
        .collect();
    Frame { background: palette.background, transparent: false, font_scale: settings.font_scale as f32, views }
}
