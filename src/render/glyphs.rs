//! The fonts, and the atlas of their glyphs at the pixel sizes in use.

use std::collections::HashMap;

use ab_glyph::{Font, FontRef, GlyphId, ScaleFont};

/// Width of the atlas in pixels, and the most that it is high.
const SIDE: u32 = 2048;
const HIGHEST: u32 = 4096;
/// Directions in which a halo is spread, and the opacity of its outer ring; the inner one is full.
const HALO_DIRECTIONS: u8 = 8;
pub(super) const HALO_OUTER: u16 = 154;
pub(super) const HALO_INNER: f32 = 0.6;
/// Largest em in pixels: beyond it the atlas would hold too few glyphs.
const LARGEST: f32 = 220.0;
/// Free pixels round each glyph.
const PADDING: u32 = 1;
/// Size and drop of an index, in parts of the text's size.
const INDEX_SIZE: f32 = 0.68;
const INDEX_DROP: f32 = 0.16;
/// Those of an exponent, which is read where an index is only recognised: its digits are 11 points high beside a label's of 19.
const EXPONENT_SIZE: f32 = 0.82;
const EXPONENT_RISE: f32 = -0.25;

/// A glyph drawn at one size: where it is in the atlas and beside the pen.
#[derive(Clone, Copy)]
struct Cell {
    source: [u32; 2],
    extent: [u32; 2],
    bearing: [f32; 2],
}

/// The typefaces, the usual one first; each of the others has what those before it lack.
pub static TYPEFACES: [&[u8]; 2] = [crate::typeface::SANS, crate::typeface::MONO];

/// A letter of a laid out text, in pixels from the text's top left corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Letter {
    /// The character that its font is asked for.
    pub character: char,
    /// Which of the [`TYPEFACES`] it is of.
    pub font: usize,
    /// Its number in the font.
    pub glyph: u16,
    /// Pixels an em.
    pub em: f32,
    /// Its origin: where the pen comes to, on the letter's own base line.
    pub pen: [f32; 2],
    /// Size as the rasteriser counts it.
    size: f32,
}

/// A font's number, one of its glyphs, its size in pixels an em and the radius of its halo, both as bits.
type Key = (usize, GlyphId, [u32; 2]);

/// A glyph of a laid out text, in pixels from the text's top left corner.
#[derive(Clone, Copy)]
pub(super) struct PlacedGlyph {
    key: Key,
    pub(super) low: [f32; 2],
    pub(super) extent: [u32; 2],
    pub(super) source: [u32; 2],
}

/// A text laid out on one line.
pub(super) struct TextLine {
    pub(super) letters: Vec<Letter>,
    pub(super) glyphs: Vec<PlacedGlyph>,
    pub(super) extent: [f32; 2],
}

/// Rasterises glyphs when they are first met and keeps them.
pub(super) struct Glyphs {
    fonts: Vec<FontRef<'static>>,
    cells: HashMap<Key, Option<Cell>>,
    /// Coverage, rows of [`SIDE`] bytes as far as they are in use.
    pixels: Vec<u8>,
    /// The shelf being filled: left end, top, height.
    shelf: [u32; 3],
    changed: bool,
    full: bool,
}

impl Glyphs {
    pub(super) const SIDE: u32 = SIDE;

    pub(super) fn new() -> Self {
        Self {
            fonts: TYPEFACES.iter().filter_map(|bytes| FontRef::try_from_slice(bytes).ok()).collect(),
            cells: HashMap::new(),
            pixels: vec![],
            shelf: [0; 3],
            changed: false,
            full: false,
        }
    }

    /// How many rows of the atlas are in use, and what they hold where that changed since the last call.
    pub(super) fn take_changed(&mut self) -> (u32, Option<&[u8]>) {
        let rows = (self.pixels.len() / SIDE as usize) as u32;
        (rows, (std::mem::take(&mut self.changed) && rows > 0).then_some(&*self.pixels))
    }

    /// Empties an atlas that has run full, so that the sizes now in use find room.
    pub(super) fn begin_frame(&mut self) {
        if std::mem::take(&mut self.full) {
            self.cells.clear();
            self.pixels.clear();
            self.shelf = [0; 3];
        }
    }

    /// Lays a text out on one line, `size` pixels an em. Indices (₁) and exponents (⁵) are digits set smaller and lower or higher,
    /// whether the font has them or not.
    pub(super) fn lay_out(&mut self, text: &str, size: f32) -> TextLine {
        let (letters, extent) = self.set(text, size);
        let mut glyphs = vec![];
        for letter in &letters {
            let (number, id, size) = (letter.font, GlyphId(letter.glyph), letter.size);
            let key = (number, id, [size.to_bits(), 0]);
            if let Some(cell) = self.cell(key, |glyphs| glyphs.rasterise(number, id, size)) {
                let [x, y] = letter.pen;
                glyphs.push(PlacedGlyph {
                    key,
                    low: [(x + cell.bearing[0]).round(), (y + cell.bearing[1]).round()],
                    extent: cell.extent,
                    source: cell.source,
                });
            }
        }
        TextLine { letters, glyphs, extent }
    }

