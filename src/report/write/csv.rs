//! `report.csv`: the rows of work and precision, one a line.

use std::fmt::Write as _;

use crate::report::Report;

const HEADER: &str = "case,method,step,t,steps,seconds,seconds_min,seconds_max,seconds_lower,seconds_upper,repeats,ns_per_step,prepare_seconds,\
attitude_error,energy_error,momentum_error,orthogonality_error,reference\n";

/// The rows with a header line; shortest decimals that read back to the same f64.
#[must_use]
pub fn write(report: &Report) -> String {
    let mut text = HEADER.to_owned();
    for row in &report.rows {
        let (timing, errors) = (row.timing, row.errors);
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{},{},{:?},{:?},{},{:?},{:?},{:?},{:?},{:?},{},{:?},{:?},{:?},{:?},{:?},{:?},{}",
            quoted(&row.case),
            row.method,
            row.step,
            row.t,
            row.steps,
            timing.seconds,
            timing.seconds_min,
            timing.seconds_max,
            timing.seconds_lower,
            timing.seconds_upper,
            timing.repeats,
            row.ns_per_step,
            row.prepare_seconds,
            errors.attitude_error,
            errors.energy_error,
            errors.momentum_error,
            errors.orthogonality_error,
            row.reference.name(),
        );
    }
    text
}

/// A field in quotes where it needs them (RFC 4180).
fn quoted(field: &str) -> String {
    if field.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", field.replace('"', "\"\""))
    } else {
        field.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::quoted;

    #[test]
    fn fields_are_quoted_where_needed() {
        assert_eq!(quoted("T-handle"), "T-handle");
        assert_eq!(quoted("a, \"b\""), "\"a, \"\"b\"\"\"");
    }
}
