//! What a figure says of itself, in a form that SVG and PDF share: an RDF description, as XMP packets hold them.
//!
//! Each remark is one element of the namespace [`NAMESPACE`], named by its keyword: `<dz:Comment>…</dz:Comment>`, its text with
//! `&`, `<` and `>` escaped and nothing else changed. An SVG has the description in its `<metadata>`, a PDF in the document's
//! metadata stream, which is never compressed: [`read_remarks`] finds either by looking through the bytes.

use std::fmt::Write as _;

use crate::render::png::Remark;

/// The namespace of the remarks.
const NAMESPACE: &str = "https://crates.io/crates/dzhanibekov#";

/// The description that holds the remarks.
pub(super) fn description(remarks: &[Remark]) -> String {
    let mut text = String::from("<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n");
    let _ = writeln!(text, "<rdf:Description rdf:about=\"\" xmlns:dz=\"{NAMESPACE}\">");
    for (keyword, remark) in remarks {
        let _ = writeln!(text, "<dz:{keyword}>{}</dz:{keyword}>", escaped(remark));
    }
    text.push_str("</rdf:Description>\n</rdf:RDF>");
    text
}

/// The packet that holds the remarks in a document, as XMP has it.
pub(super) fn packet(remarks: &[Remark]) -> String {
    let description = description(remarks);
    format!(
        "<?xpacket begin=\"\u{feff}\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n\
         {description}\n</x:xmpmeta>\n<?xpacket end=\"r\"?>"
    )
}

/// The remarks in the bytes of a figure, in order; none where it has none.
#[must_use]
pub fn read_remarks(bytes: &[u8]) -> Vec<(String, String)> {
    let text = String::from_utf8_lossy(bytes);
    let Some((_, rest)) = text.split_once(&format!("xmlns:dz=\"{NAMESPACE}\"")) else { return vec![] };
    let inside = rest.split_once("</rdf:Description>").map_or(rest, |(inside, _)| inside);
    let mut remarks = vec![];
    let mut rest = inside;
    while let Some((_, after)) = rest.split_once("<dz:") {
        let Some((keyword, after)) = after.split_once('>') else { break };
        let Some((value, after)) = after.split_once(&format!("</dz:{keyword}>")) else { break };
        remarks.push((keyword.to_owned(), unescaped(value)));
        rest = after;
    }
    remarks
}

/// Text as XML holds it.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

fn unescaped(text: &str) -> String {
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&apos;", "'").replace("&amp;", "&")
}

#[cfg(test)]
mod tests {
    use super::{description, read_remarks};

    #[test]
    fn remarks_come_back_as_they_were_said() {
        let said = [("Title", "a < b & \"c\" > ω\nover lines".to_owned()), ("Comment", "&lt;".to_owned())];
        let read = read_remarks(format!("before{}after", description(&said)).as_bytes());
        let expected: Vec<_> = said.iter().map(|(keyword, text)| ((*keyword).to_owned(), text.clone())).collect();
        assert_eq!(read, expected);
        assert_eq!(read_remarks(b"nothing"), []);
    }
}
