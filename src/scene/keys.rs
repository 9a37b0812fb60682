//! The table of keys: whatever a scene can say, with its type, unit, flag and help. Scene files are read and written
//! by it, flags and links are made of it.

use super::field::{Field, Kind, Refused, Wrong};
use super::value::{Item, Value};
use super::{SceneFile, SolidFile, StepFile};

/// A key of a scene file.
#[derive(Clone, Copy, Debug)]
pub struct Key<Holder: 'static = SceneFile> {
    /// Its name from the top of the file: `spin.tilt_deg`.
    pub name: &'static str,
    /// What kind of value it takes.
    pub kind: Kind,
    /// The unit of its numbers; empty where there is none.
    pub unit: &'static str,
    /// What it says, in one line.
    pub help: &'static str,
    /// The flag of the command line that says the same.
    pub flag: Option<Flag>,
    /// Whether it says in short what other keys say one by one: it is read, and never written to a file.
    pub(super) is_short: bool,
    /// Another name, of files written earlier.
    pub(super) other_name: &'static str,
    /// The keys whose place it takes where a flag, `--set` or a link gives it.
    pub(super) replaces: &'static [&'static str],
    /// The list from which a name goes that its flag adds to this one; empty where its flag takes the whole list's place.
    pub(super) opposite: &'static str,
    read: fn(Option<&Item>, &mut Holder) -> Result<(), Refused>,
    get: fn(&Holder) -> Option<Value>,
    copy: fn(&Holder, &mut Holder),
}

/// A flag that says what a key says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Flag {
    /// Its name without the dashes.
    pub name: &'static str,
    /// What its value is called.
    pub value: &'static str,
    /// What it says, where the key's help is not the right one.
    pub help: &'static str,
}

impl<Holder> Key<Holder> {
    /// The last part of its name: the key in its own table.
    #[must_use]
    pub fn own_name(&self) -> &'static str {
        self.name.rsplit('.').next().unwrap_or(self.name)
    }

    /// What a file says under this key; nothing where it is left out.
    #[must_use]
    pub fn get(&self, file: &Holder) -> Option<Value> {
        (self.get)(file)
    }

    /// Takes what one file says under this key over into another.
    pub(super) fn copy(&self, from: &Holder, to: &mut Holder) {
        (self.copy)(from, to);
    }

    /// Reads a value, or takes away what is there.
    pub(super) fn read(&self, item: Option<&Item>, file: &mut Holder) -> Result<(), Wrong> {
        (self.read)(item, file).map_err(|refused| match refused {
            Refused::Wrong(wrong) => wrong,
            Refused::Kind(what, start) => Wrong { start, message: self.refused(&what) },
        })
    }

    /// What is said of a value that is this and not what the key takes.
    pub(super) fn refused(&self, what: &str) -> String {
        let unit = if self.unit.is_empty() { String::new() } else { format!(" ({})", self.unit) };
        format!("{} is {what}: it must be {}{unit}", self.name, self.kind.words())
    }

    const fn flag(self, name: &'static str, value: &'static str) -> Self {
        let help = self.help;
        self.flag_saying(name, value, help)
    }

    const fn flag_saying(mut self, name: &'static str, value: &'static str, help: &'static str) -> Self {
        self.flag = Some(Flag { name, value, help });
        self
    }

    const fn in_short(mut self) -> Self {
        self.is_short = true;
        self
    }

    const fn once(mut self, name: &'static str) -> Self {
        self.other_name = name;
        self
    }

    const fn in_place_of(mut self, names: &'static [&'static str]) -> Self {
        self.replaces = names;
        self
    }

    const fn against(mut self, name: &'static str) -> Self {
        self.opposite = name;
        self
    }
}

/// The kind of a field.
const fn kind<Holder, Of: Field>(_: fn(&Holder) -> &Of) -> Kind {
    Of::KIND
}

