//! The body's part of the panel: a box by its edges, any body by its moments, or the solids that the scene came with.

use egui::Ui;
use glam::{DMat3, DVec3};

use super::widgets::{NumberRow, choice, note, section};
use super::{Command, Look, numbers, style};
use crate::physics::{Body, so3};
use crate::scene::{BodyFile, PartKind, SolidFile};

/// Shortest and longest edge that the sliders reach (m).
const EDGES: (f64, f64) = (0.01, 0.5);
/// Longest edge (m) of a box that is made from moments.
const MADE_EDGE: f64 = 0.3;
/// Two bodies are the same where their tensors differ by less than the rounding of a few operations.
const SAME: f64 = 1e-13;

/// How the body is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Given {
    /// One box, turned or not.
    Edges,
    /// Moments, or the tensor of a body whose principal axes are turned.
    Moments,
    /// Solids that are no single box.
    Solids,
}

/// The body as a box, by its edges; as moments about its axes, or the principal ones; or as the solids it was opened with.
pub(super) fn show(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    section(ui, "Body");
    let given = given(&look.scene.file.body);
    let (replaces, kept) = replaced(look);
    let box_hint = format!("A solid box, by its edges: always a possible body. {replaces}{kept}");
    let moments_hint = format!("Any body, by its three principal moments of inertia. {kept}");
    let mut options =
        vec![(Given::Edges, "Box", box_hint.as_str()), (Given::Moments, "Moments", moments_hint.as_str())];
    let has_solids = [given, self::given(&look.opened.body)].contains(&Given::Solids);
    if has_solids {
        options.push((Given::Solids, "Solids", "The solids that the scene came with"));
    }
    if let Some(wanted) = choice(ui, Some(given), &options)
        && wanted != given
    {
        commands.push(Command::SetBody(Box::new(body_as(look, wanted))));
    }
    match given {
        Given::Edges => edges_ui(ui, look, commands),
        Given::Moments => moments_ui(ui, look, commands),
        Given::Solids => {
            note(ui, format!("{replaces}{kept}"));
            ratios(ui, look);
        }
    }
}

/// What a box would take the place of, and how that comes back.
fn replaced(look: &Look<'_>) -> (String, &'static str) {
    let body = &look.scene.file.body;
    let replaces = match (given(body), body.form) {
        (Given::Solids, _) if body.solids.len() == 1 => {
            "Takes the place of the solid, with the same moments. ".to_owned()
        }
        (Given::Solids, _) => {
            format!("One box or three moments take the place of these {} solids. ", body.solids.len())
        }
        (Given::Moments, Some(PartKind::Ellipsoid)) => "Takes the place of the ellipsoid. ".to_owned(),
        _ => String::new(),
    };
    let is_solids = given(&look.opened.body) == Given::Solids;
    (replaces, if is_solids { "“Solids” brings them back." } else { "" })
}

fn edges_ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let body = &look.scene.file.body;
    let mut edges = edges_of(body);
    let mut changed = false;
    for (edge, label) in edges.iter_mut().zip(["edge a", "edge b", "edge c"]) {
        let row = NumberRow {
            label,
            unit: " cm",
            range: (EDGES.0 * 100.0, EDGES.1 * 100.0),
            logarithmic: None,
            hint: "Edge of the solid box; three clearly different edges give three different moments",
        };
        let mut centimetres = *edge * 100.0;
        if row.ui(ui, &mut centimetres, commands).changed() {
            *edge = centimetres / 100.0;
            changed = true;
        }
    }
    ratios(ui, look);
    if changed {
        commands.push(Command::SetBody(Box::new(with_edges(body, edges))));
    }
}

fn ratios(ui: &mut Ui, look: &Look<'_>) {
    let moments = look.scene.body.principal_moments();
    let ratio = moments / moments.z;
    let [first, second] = [ratio.x, ratio.y].map(|part| numbers::significant(part, 3));
    note(ui, format!("I₁ : I₂ : I₃ = {} : {} : 1", numbers::trimmed(&first), numbers::trimmed(&second)));
}

