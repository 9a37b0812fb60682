//! What is drawn: one file an object, each a pure function of the simulation that adds primitives to a pane.
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
mod labels;
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

use Space::{Momentum, World};
use glam::Vec2;

use crate::camera::Camera;
use crate::frame::{Color, Frame, Pane};
use crate::scene::{self, Scene, Theme};
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
    /// One sentence about it.
    pub help: &'static str,
    /// What it asks of the rest of the picture.
    role: Role,
    /// Adds it to a pane of that space.
    draw: fn(&Context<'_>, &mut Pane),
}

/// What the rest of the picture does for an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    /// Nothing.
    Plain,
    /// It is a part of Poinsot's construction, drawn on the invariable plane, which is then named.
    OnPlane,
    /// It is Poinsot's ellipsoid, for which ω is drawn small enough.
    RollingEllipsoid,
    /// It is the momentum sphere in the world, on which L then ends.
    MomentumSphere,
}

impl Object {
    /// The same row with a role.
    const fn with(mut self, role: Role) -> Self {
        self.role = role;
        self
    }
}

const fn object(
    name: &'static str,
    label: &'static str,
    space: Space,
    shown: bool,
    help: &'static str,
    draw: fn(&Context<'_>, &mut Pane),
) -> Object {
    Object { name, label, space, shown, help, role: Role::Plain, draw }
}

/// The body, on which its axes are numbered.
const BODY: Object =
    object("body", "Body", World, true, "the body, its faces in the colours of its principal axes", body::draw);
/// The axes that turn with it, which have their own numbers.
const BODY_AXES: Object =
    object("body-axes", "Axes of the body", World, false, "the principal axes, turning with the body", body_axes::axes);
/// The axes of momentum space, whose moments have a unit.
const AXES: Object =
    object("axes", "Principal axes", Momentum, true, "the principal axes 1, 2, 3 with their moments", axes::axes);
/// The tip of M, which can be dragged where it is drawn.
pub const TIP: Object = object("tip", "Tip of M", Momentum, true, "M, the momentum as the body sees it", tip::tip);

/// The words of both spaces, under which there must be room.
const WORLD_NOTES: Object = object(
    "world-notes",
    "Words about the world",
    World,
    true,
    "what is seen, and which method is which",
    notes::world,
);
const MOMENTUM_NOTES: Object = object(
    "body-notes",
    "Words about the momentum sphere",
    Momentum,
    true,
    "what is seen, and the unit of the moments",
    notes::momentum_space,
);

/// All objects, in the order in which they are added.
pub static OBJECTS: &[Object] = &[
    object("shadow", "Shadow", World, true, "the body's soft shadow on the floor", floor::shadow),
    object("plane", "Invariable plane", World, true, "the plane square to L, drawn as the floor", floor::plane),
    object(
        "annulus",
        "Annulus of the herpolhode",
        World,
        false,
        "the two circles between which it runs",
        floor::annulus,
    )
    .with(Role::OnPlane),
    object("herpolhode", "Herpolhode", World, false, "the path of the contact point on the plane", floor::herpolhode)
        .with(Role::OnPlane),
    object(
        "rolling-ellipsoid",
        "Poinsot's rolling ellipsoid",
        World,
        false,
        "the inertia ellipsoid, which rolls on the plane without slipping",
        floor::rolling_ellipsoid,
    )
    .with(Role::RollingEllipsoid),
    object(
        "rolling-sphere",
        "Rolling momentum sphere",
        World,
        false,
        "the momentum sphere as the body carries it, L's tip on its polhode",
        body_axes::carried_sphere,
    )
    .with(Role::MomentumSphere),
    object("axis-trail", "Trail of the spin axis", World, false, "the way of the axis spun about", body_axes::trail),
    object("axis-1-trail", "Trail of axis 1", World, false, "the way of axis 1", body_axes::trail_of_axis::<0>),
    object("axis-2-trail", "Trail of axis 2", World, false, "the way of axis 2", body_axes::trail_of_axis::<1>),
    object("axis-3-trail", "Trail of axis 3", World, false, "the way of axis 3", body_axes::trail_of_axis::<2>),
    BODY,
    object("axis-names", "Numbers of the axes", World, true, "the numbers 1, 2, 3 on the body", body_axes::names),
    BODY_AXES,
    object(
        "ghosts",
        "Bodies of the other methods",
        World,
        true,
        "the body as each other method has it",
        ghosts::bodies,
    ),
    object("momentum", "Angular momentum L", World, true, "L, fixed in the room", vectors::momentum),
    object(
        "omega",
        "Angular velocity ω",
        World,
        true,
        "ω, the axis and rate of the turning",
        vectors::angular_velocity,
    ),
    WORLD_NOTES,
    object("sphere", "Sphere |M| = |L|", Momentum, true, "all M of the length of L", surfaces::sphere),
    object("ellipsoid", "Energy ellipsoid", Momentum, true, "all M of the same energy", surfaces::ellipsoid),
    AXES,
    object("level-sets", "Levels of the energy", Momentum, true, "paths of M at other energies", level_sets::draw),
    object("separatrix", "Separatrix", Momentum, true, "the border between the two kinds of motion", separatrix::draw),
    object("poles", "Steady spins", Momentum, true, "where M stays: a disc is stable, a cross is not", axes::poles),
    object("polhode", "Polhode", Momentum, true, "the path of M: where sphere and ellipsoid meet", polhode::draw),
    object("ghost-marks", "M of the other methods", Momentum, true, "M as each other method has it", ghosts::marks),
    object("tail", "Tail of M", Momentum, true, "where M was a moment ago", tip::tail),
    TIP,
    MOMENTUM_NOTES,
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

/// Every object and whether a view's settings show it, what is usually shown first: what a list of them to choose from says.
#[must_use]
pub fn items(view: &scene::View) -> Vec<(&'static Object, bool)> {
    let usual = OBJECTS.iter().filter(|object| object.shown);
    let others = OBJECTS.iter().filter(|object| !object.shown);
    usual.chain(others).map(|object| (object, is_shown(object, view))).collect()
}

/// The colours of the principal axes 1, 2, 3.
#[must_use]
pub fn axis_colors(theme: Theme) -> [Color; 3] {
    Palette::new(theme).axes
}

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
    // Under the legend.
    let legend = notes::legend_height(context, space);
    camera.distance /= 1.0 - legend;
    camera.pan(Vec2::new(0.0, 0.5 * legend));
    camera
}

/// The picture of a scene as its simulation is now, in a picture of this aspect (width over height).
#[must_use]
pub fn build_frame(scene: &Scene, simulation: &Simulation, cameras: &Cameras, aspect: f32) -> Frame {
    let settings = &scene.view;
    let palette = Palette::new(settings.theme);
    let context = Context::new(scene, simulation, &palette);
    let panes = areas(settings.layout, aspect)
        .into_iter()
        .map(|(space, area)| {
            let mut pane = Pane::new(area, camera_of(&context, cameras, space), space.lift());
            for object in OBJECTS.iter().filter(|object| object.space == space && is_shown(object, settings)) {
                (object.draw)(&context, &mut pane);
            }
            if !settings.labels {
                pane.labels.clear();
                pane.notes.clear();
            }
            pane
        })
        .collect();
    Frame { background: palette.background, transparent: false, font_scale: settings.font_scale as f32, panes }
}

#[cfg(test)]
mod tests {
    use super::{OBJECTS, Role, TIP, items, object_named};
    use crate::scene::{Scene, SceneError, SceneFile};

    #[test]
    fn the_table_names_each_object_once_and_explains_it() {
        for (number, object) in OBJECTS.iter().enumerate() {
            assert!(OBJECTS[..number].iter().all(|other| other.name != object.name), "{} stands twice", object.name);
            assert!(!object.help.is_empty() && !object.help.ends_with('.'), "{}: {}", object.name, object.help);
        }
        assert!(object_named(TIP.name).is_some_and(|row| row.space == TIP.space));
        for role in [Role::OnPlane, Role::RollingEllipsoid, Role::MomentumSphere] {
            assert!(OBJECTS.iter().any(|object| object.role == role), "nothing is {role:?}");
        }
    }

    #[test]
    fn a_list_to_choose_from_holds_all_and_says_what_is_shown() -> Result<(), SceneError> {
        let mut file = SceneFile::default();
        file.view.hide = vec!["tip".to_owned()];
        file.view.show = vec!["annulus".to_owned()];
        let items = items(&Scene::check(&file)?.view);
        assert_eq!(items.len(), OBJECTS.len());
        for (object, is_shown) in items {
            let expected = object.name == "annulus" || object.shown && object.name != "tip";
            assert_eq!(is_shown, expected, "{}", object.name);
        }
        Ok(())
    }
}
