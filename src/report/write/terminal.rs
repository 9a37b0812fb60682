//! The summary on the terminal.

use std::fmt::Write as _;

use super::summary::{self, Summary};
use crate::report::Report;

/// A table of the methods and what is worth a word.
#[must_use]
pub fn write(report: &Report) -> String {
    let mut rows = vec![summary::HEADER.map(str::to_owned)];
    rows.extend(summary::of(report).iter().map(Summary::cells));
    let mut widths = [0; summary::COLUMNS];
    for row in &rows {
        for (width, cell) in widths.iter_mut().zip(row) {
            *width = (*width).max(cell.chars().count());
        }
    }
    let mut text = format!("{}\n\n", report.machine.line());
    for row in &rows {
        let mut line = String::new();
        for (i, (width, cell)) in widths.iter().zip(row).enumerate() {
            // Writing to a string cannot fail. Names to the left, numbers to the right.
            let _ = if i == 0 { write!(line, "{cell:width$}") } else { write!(line, "  {cell:>width$}") };
        }
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text.push('\n');
    for remark in summary::remarks(report) {
        let _ = writeln!(text, "{remark}");
    }
    text
}
