//! A figure as a list of shapes, each over those before it: what is written as SVG or PDF.

use glam::DVec2;

use crate::frame::Color;
use crate::render::Letter;

/// A figure. Places are pixels from its upper left corner, y down.
#[derive(Debug)]
pub(super) struct Drawing {
    /// Width and height in pixels.
    pub(super) size: [u32; 2],
    /// What is behind all, where anything is.
    pub(super) background: Option<Color>,
    /// What is drawn, the lowest first.
    pub(super) shapes: Vec<Shape>,
}

/// One shape.
#[derive(Debug)]
pub(super) enum Shape {
    /// Pixels.
    Picture(Picture),
    /// The way of a pen.
    Stroke { path: Path, pen: Pen, paint: Paint },
    /// An area; where even and odd, one that is gone round twice is a hole.
    Fill { path: Path, even_odd: bool, paint: Paint },
    /// A text, or the halo of one.
    Words(Words),
    /// Shapes that are cut off at the border of an area (even and odd).
    Group { clip: Path, shapes: Vec<Shape> },
}

/// Pixels in their place.
#[derive(Debug)]
pub(super) struct Picture {
    /// The upper left corner.
    pub(super) corner: [u32; 2],
    /// Width and height.
    pub(super) size: [u32; 2],
    /// Straight (not premultiplied) sRGB bytes: three a pixel, or four with the opacity.
    pub(super) bytes: Vec<u8>,
    /// Whether there are four.
    pub(super) has_opacity: bool,
}

impl Picture {
    /// Bytes a pixel.
    pub(super) fn channels(&self) -> usize {
        if self.has_opacity { 4 } else { 3 }
    }
}

/// How a pen draws.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pen {
    /// Width in pixels.
    pub(super) width: f64,
    /// Whether its ends are round, or cut off where the way ends.
    pub(super) is_round: bool,
}

/// What a shape is filled with.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Paint {
    /// One colour.
    Flat(Color),
    /// Colours along a straight way, each at its part of it.
    Along { from: DVec2, to: DVec2, stops: Vec<(f64, Color)> },
    /// Colours from a middle outwards, in the space in which that is the unit circle's: `[x axis, y axis, middle]`.
    Around { axes: [DVec2; 3], stops: Vec<(f64, Color)> },
}

/// A text.
#[derive(Debug)]
pub(super) struct Words {
    /// Its letters, the pen of each in pixels of the figure.
    pub(super) letters: Vec<Letter>,
    /// Ink, or a halo of this width on either side (pixels).
    pub(super) halo: Option<f64>,
    /// Its colour.
    pub(super) color: Color,
}

/// A step of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Step {
    /// Begins here.
    Move(DVec2),
    /// Straight to here.
    Line(DVec2),
    /// By a quadratic curve with this control point.
    Quadratic(DVec2, DVec2),
    /// By a cubic curve with these control points.
    Cubic(DVec2, DVec2, DVec2),
    /// Back to where it began.
    Close,
}

/// Lines and curves.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Path(pub(super) Vec<Step>);

/// Control points of a quarter of a circle: 4/3 tan(π/8) radii from its ends, within 0.03 % of it.
const QUARTER: f64 = 0.552_284_749_830_793_4;

impl Path {
    /// Through these points.
    pub(super) fn through(points: impl IntoIterator<Item = DVec2>, is_closed: bool) -> Self {
        let mut steps = vec![];
        for point in points {
            steps.push(if steps.is_empty() { Step::Move(point) } else { Step::Line(point) });
        }
        if is_closed {
            steps.push(Step::Close);
        }
        Self(steps)
    }

    /// The ellipse about a middle with these half axes, in four curves.
    pub(super) fn ellipse([x, y, middle]: [DVec2; 3]) -> Self {
        let mut steps = vec![Step::Move(middle + x)];
        for [a, b] in [[x, y], [y, -x], [-x, -y], [-y, x]] {
            steps.push(Step::Cubic(middle + a + b * QUARTER, middle + b + a * QUARTER, middle + b));
        }
        steps.push(Step::Close);
        Self(steps)
    }

    /// The circle about a middle.
    pub(super) fn circle(middle: DVec2, radius: f64) -> Self {
        Self::ellipse([DVec2::X * radius, DVec2::Y * radius, middle])
    }

    /// An upright rectangle.
    pub(super) fn rectangle(low: DVec2, high: DVec2) -> Self {
        Self::through([low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)], true)
    }

    /// Adds another.
    pub(super) fn append(&mut self, other: Self) {
        self.0.extend(other.0);
    }

    /// The points that it goes through or is drawn to.
    pub(super) fn points(&self) -> impl Iterator<Item = DVec2> {
        self.0
            .iter()
            .flat_map(|step| match *step {
                Step::Move(a) | Step::Line(a) => [Some(a), None, None],
                Step::Quadratic(a, b) => [Some(a), Some(b), None],
                Step::Cubic(a, b, c) => [Some(a), Some(b), Some(c)],
                Step::Close => [None; 3],
            })
            .flatten()
    }
}
