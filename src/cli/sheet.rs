//! `shot --times`: a sheet of moments.

use dzhanibekov::files;
use dzhanibekov::headless::{FigureFormat, Sheet, ShotOptions};
use dzhanibekov::render::png::Remark;
use dzhanibekov::scene::Scene;

use super::failure::Failure;
use super::picture::{ShotArguments, followed, open_for, options, remarks};
use super::times::{check_steps, short};

/// Draws the moments of a checked scene, which these words name, side by side.
pub(super) fn sheet(
    arguments: &ShotArguments,
    times: &[f64],
    format: Option<FigureFormat>,
    scene: &Scene,
    words: &[String],
) -> Result<(), Failure> {
    let picture = &arguments.picture;
    if let Some(time) = times.iter().find(|time| !time.is_finite()) {
        return Err(Failure::request(format!("--times holds {time}, which is not finite")));
    }
    let farthest = times.iter().copied().fold(0.0, |most: f64, time| if time.abs() > most.abs() { time } else { most });
    check_steps(scene, &format!("{} in --times", short(farthest)), farthest, followed(scene))?;
    let font_scale = scene.view.font_scale as f32;
    let sheet =
        Sheet::new(times.len(), arguments.columns, picture.size.said(), font_scale).map_err(Failure::request)?;
    let options = options(picture);
    let mut notes = notes(arguments, times, scene, words);
    let bytes = match format {
        None => {
            let gpu = open_for(&sheet.options(&options), picture.quiet)?;
            sheet.draw(&gpu, scene, times, &options, &notes)?
        }
        Some(format) => {
            arguments.figure.mark(format, &mut notes);
            // Its surfaces are one picture.
            let open = || open_for(&ShotOptions { size: sheet.whole, ..options.clone() }, picture.quiet);
            sheet.figure(open, scene, times, &options, (arguments.figure.style(), format), &notes)?
        }
    };
    Ok(files::write(&arguments.output, &bytes)?)
}

/// What the sheet's file says of itself: as the picture of its first moment, but for the times.
fn notes(arguments: &ShotArguments, times: &[f64], scene: &Scene, words: &[String]) -> Vec<Remark> {
    let list: Vec<String> = times.iter().map(|time| short(*time)).collect();
    let mut moment = vec!["--times".to_owned(), list.join(",")];
    if let Some(columns) = arguments.columns {
        moment.extend(["--columns".to_owned(), columns.to_string()]);
    }
    let first = times.first().copied().unwrap_or_default();
    let mut notes = remarks(&arguments.picture, scene, words, &moment, first);
    if let Some((_, text)) = notes.iter_mut().find(|(keyword, _)| *keyword == "Description") {
        *text = format!("t = {} s", list.join(", "));
    }
    notes
}
