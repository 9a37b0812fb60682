//! What every writer says first: one line a method, and the remarks.

use super::format::{short, time, times};
use crate::physics::METHODS;
use crate::physics::methods::Order;
use crate::report::Report;
use crate::report::peers::Beside;

/// Number of columns.
pub const COLUMNS: usize = 8;

/// Names of the columns.
pub const HEADER: [&str; COLUMNS] =
    ["method", "order", "measured", "a step", "× floor", "best error", "flips up to", "hard cases"];

/// One method.
#[derive(Clone, Debug)]
pub struct Summary {
    /// Its name.
    pub method: &'static str,
    /// Claimed order.
    pub order: String,
    /// Measured order.
    pub measured: String,
    /// Time of a step.
    pub step: String,
    /// Its ratio to the floor.
    pub ratio: String,
    /// Smallest attitude error on the case on which orders are measured.
    pub best: String,
    /// Largest step that flips rightly.
    pub flips: String,
    /// Hard cases held, of those where something is promised.
    pub hard: String,
}

impl Summary {
    /// The cells of its row.
    #[must_use]
    pub fn cells(&self) -> [String; COLUMNS] {
        let s = self.clone();
        [s.method.to_owned(), s.order, s.measured, s.step, s.ratio, s.best, s.flips, s.hard]
    }
}

/// One summary a method.
#[must_use]
pub fn of(report: &Report) -> Vec<Summary> {
    METHODS
        .iter()
        .map(|method| {
            let name = method.name;
            let order = report.orders.iter().find(|order| order.method == name);
            let cost = report.cost.methods.iter().find(|cost| cost.method == name);
            let case = order.map_or("", |order| order.case.as_str());
            let best = report
                .rows
                .iter()
                .filter(|row| row.method == name && row.case == case)
                .map(|row| row.errors.attitude_error)
                .fold(f64::INFINITY, f64::min);
            let stability = report.stability.iter().find(|stability| stability.method == name);
            let promised: Vec<_> = report.hard.iter().filter(|row| row.method == name && row.is_promised()).collect();
            let held = promised.iter().filter(|row| row.held).count();
            let measured = match order {
                Some(order) => match (order.measured, order.agrees) {
                    (Some(slope), true) => format!("{slope:.2}"),
                    (Some(slope), false) => format!("{slope:.2} ✗"),
                    (None, true) => "–".to_owned(),
                    (None, false) => "none ✗".to_owned(),
                },
                None => "–".to_owned(),
            };
            Summary {
                method: name,
                order: match method.order {
                    Order::Finite(order) => order.to_string(),
                    Order::Exact => "exact".to_owned(),
                },
                measured,
                step: cost.map_or_else(String::new, |cost| time(cost.timing.seconds)),
                ratio: cost.map_or_else(String::new, |cost| format!("{:.1}", cost.ratio)),
                best: if best.is_finite() { short(best) } else { "–".to_owned() },
                flips: if method.is_direct {
                    "any step".to_owned()
                } else {
                    stability
                        .and_then(|stability| stability.largest_right_step)
                        .map_or("none".to_owned(), |angle| format!("{angle:.2} rad"))
                },
                hard: format!("{held}/{}", promised.len()),
            }
        })
        .collect()
}

/// Sentences on what differs from the claims, and on the comparison with other programs.
#[must_use]
pub fn remarks(report: &Report) -> Vec<String> {
    let mut remarks = Vec::new();
    for order in report.orders.iter().filter(|order| !order.agrees) {
        remarks.push(format!("{} {}.", order.method, order.words));
    }
    for row in report.hard.iter().filter(|row| !row.held) {
        let said = match (&row.said, row.error) {
            (Some(said), _) => said.clone(),
            (None, Some(error)) => {
                format!("error {} past the bound {}", short(error), row.bound.map_or_else(|| "–".to_owned(), short))
            }
            (None, None) => "no number".to_owned(),
        };
        remarks.push(format!("{} does not hold {}: {said}.", row.method, row.case));
    }
    if remarks.is_empty() {
        remarks.push("Every measured order agrees with the claim, and every hard case is held.".to_owned());
    }
    remarks.push(report.augmented.words.clone());
    remarks.extend(beside(report));
    if !report.machine.is_optimised {
        remarks.push("This program was built without optimisation: the times say nothing.".to_owned());
    }
    remarks
}

/// One sentence for each other program and case: the least advantage over its points.
fn beside(report: &Report) -> Vec<String> {
    let mut pairs: Vec<(&str, &str)> = Vec::new();
    for row in &report.beside {
        let pair = (row.peer.peer.as_str(), row.peer.case.as_str());
        if !pairs.contains(&pair) {
            pairs.push(pair);
        }
    }
    let sentence = |(peer, case): (&str, &str)| {
        let rows = || report.beside.iter().filter(|row| row.peer.peer == peer && row.peer.case == case);
        // None as soon as one point has no answer.
        let least = |factor: fn(&Beside) -> Option<f64>| {
            rows().map(factor).try_fold(f64::INFINITY, |least, next| next.map(|next| next.min(least)))
        };
        let stepping = least(|row| row.stepping.as_ref().map(|faster| faster.times_faster));
        let closed = least(|row| row.closed_form.as_ref().map(|faster| faster.times_faster));
        let says = |least: Option<f64>| match least {
            Some(factor) => format!("at least {} times as fast", times(factor)),
            None => "not at every point as accurate".to_owned(),
        };
        format!(
            "Beside {peer} on {case}, at each of its {} errors: the best stepping method is {}, the closed form {}.",
            rows().count(),
            says(stepping),
            says(closed)
        )
    };
    pairs.into_iter().map(sentence).collect()
}
