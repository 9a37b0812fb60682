//! The scene that a picture carries: what a picture's file says of itself, among it the link of the scene that drew it, and how
//! that is found again in a PNG, an SVG, a PDF or a page, whatever else is in it.

use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;

use super::link::{self, LONGEST, Link};
use super::{SceneError, SceneFile};
use crate::physics::number;

/// The keyword of the scene's link.
const KEYWORD: &str = "Scene";
/// Where a page says it, up to the link's own first letter.
const ATTRIBUTE: &str = "data-scene=\"#";
/// What every PNG begins with.
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";
/// How far into a file its first words are looked for.
const HEAD: usize = 1024;

/// A kind of picture, and whether a file that begins so is of it.
type Kind = (&'static str, fn(&[u8]) -> bool);

/// The kinds of picture that can carry a scene.
const KINDS: [Kind; 4] = [
    ("a PNG picture", |head| head.starts_with(PNG)),
    ("a PDF", |head| head.starts_with(b"%PDF-")),
    ("a page", |head| is_markup(head) && find(head, b"<html").is_some()),
    ("an SVG picture", |head| is_markup(head) && find(head, b"<svg").is_some()),
];

/// How much a picture's file says of itself.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Saying {
    /// Nothing.
    Nothing,
    /// What the picture is of: another picture says something else, and no other.
    #[default]
    Plain,
    /// And which version of the program drew it.
    Full,
}

/// What a picture's file says of itself, a keyword and its text each: the program, the scene's title, the time (s), the command
/// that draws it again, and the scene itself at a step counted from 0.
#[must_use]
pub fn remarks(
    saying: Saying,
    title: String,
    file: &SceneFile,
    step: Option<usize>,
    time: f64,
    command: String,
) -> Vec<(&'static str, String)> {
    let program = match saying {
        Saying::Nothing => return vec![],
        Saying::Plain => "dzhanibekov".to_owned(),
        Saying::Full => concat!("dzhanibekov ", env!("CARGO_PKG_VERSION")).to_owned(),
    };
    vec![
        ("Software", program),
        ("Title", title),
        ("Description", format!("t = {} s", number(time))),
        ("Comment", command),
        (KEYWORD, link_of(file, step, time)),
    ]
}

/// The link of a scene as it looks at a step, counted from 0, and a time (s): whole, and not as what differs from a built-in
/// scene, which another version may have otherwise.
#[must_use]
pub fn link_of(file: &SceneFile, step: Option<usize>, time: f64) -> String {
    // What a window would keep from the scene before it is said, so that it opens as it looks.
    let mut file = file.clone();
    file.view.theme.get_or_insert_default();
    file.view.labels.get_or_insert(true);
    link::write_at(None, &file, step, Some(time))
}

/// Whether a file that begins so is a picture, and of which kind: one that is no scene's text.
#[must_use]
pub fn kind_of_picture(bytes: &[u8]) -> Option<&'static str> {
    let head = &bytes[..bytes.len().min(HEAD)];
    KINDS.iter().find_map(|(kind, is_it)| is_it(head).then_some(*kind))
}

/// Reads the scene that a picture carries.
///
/// # Errors
/// A picture that carries none, or one with a fault: one sentence.
pub fn read(bytes: &[u8]) -> Result<Link, SceneError> {
    let kind = kind_of_picture(bytes).unwrap_or("a file");
    let found = if bytes.starts_with(PNG) { in_png(bytes) } else { in_markup(bytes) };
    let Some(link) = found else {
        return Err(SceneError::Unreadable(format!(
            "is {kind} that carries no scene: only one that this program wrote, with its metadata, opens"
        )));
    };
    link::read(&link).map_err(|error| SceneError::Unreadable(format!("is {kind} whose scene has a fault: {error}")))
}

