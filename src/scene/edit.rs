//! What is said over a scene: flags, and `--set KEY=VALUE` for whatever has none. Later wins: file, `--set`, flag.

use super::field::{Kind, Wrong};
use super::keys::{KEYS, Key, key, keys_of};
use super::value::{Item, Value, shortened};
use super::{SceneError, SceneFile, read, word};

/// One flag or `--set` with its value, read.
#[derive(Clone, Debug)]
pub struct Edit {
    /// The keys that it gives or takes away.
    keys: Vec<&'static Key>,
    /// What it says under them.
    said: Box<SceneFile>,
    /// Whether names are added to those that the scene has.
    adds: bool,
}

impl Edit {
    /// Reads `KEY=VALUE`: a key of a scene file by its dotted name, and a value as in TOML. A text needs no quotes; an
    /// empty value takes away what the scene says under the key, or under all keys of a table.
    ///
    /// # Errors
    /// One sentence: no `=`, an unknown key, or a value that is not of the key's type.
    pub fn set(text: &str) -> Result<Self, SceneError> {
        let Some((name, value)) = text.split_once('=') else {
            return Err(SceneError::Edit(format!(
                "`{}` has no value: KEY=VALUE is wanted, as in spin.rate=6",
                shortened(text)
            )));
        };
        Self::key_and_value(name.trim(), value.trim())
    }

    /// The same, with the key and its value apart.
    pub(super) fn key_and_value(name: &str, value: &str) -> Result<Self, SceneError> {
        let wrong = |Wrong { message, .. }| SceneError::Edit(message);
        let row = key(name);
        let mut said = Box::<SceneFile>::default();
        if value.is_empty() {
            let keys: Vec<_> = row.into_iter().chain(keys_of(name)).collect();
            if keys.is_empty() {
                return Err(SceneError::Edit(read::unknown(name)));
            }
            return Ok(Self { keys, said, adds: false });
        }
        if let Some(row) = row
            && matches!(row.kind, Kind::Text | Kind::Choice(_))
            && !value.starts_with(['"', '\''])
        {
            row.read(Some(&Value::Text(value.to_owned()).into()), &mut said).map_err(wrong)?;
            return Ok(Self { keys: vec![row], said, adds: false });
        }
        if row.is_none() && keys_of(name).next().is_none() {
            return Err(SceneError::Edit(read::unknown(name)));
        }
        if let (Some(row), Err(_)) = (row, toml::de::DeValue::parse(value)) {
            let what = format!("`{}`", shortened(value));
            return Err(SceneError::Edit(row.refused(&what)));
        }
        let keys = read::read_into(&format!("{name} = {value}"), &mut said).map_err(wrong)?;
        Ok(Self { keys, said, adds: false })
    }

    /// Reads the value of a key's flag.
    ///
    /// # Errors
    /// One sentence: a value that is not of the key's type.
    pub fn flag(key: &'static Key, text: &str) -> Result<Self, SceneError> {
        let mut said = Box::<SceneFile>::default();
        let item = word::read(key.kind, text).map_err(SceneError::Edit)?;
        key.read(Some(&item), &mut said).map_err(|Wrong { message, .. }| SceneError::Edit(message))?;
        Ok(Self { keys: vec![key], said, adds: !key.opposite.is_empty() })
    }

    /// Two flags of the same list of names as one: the names of both.
    #[must_use]
    pub fn and(mut self, other: &Self) -> Self {
        for key in &self.keys {
            append(key, &other.said, &mut self.said);
        }
        self
    }

    /// Whether it gives just this value under this key.
    pub(super) fn says(&self, key: &Key, value: &Value) -> bool {
        key.get(&self.said).as_ref() == Some(value)
    }
}

/// All that is said over a scene.
#[derive(Clone, Debug, Default)]
pub struct Edits {
    /// By `--set`, in the order given.
    pub set: Vec<Edit>,
    /// By flags.
    pub flags: Vec<Edit>,
}

