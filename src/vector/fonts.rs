//! The fonts of a figure: the letters that it uses, cut out of the typefaces, or their outlines.

use std::collections::BTreeMap;

use ab_glyph::{Font, FontRef, GlyphId, OutlineCurve, Point};
use glam::DVec2;
use subsetter::GlyphRemapper;

use super::drawing::{Paint, Path, Pen, Shape, Step, Words};
use crate::render::{Letter, TYPEFACES};

/// The letters of a figure that are of one typeface.
pub(super) struct UsedFont {
    /// Its place among the typefaces.
    pub(super) number: usize,
    /// Its glyphs, by characters.
    pub(super) glyphs: BTreeMap<char, u16>,
    /// Their new numbers.
    remapper: GlyphRemapper,
}

impl UsedFont {
    /// The typefaces of these letters, each once.
    pub(super) fn all<'a>(letters: impl Iterator<Item = &'a Letter>) -> Vec<Self> {
        let mut fonts: BTreeMap<usize, BTreeMap<char, u16>> = BTreeMap::new();
        for letter in letters {
            fonts.entry(letter.font).or_default().insert(letter.character, letter.glyph);
        }
        let with_numbers = fonts.into_iter().map(|(number, glyphs)| {
            let mut remapper = GlyphRemapper::new();
            for glyph in glyphs.values() {
                remapper.remap(*glyph);
            }
            Self { number, glyphs, remapper }
        });
        with_numbers.collect()
    }

    /// The number of a glyph in the cut out font.
    pub(super) fn glyph(&self, old: u16) -> u16 {
        self.remapper.get(old).unwrap_or(0)
    }

    /// The cut out font, as documents embed it: glyphs by their numbers alone.
    pub(super) fn cut_out(&self) -> Option<Vec<u8>> {
        subsetter::subset(TYPEFACES.get(self.number)?, 0, &self.remapper).ok()
    }

    /// Width of a glyph, in thousandths of an em.
    pub(super) fn width(&self, old: u16) -> f32 {
        let font = TYPEFACES.get(self.number).and_then(|bytes| FontRef::try_from_slice(bytes).ok());
        let units = font.as_ref().and_then(Font::units_per_em).unwrap_or(1000.0);
        font.map_or(0.0, |font| font.h_advance_unscaled(GlyphId(old)) / units * 1000.0)
    }

    /// What is above and below the base line, in thousandths of an em.
    pub(super) fn reach(&self) -> [f32; 2] {
        let font = TYPEFACES.get(self.number).and_then(|bytes| FontRef::try_from_slice(bytes).ok());
        let units = font.as_ref().and_then(Font::units_per_em).unwrap_or(1000.0);
        font.map_or([0.0; 2], |font| [font.ascent_unscaled(), font.descent_unscaled()].map(|far| far / units * 1000.0))
    }

    /// The cut out font as browsers take it: with the table from characters to glyphs, and what they ask for besides.
    pub(super) fn for_browsers(&self) -> Option<Vec<u8>> {
        let whole = *TYPEFACES.get(self.number)?;
        let cut_out = self.cut_out()?;
        let mut tables: BTreeMap<[u8; 4], Vec<u8>> =
            tables(&cut_out).map(|(tag, bytes)| (tag, bytes.to_vec())).collect();
        for (tag, bytes) in self::tables(whole).filter(|(tag, _)| [*b"OS/2", *b"name", *b"post"].contains(tag)) {
            tables.entry(tag).or_insert_with(|| bytes.to_vec());
        }
        // Names of glyphs are of no use: version 3 of the table has none.
        if let Some(post) = tables.get_mut(b"post") {
            post.truncate(32);
            if let Some(version) = post.get_mut(..4) {
                version.copy_from_slice(&[0, 3, 0, 0]);
            }
        }
        tables.insert(*b"cmap", self.character_map());
        Some(assembled(&tables))
    }

    /// The table from characters to glyphs: one of format 12, a group each.
    fn character_map(&self) -> Vec<u8> {
        let mut map = vec![];
        let groups = self.glyphs.len() as u32;
        // Version 0 with one table, of the platform 3 (Windows) and its encoding 10 (all of Unicode), at byte 12.
        for word in [0_u16, 1, 3, 10, 0, 12, 12, 0] {
            map.extend(word.to_be_bytes());
        }
        for word in [16 + 12 * groups, 0, groups] {
            map.extend(word.to_be_bytes());
        }
        for (character, glyph) in &self.glyphs {
            let character = u32::from(*character);
            for word in [character, character, u32::from(self.glyph(*glyph))] {
                map.extend(word.to_be_bytes());
            }
        }
        map
    }
}

/// Four bytes of a font as a number.
fn long(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_be_bytes(bytes.get(at..at + 4)?.try_into().ok()?))
}

/// The tables of a font by their names.
fn tables(font: &[u8]) -> impl Iterator<Item = ([u8; 4], &[u8])> {
    let count = long(font, 4).map_or(0, |word| word >> 16) as usize;
    (0..count).filter_map(move |number| {
        let at = 12 + 16 * number;
        let (start, length) = (long(font, at + 8)? as usize, long(font, at + 12)? as usize);
        Some((font.get(at..at + 4)?.try_into().ok()?, font.get(start..start + length)?))
    })
}

/// The sum of a table's words, by which readers tell whether it is whole.
fn checksum(bytes: &[u8]) -> u32 {
    bytes.chunks(4).fold(0, |sum: u32, chunk| {
        let mut word = [0; 4];
        word[..chunk.len()].copy_from_slice(chunk);
        sum.wrapping_add(u32::from_be_bytes(word))
    })
}