/// The text under the keyword in a PNG: in any of its three kinds of text, before or behind the pixels, as programs that write
/// it again put it.
fn in_png(bytes: &[u8]) -> Option<String> {
    let mut rest = bytes.get(PNG.len()..)?;
    loop {
        let (head, after) = rest.split_at_checked(8)?;
        let length = u32::from_be_bytes(head[..4].try_into().ok()?) as usize;
        let data = after.get(..length)?;
        let text = data.strip_prefix(KEYWORD.as_bytes()).and_then(|data| data.strip_prefix(b"\0"));
        if let Some(text) = text.and_then(|text| text_of_chunk(&head[4..], text)) {
            return Some(text);
        }
        // Behind it is a check sum.
        rest = after.get(length + 4..)?;
    }
}

/// The text of a chunk of this type, from behind its keyword.
fn text_of_chunk(kind: &[u8], data: &[u8]) -> Option<String> {
    let unpacked = |data: &[u8]| decompress_to_vec_zlib_with_limit(data, LONGEST).ok();
    let text = match (kind, data) {
        (b"tEXt", _) => data.to_vec(),
        (b"zTXt", [0, packed @ ..]) => unpacked(packed)?,
        (b"iTXt", [is_packed, 0, rest @ ..]) => {
            // The language, and the keyword in it.
            let text = rest.splitn(3, |byte| *byte == 0).nth(2)?;
            if *is_packed == 1 { unpacked(text)? } else { text.to_vec() }
        }
        _ => return None,
    };
    String::from_utf8(text).ok()
}

/// The text of the first element of that name, of whatever namespace, in what is not packed of an SVG or a PDF; of a page that of
/// its attribute.
fn in_markup(bytes: &[u8]) -> Option<String> {
    let element = format!(":{KEYWORD}>#");
    let openings = [(&*element, b'<'), (ATTRIBUTE, b'"')];
    let (opening, closing) = openings.into_iter().find(|(opening, _)| find(bytes, opening.as_bytes()).is_some())?;
    // From the # on.
    let text = &bytes[find(bytes, opening.as_bytes())? + opening.len() - 1..];
    let text = &text[..text.len().min(LONGEST + 1)];
    let end = text.iter().position(|byte| *byte == closing)?;
    Some(str::from_utf8(&text[..end]).ok()?.replace("&amp;", "&"))
}

/// Whether text begins with a tag, after a mark of UTF-8 or blanks.
fn is_markup(head: &[u8]) -> bool {
    let head = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
    head.trim_ascii_start().starts_with(b"<")
}

/// Where bytes stand among others first.
fn find(bytes: &[u8], wanted: &[u8]) -> Option<usize> {
    bytes.windows(wanted.len()).position(|window| window == wanted)
}

#[cfg(test)]
mod tests {
    use super::{LONGEST, PNG, Saying, kind_of_picture, read, remarks};
    use crate::scene::link::Link;
    use crate::scene::{SceneError, SceneFile, Theme, preset};
    use miniz_oxide::deflate::compress_to_vec_zlib;

    fn chunk(kind: &str, data: &[u8]) -> Vec<u8> {
        [&(data.len() as u32).to_be_bytes(), kind.as_bytes(), data, &[0; 4]].concat()
    }

    fn png(chunks: &[Vec<u8>]) -> Vec<u8> {
        [PNG, &chunk("IHDR", &[0; 13]), &chunks.concat(), &chunk("IEND", &[])].concat()
    }

    fn drawn() -> Result<(SceneFile, String), SceneError> {
        let mut file = preset("t-handle")?.read()?;
        file.view.world_camera.distance = Some(0.7);
        let said = remarks(Saying::Plain, String::new(), &file, None, -2.5, String::new());
        let link = said.into_iter().find_map(|(keyword, text)| (keyword == "Scene").then_some(text));
        Ok((file, link.unwrap_or_default()))
    }

    fn refused(bytes: &[u8]) -> String {
        read(bytes).map_or_else(|error| error.to_string(), |link| format!("{link:?}"))
    }

