//! Text that is read with a bound on its length, and the scenes of a file or a folder.

use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};

use super::FileError;
use crate::scene::link::Link;
use crate::scene::{SceneError, SceneFile, carried};

/// Largest scene file read (bytes): a thousand times the longest preset.
pub const LARGEST_SCENE: u64 = 1 << 20;

/// Largest picture that is looked through for its scene (bytes): a figure is rarely past a few millions.
pub const LARGEST_PICTURE: u64 = 1 << 28;
/// So many of a file's first bytes tell a picture from a text.
const HEAD: u64 = 1024;

/// A scene's path, as it was named, and what is there.
pub type NamedScene = (String, Result<Link, SceneError>);

/// The text of a file, or of a pipe, that is UTF-8 and at most `most` bytes long.
///
/// # Errors
/// One sentence that says why it cannot be had.
pub fn read_text(path: &Path, most: u64) -> Result<String, FileError> {
    read(path, most).map_err(|reason| FileError::read(path, reason))
}

/// The text of standard input, likewise.
///
/// # Errors
/// One sentence that says why it cannot be had.
pub fn read_standard_input(most: u64) -> Result<String, FileError> {
    text_of(std::io::stdin().lock(), most).map_err(|reason| FileError::read(Path::new("standard input"), reason))
}

/// The text, or why it cannot be had.
fn read(path: &Path, most: u64) -> Result<String, String> {
    let refused = |error: std::io::Error| format!("could not be read: {error}");
    let file = File::open(path).map_err(refused)?;
    within(file.metadata().map_err(refused)?.len(), most)?;
    text_of(file, most)
}

/// Refuses a file that is longer than what is read of one.
fn within(length: u64, most: u64) -> Result<(), String> {
    if length > most {
        return Err(format!("is {length} bytes long, and at most {most} are read"));
    }
    Ok(())
}

/// The text of anything that can be read to its end: a device has no length beforehand, and some have no end.
fn text_of(source: impl Read, most: u64) -> Result<String, String> {
    let mut bytes = vec![];
    source.take(most + 1).read_to_end(&mut bytes).map_err(|error| format!("could not be read: {error}"))?;
    if bytes.len() as u64 > most {
        return Err(format!("is more than {most} bytes long, and no more are read"));
    }
    if is_wide(&bytes) {
        return Err("is UTF-16 or UTF-32 text: save it as UTF-8".to_owned());
    }
    // The mark of UTF-8 that some editors put first is no part of the text.
    if bytes.starts_with(b"\xef\xbb\xbf") {
        bytes.drain(..3);
    }
    String::from_utf8(bytes)
        .map_err(|error| format!("is no UTF-8 text: byte {} is not valid", error.utf8_error().valid_up_to()))
}

/// Whether text takes two or four bytes a character: it says so at its start, or every other byte there is 0.
fn is_wide(bytes: &[u8]) -> bool {
    match bytes {
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] | [0, 0, 0xfe, 0xff, ..] => true,
        [first, 0, third, 0, ..] | [0, first, 0, third, ..] => *first != 0 && *third != 0,
        _ => false,
    }
}

/// Reads a scene's file, or a picture that carries the scene that drew it, with the time that it shows. What it says is not
/// checked yet.
///
/// # Errors
/// A folder, a file that cannot be read, text that is no scene, or a picture that carries none.
pub fn read_scene(path: &Path) -> Result<Link, SceneError> {
    if path.is_dir() {
        let reason = "is a folder, which only the window can show; here name one of the scenes in it";
        return Err(SceneError::Unreadable(reason.to_owned()));
    }
    let refused = |error: std::io::Error| SceneError::Unreadable(format!("could not be read: {error}"));
    let mut file = File::open(path).map_err(refused)?;
    let length = file.metadata().map_err(refused)?.len();
    let mut bytes = vec![];
    file.by_ref().take(HEAD).read_to_end(&mut bytes).map_err(refused)?;
    let is_picture = carried::kind_of_picture(&bytes).is_some();
    let most = if is_picture { LARGEST_PICTURE } else { LARGEST_SCENE };
    within(length, most).map_err(SceneError::Unreadable)?;
    if is_picture {
        file.take(LARGEST_PICTURE).read_to_end(&mut bytes).map_err(refused)?;
        return carried::read(&bytes);
    }
    let text = text_of(bytes.as_slice().chain(file), LARGEST_SCENE).map_err(SceneError::Unreadable)?;
    Ok(Link { file: SceneFile::parse(&text)?, ..Link::default() })
}

