//! `record`: moving pictures, as numbered files, a film, or a stream.

mod ffmpeg;
mod film;
mod pattern;
mod rate;

use std::cell::Cell;
use std::io::BufWriter;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Args;
use dzhanibekov::files::{self, Output, Sink};
use dzhanibekov::headless::{
    Apng, FrameRate, Gif, HeadlessError, Movie, MovieError, PictureSize, Recording, ShotOptions, Studio, Y4m, record,
};
use dzhanibekov::objects::Cameras;
use dzhanibekov::render::png::{Remark, encode_marked, is_whole};
use dzhanibekov::render::{Gpu, Pixels};
use dzhanibekov::scene::{Scene, one_number};
use dzhanibekov::sim::Simulation;
use indicatif::{ProgressBar, ProgressStyle};

use super::arguments::PictureArguments;
use super::failure::{Failure, say};
use super::output::{check_place, ending, io_failure};
use super::page::{Beginning, is_page, page};
use super::picture::{followed, notes, open, options, picture_scene};
use super::quiet_driver::keep_quiet;
use super::signal;
use super::times::{check_steps, rough, short};
use ffmpeg::{Encoder, Ffmpeg};
use film::{CONTAINERS, Container, list};
use pattern::Pattern;
use rate::frame_rate;

/// Pictures looked at for a palette, and their largest width.
const SAMPLES: u64 = 8;
const SAMPLE_WIDTH: u32 = 640;

/// Flags of `record`.
#[derive(Args, Debug)]
pub(super) struct RecordArguments {
    #[command(flatten)]
    picture: PictureArguments,
    /// frame-{:05}.png (numbered), FILE.gif, FILE.apng, through ffmpeg FILE.mp4, .webm, .mov or .mkv, FILE.html (a page that plays
    /// without end), or - for YUV4MPEG2 on standard output
    #[arg(short, long, value_name = "OUT")]
    output: PathBuf,
    /// Frames a second, whole, decimal or a ratio such as 30000/1001
    #[arg(long, default_value = "60", allow_hyphen_values = true, value_parser = frame_rate)]
    fps: FrameRate,
    /// Length (s)
    #[arg(long, value_name = "S", default_value = "10", allow_hyphen_values = true, value_parser = one_number)]
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
    Film(Encoder),
    Stream,
}