    #[test]
    fn every_picture_gives_back_the_scene_that_drew_it() -> Result<(), SceneError> {
        let (mut file, link) = drawn()?;
        (file.view.theme, file.view.labels) = (Some(Theme::Dark), Some(true));
        let packed = compress_to_vec_zlib(link.as_bytes(), 6);
        let text = |kind: &str, middle: &[u8], text: &[u8]| chunk(kind, &[b"Scene\0", middle, text].concat());
        let pixels = chunk("IDAT", &[7; 100]);
        let escaped = link.replace('&', "&amp;");
        let element = format!("<dz:Comment>:Scene</dz:Comment><dz:Scene>{escaped}</dz:Scene>");
        for bytes in [
            png(&[text("iTXt", b"\0\0\0\0", link.as_bytes()), pixels.clone()]),
            png(&[pixels.clone(), text("tEXt", b"", link.as_bytes())]),
            png(&[pixels.clone(), text("zTXt", b"\0", &packed)]),
            png(&[chunk("tEXt", b"Scenery\0no"), text("iTXt", b"\x01\0en\0Szene\0", &packed)]),
            format!("<?xml version=\"1.0\"?>\n<svg><metadata>{element}</metadata></svg>").into_bytes(),
            format!("<!doctype html>\n<html data-scene=\"{escaped}\">\n<p>").into_bytes(),
            [b"%PDF-1.7\n\xff\xfe\0", element.as_bytes(), b"\n%%EOF"].concat(),
        ] {
            let read = read(&bytes)?;
            assert!(kind_of_picture(&bytes).is_some());
            assert_eq!(read, Link { file: file.clone(), time: Some(-2.5), ..Link::default() });
        }
        Ok(())
    }

    #[test]
    fn what_carries_none_is_refused_in_one_sentence() -> Result<(), SceneError> {
        let (_, link) = drawn()?;
        let none = "carries no scene: only one that this program wrote, with its metadata, opens";
        let whole = png(&[chunk("tEXt", format!("Scene\0{link}").as_bytes())]);
        for cut in PNG.len()..whole.len() - 30 {
            assert!(refused(&whole[..cut]).ends_with(none), "{cut}");
        }
        assert!(refused(&png(&[])).starts_with("is a PNG picture that "));
        assert!(refused(b"<svg></svg>").starts_with("is an SVG picture that "));
        assert!(refused(b"<html></html>").starts_with("is a page that "));
        assert!(refused(b"%PDF-1.7").starts_with("is a PDF that "));
        // A length past the end, a text that would fill the memory, one that is no UTF-8.
        let bomb = compress_to_vec_zlib(&vec![b'#'; 1 << 24], 9);
        for bytes in [
            [PNG, &u32::MAX.to_be_bytes(), b"tEXtScene\0#flip"].concat(),
            png(&[chunk("zTXt", &[b"Scene\0\0", &*bomb].concat())]),
            png(&[chunk("tEXt", b"Scene\0#\xff")]),
            png(&[chunk("iTXt", b"Scene\0"), chunk("iTXt", b"Scene\0\0\0\0")]),
            [b"<svg><dz:Scene>#flip".to_vec(), vec![b'x'; LONGEST]].concat(),
        ] {
            assert!(refused(&bytes).ends_with(none), "{}", refused(&bytes));
        }
        assert_eq!(
            refused(b"<svg><dz:Scene>#flop</dz:Scene></svg>"),
            "is an SVG picture whose scene has a fault: scene `flop` is not known: the nearest is `flip`"
        );
        Ok(())
    }

    #[test]
    fn texts_of_scenes_are_no_pictures() -> Result<(), SceneError> {
        for text in ["", "title = \"<svg\"", "[spin]\n", "<xml></xml>", "\u{89}PNG"] {
            assert_eq!(kind_of_picture(text.as_bytes()), None, "{text}");
        }
        // The version is named where it is asked for, and nowhere else.
        let (file, _) = drawn()?;
        let said = |saying| format!("{:?}", remarks(saying, String::new(), &file, None, 0.0, String::new()));
        assert!(said(Saying::Full).contains(env!("CARGO_PKG_VERSION")));
        assert!(!said(Saying::Plain).contains(env!("CARGO_PKG_VERSION")));
        assert_eq!(said(Saying::Nothing), "[]");
        Ok(())
    }
}