/// A row: the key's name, the field that it fills, its unit and what it says.
macro_rules! key {
    ($holder:ty, $name:literal, $($field:ident).+, $unit:literal, $help:literal) => {
        Key::<$holder> {
            name: $name,
            kind: kind(|file: &$holder| &file.$($field).+),
            unit: $unit,
            help: $help,
            flag: None,
            is_short: false,
            other_name: "",
            replaces: &[],
            opposite: "",
            read: |item: Option<&Item>, file: &mut $holder| {
                file.$($field).+ = match item {
                    Some(item) => Field::read(item)?,
                    None => Default::default(),
                };
                Ok(())
            },
            get: |file: &$holder| Field::get(&file.$($field).+),
            copy: |from: &$holder, to: &mut $holder| to.$($field).+.clone_from(&from.$($field).+),
        }
    };
    ($name:literal, $($field:ident).+, $unit:literal, $help:literal) => {
        key!(SceneFile, $name, $($field).+, $unit, $help)
    };
}

/// Whatever a scene file can say, in the order in which it is written.
pub static KEYS: &[Key] = &[
    key!("title", title, "", "Name of the slide, in a few words"),
    key!("text", text, "", "Two or three sentences"),
    key!("question", question, "", "A question to the class"),
    key!("answer", answer, "", "Its answer, which is shown when it is asked for"),
    key!("order", order, "", "Place among the scenes, ascending"),
    key!("body.box", body.edges, "m", "Edges of a solid box along the body's axes")
        .flag("box", "A,B,C")
        .in_place_of(&["body.mass", "body.moments", "body.inertia", "body.form", "body.solids"]),
    key!("body.mass", body.mass, "kg", "Mass of the box").flag("mass", "KG"),
    key!("body.moments", body.moments, "kg m²", "Principal moments in the order of the body's axes")
        .flag("moments", "I1,I2,I3")
        .in_place_of(&["body.box", "body.mass", "body.inertia", "body.form", "body.solids"]),
    key!("body.inertia", body.inertia, "kg m²", "Inertia tensor in the body frame: xx, yy, zz, xy, xz, yz")
        .flag_saying("inertia", "XX,YY,ZZ,XY,XZ,YZ", "Inertia tensor in the body frame")
        .in_place_of(&["body.box", "body.mass", "body.moments", "body.form", "body.solids"]),
    key!("body.form", body.form, "", "What is drawn of moments or an inertia: the solid of this form that has them"),
    key!("body.solids", body.solids, "", "Solids that move as one").in_place_of(&[
        "body.box",
        "body.mass",
        "body.moments",
        "body.inertia",
        "body.form",
    ]),
    key!("spin.omega", spin.omega, "rad/s", "Angular velocity at the start in the body frame")
        .flag("omega", "X,Y,Z")
        .in_place_of(&["spin.axis", "spin.tilt_deg", "spin.rate"]),
    key!("spin.axis", spin.axis, "", "Principal axis to spin about: 1 has the smallest moment, 3 the largest")
        .flag("axis", "1|2|3")
        .in_place_of(&["spin.omega"]),
    key!("spin.tilt_deg", spin.tilt_deg, "degrees", "Tilt of the spin from that axis towards the next")
        .flag("tilt", "DEG")
        .in_place_of(&["spin.omega"]),
    key!("spin.rate", spin.rate, "rad/s", "Speed of the spin").flag("rate", "RAD_S").in_place_of(&["spin.omega"]),
    key!("spin.attitude", spin.attitude, "", "Attitude at the start, a quaternion w, x, y, z (made unit)"),
    key!("motion.method", motion.method, "", "Method that follows the motion (`dzhanibekov methods` lists them)")
        .flag("method", "NAME"),
    key!("motion.step", motion.step, "s", "Step of the method").flag("step", "S"),
    key!("motion.compare", motion.compare, "", "Methods run beside it from the same start").flag_saying(
        "compare",
        "NAME,NAME",
        "Methods run beside it from the same start, each once; '' for none",
    ),
    key!(
        "motion.energy_loss",
        motion.energy_loss,
        "",
        "Energy lost inside the body at constant L, a number without a unit (0.02: in tens of turns); followed by `magnus4`"
    )
    .flag("energy-loss", "X"),
    key!("cloud.count", cloud.count, "", "How many starts close together the cloud is made of, in all"),
    key!("cloud.spread_deg", cloud.spread_deg, "degrees", "How far from their axis they are at most"),
    key!("cloud.axes", cloud.axes, "", "The principal axes round which they are; all three where left out"),
    key!("view.layout", view.layout, "", "Which spaces to show").flag("view", "both|world|body"),
    key!("view.show", view.show, "", "Objects to show besides the default ones (`dzhanibekov objects` lists them)")
        .flag("show", "NAME,…")
        .against("view.hide"),
    key!("view.hide", view.hide, "", "Objects to hide").flag("hide", "NAME,…").against("view.show"),
    key!("view.theme", view.theme, "", "Colours for a dark hall, or for bright rooms and print")
        .flag("theme", "dark|light"),
    key!("view.time_unit", view.time_unit, "", "What a unit of time is called on the screen: s (seconds) or d (days)"),
    key!("view.labels", view.labels, "", "Names beside things").flag("labels", "on|off"),
    key!("view.font_scale", view.font_scale, "", "Factor on the size of text and the width of lines")
        .flag("font-scale", "X"),
    key!("view.slow_at_flip", view.slow_at_flip, "", "Whether the clock slows round each flip"),
    key!("view.azimuth_deg", view.azimuth_deg, "degrees", "Camera's direction round the vertical")
        .flag("azimuth", "DEG")
        .once("view.azimuth"),
    key!("view.elevation_deg", view.elevation_deg, "degrees", "Camera's height above the horizon")
        .flag("elevation", "DEG")
        .once("view.elevation"),
    key!("view.distance", view.distance, "", "Camera's distance, a factor on the one that frames everything")
        .flag("distance", "X"),
    key!("view.world_camera", view.world_camera, "", "Camera of the world alone in short: the four keys below")
        .flag_saying(
            "world-camera",
            "DEG,DEG,X,X,Y,Z",
            "Camera of the world alone: azimuth, elevation, distance, and the point looked at",
        )
        .in_short(),
    key!(
        "view.world_camera.azimuth_deg",
        view.world_camera.azimuth_deg,
        "degrees",
        "Direction of the world's camera round the vertical"
    ),
    key!(
        "view.world_camera.elevation_deg",
        view.world_camera.elevation_deg,
        "degrees",
        "Height of the world's camera above the horizon"
    ),
    key!(
        "view.world_camera.distance",
        view.world_camera.distance,
        "",
        "Distance of the world's camera, a factor on the one that frames everything"
    ),
    key!(
        "view.world_camera.target",
        view.world_camera.target,
        "",
        "Point that the world's camera looks at; the body is about 1 large"
    ),
    key!("view.body_camera", view.body_camera, "", "Camera of momentum space alone in short: the four keys below")
        .flag_saying("body-camera", "DEG,DEG,X,X,Y,Z", "Camera of momentum space alone, likewise")
        .in_short(),
    key!(
        "view.body_camera.azimuth_deg",
        view.body_camera.azimuth_deg,
        "degrees",
        "Direction of momentum space's camera round the vertical"
    ),
    key!(
        "view.body_camera.elevation_deg",
        view.body_camera.elevation_deg,
        "degrees",
        "Height of momentum space's camera above the horizon"
    ),
    key!(
        "view.body_camera.distance",
        view.body_camera.distance,
        "",
        "Distance of momentum space's camera, a factor on the one that frames everything"
    ),
    key!(
        "view.body_camera.target",
        view.body_camera.target,
        "",
        "Point that momentum space's camera looks at; the sphere has radius 1"
    ),
    key!("step", steps, "", "Steps in which it is told, each a table [[step]]; what one leaves out stays as before"),
];

