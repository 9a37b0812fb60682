//! Which plots a report has.

use super::bars;
use super::svg::{Axis, Guide, Look, Plot, SIZE, SMALL, Scale, Series};
use crate::physics::METHODS;
use crate::report::cases::Errors;
use crate::report::long_run::{INVARIANT_LOST, LOST};
use crate::report::separatrix::BesideSeparatrix;
use crate::report::{CaseRow, Report, is_direct};

/// Smallest error drawn: anything below lies on the axis.
const SMALLEST_ERROR: f64 = 1e-16;
/// The same for invariants, which may be kept to the last bit.
const SMALLEST_INVARIANT: f64 = 1e-17;
/// Orders of the guides.
const ORDERS: [f64; 3] = [1.0, 2.0, 4.0];
/// A long run of fewer samples shows each of them.
const FEW_SAMPLES: usize = 12;
/// Points that a distribution is drawn with.
const DISTRIBUTION_POINTS: usize = 120;

/// A plot of any kind: its file's name without the ending, and its drawing.
#[derive(Clone, Debug)]
pub enum Drawing {
    /// Curves on two axes.
    Curves(Plot),
    /// Bars.
    Bars(bars::Bars),
}

impl Drawing {
    /// The drawing as a file of its own.
    #[must_use]
    pub fn standalone(&self) -> String {
        match self {
            Self::Curves(plot) => plot.standalone(),
            Self::Bars(bars) => bars.standalone(),
        }
    }
}

/// Every plot of the report with its file's name, without the ending.
#[must_use]
pub fn all(report: &Report) -> Vec<(String, Drawing)> {
    let mut plots = Vec::new();
    let mut add = |name: String, plot: Plot| plots.push((name, Drawing::Curves(plot)));
    for case in &report.cases {
        add(format!("work-precision-{}", slug(&case.name)), work_precision(report, case));
        add(format!("step-error-{}", slug(&case.name)), step_error(report, case));
    }
    add("order".to_owned(), order(report));
    for (name, plot) in long_run(report) {
        add(format!("long-run-{name}"), plot);
    }
    add("large-steps".to_owned(), large_steps(report));
    add("many-bodies".to_owned(), many_bodies(report));
    add("separatrix".to_owned(), separatrix(report));
    add("augmented-term".to_owned(), augmented(report));
    plots.push(("cost".to_owned(), Drawing::Bars(bars::cost(report))));
    plots
}

/// A name that is good for a file.
#[must_use]
pub fn slug(name: &str) -> String {
    let words: String = name.chars().map(|c| if c.is_alphanumeric() { c.to_ascii_lowercase() } else { ' ' }).collect();
    words.split_whitespace().collect::<Vec<_>>().join("-")
}

fn method_series(name: &str, points: Vec<(f64, f64)>) -> Series {
    Series::new(name, Look::of_method(name), points)
}

fn errors_axis(label: &str, series: &[Series]) -> Axis {
    let values = series.iter().flat_map(|series| series.points.iter().map(|point| point.1.max(SMALLEST_ERROR)));
    Axis::decades(label, values, (1e-14, 1.0))
}

/// Power laws through a corner of the plot: the top left where errors fall, else the top right.
fn guides(x: &Axis, y: &Axis, sign: f64) -> Vec<Guide> {
    let corner = if sign < 0.0 { x.range.0 * 3.0 } else { x.range.1 };
    ORDERS
        .iter()
        .map(|order| Guide { label: format!("order {order}"), through: (corner, y.range.1), power: sign * order })
        .collect()
}

/// Time against error on one case.
#[must_use]
pub fn work_precision(report: &Report, case: &CaseRow) -> Plot {
    let mut series: Vec<Series> = METHODS
        .iter()
        .map(|method| {
            let rows = || report.rows.iter().filter(|row| row.case == case.name && row.method == method.name);
            let points = rows().map(|row| (row.timing.seconds, row.errors.attitude_error)).collect();
            let spread = rows().map(|row| (row.timing.seconds_lower, row.timing.seconds_upper)).collect();
            Series { spread, ..method_series(method.name, points) }
        })
        .collect();
    let mut names: Vec<&str> = Vec::new();
    for peer in &report.peers {
        if !names.contains(&peer.peer.as_str()) {
            names.push(&peer.peer);
        }
    }
    for (index, name) in names.iter().enumerate() {
        let same = report.peers.iter().filter(|peer| peer.peer == *name && peer.case == case.name && peer.t == case.t);
        // A setting with two words has curves of its own: MuJoCo's integrators are not one method.
        let mut groups: Vec<(&str, Vec<(f64, f64)>)> = Vec::new();
        for peer in same {
            let kind = peer.setting.split([' ', '=']).next().unwrap_or_default();
            match groups.iter_mut().find(|group| group.0 == kind) {
                Some(group) => group.1.push((peer.seconds, peer.error)),
                None => groups.push((kind, vec![(peer.seconds, peer.error)])),
            }
        }
        let several = groups.len() > 1;
        series.extend(groups.into_iter().map(|(kind, points)| {
            let label = if several { format!("{name} {kind}") } else { (*name).to_owned() };
            Series::new(&label, Look::Peer(index), points)
        }));
    }
    let times = series.iter().flat_map(|series| series.points.iter().map(|point| point.0));
    let x = Axis { scale: Scale::Seconds, ..Axis::decades("time to solution", times, (1e-7, 1e-3)) };
    let y = errors_axis("attitude error (rad)", &series);
    Plot {
        title: format!("{}: {} s of motion", case.name, case.t),
        guides: guides(&x, &y, -1.0),
        x,
        y,
        series,
        size: SIZE,
    }
}

