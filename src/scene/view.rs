//! How a scene is looked at.

use super::CameraFile;

/// Which of the two spaces the picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Layout {
    /// World and body side by side; one above the other where the picture is tall.
    #[default]
    Both,
    /// The body tumbling in the world, the angular momentum up.
    World,
    /// Momentum space in the body frame.
    Body,
}

/// Colours for a dark hall or for bright rooms and print.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// Light things on a dark background.
    #[default]
    Dark,
    /// Dark things on a light background.
    Light,
}

/// What a unit of the scene's time is called: the equations do not mind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TimeUnit {
    /// Seconds.
    #[default]
    Second,
    /// Days, as of a tumbling asteroid.
    Day,
}

impl TimeUnit {
    /// Its sign: s, d.
    #[must_use]
    pub fn sign(self) -> &'static str {
        match self {
            Self::Second => "s",
            Self::Day => "d",
        }
    }
}

/// The checked settings of a view.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// What a unit of time is called.
    pub time_unit: TimeUnit,
    /// Which spaces are shown.
    pub layout: Layout,
    /// Colours.
    pub theme: Theme,
    /// Objects shown although they are not by default.
    pub show: Vec<String>,
    /// Objects hidden although they are shown by default.
    pub hide: Vec<String>,
    /// Whether names are written beside things.
    pub labels: bool,
    /// Factor on the size of text and the width of lines.
    pub font_scale: f64,
    /// Whether the clock slows round each flip.
    pub slow_at_flip: bool,
    /// The camera's direction round the vertical (degrees), where the scene sets one.
    pub azimuth_deg: Option<f64>,
    /// The camera's height above the horizon (degrees), where the scene sets one.
    pub elevation_deg: Option<f64>,
    /// The camera's distance as a factor on the one that frames everything, where the scene sets one.
    pub distance: Option<f64>,
    /// The camera of the world alone: what it says goes before what is said of both.
    pub world_camera: CameraFile,
    /// The camera of momentum space alone, likewise.
    pub body_camera: CameraFile,
}
