//! The command line: what can be asked, dispatch, and errors in one sentence with the right exit code.

mod arguments;
mod failure;
#[cfg(feature = "headless")]
mod figure;
mod flags;
#[cfg(feature = "headless")]
mod handout;
mod lists;
mod manual;
mod output;
#[cfg(feature = "headless")]
mod page;
#[cfg(feature = "headless")]
mod picture;
#[cfg(any(feature = "headless", feature = "window"))]
mod quiet_driver;
#[cfg(feature = "headless")]
mod record;
#[cfg(feature = "report")]
mod report;
#[cfg(feature = "headless")]
mod sheet;
mod signal;
#[cfg(feature = "headless")]
mod size;
mod times;
mod trace;

use std::ffi::{OsStr, OsString};
use std::path::Path;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

use arguments::SceneArguments;
use failure::Failure;
use flags::ViewFlags;

/// See, teach and measure how a free rigid body turns: the Dzhanibekov effect (tennis-racket theorem).
///
/// Without a command it opens the window on SCENE. Every command lists its own flags and examples:
/// `dzhanibekov shot --help`.
#[derive(Parser, Debug)]
#[command(
    version,
    args_conflicts_with_subcommands = true,
    args_override_self = true,
    infer_long_args = false,
    max_term_width = 100
)]
#[command(after_help = "Examples:
  dzhanibekov                                   the window, on the scene `flip`
  dzhanibekov --box 0.2,0.12,0.04 --axis 2 --tilt 0.01 --rate 6
  dzhanibekov shot flip --time 3 -o flip.png    one picture, no window, no display
  dzhanibekov trace flip --every 0.01 --duration 10 -o flip.csv")]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    view: ViewFlags,
    /// Step of the scene to begin at, counted from 1
    #[arg(long, value_name = "N", allow_hyphen_values = true, help_heading = "Picture")]
    scene_step: Option<usize>,
    /// Size of the window in pixels
    #[arg(long, value_name = "WxH", help_heading = "Picture")]
    size: Option<String>,
    /// Name (or a part of it) of the graphics adapter to draw with
    #[arg(long, value_name = "NAME", help_heading = "Picture")]
    adapter: Option<String>,
    /// Say nothing but errors
    #[arg(long)]
    quiet: bool,
}

#[derive(Subcommand, Debug)]
enum Command {
    #[cfg(feature = "headless")]
    /// Draw one picture to a file, with no window and no display
    #[command(after_help = "Examples:
  dzhanibekov shot flip -o flip.png
  dzhanibekov shot flip --time 2.5 --size 3840x2160 --theme light -o flip.png
  dzhanibekov shot flip --time 2.5 --width 86mm --dpi 600 --theme light -o figure.png
  dzhanibekov shot flip --time 2.5 --panel -o window.png
  dzhanibekov shot --moments 1,2,3 --omega 0,1,0.001 --view body -o - | display")]
    Shot(Box<picture::ShotArguments>),
    #[cfg(feature = "headless")]
    /// Record moving pictures: numbered PNG files, GIF, animated PNG, films through ffmpeg, or a stream
    #[command(after_help = "Examples:
  dzhanibekov record flip -o frame-{:05}.png --fps 60 --duration 10
  dzhanibekov record flip -o flip.gif --fps 50 --duration 5 --size 640x360
  dzhanibekov record flip -o flip.mp4 --duration 20 --size 1920x1080
  dzhanibekov record flip -o flip.webm --transparent --view world      also .mov and .mkv
  dzhanibekov record flip -o - | ffplay -
  dzhanibekov record flip -o frame-{:05}.png --frames 0..300 --keep")]
    Record(Box<record::RecordArguments>),
    #[cfg(feature = "headless")]
    /// Write a scene's steps as pages: words, picture, question and graph
    #[command(after_help = "Examples:
  dzhanibekov handout flip -o flip.pdf
  dzhanibekov handout flip --answer -o flip.pdf
  dzhanibekov handout flip --theme dark -o flip.png    flip-1.png and so on")]
    Handout(Box<handout::HandoutArguments>),
    /// Write the motion as numbers (CSV)
    #[command(after_help = "Examples:
  dzhanibekov trace flip --at 0,1,10
  dzhanibekov trace --moments 0.5,0.85,1 --omega 0.4,1.18,0.4 --method buss --step 0.001 --at 30
  dzhanibekov trace flip --every 0.01 --duration 10 -o flip.csv")]
    Trace(Box<trace::TraceArguments>),
    #[cfg(feature = "report")]
    /// Measure every method here: speed against error, as a page, tables and plots
    #[command(after_help = "Examples:
  dzhanibekov report -o report                  report/report.html and the rest
  dzhanibekov report --quick --json -           the numbers of two cases
  dzhanibekov report flip --peers peers.json    a scene besides, and other programs' points")]
    Report(Box<arguments::ReportArguments>),
    /// List the scenes built in
    #[command(after_help = "Examples:
  dzhanibekov scenes
  dzhanibekov scenes --json")]
    Scenes(lists::ListArguments),
    /// List the methods
    #[command(after_help = "Examples:
  dzhanibekov methods
  dzhanibekov methods --json")]
    Methods(lists::ListArguments),
    /// List the keys of a scene file, which --set takes, and those inside of [[step]] and [[body.solids]]
    #[command(after_help = "Examples:
  dzhanibekov keys
  dzhanibekov keys --json")]
    Keys(lists::ListArguments),
    #[cfg(feature = "picture")]
    /// List the things that can be drawn, which --show and --hide take
    #[command(after_help = "Examples:
  dzhanibekov objects
  dzhanibekov objects --json")]
    Objects(lists::ListArguments),
    #[cfg(feature = "headless")]
    /// List the graphics adapters
    #[command(after_help = "Examples:
  dzhanibekov adapters
  dzhanibekov shot flip --adapter llvmpipe -o flip.png    a part of a name chooses it")]
    Adapters(lists::ListArguments),
    /// Write the man page to standard output: dzhanibekov man | man -l -
    #[command(
        hide = true,
        after_help = "Examples:
  dzhanibekov man | man -l -"
    )]
    Man,
    /// Write completions for a shell to standard output
    #[command(
        hide = true,
        after_help = "Examples:
  dzhanibekov completions bash"
    )]
    Completions(manual::CompletionArguments),
}