/// Whatever can be said of one of `body.solids`.
pub static SOLID_KEYS: &[Key<SolidFile>] = &[
    key!(SolidFile, "body.solids.kind", kind, "", "Its form"),
    key!(
        SolidFile,
        "body.solids.size",
        size,
        "m",
        "Full extents along its own axes; a cylinder's are its diameter twice and its length"
    ),
    key!(SolidFile, "body.solids.position", position, "m", "Where its centre is; the origin where left out"),
    key!(
        SolidFile,
        "body.solids.rotation_deg",
        rotation_deg,
        "degrees",
        "How it is turned from the body's axes: a rotation vector"
    ),
    key!(SolidFile, "body.solids.density", density, "kg/m³", "Density; that of water, 1000, where left out"),
];

/// Whatever can be said of one `step`.
pub static STEP_KEYS: &[Key<StepFile>] = &[
    key!(StepFile, "step.title", title, "", "What it is called, after the scene's title"),
    key!(StepFile, "step.text", text, "", "What is said, in place of the scene's text"),
    key!(StepFile, "step.show", show, "", "Objects shown from here on; \"all\" for every one"),
    key!(StepFile, "step.hide", hide, "", "Objects hidden from here on, but for those shown; \"all\" for every one"),
    key!(StepFile, "step.layout", layout, "", "Which spaces to show"),
    key!(StepFile, "step.world_camera", world_camera, "", "Camera of the world in short: the four keys below")
        .in_short(),
    key!(
        StepFile,
        "step.world_camera.azimuth_deg",
        world_camera.azimuth_deg,
        "degrees",
        "As view.world_camera.azimuth_deg"
    ),
    key!(
        StepFile,
        "step.world_camera.elevation_deg",
        world_camera.elevation_deg,
        "degrees",
        "As view.world_camera.elevation_deg"
    ),
    key!(StepFile, "step.world_camera.distance", world_camera.distance, "", "As view.world_camera.distance"),
    key!(StepFile, "step.world_camera.target", world_camera.target, "", "As view.world_camera.target"),
    key!(StepFile, "step.body_camera", body_camera, "", "Camera of momentum space in short: the four keys below")
        .in_short(),
    key!(
        StepFile,
        "step.body_camera.azimuth_deg",
        body_camera.azimuth_deg,
        "degrees",
        "As view.body_camera.azimuth_deg"
    ),
    key!(
        StepFile,
        "step.body_camera.elevation_deg",
        body_camera.elevation_deg,
        "degrees",
        "As view.body_camera.elevation_deg"
    ),
    key!(StepFile, "step.body_camera.distance", body_camera.distance, "", "As view.body_camera.distance"),
    key!(StepFile, "step.body_camera.target", body_camera.target, "", "As view.body_camera.target"),
    key!(StepFile, "step.time", time, "s", "Time that is gone to"),
    key!(StepFile, "step.speed", speed, "", "Simulated seconds a real second; negative runs backwards"),
    key!(StepFile, "step.pause", pause, "", "Whether time stands"),
    key!(StepFile, "step.slow_at_flip", slow_at_flip, "", "Whether the clock slows round each flip"),
];

