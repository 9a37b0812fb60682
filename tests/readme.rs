//! What README says of errors is what the table of bounds says.

use dzhanibekov::physics::bounds::{BOUNDS, Bound, Limit};

const README: &str = include_str!("../README.md");

/// A row of README's table.
fn row(bound: &Bound) -> String {
    let limit = match bound.limit {
        Limit::Fixed(0.0) => "none".to_owned(),
        Limit::Fixed(error) => format!("{error:e}"),
        Limit::Epsilons(count) => format!("{count} ε"),
        Limit::Growing(count) => format!("{count} ε(1 + x)"),
    };
    format!(
        "| {} | {} | {limit} | {} |",
        bound.of,
        bound.quantity.replace('|', "\\|"),
        bound.domain.replace('|', "\\|")
    )
}

/// Each row of the motion, bodies and flips; the elliptic functions beneath them are told of in their own documentation.
#[test]
fn every_bound_that_readme_states_is_the_table_s() {
    let wanted: Vec<String> = BOUNDS.iter().filter(|bound| !bound.of.starts_with("elliptic")).map(row).collect();
    assert!(wanted.len() >= 12);
    let missing: Vec<&String> = wanted.iter().filter(|row| !README.contains(row.as_str())).collect();
    assert!(
        missing.is_empty(),
        "README lacks:\n{}",
        missing.iter().map(|row| row.as_str()).collect::<Vec<_>>().join("\n")
    );
}
