//! Reading a scene file by the table of keys: one sentence with the line where it is none.

use toml::de::DeTable;

use super::field::Wrong;
use super::keys::{KEYS, Key, SOLID_KEYS, key, keys_of};
use super::value::{Entry, Item, Value, entries, shortened};
use super::{SceneError, SceneFile, SolidFile, nearest};

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
            .map_err(|Wrong { start, message }| SceneError::Text { line: line_of(text, start), message })?;
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
    for entry in entries {
        let Some(key) = SOLID_KEYS.iter().find(|key| key.own_name() == entry.key) else {
            let message = unknown_among(&entry.key, "body.solids.", SOLID_KEYS.iter().map(Key::own_name));
            return Err(Wrong { start: entry.start, message });
        };
        key.read(Some(&entry.item), &mut solid)?;
    }
    match NEEDED.into_iter().find(|needed| entries.iter().all(|entry| entry.key != *needed)) {
        Some(needed) => Err(Wrong { start, message: format!("this solid has no {needed}: every solid needs one") }),
        None => Ok(solid),
    }
}

/// What is said of a key that is none.
pub(super) fn unknown(name: &str) -> String {
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