/// Step against error on one case.
#[must_use]
pub fn step_error(report: &Report, case: &CaseRow) -> Plot {
    let series: Vec<Series> = METHODS
        .iter()
        .filter(|method| !method.is_direct)
        .map(|method| {
            let rows = report.rows.iter().filter(|row| row.case == case.name && row.method == method.name);
            method_series(method.name, rows.map(|row| (case.rate * row.step, row.errors.attitude_error)).collect())
        })
        .collect();
    steps(format!("{}: error after {} s against the step", case.name, case.t), series)
}

/// Step against error where orders are measured.
#[must_use]
pub fn order(report: &Report) -> Plot {
    let rate = |name: &str| report.cases.iter().find(|case| case.name == name).map_or(1.0, |case| case.rate);
    let series: Vec<Series> = report
        .orders
        .iter()
        .filter(|row| !is_direct(row.method))
        .map(|row| {
            let points =
                row.samples.iter().map(|sample| (rate(&row.case) * sample.step, sample.attitude_error)).collect();
            let slope = row.measured.map(|slope| format!("{}: {slope:.2}", row.method));
            let series = method_series(row.method, points);
            Series { label: slope.unwrap_or(series.label), ..series }
        })
        .collect();
    let t = report.orders.first().map_or(0.0, |row| row.t);
    let case = report.orders.first().map_or("", |row| row.case.as_str());
    steps(format!("Orders, measured: {case}, {t} s"), series)
}

fn steps(title: String, series: Vec<Series>) -> Plot {
    let values = series.iter().flat_map(|series| series.points.iter().map(|point| point.0));
    let x = Axis::decades("angle turned in a step, |Ω|h (rad)", values, (1e-3, 1.0));
    let y = errors_axis("attitude error (rad)", &series);
    Plot { title, guides: guides(&x, &y, 1.0), x, y, series, size: SIZE }
}

/// The four errors of the long run, with the names of their files.
#[must_use]
pub fn long_run(report: &Report) -> Vec<(&'static str, Plot)> {
    type Error = fn(&Errors) -> f64;
    let kinds: [(&str, &str, &str, Error, f64); 4] = [
        ("attitude", "Attitude", "attitude error (rad)", |errors| errors.attitude_error, LOST),
        ("energy", "Energy", "energy error (relative)", |errors| errors.energy_error, INVARIANT_LOST),
        ("momentum", "World momentum", "momentum error (relative)", |errors| errors.momentum_error, INVARIANT_LOST),
        ("orthogonality", "Staying a rotation", "|RᵀR − 1|", |errors| errors.orthogonality_error, INVARIANT_LOST),
    ];
    kinds
        .into_iter()
        .map(|(name, title, label, error, lost)| {
            let series: Vec<Series> = report
                .long_run
                .iter()
                .map(|run| {
                    let samples = run.samples.iter().map(|sample| (sample.turns, error(&sample.errors)));
                    // Up to the first sample at which it is lost; what follows is noise.
                    let mut is_lost = false;
                    let points =
                        samples.take_while(|point| !std::mem::replace(&mut is_lost, point.1 >= lost)).collect();
                    let has_markers = run.samples.len() < FEW_SAMPLES;
                    Series { has_markers, ..method_series(run.method, points) }
                })
                .collect();
            let values = series.iter().flat_map(|series| series.points.iter().map(|point| point.0));
            let x = Axis::decades("turns since the start", values.filter(|turns| *turns < 1e6), (1.0, 1e5));
            // What has blown up is past all interest.
            let values = series
                .iter()
                .flat_map(|series| series.points.iter().map(|point| point.1.clamp(SMALLEST_INVARIANT, 10.0)));
            let y = Axis::decades(label, values, (1e-16, 1.0));
            let series = series
                .into_iter()
                .map(|series| {
                    let points = series.points.iter().copied().filter(|point| point.0 <= x.range.1).collect();
                    Series { points, ..series }
                })
                .collect();
            (name, Plot { title: title.to_owned(), x, y, series, guides: Vec::new(), size: SMALL })
        })
        .collect()
}

