//! Reading a scene file by the table of keys: one sentence with the line where it is none.

use toml::de::DeTable;

use super::field::Wrong;
use super::keys::{KEYS, Key, SOLID_KEYS, STEP_KEYS, inside, key, keys_of};
use super::nearest::nearest;
use super::value::{Entry, Item, Value, entries, shortened};
use super::{SceneError, SceneFile, SolidFile, StepFile};

/// The keys without which a solid is none.
const NEEDED: [&str; 2] = ["kind", "size"];

impl SceneFile {
    /// Reads TOML.
    ///
    /// # Errors
    /// Text that is no TOML, a value of the wrong type, or an unknown key: one sentence with the line and, for a
    /// key, the nearest known one.
    pub fn parse(text: &str) -> Result<Self, SceneError> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut file = Self::default();
        read_into(text, &mut file)
            .map_err(|Wrong { start, message }| SceneError::NotAScene { line: line_of(text, start), message })?;
        Ok(file)
    }
}

/// The line, from 1, of a byte of a text.
fn line_of(text: &str, start: usize) -> usize {
    1 + text.bytes().take(start).filter(|byte| *byte == b'\n').count()
}

/// Reads TOML into a file, and gives the keys that it fills, in the order in which they stand.
pub(super) fn read_into(text: &str, file: &mut SceneFile) -> Result<Vec<&'static Key>, Wrong> {
    let document = DeTable::parse(text).map_err(|error| {
        let span = error.span().unwrap_or_default();
        Wrong { start: span.start, message: syntax(error.message(), text.get(span).unwrap_or_default()) }
    })?;
    let mut filled = vec![];
    read_table("", entries(document.get_ref()), file, &mut filled)?;
    Ok(filled)
}

/// Reads the entries of the table of this name; the top of the file has none.
fn read_table(
    table: &str,
    entries: Vec<Entry>,
    file: &mut SceneFile,
    filled: &mut Vec<&'static Key>,
) -> Result<(), Wrong> {
    for Entry { key: own, start, item } in entries {
        let name = if table.is_empty() { own.clone() } else { format!("{table}.{own}") };
        // A quoted key may hold a point, which names no table.
        let row = key(&name).filter(|_| !own.contains('.'));
        let is_table = !own.contains('.') && keys_of(&name).next().is_some();
        match (row, item.value) {
            (None, _) if key(&name).is_some() => {
                return Err(Wrong { start, message: format!("the key {name} stands in quotes: leave them out") });
            }
            (None, _) if !is_table => return Err(Wrong { start, message: unknown(&name) }),
            (_, Value::Table(parts)) if is_table => read_table(&name, parts, file, filled)?,
            (Some(row), value) => {
                if filled.iter().any(|before| before.name == row.name) {
                    let message = format!("{} and {} say the same: leave one out", row.name, row.other_name);
                    return Err(Wrong { start, message });
                }
                row.read(Some(&Item { value, start: item.start }), file)?;
                filled.push(row);
            }
            (None, value) => {
                let message = format!("{name} is {}: it must be a table", value.described());
                return Err(Wrong { start, message });
            }
        }
    }
    Ok(())
}

/// Reads a solid that stands at this byte.
pub(super) fn solid(entries: &[Entry], start: usize) -> Result<SolidFile, Wrong> {
    let mut solid = SolidFile::default();
    read_one("body.solids.", entries, SOLID_KEYS, &mut solid)?;
    match NEEDED.into_iter().find(|needed| entries.iter().all(|entry| entry.key != *needed)) {
        Some(needed) => Err(Wrong { start, message: format!("this solid has no {needed}: every solid needs one") }),
        None => Ok(solid),
    }
}

/// Reads a step.
pub(super) fn step(entries: &[Entry]) -> Result<StepFile, Wrong> {
    let mut step = StepFile::default();
    read_one("step.", entries, STEP_KEYS, &mut step)?;
    Ok(step)
}

