//! What is drawn: one file an object, each a pure function of the simulation that adds primitives to a view.
//!
//! To draw something new: one file here, and one row of [`OBJECTS`].

mod arrow;
mod axes;
mod body;
mod body_axes;
mod check;
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
use crate::scene::{self, Scene};
use crate::sim::Simulation;

pub use check::check;
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
    /// What it is, in one sentence.
    pub about: &'static str,
    /// Adds it to a view of that space.
    draw: fn(&Context<'_>, &mut View),
}

const fn object(
    name: &'static str,
    label: &'static str,
    space: Space,
    shown: bool,
    draw: fn(&Context<'_>, &mut View),
    about: &'static str,
) -> Object {
    Object { name, label, space, shown, about, draw }
}

/// All objects, in the order in which they are added.
pub static OBJECTS: &[Object] = &[
    object(
        "shadow",
        "Shadow",
        Space::World,
        true,
        floor::shadow,
        "What the body would throw on the floor in light from above",
    ),
    object(
        "plane",
        "Invariable plane",
        Space::World,
        true,
        floor::plane,
        "The floor: the plane across L on which the ellipsoid of inertia rolls",
    ),
    object(
        "annulus",
        "Annulus of the herpolhode",
        Space::World,
        false,
        floor::annulus,
        "The ring of the plane within which the herpolhode stays",
    ),
    object(
        "herpolhode",
        "Herpolhode",
        Space::World,
        false,
        floor::herpolhode,
        "The path of the point of contact on the plane",
    ),
    object(
        "rolling-ellipsoid",
        "Poinsot's rolling ellipsoid",
        Space::World,
        false,
        floor::rolling_ellipsoid,
        "The ellipsoid of inertia, which rolls on the plane without slipping",
    ),
    object(
        "rolling-sphere",
        "Rolling momentum sphere",
        Space::World,
        false,
        body_axes::carried_sphere,
        "The momentum sphere carried by the body, with the polhode on it",
    ),
    object(
        "axis-trail",
        "Trail of the spin axis",
        Space::World,
        false,
        body_axes::trail,
        "The path of the tip of the axis that the body was spun about",
    ),
    object(
        "axis-1-trail",
        "Trail of axis 1",
        Space::World,
        false,
        body_axes::trail_of_axis::<0>,
        "The path of the tip of the axis of the smallest moment",
    ),
    object(
        "axis-2-trail",
        "Trail of axis 2",
        Space::World,
        false,
        body_axes::trail_of_axis::<1>,
        "The path of the tip of the axis of the middle moment",
    ),
    object(
        "axis-3-trail",
        "Trail of axis 3",
        Space::World,
        false,
        body_axes::trail_of_axis::<2>,
        "The path of the tip of the axis of the largest moment",
    ),
    object("body", "Body", Space::World, true, body::draw, "The body itself, its faces and edges"),
    object(
        "axis-names",
        "Numbers of the axes",
        Space::World,
        true,
        body_axes::names,
        "The numbers 1, 2, 3 at the ends of the body's axes",
    ),
    object(
        "body-axes",
        "Axes of the body",
        Space::World,
        false,
        body_axes::axes,
        "The principal axes of the body, out of its faces",
    ),
    object(
        "ghosts",
        "Bodies of the other methods",
        Space::World,
        true,
        ghosts::bodies,
        "The bodies of the methods that are compared, seen through",
    ),
    object(
        "momentum",
        "Angular momentum L",
        Space::World,
        true,
        vectors::momentum,
        "The arrow of the angular momentum, which never moves",
    ),
    object(
        "omega",
        "Angular velocity ω",
        Space::World,
        true,
        vectors::angular_velocity,
        "The arrow of the angular velocity, which swings about L",
    ),
    object(
        "world-notes",
        "Words about the world",
        Space::World,
        true,
        notes::world,
        "The caption over the world and the legend of the methods",
    ),
    object(
        "sphere",
        "Sphere |M| = |L|",
        Space::Body,
        true,
        surfaces::sphere,
        "The sphere that the tip of M cannot leave, for |M| stays the same",
    ),
    object(
        "ellipsoid",
        "Energy ellipsoid",
        Space::Body,
        true,
        surfaces::ellipsoid,
        "The ellipsoid of all momenta of the same energy",
    ),
    object("axes", "Principal axes", Space::Body, true, axes::axes, "The principal axes through momentum space"),
    object(
        "level-sets",
        "Levels of the energy",
        Space::Body,
        true,
        level_sets::draw,
        "The paths of M at other energies, on the sphere",
    ),
    object(
        "separatrix",
        "Separatrix",
        Space::Body,
        true,
        separatrix::draw,
        "The two circles' border between paths about axis 1 and about axis 3",
    ),
    object(
        "poles",
        "Steady spins",
        Space::Body,
        true,
        axes::poles,
        "The six steady spins: stable ones dots, unstable ones crosses",
    ),
    object("polhode", "Polhode", Space::Body, true, polhode::draw, "The path of M: where sphere and ellipsoid cross"),
    object(
        "ghost-marks",
        "M of the other methods",
        Space::Body,
        true,
        ghosts::marks,
        "The tips of M of the methods that are compared",
    ),
    object("tail", "Tail of M", Space::Body, true, tip::tail, "The way that the tip of M has just come"),
    object("tip", "Tip of M", Space::Body, true, tip::tip, "The tip of M, and the arrow to it"),
    object(
        "body-notes",
        "Words about the momentum sphere",
        Space::Body,
        true,
        notes::body,
        "The caption over momentum space",
    ),
];

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
