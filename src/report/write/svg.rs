//! Plots as SVG: axes with decades, curves told apart by colour, dash and marker, labels beside the curves.
//!
//! Colours are CSS custom properties ([`style()`]), so that one and the same plot is right on a light page, a dark one and on
//! paper, alone or inside the HTML page.

use std::fmt::Write as _;

use super::format::{escape, power_of_ten, short};
use super::labels::{Label, place};
use crate::physics::methods::{Dash, Mark};
use crate::physics::{self, METHODS, Method};

/// Width and height of a plot (user units, pixels at its natural size).
pub const SIZE: (f64, f64) = (860.0, 520.0);
/// The same of one of several that stand side by side.
pub const SMALL: (f64, f64) = (560.0, 400.0);
const LEFT: f64 = 78.0;
const RIGHT: f64 = 96.0;
const TOP: f64 = 40.0;
const BOTTOM: f64 = 58.0;
/// Distance between the points at which a curve counts as an obstacle for labels.
const OBSTACLE_EVERY: f64 = 5.0;
/// Most labels on an axis.
const MOST_TICKS: i32 = 9;

/// Colours of the page by theme, and on paper.
const ON_LIGHT: &str =
    "--paper:#fff;--ink:#1b1d21;--soft:#5b6169;--rule:#c9ced6;--faint:#e7eaee;--good:#00795a;--bad:#b33a00;--p:#5b6169";
const ON_DARK: &str = "--paper:#15171b;--ink:#e8eaed;--soft:#a3aab4;--rule:#454b55;--faint:#2a2e35;--good:#3fd2a4;--bad:#ff9a5c;--p:#a3aab4";
const ON_PAPER: &str =
    "--paper:#fff;--ink:#000;--soft:#444;--rule:#bbb;--faint:#e4e4e4;--good:#005c44;--bad:#8c2d00;--p:#444";
const CLASSES: &str = "\
.plot{font:13px system-ui,\"Segoe UI\",\"Helvetica Neue\",sans-serif;font-variant-numeric:tabular-nums}
.plot text{fill:var(--ink)}.plot .title{font-weight:600;font-size:14px}.plot .tick{fill:var(--soft);font-size:12px}
.plot .grid{stroke:var(--faint);stroke-width:1;fill:none}.plot .frame{stroke:var(--rule);stroke-width:1;fill:none}
.plot .guide{stroke:var(--soft);stroke-width:1;stroke-dasharray:2 4;opacity:.7;fill:none}.plot .guide-name{fill:var(--soft);font-size:11px;font-style:italic}
.plot .line{fill:none;stroke-width:1.8;stroke-linejoin:round;stroke-linecap:round}.plot .whisker{stroke-width:1;opacity:.55;fill:none}
.plot .mark{stroke-width:1.5}.plot .name{font-size:12px;font-weight:600;stroke:var(--paper);stroke-width:4px;paint-order:stroke;stroke-linejoin:round}
.plot .ring{fill:none;stroke-width:1.6}
";

/// The style sheet of every drawing: colours of the page, those of the methods from their table, and classes.
#[must_use]
pub fn style() -> String {
    let methods = |hue: fn(&Method) -> u32| -> String {
        let colours = METHODS.iter().map(|method| format!(";--{}:#{:06x}", method.name, hue(method)));
        colours.collect::<Vec<_>>().concat()
    };
    let (on_light, on_dark) = (methods(|method| method.hue.on_light), methods(|method| method.hue.on_dark));
    format!(
        ":root{{{ON_LIGHT}{on_light}}}\n@media (prefers-color-scheme:dark){{:root{{{ON_DARK}{on_dark}}}}}\n\
         @media print{{:root{{{ON_PAPER}{on_light}}}}}\n{CLASSES}"
    )
}

