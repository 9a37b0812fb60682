//! The `shot` command that draws what the window shows.

use crate::objects::Cameras;
use crate::scene::{Scene, SceneFile, flags, quoted};

/// What the scene came from, as the command line names it.
#[derive(Clone, Debug)]
pub(super) struct Base {
    /// Name or path.
    pub(super) name: String,
    /// Its text as it was opened.
    pub(super) file: SceneFile,
}

/// The command for a scene at a time (s) in a picture of this size; `None` where flags cannot say it and the scene
/// has to be saved first.
pub(super) fn shot(base: &Base, file: &SceneFile, cameras: &Cameras, time: f64, size: [u32; 2]) -> Option<String> {
    // An attitude has no flag, and none takes methods of the base away.
    let loses_ghosts = file.motion.compare.is_empty() && !base.file.motion.compare.is_empty();
    if loses_ghosts || file.spin.attitude != base.file.spin.attitude {
        return None;
    }
    let mut file = file.clone();
    cameras.write(&Scene::check(&base.file).ok()?.view, &mut file.view);
    let mut words = vec!["dzhanibekov".to_owned(), "shot".to_owned(), base.name.clone()];
    words.extend(flags(&base.file, &file));
    words.extend([
        "--time".to_owned(),
        rounded_time(time).to_string(),
        "--size".to_owned(),
        format!("{}x{}", size[0], size[1]),
    ]);
    words.extend(["-o".to_owned(), format!("{}.png", super::files::slug(&file.title))]);
    Some(quoted(&words))
}

/// Without the digits that adding up steps leaves at the end: a nanosecond is nothing to see.
fn rounded_time(time: f64) -> f64 {
    if time.abs() < 1e6 { (time * 1e9).round() / 1e9 } else { time }
}
