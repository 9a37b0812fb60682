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
const LONGEST: usize = 1 << 18;
/// Longest text that a link may hold (bytes): as long as that of a file.
const LONGEST_TEXT: usize = 1 << 20;
/// Effort of packing, of 10.
const EFFORT: u8 = 9;
/// What a key or a value holds as it is: what no program takes for the end of a link.
const HELD: &AsciiSet = &NON_ALPHANUMERIC.remove(b'-').remove(b'_').remove(b'.').remove(b',').remove(b':');

/// What a link says.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// The built-in scene that it starts from; none where the scene is the link's own.
    pub name: Option<String>,
    /// The scene.
    pub file: SceneFile,
    /// The time (s) at which it is shown, where it says one.
    pub time: Option<f64>,
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
        return Err(SceneError::Link("has no #, from which on it would say the scene".to_owned()));
    };
    if end.len() > LONGEST {
        return Err(SceneError::Link(format!("is {} bytes long, and at most {LONGEST} are read", end.len())));
    }
    let own = end.starts_with("scene=");
    let (name, rest) = if own { ("", end) } else { end.split_once('?').unwrap_or((end, "")) };
    let name = if name.is_empty() && !own { DEFAULT_PRESET.to_owned() } else { decoded(name)? };
    let (mut file, name) = if own { (SceneFile::default(), None) } else { (preset(&name)?.read()?, Some(name)) };
    let mut edits = Edits::default();
    let mut time = None;
    for pair in rest.split('&').filter(|pair| !pair.is_empty()) {
        let (key, value) = pair.split_once('=').unwrap_or((pair, ""));
        match key {
            "scene" if own => file = unpacked(value)?,
            "time" => time = Some(time_of(&decoded(value)?)?),
            _ if !pair.contains('=') => {
                return Err(SceneError::Link(format!("has `{}` without a value", shortened(pair))));
            }
            _ => edits.set.push(Edit::key_and_value(&decoded(key)?, &decoded(value)?)?),
        }
    }
    edits.apply(&mut file);
    Ok(Link { name, file, time })
}

/// Writes the link of a scene from its `#` on: where a built-in scene of this name is near, what differs from it, else
/// the whole scene.
#[must_use]
pub fn write(name: Option<&str>, file: &SceneFile, time: Option<f64>) -> String {
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
    if let Some(time) = time {
        link.push(if link.contains('?') || link.starts_with("#scene=") { '&' } else { '?' });
        link.extend(["time=", &number(time)]);
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
        return Err(SceneError::Link("is cut off or changed: its scene cannot be unpacked".to_owned()));
    };
    SceneFile::parse(&text).map_err(|error| SceneError::Link(format!("holds a scene with a fault: {error}")))
}

fn decoded(text: &str) -> Result<String, SceneError> {
    match percent_decode_str(text).decode_utf8() {
        Ok(text) => Ok(text.into_owned()),
        Err(_) => Err(SceneError::Link(format!("has `{}`, which is no UTF-8", shortened(text)))),
    }
}

fn time_of(text: &str) -> Result<f64, SceneError> {
    text.parse::<f64>()
        .ok()
        .filter(|time| time.is_finite())
        .ok_or_else(|| SceneError::Link(format!("has the time `{}`: it must be a finite number (s)", shortened(text))))
}
