//! What is drawn: one file an object, each a pure function of the simulation that adds primitives to a pane.
//!
//! To draw something new: one file here, and one row of [`OBJECTS`].

mod arrow;
mod axes;
mod body;
mod body_axes;
mod build;
mod check;
mod cloud;
mod context;
mod curve;
mod floor;
mod flow;
#[cfg(test)]
mod frames_test;
mod ghosts;
mod glide;
mod labels;
mod layout;
mod level_sets;
mod loupe;
mod mesh;
mod notes;
mod page;
mod polhode;
mod rings;
mod separatrix;
mod surfaces;
mod theme;
mod tip;
mod track;
mod turn;
mod vectors;
mod way;
mod words;

use Space::{Momentum, World};

use crate::frame::{Color, Pane};
use crate::scene::{self, ALL, Theme};

pub use build::{build_frame, build_frame_on_the_way, build_frame_scaled, camera};
pub use check::{check, check_at};
pub use context::Context;
pub use ghosts::method_color;
pub use glide::Glide;
pub use layout::{Cameras, Space, areas};
pub use notes::is_turning_over;
pub use page::{PAGE, PAGE_ON_PAPER, build_page, page_time, pages};
pub use theme::Palette;
pub use words::{WORDS, Word, word_of};

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
    draw: fn(&Context<'_>, &mut Pane),
    about: &'static str,
) -> Object {
    Object { name, label, space, shown, about, role: Role::Plain, draw }
}

/// The body, on which its axes are numbered.
const BODY: Object = object("body", "Body", World, true, body::draw, "The body itself, its faces and edges");
/// The numbers of the axes, at the ends that are not named otherwise.
const AXIS_NAMES: Object = object(
    "axis-names",
    "Numbers of the axes",
    World,
    true,
    body_axes::names,
    "The numbers 1, 2, 3 at the ends of the body's axes",
);
/// The ends of the axis that it was started about.
const ENDS: Object = object(
    "ends",
    "Top and bottom",
    World,
    false,
    body_axes::ends,
    "Which end of the axis of the spin was up at the start, and which down",
);
/// The axes that turn with it, which have their own numbers.
const BODY_AXES: Object = object(
    "body-axes",
    "Axes of the body",
    World,
    false,
    body_axes::axes,
    "The principal axes of the body, out of its faces",
);
/// The axes of momentum space, whose moments have a unit.
const AXES: Object =
    object("axes", "Principal axes", Momentum, true, axes::axes, "The principal axes through momentum space");
/// The moments, named at the axes.
const MOMENTS: Object = object(
    "moments",
    "Moments of inertia",
    Momentum,
    true,
    axes::moments,
    "The moments of inertia beside the numbers of the axes",
);
/// What the ends of the axes are where the energy is taken as a height, beside their numbers.
const HEIGHTS: Object = object(
    "heights",
    "Summits, valleys and passes",
    Momentum,
    false,
    axes::heights,
    "The ends of the axes where the energy is taken as a height: summits, valleys and passes",
);
/// The ellipsoid, which the sphere crosses along two lines.
const ELLIPSOID: Object = object(
    "ellipsoid",
    "Energy ellipsoid",
    Momentum,
    true,
    surfaces::ellipsoid,
    "The ellipsoid of all momenta of the same energy",
);
/// The path of M.
const POLHODE: Object =
    object("polhode", "Polhode", Momentum, true, polhode::draw, "The path of M: where sphere and ellipsoid cross");
