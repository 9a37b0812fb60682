//! `report`: speed against error, measured on this machine.

use std::io::{IsTerminal, Write};
use std::path::Path;

use dzhanibekov::files;
use dzhanibekov::report::cases::Case;
use dzhanibekov::report::{self, Effort, Report, ReportError, peers, write};
use indicatif::{ProgressBar, ProgressStyle};

use super::arguments::ReportArguments;
use super::failure::{Failure, say};
use super::output::{check_place, io_failure};

/// Folder of a report that names none.
const DEFAULT_FOLDER: &str = "report";
/// Largest file of peers read (bytes).
const LARGEST_FILE: u64 = 16 << 20;
/// Steps of the progress bar.
const BAR: f64 = 1000.0;

pub(super) fn run(arguments: &ReportArguments) -> Result<(), Failure> {
    super::signal::end_at_once()?;
    let scene = if arguments.scene.is_given() { Some(arguments.scene.scene(None, arguments.quiet)?) } else { None };
    let is_at_rest = scene.as_ref().is_some_and(|scene| Case::of_scene(scene).is_none());
    if is_at_rest && !arguments.quiet {
        say("the body of the scene is at rest: there is nothing to measure on it, and it is left out");
    }
    let peers = arguments.peers.as_deref().map(read_peers).transpose()?.unwrap_or_default();
    let folder = match (&arguments.output, &arguments.json) {
        (Some(folder), _) => Some(folder.as_path()),
        (None, Some(_)) => None,
        (None, None) => Some(Path::new(DEFAULT_FOLDER)),
    };
    // Minutes of measuring are not to end in a place that cannot be written.
    let made = folder.map(prepare).transpose()?;
    if let Some(file) = &arguments.json {
        check_place(file)?;
    }

    let effort = if arguments.quick { Effort::quick() } else { Effort::full() };
    let bar = bar(arguments.quiet);
    let report = report::measure(scene.as_ref(), peers, &effort, |doing, share| {
        bar.set_position((BAR * share) as u64);
        bar.set_message(doing.to_owned());
    });
    bar.finish_and_clear();
    let report = report.map_err(|error| Failure::could_not(error.to_string()))?;

    if let Some(folder) = folder {
        write_folder(&report, folder)?;
    }
    // What holds the report stays.
    drop(made);
    if let Some(file) = &arguments.json {
        write_text(file, &write::json::write(&report))?;
    }
    if !arguments.quiet {
        // Words for a reader: where they cannot be read the report stands all the same.
        let _ = std::io::stderr().write_all(write::terminal::write(&report).as_bytes());
        let left_out = report.peers.len() - report.beside.len();
        if left_out > 0 {
            say(&format!("{left_out} of the peers' points are of motions or times that were not measured"));
        }
        if let Some(folder) = folder {
            say(&format!("the report is in {}", folder.join("report.html").display()));
        }
    }
    Ok(())
}

fn write_folder(report: &Report, folder: &Path) -> Result<(), Failure> {
    for (name, drawing) in write::plots::all(report) {
        write_text(&folder.join(format!("{name}.svg")), &drawing.standalone())?;
    }
    write_text(&folder.join("report.csv"), &write::csv::write(report))?;
    write_text(&folder.join("report.json"), &write::json::write(report))?;
    write_text(&folder.join("report.html"), &write::html::write(report))
}

fn write_text(path: &Path, text: &str) -> Result<(), Failure> {
    Ok(files::write(path, text.as_bytes())?)
}

/// Makes the folder and tries whether a file can be made in it.
fn prepare(folder: &Path) -> Result<files::Folder, Failure> {
    if folder == Path::new("-") {
        return Err(Failure::request(
            "- names no folder: name one, or give --json - for the numbers on standard output",
        ));
    }
    if folder.exists() && !folder.is_dir() {
        return Err(Failure::request(format!("{} is a file: name a folder", folder.display())));
    }
    let made = files::Folder::make(folder).map_err(|error| io_failure(folder, error))?;
    // Dropped, it is gone.
    files::Output::create(&folder.join("report.html"))?;
    Ok(made)
}

fn read_peers(path: &Path) -> Result<Vec<peers::Peer>, Failure> {
    let text = files::read_text(path, LARGEST_FILE)?;
    peers::parse(&text).map_err(|error: ReportError| Failure::request(format!("{}: {error}", path.display())))
}

/// A bar on a terminal, nothing elsewhere.
fn bar(is_quiet: bool) -> ProgressBar {
    if is_quiet || !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(BAR as u64);
    if let Ok(style) = ProgressStyle::with_template("{bar:30} {percent:>3} %  {msg}") {
        bar.set_style(style.progress_chars("━╸ "));
    }
    bar
}