/// The key of this name, or of this earlier name.
#[must_use]
pub fn key(name: &str) -> Option<&'static Key> {
    KEYS.iter().find(|key| key.name == name || (!key.other_name.is_empty() && key.other_name == name))
}

/// The array of tables, each written `[[…]]`, that the key of this name stands in, and its name there: of `step.time`
/// `step` and `time`.
#[must_use]
pub fn inside(name: &str) -> Option<(&'static str, &str)> {
    let is_known = SOLID_KEYS.iter().any(|key| key.name == name) || STEP_KEYS.iter().any(|key| key.name == name);
    let mut arrays = KEYS.iter().filter(|key| matches!(key.kind, Kind::Solids | Kind::Steps));
    let found = arrays.find_map(|array| Some((array.name, name.strip_prefix(array.name)?.strip_prefix('.')?)));
    found.filter(|_| is_known)
}

/// The keys of the table of this name: `spin`.
pub(super) fn keys_of(table: &str) -> impl Iterator<Item = &'static Key> {
    KEYS.iter().filter(move |key| key.name.strip_prefix(table).is_some_and(|rest| rest.starts_with('.')))
}

#[cfg(test)]
mod tests {
    use super::{KEYS, Key, SOLID_KEYS, STEP_KEYS, inside, key, keys_of};
    use crate::scene::Kind;

    /// The flags that scripts rest on, each with the key that it gives.
    const PROMISED: [(&str, &str); 22] = [
        ("box", "body.box"),
        ("mass", "body.mass"),
        ("moments", "body.moments"),
        ("inertia", "body.inertia"),
        ("omega", "spin.omega"),
        ("axis", "spin.axis"),
        ("tilt", "spin.tilt_deg"),
        ("rate", "spin.rate"),
        ("method", "motion.method"),
        ("step", "motion.step"),
        ("compare", "motion.compare"),
        ("view", "view.layout"),
        ("show", "view.show"),
        ("hide", "view.hide"),
        ("theme", "view.theme"),
        ("labels", "view.labels"),
        ("font-scale", "view.font_scale"),
        ("azimuth", "view.azimuth_deg"),
        ("elevation", "view.elevation_deg"),
        ("distance", "view.distance"),
        ("world-camera", "view.world_camera"),
        ("body-camera", "view.body_camera"),
    ];

