//! `-o FILE.html`: the page in one file, which plays the scene in any browser.

use std::path::{Path, PathBuf};

use clap::Args;
use dzhanibekov::files;
use dzhanibekov::scene::{SceneFile, carried};

use super::arguments::PictureArguments;
use super::failure::Failure;
use super::output::{check_place, ending};
use super::picture::picture_scene;

/// Flags of a page.
#[derive(Args, Debug)]
pub(super) struct PageArguments {
    /// Of a .html: the folder of the page that it is made from, where that is not installed beside the program
    #[arg(long, value_name = "FOLDER", help_heading = "Picture")]
    page: Option<PathBuf>,
}

/// How a page begins.
#[derive(Clone, Copy, Debug)]
pub(super) struct Beginning {
    /// Whether time runs.
    pub(super) plays: bool,
    /// Whether the panel is there, and with it all that the window has.
    pub(super) has_panel: bool,
}

/// Whether a name is that of a page.
pub(super) fn is_page(output: &Path) -> bool {
    ending(output).as_deref() == Some("html")
}

/// Writes the page that shows the scene of a picture, which was asked for with these flags besides.
pub(super) fn page(
    picture: &PictureArguments,
    output: &Path,
    beginning: Beginning,
    flags: &[(&str, bool)],
) -> Result<(), Failure> {
    let (scene, words) = picture_scene(picture)?;
    let own = [
        ("--transparent", picture.transparent),
        ("--metadata", picture.metadata.is_some()),
        ("--no-metadata", picture.no_metadata),
    ];
    let size = picture.size.flags().map(|flag| (flag, true));
    if let Some((flag, _)) = size.chain(own).chain(flags.iter().copied()).find(|(_, is_said)| *is_said) {
        return Err(Failure::request(format!(
            "{flag} has no meaning for {}, a page that fills what shows it and holds its scene: leave it out",
            output.display()
        )));
    }
    check_place(output)?;
    let folder = folder(picture.page.page.as_deref(), output)?;
    let mut file = scene.file.clone();
    if !beginning.has_panel && scene.at.is_none() {
        // A page begins at the first step of what is told in steps; this is the scene as a whole.
        file.steps.clear();
    }
    let link = carried::link_of(&file, scene.at, picture.time(&scene));
    let query = [("embed=1", !beginning.has_panel), ("play=0", !beginning.plays)];
    let query: Vec<&str> = query.iter().filter_map(|(word, is_said)| is_said.then_some(*word)).collect();
    let title = title(&file, &words);
    let text = files::page(&folder, &link, &query.join("&"), title)?;
    Ok(files::write(output, text.as_bytes())?)
}

/// What the page is called.
fn title<'a>(file: &'a SceneFile, words: &'a [String]) -> &'a str {
    let title = file.title.trim();
    if title.is_empty() { words.first().map_or("Dzhanibekov", String::as_str) } else { title }
}

/// The folder that holds a page: the one that is named, else one beside the program or among the system's data.
fn folder(named: Option<&Path>, output: &Path) -> Result<PathBuf, Failure> {
    if let Some(folder) = named {
        return if files::is_page(folder) {
            Ok(folder.to_owned())
        } else {
            Err(Failure::request(format!(
                "--page {} holds no page: `bash .ci/page {}`, in the program's source, builds one there",
                folder.display(),
                folder.display()
            )))
        };
    }
    places().into_iter().find(|folder| files::is_page(folder)).ok_or_else(|| {
        Failure::could_not(format!(
            "{} is made from the page, which is not installed here: name its folder by --page FOLDER (`bash .ci/page FOLDER`, in the \
             program's source, builds it)",
            output.display()
        ))
    })
}

/// Where a page is looked for.
fn places() -> Vec<PathBuf> {
    let from = |name: &str| std::env::var_os(name).filter(|value| !value.is_empty());
    let mut places = vec![];
    let program = std::env::current_exe().and_then(std::fs::canonicalize).ok();
    if let Some(beside) = program.as_deref().and_then(Path::parent) {
        places.push(beside.join("page"));
        places.push(beside.join("../share/dzhanibekov/page"));
    }
    let own =
        from("XDG_DATA_HOME").map(PathBuf::from).or_else(|| Some(PathBuf::from(from("HOME")?).join(".local/share")));
    let shared = from("XDG_DATA_DIRS").unwrap_or_else(|| "/usr/local/share:/usr/share".into());
    let data = own.into_iter().chain(std::env::split_paths(&shared));
    places.extend(data.filter(|path| path.is_absolute()).map(|path| path.join("dzhanibekov/page")));
    places
}
