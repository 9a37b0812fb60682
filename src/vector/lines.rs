//! Lines as ways of a pen: cut where surfaces hide them, dashed, and simplified to what can be seen.

use glam::{DMat4, DVec2, DVec3};

use super::drawing::{Paint, Path, Pen, Shape, Step};
use super::sight::{Before, Sight};
use crate::camera::NEAR;
use crate::frame::{Color, Dash, Line};

/// Farthest (pixels) that a simplified way passes a point that is left out.
const TOLERANCE: f64 = 0.04;
/// A colour that is passed no farther than this needs no stop of its own.
const COLOR_TOLERANCE: f32 = 0.5 / 255.0;
/// Shorter pieces (pixels) are not drawn: they are where a line and what hides it touch.
const SHORTEST: f64 = 0.05;
/// How far (rad) a piece that is painted along its chord may turn: its ends then look along the chord within half of it.
const WIDEST_TURN: f64 = 1.2;

/// From a pane's world, or what lies flat before it, to pixels of the figure.
#[derive(Clone, Copy, Debug)]
pub(super) struct Projection {
    /// Takes places to clip space.
    pub(super) clip: DMat4,
    /// The upper left corner of the pane (pixels).
    pub(super) corner: DVec2,
    /// Its width and height.
    pub(super) pixels: DVec2,
    /// Pixels a point of the frame.
    pub(super) point: f64,
    /// Thinnest pen (pixels).
    pub(super) thinnest: f64,
}

impl Projection {
    /// Where a place that is before the eye is seen.
    pub(super) fn pixel(&self, at: DVec3) -> Option<DVec2> {
        let clip = self.clip * at.extend(1.0);
        let ndc = DVec2::new(clip.x, clip.y) / clip.w;
        (clip.w >= f64::from(NEAR) * (1.0 - 1e-9))
            .then(|| self.corner + (ndc * DVec2::new(0.5, -0.5) + 0.5) * self.pixels)
    }

    /// The part of a straight piece before the near plane, as parameters.
    fn in_front(&self, from: DVec3, to: DVec3) -> Option<[f64; 2]> {
        let depth = |at: DVec3| (self.clip * at.extend(1.0)).w - f64::from(NEAR);
        match (depth(from), depth(to)) {
            (a, b) if a >= 0.0 && b >= 0.0 => Some([0.0, 1.0]),
            (a, b) if a < 0.0 && b < 0.0 => None,
            (a, b) if a < 0.0 => Some([a / (a - b), 1.0]),
            (a, b) => Some([0.0, a / (a - b)]),
        }
    }
}

/// A point of a line on the screen.
#[derive(Clone, Copy, Debug)]
struct Spot {
    pixel: DVec2,
    /// Length of the line up to here, in its pane's world.
    along: f64,
    color: Color,
}

/// A piece of a line that is seen as a whole, or hidden as a whole.
#[derive(Clone, Debug)]
struct Piece {
    is_hidden: bool,
    spots: Vec<Spot>,
    /// Whether it begins, and ends, where the line does.
    free: [bool; 2],
    is_closed: bool,
}

/// Which pieces of a line are drawn, and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// What is seen.
    Seen,
    /// What anything hides, fainter.
    Hidden,
    /// What opaque bodies do not hide, fainter: it is inside of something hollow.
    Inside,
}

/// Adds a part of a line.
pub(super) fn draw(line: &Line, part: Part, sight: &Sight, projection: &Projection, shapes: &mut Vec<Shape>) {
    let factor = if part == Part::Seen { 1.0 } else { line.hidden };
    if factor <= 0.0 {
        return;
    }
    let before = if part == Part::Inside { Before::Opaque } else { Before::All };
    let pieces = pieces(line, sight, before, projection);
    let pen = Pen { width: (f64::from(line.width) * projection.point).max(projection.thinnest), is_round: true };
    for piece in pieces.into_iter().filter(|piece| piece.is_hidden == (part == Part::Hidden)) {
        let (dashes, period) = match line.dash {
            Dash::Solid => (vec![piece], 0.0),
            Dash::Dashed(period) => (dashes(&piece, f64::from(period), pen.width, false), f64::from(period)),
            Dash::Dotted(period) => (dashes(&piece, f64::from(period), pen.width, true), f64::from(period)),
        };
        if period > 0.0 && is_plain(&dashes) {
            stroke_together(dashes, factor, pen, shapes);
        } else {
            for dash in dashes {
                stroke(dash, factor, pen, shapes);
            }
        }
    }
}

