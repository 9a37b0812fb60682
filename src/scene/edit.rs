//! What is said over a scene: flags, and `--set KEY=VALUE` for whatever has none. Later wins: file, `--set`, flag.

use super::field::{Kind, Wrong};
use super::keys::{KEYS, Key, key, keys_of};
use super::value::{Item, Value, shortened};
use super::{ALL, SceneError, SceneFile, read, word};

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
            return Err(SceneError::NotTaken(format!(
                "`{}` has no value: KEY=VALUE is wanted, as in spin.rate=6",
                shortened(text)
            )));
        };
        Self::key_and_value(name.trim(), value.trim())
    }

    /// The same, with the key and its value apart.
    pub(super) fn key_and_value(name: &str, value: &str) -> Result<Self, SceneError> {
        let wrong = |Wrong { message, .. }| SceneError::NotTaken(message);
        let row = key(name);
        let mut said = Box::<SceneFile>::default();
        if value.is_empty() {
            let keys: Vec<_> = row.into_iter().chain(keys_of(name)).collect();
            if keys.is_empty() {
                return Err(SceneError::NotTaken(read::unknown(name)));
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
            return Err(SceneError::NotTaken(read::unknown(name)));
        }
        if let (Some(row), Err(_)) = (row, toml::de::DeValue::parse(value)) {
            let what = format!("`{}`", shortened(value));
            return Err(SceneError::NotTaken(row.refused(&what)));
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
        let item = word::read(key.kind, text).map_err(SceneError::NotTaken)?;
        key.read(Some(&item), &mut said).map_err(|Wrong { message, .. }| SceneError::NotTaken(message))?;
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
                return Err(SceneError::NotTaken(format!("`{}` is no flag of a scene", shortened(flag))));
            }
            let Some(word) = words.next() else {
                return Err(SceneError::NotTaken(format!("{flag} has no value")));
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

/// Adds names to a list, and takes them out of its opposite, which the name of all empties.
fn add(row: &Key, said: &SceneFile, file: &mut SceneFile) {
    append(row, said, file);
    if let Some(other) = key(row.opposite) {
        let added = names(row, said);
        let is_all = added.contains(&Value::Text(ALL.to_owned()).into());
        put(other, names(other, file).into_iter().filter(|name| !is_all && !added.contains(name)).collect(), file);
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

#[cfg(test)]
mod tests {
    use super::{Edit, Edits};
    use crate::scene::{BodyFile, PartKind, SceneError, SceneFile, SpinFile, key, preset};

    /// A scene with these words said over it.
    fn over(base: &SceneFile, words: &[&str]) -> Result<SceneFile, SceneError> {
        let mut file = base.clone();
        Edits::of_words(words)?.apply(&mut file);
        Ok(file)
    }

    fn refused(words: &[&str]) -> String {
        Edits::of_words(words).map_or_else(|error| error.to_string(), |edits| format!("{edits:?}"))
    }

    #[test]
    fn a_body_takes_the_place_of_a_body_and_a_spin_of_a_spin() -> Result<(), SceneError> {
        let flip = preset("flip")?.read()?;
        let file = over(&flip, &["--moments", "1,2,3"])?;
        assert_eq!(file.body, BodyFile { moments: Some([1.0, 2.0, 3.0]), ..BodyFile::default() });
        assert_eq!(file.spin, flip.spin);
        let file = over(&flip, &["--omega", "1,2,3"])?;
        assert_eq!(file.spin, SpinFile { omega: Some([1.0, 2.0, 3.0]), ..SpinFile::default() });
        for words in [["--rate", "4"], ["--set", "spin.rate=4"]] {
            let back = over(&file, &words)?;
            assert_eq!(back.spin, SpinFile { rate: Some(4.0), ..SpinFile::default() });
            assert_eq!(over(&flip, &words)?.spin, SpinFile { rate: Some(4.0), ..flip.spin.clone() });
        }
        // Two at once both stay, and are refused by the check.
        let both = over(&flip, &["--box", "1,2,3", "--moments", "1,2,3"])?;
        assert!(both.body.edges.is_some() && both.body.moments.is_some());
        // What says the size of a box goes with the box that it was said of, and not with the next.
        assert_eq!(over(&flip, &["--box", "1,2,3"])?.body.mass, None);
        assert_eq!(over(&flip, &["--box", "1,2,3", "--mass", "4"])?.body.mass, Some(4.0));
        assert_eq!(over(&flip, &["--mass", "4"])?.body.edges, flip.body.edges);
        Ok(())
    }

    #[test]
    fn a_flag_goes_before_set_and_set_before_the_file() -> Result<(), SceneError> {
        let flip = preset("flip")?.read()?;
        let file = over(&flip, &["--rate", "7", "--set", "spin.rate=8", "--set", "spin.tilt_deg=9"])?;
        assert_eq!((file.spin.rate, file.spin.tilt_deg, file.spin.axis), (Some(7.0), Some(9.0), Some(2)));
        assert_eq!(over(&flip, &["--set", "spin.rate=8", "--set", "spin.rate=9"])?.spin.rate, Some(9.0));
        let file = over(&flip, &["--set", "body.box=[1,2,3]", "--set", "body.form=ellipsoid", "--moments", "1,2,3"])?;
        let form = Some(PartKind::Ellipsoid);
        assert_eq!(file.body, BodyFile { moments: Some([1.0, 2.0, 3.0]), form, ..BodyFile::default() });
        let file = over(&flip, &["--set", "spin.axis=3", "--omega", "1,2,3"])?;
        assert_eq!((file.spin.axis, file.spin.omega), (None, Some([1.0, 2.0, 3.0])));
        Ok(())
    }

    #[test]
    fn an_empty_value_takes_away() -> Result<(), SceneError> {
        let methods = preset("methods")?.read()?;
        assert_eq!(methods.motion.compare.len(), 4);
        for words in [["--compare", ""], ["--set", "motion.compare=[]"], ["--set", "motion.compare="]] {
            assert!(over(&methods, &words)?.motion.compare.is_empty(), "{words:?}");
        }
        let flip = preset("flip")?.read()?;
        assert!(!flip.steps.is_empty() && over(&flip, &["--set", "step=[]"])?.steps.is_empty());
        assert_eq!(over(&methods, &["--set", "body="])?.body, BodyFile::default());
        assert_eq!(over(&methods, &["--set", "spin.rate="])?.spin.rate, None);
        let seen = over(&methods, &["--world-camera", "1,2,3,4,5,6"])?;
        assert_eq!(over(&seen, &["--set", "view.world_camera="])?.view, methods.view);
        assert_eq!(over(&seen, &["--set", "view.world_camera.distance="])?.view.world_camera.distance, None);
        assert_eq!(over(&seen, &["--set", "view.world_camera={distance=7}"])?.view.world_camera.azimuth_deg, Some(1.0));
        // Taking away gives nothing, so that nothing else goes.
        assert_eq!(over(&methods, &["--set", "spin.omega="])?.spin, methods.spin);
        Ok(())
    }

    #[test]
    fn a_text_needs_no_quotes() -> Result<(), SceneError> {
        let flip = SceneFile::default();
        for words in ["title=a \\b 'c' # d", "title = \"a \\\\b 'c' # d\""] {
            assert_eq!(over(&flip, &["--set", words])?.title, "a \\b 'c' # d", "{words}");
        }
        assert_eq!(over(&flip, &["--set", "motion.method=buss"])?.motion.method.as_deref(), Some("buss"));
        assert_eq!(over(&flip, &["--set", "motion.method='a=b'"])?.motion.method.as_deref(), Some("a=b"));
        Ok(())
    }

    #[test]
    fn show_and_hide_add_to_the_lists_and_take_each_other_back() -> Result<(), SceneError> {
        let base = SceneFile::parse("view.show = ['a', 'b']\nview.hide = ['c', 'd']")?;
        let file = over(&base, &["--show", "c,e,a", "--hide", "b"])?;
        assert_eq!(
            (&file.view.show[..], &file.view.hide[..]),
            (&["a", "c", "e"].map(String::from)[..], &["d", "b"].map(String::from)[..])
        );
        let file = over(&base, &["--show", "e", "--hide", "all"])?;
        assert_eq!((&file.view.show[..], &file.view.hide[..]), (&[][..], &["c", "d", "all"].map(String::from)[..]));
        let file = over(&base, &["--set", "view.show=['e']"])?;
        assert_eq!((&file.view.show[..], &file.view.hide[..]), (&["e".to_owned()][..], &base.view.hide[..]));
        Ok(())
    }

    #[test]
    fn several_flags_of_names_are_one_list() -> Result<(), SceneError> {
        let Some(compare) = key("motion.compare") else { return Err(SceneError::NotTaken("no such key".to_owned())) };
        let both = Edit::flag(compare, "rk4,buss")?.and(&Edit::flag(compare, "buss,lie-euler")?);
        let mut file = preset("methods")?.read()?;
        Edits { set: vec![], flags: vec![both] }.apply(&mut file);
        assert_eq!(file.motion.compare, ["rk4", "buss", "lie-euler"]);
        Ok(())
    }

    #[test]
    fn what_is_touched_is_known() -> Result<(), SceneError> {
        let edits = Edits::of_words(&["--set", "spin.rate=1", "--box", "1,2,3"])?;
        assert!(edits.touch(&["spin"]) && edits.touch(&["body", "view"]) && !edits.touch(&["motion", "view"]));
        assert!(!Edits::default().touch(&["body", "spin"]));
        Ok(())
    }

    #[test]
    fn what_cannot_be_said_is_refused() {
        for (words, sentence) in [
            (&["--set", "spin.rate"][..], "`spin.rate` has no value: KEY=VALUE is wanted, as in spin.rate=6"),
            (
                &["--set", "=3"],
                "unknown key ``; known here are title, text, question, answer, order, body, spin, motion, cloud, view, step",
            ),
            (&["--set", "spin.rat=3"], "unknown key `spin.rat`; the nearest known key is `spin.rate`"),
            (&["--set", "spin.rat="], "unknown key `spin.rat`; the nearest known key is `spin.rate`"),
            (&["--set", "spin=3"], "spin is the number 3: it must be a table"),
            (&["--set", "spin.rate=fast"], "spin.rate is `fast`: it must be a number (rad/s)"),
            (&["--set", "spin.omega=[1,2"], "spin.omega is `[1,2`: it must be an array of 3 numbers (rad/s)"),
            (&["--set", "spin.omega=[1,2]"], "spin.omega is an array of 2: it must be an array of 3 numbers (rad/s)"),
            (&["--set", "view.theme=drak"], "view.theme is the text \"drak\": it must be dark or light"),
            (&["--set", "body.solids=[]"], "body.solids is an array of 0: it must be an array of solids, one at least"),
            (
                &["--set", "body.solids.size=3"],
                "`body.solids.size` is a key inside of [[body.solids]]: they are given all at once, as in body.solids=[{ size = … }]",
            ),
            (&["--set"], "--set has no value"),
            (&["--rate"], "--rate has no value"),
            (&["--nonsense", "3"], "`--nonsense` is no flag of a scene"),
            (&["rate", "3"], "`rate` is no flag of a scene"),
            (&["set", "spin.rate=3"], "`set` is no flag of a scene"),
            (&["--rate", "fast"], "`fast` is not a number"),
            (&["--rate", "1e400"], "`1e400` is past the range of numbers"),
            (&["--axis", "x"], "`x` is not 1 (smallest moment), 2 or 3 (largest)"),
            (&["--axis", "4"], "spin.axis is the number 4: it must be 1 (smallest moment), 2 or 3 (largest)"),
            (&["--box", "1,2"], "3 numbers with commas between them are wanted, 2 are given"),
            (&["--labels", "maybe"], "`maybe` is neither on nor off"),
            (&["--theme", "drak"], "view.theme is the text \"drak\": it must be dark or light"),
        ] {
            assert_eq!(refused(words), sentence, "{words:?}");
        }
    }
}