    /// The letters of a text on one line, and its width and height.
    fn set(&self, text: &str, size: f32) -> (Vec<Letter>, [f32; 2]) {
        let size = size.min(LARGEST) * self.fonts.first().and_then(height_per_em).unwrap_or(1.0);
        let Some(first) = self.fonts.first() else { return (vec![], [0.0; 2]) };
        let scaled = first.as_scaled(size);
        let (ascent, height) = (scaled.ascent(), scaled.height());
        let mut pen = 0.0;
        let mut before = None;
        let mut after_letter = false;
        let mut letters = vec![];
        for character in text.chars() {
            let (character, part, drop) = match character {
                // Of a unit (m²), which is known at a glance: as the font has it.
                '²' | '³' if after_letter => (character, 1.0, 0.0),
                _ => set_apart(character),
            };
            after_letter = character.is_alphabetic();
            let drop = size * drop;
            let size = size * part;
            let Some(number) =
                self.fonts.iter().position(|font| font.glyph_id(character).0 != 0).or(Some(0)).filter(|_| size > 0.5)
            else {
                continue;
            };
            let font = self.fonts[number].as_scaled(size);
            let id = font.glyph_id(character);
            if let Some((font_before, id_before)) = before
                && font_before == number
                && character != ' '
            {
                pen += font.kern(id_before, id);
            }
            let em = size / height_per_em(&self.fonts[number]).unwrap_or(1.0);
            letters.push(Letter { character, font: number, glyph: id.0, em, pen: [pen, ascent + drop], size });
            pen += font.h_advance(id);
            before = Some((number, id));
        }
        (letters, [pen, height])
    }

    /// The halo of a glyph, this many pixels wide: what of it is under the glyph too.
    pub(super) fn halo(&mut self, glyph: &PlacedGlyph, radius: f32) -> Option<PlacedGlyph> {
        let (number, id, [size, _]) = glyph.key;
        let key = (number, id, [size, radius.to_bits()]);
        let rim = radius.ceil() as u32 + 1;
        let cell = self.cell(key, |glyphs| glyphs.spread(glyph, radius, rim))?;
        let low = glyph.low.map(|side| side - rim as f32);
        Some(PlacedGlyph { key, low, extent: cell.extent, source: cell.source })
    }

    fn cell(&mut self, key: Key, make: impl FnOnce(&mut Self) -> Option<Cell>) -> Option<Cell> {
        if let Some(cell) = self.cells.get(&key) {
            return *cell;
        }
        let cell = make(self);
        self.cells.insert(key, cell);
        cell
    }

    fn rasterise(&mut self, number: usize, id: GlyphId, size: f32) -> Option<Cell> {
        let outline = self.fonts[number].outline_glyph(id.with_scale(size))?;
        let bounds = outline.px_bounds();
        let extent = [bounds.width() as u32, bounds.height() as u32];
        let source = self.reserve(extent)?;
        outline.draw(|x, y, coverage| {
            let at = ((source[1] + y) * SIDE + source[0] + x) as usize;
            if let Some(pixel) = self.pixels.get_mut(at) {
                *pixel = (coverage.clamp(0.0, 1.0) * 255.0).round() as u8;
            }
        });
        Some(Cell { source, extent, bearing: [bounds.min.x, bounds.min.y] })
    }

    /// Draws a glyph's halo: the most of what the glyph covers on two rings round each pixel, with so wide a rim.
    fn spread(&mut self, glyph: &PlacedGlyph, radius: f32, rim: u32) -> Option<Cell> {
        let [width, height] = glyph.extent;
        let extent = [width + 2 * rim, height + 2 * rim];
        let source = self.reserve(extent)?;
        let ring = |factor: f32| {
            let directions = (0..HALO_DIRECTIONS).map(f32::from);
            directions.map(move |n| glam::Vec2::from_angle(n * std::f32::consts::FRAC_PI_4) * (radius * factor))
        };
        // In 256ths.
        let rings = ring(1.0).map(|away| (away, HALO_OUTER)).chain(ring(HALO_INNER).map(|away| (away, 256)));
        let middle = std::iter::once((glam::Vec2::ZERO, 256));
        let mut cover = vec![0; (extent[0] * extent[1]) as usize];
        for (away, factor) in rings.chain(middle) {
            let [left, top] = away.to_array().map(|side| (side.round() + rim as f32).max(0.0) as usize);
            for row in 0..height {
                let from = ((glyph.source[1] + row) * SIDE + glyph.source[0]) as usize;
                let to = (top + row as usize) * extent[0] as usize + left;
                let ink = self.pixels.get(from..from + width as usize)?;
                let halo = cover.get_mut(to..to + width as usize)?;
                for (halo, ink) in halo.iter_mut().zip(ink) {
                    *halo = (*halo).max(((u16::from(*ink) * factor) >> 8) as u8);
                }
            }
        }
        for (row, line) in cover.chunks_exact(extent[0] as usize).enumerate() {
            let to = (source[1] as usize + row) * SIDE as usize + source[0] as usize;
            self.pixels.get_mut(to..to + line.len())?.copy_from_slice(line);
        }
        Some(Cell { source, extent, bearing: [0.0; 2] })
    }

