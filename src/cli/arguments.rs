//! Flags that several commands share: what overrides a scene, and what is said of a picture.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use clap::Args;
#[cfg(feature = "headless")]
use clap::ValueEnum;

use dzhanibekov::files;
use dzhanibekov::scene::link::{self, Link};
use dzhanibekov::scene::{DEFAULT_PRESET, Edit, Edits, Scene, SceneError, SceneFile, flags, one_number, preset};

use super::failure::{Failure, say};
use super::flags::{SceneFlags, ViewFlags as ViewArguments};
#[cfg(feature = "headless")]
use super::page::PageArguments;
#[cfg(feature = "headless")]
use super::size::SizeArguments;

/// The scene and what is said over it.
#[derive(Args, Debug)]
pub(super) struct SceneArguments {
    /// Name of a built-in scene, the path of a .toml file or of a picture that the program drew, or a link; for the window also a
    /// folder of files
    #[arg(value_name = "SCENE")]
    scene: Option<PathBuf>,
    #[command(flatten)]
    flags: SceneFlags,
    /// Any key of a scene file (`dzhanibekov keys` lists them), the value as in TOML: spin.attitude=[1,0,0,0]. With no value, as
    /// in spin.rate=, what the scene says under the key is taken away
    #[arg(long, value_name = "KEY=VALUE", value_parser = Edit::set, help_heading = "Scene")]
    set: Vec<Edit>,
    /// What SCENE says, once it is read: a pipe is read once.
    #[arg(skip)]
    said: OnceLock<Result<Link, String>>,
}

/// Everything that is said of a picture in a file, but its name.
#[cfg(feature = "headless")]
#[derive(Args, Debug)]
pub(super) struct PictureArguments {
    #[command(flatten)]
    pub(super) scene: SceneArguments,
    #[command(flatten)]
    pub(super) view: ViewArguments,
    /// Simulated time shown (s), 0 where left out; of a recording, its first frame's
    #[arg(long, value_name = "T", allow_hyphen_values = true, value_parser = one_number, help_heading = "Picture")]
    time: Option<f64>,
    /// Step of the scene, counted from 1; the scene as a whole where left out
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = count, help_heading = "Picture")]
    scene_step: Option<usize>,
    #[command(flatten)]
    pub(super) size: SizeArguments,
    /// No background: transparent where nothing is drawn
    #[arg(long, help_heading = "Picture")]
    pub(super) transparent: bool,
    /// What the file says of itself: `plain`, what draws it again (opened, it is the scene), or `full`, the program's version too
    #[arg(long, value_enum, value_name = "plain|full", hide_possible_values = true, help_heading = "Picture")]
    pub(super) metadata: Option<Metadata>,
    /// Let the file say nothing of itself
    #[arg(long, conflicts_with = "metadata", help_heading = "Picture")]
    pub(super) no_metadata: bool,
    #[command(flatten)]
    pub(super) page: PageArguments,
    /// Name (or a part of it) of the graphics adapter to draw with
    #[arg(long, value_name = "NAME", help_heading = "Picture")]
    pub(super) adapter: Option<String>,
    /// Say nothing but errors
    #[arg(long)]
    pub(super) quiet: bool,
}

/// How much a picture's file says of itself.
#[cfg(feature = "headless")]
#[derive(ValueEnum, Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Metadata {
    /// What draws it again.
    Plain,
    /// The version of the program too.
    Full,
}

/// Flags of `report`.
#[cfg(feature = "report")]
#[derive(Args, Debug)]
pub(super) struct ReportArguments {
    #[command(flatten)]
    pub(super) scene: SceneArguments,
    /// Folder for report.html, report.json, report.csv and the plots; `report` where neither it nor --json is given
    #[arg(short, long, value_name = "DIR")]
    pub(super) output: Option<PathBuf>,
    /// Write the numbers alone to a file, or - for standard output
    #[arg(long, value_name = "FILE|-")]
    pub(super) json: Option<PathBuf>,
    /// Two cases and less of everything, in under twenty seconds
    #[arg(long)]
    pub(super) quick: bool,
    /// Points measured with other programs (JSON), drawn in the same plots
    #[arg(long, value_name = "FILE")]
    pub(super) peers: Option<PathBuf>,
    /// Say nothing but errors
    #[arg(long)]
    pub(super) quiet: bool,
}

#[cfg(feature = "headless")]
impl PictureArguments {
    /// The time (s) shown: as said here, else as a link says, else as the scene's step does.
    pub(super) fn time(&self, scene: &Scene) -> f64 {
        self.time.or_else(|| self.scene.time()).or(scene.file.pace_at(scene.at).time).unwrap_or(0.0)
    }