/// Runs the program and turns its outcome into the exit code: 0 done, 1 it could not, 2 the request was wrong.
pub(crate) fn main() -> ExitCode {
    let outcome = left_out(std::env::args_os().nth(1).as_deref()).map_or_else(
        || match Arguments::try_parse_from(scene_last(std::env::args_os())) {
            Ok(arguments) => run(arguments),
            Err(error) => failure::of_command_line(&error).map_or_else(|| print_help(&error), Err),
        },
        Err,
    );
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

/// Why there is no such command, where this program was built without the room that it runs.
fn left_out(first: Option<&OsStr>) -> Option<Failure> {
    /// A command, what it is for, the feature that brings it, and whether that is there.
    const PARTS: [(&str, &str, &str, bool); 6] = [
        ("shot", "pictures", "headless", cfg!(feature = "headless")),
        ("record", "pictures", "headless", cfg!(feature = "headless")),
        ("handout", "pictures", "headless", cfg!(feature = "headless")),
        ("adapters", "pictures", "headless", cfg!(feature = "headless")),
        ("objects", "pictures", "picture", cfg!(feature = "picture")),
        ("report", "the report", "report", cfg!(feature = "report")),
    ];
    let first = first?;
    let (_, what, feature, _) = PARTS.into_iter().find(|(name, _, _, is_there)| first == *name && !is_there)?;
    Some(Failure::not_built(what, feature))
}

/// The words of a command line with a scene that follows `--` put at the end, so that flags may stand after it:
/// `-- methods --size 1280x720` opens the scene that is named like a command.
fn scene_last(words: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let mut words: Vec<OsString> = words.collect();
    if let Some(dashes) = words.iter().position(|word| word == "--")
        && words.len() > dashes + 2
    {
        // The two words `--` and the scene's name.
        words[dashes..].rotate_left(2);
    }
    words
}

/// Prints help or the version, which were asked for.
fn print_help(asked: &clap::Error) -> Result<(), Failure> {
    let stdout = Path::new("-");
    output::check_place(stdout)?;
    asked.print().map_err(|error| output::io_failure(stdout, error))
}

fn run(arguments: Arguments) -> Result<(), Failure> {
    match arguments.command {
        None => window(&arguments),
        #[cfg(feature = "headless")]
        Some(Command::Shot(shot)) => picture::shot(&shot),
        #[cfg(feature = "headless")]
        Some(Command::Record(recording)) => record::run(&recording),
        #[cfg(feature = "headless")]
        Some(Command::Handout(handout)) => handout::run(&handout),
        Some(Command::Trace(trace)) => trace::run(&trace),
        #[cfg(feature = "report")]
        Some(Command::Report(report)) => report::run(&report),
        Some(Command::Scenes(list)) => lists::scenes(&list),
        Some(Command::Methods(list)) => lists::methods(&list),
        Some(Command::Keys(list)) => lists::keys(&list),
        #[cfg(feature = "picture")]
        Some(Command::Objects(list)) => lists::objects(&list),
        #[cfg(feature = "headless")]
        Some(Command::Adapters(list)) => picture::adapters(&list),
        Some(Command::Man) => manual::man(),
        Some(Command::Completions(completions)) => manual::completions(&completions),
    }
}

fn window(arguments: &Arguments) -> Result<(), Failure> {
    #[cfg(feature = "window")]
    {
        quiet_driver::keep_quiet();
        let (scene, slides) = arguments.scene.slides(&arguments.view, arguments.scene_step, arguments.quiet)?;
        let size = arguments.size.as_deref().map(arguments::size).transpose().map_err(Failure::request)?;
        let adapter = arguments.adapter.clone();
        let place = arguments.scene.place();
        let (time, paused) = (arguments.scene.time(), arguments.scene.is_picture());
        let options = dzhanibekov::app::WindowOptions { size, adapter, slides, place, time, paused };
        dzhanibekov::app::run(scene, options).map_err(|error| Failure::could_not(error.to_string()))
    }
    #[cfg(not(feature = "window"))]
    {
        arguments.scene.scene(Some(&arguments.view), arguments.quiet)?;
        let _ = (&arguments.size, &arguments.adapter, arguments.scene_step);
        Err(Failure::not_built("the window", "window"))
    }
}
