//! What triangles take of a pane, strip of rows by strip: where there is no GPU every pixel that is laid into a picture is paid for.

use glam::Vec2;

use super::part::Part;

/// Rows of a strip (pixels).
const ROWS: f32 = 16.0;
/// Farther than this from every triangle no sample of a pixel meets one.
const MARGIN: f32 = 1.0;

/// What is taken of a pane, in pixels from its upper left corner.
pub(super) struct Outline {
    size: Vec2,
    /// The least and the greatest place across of what is in each strip, from the top.
    strips: Vec<[f32; 2]>,
    /// Low and high corner.
    bounds: [Vec2; 2],
}

impl Outline {
    /// Nothing yet, of a pane of this size.
    pub(super) fn new(size: Vec2) -> Self {
        let strips = vec![[f32::INFINITY, f32::NEG_INFINITY]; (size.y / ROWS).ceil().max(1.0) as usize];
        Self { size, strips, bounds: [Vec2::INFINITY, Vec2::NEG_INFINITY] }
    }

    /// Takes a triangle in; without corners, where one of them is behind the eye, the whole pane.
    pub(super) fn add(&mut self, corners: [Option<Vec2>; 3]) {
        let [Some(a), Some(b), Some(c)] = corners else {
            self.strips.fill([0.0, self.size.x]);
            self.bounds = [Vec2::ZERO, self.size];
            return;
        };
        let (low, high) = (a.min(b).min(c) - MARGIN, a.max(b).max(c) + MARGIN);
        self.bounds = [self.bounds[0].min(low).max(Vec2::ZERO), self.bounds[1].max(high).min(self.size)];
        let last = self.strips.len() - 1;
        let number = |y: f32| ((y / ROWS).max(0.0) as usize).min(last);
        for strip in number(low.y)..=number(high.y) {
            let rows = [ROWS * strip as f32 - MARGIN, ROWS * (strip + 1) as f32 + MARGIN];
            let [least, greatest] = &mut self.strips[strip];
            for (p, q) in [(a, b), (b, c), (c, a)] {
                let Some(ends) = within(p, q, rows) else { continue };
                *least = least.min(ends[0].min(ends[1]) - MARGIN);
                *greatest = greatest.max(ends[0].max(ends[1]) + MARGIN);
            }
        }
    }

    /// Low and high corner of all of it; none where there is nothing.
    pub(super) fn bounds(&self) -> Option<[Vec2; 2]> {
        let [low, high] = self.bounds;
        low.cmplt(high).all().then_some(self.bounds)
    }

    /// Low and high corners of rectangles that hold what a part of a picture shows of it, where the pane has this corner in the picture.
    pub(super) fn rectangles(&self, part: Part, pane: Vec2) -> impl Iterator<Item = [Vec2; 2]> {
        let (low, high) = (part.corner(), part.corner() + part.extent());
        let strips = self.strips.iter().enumerate().map(move |(number, [least, greatest])| {
            let top = ROWS * number as f32;
            let (one, other) = (Vec2::new(*least, top), Vec2::new(*greatest, top + ROWS));
            [(one + pane).max(low), (other + pane).min(high)]
        });
        strips.filter(|[low, high]| low.cmplt(*high).all())
    }
}

/// The places across between which a straight line is within these rows.
fn within(p: Vec2, q: Vec2, [top, bottom]: [f32; 2]) -> Option<[f32; 2]> {
    let (upper, lower) = if p.y <= q.y { (p, q) } else { (q, p) };
    if lower.y < top || upper.y > bottom {
        return None;
    }
    let at = |y: f32| {
        let part = (y - upper.y) / (lower.y - upper.y).max(f32::MIN_POSITIVE);
        upper.x + (lower.x - upper.x) * part.clamp(0.0, 1.0)
    };
    Some(if lower.y > upper.y { [at(top), at(bottom)] } else { [upper.x, lower.x] })
}

#[cfg(test)]
mod tests {
    use super::{MARGIN, Outline};
    use crate::render::part::Part;
    use glam::Vec2;

    #[test]
    fn all_of_a_triangle_is_held_and_little_else() {
        let corners = [Vec2::new(10.0, 20.0), Vec2::new(90.0, 60.0), Vec2::new(20.0, 95.0)];
        let mut outline = Outline::new(Vec2::new(100.0, 100.0));
        assert_eq!(outline.bounds(), None);
        outline.add(corners.map(Some));
        assert_eq!(outline.bounds(), Some([Vec2::new(10.0, 20.0) - MARGIN, Vec2::new(90.0, 95.0) + MARGIN]));
        // Seen through a part that cuts its left away.
        let pane = Vec2::new(300.5, 7.25);
        let part = Part { low: [315, 0], size: [200, 200] };
        let rectangles: Vec<_> = outline.rectangles(part, pane).collect();
        let [a, b, c] = corners;
        let mut area = 0.0;
        for [low, high] in &rectangles {
            area += (high.x - low.x) * (high.y - low.y);
            assert!(low.x >= 315.0);
        }
        for n in 0..=20 {
            for m in 0..=20 - n {
                let place = pane + a + (b - a) * (n as f32 / 20.0) + (c - a) * (m as f32 / 20.0);
                let holding =
                    rectangles.iter().filter(|[low, high]| place.cmpge(*low).all() && place.cmplt(*high).all());
                assert_eq!(holding.count(), usize::from(place.x >= 315.0), "{place}");
            }
        }
        // A triangle's strips hold about half as much again as it does: its area is 2825.
        assert!(area < 1.6 * 0.5 * (b - a).perp_dot(c - a).abs(), "{area}");
    }

    #[test]
    fn what_reaches_behind_the_eye_may_be_anywhere() {
        let mut outline = Outline::new(Vec2::new(50.0, 40.0));
        outline.add([Some(Vec2::ONE), None, Some(Vec2::ZERO)]);
        assert_eq!(outline.bounds(), Some([Vec2::ZERO, Vec2::new(50.0, 40.0)]));
        let whole = Part { low: [0, 0], size: [50, 40] };
        let area: f32 = outline.rectangles(whole, Vec2::ZERO).map(|[low, high]| (high - low).element_product()).sum();
        assert_eq!(area, 50.0 * 40.0);
    }
}
