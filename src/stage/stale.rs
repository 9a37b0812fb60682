//! What of a window is no longer as it is shown: where there is no GPU every pixel of the panels costs time, and while a motion plays
//! few of them change.

use egui::epaint::ClippedShape;
use egui::{Color32, Pos2, Rect, Vec2};

/// How far (pixels) what is painted of a shape may reach beyond its outline: soft edges, and the rounding to whole pixels.
const MARGIN: f32 = 2.0;

/// More rectangles than this are painted as one.
const MOST: usize = 16;

/// All that the pixels of a window come from.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Shown {
    /// What the panels drew.
    pub(super) shapes: Vec<ClippedShape>,
    /// Pixels a point.
    pub(super) pixels_per_point: f32,
    /// Behind everything.
    pub(super) background: Color32,
    /// Where the picture lies (pixels).
    pub(super) picture: Rect,
}

impl Shown {
    /// The rectangles (whole pixels, none over another) in which a window of this size (pixels) that shows `before` does not show
    /// this, the picture's own pixels apart.
    pub(super) fn stale_since(&self, before: &Self, window: Vec2) -> Vec<Rect> {
        let whole = Rect::from_min_size(Pos2::ZERO, window);
        let frame = |shown: &Self| (shown.pixels_per_point, shown.background, shown.picture);
        if frame(self) != frame(before) {
            return vec![whole];
        }
        let (mut old, mut new) = (&before.shapes[..], &self.shapes[..]);
        while let ([one, rest @ ..], [other, others @ ..]) = (old, new)
            && one == other
        {
            (old, new) = (rest, others);
        }
        while let ([rest @ .., one], [others @ .., other]) = (old, new)
            && one == other
        {
            (old, new) = (rest, others);
        }
        // As many as before: most of those between are the same still.
        let is_one_by_one = old.len() == new.len();
        let changed = (0..old.len().max(new.len())).filter(|&at| !is_one_by_one || old[at] != new[at]);
        let mut stale = vec![];
        for at in changed {
            for shape in [old.get(at), new.get(at)].into_iter().flatten() {
                add(&mut stale, self.pixels(shape).intersect(whole));
            }
        }
        if stale.len() > MOST {
            stale = vec![stale.into_iter().fold(Rect::NOTHING, |all, one| all | one)];
        }
        stale
    }

    /// The pixels that a shape may colour.
    fn pixels(&self, shape: &ClippedShape) -> Rect {
        let outline = shape.transform_after_tessellation * shape.shape.visual_bounding_rect();
        let reach = outline.intersect(shape.clip_rect);
        if reach.is_negative() { Rect::NOTHING } else { (reach * self.pixels_per_point).expand(MARGIN).round_out() }
    }

    /// The shapes that colour any pixel of a rectangle, held to it.
    pub(super) fn within(&self, pixels: Rect) -> Vec<ClippedShape> {
        let shapes = self.shapes.iter().filter(|shape| self.pixels(shape).intersects(pixels));
        let bounds = pixels / self.pixels_per_point;
        shapes.map(|shape| ClippedShape { clip_rect: shape.clip_rect.intersect(bounds), ..shape.clone() }).collect()
    }
}

/// Adds a rectangle, as one with those that it lies over.
pub(super) fn add(stale: &mut Vec<Rect>, mut one: Rect) {
    while one.is_positive()
        && let Some(at) = stale.iter().position(|other| other.intersects(one))
    {
        one |= stale.swap_remove(at);
    }
    if one.is_positive() {
        stale.push(one);
    }
}

/// What of a rectangle lies outside another one.
pub(super) fn outside(one: Rect, hole: Rect) -> Vec<Rect> {
    let hole = hole.intersect(one);
    if !hole.is_positive() {
        return vec![one];
    }
    let rows = Rect::from_x_y_ranges(one.x_range(), hole.y_range());
    let pieces = [
        Rect { max: Pos2::new(one.max.x, hole.min.y), ..one },
        Rect { min: Pos2::new(one.min.x, hole.max.y), ..one },
        Rect { max: Pos2::new(hole.min.x, rows.max.y), ..rows },
        Rect { min: Pos2::new(hole.max.x, rows.min.y), ..rows },
    ];
    pieces.into_iter().filter(Rect::is_positive).collect()
}

/// A rectangle of whole pixels round another.
trait RoundOut {
    fn round_out(self) -> Self;
}