/// The border, beside which the second of those lines would run.
const SEPARATRIX: Object = object(
    "separatrix",
    "Separatrix",
    Momentum,
    true,
    separatrix::draw,
    "The two circles' border between paths about axis 1 and about axis 3",
);
/// L's arrow, of which the captions speak.
const MOMENTUM: Object = object(
    "momentum",
    "Angular momentum L",
    World,
    true,
    vectors::momentum,
    "The arrow of the angular momentum, which never moves",
);
/// It writes two lines over the world.
const TURN: Object = object(
    "turn",
    "Turn in one period",
    World,
    false,
    turn::turn,
    "The angle by which the body has turned about L when M has come round once",
);
/// Paths of their own, that the flow runs along where they are shown.
const RINGS: Object = object(
    "rings",
    "Rings round axes 1 and 3",
    Momentum,
    false,
    rings::draw,
    "The paths of M at other energies, each in the colour of the axis that it circles",
);
/// The ends of the axes on the sphere.
const POLES: Object = object(
    "poles",
    "Steady spins",
    Momentum,
    true,
    axes::poles,
    "The six steady spins: stable ones dots, unstable ones crosses",
);
/// The tip of M, which can be dragged where it is drawn.
pub const TIP: Object = object("tip", "Tip of M", Momentum, true, tip::tip, "The tip of M, and the arrow to it");
/// The words over the world, under which there must be room.
const WORLD_NOTES: Object = object(
    "world-notes",
    "Words about the world",
    World,
    true,
    notes::world,
    "The caption over the world and the legend of the methods",
);
/// What flips and what stays.
const FLIP_NOTES: Object = object(
    "flip-notes",
    "Words about the flip",
    World,
    false,
    notes::flip,
    "What flips and what stays, over the world",
);
/// Likewise over momentum space.
const MOMENTUM_NOTES: Object = object(
    "body-notes",
    "Words about the momentum sphere",
    Momentum,
    true,
    notes::momentum_space,
    "The caption over momentum space",
);

/// All objects, in the order in which they are added.
pub static OBJECTS: &[Object] = &[
    object(
        "shadow",
        "Shadow",
        World,
        true,
        floor::shadow,
        "What the body would throw on the floor in light from above",
    ),
    object(
        "plane",
        "Invariable plane",
        World,
        true,
        floor::plane,
        "The floor: the plane across L on which the ellipsoid of inertia rolls",
    ),
    object(
        "way",
        "Way round it turns",
        World,
        false,
        way::draw,
        "A bent arrow on the floor: the way round the body turns, which never changes",
    ),
    object(
        "annulus",
        "Annulus of the herpolhode",
        World,
        false,
        floor::annulus,
        "The ring of the plane within which the herpolhode stays",
    )
    .with(Role::OnPlane),
    object(
        "herpolhode",
        "Herpolhode",
        World,
        false,
        floor::herpolhode,
        "The path of the point of contact on the plane",
    )
    .with(Role::OnPlane),
    object(
        "rolling-ellipsoid",
        "Poinsot's rolling ellipsoid",
        World,
        false,
        floor::rolling_ellipsoid,
        "The ellipsoid of inertia, which rolls on the plane without slipping",
    )
    .with(Role::RollingEllipsoid),
    object(
        "rolling-sphere",
        "Rolling momentum sphere",
        World,
        false,
        body_axes::carried_sphere,
        "The momentum sphere carried by the body, with the polhode on it",
    )
    .with(Role::MomentumSphere),
    object(
        "axis-trail",
        "Trail of the spin axis",
        World,
        false,
        body_axes::trail,
        "The path of the tip of the axis that the body was spun about",
    ),
    object(
        "axis-1-trail",
        "Trail of axis 1",
        World,
        false,
        body_axes::trail_of_axis::<0>,
        "The path of the tip of the axis of the smallest moment",
    ),
    object(
        "axis-2-trail",
        "Trail of axis 2",
        World,
        false,
        body_axes::trail_of_axis::<1>,
        "The path of the tip of the axis of the middle moment",
    ),
    object(
        "axis-3-trail",
        "Trail of axis 3",
        World,
        false,
        body_axes::trail_of_axis::<2>,
        "The path of the tip of the axis of the largest moment",
    ),
    BODY,
    AXIS_NAMES,
    ENDS,
    BODY_AXES,
    object(
        "ghosts",
        "Bodies of the other methods",
        World,
        true,
        ghosts::bodies,
        "The bodies of the methods that are compared, seen through",
    ),
    object(
        "cloud-bodies",
        "Bodies of the cloud",
        World,
        false,
        cloud::bodies,
        "A handful of bodies that started close together, seen through",
    ),
    TURN,
    MOMENTUM,
    object(
        "omega",
        "Angular velocity ω",
        World,
        true,
        vectors::angular_velocity,
        "The arrow of the angular velocity, which swings about L",
    ),
    WORLD_NOTES,
    FLIP_NOTES,
    object(
        "sphere",
        "Sphere |M| = |L|",
        Momentum,
        true,
        surfaces::sphere,
        "The sphere that the tip of M cannot leave, for |M| stays the same",
    ),
    ELLIPSOID,
    object(
        "still-body",
        "Body, standing still",
        Momentum,
        false,
        body::still,
        "The body as one sees it who sits on it, in the middle of the sphere",
    ),
    AXES,
    MOMENTS,
    HEIGHTS,
    object(
        "level-sets",
        "Levels of the energy",
        Momentum,
        true,
        level_sets::draw,
        "The paths of M at other energies, on the sphere",
    ),
    RINGS,
    SEPARATRIX,
    object(
        "flow",
        "Flow",
        Momentum,
        false,
        flow::draw,
        "Arrowheads that run along the levels of the energy as M would there",
    ),
    object(
        "solid-angle",
        "Solid angle of M's path",
        Momentum,
        false,
        turn::solid_angle,
        "The part of the sphere that M goes round, and its solid angle",
    ),
    POLES,
    object(
        "cloud",
        "Cloud of starts",
        Momentum,
        false,
        cloud::points,
        "Starts close together round each axis, all followed exactly",
    ),
    POLHODE,
    object(
        "loupe",
        "Axis 2, magnified",
        Momentum,
        false,
        loupe::draw,
        "The end of axis 2 as through a magnifying glass, where M's path passes it too near for the eye",
    ),
    object(
        "ghost-marks",
        "M of the other methods",
        Momentum,
        true,
        ghosts::marks,
        "The tips of M of the methods that are compared",
    ),
    object(
        "track",
        "Way of M since the start",
        Momentum,
        false,
        track::draw,
        "The way of M since the start: where energy is lost a spiral from ring to ring",
    ),
    object("tail", "Tail of M", Momentum, true, tip::tail, "The way that the tip of M has just come"),
    TIP,
    MOMENTUM_NOTES,
];

