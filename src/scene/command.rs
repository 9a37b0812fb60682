//! A scene as words of a command line: what reproduces a picture in a shell.

use super::edit::{Edit, Edits, names};
use super::keys::{KEYS, Key};
use super::value::Value;
use super::{SceneFile, word};

/// What turns one scene into another: each key, and what it says then; nothing where it is taken away.
type Changes = Vec<(&'static Key, Option<Value>)>;

/// The words of a command line that turn the scene `base` into `file`: a flag for whatever has one, `--set` for the
/// rest. Read over `base` they give `file` again, whatever it is.
#[must_use]
pub fn flags(base: &SceneFile, file: &SceneFile) -> Vec<String> {
    let changes = changes(base, file);
    let lists = added(base, file);
    let mut flags = vec![];
    let mut set = vec![];
    for (key, value) in changes {
        if !key.opposite.is_empty() && lists.is_some() {
            continue;
        }
        let flag = key.flag.filter(|_| key.opposite.is_empty());
        // Names that are taken away have a word, and nothing else that is taken away has.
        let said = value.clone().or_else(|| (key.name == "motion.compare").then(|| Value::List(vec![])));
        match (flag, said.and_then(|value| word::write(key.kind, &value))) {
            (Some(flag), Some(word)) => flags.extend([format!("--{}", flag.name), word]),
            _ => set.extend(["--set".to_owned(), pair(key, value.as_ref())]),
        }
    }
    flags.extend(lists.into_iter().flatten());
    flags.extend(set);
    flags
}

/// `KEY=VALUE` pairs, as for `--set`, that turn the scene `base` into `file`.
pub(super) fn pairs(base: &SceneFile, file: &SceneFile) -> Vec<String> {
    changes(base, file).iter().map(|(key, value)| pair(key, value.as_ref())).collect()
}

/// The keys under which two scenes differ, once what is given has taken the place of what it replaces.
fn changes(base: &SceneFile, file: &SceneFile) -> Changes {
    let mut reached = base.clone();
    let nothing = SceneFile::default();
    let gives = |key: &&Key| key.get(file).is_some() && key.get(file) != key.get(base);
    for replaced in KEYS.iter().filter(gives).flat_map(|key| key.replaces) {
        if let Some(key) = super::keys::key(replaced) {
            key.copy(&nothing, &mut reached);
        }
    }
    let mut changes = vec![];
    for key in KEYS {
        let value = key.get(file);
        // A camera in short can only be given: what else is said of it the keys below it say.
        if value == key.get(&reached) || (key.is_short && value.is_none()) {
            continue;
        }
        key.copy(file, &mut reached);
        changes.push((key, value));
    }
    changes
}

/// The flags that add to the lists of names, where these alone turn those of `base` into those of `file`.
fn added(base: &SceneFile, file: &SceneFile) -> Option<Vec<String>> {
    let mut words = vec![];
    for key in KEYS.iter().filter(|key| !key.opposite.is_empty()) {
        let before = names(key, base);
        let new: Vec<_> = names(key, file).into_iter().filter(|name| !before.contains(name)).collect();
        if !new.is_empty() {
            words.extend([format!("--{}", key.flag?.name), word::write(key.kind, &Value::List(new))?]);
        }
    }
    let mut reached = base.clone();
    Edits::of_words(&words).ok()?.apply(&mut reached);
    (reached.view.show == file.view.show && reached.view.hide == file.view.hide).then_some(words)
}

/// `KEY=VALUE`, a text without quotes where it reads back so.
fn pair(key: &Key, value: Option<&Value>) -> String {
    let Some(value) = value else { return format!("{}=", key.name) };
    if let Value::Text(text) = value {
        let plain = format!("{}={text}", key.name);
        let is_read_back = Edit::set(&plain).is_ok_and(|edit| edit.says(key, value));
        if is_read_back && !text.contains(char::is_control) {
            return plain;
        }
    }
    format!("{}={}", key.name, value.to_toml())
}

/// Words as one line for a shell, quoted where they need it.
#[must_use]
pub fn quoted(words: &[String]) -> String {
    let is_plain =
        |word: &str| !word.is_empty() && word.chars().all(|c| c.is_ascii_alphanumeric() || "-_=+,./:@%".contains(c));
    let quote =
        |word: &String| if is_plain(word) { word.clone() } else { format!("'{}'", word.replace('\'', r"'\''")) };
    words.iter().map(quote).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::{flags, pairs, quoted};
    use crate::scene::{SceneError, SceneFile, preset};

    /// The words for what this TOML says over a built-in scene that it takes the place of, table by table.
    fn words(base: &str, change: impl FnOnce(&mut SceneFile)) -> Result<String, SceneError> {
        let base = preset(base)?.read()?;
        let mut file = base.clone();
        change(&mut file);
        Ok(quoted(&flags(&base, &file)))
    }

    #[test]
    fn a_flag_says_what_has_one_and_set_the_rest() -> Result<(), SceneError> {
        assert_eq!(words("flip", |_| ())?, "");
        assert_eq!(words("flip", |file| file.spin.rate = Some(0.1))?, "--rate 0.1");
        assert_eq!(words("flip", |file| file.spin.rate = None)?, "--set spin.rate=");
        assert_eq!(words("flip", |file| file.motion.step = Some(1e-300))?, "--step 1e-300");
        assert_eq!(
            words("flip", |file| file.spin.attitude = Some([1.0, 0.0, 0.0, -0.5]))?,
            "--set 'spin.attitude=[1, 0, 0, -0.5]'"
        );
        assert_eq!(words("methods", |file| file.motion.compare.clear())?, "--compare ''");
        assert_eq!(words("flip", |file| file.title = "It's".to_owned())?, r"--set 'title=It'\''s'");
        assert_eq!(words("flip", |file| file.title = "\"a\"".to_owned())?, r#"--set 'title="\"a\""'"#);
        assert_eq!(words("flip", |file| file.title = "a\nb".to_owned())?, r#"--set 'title="a\nb"'"#);
        assert_eq!(words("flip", |file| file.view.labels = Some(false))?, "--labels off");
        let moments = |file: &mut SceneFile| {
            file.body = SceneFile::default().body;
            file.body.moments = Some([1.0, 2.0, 3.0]);
        };
        assert_eq!(words("flip", moments)?, "--moments 1,2,3");
        assert_eq!(
            words("flip", |file| file.view.world_camera.distance = Some(2.0))?,
            "--set view.world_camera.distance=2"
        );
        Ok(())
    }

    #[test]
    fn lists_are_added_to_or_set() -> Result<(), SceneError> {
        assert_eq!(words("t-handle", |file| file.view.show.push("herpolhode".to_owned()))?, "--show herpolhode");
        assert_eq!(words("t-handle", |file| file.view.hide.push("body".to_owned()))?, "--hide body");
        assert_eq!(words("t-handle", |file| file.view.show.clear())?, "--set view.show=");
        let swapped = |file: &mut SceneFile| std::mem::swap(&mut file.view.show, &mut file.view.hide);
        assert_eq!(words("t-handle", swapped)?, "--hide axis-trail");
        Ok(())
    }

    #[test]
    fn pairs_say_it_all() -> Result<(), SceneError> {
        let base = preset("flip")?.read()?;
        let mut file = base.clone();
        file.spin.rate = Some(8.0);
        file.view.world_camera.distance = Some(2.0);
        assert_eq!(pairs(&base, &file), ["spin.rate=8", "view.world_camera.distance=2"]);
        Ok(())
    }

    #[test]
    fn words_are_quoted_where_a_shell_needs_it() {
        for (word, line) in [
            ("a-b_=+,./:@%9", "a-b_=+,./:@%9"),
            ("", "''"),
            ("a b", "'a b'"),
            ("it's", r"'it'\''s'"),
            ("#x", "'#x'"),
            ("é", "'é'"),
        ] {
            assert_eq!(quoted(&[word.to_owned()]), line);
        }
        assert_eq!(quoted(&["a".to_owned(), "b".to_owned()]), "a b");
    }
}