fn moments_ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let (file, body) = (&look.scene.file.body, &look.scene.body);
    // A turned tensor is shown by what does not depend on the axes that it is written in.
    let (mut moments, labels) = match file.moments {
        Some(moments) => (moments, ["about x", "about y", "about z"]),
        None => (body.principal_moments().to_array(), ["I₁", "I₂", "I₃"]),
    };
    let largest = moments.iter().copied().fold(0.0, f64::max);
    // Only the ratios of the moments matter for the motion: the sliders' range follows their size.
    let (unit, per_unit) = if largest < 1.0 { (" g m²", 1e3) } else { (" kg m²", 1.0) };
    let scale = 10f64.powi((largest * per_unit).log10().ceil() as i32);
    let mut changed = false;
    for (moment, label) in moments.iter_mut().zip(labels) {
        let row = NumberRow {
            label,
            unit,
            range: (0.01 * scale, scale),
            logarithmic: None,
            hint: "Moment of inertia about this axis of the body",
        };
        let mut shown = *moment * per_unit;
        if row.ui(ui, &mut shown, commands).changed() {
            *moment = shown / per_unit;
            changed = true;
        }
    }
    if let Some(ratio) = body.triangle_excess() {
        let text = format!(
            "The largest moment is {ratio:.2} times the sum of the other two. No solid reaches past 1; \
             the equations do not mind."
        );
        ui.label(egui::RichText::new(text).small().color(style::warning(ui.visuals().dark_mode)));
    } else {
        note(ui, "A solid: none exceeds the sum of the other two.");
    }
    if changed {
        commands.push(Command::SetBody(Box::new(with_moments(file, body, moments))));
    }
}

fn given(body: &BodyFile) -> Given {
    match body.solids.as_slice() {
        [] if body.moments.is_some() || body.inertia.is_some() => Given::Moments,
        [] => Given::Edges,
        [only] if only.kind == PartKind::Box => Given::Edges,
        _ => Given::Solids,
    }
}

/// The edges (m) of a body that is given as one box.
fn edges_of(body: &BodyFile) -> [f64; 3] {
    let turned = body.solids.first().map(|solid| solid.size);
    turned.or(body.edges).unwrap_or(crate::scene::DEFAULT_EDGES)
}

/// The same box with other edges (m): mass or density, turn and place stay.
fn with_edges(body: &BodyFile, edges: [f64; 3]) -> BodyFile {
    match body.solids.as_slice() {
        [only] => BodyFile { solids: vec![SolidFile { size: edges, ..only.clone() }], ..body.clone() },
        _ => BodyFile { edges: Some(edges), ..body.clone() },
    }
}

/// The same body with other moments; its axes stay as they are turned.
fn with_moments(file: &BodyFile, body: &Body, moments: [f64; 3]) -> BodyFile {
    if file.moments.is_some() {
        return BodyFile { moments: Some(moments), ..file.clone() };
    }
    let axes = body.body_from_principal();
    let tensor = axes * DMat3::from_diagonal(DVec3::from_array(moments)) * axes.transpose();
    BodyFile { inertia: Some(entries(tensor)), ..file.clone() }
}

/// The entries xx, yy, zz, xy, xz, yz of a tensor.
fn entries(tensor: DMat3) -> [f64; 6] {
    let [x, y, z] = [tensor.x_axis, tensor.y_axis, tensor.z_axis];
    [x.x, y.y, z.z, y.x, z.x, z.y]
}

/// The body given another way: as the scene was opened, where that is the same body or the only one of its kind; else worked out.
fn body_as(look: &Look<'_>, wanted: Given) -> BodyFile {
    let opened = &look.opened.body;
    if given(opened) == wanted && (wanted == Given::Solids || is_same(look)) {
        return opened.clone();
    }
    match wanted {
        Given::Solids => look.scene.file.body.clone(),
        Given::Edges => box_of(&look.scene.body, opened.mass.unwrap_or(1.0)),
        Given::Moments => moments_of(&look.scene.body),
    }
}

/// Whether the body now has the inertia of the one that was opened.
fn is_same(look: &Look<'_>) -> bool {
    let Ok(scene) = crate::scene::Scene::check(look.opened) else { return false };
    let (now, then) = (entries(look.scene.body.inertia()), entries(scene.body.inertia()));
    let largest = then.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
    now.iter().zip(then).all(|(a, b)| (a - b).abs() <= SAME * largest)
}

/// The solid box with a body's moments, turned as its principal axes are: of this mass (kg) where its edges are then handy.
fn box_of(body: &Body, mass: f64) -> BodyFile {
    let of_mass = body.equivalent_box(mass);
    let is_handy = (EDGES.0..=EDGES.1).contains(&of_mass.max_element());
    // Moments go with mass times length squared.
    let factor = if is_handy { 1.0 } else { of_mass.max_element() / MADE_EDGE };
    let edges = (of_mass / factor).max(DVec3::splat(EDGES.0.min(0.02 * MADE_EDGE)));
    let mass = mass * factor * factor;
    let axes = body.body_from_principal();
    let is_aligned = axes.to_cols_array().iter().all(|entry| [0.0, 1.0, -1.0].contains(entry));
    if is_aligned {
        return BodyFile { edges: Some((axes * edges).abs().to_array()), mass: Some(mass), ..BodyFile::default() };
    }
    let solid = SolidFile {
        kind: PartKind::Box,
        size: edges.to_array(),
        position: [0.0; 3],
        rotation_deg: so3::log(axes).map(f64::to_degrees).to_array(),
        density: mass / edges.element_product(),
    };
    BodyFile { solids: vec![solid], ..BodyFile::default() }
}