/// Looks an object up by its name.
#[must_use]
pub fn object_named(name: &str) -> Option<&'static Object> {
    OBJECTS.iter().find(|object| object.name == name)
}

/// Whether a view's settings show an object. What is hidden by name stays hidden, whatever else is said; its own name goes before
/// that of all.
#[must_use]
pub fn is_shown(object: &Object, view: &scene::View) -> bool {
    let holds = |names: &[String], name: &str| names.iter().any(|other| other == name);
    if holds(&view.hide, object.name) {
        return false;
    }
    let is_usual = (object.shown || holds(&view.show, ALL)) && !holds(&view.hide, ALL);
    is_usual || holds(&view.show, object.name)
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

#[cfg(test)]
mod tests {
    use super::{OBJECTS, Role, TIP, items, object_named};
    use crate::scene::{Scene, SceneError, SceneFile};

    #[test]
    fn the_table_names_each_object_once_and_explains_it() {
        for (number, object) in OBJECTS.iter().enumerate() {
            assert!(OBJECTS[..number].iter().all(|other| other.name != object.name), "{} stands twice", object.name);
            assert!(!object.about.is_empty() && !object.about.ends_with('.'), "{}: {}", object.name, object.about);
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
        let shown = |file: &SceneFile| -> Result<Vec<&str>, SceneError> {
            let items = items(&Scene::check(file)?.view);
            Ok(items.into_iter().filter_map(|(object, is_shown)| is_shown.then_some(object.name)).collect())
        };
        let alone = SceneFile::parse("view = { hide = ['all', 'tip'], show = ['annulus', 'tip'] }")?;
        assert_eq!(shown(&alone)?, ["annulus"]);
        let all = SceneFile::parse("view = { show = ['all'], hide = ['tip'] }")?;
        assert_eq!(shown(&all)?.len(), OBJECTS.len() - 1);
        let items = items(&Scene::check(&file)?.view);
        assert_eq!(items.len(), OBJECTS.len());
        for (object, is_shown) in items {
            let expected = object.name == "annulus" || object.shown && object.name != "tip";
            assert_eq!(is_shown, expected, "{}", object.name);
        }
        Ok(())
    }
}
