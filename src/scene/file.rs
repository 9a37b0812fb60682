//! A scene as it is written: what each key of [`super::KEYS`] fills.

use super::{Layout, PartKind, StepFile, Theme, TimeUnit};

/// A scene file. Every part may be left out; [`super::Scene::check`] says what then holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneFile {
    /// Name of the slide, in a few words.
    pub title: String,
    /// Two or three sentences.
    pub text: String,
    /// A question to the class.
    pub question: String,
    /// What the question is answered by, once it is asked for.
    pub answer: String,
    /// Place among the presets, ascending.
    pub order: Option<i64>,
    /// The body.
    pub body: BodyFile,
    /// How it starts.
    pub spin: SpinFile,
    /// How it is followed.
    pub motion: MotionFile,
    /// Starts close together.
    pub cloud: CloudFile,
    /// How it is looked at.
    pub view: ViewFile,
    /// The steps in which it is told.
    pub steps: Vec<StepFile>,
}

/// The body: just one of `box`, `moments`, `inertia`, `solids`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BodyFile {
    /// Edges (m) of a solid box along the body's axes.
    pub edges: Option<[f64; 3]>,
    /// Mass (kg) of the box; 1 where left out.
    pub mass: Option<f64>,
    /// Principal moments (kg m²) in the order of the body's axes.
    pub moments: Option<[f64; 3]>,
    /// Inertia tensor (kg m²) as xx, yy, zz, xy, xz, yz.
    pub inertia: Option<[f64; 6]>,
    /// What is drawn of a body given by `moments` or `inertia`: the solid of this form that has them.
    pub form: Option<PartKind>,
    /// Solids that move as one.
    pub solids: Vec<SolidFile>,
}

/// A solid of uniform density.
#[derive(Clone, Debug, PartialEq)]
pub struct SolidFile {
    /// Its form.
    pub kind: PartKind,
    /// Full extents (m) along its own axes; a cylinder's are its diameter twice and its length.
    pub size: [f64; 3],
    /// Where its centre is (m); the origin where left out.
    pub position: [f64; 3],
    /// How it is turned from the body's axes: a rotation vector (degrees).
    pub rotation_deg: [f64; 3],
    /// Density (kg/m³); that of water where left out.
    pub density: f64,
}

/// The start: either `omega` or `axis`, `tilt_deg`, `rate`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SpinFile {
    /// Body angular velocity (rad/s) in the body frame.
    pub omega: Option<[f64; 3]>,
    /// Principal axis spun about: 1 has the smallest moment, 3 the largest.
    pub axis: Option<u8>,
    /// Angle (degrees) from that axis towards the next (1 → 2 → 3 → 1).
    pub tilt_deg: Option<f64>,
    /// Angular speed (rad/s).
    pub rate: Option<f64>,
    /// Attitude at the start, a quaternion w, x, y, z (made unit); the identity where left out.
    pub attitude: Option<[f64; 4]>,
}

/// How the motion is followed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MotionFile {
    /// Name of a method.
    pub method: Option<String>,
    /// Step (s).
    pub step: Option<f64>,
    /// Names of the methods run beside it from the same start.
    pub compare: Vec<String>,
    /// Energy lost inside the body at constant L, a number without a unit; none where left out.
    pub energy_loss: Option<f64>,
}

/// Starts close together, all with the momentum of the scene's own: what the cloud is drawn of.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CloudFile {
    /// How many in all.
    pub count: Option<i64>,
    /// How far (degrees) from their axis they are at most.
    pub spread_deg: Option<f64>,
    /// The principal axes round which they are; all three where left out.
    pub axes: Vec<u8>,
}

/// How it is looked at.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ViewFile {
    /// Which spaces are shown.
    pub layout: Option<Layout>,
    /// Colours.
    pub theme: Option<Theme>,
    /// What a unit of time is called.
    pub time_unit: Option<TimeUnit>,
    /// Objects shown besides the default ones.
    pub show: Vec<String>,
    /// Objects hidden.
    pub hide: Vec<String>,
    /// Whether names are written beside things.
    pub labels: Option<bool>,
    /// Factor on text and lines.
    pub font_scale: Option<f64>,
    /// Whether the clock slows round each flip.
    pub slow_at_flip: Option<bool>,
    /// Direction of both cameras round the vertical (degrees).
    pub azimuth_deg: Option<f64>,
    /// Height of both cameras above the horizon (degrees).
    pub elevation_deg: Option<f64>,
    /// Distance of both cameras, a factor on the one that frames everything.
    pub distance: Option<f64>,
    /// The camera of the world alone; what it leaves out is as for both.
    pub world_camera: CameraFile,
    /// The camera of momentum space alone, likewise.
    pub body_camera: CameraFile,
}

/// A camera of one space.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CameraFile {
    /// Direction round the vertical (degrees).
    pub azimuth_deg: Option<f64>,
    /// Height above the horizon (degrees).
    pub elevation_deg: Option<f64>,
    /// Distance, a factor on the one that frames everything.
    pub distance: Option<f64>,
    /// The point looked at: in the world the body is about 1 large, in momentum space the sphere has radius 1.
    pub target: Option<[f64; 3]>,
}

impl Default for SolidFile {
    /// A solid of water at the origin, still without a size.
    fn default() -> Self {
        Self { kind: PartKind::Box, size: [0.0; 3], position: [0.0; 3], rotation_deg: [0.0; 3], density: 1000.0 }
    }
}