/// A body by its moments about its own axes, or by its tensor where its principal axes are turned.
fn moments_of(body: &Body) -> BodyFile {
    let tensor = entries(body.inertia());
    if tensor[3..] == [0.0; 3] {
        return BodyFile { moments: Some([tensor[0], tensor[1], tensor[2]]), ..BodyFile::default() };
    }
    BodyFile { inertia: Some(tensor), ..BodyFile::default() }
}

#[cfg(test)]
mod tests {
    use super::{Given, box_of, entries, given, moments_of, with_edges, with_moments};
    use crate::physics::Body;
    use crate::scene::{BodyFile, Scene, SceneError, SceneFile};
    use glam::{DMat3, DVec3};

    /// Principal moments 1.33, 3.47 and 4.53 g m², turned about the axis of the largest.
    const TURNED: [f64; 6] =
        [0.002_034_038_446_641_534_3, 0.002_765_961_553_358_465_3, 0.004_53, -0.001_005_471_104_240_922, 0.0, 0.0];

    fn body_of(file: &BodyFile) -> Result<Body, SceneError> {
        Ok(Scene::check(&SceneFile { body: file.clone(), ..SceneFile::default() })?.body)
    }

    fn turned() -> BodyFile {
        BodyFile { inertia: Some(TURNED), ..BodyFile::default() }
    }

    /// Ten operations on numbers of the tensor's size.
    fn are_near(a: [f64; 6], b: [f64; 6]) -> bool {
        let largest = a.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
        a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-14 * largest)
    }

    #[test]
    fn a_turned_tensor_is_a_turned_box_of_the_same_tensor() -> Result<(), SceneError> {
        let body = body_of(&turned())?;
        let file = box_of(&body, 1.0);
        assert_eq!(given(&file), Given::Edges);
        let mut edges = super::edges_of(&file);
        edges.sort_by(f64::total_cmp);
        // Moments 1.33 : 3.47 : 4.53 are those of a box 30 : 17.9 : 6, to one in the last digit given.
        for (edge, wanted) in edges.into_iter().zip([6.0, 17.9, 30.0]) {
            assert!((30.0 * edge / edges[2] - wanted).abs() < 0.1, "{edge} {wanted}");
        }
        assert!(are_near(entries(body_of(&file)?.inertia()), TURNED));
        // An edge that is changed leaves the turn as it is.
        let longer = body_of(&with_edges(&file, [0.3, edges[1], edges[0]]))?;
        let turn = longer.body_from_principal().transpose() * body_of(&file)?.body_from_principal();
        let is_permutation = turn.to_cols_array().iter().all(|entry| entry.abs() < 1e-12 || entry.abs() > 1.0 - 1e-12);
        assert!(is_permutation, "{turn}");
        Ok(())
    }

    #[test]
    fn moments_of_a_turned_body_change_about_its_own_axes() -> Result<(), SceneError> {
        let body = body_of(&turned())?;
        assert_eq!(given(&turned()), Given::Moments);
        let changed = with_moments(&turned(), &body, [0.0015, 0.0035, 0.0045]);
        let after = body_of(&changed)?;
        assert!((after.principal_moments() - DVec3::new(0.0015, 0.0035, 0.0045)).length() < 1e-17);
        let turn = after.body_from_principal().transpose() * body.body_from_principal();
        assert!((turn - DMat3::IDENTITY).to_cols_array().iter().all(|entry| entry.abs() < 1e-13), "{turn}");
        assert_eq!(moments_of(&body).inertia, Some(TURNED));
        Ok(())
    }

    #[test]
    fn moments_along_the_axes_are_a_box_along_them() -> Result<(), SceneError> {
        let file = BodyFile { moments: Some([0.003, 0.002, 0.004]), ..BodyFile::default() };
        let body = body_of(&file)?;
        let as_box = box_of(&body, 1.0);
        assert!(as_box.solids.is_empty() && as_box.edges.is_some());
        assert!(are_near(entries(body_of(&as_box)?.inertia()), [0.003, 0.002, 0.004, 0.0, 0.0, 0.0]));
        assert_eq!(moments_of(&body).moments, Some([0.003, 0.002, 0.004]));
        Ok(())
    }
}