/// What a film that failed is told by.
fn movie_failure(output: &Path, error: MovieError) -> Failure {
    match error {
        MovieError::Io(error) => io_failure(output, error),
        MovieError::Format(reason) => Failure::could_not(format!("the recording could not be written: {reason}")),
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
    if is_page(&arguments.output) {
        let flags = [("--frames", arguments.frames.is_some()), ("--keep", arguments.keep)];
        return page(picture, &arguments.output, Beginning { plays: true, has_panel: false }, &flags);
    }
    let (scene, words) = picture_scene(picture)?;
    let format = format_of(arguments)?;
    let frames = frames_of(arguments)?;
    check_place(&arguments.output)?;
    let end = picture.time(&scene) + arguments.fps.time(frames.end);
    check_steps(&scene, &format!("the last frame, at {} s,", short(end)), end, followed(&scene))?;
    let recording = Recording { shot: options(picture), start: picture.time(&scene), rate: arguments.fps, frames };
    // A pipe is opened once someone reads it; until then, and only until then, a signal ends the program at once.
    signal::end_at_once()?;
    let output = match &format {
        Format::Numbered(_) => None,
        Format::Film(_) => Some(Output::create_for_program(&arguments.output)?),
        Format::Gif | Format::Apng | Format::Stream => Some(Output::create(&arguments.output)?),
    };
    let stop = signal::raise_flag();
    let gpu = open(picture)?;
    // Once nothing is left to be refused.
    if matches!(format, Format::Gif) && arguments.fps.per_second() > 50.0 && !picture.quiet {
        say("many programs slow down a GIF of more than 50 frames a second: --fps 50 plays right everywhere");
    }
    let count = recording.frames.end - recording.frames.start;
    let bar = progress_bar(count, picture.quiet);
    let begun = Instant::now();
    // Frames that were whole already.
    let kept = Cell::new(0);

    let is_finished = match (&format, output) {
        (Format::Numbered(pattern), _) => {
            let PictureSize { pixels: size, .. } = recording.shot.size;
            let mark = recording.shot.size.pixels_per_metre();
            let notes_of = |index| notes(picture, &scene, &words, recording.time(index));
            let skip = |index| {
                let is_kept = arguments.keep
                    && std::fs::read(pattern.path(index))
                        .is_ok_and(|bytes| is_whole(&bytes, size, &notes_of(index), mark));
                bar.inc(u64::from(is_kept));
                kept.set(kept.get() + u64::from(is_kept));
                is_kept
            };
            record(&gpu, &scene, &recording, stop, skip, |index, pixels| {
                let bytes =
                    encode_marked(pixels, picture.transparent, &notes_of(index), mark).map_err(HeadlessError::from)?;
                files::write(&pattern.path(index), &bytes)?;
                bar.inc(1);
                Ok::<(), Failure>(())
            })?
        }
        (_, Some(output)) => {
            let fail = |error| movie_failure(&arguments.output, error);
            let notes = notes(picture, &scene, &words, recording.time(recording.frames.start));
            let movie = movie(&format, &output, &gpu, &scene, &recording, &notes)?;
            let mut movie = movie.map_err(fail)?;
            let is_finished = record(
                &gpu,
                &scene,
                &recording,
                stop,
                |_| false,
                |_, pixels| {
                    movie.frame(pixels).map_err(fail)?;
                    bar.inc(1);
                    Ok::<(), Failure>(())
                },
            )?;
            if is_finished {
                movie.finish().map_err(fail)?;
                output.keep()?;
            }
            is_finished
        }
        // Every film has its output.
        (_, None) => false,
    };
    // Taken down, a bar is at its end.
    let written = bar.position();
    bar.finish_and_clear();
    if !is_finished {
        let left =
            if matches!(format, Format::Numbered(_)) { "the frames there are whole" } else { "no file was left" };
        return Err(Failure::could_not(format!("stopped by a signal after {written} of {count} frames; {left}")));
    }
    if !picture.quiet {
        let seconds = begun.elapsed().as_secs_f64();
        say(&format!("{}: {}", told(count, kept.get(), seconds), arguments.output.display()));
    }
    Ok(())
}

/// What is said of so many frames, of which so many were there before, after so long (s).
fn told(count: u64, kept: u64, seconds: f64) -> String {
    let frames = |count: u64| if count == 1 { "1 frame".to_owned() } else { format!("{count} frames") };
    let drawn = count.saturating_sub(kept);
    let speed = drawn as f64 / seconds.max(1e-9);
    match (drawn, kept) {
        (0, _) => format!("{} kept, none drawn", frames(kept)),
        (_, 0) => format!("{} in {seconds:.1} s, {speed:.0} a second", frames(drawn)),
        _ => format!("{} in {seconds:.1} s, {speed:.0} a second, and {kept} kept", frames(drawn)),
    }
}

/// Begins a film.
fn movie(
    format: &Format,
    output: &Output,
    gpu: &Gpu,
    scene: &Scene,
    recording: &Recording,
    notes: &[Remark],
) -> Result<Result<Box<dyn Movie>, MovieError>, Failure> {
    let Recording { shot, rate, frames, .. } = recording;
    let (size, rate) = (shot.size.pixels, *rate);
    let writer = || output.handle().map(BufWriter::new);
    Ok(match format {
        Format::Gif => Gif::new(writer()?, size, rate, &samples(gpu, scene, recording)?).map(boxed),
        Format::Apng => Apng::new(writer()?, size, rate, frames.end - frames.start, shot.transparent, notes).map(boxed),
        Format::Film(encoder) => {
            Ok(boxed(Ffmpeg::new(output.beside().unwrap_or(Path::new("-")), size, rate, *encoder)?))
        }
        Format::Stream | Format::Numbered(_) => Y4m::new(writer()?, size, rate).map(boxed),
    })
}

/// A film of any format.
fn boxed<M: Movie + 'static>(movie: M) -> Box<dyn Movie> {
    Box::new(movie)
}

/// Small pictures from all over the recording, for a palette.
fn samples(gpu: &Gpu, scene: &Scene, recording: &Recording) -> Result<Vec<Pixels>, Failure> {
    let [width, height] = recording.shot.size.pixels;
    let size =
        if width > SAMPLE_WIDTH { [SAMPLE_WIDTH, (height * SAMPLE_WIDTH).div_ceil(width)] } else { [width, height] };
    let small = ShotOptions { size: PictureSize::in_pixels(size), ..recording.shot.clone() };
    let mut studio = Studio::new(gpu, size)?;
    let cameras = Cameras::new(&scene.view);
    let mut simulation = Simulation::new(scene);
    let Range { start, end } = recording.frames;
    let wanted = (end - start).min(SAMPLES);
    (0..wanted)
        .map(|sample| {
            simulation.go_to(recording.time(start + sample * (end - start) / wanted));
            Ok(studio.draw(&small.frame(scene, &simulation, &cameras))?)
        })
        .collect()
}

