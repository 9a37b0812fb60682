//! `record`: moving pictures, as numbered files, a film, or a stream.

mod ffmpeg;
mod pattern;

use std::io::{self, BufWriter, Write};
use std::num::NonZeroU32;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use clap::Args;
use dzhanibekov::headless::{Apng, FrameRate, Gif, HeadlessError, Movie, MovieError, Recording, Studio, Y4m, record};
use dzhanibekov::objects::{Cameras, build_frame};
use dzhanibekov::render::png::{encode, is_whole};
use dzhanibekov::render::{Gpu, Pixels};
use dzhanibekov::scene::Scene;
use dzhanibekov::sim::Simulation;
use indicatif::{ProgressBar, ProgressStyle};

use super::arguments::PictureArguments;
use super::failure::{Failure, say};
use super::output::{WholeFile, check_place, io_failure};
use super::picture::{notes, open, options, picture_scene};
use super::quiet_driver::keep_quiet;
use super::signal;
use ffmpeg::Ffmpeg;
use pattern::Pattern;

/// Pictures looked at for a palette, and their largest width.
const SAMPLES: u64 = 8;
const SAMPLE_WIDTH: u32 = 640;

/// Flags of `record`.
#[derive(Args, Debug)]
pub(super) struct RecordArguments {
    #[command(flatten)]
    picture: PictureArguments,
    /// frame-{:05}.png (numbered), FILE.gif, FILE.apng, FILE.mp4 (through ffmpeg), or - for YUV4MPEG2 on standard output
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    /// Frames a second, whole, decimal or a ratio such as 30000/1001
    #[arg(long, default_value = "60", allow_hyphen_values = true, value_parser = frame_rate)]
    fps: FrameRate,
    /// Length (s)
    #[arg(long, value_name = "S", default_value = "10", allow_hyphen_values = true)]
    duration: f64,
    /// Only frames A to B − 1 of the recording, for several machines
    #[arg(long, value_name = "A..B", value_parser = frame_range, allow_hyphen_values = true)]
    frames: Option<Range<u64>>,
    /// Leave numbered frames alone that are already whole on disk
    #[arg(long)]
    keep: bool,
    /// Known only to be refused in words of its own.
    #[arg(long, hide = true)]
    panel: bool,
}

/// What is written.
enum Format {
    Numbered(Pattern),
    Gif,
    Apng,
    Mp4,
    Stream,
}

impl From<MovieError> for Failure {
    fn from(error: MovieError) -> Self {
        Self::could(format!("the recording could not be written: {error}"))
    }
}

