//! A scene checked: the body and its start worked out, every refusal in one sentence.

use glam::{DMat3, DQuat, DVec3};

use super::value::shortened;
use super::{CameraFile, Part, PartKind, SceneFile, SpinFile, View, nearest, parts};
use crate::physics::{
    self, Body, BodyError, METHODS, Method, State, methods::DEFAULT_METHOD, number, so3, solids::SolidError,
};

/// Step (s) of a scene that names none.
const DEFAULT_STEP: f64 = 0.001;
/// Edges (m) of the body of a scene that names none.
pub const DEFAULT_EDGES: [f64; 3] = [0.2, 0.12, 0.04];

/// A scene that can be run.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The text that it came from, with every change since.
    pub file: SceneFile,
    /// The body.
    pub body: Body,
    /// What the body looks like.
    pub parts: Vec<Part>,
    /// Attitude and momentum at time 0.
    pub start: State,
    /// The method that follows the motion.
    pub method: &'static Method,
    /// Methods that run beside it from the same start.
    pub compare: Vec<&'static Method>,
    /// Step (s).
    pub step: f64,
    /// How it is looked at.
    pub view: View,
}

/// Why a scene cannot be run. Each is one sentence with the value and what would be right.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SceneError {
    /// What is said over a scene is no flag of it, no `KEY=VALUE`.
    #[error("{0}")]
    Edit(String),
    /// A link that holds no scene.
    #[error("the link {0}")]
    Link(String),
    /// The text is no scene.
    #[error("line {line}: {message}")]
    Text {
        /// Line of the text, from 1.
        line: usize,
        /// What is wrong with it.
        message: String,
    },
    /// The text could not be had.
    #[error("{0}")]
    Unreadable(String),
    /// The body is no body.
    #[error(transparent)]
    Body(#[from] BodyError),
    /// The solids make no body.
    #[error(transparent)]
    Solid(#[from] SolidError),
    /// A cylinder that is not round.
    #[error("a cylinder's size {} x {} is not round: its first two extents are its diameter, twice the same", number(*.0), number(*.1))]
    NotRound(f64, f64),
    /// More than one description of the body.
    #[error("the body is given by {0} at once: give one of box, moments, inertia, solids")]
    TwoBodies(String),
    /// A mass with a body that is not a box.
    #[error("mass {} kg goes with a box only: moments, inertia and solids hold the mass already", number(*.0))]
    MassWithoutBox(f64),
    /// Two descriptions of the spin.
    #[error("the spin is given by omega and by {0} at once: give omega, or axis with tilt and rate")]
    TwoSpins(&'static str),
    /// No such axis.
    #[error("spin axis {0} does not exist: axes are 1 (smallest moment), 2 and 3 (largest)")]
    Axis(u8),
    /// A number out of its range.
    #[error("{name} {} is not valid: it must be {wanted}", number(*.value))]
    Number {
        /// Which number.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What would be right.
        wanted: &'static str,
    },
    /// An unknown name.
    #[error("{kind} `{}` is not known: {hint}", shortened(given))]
    Unknown {
        /// What was named.
        kind: &'static str,
        /// The name given.
        given: String,
        /// The nearest known name, or where to find them.
        hint: String,
    },
    /// Momentum or energy past the range of f64.
    #[error("angular velocity {} rad/s with this body is beyond the range of numbers: take a smaller one", number(*.0))]
    TooFast(f64),
}

impl Scene {
    /// Checks a scene and works out its body and start.
    ///
    /// # Errors
    /// See [`SceneError`].
    pub fn check(file: &SceneFile) -> Result<Self, SceneError> {
        let (body, parts) = check_body(file)?;
        let start = check_start(file, &body)?;
        let method = named_method(file.motion.method.as_deref().unwrap_or(DEFAULT_METHOD))?;
        let mut compare = file.motion.compare.iter().map(|name| named_method(name)).collect::<Result<Vec<_>, _>>()?;
        // What is the body's own method is no ghost beside it.
        compare.retain(|other| other.name != method.name);
        let step = positive("step", file.motion.step.unwrap_or(DEFAULT_STEP))?;
        Ok(Self { file: file.clone(), body, parts, start, method, compare, step, view: check_view(file)? })
    }

    /// What is unusual about a scene that can all the same be run: a sentence each.
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        let excess = self.body.triangle_excess().map(|ratio| {
            let i = self.body.principal_moments();
            format!(
                "moments {}, {}, {}: the largest is {ratio:.3} times the sum of the others and no solid has such moments; it goes on all the same",
                number(i.x),
                number(i.y),
                number(i.z)
            )
        });
        excess.into_iter().collect()
    }
}

fn check_body(file: &SceneFile) -> Result<(Body, Vec<Part>), SceneError> {
    let given = &file.body;
    let names = [
        ("box", given.edges.is_some()),
        ("moments", given.moments.is_some()),
        ("inertia", given.inertia.is_some()),
        ("solids", !given.solids.is_empty()),
    ];
    let names: Vec<&str> = names.into_iter().filter_map(|(name, is_given)| is_given.then_some(name)).collect();
    if names.len() > 1 {
        return Err(SceneError::TwoBodies(names.join(" and ")));
    }
    let is_box = names.is_empty() || given.edges.is_some();
    if let (Some(mass), false) = (given.mass, is_box) {
        return Err(SceneError::MassWithoutBox(mass));
    }
    if !given.solids.is_empty() {
        return parts::of_solids(&given.solids);
    }
    if is_box {
        let edges = DVec3::from_array(given.edges.unwrap_or(DEFAULT_EDGES));
        let body = Body::solid_box(edges, given.mass.unwrap_or(1.0))?;
        return Ok((body, vec![Part::centred(PartKind::Box, edges, DMat3::IDENTITY)]));
    }
    let body = match (given.moments, given.inertia) {
        (_, Some([xx, yy, zz, xy, xz, yz])) => {
            Body::from_tensor(DMat3::from_cols_array(&[xx, xy, xz, xy, yy, yz, xz, yz, zz]))?
        }
        (moments, None) => Body::from_moments(DVec3::from_array(moments.unwrap_or_default()))?,
    };
    Ok((body, vec![parts::equivalent(&body, given.form.unwrap_or(PartKind::Box))]))
}

fn check_start(file: &SceneFile, body: &Body) -> Result<State, SceneError> {
    let spin = &file.spin;
    let world_from_body = check_attitude(spin.attitude)?;
    let (start, velocity) = if let Some(omega) = spin.omega {
        let also =
            [("axis", spin.axis.is_some()), ("tilt_deg", spin.tilt_deg.is_some()), ("rate", spin.rate.is_some())];
        if let Some((name, _)) = also.into_iter().find(|(_, is_given)| *is_given) {
            return Err(SceneError::TwoSpins(name));
        }
        for component in omega {
            finite("omega", component)?;
        }
        (State::new(body, world_from_body, DVec3::from_array(omega)), DVec3::from_array(omega))
    } else {
        let velocity = axis_spin(spin)?;
        (State::in_principal_frame(body, world_from_body, velocity), velocity)
    };
    if !(start.body_momentum.is_finite() && start.energy(body).is_finite()) {
        return Err(SceneError::TooFast(velocity.abs().max_element()));
    }
    Ok(start)
}

/// The angular velocity (rad/s) along the principal axes of a spin about one of them, tilted towards the next.
fn axis_spin(spin: &SpinFile) -> Result<DVec3, SceneError> {
    let tilt = finite("tilt", spin.tilt_deg.unwrap_or(0.0))?;
    if tilt.abs() > 180.0 {
        return Err(SceneError::Number { name: "tilt", value: tilt, wanted: "between -180 and 180 degrees" });
    }
    let rate = finite("rate", spin.rate.unwrap_or(1.0))?;
    let (along, towards) = match spin.axis.unwrap_or(2) {
        1 => (DVec3::X, DVec3::Y),
        2 => (DVec3::Y, DVec3::Z),
        3 => (DVec3::Z, DVec3::X),
        other => return Err(SceneError::Axis(other)),
    };
    let (sine, cosine) = so3::sine_and_cosine_of_degrees(tilt);
    Ok(rate * (cosine * along + sine * towards))
}

fn check_attitude(attitude: Option<[f64; 4]>) -> Result<DMat3, SceneError> {
    let Some([w, x, y, z]) = attitude else { return Ok(DMat3::IDENTITY) };
    for component in [w, x, y, z] {
        finite("attitude", component)?;
    }
    let largest = [w, x, y, z].into_iter().fold(0.0, |m: f64, c| m.max(c.abs()));
    if largest == 0.0 {
        return Err(SceneError::Number { name: "attitude", value: 0.0, wanted: "a quaternion that is not 0" });
    }
    let [w, x, y, z] = [w, x, y, z].map(|component| component / largest);
    Ok(DMat3::from_quat(DQuat::from_xyzw(x, y, z, w).normalize()))
}

fn check_view(file: &SceneFile) -> Result<View, SceneError> {
    let view = &file.view;
    let both = CameraFile {
        azimuth_deg: view.azimuth_deg,
        elevation_deg: view.elevation_deg,
        distance: view.distance,
        target: None,
    };
    check_camera(&both, ["azimuth", "elevation", "distance", "target"])?;
    check_camera(
        &view.world_camera,
        [
            "azimuth of the world's camera",
            "elevation of the world's camera",
            "distance of the world's camera",
            "target of the world's camera",
        ],
    )?;
    check_camera(
        &view.body_camera,
        [
            "azimuth of momentum space's camera",
            "elevation of momentum space's camera",
            "distance of momentum space's camera",
            "target of momentum space's camera",
        ],
    )?;
    let font_scale = positive("font scale", view.font_scale.unwrap_or(1.0))?;
    if !(0.25..=8.0).contains(&font_scale) {
        return Err(SceneError::Number { name: "font scale", value: font_scale, wanted: "between 0.25 and 8" });
    }
    Ok(View {
        layout: view.layout.unwrap_or_default(),
        theme: view.theme.unwrap_or_default(),
        show: view.show.clone(),
        hide: view.hide.clone(),
        labels: view.labels.unwrap_or(true),
        font_scale,
        azimuth_deg: view.azimuth_deg,
        elevation_deg: view.elevation_deg,
        distance: view.distance,
        world_camera: view.world_camera,
        body_camera: view.body_camera,
    })
}

/// Checks a camera whose azimuth, elevation, distance and target have these names.
fn check_camera(camera: &CameraFile, names: [&'static str; 4]) -> Result<(), SceneError> {
    let [azimuth, elevation, distance, target] = names;
    for (name, value) in [(azimuth, camera.azimuth_deg), (elevation, camera.elevation_deg)] {
        value.map_or(Ok(0.0), |value| finite(name, value))?;
    }
    for value in camera.target.into_iter().flatten() {
        finite(target, value)?;
    }
    camera.distance.map_or(Ok(1.0), |value| positive(distance, value))?;
    Ok(())
}

fn finite(name: &'static str, value: f64) -> Result<f64, SceneError> {
    if value.is_finite() { Ok(value) } else { Err(SceneError::Number { name, value, wanted: "a finite number" }) }
}

fn positive(name: &'static str, value: f64) -> Result<f64, SceneError> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(SceneError::Number { name, value, wanted: "finite and above 0" })
    }
}

fn named_method(name: &str) -> Result<&'static Method, SceneError> {
    physics::method(name).ok_or_else(|| SceneError::Unknown {
        kind: "method",
        given: name.to_owned(),
        hint: match nearest(name, METHODS.iter().map(|method| method.name)) {
            Some(near) => format!("the nearest is `{near}`"),
            None => "`dzhanibekov methods` lists them".to_owned(),
        },
    })
}