/// How a series looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Look {
    /// A method of the table, as its row says.
    Method(&'static Method),
    /// Another program, by its place in the list.
    Peer(usize),
    /// In this colour of the page, unbroken: what is neither.
    Page(&'static str),
}

impl Look {
    /// That of the method of a name.
    #[must_use]
    pub fn of_method(name: &str) -> Self {
        physics::method(name).map_or(Self::Page("ink"), Self::Method)
    }

    pub(super) fn colour(self) -> String {
        match self {
            Self::Method(method) => format!("var(--{})", method.name),
            Self::Peer(_) => "var(--p)".to_owned(),
            Self::Page(name) => format!("var(--{name})"),
        }
    }

    fn dash(self) -> &'static str {
        match self {
            Self::Method(method) => match method.dash {
                Dash::Solid => "",
                Dash::Short => "6 4",
                Dash::Long => "13 5",
                Dash::Dotted => "1.5 4",
            },
            Self::Peer(_) => "1 4",
            Self::Page(_) => "",
        }
    }

    /// A marker: its path about the origin, and whether it is filled.
    fn marker(self) -> (&'static str, bool) {
        const SQUARE: &str = "M-3.5,-3.5h7v7h-7z";
        const DIAMOND: &str = "M0,-4.8L4.8,0L0,4.8L-4.8,0z";
        const TRIANGLE: &str = "M0,-4.5L4.2,3.2H-4.2z";
        const TRIANGLE_DOWN: &str = "M0,4.5L4.2,-3.2H-4.2z";
        const CIRCLE: &str = "M-3.8,0a3.8,3.8 0 1,0 7.6,0a3.8,3.8 0 1,0 -7.6,0z";
        match self {
            Self::Method(method) => match method.mark {
                Mark::Ring => (CIRCLE, false),
                Mark::Diamond => (DIAMOND, true),
                Mark::Square => (SQUARE, true),
                Mark::Triangle => (TRIANGLE, true),
                Mark::TriangleDown => (TRIANGLE_DOWN, true),
                Mark::OpenSquare => (SQUARE, false),
                Mark::OpenDiamond => (DIAMOND, false),
                Mark::OpenTriangle => (TRIANGLE, false),
                Mark::OpenTriangleDown => (TRIANGLE_DOWN, false),
                Mark::Star => ("M0,-6L1.5,-1.5L6,0L1.5,1.5L0,6L-1.5,1.5L-6,0L-1.5,-1.5z", true),
                Mark::Hourglass => ("M-3.8,-4.4H3.8L0,0L3.8,4.4H-3.8L0,0z", true),
                Mark::Bow => ("M-4.4,-3.8V3.8L0,0L4.4,3.8V-3.8L0,0z", true),
                Mark::Bars => ("M-3.6,-4H-1.6V4H-3.6zM1.6,-4H3.6V4H1.6z", true),
            },
            Self::Peer(index) => match index % 3 {
                0 => ("M-4,-4L4,4M-4,4L4,-4", false),
                1 => ("M-5,0H5M0,-5V5", false),
                _ => ("M-4,-4L4,4M-4,4L4,-4M-5.5,0H5.5", false),
            },
            Self::Page(_) => (CIRCLE, true),
        }
    }
}

/// What the numbers on an axis are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Powers of ten.
    Decades,
    /// Powers of ten of a second, in the unit that suits each.
    Seconds,
    /// Evenly from 0 to 1, told in percent.
    Percent,
}

/// An axis.
#[derive(Clone, Debug)]
pub struct Axis {
    /// What it shows.
    pub label: String,
    /// Its numbers.
    pub scale: Scale,
    /// Its ends.
    pub range: (f64, f64),
}

/// A curve.
#[derive(Clone, Debug)]
pub struct Series {
    /// Its name, beside it; none where empty.
    pub label: String,
    /// How it looks.
    pub look: Look,
    /// Its points.
    pub points: Vec<(f64, f64)>,
    /// For each point the spread of x, or nothing.
    pub spread: Vec<(f64, f64)>,
    /// Whether each point has a marker.
    pub has_markers: bool,
    /// Points set off by a ring.
    pub rings: Vec<(f64, f64)>,
}

