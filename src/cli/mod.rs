//! The command line: what can be asked, dispatch, and errors in one sentence with the right exit code.

mod arguments;
mod failure;
mod lists;
mod manual;
mod output;
#[cfg(feature = "picture")]
mod picture;
#[cfg(feature = "picture")]
mod quiet_driver;
#[cfg(feature = "picture")]
mod record;
#[cfg(feature = "report")]
mod report;
mod signal;
mod times;
mod trace;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use arguments::{SceneArguments, ViewArguments};
use failure::Failure;

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
    view: ViewArguments,
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
    #[cfg(feature = "picture")]
    /// Draw one picture to a file, with no window and no display
    #[command(after_help = "Examples:
  dzhanibekov shot flip -o flip.png
  dzhanibekov shot flip --time 2.5 --size 3840x2160 --theme light -o flip.png
  dzhanibekov shot flip --time 2.5 --panel -o window.png
  dzhanibekov shot --moments 1,2,3 --omega 0,1,0.001 --view body -o - | display")]
    Shot(Box<picture::ShotArguments>),
    #[cfg(feature = "picture")]
    /// Record moving pictures: numbered PNG files, GIF, animated PNG, MP4, or a stream
    #[command(after_help = "Examples:
  dzhanibekov record flip -o frame-{:05}.png --fps 60 --duration 10
  dzhanibekov record flip -o flip.gif --fps 50 --duration 5 --size 640x360
  dzhanibekov record flip -o flip.mp4 --duration 20 --size 1920x1080
  dzhanibekov record flip -o - | ffplay -
  dzhanibekov record flip -o frame-{:05}.png --frames 0..300 --keep")]
    Record(Box<record::RecordArguments>),
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
    #[cfg(feature = "picture")]
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
    let outcome = match Arguments::try_parse() {
        Ok(arguments) => run(arguments),
        Err(error) => match failure::of_command_line(&error) {
            Some(failure) => Err(failure),
            None => {
                // Help and version, asked for.
                return match error.print() {
                    Ok(()) => ExitCode::SUCCESS,
                    Err(_) => ExitCode::FAILURE,
                };
            }
        },
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

fn run(arguments: Arguments) -> Result<(), Failure> {
    match arguments.command {
        None => window(&arguments),
        #[cfg(feature = "picture")]
        Some(Command::Shot(shot)) => picture::shot(&shot),
        #[cfg(feature = "picture")]
        Some(Command::Record(recording)) => record::run(&recording),
        Some(Command::Trace(trace)) => trace::run(&trace),
        #[cfg(feature = "report")]
        Some(Command::Report(report)) => report::run(&report),
        Some(Command::Scenes(list)) => lists::scenes(&list),
        Some(Command::Methods(list)) => lists::methods(&list),
        #[cfg(feature = "picture")]
        Some(Command::Adapters(list)) => picture::adapters(&list),
        Some(Command::Man) => manual::man(),
        Some(Command::Completions(completions)) => manual::completions(&completions),
    }
}

fn window(arguments: &Arguments) -> Result<(), Failure> {
    #[cfg(feature = "window")]
    {
        quiet_driver::keep_quiet();
        let (scene, slides) = arguments.scene.slides(&arguments.view, arguments.quiet)?;
        picture::check_objects(&scene)?;
        let size = arguments.size.as_deref().map(arguments::size).transpose().map_err(Failure::request)?;
        let encode_png = |pixels: &dzhanibekov::render::Pixels, transparent| {
            dzhanibekov::render::png::encode(pixels, transparent, &[]).map_err(|error| error.to_string())
        };
        let adapter = arguments.adapter.clone();
        let options = dzhanibekov::app::WindowOptions { size, adapter, slides, encode_png };
        dzhanibekov::app::run(scene, options).map_err(|error| Failure::could(error.to_string()))
    }
    #[cfg(not(feature = "window"))]
    {
        arguments.scene.scene(Some(&arguments.view), arguments.quiet)?;
        let _ = (&arguments.size, &arguments.adapter);
        Err(Failure::not_built("the window", "window"))
    }
}