impl RoundOut for Rect {
    fn round_out(self) -> Self {
        Self::from_min_max(self.min.floor(), self.max.ceil())
    }
}

#[cfg(test)]
mod tests {
    use super::{Shown, add, outside};
    use egui::epaint::{ClippedShape, emath::TSTransform};
    use egui::{Color32, Rect, Shape, Stroke, pos2, vec2};

    /// A window of 100 by 80 points, two pixels a point, with a bar of each of these widths (points) under another.
    fn window(widths: &[f32]) -> Shown {
        let bar = |(row, width): (usize, &f32)| ClippedShape {
            clip_rect: Rect::from_min_max(pos2(0.0, 0.0), pos2(100.0, 80.0)),
            shape: Shape::line_segment(
                [pos2(10.0, 10.0 + 10.0 * row as f32), pos2(10.0 + width, 10.0 + 10.0 * row as f32)],
                Stroke::new(2.0, Color32::WHITE),
            ),
            transform_after_tessellation: TSTransform::IDENTITY,
        };
        Shown {
            shapes: widths.iter().enumerate().map(bar).collect(),
            pixels_per_point: 2.0,
            background: Color32::BLACK,
            picture: Rect::from_min_max(pos2(100.0, 0.0), pos2(200.0, 100.0)),
        }
    }

    #[test]
    fn what_changed_is_stale_and_nothing_else() {
        let size = vec2(200.0, 160.0);
        let before = window(&[20.0, 30.0, 40.0, 50.0]);
        assert!(before.stale_since(&before, size).is_empty());
        // The second and the last bar: 10 to 45 points at 20 ± 1, 10 to 60 at 40 ± 1, two pixels round each.
        let now = window(&[20.0, 35.0, 40.0, 1.0]);
        let wanted = [
            Rect::from_min_max(pos2(18.0, 36.0), pos2(92.0, 44.0)),
            Rect::from_min_max(pos2(18.0, 76.0), pos2(122.0, 84.0)),
        ];
        for wanted in wanted {
            let found = now.stale_since(&before, size);
            assert!(found.iter().any(|stale| stale.contains_rect(wanted) && stale.height() <= 14.0), "{found:?}");
            assert_eq!(found.len(), 2, "{found:?}");
        }
        // One bar more or less: only that one, at the end.
        let fewer = window(&[20.0, 30.0, 40.0]);
        assert_eq!(fewer.stale_since(&before, size), before.stale_since(&fewer, size));
        assert_eq!(fewer.stale_since(&before, size).len(), 1);
        // Another background or another place of the picture: everything.
        let other = Shown { background: Color32::GRAY, ..before.clone() };
        assert_eq!(other.stale_since(&before, size), [Rect::from_min_size(pos2(0.0, 0.0), size)]);
    }

    #[test]
    fn a_rectangle_takes_the_shapes_over_it_and_holds_them_to_it() {
        let shown = window(&[20.0, 30.0, 40.0, 50.0]);
        let pixels = Rect::from_min_max(pos2(0.0, 54.0), pos2(30.0, 66.0));
        let within = shown.within(pixels);
        assert_eq!(within.len(), 1);
        assert_eq!(within[0].clip_rect, Rect::from_min_max(pos2(0.0, 27.0), pos2(15.0, 33.0)));
        assert_eq!(within[0].shape, shown.shapes[2].shape);
    }

    #[test]
    fn rectangles_never_lie_over_one_another() {
        let rect = |x: f32| Rect::from_min_size(pos2(x, 0.0), vec2(10.0, 10.0));
        let mut stale = vec![];
        for x in [0.0, 40.0, 18.0, 9.0] {
            add(&mut stale, rect(x));
        }
        stale.sort_by(|one, other| one.min.x.total_cmp(&other.min.x));
        assert_eq!(stale, [Rect::from_min_max(pos2(0.0, 0.0), pos2(28.0, 10.0)), rect(40.0)]);
        // A hole in the middle leaves four pieces of the right area.
        let whole = Rect::from_min_size(pos2(0.0, 0.0), vec2(10.0, 10.0));
        let pieces = outside(whole, Rect::from_min_max(pos2(2.0, 3.0), pos2(7.0, 5.0)));
        assert_eq!(pieces.len(), 4);
        assert!((pieces.iter().map(Rect::area).sum::<f32>() - 90.0).abs() < 1e-3);
        assert!(outside(whole, whole.expand(1.0)).is_empty());
    }
}
