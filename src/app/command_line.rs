//! The `shot` command that draws what the window shows.

use crate::camera::Camera;
use crate::objects::Cameras;
use crate::scene::{Layout, SceneFile, View, flags, quoted};

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
    set_camera(&mut file, &base.file, cameras);
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

/// A scene knows one camera: that of the view shown, or of the world where both are.
fn set_camera(file: &mut SceneFile, base: &SceneFile, cameras: &Cameras) {
    let is_body = file.view.layout.unwrap_or_default() == Layout::Body;
    let pick = |cameras: &Cameras| -> Camera { if is_body { cameras.body } else { cameras.world } };
    let unset = |azimuth_deg, elevation_deg, distance| View { azimuth_deg, elevation_deg, distance, ..unset_view() };
    let view = &base.view;
    let now = pick(cameras);
    if now == pick(&Cameras::new(&unset(view.azimuth, view.elevation, view.distance))) {
        return;
    }
    let usual = pick(&Cameras::new(&unset(None, None, None)));
    let rounded = |value: f32| (f64::from(value) * 1e3).round() / 1e3;
    file.view.azimuth = Some(rounded(now.azimuth.to_degrees()));
    file.view.elevation = Some(rounded(now.elevation.to_degrees()));
    file.view.distance = Some(rounded(now.distance / usual.distance));
}

/// A view that nobody has set.
fn unset_view() -> View {
    View {
        layout: Layout::default(),
        theme: crate::scene::Theme::default(),
        show: Vec::new(),
        hide: Vec::new(),
        labels: true,
        font_scale: 1.0,
        azimuth_deg: None,
        elevation_deg: None,
        distance: None,
    }
}
