//! `shot` and `adapters`: pictures with no window.

use std::path::{Path, PathBuf};

use clap::Args;
use dzhanibekov::files;
use dzhanibekov::headless::{FigureFormat, HeadlessError, ShotOptions, figure as draw_figure, shot as draw};
use dzhanibekov::physics::Method;
use dzhanibekov::render::png::Remark;
use dzhanibekov::render::{self, Gpu};
use dzhanibekov::scene::carried::{self, Saying};
use dzhanibekov::scene::{Scene, quoted};
use dzhanibekov::sim::Simulation;
use dzhanibekov::vector::Shading;
use serde_json::json;

use super::arguments::{Metadata, PictureArguments, count, number_list};
use super::failure::{Failure, say};
use super::figure::FigureArguments;
use super::lists::{ListArguments, print, table};
use super::output::{check_place, ending};
use super::page::{Beginning, is_page, page};
use super::quiet_driver::keep_quiet;
use super::sheet::sheet;
use super::signal;
use super::times::{check_steps, short};

impl From<HeadlessError> for Failure {
    fn from(error: HeadlessError) -> Self {
        if error.is_bad_request() { Self::request(error.to_string()) } else { Self::could_not(error.to_string()) }
    }
}

/// Flags of `shot`.
#[derive(Args, Debug)]
pub(super) struct ShotArguments {
    #[command(flatten)]
    pub(super) picture: PictureArguments,
    /// File to write, a picture or a page that stands at the time, or - for standard output
    #[arg(short, long, value_name = "FILE.png|.svg|.pdf|.html|-")]
    pub(super) output: PathBuf,
    #[command(flatten)]
    pub(super) figure: FigureArguments,
    /// A sheet of the pictures at these times (s), each of --size; with --width or --height the sheet has that
    #[arg(long, value_name = "T,T,…", allow_hyphen_values = true, value_parser = times, conflicts_with = "time", help_heading = "Picture")]
    times: Option<Moments>,
    /// Pictures in a row of the sheet
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = count, requires = "times", help_heading = "Picture")]
    pub(super) columns: Option<usize>,
    /// With the window's panel in the picture
    #[cfg(feature = "window")]
    #[arg(long, help_heading = "Picture", conflicts_with_all = ["transparent", "width", "height", "times"])]
    panel: bool,
    /// As the window is in presenter's mode: large words, a slim strip and no panel
    #[cfg(feature = "window")]
    #[arg(long, help_heading = "Picture", conflicts_with_all = ["panel", "transparent", "width", "height", "times"])]
    presenter: bool,
}

/// Times of a sheet.
#[derive(Clone, Debug)]
struct Moments(Vec<f64>);

/// Reads them.
fn times(text: &str) -> Result<Moments, String> {
    number_list(text).map(Moments)
}

/// `shot`: everything that can be refused is refused before anything is drawn.
pub(super) fn shot(arguments: &ShotArguments) -> Result<(), Failure> {
    keep_quiet();
    signal::end_at_once()?;
    let picture = &arguments.picture;
    if is_page(&arguments.output) {
        #[cfg(feature = "window")]
        let (has_panel, presenter) = (arguments.panel, arguments.presenter);
        #[cfg(not(feature = "window"))]
        let (has_panel, presenter) = (false, false);
        let beginning = Beginning { plays: false, has_panel };
        arguments.figure.check(None, &arguments.output)?;
        return page(
            picture,
            &arguments.output,
            beginning,
            &[("--times", arguments.times.is_some()), ("--presenter", presenter)],
        );
    }
    let (scene, words) = picture_scene(picture)?;
    let time = picture.time(&scene);
    check_place(&arguments.output)?;
    let format = format(&arguments.output)?;
    arguments.figure.check(format, &arguments.output)?;
    if arguments.figure.style().shading == Shading::Flat && picture.adapter.is_some() {
        return Err(Failure::request("--adapter chooses what draws pixels, and with --surfaces flat there are none"));
    }
    #[cfg(feature = "window")]
    if (arguments.panel || arguments.presenter) && format.is_some() {
        let output = arguments.output.display();
        let flag = if arguments.presenter { "--presenter" } else { "--panel" };
        return Err(Failure::request(format!(
            "{flag} is drawn in pixels: give a name ending in .png instead of {output}"
        )));
    }
    if let Some(Moments(times)) = &arguments.times {
        return sheet(arguments, times, format, &scene, &words);
    }
    let mut simulation = Simulation::new(&scene);
    if time != 0.0 {
        simulation.go_to(time);
    }
    if let Some(error) = simulation.main().failure() {
        return Err(Failure::could_not(error.to_string()));
    }
    #[cfg(feature = "window")]
    if arguments.panel || arguments.presenter {
        let (gpu, options) = (open(picture)?, options(picture));
        let flag = if arguments.presenter { "--presenter" } else { "--panel" };
        let words = [words, vec![flag.to_owned()]].concat();
        let notes = notes(picture, &scene, &words, time);
        let pixels = dzhanibekov::stage::with_panels(&gpu, scene, time, options.size.pixels, arguments.presenter)
            .map_err(|error| Failure::could_not(error.to_string()))?;
        let bytes = render::png::encode_marked(&pixels, false, &notes, options.size.pixels_per_metre())
            .map_err(HeadlessError::from)?;
        return Ok(files::write(&arguments.output, &bytes)?);
    }
    let (options, mut notes) = (options(picture), notes(picture, &scene, &words, time));
    let bytes = match format {
        None => draw(&open(picture)?, &scene, &simulation, &options, &notes)?,
        Some(format) => {
            arguments.figure.mark(format, &mut notes);
            let style = arguments.figure.style();
            draw_figure(|| open(picture), &scene, &simulation, &options, (style, format), &notes)?
        }
    };
    Ok(files::write(&arguments.output, &bytes)?)
}

