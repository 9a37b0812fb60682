//! Writing a scene file by the table of keys.

use super::SceneFile;
use super::keys::KEYS;
use super::value::{Value, escape};

impl SceneFile {
    /// Writes TOML that reads back to the same scene.
    #[must_use]
    pub fn to_toml(&self) -> String {
        let mut toml = String::new();
        let mut open = "";
        for key in KEYS.iter().filter(|key| !key.is_short) {
            let Some(value) = key.get(self) else { continue };
            let (table, own) = key.name.rsplit_once('.').unwrap_or(("", key.name));
            let tables = tables(&value);
            if table != open && tables.is_none() {
                toml.extend(["\n[", table, "]\n"]);
                open = table;
            }
            match (tables, &value) {
                (Some(tables), _) => {
                    for entries in tables {
                        toml.extend(["\n[[", key.name, "]]\n"]);
                        for entry in entries {
                            toml.extend([&entry.key, " = ", &written(&entry.item.value), "\n"]);
                        }
                    }
                    // Whatever follows opens its own table again.
                    open = key.name;
                }
                (None, value) => toml.extend([own, " = ", &written(value), "\n"]),
            }
        }
        toml
    }
}

/// The tables of an array of nothing else.
fn tables(value: &Value) -> Option<Vec<&Vec<super::value::Entry>>> {
    let Value::List(items) = value else { return None };
    let tables = items.iter().map(|item| match &item.value {
        Value::Table(entries) => Some(entries),
        _ => None,
    });
    tables.collect::<Option<Vec<_>>>().filter(|tables| !tables.is_empty())
}

/// A value as it stands in a file.
fn written(value: &Value) -> String {
    match value {
        Value::Text(text) if text.contains('\n') => in_lines(text),
        value => value.to_toml(),
    }
}

/// A text with its line breaks as they are.
fn in_lines(text: &str) -> String {
    let mut toml = "\"\"\"\n".to_owned();
    for character in text.chars() {
        if character == '\n' { toml.push('\n') } else { escape(&mut toml, character) }
    }
    toml.push_str("\"\"\"");
    toml
}

#[cfg(test)]
mod tests {
    use crate::scene::{SceneError, SceneFile};

    #[test]
    fn a_scene_is_written_as_a_person_would() -> Result<(), SceneError> {
        let text = r#"title = "A \"b\""
text = """
First line.
Second \\ \"\"\" line."""
order = 3

[body]
form = "ellipsoid"

[[body.solids]]
kind = "box"
size = [1, 2, 3]
position = [0, 0, 0]
rotation_deg = [0, 0, 0]
density = 1000

[[body.solids]]
kind = "cylinder"
size = [1, 1, 2.5]
position = [0, 0, 1e-9]
rotation_deg = [0, 90, 0]
density = 2700

[spin]
axis = 2
rate = 6

[motion]
compare = ["rk4", "buss"]

[view]
labels = true

[view.world_camera]
azimuth_deg = -60
target = [0, 0, 0.5]

[view.body_camera]
distance = 2
"#;
        let file = SceneFile::parse(text)?;
        assert_eq!(file.to_toml(), text);
        assert_eq!(SceneFile::default().to_toml(), "");
        Ok(())
    }
}
