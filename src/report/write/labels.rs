//! Where the names of curves go: beside a point of the curve, clear of other names and of the curves.

/// Width of a character on average, and height of a line (px at 12 px).
const CHARACTER: f64 = 7.4;
const LINE: f64 = 14.0;
/// Distance from the point.
const GAP: f64 = 9.0;
/// What a place costs: another name under it (a pixel of overlap), a curve under it (a point), the frame crossed.
const NAME: f64 = 20.0;
const CURVE: f64 = 6.0;
const FRAME: f64 = 1e6;

/// A placed name: the left end of its base line, and the box around it.
#[derive(Clone, Copy, Debug)]
pub struct Label {
    /// Left end.
    pub x: f64,
    /// Base line.
    pub y: f64,
    width: f64,
}

impl Label {
    /// A name at a place.
    #[must_use]
    pub fn new(text: &str, x: f64, y: f64) -> Self {
        Self { x, y, width: text.chars().count() as f64 * CHARACTER }
    }

    fn overlap(&self, other: &Self) -> f64 {
        let along = (self.x + self.width).min(other.x + other.width) - self.x.max(other.x);
        let across = LINE - (self.y - other.y).abs();
        if along > -3.0 && across > 0.0 { (along + 4.0) * across } else { 0.0 }
    }

    fn covers(&self, (x, y): (f64, f64)) -> bool {
        x > self.x - 2.0 && x < self.x + self.width + 2.0 && y > self.y - LINE + 1.0 && y < self.y + 4.0
    }
}

/// The best place for a name beside one of the `anchors` (the first are preferred), inside the frame
/// (left, top, right, bottom).
#[must_use]
pub fn place(
    text: &str,
    anchors: &[(f64, f64)],
    labels: &[Label],
    obstacles: &[(f64, f64)],
    frame: (f64, f64, f64, f64),
) -> Label {
    let width = Label::new(text, 0.0, 0.0).width;
    let mut best = (f64::INFINITY, Label::new(text, frame.0, frame.1 + LINE));
    let mut preference = 0.0;
    for (x, y) in anchors {
        let (right, left, centre) = (x + GAP, x - GAP - width, x - 0.5 * width);
        let places = [
            (right, y + 4.0),
            (right, y - 6.0),
            (right, y + 15.0),
            (centre, y - GAP),
            (centre, y + GAP + 10.0),
            (left, y + 4.0),
            (left, y - 6.0),
            (left, y + 15.0),
            (right + 6.0, y - 18.0),
            (right + 6.0, y + 27.0),
            (left - 6.0, y - 18.0),
            (left - 6.0, y + 27.0),
        ];
        for (x, y) in places {
            let label = Label { x, y, width };
            let names: f64 = labels.iter().map(|other| label.overlap(other)).sum();
            let curves = obstacles.iter().filter(|point| label.covers(**point)).count() as f64;
            let is_outside = x < frame.0 || x + width > frame.2 || y - LINE + 2.0 < frame.1 || y + 2.0 > frame.3;
            let cost = preference + NAME * names + CURVE * curves + if is_outside { FRAME } else { 0.0 };
            if cost < best.0 {
                best = (cost, label);
            }
            preference += 0.3;
        }
        preference += 3.0;
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_curves_that_end_together_do_not_lie_on_one_another() {
        let frame = (0.0, 0.0, 400.0, 300.0);
        let mut labels: Vec<Label> = Vec::new();
        for text in ["forward-euler", "backward-euler", "lie-euler", "rk4"] {
            let label = place(text, &[(200.0, 150.0)], &labels, &[], frame);
            assert!(labels.iter().all(|other| label.overlap(other) == 0.0), "{text} {labels:?}");
            assert!(label.x >= 0.0 && label.x + label.width <= 400.0);
            labels.push(label);
        }
    }
}