/// Reads a table that is one of a list, by the keys whose names begin so.
fn read_one<Holder>(prefix: &str, entries: &[Entry], keys: &[Key<Holder>], holder: &mut Holder) -> Result<(), Wrong> {
    for Entry { key: own, start, item } in entries {
        let name = format!("{prefix}{own}");
        let parts = format!("{name}.");
        let is_known = |key: &&Key<Holder>| key.name == name && !own.contains('.');
        match (&item.value, keys.iter().find(is_known)) {
            (Value::Table(entries), _) if keys.iter().any(|key| key.name.starts_with(&parts)) => {
                read_one(&parts, entries, keys, holder)?;
            }
            (_, Some(key)) => key.read(Some(item), holder)?,
            (_, None) => {
                let mut known: Vec<&str> =
                    keys.iter().filter_map(|key| key.name.strip_prefix(prefix)?.split('.').next()).collect();
                known.dedup();
                return Err(Wrong { start: *start, message: unknown_among(own, prefix, known) });
            }
        }
    }
    Ok(())
}

/// What is said of a key that is none.
pub(super) fn unknown(name: &str) -> String {
    if let Some((table, own)) = inside(name) {
        return format!(
            "`{name}` is a key inside of [[{table}]]: they are given all at once, as in {table}=[{{ {own} = … }}]"
        );
    }
    let own = name.rsplit('.').next().unwrap_or(name);
    // The same word in another table is what was meant, else a word like it in this one.
    if let Some(meant) = KEYS.iter().find(|key| key.own_name() == own) {
        return format!("unknown key `{}`; the nearest known key is `{}`", shortened(name), meant.name);
    }
    let mut prefix = String::new();
    for part in name.split('.') {
        let mut known: Vec<&str> =
            KEYS.iter().filter_map(|key| key.name.strip_prefix(&prefix)?.split('.').next()).collect();
        known.dedup();
        if !known.contains(&part) {
            return unknown_among(part, &prefix, known);
        }
        prefix = format!("{prefix}{part}.");
    }
    format!("unknown key `{}`", shortened(name))
}

/// The same, where these are the keys of its table.
fn unknown_among<'a>(own: &str, prefix: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    let known: Vec<&str> = known.into_iter().collect();
    let given = format!("unknown key `{prefix}{}`", shortened(own));
    match nearest(own, known.iter().copied()) {
        _ if known.is_empty() => format!("{given}; `{}` has no keys of its own here", prefix.trim_end_matches('.')),
        Some(name) => format!("{given}; the nearest known key is `{prefix}{name}`"),
        None => format!("{given}; known here are {}", known.join(", ")),
    }
}