/// Error against the step, up to three radians.
#[must_use]
pub fn large_steps(report: &Report) -> Plot {
    let series: Vec<Series> = report
        .stability
        .iter()
        .filter(|row| !is_direct(row.method))
        .map(|row| {
            let points: Vec<(f64, f64)> = row
                .samples
                .iter()
                .filter_map(|sample| Some((sample.angle, sample.errors?.attitude_error)))
                .filter(|point| point.1.is_finite())
                .collect();
            let ring = points.iter().find(|point| Some(point.0) == row.largest_right_step);
            let rings = ring.into_iter().copied().collect();
            Series { rings, has_markers: false, ..method_series(row.method, points) }
        })
        .collect();
    let x = Axis {
        range: (1e-3, 4.0),
        ..Axis::decades("angle turned in a step, |Ω|h (rad)", std::iter::empty(), (1e-3, 1.0))
    };
    let y = errors_axis("attitude error after one flip (rad)", &series);
    Plot { title: "Large steps".to_owned(), x, y, series, guides: Vec::new(), size: SIZE }
}

/// Points of a distribution, few enough to draw: each value with the share of the values below it.
fn shares(values: &[f64]) -> Vec<(f64, f64)> {
    let stride = values.len().div_ceil(DISTRIBUTION_POINTS).max(1);
    let places = values.iter().enumerate().step_by(stride);
    places.map(|(i, value)| (*value, (i as f64 + 0.5) / values.len() as f64)).collect()
}

/// How the errors of each method are spread over random bodies.
#[must_use]
pub fn many_bodies(report: &Report) -> Plot {
    let series: Vec<Series> = report
        .distributions
        .iter()
        .map(|row| {
            let points = shares(&row.errors).into_iter().map(|(error, share)| (error.max(SMALLEST_ERROR), share));
            Series { has_markers: false, ..method_series(row.method, points.collect()) }
        })
        .collect();
    let first = report.distributions.first();
    let (bodies, turned) = first.map_or((0, 0.0), |row| (row.bodies, row.turned));
    let errors = series.iter().flat_map(|series| series.points.iter().map(|point| point.0));
    Plot {
        title: format!("{bodies} bodies after {turned:.0} rad"),
        x: Axis::decades("attitude error (rad)", errors, (1e-14, 1.0)),
        y: Axis { label: "share of the bodies below".to_owned(), scale: Scale::Percent, range: (0.0, 1.0) },
        series,
        guides: Vec::new(),
        size: SIZE,
    }
}

/// Errors against the distance from the separatrix, and what an ulp of the start comes to there.
#[must_use]
pub fn separatrix(report: &Report) -> Plot {
    let rows = &report.separatrix;
    let mut series: Vec<Series> = METHODS
        .iter()
        .map(|method| {
            let error = |row: &BesideSeparatrix| {
                let own = row.errors.iter().find(|error| error.method == method.name)?;
                Some((row.tilt, own.attitude_error?.max(SMALLEST_ERROR)))
            };
            method_series(method.name, rows.iter().filter_map(error).collect())
        })
        .collect();
    let ulp = rows.iter().map(|row| (row.tilt, row.an_ulp)).collect();
    series.push(Series { has_markers: false, ..Series::new("an ulp of the start", Look::Page("ink"), ulp) });
    let t = rows.first().map_or(0.0, |row| row.t);
    Plot {
        title: format!("Beside the separatrix: {t} s from ever smaller tilts"),
        x: Axis::decades("tilt from the middle axis (rad)", rows.iter().map(|row| row.tilt), (1e-15, 1.0)),
        y: errors_axis("attitude error (rad)", &series),
        series,
        guides: Vec::new(),
        size: SIZE,
    }
}

/// The distribution of the error's ratio to plain second order.
#[must_use]
pub fn augmented(report: &Report) -> Plot {
    let looks = ["ink", "bad", "good"].map(Look::Page);
    let horizon = report.augmented.horizons.get(1);
    let series: Vec<Series> = horizon
        .into_iter()
        .flat_map(|horizon| horizon.variants.iter().zip(looks))
        .map(|(variant, look)| Series {
            has_markers: false,
            ..Series::new(variant.name, look, shares(&variant.ratios))
        })
        .collect();
    let turned = horizon.map_or(0.0, |horizon| horizon.turned);
    Plot {
        title: format!("The augmented term, after {turned:.0} rad"),
        x: Axis { label: "error ÷ error of plain second order".to_owned(), scale: Scale::Decades, range: (1e-2, 1e2) },
        y: Axis { label: "share of the bodies below".to_owned(), scale: Scale::Percent, range: (0.0, 1.0) },
        series,
        guides: Vec::new(),
        size: SIZE,
    }
}