    /// The scene, with the words of a command line that name it and what is said over it.
    pub(super) fn named_scene(&self) -> Result<(Scene, Vec<String>), Failure> {
        let (scene, mut words) = self.scene.named_scene(Some(&self.view), self.scene_step, self.quiet)?;
        words.extend(scene.at.into_iter().flat_map(|step| ["--scene-step".to_owned(), (step + 1).to_string()]));
        Ok((scene, words))
    }
}

impl SceneArguments {
    /// Whether anything is said of the body or its spin: a name, a file, a link, or a flag.
    #[cfg(feature = "report")]
    pub(super) fn is_given(&self) -> bool {
        self.scene.is_some() || self.edits(None).touch(&["body", "spin"])
    }

    /// Reads the scene, says over it what is given and checks the whole. Warnings go to standard error.
    pub(super) fn scene(&self, view: Option<&ViewArguments>, is_quiet: bool) -> Result<Scene, Failure> {
        Ok(self.named_scene(view, None, is_quiet)?.0)
    }

    /// As [`Self::scene`], at a step counted from 1, with the words of a command line that name the scene and what is said over it.
    fn named_scene(
        &self,
        view: Option<&ViewArguments>,
        step: Option<usize>,
        is_quiet: bool,
    ) -> Result<(Scene, Vec<String>), Failure> {
        let opened = self.opened()?;
        let scene = self.checked(&opened, view, step, is_quiet)?;
        let mut words = vec![opened.name];
        words.extend(flags(&opened.file, &scene.file));
        Ok((scene, words))
    }

    /// The time (s) that a link or a picture says.
    #[cfg(feature = "picture")]
    pub(super) fn time(&self) -> Option<f64> {
        self.said().as_ref().ok()?.time
    }

    /// Whether a picture is named, which alone among files says a time.
    #[cfg(feature = "window")]
    pub(super) fn is_picture(&self) -> bool {
        matches!(self.source(), Source::Path(_)) && self.time().is_some()
    }

    /// What SCENE says.
    fn said(&self) -> &Result<Link, String> {
        self.said.get_or_init(|| self.source().read())
    }

    /// The scene as it stands.
    fn opened(&self) -> Result<Opened, Failure> {
        let source = self.source();
        let said = self.said().as_ref().map_err(|why| Failure::request(why.clone()))?;
        Ok(Opened { name: source.name(), file: said.file.clone(), is_file: matches!(source, Source::Path(_)) })
    }

    /// An opened scene with what is said over it, at a step counted from 1.
    fn checked(
        &self,
        opened: &Opened,
        view: Option<&ViewArguments>,
        step: Option<usize>,
        is_quiet: bool,
    ) -> Result<Scene, Failure> {
        let mut file = opened.file.clone();
        self.edits(view).apply(&mut file);
        // Before the first there is no step either: it is told as 0.
        let given = step.map(|step| step.checked_sub(1).unwrap_or(usize::MAX));
        let scene = check(&file, given.or_else(|| self.said().as_ref().ok()?.step)).map_err(|error| {
            let place = if opened.is_file { format!("{}: ", opened.name) } else { String::new() };
            Failure::request(format!("{place}{error}"))
        })?;
        if !is_quiet {
            for warning in scene.warnings() {
                say(&warning);
            }
        }
        Ok(scene)
    }

    /// For the window: the scene at a step counted from 1, and, where a folder is named, all scenes in it in the order of their names.
    #[cfg(feature = "window")]
    pub(super) fn slides(
        &self,
        view: &ViewArguments,
        step: Option<usize>,
        is_quiet: bool,
    ) -> Result<(Scene, Vec<dzhanibekov::session::Slide>), Failure> {
        let slides = match self.source() {
            Source::Path(path) if path.is_dir() => dzhanibekov::app::read_slides(path).map_err(Failure::request)?,
            Source::Path(path) => {
                let slides = dzhanibekov::app::read_slides(path).map_err(Failure::request)?;
                return Ok((self.named_scene(Some(view), step, is_quiet)?.0, slides));
            }
            _ => return Ok((self.named_scene(Some(view), step, is_quiet)?.0, vec![])),
        };
        let sound = slides.iter().find_map(|slide| Some((&slide.name, slide.file.as_ref().ok()?)));
        let Some((name, file)) = sound else {
            let why = slides.first().map(|slide| (slide.name.clone(), slide.file.clone().err().unwrap_or_default()));
            let (name, why) = why.unwrap_or_default();
            return Err(Failure::request(format!("{name}: {why}")));
        };
        let opened = Opened { name: name.clone(), file: file.clone(), is_file: true };
        let scene = self.checked(&opened, Some(view), step, is_quiet)?;
        Ok((scene, slides))
    }

