//! Notes: rows of text in the upper left corner of a pane, each after a swatch of what it explains. They lie on the screen, as
//! do the lines and markers of the swatches: places are pixels from the corner.

use glam::Vec2;

use super::glyphs::{Glyphs, TextLine};
use super::labels::Box2;
use crate::frame::{Color, Dash, Line, Marker, Note, Swatch};

/// From the rim of the pane (points).
const MARGIN: f32 = 14.0;
/// From the upper rim.
const ABOVE: f32 = 9.0;
/// Height of a row in heights of its text.
const ROW: f32 = 1.35;
/// Length of a swatch and the gap after it (points).
const SWATCH: f32 = 44.0;
const GAP: f32 = 10.0;
/// Between notes that stand side by side.
const BETWEEN: f32 = 12.0;
const LINE_WIDTH: f32 = 2.4;
const MARK_SIZE: f32 = 14.0;

/// A note in its place.
pub(super) struct PlacedNote {
    pub(super) line: TextLine,
    /// The upper left corner of the text.
    pub(super) low: Vec2,
    pub(super) color: Color,
    /// All that it takes of the pane, its swatch and the way from the rim too.
    pub(super) room: Box2,
    /// The swatch, and the left end of its line.
    swatch: Option<(Swatch, Vec2)>,
}

/// Lays out the notes of a pane of this size, with `point` pixels a point: what is too long is broken into rows, and what has
/// a swatch stands in as many columns as there is room for.
pub(super) fn lay_out(notes: &[Note], glyphs: &mut Glyphs, pixels: Vec2, point: f32) -> Vec<PlacedNote> {
    let room = pixels.x - 2.0 * MARGIN * point;
    let indent = (SWATCH + GAP) * point;
    let with_swatch = notes.iter().filter(|note| note.swatch.is_some());
    let widest = with_swatch.map(|note| glyphs.lay_out(&note.text, note.size * point).extent[0]).fold(0.0, f32::max);
    let column = indent + widest + BETWEEN * point;
    let columns = ((room + BETWEEN * point) / column).floor().max(1.0);
    let mut placed = vec![];
    let (mut bottom, mut taken) = (ABOVE * point, columns);
    for note in notes {
        let height = ROW * note.size * point;
        if let Some(swatch) = note.swatch {
            if taken >= columns {
                (bottom, taken) = (bottom + height, 0.0);
            }
            let left = Vec2::new(MARGIN * point + taken * column, bottom - 0.5 * height);
            let mut one = place(&note.text, note, glyphs, left + Vec2::X * indent, [room - indent, point]);
            one.swatch = Some((swatch, left));
            one.room.low.x = if taken == 0.0 { 0.0 } else { left.x };
            placed.push(one);
            taken += 1.0;
        } else {
            taken = columns;
            for row in rows(note, glyphs, room, point) {
                bottom += height;
                let left = Vec2::new(MARGIN * point, bottom - 0.5 * height);
                placed.push(place(&row, note, glyphs, left, [room, point]));
            }
        }
    }
    placed
}

/// A text of a note from the left end of its row's middle. One that is still too long for the room is set smaller.
fn place(text: &str, note: &Note, glyphs: &mut Glyphs, left: Vec2, [room, point]: [f32; 2]) -> PlacedNote {
    let mut line = glyphs.lay_out(text, note.size * point);
    if line.extent[0] > room {
        line = glyphs.lay_out(text, note.size * point * (room / line.extent[0]).max(0.3));
    }
    let extent = Vec2::from_array(line.extent);
    let low = (left - Vec2::new(0.0, 0.5 * extent.y)).round();
    let room = Box2 { low: Vec2::new(0.0, low.y), high: low + extent };
    PlacedNote { line, low, color: note.color, room, swatch: None }
}

/// The rows of a note in this much room (pixels): as many words in each as fit.
fn rows(note: &Note, glyphs: &mut Glyphs, room: f32, point: f32) -> Vec<String> {
    let mut fits = |text: &str| glyphs.lay_out(text, note.size * point).extent[0] <= room;
    if fits(&note.text) {
        return vec![note.text.clone()];
    }
    let mut rows: Vec<String> = vec![];
    for word in note.text.split(' ') {
        match rows.last_mut() {
            Some(row) if fits(&format!("{row} {word}")) => *row = format!("{row} {word}"),
            _ => rows.push(word.to_owned()),
        }
    }
    rows
}

/// What the swatches draw on the screen.
pub(super) fn swatches(notes: &[PlacedNote], point: f32) -> (Vec<Line>, Vec<Marker>) {
    let found = notes.iter().filter_map(|note| note.swatch);
    let found = found.map(|(Swatch { dash, mark, color, rim }, left)| {
        let ends = [left, left + Vec2::X * (SWATCH * point)].map(|place| place.extend(0.0));
        let dash = match dash {
            Dash::Solid => Dash::Solid,
            Dash::Dashed(period) => Dash::Dashed(period * point),
            Dash::Dotted(period) => Dash::Dotted(period * point),
        };
        let line = Line::new(ends, LINE_WIDTH, color).dashed(dash);
        let position = ends[0].midpoint(ends[1]);
        (line, Marker { position, size: MARK_SIZE, mark, color, rim, hidden: 0.0, moves: false })
    });
    found.unzip()
}

#[cfg(test)]
mod tests {
    use super::{MARGIN, lay_out, swatches};
    use crate::frame::{Color, Dash, Mark, Note, Swatch};
    use crate::render::glyphs::Glyphs;
    use glam::Vec2;

    fn note(text: &str, with_swatch: bool) -> Note {
        let color = Color::hex(0);
        let swatch = Swatch { dash: Dash::Dashed(10.0), mark: Mark::Disc, color, rim: color };
        Note { text: text.to_owned(), size: 17.0, color, swatch: with_swatch.then_some(swatch) }
    }

    #[test]
    fn notes_break_into_rows_and_those_with_swatches_stand_side_by_side() {
        let notes = [note("of so many words that they fill two rows", false), note("one", true), note("two", true)];
        for (width, rows) in [(640.0, 2), (200.0, 4)] {
            let placed = lay_out(&notes, &mut Glyphs::new(), Vec2::new(width, 400.0), 1.0);
            let mut tops: Vec<f32> = placed.iter().map(|note| note.low.y).collect();
            tops.dedup();
            assert_eq!(tops.len(), rows, "in {width}");
            for (number, one) in placed.iter().enumerate() {
                assert!(one.low.x >= MARGIN && one.low.x + one.line.extent[0] <= width - MARGIN + 1.0);
                let is_clear = |other: &super::PlacedNote| !one.room.meets(&other.room);
                assert!(placed[number + 1..].iter().all(is_clear), "in {width}");
            }
            let (lines, marks) = swatches(&placed, 1.0);
            assert_eq!((lines.len(), marks.len()), (2, 2));
        }
    }
}
