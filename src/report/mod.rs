//! Speed against error: every method measured on this machine.
//!
//! [`measure`] fills a plain [`Report`]; the writers in [`mod@write`] turn it into a page, tables and plots, one format a file.
//! Methods are read from [`crate::physics::METHODS`]: a new row there is measured with no change here.

pub mod augmented;
pub mod batch;
pub mod cases;
pub mod cost;
pub mod distribution;
pub mod fit;
pub mod hard;
pub mod long_run;
pub mod machine;
pub mod order;
pub mod peers;
mod random;
pub mod separatrix;
pub mod stability;
pub mod timing;
pub mod work_precision;
pub mod write;

use serde::Serialize;

use augmented::Augmented;
use batch::BatchCost;
use cases::Case;
use cost::Cost;
use distribution::Distribution;
use hard::HardRow;
use long_run::LongRun;
use machine::Machine;
use order::OrderRow;
use peers::{Beside, Peer};
use separatrix::BesideSeparatrix;
use stability::Stability;
use work_precision::Row;

use crate::physics;
use crate::scene::Scene;

/// Whether the method of this name goes to any time at once: its cost is an evaluation, not a step.
fn is_direct(name: &str) -> bool {
    physics::method(name).is_some_and(|method| method.is_direct)
}

/// Case on which orders, costs and the long run are measured: generic, and every method gets along with it.
const GENERIC: &str = "Hairer-Lubich-Wanner";
/// Case that flips: large steps are tried on it.
const FLIPPING: &str = "T-handle";
/// A flip of that case, a time that the table has (s).
const FLIP_TIME: f64 = 3.317_751_5;
/// Step of the long run (s): a power of two, so that no time is rounded.
const LONG_STEP: f64 = 0.0625;

/// Why no report could be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ReportError {
    /// The embedded table cannot be read.
    #[error("the embedded reference cannot be read: {0}")]
    Reference(String),
    /// The peers' file is no list of points.
    #[error("no list of points measured elsewhere: {0}")]
    Peers(String),
}

/// How much is measured.
#[derive(Clone, Debug)]
pub struct Effort {
    /// Two cases only and less of everything.
    pub is_quick: bool,
    /// Readings of the clock for each thing timed.
    pub rounds: usize,
    /// Time (s) after which a thing timed gets no further readings.
    pub budget: f64,
    /// Longest single run (s).
    pub longest_run: f64,
    /// Factor between one number of steps and the next.
    pub refinement: u64,
    /// Steps tried in the scan of large steps.
    pub stability_points: usize,
    /// Most steps in a hard case.
    pub most_hard_steps: f64,
    /// Length of the long run (s).
    pub long_time: f64,
    /// Random bodies in the experiment on the augmented term.
    pub bodies: usize,
    /// Random bodies whose errors are looked at, and steps that each of them takes.
    pub spread: (usize, u32),
    /// Starts in a batch that goes to any time.
    pub starts: usize,
}

impl Effort {
    /// Under twenty seconds.
    #[must_use]
    pub fn quick() -> Self {
        Self {
            is_quick: true,
            rounds: 7,
            budget: 0.05,
            longest_run: 0.012,
            refinement: 2,
            stability_points: 30,
            most_hard_steps: 1e5,
            long_time: 5e5,
            bodies: 400,
            spread: (10_000, 100),
            starts: 100_000,
        }
    }

    /// A few minutes.
    #[must_use]
    pub fn full() -> Self {
        Self {
            is_quick: false,
            rounds: 11,
            budget: 0.2,
            longest_run: 0.04,
            refinement: 2,
            stability_points: 60,
            most_hard_steps: 1e6,
            long_time: 1e6,
            bodies: 4000,
            spread: (10_000, 400),
            starts: 100_000,
        }
    }
}

/// A case as the report names it.
#[derive(Clone, Debug, Serialize)]
pub struct CaseRow {
    /// Its name.
    pub name: String,
    /// Principal moments (kg m²).
    pub moments: [f64; 3],
    /// Angular velocity at the start in the body frame (rad/s).
    pub omega: [f64; 3],
    /// Its size (rad/s).
    pub rate: f64,
    /// Time at which work and precision are compared (s).
    pub t: f64,
    /// What the attitude there was compared with.
    pub reference: &'static str,
}

/// Everything that was measured.
#[derive(Clone, Debug, Serialize)]
pub struct Report {
    /// Where.
    pub machine: Machine,
    /// Whether it is the quick report.
    pub quick: bool,
    /// The cases of `rows`.
    pub cases: Vec<CaseRow>,
    /// Work and precision.
    pub rows: Vec<Row>,
    /// Orders, claimed and measured.
    pub orders: Vec<OrderRow>,
    /// Hard cases.
    pub hard: Vec<HardRow>,
    /// Costs of a step.
    pub cost: Cost,
    /// Large steps.
    pub stability: Vec<Stability>,
    /// Errors over a long time.
    pub long_run: Vec<LongRun>,
    /// Errors over random bodies.
    pub distributions: Vec<Distribution>,
    /// Starts beside the separatrix.
    pub separatrix: Vec<BesideSeparatrix>,
    /// Many bodies at a time.
    pub batch: BatchCost,
    /// The experiment on the augmented term.
    pub augmented: Augmented,
    /// Other programs' points beside the ones here.
    pub beside: Vec<Beside>,
    /// Other programs' points as they were read.
    pub peers: Vec<Peer>,
}