pub(super) fn run(arguments: &RecordArguments) -> Result<(), Failure> {
    keep_quiet();
    let picture = &arguments.picture;
    if arguments.panel {
        return Err(Failure::request(
            "--panel goes with shot alone: a recording shows the picture, and `dzhanibekov shot --panel --time T` the panel at a time",
        ));
    }
    let (scene, words) = picture_scene(picture)?;
    let format = format_of(arguments)?;
    let frames = frames_of(arguments)?;
    check_place(&arguments.output)?;
    let recording = Recording { shot: options(picture), start: picture.time, rate: arguments.fps, frames };
    let stop = signal::raise_flag()?;
    let gpu = open(picture)?;
    let count = recording.frames.end - recording.frames.start;
    let bar = progress_bar(count, picture.quiet);
    let begun = Instant::now();

    let is_finished = match &format {
        Format::Numbered(pattern) => {
            let notes_of = |index| notes(picture, &words, recording.time(index));
            let skip = |index| {
                let is_kept = arguments.keep
                    && std::fs::read(pattern.path(index))
                        .is_ok_and(|bytes| is_whole(&bytes, picture.size, &notes_of(index)));
                bar.inc(u64::from(is_kept));
                is_kept
            };
            record(&gpu, &scene, &recording, &stop, skip, |index, pixels| {
                let bytes = encode(&pixels, picture.transparent, &notes_of(index)).map_err(HeadlessError::from)?;
                let path = pattern.path(index);
                let mut file = WholeFile::create(&path)?;
                file.writer().write_all(&bytes).map_err(|error| io_failure(&path, &error))?;
                file.keep()?;
                bar.inc(1);
                Ok::<(), Failure>(())
            })?
        }
        Format::Stream => {
            let movie = Y4m::new(BufWriter::new(io::stdout()), picture.size, arguments.fps)?;
            film(&gpu, &scene, &recording, &stop, &bar, Box::new(movie))?
        }
        Format::Gif | Format::Apng | Format::Mp4 => {
            let file = WholeFile::create(&arguments.output)?;
            let writer = || {
                let handle = file.reopen().map_err(|error| io_failure(&arguments.output, &error))?;
                Ok::<_, Failure>(BufWriter::new(handle))
            };
            let (size, rate) = (picture.size, arguments.fps);
            let movie: Box<dyn Movie> = match format {
                Format::Gif => Box::new(Gif::new(writer()?, size, rate, &samples(&gpu, &scene, &recording)?)?),
                Format::Apng => Box::new(Apng::new(writer()?, size, rate, count, picture.transparent)?),
                _ => Box::new(Ffmpeg::new(file.beside(), size, rate)?),
            };
            let is_finished = film(&gpu, &scene, &recording, &stop, &bar, movie)?;
            if is_finished {
                file.keep()?;
            }
            is_finished
        }
    };
    bar.finish_and_clear();
    if !is_finished {
        let left =
            if matches!(format, Format::Numbered(_)) { "the frames there are whole" } else { "no file was left" };
        return Err(Failure::could(format!("stopped by a signal after {} of {count} frames; {left}", bar.position())));
    }
    if !picture.quiet {
        let seconds = begun.elapsed().as_secs_f64();
        let speed = count as f64 / seconds.max(1e-9);
        say(&format!("{count} frames in {seconds:.1} s, {speed:.0} a second: {}", arguments.output.display()));
    }
    Ok(())
}

/// Draws every frame into a film; `false` where it was stopped.
fn film(
    gpu: &Gpu,
    scene: &Scene,
    recording: &Recording,
    stop: &AtomicBool,
    bar: &ProgressBar,
    mut movie: Box<dyn Movie>,
) -> Result<bool, Failure> {
    let is_finished = record(
        gpu,
        scene,
        recording,
        stop,
        |_| false,
        |_, pixels| {
            movie.frame(&pixels)?;
            bar.inc(1);
            Ok::<(), Failure>(())
        },
    )?;
    if is_finished {
        movie.finish()?;
    }
    Ok(is_finished)
}

/// Small pictures from all over the recording, for a palette.
fn samples(gpu: &Gpu, scene: &Scene, recording: &Recording) -> Result<Vec<Pixels>, Failure> {
    let [width, height] = recording.shot.size;
    let size =
        if width > SAMPLE_WIDTH { [SAMPLE_WIDTH, (height * SAMPLE_WIDTH).div_ceil(width)] } else { [width, height] };
    let mut studio = Studio::new(gpu, size)?;
    let cameras = Cameras::new(&scene.view);
    let mut simulation = Simulation::new(scene);
    let Range { start, end } = recording.frames;
    let wanted = (end - start).min(SAMPLES);
    (0..wanted)
        .map(|sample| {
            simulation.go_to(recording.time(start + sample * (end - start) / wanted));
            let frame = build_frame(&simulation, &scene.view, &cameras, studio.aspect());
            Ok(studio.draw(&frame)?)
        })
        .collect()
}

