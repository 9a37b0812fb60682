//! A scene as flags of the command line: what reproduces a picture in a shell.

use super::{Layout, SceneFile, Theme};

/// The flags that turn the scene `base` into `file`, each a word of a command line. Title and words are left out, as is
/// an attitude, which has no flag.
#[must_use]
pub fn flags(base: &SceneFile, file: &SceneFile) -> Vec<String> {
    let mut flags = Flags(vec![]);
    let (body, was) = (&file.body, &base.body);
    if body != was {
        flags.list("--box", body.edges.as_ref().map(<[f64; 3]>::as_slice));
        flags.put("--mass", body.mass);
        flags.list("--moments", body.moments.as_ref().map(<[f64; 3]>::as_slice));
        flags.list("--inertia", body.inertia.as_ref().map(<[f64; 6]>::as_slice));
    }
    let (spin, was) = (&file.spin, &base.spin);
    if spin != was {
        flags.list("--omega", spin.omega.as_ref().map(<[f64; 3]>::as_slice));
        flags.put("--axis", spin.axis);
        flags.put("--tilt", spin.tilt_deg);
        flags.put("--rate", spin.rate);
    }
    let (motion, was) = (&file.motion, &base.motion);
    flags.changed("--method", motion.method.as_ref(), was.method.as_ref());
    flags.changed("--step", motion.step.as_ref(), was.step.as_ref());
    if motion.compare != was.compare && !motion.compare.is_empty() {
        flags.put("--compare", Some(motion.compare.join(",")));
    }
    let (view, was) = (&file.view, &base.view);
    let layout = |layout: Layout| match layout {
        Layout::Both => "both",
        Layout::World => "world",
        Layout::Body => "body",
    };
    let theme = |theme: Theme| match theme {
        Theme::Dark => "dark",
        Theme::Light => "light",
    };
    flags.changed("--view", view.layout.map(layout).as_ref(), was.layout.map(layout).as_ref());
    flags.changed("--theme", view.theme.map(theme).as_ref(), was.theme.map(theme).as_ref());
    let without = |names: &[String], known: &[String]| -> Vec<String> {
        names.iter().filter(|name| !known.contains(name)).cloned().collect()
    };
    // A name that the base shows or hides and the scene no longer does is taken back by the opposite flag.
    let mut show = without(&view.show, &was.show);
    show.extend(without(&was.hide, &view.hide).into_iter().filter(|name| !view.show.contains(name)));
    let mut hide = without(&view.hide, &was.hide);
    hide.extend(without(&was.show, &view.show).into_iter().filter(|name| !view.hide.contains(name)));
    for (flag, names) in [("--show", show), ("--hide", hide)] {
        if !names.is_empty() {
            flags.put(flag, Some(names.join(",")));
        }
    }
    let switch = |is_on: bool| if is_on { "on" } else { "off" };
    flags.changed("--labels", view.labels.map(switch).as_ref(), was.labels.map(switch).as_ref());
    flags.changed("--font-scale", view.font_scale.as_ref(), was.font_scale.as_ref());
    flags.changed("--azimuth", view.azimuth.as_ref(), was.azimuth.as_ref());
    flags.changed("--elevation", view.elevation.as_ref(), was.elevation.as_ref());
    flags.changed("--distance", view.distance.as_ref(), was.distance.as_ref());
    for (flag, camera, was) in [
        ("--world-camera", &view.world_camera, &was.world_camera),
        ("--body-camera", &view.body_camera, &was.body_camera),
    ] {
        if camera != was {
            flags.list(flag, camera.as_ref().map(<[f64; 6]>::as_slice));
        }
    }
    flags.0
}

/// Words as one line for a shell, quoted where they need it.
#[must_use]
pub fn quoted(words: &[String]) -> String {
    let is_plain =
        |word: &str| !word.is_empty() && word.chars().all(|c| c.is_ascii_alphanumeric() || "-_=+,./:@%".contains(c));
    let quote =
        |word: &String| if is_plain(word) { word.clone() } else { format!("'{}'", word.replace('\'', r"'\''")) };
    words.iter().map(quote).collect::<Vec<_>>().join(" ")
}

struct Flags(Vec<String>);

impl Flags {
    fn put(&mut self, flag: &str, value: Option<impl ToString>) {
        if let Some(value) = value {
            self.0.extend([flag.to_owned(), value.to_string()]);
        }
    }

    fn list(&mut self, flag: &str, values: Option<&[f64]>) {
        self.put(flag, values.map(|values| values.iter().map(f64::to_string).collect::<Vec<_>>().join(",")));
    }

    fn changed<T: ToString + PartialEq>(&mut self, flag: &str, value: Option<&T>, before: Option<&T>) {
        if value != before {
            self.put(flag, value.map(ToString::to_string));
        }
    }
}
