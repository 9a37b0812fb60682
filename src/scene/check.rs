//! A scene checked: the body and its start worked out, every refusal in one sentence.

use std::collections::BTreeSet;

use glam::{DMat3, DQuat, DVec3};

use super::step::steps;
use super::value::shortened;
use super::{CameraFile, Cloud, Part, PartKind, SceneFile, SpinFile, StepFile, View, ViewFile, parts};
use crate::physics::{
    self, Body, BodyError, METHODS, Method, State,
    methods::{DEFAULT_METHOD, LOSS_METHOD},
    number, so3,
    solids::SolidError,
};

/// Step (s) of a scene that names none.
const DEFAULT_STEP: f64 = 0.001;
/// Slowest and fastest that time runs.
pub const SPEEDS: (f64, f64) = (1.0 / 64.0, 8.0);
/// What is refused of the cameras.
pub(super) const WORLD_CAMERA: [&str; 4] = [
    "azimuth of the world's camera",
    "elevation of the world's camera",
    "distance of the world's camera",
    "target of the world's camera",
];
pub(super) const BODY_CAMERA: [&str; 4] = [
    "azimuth of momentum space's camera",
    "elevation of momentum space's camera",
    "distance of momentum space's camera",
    "target of momentum space's camera",
];
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
    /// Energy lost inside the body at constant L: `c = loss/ℓ` in `Ω_eff = Ω + c M×Ω`; 0 for none.
    pub energy_loss: f64,
    /// Starts close together.
    pub cloud: Cloud,
    /// How it is looked at.
    pub view: View,
    /// The step of its telling at which it stands, counted from 0; none where it is shown as a whole.
    pub at: Option<usize>,
}