fn format_of(arguments: &RecordArguments) -> Result<Format, Failure> {
    let output = &arguments.output;
    let name = output.display();
    let extension = output.extension().and_then(|extension| extension.to_str()).map(str::to_lowercase);
    let format = match extension.as_deref() {
        _ if output == Path::new("-") => Format::Stream,
        Some("png") => Format::Numbered(Pattern::parse(output)?),
        Some("gif") => Format::Gif,
        Some("apng") => Format::Apng,
        Some("mp4") => Format::Mp4,
        _ => {
            return Err(Failure::request(format!(
                "{name} names no format: give frame-{{:05}}.png, a name ending in .gif, .apng or .mp4, or - for a stream"
            )));
        }
    };
    if arguments.picture.transparent && !matches!(format, Format::Numbered(_) | Format::Apng) {
        return Err(Failure::request(format!("{name} cannot hold transparency: numbered .png and .apng can")));
    }
    if arguments.keep && !matches!(format, Format::Numbered(_)) {
        return Err(Failure::request(format!("--keep goes with numbered frames, and {name} is one file")));
    }
    let [width, height] = arguments.picture.size;
    if matches!(format, Format::Mp4) && (width % 2 == 1 || height % 2 == 1) {
        return Err(Failure::request(format!(
            "--size {width}x{height} does not go with {name}: both sides must be even"
        )));
    }
    if matches!(format, Format::Gif) && arguments.fps.per_second() > 50.0 && !arguments.picture.quiet {
        say("many programs slow down a GIF of more than 50 frames a second: --fps 50 plays right everywhere");
    }
    Ok(format)
}

fn frames_of(arguments: &RecordArguments) -> Result<Range<u64>, Failure> {
    let duration = arguments.duration;
    if !(duration.is_finite() && duration > 0.0) {
        return Err(Failure::request(format!("--duration {duration:?} is not valid: it must be finite and above 0")));
    }
    let count = (duration * arguments.fps.per_second()).round();
    if !(1.0..=1e9).contains(&count) {
        return Err(Failure::request(format!(
            "--duration {duration:?} makes {count} frames: between 1 and 1e9 are wanted"
        )));
    }
    let all = 0..count as u64;
    match &arguments.frames {
        None => Ok(all),
        Some(part) if part.start < part.end && part.end <= all.end => Ok(part.clone()),
        Some(part) => Err(Failure::request(format!(
            "--frames {}..{} is not valid: the recording's frames are 0..{}",
            part.start, part.end, all.end
        ))),
    }
}

/// Whole, decimal, or a ratio.
fn frame_rate(text: &str) -> Result<FrameRate, String> {
    const WANTED: &str = "a rate is a number above 0 such as 60, 29.97 or 30000/1001";
    let rate = |frames: u32, seconds: u32| match (NonZeroU32::new(frames), NonZeroU32::new(seconds)) {
        (Some(frames), Some(seconds)) => Ok(FrameRate { frames, seconds }),
        _ => Err(WANTED.to_owned()),
    };
    let whole = |text: &str| text.parse::<u32>().map_err(|_| WANTED.to_owned());
    if let Some((frames, seconds)) = text.split_once('/') {
        return rate(whole(frames)?, whole(seconds)?);
    }
    let (before, after) = text.split_once('.').unwrap_or((text, ""));
    if after.len() > 3 {
        return Err("a rate has at most three decimals; a ratio such as 30000/1001 is exact".to_owned());
    }
    let scale = 10_u32.pow(after.len() as u32);
    let fraction = if after.is_empty() { 0 } else { whole(after)? };
    let frames = whole(before)?.checked_mul(scale).and_then(|frames| frames.checked_add(fraction));
    rate(frames.ok_or(WANTED)?, scale)
}

/// `A..B`, the end left out.
fn frame_range(text: &str) -> Result<Range<u64>, String> {
    let wanted = "a range is two whole numbers such as 0..100, the first frame and the one behind the last";
    let (start, end) = text.split_once("..").ok_or(wanted)?;
    match (start.parse(), end.parse()) {
        (Ok(start), Ok(end)) => Ok(start..end),
        _ => Err(wanted.to_owned()),
    }
}

/// A bar on a terminal, nothing elsewhere.
fn progress_bar(count: u64, is_quiet: bool) -> ProgressBar {
    if is_quiet {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new(count);
    if let Ok(style) = ProgressStyle::with_template("{bar:40} {pos}/{len} frames, {per_sec}, {eta} left") {
        bar.set_style(style);
    }
    bar
}
