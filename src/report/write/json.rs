//! `report.json`.

use crate::report::Report;

/// The whole report. Numbers that are none (a method that blew up) become `null`.
#[must_use]
pub fn write(report: &Report) -> String {
    // A plain structure with string keys: it has no way to fail.
    serde_json::to_string_pretty(report).unwrap_or_default() + "\n"
}