/// A power law drawn behind the curves: `y = y₀ (x/x₀)^power`.
#[derive(Clone, Debug)]
pub struct Guide {
    /// Its name.
    pub label: String,
    /// A point that it passes through.
    pub through: (f64, f64),
    /// The power.
    pub power: f64,
}

/// A plot.
#[derive(Clone, Debug)]
pub struct Plot {
    /// What it shows.
    pub title: String,
    /// Across.
    pub x: Axis,
    /// Up.
    pub y: Axis,
    /// Its curves.
    pub series: Vec<Series>,
    /// Laws behind them.
    pub guides: Vec<Guide>,
    /// Width and height: [`SIZE`] or [`SMALL`].
    pub size: (f64, f64),
}

impl Axis {
    /// A logarithmic axis over whole decades that hold all values above 0, and at least `least`.
    pub fn decades(label: &str, values: impl Iterator<Item = f64>, least: (f64, f64)) -> Self {
        let (low, high) = values
            .filter(|value| value.is_finite() && *value > 0.0)
            .fold(least, |(low, high), value| (low.min(value), high.max(value)));
        let low = 10f64.powf((low.log10() + 1e-9).floor());
        let high = 10f64.powf((high.log10() - 1e-9).ceil());
        Self { label: label.to_owned(), scale: Scale::Decades, range: (low, high) }
    }

    fn is_logarithmic(&self) -> bool {
        self.scale != Scale::Percent
    }

    /// Where a value lies, from 0 to 1; values past an end lie at the end.
    fn share(&self, value: f64) -> f64 {
        let (low, high) = self.range;
        let share = if self.is_logarithmic() {
            (value.max(f64::MIN_POSITIVE) / low).log10() / (high / low).log10()
        } else {
            (value - low) / (high - low)
        };
        share.clamp(0.0, 1.0)
    }

    /// Values with a line, and what is written there.
    fn ticks(&self) -> Vec<(f64, Option<String>)> {
        if !self.is_logarithmic() {
            return (0..=4).map(|i| (f64::from(i) / 4.0, Some(format!("{} %", 25 * i)))).collect();
        }
        let low = (self.range.0.log10() - 1e-9).ceil() as i32;
        let high = (self.range.1.log10() + 1e-9).floor() as i32;
        let stride = (high - low).div_euclid(MOST_TICKS) + 1;
        let mut ticks = Vec::new();
        for exponent in low..=high {
            let text = ((exponent - low) % stride == 0).then(|| match self.scale {
                Scale::Seconds => second(exponent),
                _ => power_of_ten(exponent),
            });
            ticks.push((10f64.powi(exponent), text));
            if high - low <= 4 && exponent < high {
                ticks.extend((2..10).map(|digit| (f64::from(digit) * 10f64.powi(exponent), None)));
            }
        }
        ticks
    }
}

/// `10^exponent` s in its unit.
fn second(exponent: i32) -> String {
    let (unit, power) = match exponent {
        ..=-7 => ("ns", -9),
        -6..=-4 => ("µs", -6),
        -3..=-1 => ("ms", -3),
        _ => ("s", 0),
    };
    let rest = exponent - power;
    if (0..=3).contains(&rest) {
        format!("{} {unit}", 10_i32.pow(rest.unsigned_abs()))
    } else {
        format!("{} s", power_of_ten(exponent))
    }
}

impl Series {
    /// A curve with markers.
    #[must_use]
    pub fn new(label: &str, look: Look, points: Vec<(f64, f64)>) -> Self {
        Self { label: label.to_owned(), look, points, spread: Vec::new(), has_markers: true, rings: Vec::new() }
    }
}

