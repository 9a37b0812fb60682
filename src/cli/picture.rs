//! `shot` and `adapters`: pictures with no window.

use std::path::{Path, PathBuf};

use clap::Args;
use dzhanibekov::headless::{HeadlessError, ShotOptions, shot as draw};
use dzhanibekov::objects::{OBJECTS, object_named};
use dzhanibekov::render::png::Remark;
use dzhanibekov::render::{self, Gpu};
use dzhanibekov::scene::{Scene, nearest, quoted};
use dzhanibekov::sim::Simulation;
use serde_json::json;

use super::arguments::PictureArguments;
use super::failure::{Failure, say};
use super::lists::{ListArguments, print, table};
use super::output::{check_place, io_failure, write_whole};
use super::quiet_driver::keep_quiet;
use super::signal;

impl From<HeadlessError> for Failure {
    fn from(error: HeadlessError) -> Self {
        if error.is_bad_request() { Self::request(error.to_string()) } else { Self::could(error.to_string()) }
    }
}

/// Flags of `shot`.
#[derive(Args, Debug)]
pub(super) struct ShotArguments {
    #[command(flatten)]
    picture: PictureArguments,
    /// File to write, or - for standard output
    #[arg(short, long, value_name = "FILE.png|-")]
    output: PathBuf,
    /// With the window's panel in the picture
    #[cfg(feature = "window")]
    #[arg(long, help_heading = "Picture", conflicts_with = "transparent")]
    panel: bool,
}

/// `shot`: everything that can be refused is refused before anything is drawn.
pub(super) fn shot(arguments: &ShotArguments) -> Result<(), Failure> {
    keep_quiet();
    signal::end_at_once()?;
    let picture = &arguments.picture;
    let (scene, words) = picture_scene(picture)?;
    check_place(&arguments.output)?;
    let mut simulation = Simulation::new(&scene);
    if picture.time != 0.0 {
        simulation.go_to(picture.time);
    }
    if let Some(error) = simulation.main().failure() {
        return Err(Failure::could(error.to_string()));
    }
    let gpu = open(picture)?;
    #[cfg(feature = "window")]
    if arguments.panel {
        let options = options(picture);
        let mut notes = notes(picture, &words, picture.time);
        if let Some((_, command)) = notes.last_mut() {
            command.push_str(" --panel");
        }
        let pixels = dzhanibekov::app::with_panels(&gpu, scene, picture.time, options.size)
            .map_err(|error| Failure::could(error.to_string()))?;
        let bytes = render::png::encode(&pixels, false, &notes).map_err(HeadlessError::from)?;
        return write_picture(&arguments.output, &bytes);
    }
    let bytes = draw(&gpu, &simulation, &options(picture), &notes(picture, &words, picture.time))?;
    write_picture(&arguments.output, &bytes)
}

fn write_picture(output: &Path, bytes: &[u8]) -> Result<(), Failure> {
    write_whole(output, |writer| writer.write_all(bytes).map_err(|error| io_failure(output, &error)))
}

/// The scene of a picture, checked, and the words of a command line that name it.
pub(super) fn picture_scene(picture: &PictureArguments) -> Result<(Scene, Vec<String>), Failure> {
    let (scene, words) = picture.scene.named_scene(Some(&picture.view), picture.quiet)?;
    check_objects(&scene)?;
    if !picture.time.is_finite() {
        return Err(Failure::request(format!("--time {} is not finite", picture.time)));
    }
    Ok((scene, words))
}

pub(super) fn options(picture: &PictureArguments) -> ShotOptions {
    ShotOptions { size: picture.size, transparent: picture.transparent, adapter: picture.adapter.clone() }
}

/// Opens what the picture is drawn on, and says once what is worth saying of the choice.
pub(super) fn open(picture: &PictureArguments) -> Result<Gpu, Failure> {
    let gpu = options(picture).open()?;
    if let (Some(remark), false) = (gpu.remark(), picture.quiet) {
        say(remark);
    }
    Ok(gpu)
}

/// What a picture's file says of itself: the program, the scene, the time and the command that draws it again.
pub(super) fn notes(picture: &PictureArguments, words: &[String], time: f64) -> Vec<Remark> {
    let mut command = vec!["dzhanibekov".to_owned(), "shot".to_owned()];
    command.extend_from_slice(words);
    command.extend(["--time".to_owned(), time.to_string()]);
    let [width, height] = picture.size;
    command.extend(["--size".to_owned(), format!("{width}x{height}")]);
    if picture.transparent {
        command.push("--transparent".to_owned());
    }
    command.extend(["-o".to_owned(), "picture.png".to_owned()]);
    vec![
        ("Software", concat!("dzhanibekov ", env!("CARGO_PKG_VERSION")).to_owned()),
        ("Title", words.first().cloned().unwrap_or_default()),
        ("Description", format!("t = {time} s")),
        ("Comment", quoted(&command)),
    ]
}

/// Refuses names of objects that do not exist.
pub(super) fn check_objects(scene: &Scene) -> Result<(), Failure> {
    for name in scene.view.show.iter().chain(&scene.view.hide) {
        if object_named(name).is_none() {
            let known = OBJECTS.iter().map(|object| object.name);
            let hint = match nearest(name, known.clone()) {
                Some(near) => format!("the nearest is `{near}`"),
                None => format!("there are {}", known.collect::<Vec<_>>().join(", ")),
            };
            return Err(Failure::request(format!("object `{name}` is not known: {hint}")));
        }
    }
    Ok(())
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
        return Err(Failure::could(render::no_adapter()));
    }
    print(&table(found.iter().map(|adapter| [&*adapter.name, adapter.kind, adapter.backend, &*adapter.driver])))
}