/// The pieces of a line.
fn pieces(line: &Line, sight: &Sight, before: Before, projection: &Projection) -> Vec<Piece> {
    let points = &line.points;
    // A pattern begins and ends where the line does, closed or not.
    let is_solid = line.dash == Dash::Solid;
    let is_closed =
        is_solid && points.len() > 2 && points.first().map(|p| p.position) == points.last().map(|p| p.position);
    let mut pieces: Vec<Piece> = vec![];
    let mut along = 0.0;
    // Whether the last piece goes on.
    let mut goes_on = false;
    for (number, pair) in points.windows(2).enumerate() {
        let [from, to] = [pair[0].position, pair[1].position].map(glam::Vec3::as_dvec3);
        let length = from.distance(to);
        let spot = |t: f64| {
            let color = pair[0].color.mix(pair[1].color, t as f32);
            let pixel = projection.pixel(from.lerp(to, t))?;
            Some(Spot { pixel, along: along + t * length, color })
        };
        let Some([first, last]) = projection.in_front(from, to) else {
            (goes_on, along) = (false, along + length);
            continue;
        };
        let hidden = sight.hidden(from, to, before);
        let mut cuts = vec![(first, false)];
        for [low, high] in hidden {
            let [low, high] = [low.max(first), high.min(last)];
            if low < high {
                cuts.push((low, true));
                cuts.push((high, false));
            }
        }
        for (place, &(start, is_hidden)) in cuts.iter().enumerate() {
            let end = cuts.get(place + 1).map_or(last, |next| next.0);
            if end <= start {
                continue;
            }
            let (Some(a), Some(b)) = (spot(start), spot(end)) else { continue };
            let is_free = number == 0 && start == 0.0 && !is_closed;
            match pieces.last_mut() {
                Some(piece) if goes_on && piece.is_hidden == is_hidden => piece.spots.push(b),
                _ => pieces.push(Piece { is_hidden, spots: vec![a, b], free: [is_free, false], is_closed: false }),
            }
            goes_on = true;
            if number + 2 == points.len()
                && end == 1.0
                && !is_closed
                && let Some(piece) = pieces.last_mut()
            {
                piece.free[1] = true;
            }
        }
        goes_on &= last == 1.0;
        along += length;
    }
    if is_closed && goes_on {
        close(&mut pieces);
    }
    // Only joined pieces are long enough to be judged.
    pieces.retain(|piece| length(&piece.spots) > SHORTEST || piece.free == [true; 2]);
    pieces
}

/// Joins the last piece of a closed line to the first one.
fn close(pieces: &mut Vec<Piece>) {
    let begins_anew = |pieces: &[Piece]| {
        let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else { return false };
        let gap = first.spots.first().zip(last.spots.last()).map(|(a, b)| a.pixel.distance(b.pixel));
        first.is_hidden == last.is_hidden && gap.is_some_and(|gap| gap < 1e-6)
    };
    if !begins_anew(pieces) {
        return;
    }
    if pieces.len() == 1 {
        pieces[0].is_closed = true;
    } else if let Some(mut last) = pieces.pop() {
        let first = &mut pieces[0];
        last.spots.extend(first.spots.drain(1..));
        first.spots = last.spots;
    }
}

fn length(spots: &[Spot]) -> f64 {
    spots.windows(2).map(|pair| pair[0].pixel.distance(pair[1].pixel)).sum()
}

/// The dashes of a piece: round ones within, so long that they end in the middle of their caps at a quarter and three quarters
/// of the period, as the renderer's; those that are cut with the piece end there.
fn dashes(piece: &Piece, period: f64, width: f64, is_dotted: bool) -> Vec<Piece> {
    let (Some(first), Some(last)) = (piece.spots.first(), piece.spots.last()) else { return vec![] };
    let mut dashes = vec![];
    for number in (first.along / period).floor() as i64..=(last.along / period).floor() as i64 {
        let middle = (number as f64 + 0.5) * period;
        // Half a pen's width here, in lengths of the world.
        let Some(per_pixel) = scale_at(piece, middle) else { continue };
        let cap = 0.5 * width * per_pixel;
        let half = if is_dotted { 0.0 } else { (0.25 * period - 0.5 * cap).max(0.0) };
        let [low, high] = [middle - half, middle + half];
        let is_whole =
            low - cap >= first.along && high + cap <= last.along || piece.is_closed || piece.free == [true; 2];
        let (low, high) = if is_whole { (low, high) } else { (low - 0.785 * cap, high + 0.785 * cap) };
        let [low, high] = [low, high].map(|at| at.clamp(first.along, last.along));
        let spots = between(&piece.spots, low, high);
        if !spots.is_empty() && (is_whole || high > low) {
            dashes.push(Piece { spots, free: [is_whole; 2], is_hidden: piece.is_hidden, is_closed: false });
        }
    }
    dashes
}

