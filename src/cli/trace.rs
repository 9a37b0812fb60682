//! `trace`: the motion as numbers.

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use dzhanibekov::physics::{Body, Integration, State};

use super::arguments::{SceneArguments, number_list};
use super::failure::Failure;
use super::output::{io_failure, write_whole};
use super::signal;

const HEADER: &str = "t,r11,r12,r13,r21,r22,r23,r31,r32,r33,M1,M2,M3,W1,W2,W3,L1,L2,L3,energy\n";
const DEFAULT_EVERY: f64 = 0.01;
const DEFAULT_DURATION: f64 = 10.0;

/// Flags of `trace`.
#[derive(Args, Debug)]
pub(super) struct TraceArguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// File to write, or - for standard output
    #[arg(short, long, value_name = "FILE.csv|-", default_value = "-")]
    output: PathBuf,
    /// Times wanted (s), in any order
    #[arg(long, value_name = "T,T,…", value_parser = times, allow_hyphen_values = true, conflicts_with_all = ["every", "duration"])]
    at: Option<Times>,
    /// Time between rows (s); 0.01 where left out
    #[arg(long, value_name = "DT", allow_hyphen_values = true)]
    every: Option<f64>,
    /// Time of the last row (s); 10 where left out
    #[arg(long, value_name = "T", allow_hyphen_values = true)]
    duration: Option<f64>,
    /// Say nothing but errors
    #[arg(long)]
    quiet: bool,
}

/// A list of times (s), each finite.
#[derive(Clone, Debug)]
struct Times(Vec<f64>);

fn times(text: &str) -> Result<Times, String> {
    let times = number_list(text)?;
    match times.iter().find(|time| !time.is_finite()) {
        Some(time) => Err(format!("the time {time} is not finite")),
        None => Ok(Times(times)),
    }
}

pub(super) fn run(arguments: &TraceArguments) -> Result<(), Failure> {
    signal::end_at_once()?;
    let scene = arguments.scene.scene(None, arguments.quiet)?;
    let mut integration = Integration::new(scene.method, &scene.body, scene.start, scene.step);
    let every = arguments.every.unwrap_or(DEFAULT_EVERY);
    let duration = arguments.duration.unwrap_or(DEFAULT_DURATION);
    if !(every.is_finite() && every > 0.0) {
        return Err(Failure::request(format!("--every {every:?} is not valid: it must be finite and above 0")));
    }
    if !(duration.is_finite() && duration >= 0.0) {
        return Err(Failure::request(format!(
            "--duration {duration:?} is not valid: it must be finite and not negative"
        )));
    }
    write_whole(&arguments.output, |writer| {
        let fail = |error| io_failure(&arguments.output, &error);
        writer.write_all(HEADER.as_bytes()).map_err(fail)?;
        let mut line = String::new();
        let mut row = |time: f64, writer: &mut dyn Write| {
            let state = integration.state_at(time).map_err(|error| Failure::could(format!("at {time} s: {error}")))?;
            line.clear();
            write_row(&mut line, time, &state, &scene.body);
            writer.write_all(line.as_bytes()).map_err(fail)
        };
        if let Some(Times(times)) = &arguments.at {
            for &time in times {
                row(time, writer)?;
            }
            return Ok(());
        }
        // A last row that rounding puts an ulp past the end belongs to it.
        let last = (duration / every * (1.0 + 4.0 * f64::EPSILON)).floor();
        let mut index = 0.0;
        while index <= last {
            row(index * every, writer)?;
            index += 1.0;
        }
        Ok(())
    })
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