    /// The file or the folder that SCENE names, if it names one.
    #[cfg(feature = "window")]
    pub(super) fn place(&self) -> Option<PathBuf> {
        match self.source() {
            Source::Path(path) => Some(path.to_owned()),
            _ => None,
        }
    }

    /// What SCENE names. A built-in scene goes before a file or a folder of its name, which `./flip` would be.
    fn source(&self) -> Source<'_> {
        let Some(path) = self.scene.as_deref() else { return Source::BuiltIn(DEFAULT_PRESET) };
        match path.to_str() {
            Some(word) if link::is_link(word) => Source::Link(word),
            Some(word) if preset(word).is_ok() => Source::BuiltIn(word),
            Some(word) if path.components().count() == 1 && path.extension().is_none() && !path.exists() => {
                // A name that nothing has: the built-in scenes say which is the nearest.
                Source::BuiltIn(word)
            }
            _ => Source::Path(path),
        }
    }

    /// All that is said over the scene.
    fn edits(&self, view: Option<&ViewArguments>) -> Edits {
        let mut flags = self.flags.0.clone();
        flags.extend(view.into_iter().flat_map(|view| view.0.clone()));
        Edits { set: self.set.clone(), flags }
    }
}

/// What SCENE names.
enum Source<'a> {
    /// A built-in scene.
    BuiltIn(&'a str),
    /// A link.
    Link(&'a str),
    /// A file, or a folder of them.
    Path(&'a Path),
}

/// A scene as it stands, before anything is said over it.
struct Opened {
    /// How a command line names it.
    name: String,
    /// What it says.
    file: SceneFile,
    /// Whether it is a file, which an error then names.
    is_file: bool,
}

impl Source<'_> {
    /// How a command line names it.
    fn name(&self) -> String {
        match self {
            Self::BuiltIn(word) | Self::Link(word) => (*word).to_owned(),
            Self::Path(path) => path.display().to_string(),
        }
    }

    /// What it says, or a sentence why it cannot be had.
    fn read(&self) -> Result<Link, String> {
        let built_in = |name: &str| Ok(Link { file: preset(name)?.read()?, ..Link::default() });
        match self {
            Self::BuiltIn(name) => built_in(name).map_err(|error: SceneError| {
                format!("{error}; a scene of your own is given by the path of its .toml file")
            }),
            Self::Link(text) => link::read(text).map_err(|error| error.to_string()),
            Self::Path(path) => files::read_scene(path).map_err(|error| format!("{}: {error}", path.display())),
        }
    }
}

/// Checks a scene with all that this build of the program knows of it.
fn check(file: &SceneFile, at: Option<usize>) -> Result<Scene, SceneError> {
    #[cfg(feature = "picture")]
    return dzhanibekov::objects::check_at(file, at);
    #[cfg(not(feature = "picture"))]
    Scene::check_at(file, at)
}

/// Reads numbers with commas between them.
pub(super) fn number_list(text: &str) -> Result<Vec<f64>, String> {
    text.split(',').map(one_number).collect()
}

/// Reads a count, or a place that is counted from 1.
pub(super) fn count(text: &str) -> Result<usize, String> {
    let wanted = "a whole number from 1 is wanted, as in 2";
    text.trim().parse().ok().filter(|count| *count > 0).ok_or_else(|| wanted.to_owned())
}

/// Reads a size as 1280x720.
pub(super) fn size(text: &str) -> Result<[u32; 2], String> {
    let wanted = "a size is two whole numbers above 0 and below 2^32, as in 1280x720";
    let (width, height) = text.split_once(['x', 'X', '×']).ok_or(wanted)?;
    let both = [width, height].map(|side| side.trim().parse::<u32>().ok().filter(|pixels| *pixels > 0));
    match both {
        [Some(width), Some(height)] => Ok([width, height]),
        _ => Err(wanted.to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::{count, number_list, size};

    #[test]
    fn numbers_of_flags_are_read_or_refused_with_what_is_wanted() {
        assert_eq!(count(" 2 "), Ok(2));
        for text in ["0", "-1", "1.5", "x", "", "99999999999999999999999"] {
            assert!(count(text).is_err_and(|why| why.starts_with("a whole number from 1")), "{text}");
        }
        assert_eq!(size("1280x720"), Ok([1280, 720]));
        for text in ["0x0", "-1x5", "12", "4294967296x1", "1.5x2"] {
            assert!(size(text).is_err_and(|why| why.contains("above 0 and below 2^32")), "{text}");
        }
        assert_eq!(number_list("1, 2e3"), Ok(vec![1.0, 2000.0]));
        assert_eq!(number_list("1,x"), Err("`x` is not a number".to_owned()));
        for text in ["0,1e400", "-1e-400"] {
            assert!(number_list(text).is_err_and(|why| why.contains("is past the range of numbers")), "{text}");
        }
    }
}
