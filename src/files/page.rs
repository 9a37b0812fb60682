//! The page in one file: all that it is made of inlined, with the scene that it plays. It needs no server and no connection.

use std::fs;
use std::path::Path;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use miniz_oxide::deflate::compress_to_vec_zlib;

use super::FileError;

/// The page itself, among the files of its folder.
const INDEX: &str = "index.html";
/// The program, which alone is large.
const PROGRAM: &str = "dzhanibekov_bg.wasm";
/// Largest file of a page (bytes): some ten times the program as it is built for trials.
const LARGEST: u64 = 1 << 27;
/// Effort of packing the program, of 10: more takes several times as long for a hundredth less.
const EFFORT: u8 = 8;
/// What the page may load: nothing but what is in the file.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'unsafe-inline'; \
                      img-src data: blob:; base-uri 'none'; form-action 'none'";

/// Whether a folder holds a page.
#[must_use]
pub fn is_page(folder: &Path) -> bool {
    [INDEX, PROGRAM].iter().all(|name| folder.join(name).is_file())
}

/// The page of a folder as one file that shows the scene of this link and title; the query says how, as after the `?` of an
/// address.
///
/// # Errors
/// A file of the page that cannot be read, or a page that is not of the form that is known here: one sentence.
pub fn page(folder: &Path, link: &str, query: &str, title: &str) -> Result<String, FileError> {
    let text = |name: &str| {
        let path = folder.join(name);
        let bytes = bytes(&path)?;
        String::from_utf8(bytes).map_err(|_| FileError::read(&path, "is no UTF-8 text"))
    };
    let program = bytes(&folder.join(PROGRAM))?;
    let icon = STANDARD.encode(bytes(&folder.join("icon.svg"))?);
    let program = STANDARD.encode(compress_to_vec_zlib(&program, EFFORT));
    // Inside of another page that is a text of its own this script has no address.
    let glue = text("dzhanibekov.js")?.replace("document.currentScript.src", "document.baseURI");
    let parts = [
        (
            "<html ",
            ">",
            format!(
                "<html lang=\"en\" data-state=\"loading\" data-query=\"{}\" data-scene=\"{}\">",
                escaped(query),
                escaped(link)
            ),
        ),
        ("<title>", "</title>", format!("<title>{}</title>", escaped(title))),
        (
            "<meta http-equiv=\"Content-Security-Policy\"",
            ">",
            format!("<meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">"),
        ),
        ("<link rel=\"icon\"", ">", format!("<link rel=\"icon\" href=\"data:image/svg+xml;base64,{icon}\">")),
        ("<link rel=\"manifest\"", ">", String::new()),
        ("<link rel=\"preload\"", ">", String::new()),
        ("<link rel=\"stylesheet\"", ">", format!("<style>\n{}</style>", text("page.css")?)),
        (
            "<script src=\"dzhanibekov.js\"",
            "</script>",
            format!(
                "<script id=\"wasm\" type=\"text/plain\" data-packing=\"deflate\">{program}</script>\n<script>\n{}</script>",
                inside(&glue)
            ),
        ),
        ("<script src=\"page.js\"", "</script>", format!("<script>\n{}</script>", inside(&text("page.js")?))),
    ];
    inlined(&text(INDEX)?, &parts).map_err(|missing| {
        FileError::read(&folder.join(INDEX), format!("has no {missing}, as the page of this program has"))
    })
}

/// The text with each part, from its first letters to its last ones, in place of what was there; the first letters of one that is
/// not there once.
fn inlined<'a>(text: &str, parts: &[(&'a str, &str, String)]) -> Result<String, &'a str> {
    let mut whole = String::new();
    let mut rest = text;
    // In the order of the text: what was put in is not looked through.
    let mut places = vec![];
    for (first, last, part) in parts {
        let start = text.find(first).ok_or(*first)?;
        let end = start + text[start..].find(last).ok_or(*first)? + last.len();
        places.push((start, end, part));
    }
    places.sort_by_key(|(start, ..)| *start);
    let mut from = 0;
    for (start, end, part) in places {
        let (before, after) = rest.split_at(start - from);
        whole.push_str(before);
        whole.push_str(part);
        rest = &after[end - start..];
        from = end;
    }
    whole.push_str(rest);
    Ok(whole)
}

