//! The `shot` command that draws what the window shows.

use std::fmt::Write;

use crate::camera::Camera;
use crate::objects::Cameras;
use crate::scene::{BodyFile, Layout, SceneFile, SpinFile, Theme};

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
    let mut line = format!("dzhanibekov shot {}", quoted(&base.name));
    body(&mut line, &base.file.body, &file.body)?;
    spin(&mut line, &base.file.spin, &file.spin)?;
    let (motion, was) = (&file.motion, &base.file.motion);
    if let Some(method) = motion.method.as_ref().filter(|_| motion.method != was.method) {
        add(&mut line, "method", method);
    }
    if let Some(step) = motion.step.filter(|_| motion.step != was.step) {
        add(&mut line, "step", &step.to_string());
    }
    if motion.compare != was.compare {
        if motion.compare.is_empty() {
            return None;
        }
        add(&mut line, "compare", &motion.compare.join(","));
    }
    add(&mut line, "time", &time.to_string());
    add(&mut line, "size", &format!("{}x{}", size[0], size[1]));
    let (view, was) = (&file.view, &base.file.view);
    if let Some(layout) = view.layout.filter(|_| view.layout != was.layout) {
        let name = match layout {
            Layout::Both => "both",
            Layout::World => "world",
            Layout::Body => "body",
        };
        add(&mut line, "view", name);
    }
    if let Some(theme) = view.theme.filter(|_| view.theme != was.theme) {
        let name = match theme {
            Theme::Dark => "dark",
            Theme::Light => "light",
        };
        add(&mut line, "theme", name);
    }
    if let Some(labels) = view.labels.filter(|_| view.labels != was.labels) {
        add(&mut line, "labels", if labels { "on" } else { "off" });
    }
    camera(&mut line, view.layout.unwrap_or_default(), cameras);
    let _ = write!(line, " -o {}.png", super::files::slug(&file.title));
    Some(line)
}

fn body(line: &mut String, was: &BodyFile, body: &BodyFile) -> Option<()> {
    if body == was {
        return Some(());
    }
    let list = |numbers: &[f64]| numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(",");
    if let Some(edges) = &body.edges {
        add(line, "box", &list(edges));
    } else if let Some(moments) = &body.moments {
        add(line, "moments", &list(moments));
    } else if let Some(inertia) = &body.inertia {
        add(line, "inertia", &list(inertia));
    } else {
        return None;
    }
    if let Some(mass) = body.mass {
        add(line, "mass", &mass.to_string());
    }
    Some(())
}

fn spin(line: &mut String, was: &SpinFile, spin: &SpinFile) -> Option<()> {
    if spin.attitude != was.attitude {
        return None;
    }
    if spin == was {
        return Some(());
    }
    if let Some([x, y, z]) = spin.omega {
        add(line, "omega", &format!("{x},{y},{z}"));
        return Some(());
    }
    add(line, "axis", &spin.axis.unwrap_or(2).to_string());
    add(line, "tilt", &spin.tilt_deg.unwrap_or(0.0).to_string());
    add(line, "rate", &spin.rate.unwrap_or(1.0).to_string());
    Some(())
}

/// The flags know one camera: that of the view shown, or of the world where both are.
fn camera(line: &mut String, layout: Layout, cameras: &Cameras) {
    let usual = Cameras::new(&usual_view());
    let pick = |cameras: &Cameras| -> Camera { if layout == Layout::Body { cameras.body } else { cameras.world } };
    let (now, usual) = (pick(cameras), pick(&usual));
    if now == usual {
        return;
    }
    add(line, "azimuth", &format!("{:.2}", now.azimuth.to_degrees()));
    add(line, "elevation", &format!("{:.2}", now.elevation.to_degrees()));
    add(line, "distance", &format!("{:.3}", now.distance / usual.distance));
}

/// A view whose cameras nobody has set.
pub(super) fn usual_view() -> crate::scene::View {
    crate::scene::View {
        layout: Layout::Both,
        theme: Theme::Dark,
        show: Vec::new(),
        hide: Vec::new(),
        labels: true,
        font_scale: 1.0,
        azimuth_deg: None,
        elevation_deg: None,
        distance: None,
    }
}

fn add(line: &mut String, flag: &str, value: &str) {
    let _ = write!(line, " --{flag} {value}");
}

fn quoted(name: &str) -> String {
    let is_plain = name.chars().all(|c| c.is_alphanumeric() || "-_./".contains(c));
    if is_plain { name.to_owned() } else { format!("'{}'", name.replace('\'', r"'\''")) }
}