/// Reads the scene of a file, or all scenes of a folder in the order of their names, each with its path; one
/// that is none leaves the others.
///
/// # Errors
/// A folder that cannot be read or has no scene in it.
pub fn read_scenes(path: &Path) -> Result<Vec<NamedScene>, FileError> {
    let paths = if path.is_dir() { scenes_in(path)? } else { vec![path.to_owned()] };
    let read = |path: PathBuf| {
        let scene = read_scene(&path);
        (path.display().to_string(), scene)
    };
    Ok(paths.into_iter().map(read).collect())
}

/// The scene files of a folder. What an editor hides there and what is no file is left out.
fn scenes_in(folder: &Path) -> Result<Vec<PathBuf>, FileError> {
    let refused = |error: std::io::Error| FileError::read(folder, format!("could not be read: {error}"));
    let mut paths = vec![];
    for entry in fs::read_dir(folder).map_err(refused)? {
        let path = entry.map_err(refused)?.path();
        let is_scene = path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"));
        let is_hidden = path.file_name().is_some_and(|name| name.as_encoded_bytes().starts_with(b"."));
        // A link that leads nowhere is a scene that cannot be read, and says so.
        let is_file = fs::metadata(&path).map_or(true, |metadata| metadata.is_file());
        if is_scene && !is_hidden && is_file {
            paths.push(path);
        }
    }
    paths.sort();
    if paths.is_empty() {
        return Err(FileError::read(folder, "there is no .toml file in this folder to show as a slide"));
    }
    Ok(paths)
}

#[cfg(test)]
mod tests {
    use super::{LARGEST_SCENE, is_wide, read_scenes, read_text};

    #[test]
    fn one_bad_scene_leaves_the_others() -> Result<(), Box<dyn std::error::Error>> {
        let folder = tempfile::tempdir()?;
        let put = |name: &str, text: &[u8]| std::fs::write(folder.path().join(name), text);
        put("a.toml", b"title = \"A\"")?;
        put("b.toml", b"titel = \"B\"")?;
        put("c.toml", b"\xff\xfet\0i\0")?;
        put("d.TOML", b"[spin]\naxis = true")?;
        put("e.toml", &vec![b'#'; LARGEST_SCENE as usize + 1])?;
        put(".#a.toml", b"an editor's")?;
        put("readme.txt", b"no scene")?;
        std::fs::create_dir(folder.path().join("folder.toml"))?;
        let scenes = read_scenes(folder.path())?;
        let said: Vec<String> = scenes
            .iter()
            .map(|(name, scene)| {
                let said = scene.as_ref().map_or_else(ToString::to_string, |link| link.file.title.clone());
                format!("{} {said}", name.rsplit(std::path::MAIN_SEPARATOR).next().unwrap_or_default())
            })
            .collect();
        assert_eq!(said.len(), 5, "{said:?}");
        for (said, wanted) in said.iter().zip(["a.toml A", "`title`", "UTF-16", "spin.axis is true", "1048577"]) {
            assert!(said.contains(wanted), "{said} says nothing of {wanted}");
        }
        let empty = tempfile::tempdir()?;
        assert!(read_scenes(empty.path()).is_err_and(|error| error.to_string().contains("no .toml file")));
        Ok(())
    }

    #[test]
    fn text_of_two_bytes_a_character_is_told_from_text() -> Result<(), Box<dyn std::error::Error>> {
        assert!(is_wide(b"\xfe\xff\0a"));
        assert!(is_wide(b"a\0b\0") && is_wide(b"\0a\0b"));
        assert!(!is_wide(b"ab") && !is_wide(b"") && !is_wide("é\0".as_bytes()));
        let folder = tempfile::tempdir()?;
        let path = folder.path().join("text");
        std::fs::write(&path, "\u{feff}text")?;
        assert_eq!(read_text(&path, 100)?, "text");
        Ok(())
    }
}