impl Plot {
    /// The plot as a file of its own.
    #[must_use]
    pub fn standalone(&self) -> String {
        let (body, (width, height)) = (self.body(), self.size);
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\">\n\
             <style>{}</style>\n<rect width=\"100%\" height=\"100%\" style=\"fill:var(--paper)\"/>\n{body}</svg>\n",
            style()
        )
    }

    /// The plot inside a page that has [`style()`].
    #[must_use]
    pub fn inline(&self) -> String {
        let (title, (width, height)) = (escape(&self.title), self.size);
        format!(
            "<svg class=\"plot\" viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{title}\">\n{}</svg>\n",
            self.body()
        )
    }

    fn at(&self, (x, y): (f64, f64)) -> (f64, f64) {
        let width = self.size.0 - LEFT - RIGHT;
        let height = self.size.1 - TOP - BOTTOM;
        (LEFT + width * self.x.share(x), TOP + height * (1.0 - self.y.share(y)))
    }

    fn body(&self) -> String {
        let mut svg = String::new();
        // Writing to a string cannot fail, here and below.
        let _ = writeln!(
            svg,
            "<title>{0}</title><text class=\"title\" x=\"{LEFT}\" y=\"22\">{0}</text>",
            escape(&self.title)
        );
        self.axes(&mut svg);
        let guides = self.guides(&mut svg);
        let mut obstacles = Vec::new();
        for series in &self.series {
            self.curve(&mut svg, series, &mut obstacles);
        }
        let frame = (LEFT, TOP, self.size.0 - 2.0, self.size.1 - BOTTOM);
        let mut labels: Vec<Label> = Vec::new();
        for series in self.series.iter().filter(|series| !series.label.is_empty() && !series.points.is_empty()) {
            let points: Vec<(f64, f64)> = series.points.iter().map(|point| self.at(*point)).collect();
            let middle = points[points.len() / 2];
            let ends =
                [points[points.len() - 1], points[0], middle, points[points.len() / 4], points[3 * points.len() / 4]];
            let label = place(&series.label, &ends, &labels, &obstacles, frame);
            let _ = writeln!(
                svg,
                "<text class=\"name\" x=\"{:.1}\" y=\"{:.1}\" style=\"fill:{}\">{}</text>",
                label.x,
                label.y,
                series.look.colour(),
                escape(&series.label)
            );
            labels.push(label);
        }
        for (guide, places) in self.guides.iter().zip(&guides) {
            let label = place(&guide.label, places, &labels, &obstacles, frame);
            let _ = writeln!(
                svg,
                "<text class=\"guide-name\" x=\"{:.1}\" y=\"{:.1}\">{}</text>",
                label.x,
                label.y,
                escape(&guide.label)
            );
            labels.push(label);
        }
        svg
    }

    fn axes(&self, svg: &mut String) {
        let (right, bottom) = (self.size.0 - RIGHT, self.size.1 - BOTTOM);
        let (x0, y0) = (self.x.range.0, self.y.range.0);
        for (value, text) in self.x.ticks() {
            let (x, _) = self.at((value, y0));
            let top = if text.is_some() { TOP } else { bottom - 4.0 };
            let class = if text.is_some() { "grid" } else { "frame" };
            let _ = writeln!(svg, "<path class=\"{class}\" d=\"M{x:.1},{top:.1}V{bottom:.1}\"/>");
            if let Some(text) = text {
                let y = bottom + 18.0;
                let _ = writeln!(
                    svg,
                    "<text class=\"tick\" text-anchor=\"middle\" x=\"{x:.1}\" y=\"{y:.1}\">{text}</text>"
                );
            }
        }
        for (value, text) in self.y.ticks() {
            let (_, y) = self.at((x0, value));
            let end = if text.is_some() { right } else { LEFT + 4.0 };
            let class = if text.is_some() { "grid" } else { "frame" };
            let _ = writeln!(svg, "<path class=\"{class}\" d=\"M{LEFT:.1},{y:.1}H{end:.1}\"/>");
            if let Some(text) = text {
                let (x, y) = (LEFT - 8.0, y + 4.0);
                let _ =
                    writeln!(svg, "<text class=\"tick\" text-anchor=\"end\" x=\"{x:.1}\" y=\"{y:.1}\">{text}</text>");
            }
        }
        let _ = writeln!(svg, "<path class=\"frame\" d=\"M{LEFT},{TOP}V{bottom}H{right}\"/>");
        let middle = f64::midpoint(TOP, bottom);
        let _ = writeln!(
            svg,
            "<text text-anchor=\"middle\" x=\"{:.1}\" y=\"{:.1}\">{}</text>\n\
             <text text-anchor=\"middle\" transform=\"translate(18,{middle:.1}) rotate(-90)\">{}</text>",
            f64::midpoint(LEFT, right),
            self.size.1 - 14.0,
            escape(&self.x.label),
            escape(&self.y.label)
        );
    }

    /// Draws the laws and returns the places along each where its name may stand, from its end upwards.
    fn guides(&self, svg: &mut String) -> Vec<Vec<(f64, f64)>> {
        let mut places = Vec::new();
        for guide in &self.guides {
            let value = |x: f64| guide.through.1 * (x / guide.through.0).powf(guide.power);
            let inverse = |y: f64| guide.through.0 * (y / guide.through.1).powf(1.0 / guide.power);
            // From the point to where the law leaves the plot on its way down.
            let (x, y) = (if guide.power < 0.0 { self.x.range.1 } else { self.x.range.0 }, self.y.range.0);
            let end = if value(x) > y { (x, value(x)) } else { (inverse(y), y) };
            let ((x1, y1), (x2, y2)) = (self.at(guide.through), self.at(end));
            let _ = writeln!(svg, "<path class=\"guide\" d=\"M{x1:.1},{y1:.1}L{x2:.1},{y2:.1}\"/>");
            places.push([0.06, 0.12, 0.2, 0.3].map(|share| (x2 + share * (x1 - x2), y2 + share * (y1 - y2))).to_vec());
        }
        places
    }

    fn curve(&self, svg: &mut String, series: &Series, obstacles: &mut Vec<(f64, f64)>) {
        let colour = series.look.colour();
        let points: Vec<(f64, f64)> = series.points.iter().map(|point| self.at(*point)).collect();
        let _ = writeln!(svg, "<g style=\"stroke:{colour}\"><title>{}</title>", escape(&series.label));
        for (&(_, y), &(low, high)) in points.iter().zip(&series.spread) {
            let ((x1, _), (x2, _)) = (self.at((low, 1.0)), self.at((high, 1.0)));
            if x2 - x1 > 2.0 {
                let _ = writeln!(svg, "<path class=\"whisker\" d=\"M{x1:.1},{y:.1}H{x2:.1}\"/>");
            }
        }
        if points.len() > 1 {
            let mut path = String::new();
            for (i, (x, y)) in points.iter().enumerate() {
                let _ = write!(path, "{}{x:.1},{y:.1}", if i == 0 { 'M' } else { 'L' });
            }
            let dash = series.look.dash();
            let _ = writeln!(svg, "<path class=\"line\" stroke-dasharray=\"{dash}\" d=\"{path}\"/>");
            for pair in points.windows(2) {
                let ((x1, y1), (x2, y2)) = (pair[0], pair[1]);
                let count = ((x2 - x1).hypot(y2 - y1) / OBSTACLE_EVERY).ceil().max(1.0);
                obstacles.extend((0..count as u32).map(|i| {
                    let share = f64::from(i) / count;
                    (x1 + share * (x2 - x1), y1 + share * (y2 - y1))
                }));
            }
        }
        obstacles.extend(&points);
        if series.has_markers || points.len() == 1 {
            let (path, is_filled) = series.look.marker();
            let fill = if is_filled { colour.as_str() } else { "var(--paper)" };
            for ((x, y), (vx, vy)) in points.iter().zip(&series.points) {
                let _ = writeln!(
                    svg,
                    "<path class=\"mark\" style=\"fill:{fill}\" transform=\"translate({x:.1},{y:.1})\" d=\"{path}\"><title>{}: {}, {}</title></path>",
                    escape(&series.label),
                    short(*vx),
                    short(*vy)
                );
            }
        }
        for ring in &series.rings {
            let (x, y) = self.at(*ring);
            let _ = writeln!(svg, "<circle class=\"ring\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"8\"/>");
        }
        svg.push_str("</g>\n");
    }
}