/// Why a scene cannot be run. Each is one sentence with the value and what would be right.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SceneError {
    /// What is said over a scene is no flag of it, no `KEY=VALUE`.
    #[error("{0}")]
    NotTaken(String),
    /// A link that holds no scene.
    #[error("the link {0}")]
    NotALink(String),
    /// The text is no scene.
    #[error("line {line}: {message}")]
    NotAScene {
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
    NotABody(#[from] BodyError),
    /// Sizes and masses each in the range of numbers, with a moment that is not.
    #[error("{what} has a moment of {} kg m², past the range of numbers: take lengths and masses nearer to 1", number(*.moment))]
    MomentOutOfRange {
        /// The body.
        what: String,
        /// Its moment (kg m²).
        moment: f64,
    },
    /// The solids make no body.
    #[error(transparent)]
    NotSolids(#[from] SolidError),
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
    NoSuchAxis(u8),
    /// No such step.
    #[error("step {given} does not exist: {}", steps(*.count))]
    NoSuchStep {
        /// The step asked for, counted from 1.
        given: usize,
        /// How many there are.
        count: usize,
    },
    /// A number out of its range.
    #[error("{name} {} is not valid: it must be {wanted}", number(*.value))]
    OutOfRange {
        /// Which number.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What would be right.
        wanted: &'static str,
    },
    /// An unknown name.
    #[error("{kind} `{}` is not known: {hint}", shortened(given))]
    UnknownName {
        /// What was named.
        kind: &'static str,
        /// The name given.
        given: String,
        /// The nearest known name, or all that are known.
        hint: String,
    },
    /// A method that knows no energy loss, where some is lost.
    #[error("method `{method}` does not know the energy loss of {}: only `{LOSS_METHOD}` does, so leave the method out, or set energy_loss to 0", number(*.loss))]
    KnowsNoLoss {
        /// The method.
        method: &'static str,
        /// The loss.
        loss: f64,
    },
    /// Momentum or energy past the range of f64.
    #[error("angular velocity {} rad/s with this body is beyond the range of numbers: take a smaller one", number(*.0))]
    TooFast(f64),
}

impl Scene {
    /// Checks a scene and works out its body and start, to be shown as a whole.
    ///
    /// # Errors
    /// See [`SceneError`].
    pub fn check(file: &SceneFile) -> Result<Self, SceneError> {
        Self::check_at(file, None)
    }

    /// The same, to be shown as it is at this step, counted from 0.
    ///
    /// # Errors
    /// See [`SceneError`].
    pub fn check_at(file: &SceneFile, at: Option<usize>) -> Result<Self, SceneError> {
        let count = file.steps.len();
        if let Some(step) = at.filter(|step| *step >= count) {
            return Err(SceneError::NoSuchStep { given: step.wrapping_add(1), count });
        }
        file.steps.iter().try_for_each(StepFile::check)?;
        check_view(&file.view)?;
        let (body, parts) = check_body(file)?;
        let start = check_start(file, &body)?;
        let energy_loss = not_negative("energy_loss", file.motion.energy_loss.unwrap_or(0.0))?;
        let usual = if energy_loss > 0.0 { LOSS_METHOD } else { DEFAULT_METHOD };
        let method = named_method(file.motion.method.as_deref().unwrap_or(usual))?;
        let mut compare = file.motion.compare.iter().map(|name| named_method(name)).collect::<Result<Vec<_>, _>>()?;
        // What is the body's own method is no ghost beside it, and what is named twice is one.
        let mut followed = BTreeSet::from([method.name]);
        compare.retain(|other| followed.insert(other.name));
        let knows_none = |method: &&&'static Method| energy_loss > 0.0 && method.name != LOSS_METHOD;
        if let Some(other) = std::iter::once(&method).chain(&compare).find(knows_none) {
            return Err(SceneError::KnowsNoLoss { method: other.name, loss: energy_loss });
        }
        let step = positive("step", file.motion.step.unwrap_or(DEFAULT_STEP))?;
        let (cloud, view) = (Cloud::check(file)?, check_view(&file.view_at(at))?);
        Ok(Self { file: file.clone(), body, parts, start, method, compare, step, energy_loss, cloud, view, at })
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
        return parts::of_box(edges, given.mass.unwrap_or(1.0));
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
    let tilt = spin.tilt_deg.unwrap_or(0.0);
    if !(-180.0..=180.0).contains(&tilt) {
        return Err(SceneError::OutOfRange { name: "tilt", value: tilt, wanted: "between -180 and 180 degrees" });
    }
    let rate = finite("rate", spin.rate.unwrap_or(1.0))?;
    let (along, towards) = match spin.axis.unwrap_or(2) {
        1 => (DVec3::X, DVec3::Y),
        2 => (DVec3::Y, DVec3::Z),
        3 => (DVec3::Z, DVec3::X),
        other => return Err(SceneError::NoSuchAxis(other)),
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
        return Err(SceneError::OutOfRange { name: "attitude", value: 0.0, wanted: "a quaternion that is not 0" });
    }
    let [w, x, y, z] = [w, x, y, z].map(|component| component / largest);
    Ok(DMat3::from_quat(DQuat::from_xyzw(x, y, z, w).normalize()))
}

fn check_view(view: &ViewFile) -> Result<View, SceneError> {
    let both = CameraFile {
        azimuth_deg: view.azimuth_deg,
        elevation_deg: view.elevation_deg,
        distance: view.distance,
        target: None,
    };
    check_camera(&both, ["azimuth", "elevation", "distance", "target"])?;
    check_camera(&view.world_camera, WORLD_CAMERA)?;
    check_camera(&view.body_camera, BODY_CAMERA)?;
    let font_scale = view.font_scale.unwrap_or(1.0);
    if !(0.25..=8.0).contains(&font_scale) {
        return Err(SceneError::OutOfRange { name: "font scale", value: font_scale, wanted: "between 0.25 and 8" });
    }
    Ok(View {
        layout: view.layout.unwrap_or_default(),
        theme: view.theme.unwrap_or_default(),
        time_unit: view.time_unit.unwrap_or_default(),
        show: view.show.clone(),
        hide: view.hide.clone(),
        labels: view.labels.unwrap_or(true),
        font_scale,
        slow_at_flip: view.slow_at_flip.unwrap_or(false),
        azimuth_deg: view.azimuth_deg,
        elevation_deg: view.elevation_deg,
        distance: view.distance,
        world_camera: view.world_camera,
        body_camera: view.body_camera,
    })
}

/// Checks a camera whose azimuth, elevation, distance and target have these names.
pub(super) fn check_camera(camera: &CameraFile, names: [&'static str; 4]) -> Result<(), SceneError> {
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

pub(super) fn finite(name: &'static str, value: f64) -> Result<f64, SceneError> {
    if value.is_finite() { Ok(value) } else { Err(SceneError::OutOfRange { name, value, wanted: "a finite number" }) }
}

fn positive(name: &'static str, value: f64) -> Result<f64, SceneError> {
    if value.is_finite() && value > 0.0 {
        Ok(value)
    } else {
        Err(SceneError::OutOfRange { name, value, wanted: "finite and above 0" })
    }
}

fn not_negative(name: &'static str, value: f64) -> Result<f64, SceneError> {
    if value.is_finite() && value >= 0.0 {
        Ok(value)
    } else {
        Err(SceneError::OutOfRange { name, value, wanted: "finite and not negative" })
    }
}

fn named_method(name: &str) -> Result<&'static Method, SceneError> {
    physics::method(name)
        .ok_or_else(|| SceneError::unknown_name("method", name, METHODS.iter().map(|method| method.name)))
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, DVec3};

    use super::{DEFAULT_EDGES, Scene, SceneError};
    use crate::physics::so3;
    use crate::scene::{Layout, PartKind, SceneFile, Theme};

    fn check(text: &str) -> Result<Scene, SceneError> {
        Scene::check(&SceneFile::parse(text)?)
    }

    fn near(one: DVec3, other: DVec3) -> bool {
        // Three products and sums of numbers up to their length.
        (one - other).length() <= 8.0 * f64::EPSILON * other.length()
    }

    #[test]
    fn what_a_scene_leaves_out_is_as_promised() -> Result<(), SceneError> {
        let scene = check("")?;
        assert_eq!((scene.method.name, scene.step, scene.compare.len()), ("exact-step", 0.001, 0));
        let part = scene.parts.first().map(|part| (part.kind, part.size, part.centre, part.body_from_part));
        let edges = DVec3::from_array(DEFAULT_EDGES);
        assert_eq!(part, Some((PartKind::Box, edges, DVec3::ZERO, DMat3::IDENTITY)));
        // m/12 (b² + c²) of 1 kg, and 1 rad/s about the middle axis.
        let middle = (edges.x * edges.x + edges.z * edges.z) / 12.0;
        assert!(near(scene.start.body_momentum, DVec3::new(0.0, middle, 0.0)), "{}", scene.start.body_momentum);
        assert_eq!(scene.start.world_from_body, DMat3::IDENTITY);
        let view = &scene.view;
        assert_eq!((view.layout, view.theme, view.labels, view.font_scale), (Layout::Both, Theme::Dark, true, 1.0));
        assert!(scene.warnings().is_empty());
        Ok(())
    }

    #[test]
    fn a_body_is_what_its_key_says() -> Result<(), SceneError> {
        let inertia = |text: &str| check(text).map(|scene| scene.body.inertia());
        assert_eq!(
            inertia("body = { box = [1, 2, 3], mass = 12 }")?,
            DMat3::from_diagonal(DVec3::new(13.0, 10.0, 5.0))
        );
        assert_eq!(inertia("body.moments = [3, 1, 2]")?, DMat3::from_diagonal(DVec3::new(3.0, 1.0, 2.0)));
        let tensor = [4.0, 0.1, 0.2, 0.1, 5.0, 0.3, 0.2, 0.3, 6.0];
        assert_eq!(inertia("body.inertia = [4, 5, 6, 0.1, 0.2, 0.3]")?, DMat3::from_cols_array(&tensor));
        let scene = check("body.solids = [{ kind = 'box', size = [1, 2, 3], density = 2 }]")?;
        assert_eq!(scene.body.inertia(), DMat3::from_diagonal(DVec3::new(13.0, 10.0, 5.0)));
        let form = |text: &str| check(text).map(|scene| scene.parts.iter().map(|part| part.kind).collect::<Vec<_>>());
        assert_eq!(form("body = { moments = [1, 1, 1], form = 'ellipsoid' }")?, [PartKind::Ellipsoid]);
        assert_eq!(form("body.moments = [1, 1, 1]")?, [PartKind::Box]);
        Ok(())
    }

    #[test]
    fn a_spin_is_about_its_axis_and_tilts_towards_the_next() -> Result<(), SceneError> {
        // The axes of the body are its principal axes, but not in their order: 2 is along x, 3 along y, 1 along z.
        let axes = [DVec3::Z, DVec3::X, DVec3::Y];
        for (axis, tilt) in
            [(1, 0.0_f64), (2, 0.0), (3, 0.0), (1, 30.0), (2, -30.0), (3, 150.0), (2, 180.0), (2, -180.0)]
        {
            let text = format!("body.moments = [2, 3, 1]\nspin = {{ axis = {axis}, tilt_deg = {tilt:?}, rate = 4 }}");
            let scene = check(&text)?;
            let omega = scene.start.body_angular_velocity(&scene.body);
            let (along, towards) = (axes[axis - 1], axes[axis % 3]);
            let sign = if along.dot(scene.body.body_from_principal().col(axis - 1)) < 0.0 { -1.0 } else { 1.0 };
            let next = if towards.dot(scene.body.body_from_principal().col(axis % 3)) < 0.0 { -1.0 } else { 1.0 };
            let (sine, cosine) = tilt.to_radians().sin_cos();
            assert!(near(omega, 4.0 * (cosine * sign * along + sine * next * towards)), "{axis} {tilt}: {omega}");
        }
        let scene = check("body.moments = [2, 3, 1]\nspin.omega = [1, -2, 3]")?;
        assert!(near(scene.start.body_momentum, DVec3::new(2.0, -6.0, 3.0)));
        Ok(())
    }

    #[test]
    fn an_attitude_is_made_unit() -> Result<(), SceneError> {
        for attitude in ["[2, 0, 0, 2]", "[-0.1, 0, 0, -0.1]", "[1e300, 0, 0, 1e300]", "[1e-300, 0, 0, 1e-300]"] {
            let scene = check(&format!("spin.attitude = {attitude}"))?;
            // A quarter about z.
            let turned = so3::exp(DVec3::Z * std::f64::consts::FRAC_PI_2);
            assert!(so3::angle_between(scene.start.world_from_body, turned) < 8.0 * f64::EPSILON, "{attitude}");
        }
        let scene = check("spin.attitude = [1, 1, 1, 1]")?;
        assert!(near(scene.start.world_from_body * DVec3::X, DVec3::Y), "(x, y, z) goes to (y, z, x)");
        Ok(())
    }

    #[test]
    fn methods_are_found_and_none_is_its_own_ghost() -> Result<(), SceneError> {
        let scene = check("motion = { method = 'buss', step = 0.5, compare = ['rk4', 'buss', 'lie-euler'] }")?;
        assert_eq!((scene.method.name, scene.step), ("buss", 0.5));
        assert_eq!(scene.compare.iter().map(|method| method.name).collect::<Vec<_>>(), ["rk4", "lie-euler"]);
        assert_eq!(scene.file.motion.compare.len(), 3);
        Ok(())
    }

    #[test]
    fn losses_that_cannot_be_are_refused() {
        for (text, sentence) in [
            ("motion.energy_loss = -0.1", "energy_loss -0.1 is not valid: it must be finite and not negative"),
            ("motion.energy_loss = inf", "energy_loss inf is not valid: it must be finite and not negative"),
            (
                "motion = { energy_loss = 0.02, method = 'closed-form' }",
                "method `closed-form` does not know the energy loss of 0.02: only `magnus4` does, so leave the method out, or set energy_loss to 0",
            ),
            (
                "motion = { energy_loss = 0.02, compare = ['magnus4', 'rk4'] }",
                "method `rk4` does not know the energy loss of 0.02: only `magnus4` does, so leave the method out, or set energy_loss to 0",
            ),
        ] {
            let said = check(text).map_or_else(|error| error.to_string(), |_| "no refusal".to_owned());
            assert_eq!(said, sentence, "{text}");
        }
    }

    #[test]
    fn where_energy_is_lost_the_method_that_knows_it_follows() -> Result<(), SceneError> {
        let scene = check("motion.energy_loss = 0.02")?;
        assert_eq!((scene.method.name, scene.energy_loss), ("magnus4", 0.02));
        let scene = check("motion = { energy_loss = 0.5, compare = ['magnus4'] }")?;
        assert_eq!((scene.method.name, scene.compare.len()), ("magnus4", 0));
        for none in ["motion = { energy_loss = 0, method = 'buss', compare = ['rk4'] }", "motion.method = 'magnus4'"] {
            assert_eq!(check(none)?.energy_loss, 0.0);
        }
        Ok(())
    }

    #[test]
    fn a_view_is_as_it_is_said() -> Result<(), SceneError> {
        let text = "[view]\nlayout = 'body'\ntheme = 'light'\nshow = ['a']\nhide = ['b']\nlabels = false\nfont_scale = 8\n\
                    azimuth_deg = -1\nelevation_deg = 2\ndistance = 3\nworld_camera.distance = 4\nbody_camera.distance = 5\ntime_unit = 'd'";
        let scene = check(text)?;
        let (view, file) = (&scene.view, &scene.file.view);
        assert_eq!((view.layout, view.theme, view.labels, view.font_scale), (Layout::Body, Theme::Light, false, 8.0));
        assert_eq!((&view.show, &view.hide), (&file.show, &file.hide));
        assert_eq!((view.azimuth_deg, view.elevation_deg, view.distance), (Some(-1.0), Some(2.0), Some(3.0)));
        assert_eq!((view.world_camera, view.body_camera), (file.world_camera, file.body_camera));
        assert_eq!((view.time_unit.sign(), check("")?.view.time_unit.sign()), ("d", "s"));
        assert!(check("view.font_scale = 0.25").is_ok());
        Ok(())
    }

    #[test]
    fn what_cannot_be_run_is_refused_in_one_sentence() {
        for (text, sentence) in [
            (
                "body = { box = [1, 1, 1], moments = [1, 1, 1] }",
                "the body is given by box and moments at once: give one of box, moments, inertia, solids",
            ),
            (
                "body = { inertia = [1, 1, 1, 0, 0, 0], solids = [{ kind = 'box', size = [1, 1, 1] }] }",
                "the body is given by inertia and solids at once: give one of box, moments, inertia, solids",
            ),
            (
                "body = { moments = [1, 1, 1], mass = 2.5 }",
                "mass 2.5 kg goes with a box only: moments, inertia and solids hold the mass already",
            ),
            (
                "body.box = [1, 1e-300, -1e-300]",
                "edge -1e-300 m is not a length: every edge must be finite and above 0",
            ),
            (
                "body.box = [1e-200, 1e-200, 2e-200]",
                "a box of 1e-200 x 1e-200 x 2e-200 m and 1 kg has a moment of 0 kg m², past the range of numbers: take lengths and masses nearer to 1",
            ),
            ("body.mass = 0", "mass 0 kg is not a mass: it must be finite and above 0"),
            (
                "body.moments = [1, nan, 2]",
                "moment NaN kg m² is not a moment of inertia: every moment must be finite and above 0",
            ),
            (
                "body.solids = [{ kind = 'cylinder', size = [1, 2, 3] }]",
                "a cylinder's size 1 x 2 is not round: its first two extents are its diameter, twice the same",
            ),
            (
                "body.solids = [{ kind = 'box', size = [1, 2, 3], rotation_deg = [1, inf, 0] }]",
                "rotation_deg inf is not valid: it must be a finite number",
            ),
            (
                "body.solids = [{ kind = 'box', size = [1, 0, 3] }]",
                "0 m is not the size of a solid: it must be finite and above 0",
            ),
            (
                "spin = { omega = [1, 2, 3], tilt_deg = 1 }",
                "the spin is given by omega and by tilt_deg at once: give omega, or axis with tilt and rate",
            ),
            (
                "spin = { omega = [1, 2, 3], axis = 1 }",
                "the spin is given by omega and by axis at once: give omega, or axis with tilt and rate",
            ),
            (
                "spin = { omega = [1, 2, 3], rate = 1 }",
                "the spin is given by omega and by rate at once: give omega, or axis with tilt and rate",
            ),
            ("spin.omega = [1, -inf, 3]", "omega -inf is not valid: it must be a finite number"),
            ("spin.tilt_deg = 180.5", "tilt 180.5 is not valid: it must be between -180 and 180 degrees"),
            ("spin.tilt_deg = nan", "tilt NaN is not valid: it must be between -180 and 180 degrees"),
            ("spin.rate = inf", "rate inf is not valid: it must be a finite number"),
            (
                "spin.rate = 1e200",
                "angular velocity 1e200 rad/s with this body is beyond the range of numbers: take a smaller one",
            ),
            ("spin.attitude = [0, 0, -0.0, 0]", "attitude 0 is not valid: it must be a quaternion that is not 0"),
            ("spin.attitude = [1, 0, 0, inf]", "attitude inf is not valid: it must be a finite number"),
            ("motion.method = 'bus'", "method `bus` is not known: the nearest is `buss`"),
            ("motion.step = 0", "step 0 is not valid: it must be finite and above 0"),
            ("motion.step = inf", "step inf is not valid: it must be finite and above 0"),
            ("view.azimuth_deg = nan", "azimuth NaN is not valid: it must be a finite number"),
            ("view.elevation_deg = inf", "elevation inf is not valid: it must be a finite number"),
            ("view.distance = 0", "distance 0 is not valid: it must be finite and above 0"),
            ("view.font_scale = 0", "font scale 0 is not valid: it must be between 0.25 and 8"),
            ("view.font_scale = 0.24", "font scale 0.24 is not valid: it must be between 0.25 and 8"),
            ("view.font_scale = 8.1", "font scale 8.1 is not valid: it must be between 0.25 and 8"),
            (
                "view.world_camera.azimuth_deg = nan",
                "azimuth of the world's camera NaN is not valid: it must be a finite number",
            ),
            (
                "view.world_camera.distance = -1",
                "distance of the world's camera -1 is not valid: it must be finite and above 0",
            ),
            (
                "view.body_camera.elevation_deg = inf",
                "elevation of momentum space's camera inf is not valid: it must be a finite number",
            ),
            (
                "view.body_camera.target = [0, inf, 0]",
                "target of momentum space's camera inf is not valid: it must be a finite number",
            ),
        ] {
            let said = check(text).map_or_else(|error| error.to_string(), |_| "no refusal".to_owned());
            assert_eq!(said, sentence, "{text}");
        }
        let file =
            SceneFile { spin: crate::scene::SpinFile { axis: Some(4), ..Default::default() }, ..Default::default() };
        let said = "spin axis 4 does not exist: axes are 1 (smallest moment), 2 and 3 (largest)";
        assert_eq!(Scene::check(&file).map_err(|error| error.to_string()).err().as_deref(), Some(said));
    }
}
