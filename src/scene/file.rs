//! A scene as it is written in TOML.

use serde::{Deserialize, Serialize};

use super::{Layout, PartKind, SceneError, Theme, nearest};

/// A scene file. Every part may be left out; [`super::Scene::check`] says what then holds.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct SceneFile {
    /// Name of the slide, in a few words.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub title: String,
    /// Two or three sentences.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub text: String,
    /// A question to the class.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub question: String,
    /// Place among the presets, ascending.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub order: Option<i64>,
    /// The body.
    pub body: BodyFile,
    /// How it starts.
    pub spin: SpinFile,
    /// How it is followed.
    pub motion: MotionFile,
    /// How it is looked at.
    pub view: ViewFile,
}

/// The body: just one of `box`, `moments`, `inertia`, `solids`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct BodyFile {
    /// Edges (m) of a solid box along the body's axes.
    #[serde(rename = "box", skip_serializing_if = "Option::is_none")]
    pub edges: Option<[f64; 3]>,
    /// Mass (kg) of the box; 1 where left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mass: Option<f64>,
    /// Principal moments (kg m²) in the order of the body's axes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub moments: Option<[f64; 3]>,
    /// Inertia tensor (kg m²) as xx, yy, zz, xy, xz, yz.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub inertia: Option<[f64; 6]>,
    /// What is drawn of a body given by `moments` or `inertia`: the solid of this form that has them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub form: Option<PartKind>,
    /// Solids that move as one.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub solids: Vec<SolidFile>,
}

/// A solid of uniform density.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SolidFile {
    /// Its form.
    pub kind: PartKind,
    /// Full extents (m) along its own axes; a cylinder's are its diameter twice and its length.
    pub size: [f64; 3],
    /// Where its centre is (m); the origin where left out.
    #[serde(default)]
    pub position: [f64; 3],
    /// How it is turned from the body's axes: a rotation vector (degrees).
    #[serde(default)]
    pub rotation_deg: [f64; 3],
    /// Density (kg/m³); that of water where left out.
    #[serde(default = "water")]
    pub density: f64,
}

fn water() -> f64 {
    1000.0
}

/// The start: either `omega` or `axis`, `tilt_deg`, `rate`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct SpinFile {
    /// Body angular velocity (rad/s) in the body frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub omega: Option<[f64; 3]>,
    /// Principal axis spun about: 1 has the smallest moment, 3 the largest.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub axis: Option<u8>,
    /// Angle (degrees) from that axis towards the next (1 → 2 → 3 → 1).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tilt_deg: Option<f64>,
    /// Angular speed (rad/s).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rate: Option<f64>,
    /// Attitude at the start, a quaternion w, x, y, z (made unit); the identity where left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub attitude: Option<[f64; 4]>,
}

/// How the motion is followed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct MotionFile {
    /// Name of a method.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub method: Option<String>,
    /// Step (s).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub step: Option<f64>,
    /// Names of the methods run beside it from the same start.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub compare: Vec<String>,
}

/// How it is looked at.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct ViewFile {
    /// `both`, `world` or `body`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub layout: Option<Layout>,
    /// `dark` or `light`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub theme: Option<Theme>,
    /// Objects shown besides the default ones.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub show: Vec<String>,
    /// Objects hidden.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub hide: Vec<String>,
    /// Whether names are written beside things.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub labels: Option<bool>,
    /// Factor on text and lines.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub font_scale: Option<f64>,
    /// Camera's direction round the vertical (degrees).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub azimuth: Option<f64>,
    /// Camera's height above the horizon (degrees).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub elevation: Option<f64>,
    /// Camera's distance, a factor on the one that frames everything.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub distance: Option<f64>,
    /// The camera of the world alone: azimuth and elevation (degrees), distance as above, and the point looked at.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub world_camera: Option<[f64; 6]>,
    /// The camera of momentum space alone, likewise.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body_camera: Option<[f64; 6]>,
}

impl SceneFile {
    /// Reads TOML.
    ///
    /// # Errors
    /// Text that is no TOML, a value of the wrong type, or an unknown key: one sentence with the line and, for a
    /// key, the nearest known one.
    pub fn parse(text: &str) -> Result<Self, SceneError> {
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        toml::from_str(text).map_err(|error| {
            let line = error.span().map_or(1, |span| {
                let before = text.get(..span.start).unwrap_or(text);
                before.matches('\n').count() + 1
            });
            SceneError::Text { line, message: one_sentence(error.message()) }
        })
    }

    /// Writes TOML that reads back to the same scene.
    ///
    /// # Errors
    /// None for a scene that was read or checked.
    pub fn to_toml(&self) -> Result<String, SceneError> {
        toml::to_string(self).map_err(|error| SceneError::Text { line: 0, message: error.to_string() })
    }
}

/// Turns serde's "unknown field `x`, expected one of `a`, `b`" into the nearest known key, and joins other messages
/// into one line.
fn one_sentence(message: &str) -> String {
    let mut quoted = message.split('`').skip(1).step_by(2);
    if message.starts_with("unknown field")
        && let Some(given) = quoted.next()
    {
        let known: Vec<&str> = quoted.collect();
        return match nearest(given, known.iter().copied()) {
            Some(name) => format!("unknown key `{given}`; the nearest known key is `{name}`"),
            None => format!("unknown key `{given}`; known here are {}", known.join(", ")),
        };
    }
    // Serde names the types of the code; a reader knows those of the file.
    let known = [("f64", "a number"), ("u8", "a whole number"), ("i64", "a whole number"), ("a sequence", "an array")];
    let message = message.split_whitespace().collect::<Vec<_>>().join(" ");
    let Some((given, expected)) = message.rsplit_once("expected ") else { return message };
    match known.into_iter().find(|(name, _)| expected == *name) {
        Some((_, words)) => format!("{given}expected {words}"),
        None if expected.starts_with("struct ") => format!("{given}expected a table"),
        None => message,
    }
}
