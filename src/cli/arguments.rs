//! Flags that several commands share: what overrides a scene, and what is said of a picture.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use dzhanibekov::files;
use dzhanibekov::scene::{DEFAULT_PRESET, Layout, Scene, SceneFile, Theme, flags, preset};

use super::failure::{Failure, say};

/// The scene and what overrides it.
#[derive(Args, Debug)]
pub(super) struct SceneArguments {
    /// Name of a built-in scene, or the path of a .toml file; for the window also of a folder of them
    #[arg(value_name = "SCENE")]
    scene: Option<PathBuf>,
    /// Edges of a solid box along the body's axes (m)
    #[arg(long = "box", value_name = "A,B,C", value_parser = numbers::<3>, allow_hyphen_values = true, help_heading = "Scene")]
    edges: Option<[f64; 3]>,
    /// Mass of the box (kg)
    #[arg(long, value_name = "KG", allow_hyphen_values = true, help_heading = "Scene")]
    mass: Option<f64>,
    /// Principal moments in the order of the body's axes (kg m²)
    #[arg(long, value_name = "I1,I2,I3", value_parser = numbers::<3>, allow_hyphen_values = true, help_heading = "Scene")]
    moments: Option<[f64; 3]>,
    /// Inertia tensor in the body frame (kg m²)
    #[arg(long, value_name = "XX,YY,ZZ,XY,XZ,YZ", value_parser = numbers::<6>, allow_hyphen_values = true, help_heading = "Scene")]
    inertia: Option<[f64; 6]>,
    /// Angular velocity at the start in the body frame (rad/s)
    #[arg(long, value_name = "X,Y,Z", value_parser = numbers::<3>, allow_hyphen_values = true, help_heading = "Scene")]
    omega: Option<[f64; 3]>,
    /// Principal axis to spin about: 1 has the smallest moment, 3 the largest
    #[arg(long, value_name = "1|2|3", allow_hyphen_values = true, help_heading = "Scene", value_parser = axis)]
    axis: Option<u8>,
    /// Tilt of the spin from that axis towards the next (degrees)
    #[arg(long, value_name = "DEG", allow_hyphen_values = true, help_heading = "Scene")]
    tilt: Option<f64>,
    /// Speed of the spin (rad/s)
    #[arg(long, value_name = "RAD_S", allow_hyphen_values = true, help_heading = "Scene")]
    rate: Option<f64>,
    /// Method that follows the motion (`dzhanibekov methods` lists them)
    #[arg(long, value_name = "NAME", help_heading = "Scene")]
    method: Option<String>,
    /// Step of the method (s)
    #[arg(long, value_name = "S", allow_hyphen_values = true, help_heading = "Scene")]
    step: Option<f64>,
    /// Methods run beside it from the same start
    #[arg(long, value_name = "NAME,NAME", value_delimiter = ',', help_heading = "Scene")]
    compare: Vec<String>,
}

/// How a scene is looked at.
#[derive(Args, Debug)]
pub(super) struct ViewArguments {
    /// Which spaces to show
    #[arg(long, value_name = "both|world|body", help_heading = "Picture")]
    view: Option<LayoutName>,
    /// Objects to show besides the default ones
    #[arg(long, value_name = "NAME,…", value_delimiter = ',', help_heading = "Picture")]
    show: Vec<String>,
    /// Objects to hide
    #[arg(long, value_name = "NAME,…", value_delimiter = ',', help_heading = "Picture")]
    hide: Vec<String>,
    /// Colours for a dark hall, or for bright rooms and print
    #[arg(long, value_name = "dark|light", help_heading = "Picture")]
    theme: Option<ThemeName>,
    /// Names beside things
    #[arg(long, value_name = "on|off", help_heading = "Picture")]
    labels: Option<Switch>,
    /// Factor on the size of text and the width of lines
    #[arg(long, value_name = "X", allow_hyphen_values = true, help_heading = "Picture")]
    font_scale: Option<f64>,
    /// Camera's direction round the vertical (degrees)
    #[arg(long, value_name = "DEG", allow_hyphen_values = true, help_heading = "Picture")]
    azimuth: Option<f64>,
    /// Camera's height above the horizon (degrees)
    #[arg(long, value_name = "DEG", allow_hyphen_values = true, help_heading = "Picture")]
    elevation: Option<f64>,
    /// Camera's distance, a factor on the one that frames everything
    #[arg(long, value_name = "X", allow_hyphen_values = true, help_heading = "Picture")]
    distance: Option<f64>,
    /// Camera of the world alone: azimuth, elevation, distance, and the point looked at
    #[arg(long, value_name = "DEG,DEG,X,X,Y,Z", value_parser = numbers::<6>, allow_hyphen_values = true, help_heading = "Picture")]
    world_camera: Option<[f64; 6]>,
    /// Camera of momentum space alone, likewise
    #[arg(long, value_name = "DEG,DEG,X,X,Y,Z", value_parser = numbers::<6>, allow_hyphen_values = true, help_heading = "Picture")]
    body_camera: Option<[f64; 6]>,
}