/// What the reader of TOML says of this piece of a text, on one line.
fn syntax(message: &str, piece: &str) -> String {
    let word = shortened(piece.split(char::is_whitespace).next().unwrap_or_default());
    if message.starts_with("duplicate key") {
        return format!("the key `{word}` stands here a second time");
    }
    // A word without quotes is taken for a number or for true and false, whichever its first letter allows.
    if piece.starts_with(char::is_alphabetic)
        && ["invalid boolean", "string values"].iter().any(|of| message.starts_with(of))
    {
        return format!("`{word}` is no value: a text stands in quotes");
    }
    message.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::SceneFile;
    use crate::scene::{CameraFile, Layout, PartKind, SceneError, SolidFile, Theme};

    fn said(text: &str) -> String {
        SceneFile::parse(text).map_or_else(|error| error.to_string(), |file| format!("{file:?}"))
    }

    #[test]
    fn every_key_is_read() -> Result<(), SceneError> {
        let text = r#"
title = "A"
text = """
B \
C"""
question = 'D'
order = -3
[body]
box = [1, 2.5, 3e2]
mass = 0x10
moments = [1, 2, 3]
inertia = [1, 2, 3, 4, 5, 6]
form = "ellipsoid"
[[body.solids]]
kind = "cylinder"
size = [1, 1, 2]
[[body.solids]]
kind = "box"
size = [1, 2, 3]
position = [4, 5, 6]
rotation_deg = [7, 8, 9]
density = 10
[spin]
omega = [1, 2, 3]
axis = 3
tilt_deg = 1_000.5
rate = -inf
attitude = [1, 2, 3, 4]
[motion]
method = "buss"
step = 1
compare = ["rk4", "x"]
energy_loss = 0.5
[cloud]
count = 7
spread_deg = 2
axes = [2, 3]
[view]
layout = "world"
theme = "light"
show = ["a"]
hide = ["b", "c"]
labels = false
font_scale = 2
azimuth_deg = 3
elevation_deg = 4
distance = 5
world_camera = { azimuth_deg = 1, target = [1, 2, 3] }
[view.body_camera]
elevation_deg = 2
distance = 3
"#;
        let file = SceneFile::parse(text)?;
        assert_eq!((&*file.title, &*file.text, &*file.question, file.order), ("A", "B C", "D", Some(-3)));
        let body = &file.body;
        assert_eq!((body.edges, body.mass), (Some([1.0, 2.5, 300.0]), Some(16.0)));
        assert_eq!((body.moments, body.form), (Some([1.0, 2.0, 3.0]), Some(PartKind::Ellipsoid)));
        assert_eq!(body.inertia, Some([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]));
        let first = SolidFile {
            kind: PartKind::Cylinder,
            size: [1.0, 1.0, 2.0],
            position: [0.0; 3],
            rotation_deg: [0.0; 3],
            density: 1000.0,
        };
        let second = SolidFile {
            kind: PartKind::Box,
            size: [1.0, 2.0, 3.0],
            position: [4.0, 5.0, 6.0],
            rotation_deg: [7.0, 8.0, 9.0],
            density: 10.0,
        };
        assert_eq!(body.solids, [first, second]);
        let spin = &file.spin;
        assert_eq!((spin.omega, spin.axis, spin.tilt_deg), (Some([1.0, 2.0, 3.0]), Some(3), Some(1000.5)));
        assert_eq!((spin.rate, spin.attitude), (Some(f64::NEG_INFINITY), Some([1.0, 2.0, 3.0, 4.0])));
        let motion = &file.motion;
        assert_eq!((motion.method.as_deref(), motion.step), (Some("buss"), Some(1.0)));
        assert_eq!((&motion.compare[..], motion.energy_loss), (&["rk4".to_owned(), "x".to_owned()][..], Some(0.5)));
        let cloud = &file.cloud;
        assert_eq!((cloud.count, cloud.spread_deg, &cloud.axes[..]), (Some(7), Some(2.0), &[2, 3][..]));
        let view = &file.view;
        assert_eq!((view.layout, view.theme, view.labels), (Some(Layout::World), Some(Theme::Light), Some(false)));
        assert_eq!((&view.show[..], &view.hide[..]), (&["a".to_owned()][..], &["b".to_owned(), "c".to_owned()][..]));
        assert_eq!((view.font_scale, view.azimuth_deg), (Some(2.0), Some(3.0)));
        assert_eq!((view.elevation_deg, view.distance), (Some(4.0), Some(5.0)));
        let world = CameraFile { azimuth_deg: Some(1.0), target: Some([1.0, 2.0, 3.0]), ..CameraFile::default() };
        let momentum = CameraFile { elevation_deg: Some(2.0), distance: Some(3.0), ..CameraFile::default() };
        assert_eq!((view.world_camera, view.body_camera), (world, momentum));
        Ok(())
    }

    #[test]
    fn what_earlier_files_say_is_read() -> Result<(), SceneError> {
        let file = SceneFile::parse(
            "\u{feff}[view]\r\nazimuth = 1\r\nelevation = 2\r\nworld_camera = [1, 2, 3, 4, 5, 6]\r\n",
        )?;
        assert_eq!((file.view.azimuth_deg, file.view.elevation_deg), (Some(1.0), Some(2.0)));
        let camera = CameraFile {
            azimuth_deg: Some(1.0),
            elevation_deg: Some(2.0),
            distance: Some(3.0),
            target: Some([4.0, 5.0, 6.0]),
        };
        assert_eq!(file.view.world_camera, camera);
        assert_eq!(
            said("view.azimuth = 1\nview.azimuth_deg = 2"),
            "line 2: view.azimuth_deg and view.azimuth say the same: leave one out"
        );
        Ok(())
    }

    #[test]
    fn a_value_that_is_not_taken_is_refused_in_the_words_of_the_file() {
        for (text, sentence) in [
            (
                "[body]\nmoments = [1, 2, 3, 4]",
                "line 2: body.moments is an array of 4: it must be an array of 3 numbers (kg m²)",
            ),
            ("body.box = [1, 2]", "line 1: body.box is an array of 2: it must be an array of 3 numbers (m)"),
            (
                "\n\nbody.inertia = [1, 2, 3]",
                "line 3: body.inertia is an array of 3: it must be an array of 6 numbers (kg m²)",
            ),
            (
                "body.box = [1,\n2,\n'a']",
                "line 3: body.box is an array with the text \"a\" in it: it must be an array of 3 numbers (m)",
            ),
            ("body.box = 1", "line 1: body.box is the number 1: it must be an array of 3 numbers (m)"),
            ("body.box = { a = 1 }", "line 1: body.box is a table: it must be an array of 3 numbers (m)"),
            ("spin.rate = 1979-05-27", "line 1: spin.rate is the date 1979-05-27: it must be a number (rad/s)"),
            ("spin.rate = 07:32:00", "line 1: spin.rate is the date 07:32:00: it must be a number (rad/s)"),
            ("spin.rate = 'fast'", "line 1: spin.rate is the text \"fast\": it must be a number (rad/s)"),
            ("spin.rate = true", "line 1: spin.rate is true: it must be a number (rad/s)"),
            (
                "spin.rate = 1e400",
                "line 1: spin.rate is the number 1e400, past the range of numbers: it must be a number (rad/s)",
            ),
            ("spin.axis = 4", "line 1: spin.axis is the number 4: it must be 1 (smallest moment), 2 or 3 (largest)"),
            ("spin.axis = 0", "line 1: spin.axis is the number 0: it must be 1 (smallest moment), 2 or 3 (largest)"),
            (
                "spin.axis = 2.5",
                "line 1: spin.axis is the number 2.5: it must be 1 (smallest moment), 2 or 3 (largest)",
            ),
            (
                "spin.rate = 1e-400",
                "line 1: spin.rate is the number 1e-400, past the range of numbers: it must be a number (rad/s)",
            ),
            ("spin.attitude = [1, 0, 0]", "line 1: spin.attitude is an array of 3: it must be an array of 4 numbers"),
            ("order = 1.5", "line 1: order is the number 1.5: it must be a whole number"),
            ("title = 3", "line 1: title is the number 3: it must be a text in quotes"),
            (
                "motion.compare = ['rk4', 3]",
                "line 1: motion.compare is an array with the number 3 in it: it must be an array of names in quotes",
            ),
            (
                "motion.compare = 'rk4'",
                "line 1: motion.compare is the text \"rk4\": it must be an array of names in quotes",
            ),
            ("view.labels = 1", "line 1: view.labels is the number 1: it must be true or false"),
            ("view.theme = 'drak'", "line 1: view.theme is the text \"drak\": it must be dark or light"),
            ("view.layout = 2", "line 1: view.layout is the number 2: it must be both, world or body"),
            (
                "view.world_camera = [1, 2]",
                "line 1: view.world_camera is an array of 2: it must be an array of 6 numbers",
            ),
            (
                "view.body_camera.target = [1, 2]",
                "line 1: view.body_camera.target is an array of 2: it must be an array of 3 numbers",
            ),
            ("spin = 3", "line 1: spin is the number 3: it must be a table"),
            ("[[spin]]\nrate = 3", "line 1: spin is an array of 1: it must be a table"),
        ] {
            assert_eq!(said(text), sentence, "{text}");
        }
    }

    #[test]
    fn what_is_no_scene_is_refused_in_one_sentence_with_its_line() {
        for (text, sentence) in [
            // Solids.
            (
                "[body]\nsolids = []",
                "line 2: body.solids is an array of 0: it must be an array of solids, one at least",
            ),
            (
                "body.solids = [3]",
                "line 1: body.solids is an array with the number 3 in it: it must be an array of solids, one at least",
            ),
            ("[[body.solids]]\nkind = 'box'", "line 1: this solid has no size: every solid needs one"),
            ("[[body.solids]]\nsize = [1, 1, 1]", "line 1: this solid has no kind: every solid needs one"),
            (
                "[[body.solids]]\nkind = 'ball'\nsize = [1, 1, 1]",
                "line 2: body.solids.kind is the text \"ball\": it must be box, cylinder or ellipsoid",
            ),
            (
                "[[body.solids]]\nkind = 'box'\nsize = [1, 1]",
                "line 3: body.solids.size is an array of 2: it must be an array of 3 numbers (m)",
            ),
            (
                "[[body.solids]]\nkind = 'box'\nsize = [1, 1, 1]\nposn = 1",
                "line 4: unknown key `body.solids.posn`; known here are kind, size, position, rotation_deg, density",
            ),
            (
                "[[body.solids]]\npositon = 1",
                "line 2: unknown key `body.solids.positon`; the nearest known key is `body.solids.position`",
            ),
            // Keys.
            ("[spn]\nrate = 1", "line 1: unknown key `spn`; the nearest known key is `spin`"),
            ("[spin]\nrat = 1", "line 2: unknown key `spin.rat`; the nearest known key is `spin.rate`"),
            ("rate = 1", "line 1: unknown key `rate`; the nearest known key is `spin.rate`"),
            (
                "xyz = 1",
                "line 1: unknown key `xyz`; known here are title, text, question, answer, order, body, spin, motion, cloud, view, step",
            ),
            (
                "view.world_camera.azimut_deg = 1",
                "line 1: unknown key `view.world_camera.azimut_deg`; the nearest known key is `view.world_camera.azimuth_deg`",
            ),
            (
                "view.world_camera.q = 1",
                "line 1: unknown key `view.world_camera.q`; known here are azimuth_deg, elevation_deg, distance, target",
            ),
            ("'spin.rate' = 1", "line 1: the key spin.rate stands in quotes: leave them out"),
            ("'spin.rat' = 1", "line 1: unknown key `spin.rat`; the nearest known key is `spin.rate`"),
            (
                "\"a\\nb\" = 1",
                "line 1: unknown key `a\\nb`; known here are title, text, question, answer, order, body, spin, motion, cloud, view, step",
            ),
            ("spin.rate.x = 1", "line 1: spin.rate is a table: it must be a number (rad/s)"),
            // TOML.
            ("[spin]\nrate = 1\n\nrate = 2", "line 4: the key `rate` stands here a second time"),
            ("[spin]\n[spin]", "line 2: the key `spin` stands here a second time"),
            ("spin.rate = fast", "line 1: `fast` is no value: a text stands in quotes"),
            ("motion.method = buss # the second order", "line 1: `buss` is no value: a text stands in quotes"),
            ("a = [1,", "line 1: unclosed array, expected `]`"),
        ] {
            assert_eq!(said(text), sentence, "{text}");
        }
    }

    #[test]
    fn a_long_word_is_cut_in_a_message() {
        let long = "x".repeat(1_000_000);
        assert_eq!(
            said(&format!("spin.rate = '{long}'")),
            format!("line 1: spin.rate is the text \"{}…\": it must be a number (rad/s)", "x".repeat(40))
        );
        assert!(said(&format!("{long} = 1")).len() < 200);
    }

    #[test]
    fn depth_is_bounded() {
        for text in [
            "a = ".to_owned() + &"[".repeat(100_000),
            "a = ".to_owned() + &"{a=".repeat(100_000),
            "a.".repeat(100_000) + "a = 1",
        ] {
            assert!(said(&text).starts_with("line 1: "));
        }
    }
}