fn format_of(arguments: &RecordArguments) -> Result<Format, Failure> {
    let output = &arguments.output;
    let name = output.display();
    let format = match ending(output).as_deref() {
        _ if output == Path::new("-") => Format::Stream,
        Some("png") => Format::Numbered(Pattern::parse(output)?),
        Some("gif") => Format::Gif,
        Some("apng") => Format::Apng,
        Some(ending) if Container::of(ending).is_some() => return film(arguments, ending),
        _ if files::takes_streams(output) => Format::Stream,
        _ => {
            return Err(Failure::request(format!(
                "{name} names no format: give frame-{{:05}}.png, a name ending in {}, or - for a stream",
                list(&endings(&["gif", "apng", "html"]), "or")
            )));
        }
    };
    if arguments.picture.transparent && !matches!(format, Format::Numbered(_) | Format::Apng) {
        return Err(clear_refused(output));
    }
    if arguments.keep && !matches!(format, Format::Numbered(_)) {
        return Err(keep_refused(output));
    }
    if arguments.keep && arguments.picture.no_metadata {
        return Err(Failure::request("--keep tells frames by what they say of themselves: leave out --no-metadata"));
    }
    let checked = match format {
        Format::Gif => Gif::<Sink>::check(arguments.picture.size.get().pixels, arguments.fps),
        Format::Apng => Apng::<Sink>::check(arguments.fps, 1),
        _ => Ok(()),
    };
    if let Err(error) = checked {
        return Err(Failure::request(format!("--fps does not go with {name}: {error}")));
    }
    Ok(format)
}

/// A film of this ending; what ffmpeg lacks is refused before anything is drawn.
fn film(arguments: &RecordArguments, ending: &str) -> Result<Format, Failure> {
    let (output, is_transparent) = (&arguments.output, arguments.picture.transparent);
    let container = Container::of(ending).unwrap_or(Container::Mp4);
    let codec = container.codec(is_transparent).ok_or_else(|| clear_refused(output))?;
    if arguments.keep {
        return Err(keep_refused(output));
    }
    let [width, height] = arguments.picture.size.get().pixels;
    if codec.is_even && (width % 2 == 1 || height % 2 == 1) {
        return Err(Failure::request(format!(
            "{width}x{height} pixels do not go with {}: both sides must be even",
            output.display()
        )));
    }
    Ok(Format::Film(Encoder::find(container, codec, is_transparent)?))
}

/// These endings, then those of the films.
fn endings(first: &[&'static str]) -> Vec<&'static str> {
    first.iter().copied().chain(CONTAINERS.iter().map(|container| container.ending())).collect()
}

/// What is said where a format has no transparency.
fn clear_refused(output: &Path) -> Failure {
    let can = CONTAINERS.iter().filter(|container| container.codec(true).is_some()).map(|container| container.ending());
    let can: Vec<&str> = std::iter::once("apng").chain(can).collect();
    Failure::request(format!("{} cannot hold transparency: numbered .png, {} can", output.display(), list(&can, "and")))
}

/// What is said where `--keep` has nothing to keep.
fn keep_refused(output: &Path) -> Failure {
    Failure::request(format!("--keep goes with numbered frames, and {} is one file", output.display()))
}

fn frames_of(arguments: &RecordArguments) -> Result<Range<u64>, Failure> {
    let duration = arguments.duration;
    if !(duration.is_finite() && duration > 0.0) {
        return Err(Failure::request(format!(
            "--duration {} is not valid: it must be finite and above 0",
            short(duration)
        )));
    }
    let count = (duration * arguments.fps.per_second()).round();
    if !(1.0..=1e9).contains(&count) {
        return Err(Failure::request(format!(
            "--duration {} makes {} frames: between 1 and 1e9 are wanted",
            short(duration),
            rough(count)
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

#[cfg(test)]
mod tests {
    use super::told;

    #[test]
    fn frames_that_were_there_are_not_drawn() {
        assert_eq!(told(12, 0, 0.6), "12 frames in 0.6 s, 20 a second");
        assert_eq!(told(1, 0, 0.5), "1 frame in 0.5 s, 2 a second");
        assert_eq!(told(12, 10, 1.0), "2 frames in 1.0 s, 2 a second, and 10 kept");
        assert_eq!(
            (&*told(12, 12, 0.1), &*told(1, 1, 0.1)),
            ("12 frames kept, none drawn", "1 frame kept, none drawn")
        );
    }
}