/// A font of these tables.
fn assembled(tables: &BTreeMap<[u8; 4], Vec<u8>>) -> Vec<u8> {
    let count = tables.len() as u16;
    let power = count.max(1).ilog2() as u16;
    let range = 16 << power;
    let mut font = vec![0, 1, 0, 0];
    for word in [count, range, power, 16 * count - range] {
        font.extend(word.to_be_bytes());
    }
    let mut body: Vec<u8> = vec![];
    let first = 12 + 16 * tables.len();
    let mut head = None;
    for (tag, bytes) in tables {
        let mut bytes = bytes.clone();
        if tag == b"head" && bytes.len() >= 12 {
            bytes[8..12].fill(0);
            head = Some(first + body.len());
        }
        font.extend(tag);
        for word in [checksum(&bytes), (first + body.len()) as u32, bytes.len() as u32] {
            font.extend(word.to_be_bytes());
        }
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        body.extend(bytes);
    }
    font.extend(body);
    if let Some(head) = head {
        let whole = 0xB1B0_AFBA_u32.wrapping_sub(checksum(&font));
        font[head + 8..head + 12].copy_from_slice(&whole.to_be_bytes());
    }
    font
}

/// A text as areas, or as the way of a pen as wide as its halo.
pub(super) fn outlines(words: &Words) -> Option<Shape> {
    let mut path = Path::default();
    for letter in &words.letters {
        let font = FontRef::try_from_slice(TYPEFACES.get(letter.font)?).ok()?;
        path.append(outline(&font, letter));
    }
    if path.0.is_empty() {
        return None;
    }
    let paint = Paint::Flat(words.color);
    Some(match words.halo {
        None => Shape::Fill { path, even_odd: false, paint },
        Some(reach) => Shape::Stroke { path, pen: Pen { width: 2.0 * reach, is_round: true }, paint },
    })
}

fn outline(font: &FontRef<'_>, letter: &Letter) -> Path {
    let Some(outline) = font.outline(GlyphId(letter.glyph)) else { return Path::default() };
    let scale = f64::from(letter.em) / f64::from(font.units_per_em().unwrap_or(1.0));
    let pen = DVec2::new(f64::from(letter.pen[0]), f64::from(letter.pen[1]));
    let place = |point: Point| pen + DVec2::new(f64::from(point.x), -f64::from(point.y)) * scale;
    let mut steps: Vec<Step> = vec![];
    let mut last: Option<Point> = None;
    for curve in outline.curves {
        let (from, to, step) = match curve {
            OutlineCurve::Line(a, b) => (a, b, Step::Line(place(b))),
            OutlineCurve::Quad(a, b, c) => (a, c, Step::Quadratic(place(b), place(c))),
            OutlineCurve::Cubic(a, b, c, d) => (a, d, Step::Cubic(place(b), place(c), place(d))),
        };
        if last != Some(from) {
            if last.is_some() {
                steps.push(Step::Close);
            }
            steps.push(Step::Move(place(from)));
        }
        steps.push(step);
        last = Some(to);
    }
    if last.is_some() {
        steps.push(Step::Close);
    }
    Path(steps)
}

#[cfg(test)]
mod tests {
    use super::UsedFont;
    use crate::camera::Camera;
    use crate::frame::{Area, Color, Frame, Note, Pane};
    use crate::render::{Letter, TYPEFACES, screen_layers};
    use ab_glyph::{Font, FontRef, InvalidFont};

    fn letters(text: &str) -> Vec<Letter> {
        let mut pane = Pane::new(Area::WHOLE, Camera::new(0.0, 0.0, 5.0), 0.0);
        pane.notes.push(Note { text: text.to_owned(), size: 20.0, color: Color::hex(0), swatch: None });
        let frame = Frame { background: Color::hex(0), transparent: false, font_scale: 1.0, panes: vec![pane] };
        screen_layers(&frame, [1280, 720])
            .into_iter()
            .flat_map(|layer| layer.texts)
            .flat_map(|text| text.letters)
            .collect()
    }

    #[test]
    fn fonts_of_a_figure_hold_its_letters_and_little_else() -> Result<(), InvalidFont> {
        // The arrow is of the second typeface; the index is a small 3.
        let letters = letters("ωM₃ = 0.5·10⁻² → ω");
        let fonts = UsedFont::all(letters.iter());
        assert_eq!(fonts.iter().map(|font| font.number).collect::<Vec<_>>(), [0, 1]);
        for used in &fonts {
            let bytes = used.for_browsers().unwrap_or_default();
            assert!(bytes.len() < 20_000, "{} bytes", bytes.len());
            let (cut_out, whole) = (FontRef::try_from_slice(&bytes)?, FontRef::try_from_slice(TYPEFACES[used.number])?);
            for letter in letters.iter().filter(|letter| letter.font == used.number) {
                let (new, old) = (cut_out.glyph_id(letter.character), whole.glyph_id(letter.character));
                assert_eq!((new.0, old.0), (used.glyph(letter.glyph), letter.glyph), "{}", letter.character);
                assert_eq!(cut_out.h_advance_unscaled(new), whole.h_advance_unscaled(old));
                let curves = |font: &FontRef<'_>, id| font.outline(id).map_or(0, |outline| outline.curves.len());
                assert_eq!(curves(&cut_out, new), curves(&whole, old), "{}", letter.character);
            }
            assert_eq!(cut_out.glyph_id('Q').0, 0);
        }
        Ok(())
    }
}
