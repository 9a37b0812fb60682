//! A scene as the end of a link, from its `#` on: a built-in scene and what is changed in it, `#flip?spin.rate=8&time=2.5`,
//! or a whole scene of one's own, `#scene=…`, its text packed (zlib, base64url).
//!
//! A link is read from its own letters alone: nothing is fetched and nothing runs.

use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use miniz_oxide::deflate::compress_to_vec_zlib;
use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;
use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, percent_decode_str, utf8_percent_encode};

use super::command::pairs;
use super::edit::{Edit, Edits};
use super::value::shortened;
use super::{DEFAULT_PRESET, SceneError, SceneFile, preset};
use crate::physics::number;

/// Longest link that is read (bytes from its `#` on): browsers take no longer ones.
pub(super) const LONGEST: usize = 1 << 18;
/// Longest text that a link may hold (bytes): as long as that of a file.
const LONGEST_TEXT: usize = 1 << 20;
/// The key of the step at which the scene is shown.
const STEP: &str = "scene-step";
/// Effort of packing, of 10.
const EFFORT: u8 = 9;
/// What a key or a value holds as it is: what no program takes for the end of a link.
const HELD: &AsciiSet = &NON_ALPHANUMERIC.remove(b'-').remove(b'_').remove(b'.').remove(b',').remove(b':');

/// What a link says.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Link {
    /// The built-in scene that it starts from; none where the scene is the link's own.
    pub name: Option<String>,
    /// The scene.
    pub file: SceneFile,
    /// The time (s) at which it is shown, where it says one.
    pub time: Option<f64>,
    /// The step at which it is shown, counted from 0, where it says one.
    pub step: Option<usize>,
}

/// Whether a word that names a scene is a link: it begins with `#`, or is an address with a `#` in it.
#[must_use]
pub fn is_link(word: &str) -> bool {
    word.starts_with('#') || word.split_once('#').is_some_and(|(address, _)| address.contains("://"))
}

/// Reads a link. What stands before its `#` is not looked at.
///
/// # Errors
/// One sentence: no `#`, an unknown scene or key, a value that is not taken, a packed scene that is cut off.
pub fn read(link: &str) -> Result<Link, SceneError> {
    let Some((_, end)) = link.split_once('#') else {
        return Err(SceneError::NotALink("has no #, from which on it would say the scene".to_owned()));
    };
    if end.len() > LONGEST {
        return Err(SceneError::NotALink(format!("is {} bytes long, and at most {LONGEST} are read", end.len())));
    }
    let own = end.starts_with("scene=");
    let (name, rest) = if own { ("", end) } else { end.split_once('?').unwrap_or((end, "")) };
    let name = if name.is_empty() && !own { DEFAULT_PRESET.to_owned() } else { decoded(name)? };
    let (mut file, name) = if own { (SceneFile::default(), None) } else { (preset(&name)?.read()?, Some(name)) };
    let mut edits = Edits::default();
    let (mut time, mut step) = (None, None);
    for pair in rest.split('&').filter(|pair| !pair.is_empty()) {
        let (key, value) = pair.split_once('=').unwrap_or((pair, ""));
        match key {
            "scene" if own => file = unpacked(value)?,
            "time" => time = Some(time_of(&decoded(value)?)?),
            STEP => step = Some(step_of(&decoded(value)?)?),
            _ if !pair.contains('=') => {
                return Err(SceneError::NotALink(format!("has `{}` without a value", shortened(pair))));
            }
            _ => edits.set.push(Edit::key_and_value(&decoded(key)?, &decoded(value)?)?),
        }
    }
    edits.apply(&mut file);
    Ok(Link { name, file, time, step })
}

/// Writes the link of a scene from its `#` on: where a built-in scene of this name is near, what differs from it, else
/// the whole scene.
#[must_use]
pub fn write(name: Option<&str>, file: &SceneFile, time: Option<f64>) -> String {
    write_at(name, file, None, time)
}

/// The same, of the scene at this step, counted from 0.
#[must_use]
pub fn write_at(name: Option<&str>, file: &SceneFile, step: Option<usize>, time: Option<f64>) -> String {
    let base = name.and_then(|name| Some((name, preset(name).ok()?.read().ok()?)));
    let whole = format!("#scene={}", packed(file));
    let mut link = match base {
        None => whole,
        Some((name, base)) => {
            let mut link = format!("#{}", utf8_percent_encode(name, HELD));
            for (index, pair) in pairs(&base, file).iter().enumerate() {
                let (key, value) = pair.split_once('=').unwrap_or((pair, ""));
                link.push(if index == 0 { '?' } else { '&' });
                link.extend(utf8_percent_encode(key, HELD));
                link.push('=');
                link.extend(utf8_percent_encode(value, HELD));
            }
            if link.len() > whole.len() { whole } else { link }
        }
    };
    let step = step.map(|step| (STEP, (step + 1).to_string()));
    for (key, value) in step.into_iter().chain(time.map(|time| ("time", number(time)))) {
        link.push(if link.contains('?') || link.starts_with("#scene=") { '&' } else { '?' });
        link.extend([key, "=", &value]);
    }
    link
}

