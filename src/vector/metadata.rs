//! What a figure says of itself, in a form that SVG and PDF share: an RDF description, as XMP packets hold them.
//!
//! Each remark is one element of the namespace [`NAMESPACE`], named by its keyword: `<dz:Comment>…</dz:Comment>`, its text with
//! `&`, `<` and `>` escaped and nothing else changed. An SVG has the description in its `<metadata>`, a PDF in the document's
//! metadata stream, which is never compressed: looking through the bytes finds it, as `scene::carried` does.

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

/// Text as XML holds it. For what it has no place for, as a file's name may have it, stands U+FFFD.
pub(super) fn escaped(text: &str) -> String {
    let has_no_place =
        |c: char| matches!(c, '\0'..='\u{8}' | '\u{b}' | '\u{c}' | '\u{e}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}');
    text.replace(has_no_place, "\u{fffd}").replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::{escaped, packet};

    #[test]
    fn remarks_are_said_as_they_are_but_for_what_markup_takes() {
        let said =
            packet(&[("Scene", "#flip?a&b".to_owned()), ("Comment", "a < b > &lt; \"ω\"\nover lines".to_owned())]);
        let expected =
            "<dz:Scene>#flip?a&amp;b</dz:Scene>\n<dz:Comment>a &lt; b &gt; &amp;lt; \"ω\"\nover lines</dz:Comment>\n";
        assert!(said.contains(expected), "{said}");
    }

    #[test]
    fn what_xml_has_no_place_for_is_replaced() {
        assert_eq!(escaped("a\u{1}\0\u{1f}\u{fffe}\t\n\r\u{85}é"), "a\u{fffd}\u{fffd}\u{fffd}\u{fffd}\t\n\r\u{85}é");
    }
}
