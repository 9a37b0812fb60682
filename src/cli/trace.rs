//! `trace`: the motion as numbers.

use std::path::PathBuf;

use clap::Args;
use clap::builder::{OsStringValueParser, TypedValueParser};
use dzhanibekov::physics::{Body, Integration, State};
use dzhanibekov::scene::Scene;

use super::arguments::SceneArguments;
use super::failure::Failure;
use super::output::{check_place, io_failure, write_whole};
use super::signal;
use super::times::{Decimal, Times, check_steps, rough, short, span, sweep, time_of};

const HEADER: &str = "t,r11,r12,r13,r21,r22,r23,r31,r32,r33,M1,M2,M3,W1,W2,W3,L1,L2,L3,energy\n";
/// Most rows at equal distances: some hundred gigabytes.
const MOST_ROWS: u64 = 1_000_000_000;

/// Flags of `trace`.
#[derive(Args, Debug)]
pub(super) struct TraceArguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// File to write, or - for standard output
    #[arg(short, long, value_name = "FILE.csv|-", default_value = "-")]
    output: PathBuf,
    /// Times wanted (s), in any order; or a file of them, or - for standard input
    #[arg(long, value_name = "T,T,…|@FILE|-", value_parser = OsStringValueParser::new().try_map(Times::parse), allow_hyphen_values = true, conflicts_with_all = ["every", "duration"])]
    at: Option<Times>,
    /// Time between rows (s); 0.01 where left out
    #[arg(long, value_name = "DT", value_parser = Decimal::parse, allow_hyphen_values = true)]
    every: Option<Decimal>,
    /// Time past which there is no row (s); 10 where left out
    #[arg(long, value_name = "T", value_parser = Decimal::parse, allow_hyphen_values = true)]
    duration: Option<Decimal>,
    /// Say nothing but errors
    #[arg(long)]
    quiet: bool,
}

/// The rows wanted.
enum Rows {
    /// At these times (s), in this order.
    At(Vec<f64>),
    /// At the multiples 0 to `last` of a time.
    Every(Decimal, u64),
}

pub(super) fn run(arguments: &TraceArguments) -> Result<(), Failure> {
    signal::end_at_once()?;
    let scene = arguments.scene.scene(None, arguments.quiet)?;
    check_place(&arguments.output)?;
    let rows = rows(arguments, &scene)?;
    let mut integration =
        Integration::with_energy_loss(scene.method, &scene.body, scene.start, scene.step, scene.energy_loss);
    let mut state_at =
        |time| integration.state_at(time).map_err(|error| Failure::could_not(format!("at {} s: {error}", short(time))));
    write_whole(&arguments.output, |writer| {
        let mut line = HEADER.to_owned();
        let mut put = |time, state: &State| {
            write_row(&mut line, time, state, &scene.body);
            let written = writer.write_all(line.as_bytes());
            line.clear();
            written.map_err(|error| io_failure(&arguments.output, error))
        };
        match rows {
            Rows::Every(step, last) => {
                for index in 0..=last {
                    let time = step.times(index);
                    put(time, &state_at(time)?)?;
                }
            }
            Rows::At(times) => match sweep(&times).filter(|_| !scene.method.is_direct) {
                None => {
                    for time in times {
                        put(time, &state_at(time)?)?;
                    }
                }
                Some(order) => {
                    // Steps are not undone: all in one sweep, then put back in the order asked for.
                    let mut states = vec![scene.start; times.len()];
                    for index in order {
                        states[index] = state_at(times[index])?;
                    }
                    for (time, state) in times.into_iter().zip(&states) {
                        put(time, state)?;
                    }
                }
            },
        }
        Ok(())
    })
}

/// The rows that are asked for, where there is an end to them.
fn rows(arguments: &TraceArguments, scene: &Scene) -> Result<Rows, Failure> {
    if let Some(times) = &arguments.at {
        let times = times.read()?;
        let farthest =
            times.iter().fold(0.0_f64, |farthest, time| if time.abs() > farthest.abs() { *time } else { farthest });
        check_steps(scene, &format!("--at {}", short(farthest)), farthest, [&scene.method])?;
        return Ok(Rows::At(times));
    }
    let every = arguments.every.map_or_else(|| Decimal::parse("0.01"), Ok).map_err(Failure::request)?;
    let duration = arguments.duration.map_or_else(|| Decimal::parse("10"), Ok).map_err(Failure::request)?;
    if !(every.value.is_finite() && every.value > 0.0) {
        return Err(Failure::request(format!(
            "--every {} is not valid: it must be finite and above 0",
            short(every.value)
        )));
    }
    if !(duration.value.is_finite() && duration.value >= 0.0) {
        return Err(Failure::request(format!(
            "--duration {} is not valid: it must be finite and not negative",
            short(duration.value)
        )));
    }
    let last = duration.whole_parts(every).and_then(|last| u64::try_from(last).ok()).filter(|last| *last < MOST_ROWS);
    let Some(last) = last else {
        let count = duration.value / every.value;
        let mut line = String::new();
        let seconds = time_of(count, || {
            line.clear();
            write_row(&mut line, every.value, &scene.start, &scene.body);
        });
        return Err(Failure::request(format!(
            "--every {} up to {} s makes {} rows, about {} of writing: at most {} are written, so take a longer --every, or --at with the times wanted",
            short(every.value),
            short(duration.value),
            rough(count),
            span(seconds),
            rough(MOST_ROWS as f64)
        )));
    };
    check_steps(scene, &format!("--duration {}", short(duration.value)), every.times(last), [&scene.method])?;
    Ok(Rows::Every(every, last))
}

/// One line of the table, with the shortest decimals that read back to the same numbers.
fn write_row(line: &mut String, time: f64, state: &State, body: &Body) {
    let mut buffer = ryu::Buffer::new();
    let mut put = |value: f64, end: char| {
        line.push_str(buffer.format(value));
        line.push(end);
    };
    put(time, ',');
    let rows = state.world_from_body.transpose();
    let angular_velocity = state.body_angular_velocity(body);
    for vector in [rows.x_axis, rows.y_axis, rows.z_axis, state.body_momentum, angular_velocity, state.world_momentum] {
        for component in vector.to_array() {
            put(component, ',');
        }
    }
    put(state.energy(body), '\n');
}