/// Lengths of the world a pixel where a piece is this long.
fn scale_at(piece: &Piece, along: f64) -> Option<f64> {
    let at = piece.spots.partition_point(|spot| spot.along < along).clamp(1, piece.spots.len() - 1);
    let (a, b) = (piece.spots[at - 1], piece.spots[at]);
    let pixels = a.pixel.distance(b.pixel);
    (pixels > 0.0).then(|| (b.along - a.along) / pixels)
}

/// The spots of a way between two lengths.
fn between(spots: &[Spot], low: f64, high: f64) -> Vec<Spot> {
    let at = |along: f64| {
        let next = spots.partition_point(|spot| spot.along < along).clamp(1, spots.len() - 1);
        let (a, b) = (spots[next - 1], spots[next]);
        let part = if b.along > a.along { ((along - a.along) / (b.along - a.along)).clamp(0.0, 1.0) } else { 0.0 };
        Spot { pixel: a.pixel.lerp(b.pixel, part), along, color: a.color.mix(b.color, part as f32) }
    };
    if spots.len() < 2 {
        return vec![];
    }
    let inner = spots.iter().filter(|spot| spot.along > low && spot.along < high).copied();
    std::iter::once(at(low)).chain(inner).chain([at(high)]).collect()
}

/// Whether pieces have one colour and all their own ends.
fn is_plain(pieces: &[Piece]) -> bool {
    let color = pieces.first().and_then(|piece| piece.spots.first()).map(|spot| spot.color);
    pieces.iter().all(|piece| piece.spots.iter().all(|spot| Some(spot.color) == color))
}

/// Dashes of one colour, as one path for those with round ends and one for those that are cut.
fn stroke_together(pieces: Vec<Piece>, factor: f32, pen: Pen, shapes: &mut Vec<Shape>) {
    let Some(color) = pieces.first().and_then(|piece| piece.spots.first()).map(|spot| spot.color) else { return };
    let mut paths = [Path::default(), Path::default()];
    for piece in pieces {
        let is_round = piece.free == [true; 2];
        paths[usize::from(is_round)].append(path(&piece));
    }
    for (path, is_round) in paths.into_iter().zip([false, true]) {
        if !path.0.is_empty() {
            shapes.push(Shape::Stroke { path, pen: Pen { is_round, ..pen }, paint: Paint::Flat(color.fade(factor)) });
        }
    }
}

/// The simplified way of a piece.
fn path(piece: &Piece) -> Path {
    let pixels: Vec<DVec2> = piece.spots.iter().map(|spot| spot.pixel).collect();
    let mut kept = simplified(&pixels, TOLERANCE);
    if piece.is_closed {
        kept.pop();
    }
    let mut path = Path::through(kept, piece.is_closed);
    // A dot.
    if let [Step::Move(at)] = path.0[..] {
        path.0.push(Step::Line(at + DVec2::new(0.01, 0.0)));
    }
    path
}