    /// Room for a glyph, on the open shelf or a new one.
    fn reserve(&mut self, [width, height]: [u32; 2]) -> Option<[u32; 2]> {
        let (wide, high) = (width + PADDING, height + PADDING);
        if self.shelf[0] + wide > SIDE {
            self.shelf = [0, self.shelf[1] + self.shelf[2], 0];
        }
        if wide > SIDE || self.shelf[1] + high > HIGHEST {
            self.full = true;
            return None;
        }
        self.changed = true;
        let rows = (self.shelf[1] + self.shelf[2].max(high)) as usize;
        if self.pixels.len() < rows * SIDE as usize {
            self.pixels.resize(rows * SIDE as usize, 0);
        }
        let place = [self.shelf[0], self.shelf[1]];
        self.shelf[0] += wide;
        self.shelf[2] = self.shelf[2].max(high);
        Some(place)
    }
}

/// What stands for a character, its size and its drop in parts of the text's size.
fn set_apart(character: char) -> (char, f32, f32) {
    const EXPONENTS: [char; 11] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹', '⁻'];
    const DIGITS: [char; 11] = ['0', '1', '2', '3', '4', '5', '6', '7', '8', '9', '−'];
    if let '₀'..='₉' = character {
        return (DIGITS[character as usize - '₀' as usize], INDEX_SIZE, INDEX_DROP);
    }
    let exponent = EXPONENTS.iter().position(|high| *high == character);
    exponent.map_or((character, 1.0, 0.0), |place| (DIGITS[place], EXPONENT_SIZE, EXPONENT_RISE))
}

/// What the rasteriser counts as a font's height, in ems.
fn height_per_em(font: &FontRef<'_>) -> Option<f32> {
    font.units_per_em().map(|units| font.height_unscaled() / units)
}

#[cfg(test)]
mod tests {
    use super::Glyphs;

    #[test]
    fn exponents_are_read_from_a_distance() {
        let mut glyphs = Glyphs::new();
        // As the moments are written beside the axes, in a picture 720 pixels high.
        let line = glyphs.lay_out("2·10⁻⁵", 19.0);
        let [base, exponent] = [&line.glyphs[0], &line.glyphs[5]].map(|glyph| (glyph.low[1], glyph.extent[1]));
        assert!(exponent.1 >= 11, "{exponent:?}");
        // Higher than the base's, and within the line.
        assert!(exponent.0 < base.0 && exponent.0 >= 0.0, "{exponent:?} {base:?}");
    }

    #[test]
    fn a_halo_lies_all_round_its_glyph() {
        let mut glyphs = Glyphs::new();
        let line = glyphs.lay_out("I", 24.0);
        let ink = line.glyphs[0];
        let halo = glyphs.halo(&ink, 2.4).map(|halo| (halo.low, halo.extent, halo.source));
        // Two pixels and most of a third, and one to spare.
        let expected = (ink.low.map(|side| side - 4.0), ink.extent.map(|side| side + 8));
        let Some((low, extent, source)) = halo else { unreachable!("there is room for it") };
        assert_eq!((low, extent), expected);
        let (_, pixels) = glyphs.take_changed();
        let at = |[x, y]: [u32; 2]| {
            pixels.map_or(0, |pixels| pixels[((source[1] + y) * super::SIDE + source[0] + x) as usize])
        };
        let row = extent[1] / 2;
        let is_inked = |x: &u32| at([*x, row]) == 255;
        let Some(first) = (0..extent[0]).find(is_inked) else { unreachable!("a stem has ink") };
        // The stem's own full column, and what spreads of it: in full to 0.6 of the radius, then fainter, and at last not at all.
        let ring = [first, first - 1, first - 2].map(|x| at([x, row]));
        assert_eq!(ring[0], 255);
        assert!(ring[1] >= 153 && ring[1] < 255 && ring[2] < ring[1], "{ring:?}");
        assert_eq!(at([0, row]), 0);
    }
}