/// A scene's text, packed.
fn packed(file: &SceneFile) -> String {
    URL_SAFE_NO_PAD.encode(compress_to_vec_zlib(file.to_toml().as_bytes(), EFFORT))
}

/// The scene of a packed text.
fn unpacked(text: &str) -> Result<SceneFile, SceneError> {
    let bytes = URL_SAFE_NO_PAD.decode(text).ok();
    let text = bytes
        .and_then(|bytes| decompress_to_vec_zlib_with_limit(&bytes, LONGEST_TEXT).ok())
        .and_then(|text| String::from_utf8(text).ok());
    let Some(text) = text else {
        return Err(SceneError::NotALink("is cut off or changed: its scene cannot be unpacked".to_owned()));
    };
    SceneFile::parse(&text).map_err(|error| SceneError::NotALink(format!("holds a scene with a fault: {error}")))
}

fn decoded(text: &str) -> Result<String, SceneError> {
    match percent_decode_str(text).decode_utf8() {
        Ok(text) => Ok(text.into_owned()),
        Err(_) => Err(SceneError::NotALink(format!("has `{}`, which is no UTF-8", shortened(text)))),
    }
}

fn step_of(text: &str) -> Result<usize, SceneError> {
    let step = text.parse::<usize>().ok().and_then(|step| step.checked_sub(1));
    step.ok_or_else(|| SceneError::NotALink(format!("has the step `{}`: it must be 1 or more", shortened(text))))
}

fn time_of(text: &str) -> Result<f64, SceneError> {
    text.parse::<f64>().ok().filter(|time| time.is_finite()).ok_or_else(|| {
        SceneError::NotALink(format!("has the time `{}`: it must be a finite number (s)", shortened(text)))
    })
}

#[cfg(test)]
mod tests {
    use super::{LONGEST, is_link, packed, read, write, write_at};
    use crate::scene::{SceneError, SceneFile, preset};

    fn refused(link: &str) -> String {
        read(link).map_or_else(|error| error.to_string(), |link| format!("{link:?}"))
    }

    #[test]
    fn links_are_told_from_names_and_paths() {
        for link in ["#", "#flip", "#scene=x", "https://a.org/b/#flip", "file:///a#b"] {
            assert!(is_link(link), "{link}");
        }
        for word in ["", "flip", "a#b.toml", "./#x.toml", "https://a.org/", "a#b://c"] {
            assert!(!is_link(word), "{word}");
        }
    }

    #[test]
    fn a_link_starts_from_a_built_in_scene() -> Result<(), SceneError> {
        let flip = preset("flip")?.read()?;
        for (link, name, time) in [
            ("#flip", "flip", None),
            ("#", "flip", None),
            ("#?", "flip", None),
            ("https://a.org/?embed#flip?time=2.5", "flip", Some(2.5)),
            ("#fl%69p?&time=-1e3&", "flip", Some(-1000.0)),
        ] {
            let read = read(link)?;
            assert_eq!((read.name.as_deref(), &read.file, read.time), (Some(name), &flip, time), "{link}");
        }
        let read = read(
            "#t-handle?spin.rate=3&motion.compare=%5B%22rk4%22%5D&spin.attitude=[1,0,0,0]&title=a%26b%23c+d&time=1",
        )?;
        let file = &read.file;
        assert_eq!(
            (file.spin.rate, file.spin.attitude, &*file.title),
            (Some(3.0), Some([1.0, 0.0, 0.0, 0.0]), "a&b#c+d")
        );
        assert_eq!((&file.motion.compare[..], read.time), (&["rk4".to_owned()][..], Some(1.0)));
        Ok(())
    }