/// The format of a figure that a name says; none for a PNG. A name that says another format, or none, is refused. Where a
/// stream goes has a name of its own.
fn format(output: &Path) -> Result<Option<FigureFormat>, Failure> {
    match ending(output).as_deref() {
        Some("png") => Ok(None),
        Some("svg") => Ok(Some(FigureFormat::Svg)),
        Some("pdf") => Ok(Some(FigureFormat::Pdf)),
        _ if files::takes_streams(output) => Ok(None),
        _ => Err(Failure::request(format!(
            "{} names no format that shot writes: give a name ending in .png, .svg, .pdf or .html, or - for standard output",
            output.display()
        ))),
    }
}

/// The scene of a picture, checked, and the words of a command line that name it.
pub(super) fn picture_scene(picture: &PictureArguments) -> Result<(Scene, Vec<String>), Failure> {
    let (scene, words) = picture.named_scene()?;
    let time = picture.time(&scene);
    if !time.is_finite() {
        return Err(Failure::request(format!("--time {time} is not finite")));
    }
    check_steps(&scene, &format!("--time {}", short(time)), time, followed(&scene))?;
    picture.size.check().map_err(Failure::request)?;
    Ok((scene, words))
}

/// The methods that a picture shows: the body's own and those beside it.
pub(super) fn followed(scene: &Scene) -> impl Iterator<Item = &&'static Method> {
    std::iter::once(&scene.method).chain(&scene.compare)
}

pub(super) fn options(picture: &PictureArguments) -> ShotOptions {
    ShotOptions { size: picture.size.get(), transparent: picture.transparent, adapter: picture.adapter.clone() }
}

/// Opens what the picture is drawn on, and says once what is worth saying of the choice.
pub(super) fn open(picture: &PictureArguments) -> Result<Gpu, Failure> {
    open_for(&options(picture), picture.quiet)
}

/// Likewise, for pictures of these options.
pub(super) fn open_for(options: &ShotOptions, is_quiet: bool) -> Result<Gpu, Failure> {
    let gpu = options.open()?;
    if let (Some(remark), false) = (gpu.remark(), is_quiet) {
        say(remark);
    }
    Ok(gpu)
}

/// What a picture's file says of itself: the program, the scene, the time and the command that draws it again.
pub(super) fn notes(picture: &PictureArguments, scene: &Scene, words: &[String], time: f64) -> Vec<Remark> {
    remarks(picture, scene, words, &["--time".to_owned(), short(time)], time)
}

/// The same where a command line says the moment or the moments in these words, the first of them at a time (s).
pub(super) fn remarks(
    picture: &PictureArguments,
    scene: &Scene,
    words: &[String],
    moment: &[String],
    time: f64,
) -> Vec<Remark> {
    let mut command = vec!["dzhanibekov".to_owned(), "shot".to_owned()];
    command.extend_from_slice(words);
    command.extend_from_slice(moment);
    command.extend(picture.size.words());
    if picture.transparent {
        command.push("--transparent".to_owned());
    }
    if picture.metadata == Some(Metadata::Full) {
        command.extend(["--metadata".to_owned(), "full".to_owned()]);
    }
    command.extend(["-o".to_owned(), "picture.png".to_owned()]);
    let title = Some(scene.file.title.clone()).filter(|title| !title.is_empty());
    let title = title.or_else(|| words.first().cloned()).unwrap_or_default();
    let saying = match picture.metadata {
        _ if picture.no_metadata => Saying::Nothing,
        Some(Metadata::Full) => Saying::Full,
        Some(Metadata::Plain) | None => Saying::Plain,
    };
    carried::remarks(saying, title, &scene.file, scene.at, time, quoted(&command))
}

/// `adapters`: what there is to draw with.
pub(super) fn adapters(arguments: &ListArguments) -> Result<(), Failure> {
    keep_quiet();
    let found = pollster::block_on(render::adapters());
    if arguments.json {
        let list: Vec<_> = found
            .iter()
            .map(|adapter| {
                json!({ "name": adapter.name, "kind": adapter.kind, "backend": adapter.backend, "driver": adapter.driver })
            })
            .collect();
        return print(&format!("{:#}\n", json!(list)));
    }
    if found.is_empty() {
        return Err(Failure::could_not(render::no_adapter()));
    }
    print(&table(found.iter().map(|adapter| [&*adapter.name, adapter.kind, adapter.backend, &*adapter.driver])))
}
