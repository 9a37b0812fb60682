//! The cost of a step as bars.

use std::fmt::Write as _;

use super::format::{escape, time};
use super::svg::{Look, SIZE, style};
use crate::report::{Report, is_direct};

const WIDTH: f64 = SIZE.0;
const LEFT: f64 = 150.0;
const RIGHT: f64 = 130.0;
const TOP: f64 = 62.0;
const ROW: f64 = 30.0;
const BAR: f64 = 16.0;

/// Bars with a spread, and a line that marks the floor.
#[derive(Clone, Debug)]
pub struct Bars {
    title: String,
    floor: f64,
    rows: Vec<Bar>,
}

#[derive(Clone, Debug)]
struct Bar {
    label: String,
    look: Look,
    seconds: f64,
    spread: (f64, f64),
    remark: String,
}

/// What a step of every method costs.
#[must_use]
pub fn cost(report: &Report) -> Bars {
    let rows = report.cost.methods.iter().map(|row| {
        let evaluation = if is_direct(row.method) { ", any time" } else { "" };
        Bar {
            label: row.method.to_owned(),
            look: Look::of_method(row.method),
            seconds: row.timing.seconds,
            spread: (row.timing.seconds_lower, row.timing.seconds_upper),
            remark: format!("{}{evaluation}", time(row.timing.seconds)),
        }
    });
    Bars { title: "Cost of a step".to_owned(), floor: report.cost.floor.seconds, rows: rows.collect() }
}

impl Bars {
    fn height(&self) -> f64 {
        TOP + ROW * self.rows.len() as f64 + 16.0
    }

    /// The bars as a file of their own.
    #[must_use]
    pub fn standalone(&self) -> String {
        let (height, body) = (self.height(), self.body());
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot\" viewBox=\"0 0 {WIDTH} {height}\" width=\"{WIDTH}\" height=\"{height}\">\n\
             <style>{}</style>\n<rect width=\"100%\" height=\"100%\" style=\"fill:var(--paper)\"/>\n{body}</svg>\n",
            style()
        )
    }

    /// The bars inside a page that has [`style()`].
    #[must_use]
    pub fn inline(&self) -> String {
        format!(
            "<svg class=\"plot\" viewBox=\"0 0 {WIDTH} {}\" role=\"img\" aria-label=\"{}\">\n{}</svg>\n",
            self.height(),
            escape(&self.title),
            self.body()
        )
    }

    fn body(&self) -> String {
        let largest = self.rows.iter().map(|row| row.seconds).fold(self.floor, f64::max);
        let width = WIDTH - LEFT - RIGHT;
        // An outlier of the spread is cut at the end of the plot: it tells of the machine, not of the method.
        let x = |seconds: f64| LEFT + width * (seconds / (1.08 * largest)).min(1.0);
        let bottom = self.height() - 12.0;
        let mut svg = String::new();
        // Writing to a string cannot fail.
        let _ = writeln!(svg, "<text class=\"title\" x=\"12\" y=\"22\">{}</text>", escape(&self.title));
        for (i, row) in self.rows.iter().enumerate() {
            let y = TOP + ROW * i as f64;
            let middle = y + 0.5 * BAR;
            let (low, high) = (x(row.spread.0), x(row.spread.1));
            let _ = writeln!(
                svg,
                "<text text-anchor=\"end\" x=\"{:.1}\" y=\"{:.1}\">{}</text>\n\
                 <path style=\"fill:{};opacity:.8\" d=\"M{LEFT},{y:.1}H{:.1}v{BAR}H{LEFT}z\"/>\n\
                 <path class=\"frame\" style=\"stroke:var(--ink)\" d=\"M{low:.1},{middle:.1}H{high:.1}M{low:.1},{:.1}v8M{high:.1},{:.1}v8\"/>\n\
                 <text class=\"name\" x=\"{:.1}\" y=\"{:.1}\">{}</text>",
                LEFT - 10.0,
                middle + 4.0,
                escape(&row.label),
                row.look.colour(),
                x(row.seconds),
                middle - 4.0,
                middle - 4.0,
                high.max(x(row.seconds)) + 8.0,
                middle + 4.0,
                escape(&row.remark)
            );
        }
        let floor = x(self.floor);
        let _ = writeln!(
            svg,
            "<path class=\"guide\" style=\"stroke:var(--ink);stroke-dasharray:4 3\" d=\"M{floor:.1},{:.1}V{bottom:.1}\"/>\n\
             <text class=\"guide-name\" x=\"{:.1}\" y=\"{:.1}\">floor: one sine and cosine, {}</text>\n\
             <path class=\"frame\" d=\"M{LEFT},{:.1}V{bottom:.1}\"/>",
            TOP - 10.0,
            floor + 5.0,
            TOP - 12.0,
            time(self.floor),
            TOP - 10.0
        );
        svg
    }
}
