//! `handout`: a scene's steps as pages.

use std::path::{Path, PathBuf};

use clap::Args;
use dzhanibekov::files;
use dzhanibekov::frame::Frame;
use dzhanibekov::headless::{ShotOptions, page, page_as_png, page_as_svg, page_size, pages_as_pdf};
use dzhanibekov::objects::{page_time, pages};
use dzhanibekov::render::png::Remark;
use dzhanibekov::scene::one_number;

use super::arguments::SceneArguments;
use super::failure::Failure;
use super::flags::ViewFlags;
use super::output::{check_place, ending};
use super::picture::{followed, open_for};
use super::quiet_driver::keep_quiet;
use super::signal;
use super::times::{check_steps, short};

/// Flags of `handout`.
#[derive(Args, Debug)]
pub(super) struct HandoutArguments {
    #[command(flatten)]
    scene: SceneArguments,
    #[command(flatten)]
    view: ViewFlags,
    /// File to write: one PDF, or a PNG or an SVG a page, numbered where there is more than one
    #[arg(short, long, value_name = "FILE.pdf|.png|.svg")]
    output: PathBuf,
    /// Simulated time shown (s) where a step says none; just before the first flip where left out
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = one_number, help_heading = "Picture")]
    time: Option<f64>,
    /// With the answer below the question
    #[arg(long, help_heading = "Picture")]
    answer: bool,
    /// Name (or a part of it) of the graphics adapter to draw with
    #[arg(long, value_name = "NAME", help_heading = "Picture")]
    adapter: Option<String>,
    /// Say nothing but errors
    #[arg(long)]
    quiet: bool,
}

/// What the pages are written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Pdf,
    Png,
    Svg,
}

/// `handout`: everything that can be refused is refused before anything is drawn.
pub(super) fn run(arguments: &HandoutArguments) -> Result<(), Failure> {
    keep_quiet();
    signal::end_at_once()?;
    let format = format_of(&arguments.output)?;
    let scene = arguments.scene.scene(Some(&arguments.view), arguments.quiet)?;
    let scenes = pages(&scene.file).map_err(|error| Failure::request(error.to_string()))?;
    let mut frames = vec![];
    for scene in &scenes {
        let own = scene.file.pace_at(scene.at).time;
        let time = own.or(arguments.time).unwrap_or_else(|| page_time(scene));
        if !time.is_finite() {
            return Err(Failure::request(format!("--time {time} is not finite")));
        }
        check_steps(scene, &format!("--time {}", short(time)), time, followed(scene))?;
        frames.push(page(scene, time, arguments.answer)?);
    }
    let places = places(&arguments.output, if format == Format::Pdf { 1 } else { frames.len() });
    for place in &places {
        check_place(place)?;
    }
    let title = scene.file.title.trim().to_owned();
    let remarks: [Remark; 2] =
        [("Software", concat!("dzhanibekov ", env!("CARGO_PKG_VERSION")).to_owned()), ("Title", title)];
    let options = ShotOptions { size: page_size(), transparent: false, adapter: arguments.adapter.clone() };
    let gpu = open_for(&options, arguments.quiet)?;
    if let (Format::Pdf, Some(place)) = (format, places.first()) {
        return Ok(files::write(place, &pages_as_pdf(&gpu, &frames, &remarks)?)?);
    }
    let draw = |frame: &Frame| match format {
        Format::Svg => page_as_svg(&gpu, frame, &remarks),
        _ => page_as_png(&gpu, frame, &remarks),
    };
    for (frame, place) in frames.iter().zip(&places) {
        files::write(place, &draw(frame)?)?;
    }
    Ok(())
}

/// What a name asks for.
fn format_of(output: &Path) -> Result<Format, Failure> {
    match ending(output).as_deref() {
        Some("pdf") => Ok(Format::Pdf),
        Some("png") => Ok(Format::Png),
        Some("svg") => Ok(Format::Svg),
        _ => Err(Failure::request(format!(
            "{} names no format of a handout: give a name ending in .pdf for one file, or in .png or .svg for one a page",
            output.display()
        ))),
    }
}

/// The files of so many pages: that which is named, or numbered ones beside it.
fn places(output: &Path, count: usize) -> Vec<PathBuf> {
    if count == 1 {
        return vec![output.to_owned()];
    }
    let part = |part: Option<&std::ffi::OsStr>| part.unwrap_or_default().to_string_lossy().into_owned();
    let (stem, ending) = (part(output.file_stem()), part(output.extension()));
    (1..=count).map(|number| output.with_file_name(format!("{stem}-{number}.{ending}"))).collect()
}

#[cfg(test)]
mod tests {
    use std::path::{Path, PathBuf};

    use super::places;

    #[test]
    fn pages_are_numbered_where_there_is_more_than_one() {
        assert_eq!(places(Path::new("talk/flip.png"), 1), [PathBuf::from("talk/flip.png")]);
        let two = [PathBuf::from("talk/flip-1.png"), PathBuf::from("talk/flip-2.png")];
        assert_eq!(places(Path::new("talk/flip.png"), 2), two);
    }
}