/// Measures everything: the cases of the table, and a scene where one is given (not where its body is at rest). `progress` is told what is
/// being done and what part of the whole is (0 to 1).
///
/// # Errors
/// See [`ReportError`].
pub fn measure(
    scene: Option<&Scene>,
    peers: Vec<Peer>,
    effort: &Effort,
    mut progress: impl FnMut(&str, f64),
) -> Result<Report, ReportError> {
    let table = cases::reference_cases()?;
    let find = |name: &str| {
        table.iter().find(|case| case.name == name).ok_or_else(|| ReportError::Reference(format!("no case {name}")))
    };
    let (generic, flipping) = (find(GENERIC)?, find(FLIPPING)?);
    let mut measured: Vec<Case> = if effort.is_quick { vec![generic.clone(), flipping.clone()] } else { table.clone() };
    measured.extend(scene.and_then(Case::of_scene).map(|case| {
        // A scene that is named as a case of the table is another motion all the same.
        let is_taken = table.iter().any(|other| other.name == case.name);
        if is_taken { Case { name: format!("{} (scene)", case.name), ..case } } else { case }
    }));

    // Shares of the whole by what they took when this was written.
    progress("cost of a step", 0.0);
    let cost = cost::measure(generic, effort);
    let mut rows = Vec::new();
    for (i, case) in measured.iter().enumerate() {
        progress(&format!("work and precision: {}", case.name), 0.05 + 0.6 * i as f64 / measured.len() as f64);
        rows.extend(work_precision::measure(case, effort));
    }
    progress("large steps", 0.65);
    let stability = stability::measure(flipping, FLIP_TIME, effort);
    let mut runs = 0.0;
    let long_run = long_run::measure(generic, effort.long_time, LONG_STEP, || {
        runs += 1.0;
        let share = runs / physics::METHODS.len() as f64;
        progress("a hundred thousand turns", 0.67 + 0.23 * share);
    });
    let hard = hard::measure(effort, |name| progress(&format!("hard case: {name}"), 0.92))?;
    progress("ten thousand bodies", 0.94);
    let distributions = distribution::measure(effort.spread.0, effort.spread.1);
    progress("beside the separatrix", 0.96);
    let separatrix = separatrix::measure(flipping);
    progress("many at a time", 0.97);
    let batch = batch::measure(effort);
    progress("the augmented term", 0.98);
    let augmented = augmented::measure(effort.bodies);
    progress("done", 1.0);
    Ok(Report {
        machine: Machine::this(),
        quick: effort.is_quick,
        cases: measured.iter().map(case_row).collect(),
        orders: order::measure(generic),
        beside: peers::beside(&peers, &rows),
        rows,
        hard,
        cost,
        stability,
        long_run,
        distributions,
        separatrix,
        batch,
        augmented,
        peers,
    })
}

fn case_row(case: &Case) -> CaseRow {
    CaseRow {
        name: case.name.clone(),
        moments: case.body.principal_moments().to_array(),
        omega: case.start.body_angular_velocity(&case.body).to_array(),
        rate: case.rate,
        t: case.time,
        reference: case.truth(case.time).1.name(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::physics::METHODS;

    fn small() -> Effort {
        Effort {
            rounds: 1,
            budget: 0.0,
            longest_run: 1e-3,
            stability_points: 6,
            most_hard_steps: 2e4,
            long_time: 1e3,
            bodies: 20,
            spread: (30, 40),
            starts: 100,
            ..Effort::quick()
        }
    }

    #[test]
    fn a_report_has_every_method_and_can_be_written_in_every_format() {
        let peers =
            r#"[{"case":"T-handle","t":60.0,"peer":"<other> & co","setting":"a=1","seconds":1.0,"error":1e-3}]"#;
        let mut last = 0.0;
        let report = peers::parse(peers).and_then(|peers| {
            measure(None, peers, &small(), |_, share| {
                assert!((last..=1.0).contains(&share), "{last} {share}");
                last = share;
            })
        });
        let Ok(report) = report else { unreachable!("{report:?}") };
        for method in METHODS {
            let name = method.name;
            assert!(report.rows.iter().any(|row| row.method == name), "{name}");
            assert!(report.orders.iter().any(|row| row.method == name && row.agrees), "{name} {:?}", report.orders);
            assert!(report.cost.methods.iter().any(|row| row.method == name && row.timing.seconds > 0.0), "{name}");
            assert!(report.long_run.iter().any(|row| row.method == name), "{name}");
            assert!(report.hard.iter().any(|row| row.method == name), "{name}");
        }
        let lost: Vec<_> = report.hard.iter().filter(|row| !row.held).collect();
        assert!(lost.is_empty(), "{lost:?}");
        assert!(report.beside.iter().all(|row| row.stepping.is_some() && row.closed_form.is_some()));

        let json: Result<serde_json::Value, _> = serde_json::from_str(&write::json::write(&report));
        assert!(json.is_ok_and(|json| {
            ["machine", "rows", "orders", "hard"].iter().all(|key| json.get(key).is_some())
                && ["case", "method", "step", "t", "steps", "seconds", "ns_per_step", "attitude_error", "energy_error"]
                    .iter()
                    .all(|key| json["rows"][0].get(key).is_some())
        }));
        let csv = write::csv::write(&report);
        let columns = csv.lines().next().map_or(0, |head| head.split(',').count());
        assert!(csv.lines().all(|line| line.split(',').count() == columns));
        assert_eq!(csv.lines().count(), report.rows.len() + 1);
        let html = write::html::write(&report);
        assert!(html.contains("&lt;other&gt; &amp; co") && !html.contains("<other>"));
        for (name, plot) in write::plots::all(&report) {
            let svg = plot.standalone();
            assert!(svg.starts_with("<svg") && svg.ends_with("</svg>\n") && !svg.contains("NaN"), "{name}");
        }
        assert!(write::terminal::write(&report).lines().count() > METHODS.len());
    }
}