/// Everything that is said of a picture in a file, but its name.
#[derive(Args, Debug)]
pub(super) struct PictureArguments {
    #[command(flatten)]
    pub(super) scene: SceneArguments,
    #[command(flatten)]
    pub(super) view: ViewArguments,
    /// Simulated time shown (s); of a recording, its first frame's
    #[arg(long, value_name = "T", default_value = "0", allow_hyphen_values = true, help_heading = "Picture")]
    pub(super) time: f64,
    /// Size in pixels
    #[arg(long, value_name = "WxH", default_value = "1280x720", allow_hyphen_values = true, value_parser = size, help_heading = "Picture")]
    pub(super) size: [u32; 2],
    /// No background: transparent where nothing is drawn
    #[arg(long, help_heading = "Picture")]
    pub(super) transparent: bool,
    /// Name (or a part of it) of the graphics adapter to draw with
    #[arg(long, value_name = "NAME", help_heading = "Picture")]
    pub(super) adapter: Option<String>,
    /// Say nothing but errors
    #[arg(long)]
    pub(super) quiet: bool,
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

#[derive(Clone, Copy, Debug, ValueEnum)]
enum LayoutName {
    Both,
    World,
    Body,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum ThemeName {
    Dark,
    Light,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Switch {
    On,
    Off,
}

impl SceneArguments {
    /// Whether anything is said of the body or its spin: a name, a file, or a flag.
    #[cfg(feature = "report")]
    pub(super) fn is_given(&self) -> bool {
        let has_body = self.edges.is_some() || self.mass.is_some() || self.moments.is_some() || self.inertia.is_some();
        let has_spin = self.omega.is_some() || self.axis.is_some() || self.tilt.is_some() || self.rate.is_some();
        self.scene.is_some() || has_body || has_spin
    }

    /// Reads the scene, applies the overrides and checks the whole. Warnings go to standard error.
    pub(super) fn scene(&self, view: Option<&ViewArguments>, is_quiet: bool) -> Result<Scene, Failure> {
        Ok(self.named_scene(view, is_quiet)?.0)
    }

    /// As [`Self::scene`], with the words of a command line that name the scene and its overrides.
    pub(super) fn named_scene(
        &self,
        view: Option<&ViewArguments>,
        is_quiet: bool,
    ) -> Result<(Scene, Vec<String>), Failure> {
        let (name, base) = self.read()?;
        let scene = self.checked(name.as_deref(), &base, view, is_quiet)?;
        let mut words = vec![self.name().display().to_string()];
        words.extend(flags(&base, &scene.file));
        Ok((scene, words))
    }

    /// The scene of a file under this name, with the overrides.
    fn checked(
        &self,
        name: Option<&str>,
        base: &SceneFile,
        view: Option<&ViewArguments>,
        is_quiet: bool,
    ) -> Result<Scene, Failure> {
        let mut file = base.clone();
        self.apply(&mut file);
        if let Some(view) = view {
            view.apply(&mut file);
        }
        let scene = Scene::check(&file).map_err(|error| match name {
            Some(path) => Failure::request(format!("{path}: {error}")),
            None => Failure::from(error),
        })?;
        if !is_quiet {
            for warning in scene.warnings() {
                say(&warning);
            }
        }
        Ok(scene)
    }

    /// For the window: the scene and, where a folder is named, all scenes in it in the order of their names.
    #[cfg(feature = "window")]
    pub(super) fn slides(
        &self,
        view: &ViewArguments,
        is_quiet: bool,
    ) -> Result<(Scene, Vec<dzhanibekov::session::Slide>), Failure> {
        if !self.name().is_dir() {
            return Ok((self.scene(Some(view), is_quiet)?, Vec::new()));
        }
        let slides = dzhanibekov::app::read_slides(self.name()).map_err(Failure::request)?;
        let sound = slides.iter().find_map(|slide| Some((&slide.name, slide.file.as_ref().ok()?)));
        let Some((name, file)) = sound else {
            let why = slides.first().map(|slide| (slide.name.clone(), slide.file.clone().err().unwrap_or_default()));
            let (name, why) = why.unwrap_or_default();
            return Err(Failure::request(format!("{name}: {why}")));
        };
        let scene = self.checked(Some(name), file, Some(view), is_quiet)?;
        Ok((scene, slides))
    }

    fn name(&self) -> &Path {
        self.scene.as_deref().unwrap_or(Path::new(DEFAULT_PRESET))
    }

    /// The scene as it stands in its file, and the file's path where it is not built in.
    fn read(&self) -> Result<(Option<String>, SceneFile), Failure> {
        let name = self.name();
        let is_path = name.components().count() > 1 || name.extension().is_some() || name.exists();
        match name.to_str() {
            Some(stem) if !is_path || preset(stem).is_ok() => Ok((None, preset(stem)?.read()?)),
            _ => {
                let (path, file) = read_file(name).map_err(Failure::request)?;
                Ok((Some(path), file))
            }
        }
    }

    fn apply(&self, file: &mut SceneFile) {
        let body = &mut file.body;
        if self.edges.is_some() || self.moments.is_some() || self.inertia.is_some() {
            // A body on the command line takes the place of the scene's; two of them are told apart by the check.
            *body = dzhanibekov::scene::BodyFile {
                edges: self.edges,
                mass: None,
                moments: self.moments,
                inertia: self.inertia,
                ..Default::default()
            };
        }
        override_with(&mut body.mass, self.mass);
        let spin = &mut file.spin;
        if self.omega.is_some() {
            (spin.axis, spin.tilt_deg, spin.rate) = (None, None, None);
            spin.omega = self.omega;
        } else if self.axis.is_some() || self.tilt.is_some() || self.rate.is_some() {
            spin.omega = None;
        }
        override_with(&mut spin.axis, self.axis);
        override_with(&mut spin.tilt_deg, self.tilt);
        override_with(&mut spin.rate, self.rate);
        override_with(&mut file.motion.method, self.method.clone());
        override_with(&mut file.motion.step, self.step);
        if !self.compare.is_empty() {
            file.motion.compare.clone_from(&self.compare);
        }
    }
}

impl ViewArguments {
    fn apply(&self, file: &mut SceneFile) {
        let view = &mut file.view;
        override_with(
            &mut view.layout,
            self.view.map(|name| match name {
                LayoutName::Both => Layout::Both,
                LayoutName::World => Layout::World,
                LayoutName::Body => Layout::Body,
            }),
        );
        override_with(
            &mut view.theme,
            self.theme.map(|name| match name {
                ThemeName::Dark => Theme::Dark,
                ThemeName::Light => Theme::Light,
            }),
        );
        override_with(&mut view.labels, self.labels.map(|switch| matches!(switch, Switch::On)));
        override_with(&mut view.font_scale, self.font_scale);
        override_with(&mut view.azimuth, self.azimuth);
        override_with(&mut view.elevation, self.elevation);
        override_with(&mut view.distance, self.distance);
        override_with(&mut view.world_camera, self.world_camera);
        override_with(&mut view.body_camera, self.body_camera);
        for name in &self.show {
            view.hide.retain(|hidden| hidden != name);
            view.show.push(name.clone());
        }
        for name in &self.hide {
            view.show.retain(|shown| shown != name);
            view.hide.push(name.clone());
        }
    }
}

fn override_with<T>(value: &mut Option<T>, given: Option<T>) {
    if given.is_some() {
        *value = given;
    }
}

/// Reads a scene file; its path comes with it.
fn read_file(path: &Path) -> Result<(String, SceneFile), String> {
    let name = path.display().to_string();
    let file = files::read_scene(path).map_err(|error| format!("{name}: {error}"))?;
    Ok((name, file))
}

/// Reads exactly `N` numbers with commas between them.
fn numbers<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let parts: Vec<f64> = number_list(text)?;
    let count = parts.len();
    parts.try_into().map_err(|_| format!("{N} numbers with commas between them are wanted, {count} are given"))
}

/// Reads numbers with commas between them.
pub(super) fn number_list(text: &str) -> Result<Vec<f64>, String> {
    text.split(',').map(|part| part.trim().parse().map_err(|_| format!("`{}` is not a number", part.trim()))).collect()
}

fn axis(text: &str) -> Result<u8, String> {
    match text {
        "1" => Ok(1),
        "2" => Ok(2),
        "3" => Ok(3),
        _ => Err("axes are 1 (smallest moment), 2 and 3 (largest)".to_owned()),
    }
}

/// Reads a size as 1280x720.
pub(super) fn size(text: &str) -> Result<[u32; 2], String> {
    let wanted = "a size is two whole numbers above 0, as in 1280x720";
    let (width, height) = text.split_once(['x', 'X', '×']).ok_or(wanted)?;
    let both = [width, height].map(|side| side.trim().parse::<u32>().ok().filter(|pixels| *pixels > 0));
    match both {
        [Some(width), Some(height)] => Ok([width, height]),
        _ => Err(wanted.to_owned()),
    }
}