impl Edits {
    /// Reads the words of a command line that say something over a scene: `--KEY VALUE` and `--set KEY=VALUE`.
    ///
    /// # Errors
    /// A word that is no such flag, or a value that is not taken.
    pub fn of_words<Word: AsRef<str>>(words: &[Word]) -> Result<Self, SceneError> {
        let mut edits = Self::default();
        let mut words = words.iter().map(AsRef::as_ref);
        while let Some(flag) = words.next() {
            let name = flag.strip_prefix("--").unwrap_or_default();
            let row = KEYS.iter().find(|key| key.flag.is_some_and(|flag| flag.name == name));
            if row.is_none() && name != "set" {
                return Err(SceneError::Edit(format!("`{}` is no flag of a scene", shortened(flag))));
            }
            let Some(word) = words.next() else {
                return Err(SceneError::Edit(format!("{flag} has no value")));
            };
            match row {
                Some(key) => edits.flags.push(Edit::flag(key, word)?),
                None => edits.set.push(Edit::set(word)?),
            }
        }
        Ok(edits)
    }

    /// Whether anything is said of these tables: `body`, `spin`.
    #[must_use]
    pub fn touch(&self, tables: &[&str]) -> bool {
        let of_table = |key: &&Key| tables.iter().any(|table| key.name.split('.').next() == Some(table));
        self.set.iter().chain(&self.flags).flat_map(|edit| edit.keys.iter()).any(of_table)
    }

    /// Says it all over a scene.
    pub fn apply(&self, file: &mut SceneFile) {
        over(&self.set, file, &[]);
        // What --set says beside a body stays with a body that a flag gives.
        let kept: Vec<&str> = given(&self.set).filter(|key| key.replaces.is_empty()).map(|key| key.name).collect();
        over(&self.flags, file, &kept);
    }
}

/// The keys that stand in edits with a value.
fn given(edits: &[Edit]) -> impl Iterator<Item = &'static Key> {
    edits.iter().flat_map(|edit| edit.keys.iter().copied().filter(|key| key.get(&edit.said).is_some()))
}

/// Says edits of one rank over a scene. What they give takes the place of what says the same otherwise, but for these
/// keys; two that are given at once both stay, and the check tells them apart.
fn over(edits: &[Edit], file: &mut SceneFile, kept: &[&str]) {
    let nothing = SceneFile::default();
    for replaced in given(edits).flat_map(|key| key.replaces) {
        if let Some(key) = key(replaced).filter(|key| !kept.contains(&key.name)) {
            key.copy(&nothing, file);
        }
    }
    for edit in edits {
        for key in &edit.keys {
            if edit.adds {
                add(key, &edit.said, file);
            } else {
                key.copy(&edit.said, file);
            }
        }
    }
}

/// Adds names to a list, and takes them out of its opposite.
fn add(row: &Key, said: &SceneFile, file: &mut SceneFile) {
    append(row, said, file);
    if let Some(other) = key(row.opposite) {
        let added = names(row, said);
        put(other, names(other, file).into_iter().filter(|name| !added.contains(name)).collect(), file);
    }
}

/// Adds names to a list.
fn append(row: &Key, said: &SceneFile, file: &mut SceneFile) {
    let mut list = names(row, file);
    for name in names(row, said) {
        if !list.contains(&name) {
            list.push(name);
        }
    }
    put(row, list, file);
}

/// The names that stand under a key.
pub(super) fn names(key: &Key, file: &SceneFile) -> Vec<Item> {
    match key.get(file) {
        Some(Value::List(names)) => names,
        _ => vec![],
    }
}

/// Lets these names stand under a key.
fn put(key: &Key, names: Vec<Item>, file: &mut SceneFile) {
    // Whatever came out of such a list goes into one.
    let _ = key.read(Some(&Value::List(names).into()), file);
}