/// A script inside of a page, which ends at the first tag of that name.
fn inside(script: &str) -> String {
    script.replace("</script", "<\\/script").replace("<!--", "<\\!--")
}

/// Text as an attribute or an element holds it.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}

/// A file's bytes, within the bound.
fn bytes(path: &Path) -> Result<Vec<u8>, FileError> {
    let refused = |error: std::io::Error| FileError::read(path, format!("could not be read: {error}"));
    let length = fs::metadata(path).map_err(refused)?.len();
    if length > LARGEST {
        return Err(FileError::read(path, format!("is {length} bytes long, and at most {LARGEST} are read")));
    }
    fs::read(path).map_err(refused)
}

#[cfg(test)]
mod tests {
    use super::{is_page, page};
    use base64::Engine as _;
    use base64::engine::general_purpose::STANDARD;
    use miniz_oxide::inflate::decompress_to_vec_zlib;
    use std::path::Path;

    const INDEX: &str = r#"<!doctype html>
<html lang="en" data-state="loading">
<head>
<title>Dzhanibekov</title>
<meta http-equiv="Content-Security-Policy" content="default-src 'self'">
<link rel="icon" href="icon.svg" type="image/svg+xml">
<link rel="manifest" href="manifest.json">
<link rel="stylesheet" href="page.css">
<link rel="preload" href="dzhanibekov_bg.wasm" as="fetch">
</head>
<body>
<p>text</p>
<script src="dzhanibekov.js" defer></script>
<script src="page.js" defer data-bytes="7"></script>
</body>
</html>
"#;

    fn put(folder: &Path, index: &str) -> std::io::Result<()> {
        for (name, text) in [
            ("index.html", index),
            ("page.css", "p { color: red }\n"),
            ("dzhanibekov.js", "u = document.currentScript.src; s = '</script>';\n"),
            ("page.js", "go();\n"),
            ("icon.svg", "<svg/>"),
            ("dzhanibekov_bg.wasm", "\0asm and more"),
        ] {
            std::fs::write(folder.join(name), text)?;
        }
        Ok(())
    }

    #[test]
    fn a_page_in_one_file_loads_nothing_and_holds_its_scene() -> Result<(), Box<dyn std::error::Error>> {
        let folder = tempfile::tempdir()?;
        let folder = folder.path();
        assert!(!is_page(folder));
        put(folder, INDEX)?;
        assert!(is_page(folder));
        let text = page(folder, "#scene=abc&time=2", "embed=1", "A < B & \"C\"")?;
        for wanted in [
            "data-query=\"embed=1\" data-scene=\"#scene=abc&amp;time=2\">",
            "<title>A &lt; B &amp; &quot;C&quot;</title>",
            "<style>\np { color: red }\n</style>",
            "<script>\nu = document.baseURI; s = '<\\/script>';\n</script>",
            "<script>\ngo();\n</script>\n</body>",
            "<p>text</p>",
        ] {
            assert!(text.contains(wanted), "{wanted} is not in\n{text}");
        }
        for outside in ["src=", "stylesheet", "manifest", "preload", "icon.svg", "'self'"] {
            assert!(!text.contains(outside), "{outside} is in\n{text}");
        }
        let (_, packed) = text.split_once("data-packing=\"deflate\">").ok_or("no program")?;
        let packed = STANDARD.decode(packed.split('<').next().unwrap_or_default())?;
        assert_eq!(decompress_to_vec_zlib(&packed).map_err(|error| error.to_string())?, b"\0asm and more");
        Ok(())
    }

    #[test]
    fn another_page_is_refused() -> Result<(), Box<dyn std::error::Error>> {
        let folder = tempfile::tempdir()?;
        let refused = |folder: &Path| page(folder, "#flip", "", "").unwrap_or_else(|error| error.to_string());
        assert!(refused(folder.path()).contains("dzhanibekov_bg.wasm: could not be read"));
        put(folder.path(), &INDEX.replace("page.js", "other.js"))?;
        let why = refused(folder.path());
        assert!(why.ends_with("index.html: has no <script src=\"page.js\", as the page of this program has"), "{why}");
        Ok(())
    }
}