    #[test]
    fn every_promised_flag_is_there_and_gives_its_key() {
        for (flag, name) in PROMISED {
            let given: Vec<_> = KEYS.iter().filter(|key| key.flag.is_some_and(|it| it.name == flag)).collect();
            assert!(matches!(given[..], [key] if key.name == name), "--{flag}");
        }
    }

    #[test]
    fn the_table_holds_together() {
        let mut names: Vec<&str> = KEYS.iter().flat_map(|key| [key.name, key.other_name]).collect();
        names.extend(SOLID_KEYS.iter().map(|key| key.name).chain(STEP_KEYS.iter().map(|key| key.name)));
        names.retain(|name| !name.is_empty());
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), count, "a name stands twice");
        for row in KEYS {
            assert!(key(row.name).is_some_and(|found| std::ptr::eq(found, row)));
            assert!(!row.help.is_empty() && !row.help.ends_with('.'), "{}", row.name);
            for other in row.replaces.iter().chain([&row.opposite]).filter(|name| !name.is_empty()) {
                assert!(*other != row.name && key(other).is_some_and(|key| key.name == *other), "{}", row.name);
            }
            // What is said against another list is said against it both ways.
            let opposite = key(row.opposite);
            assert!(opposite.is_none_or(|other| other.opposite == row.name), "{}", row.name);
        }
        // A table is written once, so its keys stand together, and solids last: they open a table of their own.
        let mut tables: Vec<&str> = KEYS.iter().filter_map(|key| key.name.rsplit_once('.')).map(|it| it.0).collect();
        tables.dedup();
        let in_file = ["body", "spin", "motion", "cloud", "view", "view.world_camera", "view", "view.body_camera"];
        assert_eq!(tables, in_file);
        let solids = KEYS.iter().filter(|key| key.kind == Kind::Solids);
        assert!(solids.eq(keys_of("body").last()), "solids are the last of the body");
        assert!(KEYS.last().is_some_and(|key| key.kind == Kind::Steps), "steps are the last of all");
    }

    impl PartialEq for Key {
        fn eq(&self, other: &Self) -> bool {
            self.name == other.name
        }
    }

    #[test]
    fn keys_are_found_by_name_and_by_table() {
        assert_eq!(key("view.azimuth").map(|key| key.name), Some("view.azimuth_deg"));
        assert!(key("").is_none() && key("spin").is_none() && key("rate").is_none());
        assert_eq!(keys_of("spin").count(), 5);
        assert_eq!(keys_of("spi").count(), 0);
        assert_eq!(keys_of("").count(), 0);
        assert_eq!(inside("step.world_camera.distance"), Some(("step", "world_camera.distance")));
        assert_eq!(inside("body.solids.kind"), Some(("body.solids", "kind")));
        assert_eq!((inside("step"), inside("step.tim"), inside("spin.rate")), (None, None, None));
        assert_eq!(key("view.body_camera.target").map(Key::own_name), Some("target"));
        assert_eq!(key("title").map(Key::own_name), Some("title"));
    }

    #[test]
    fn kinds_are_said_in_the_words_of_a_file() {
        for (kind, words) in [
            (Kind::Text, "a text in quotes"),
            (Kind::Number, "a number"),
            (Kind::Numbers(3), "an array of 3 numbers"),
            (Kind::Whole, "a whole number"),
            (Kind::Axis, "1 (smallest moment), 2 or 3 (largest)"),
            (Kind::Switch, "true or false"),
            (Kind::Choice(&["a"]), "a"),
            (Kind::Choice(&["a", "b"]), "a or b"),
            (Kind::Choice(&["a", "b", "c"]), "a, b or c"),
            (Kind::Names, "an array of names in quotes"),
            (Kind::Axes, "an array of axes, each 1 (smallest moment), 2 or 3 (largest)"),
            (Kind::Solids, "an array of solids, one at least"),
            (Kind::Steps, "an array of steps, each a table [[step]]"),
        ] {
            assert_eq!(kind.words(), words);
        }
    }
}