/// Adds a piece as one way, or in parts that are each painted along their chord where its colour changes.
fn stroke(mut piece: Piece, factor: f32, pen: Pen, shapes: &mut Vec<Shape>) {
    for spot in &mut piece.spots {
        spot.color = spot.color.fade(factor);
    }
    let Some(&Spot { color, .. }) = piece.spots.first() else { return };
    // Where one end alone is cut the other is drawn as long as half of its cap is in area.
    if piece.free[0] != piece.free[1] {
        lengthen(&mut piece, 0.5 * 0.785 * pen.width);
    }
    let pen = Pen { is_round: piece.free == [true; 2], ..pen };
    if piece.spots.iter().all(|spot| spot.color == color) {
        if color.0[3] > 0.0 {
            shapes.push(Shape::Stroke { path: path(&piece), pen, paint: Paint::Flat(color) });
        }
        return;
    }
    for spots in straight_parts(&piece.spots) {
        let (Some(first), Some(last)) = (spots.first(), spots.last()) else { continue };
        if spots.iter().all(|spot| spot.color.0[3] <= 0.0) {
            continue;
        }
        let (from, to) = (first.pixel, last.pixel);
        let way = to - from;
        let part = |spot: &Spot| ((spot.pixel - from).dot(way) / way.length_squared().max(1e-12)).clamp(0.0, 1.0);
        let stops = simplified_colors(&spots.iter().map(|spot| (part(spot), spot.color)).collect::<Vec<_>>());
        let paint = Paint::Along { from, to, stops };
        let path =
            Path::through(simplified(&spots.iter().map(|spot| spot.pixel).collect::<Vec<_>>(), TOLERANCE), false);
        shapes.push(Shape::Stroke { path, pen: Pen { is_round: false, ..pen }, paint });
    }
}

/// Draws a piece's free end out by some pixels.
fn lengthen(piece: &mut Piece, by: f64) {
    let count = piece.spots.len();
    let (end, before) = if piece.free[0] { (0, 1) } else { (count - 1, count - 2) };
    let [end_at, before_at] = [piece.spots[end].pixel, piece.spots[before].pixel];
    piece.spots[end].pixel += (end_at - before_at).normalize_or_zero() * by;
}

/// A way in parts that turn little.
fn straight_parts(spots: &[Spot]) -> Vec<&[Spot]> {
    let mut parts = vec![];
    let mut start = 0;
    let mut turned = [0.0_f64; 2];
    let mut angle = 0.0;
    let direction = |at: usize| spots[at + 1].pixel - spots[at].pixel;
    for at in 1..spots.len().saturating_sub(1) {
        let (before, after) = (direction(at - 1), direction(at));
        if before != DVec2::ZERO && after != DVec2::ZERO {
            angle += before.angle_to(after);
        }
        turned = [turned[0].min(angle), turned[1].max(angle)];
        if turned[1] - turned[0] > WIDEST_TURN {
            parts.push(&spots[start..=at]);
            (start, angle, turned) = (at, 0.0, [0.0; 2]);
        }
    }
    if start + 1 < spots.len() {
        parts.push(&spots[start..]);
    }
    parts
}

/// Leaves out the points that the straight ways between the others pass within a tolerance (Douglas and Peucker).
pub(super) fn simplified(points: &[DVec2], tolerance: f64) -> Vec<DVec2> {
    let mut is_kept = vec![false; points.len()];
    let mut open = vec![(0, points.len().saturating_sub(1))];
    while let Some((from, to)) = open.pop() {
        for end in [from, to] {
            if let Some(kept) = is_kept.get_mut(end) {
                *kept = true;
            }
        }
        if to < from + 2 {
            continue;
        }
        let way = points[to] - points[from];
        let away = |point: DVec2| {
            let part = ((point - points[from]).dot(way) / way.length_squared().max(1e-12)).clamp(0.0, 1.0);
            point.distance(points[from] + way * part)
        };
        let inner = (from + 1..to).map(|at| (at, away(points[at])));
        if let Some((at, far)) = inner.max_by(|a, b| a.1.total_cmp(&b.1))
            && far > tolerance
        {
            open.extend([(from, at), (at, to)]);
        }
    }
    let mut kept: Vec<DVec2> =
        points.iter().zip(is_kept).filter_map(|(point, is_kept)| is_kept.then_some(*point)).collect();
    kept.dedup();
    kept
}

/// Leaves out the colours that lie between the others, as near as can be seen.
fn simplified_colors(stops: &[(f64, Color)]) -> Vec<(f64, Color)> {
    let Some((&first, &last)) = stops.first().zip(stops.last()) else { return vec![] };
    let mut kept = vec![first];
    let mut start = 0;
    for end in 2..stops.len() {
        let (from, to) = (stops[start], stops[end]);
        let is_passed = |(at, color): &(f64, Color)| {
            let part = ((at - from.0) / (to.0 - from.0).max(1e-12)) as f32;
            let passed = from.1.mix(to.1, part);
            color.0.iter().zip(passed.0).all(|(a, b)| (a - b).abs() < COLOR_TOLERANCE)
        };
        if !stops[start + 1..end].iter().all(is_passed) {
            start = end - 1;
            kept.push(stops[start]);
        }
    }
    kept.push(last);
    kept
}