    #[test]
    fn a_link_is_written_in_short_where_it_can_be() -> Result<(), SceneError> {
        let mut file = preset("flip")?.read()?;
        assert_eq!(write(Some("flip"), &file, None), "#flip");
        assert_eq!(write(Some("flip"), &file, Some(2.5)), "#flip?time=2.5");
        file.spin.rate = Some(8.0);
        file.spin.attitude = Some([1.0, 0.0, 0.0, -0.5]);
        let link = "#flip?spin.rate=8&spin.attitude=%5B1,%200,%200,%20-0.5%5D&time=0";
        assert_eq!(write(Some("flip"), &file, Some(0.0)), link);
        for name in [None, Some("nosuch")] {
            let own = write(name, &file, Some(1.0));
            assert!(own.starts_with("#scene=") && own.ends_with("&time=1"), "{own}");
            let read = read(&own)?;
            assert_eq!((read.name, read.file, read.time), (None, file.clone(), Some(1.0)));
        }
        for name in [None, Some("flip")] {
            let link = write_at(name, &file, Some(2), Some(1.0));
            assert!(link.ends_with("&scene-step=3&time=1"), "{link}");
            assert_eq!(read(&link).map(|read| (read.file, read.step, read.time))?, (file.clone(), Some(2), Some(1.0)));
        }
        // A whole scene that is shorter than what differs.
        let methods = preset("methods")?.read()?;
        assert!(write(Some("flip"), &methods, None).starts_with("#scene="));
        // Nothing in it ends a link or needs quotes in a page.
        let all = write(Some("flip"), &file, Some(1.0)) + &write(None, &methods, None);
        assert!(all.chars().all(|c| c.is_ascii_alphanumeric() || "#?&=%-_.,:".contains(c)), "{all}");
        Ok(())
    }

    #[test]
    fn what_is_no_link_is_refused_in_one_sentence() {
        for (link, sentence) in [
            ("flip", "the link has no #, from which on it would say the scene"),
            ("#flop", "scene `flop` is not known: the nearest is `flip`"),
            ("#flip?spin.rat=1", "unknown key `spin.rat`; the nearest known key is `spin.rate`"),
            ("#flip?spin.rate=x", "spin.rate is `x`: it must be a number (rad/s)"),
            ("#flip?spin.rate", "the link has `spin.rate` without a value"),
            (
                "#flip?scene=abc",
                "unknown key `scene`; known here are title, text, question, answer, order, body, spin, motion, cloud, view, step",
            ),
            ("#flip?scene-step=0", "the link has the step `0`: it must be 1 or more"),
            ("#flip?time=", "the link has the time ``: it must be a finite number (s)"),
            ("#flip?time=soon", "the link has the time `soon`: it must be a finite number (s)"),
            ("#flip?time=inf", "the link has the time `inf`: it must be a finite number (s)"),
            ("#flip?title=%ff", "the link has `%ff`, which is no UTF-8"),
            ("#%ff", "the link has `%ff`, which is no UTF-8"),
            ("#scene=", "the link is cut off or changed: its scene cannot be unpacked"),
            ("#scene=!!!", "the link is cut off or changed: its scene cannot be unpacked"),
            ("#scene=abcd", "the link is cut off or changed: its scene cannot be unpacked"),
        ] {
            assert_eq!(refused(link), sentence, "{link}");
        }
    }

    #[test]
    fn a_link_that_is_cut_off_or_too_long_is_refused() {
        let file = SceneFile { title: "A title".to_owned(), ..SceneFile::default() };
        let whole = write(None, &file, None);
        for cut in "#scene=".len()..whole.len() {
            assert!(read(&whole[..cut]).is_err(), "{cut} of {}", whole.len());
        }
        let long = format!("#flip?title={}", "x".repeat(LONGEST - "flip?title=".len()));
        assert!(read(&long).is_ok());
        assert_eq!(
            refused(&(long + "x")),
            format!("the link is {} bytes long, and at most {LONGEST} are read", LONGEST + 1)
        );
        // A short link whose scene would fill the memory.
        let bomb = SceneFile { text: "x".repeat(1 << 21), ..SceneFile::default() };
        let bomb = format!("#scene={}", packed(&bomb));
        assert!(bomb.len() < 10_000 && refused(&bomb).contains("cannot be unpacked"));
        let half = SceneFile { text: "x".repeat(1 << 19), ..SceneFile::default() };
        assert!(read(&write(None, &half, None)).is_ok_and(|link| link.file == half));
    }

    #[test]
    fn a_packed_text_that_is_no_scene_says_why() {
        use base64::Engine as _;
        let packed = |text: &[u8]| super::URL_SAFE_NO_PAD.encode(miniz_oxide::deflate::compress_to_vec_zlib(text, 6));
        let link = format!("#scene={}", packed(b"\nspin.rat = 3"));
        let why =
            "the link holds a scene with a fault: line 2: unknown key `spin.rat`; the nearest known key is `spin.rate`";
        assert_eq!(refused(&link), why);
        assert!(refused(&format!("#scene={}", packed(b"title = '\xff'"))).contains("cannot be unpacked"));
    }
}
