//! The body's part of the panel: a box by its edges, or any body by its moments.

use egui::Ui;
use glam::DVec3;

use super::widgets::{NumberRow, choice, note, section};
use super::{Command, Look, numbers, style};
use crate::scene::{BodyFile, SceneFile};

/// Shortest and longest edge that the sliders reach (m).
const EDGES: (f64, f64) = (0.01, 0.5);
/// Longest edge (m) of a box that is made from moments.
const MADE_EDGE: f64 = 0.3;

/// How the body is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Given {
    Edges,
    Moments,
}

/// Shows it.
pub(super) fn show(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    section(ui, "Body");
    let file = &look.scene.file;
    let given = given(&file.body);
    let options = [
        (Given::Edges, "Box", "A solid box, by its edges: always a possible body"),
        (Given::Moments, "Moments", "Any body, by its three principal moments of inertia"),
    ];
    match choice(ui, given, &options) {
        Some(Given::Edges) if given != Some(Given::Edges) => edit(file, commands, edges_of(look)),
        Some(Given::Moments) if given != Some(Given::Moments) => edit(file, commands, moments_of(look)),
        _ => {}
    }
    if given == Some(Given::Moments) { moments_ui(ui, look, commands) } else { edges_ui(ui, look, commands) }
}

fn edges_ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let file = &look.scene.file;
    let shown = edges_of(look);
    let Some(mut edges) = shown.edges else { return };
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
        if row.ui(ui, &mut centimetres).changed() {
            *edge = centimetres / 100.0;
            changed = true;
        }
    }
    let moments = look.scene.body.principal_moments();
    let ratio = moments / moments.z;
    note(
        ui,
        format!(
            "I₁ : I₂ : I₃ = {} : {} : 1",
            numbers::trimmed(&numbers::significant(ratio.x, 3)),
            numbers::trimmed(&numbers::significant(ratio.y, 3))
        ),
    );
    if changed {
        edit(file, commands, BodyFile { edges: Some(edges), ..shown });
    }
}

fn moments_ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let file = &look.scene.file;
    let Some(mut moments) = moments_of(look).moments else { return };
    let largest = moments.iter().copied().fold(0.0, f64::max);
    // Only the ratios of the moments matter for the motion: the sliders' range follows their size.
    let (unit, per_unit) = if largest < 1.0 { (" g m²", 1e3) } else { (" kg m²", 1.0) };
    let scale = 10f64.powi((largest * per_unit).log10().ceil() as i32);
    let mut changed = false;
    for (moment, label) in moments.iter_mut().zip(["about x", "about y", "about z"]) {
        let row = NumberRow {
            label,
            unit,
            range: (0.01 * scale, scale),
            logarithmic: None,
            hint: "Moment of inertia about this axis of the body",
        };
        let mut shown = *moment * per_unit;
        if row.ui(ui, &mut shown).changed() {
            *moment = shown / per_unit;
            changed = true;
        }
    }
    if let Some(ratio) = look.scene.body.triangle_excess() {
        let text = format!(
            "The largest moment is {ratio:.2} times the sum of the other two. No solid reaches past 1; \
             the equations do not mind."
        );
        ui.label(egui::RichText::new(text).small().color(style::warning(ui.visuals().dark_mode)));
    } else {
        note(ui, "A solid: none exceeds the sum of the other two.");
    }
    if changed {
        edit(file, commands, BodyFile { moments: Some(moments), ..BodyFile::default() });
    }
}

fn given(body: &BodyFile) -> Option<Given> {
    if body.moments.is_some() {
        Some(Given::Moments)
    } else if body.inertia.is_none() {
        Some(Given::Edges)
    } else {
        None
    }
}

/// The body as a box: as the scene gives it, or the solid box of the same moments, of such a mass that its edges are handy.
fn edges_of(look: &Look<'_>) -> BodyFile {
    let body = &look.scene.file.body;
    if body.edges.is_some() {
        return body.clone();
    }
    let along_principal = look.scene.body.equivalent_box(1.0);
    let axes = look.scene.body.body_from_principal();
    let along_body = (axes * along_principal).abs();
    // Moments go with mass times length squared.
    let shrunk = along_body.max_element() / MADE_EDGE;
    let edges = (along_body / shrunk).clamp(DVec3::splat(EDGES.0), DVec3::splat(EDGES.1));
    BodyFile { edges: Some(edges.to_array()), mass: Some(shrunk * shrunk), ..BodyFile::default() }
}

/// The body by its moments about its own axes.
fn moments_of(look: &Look<'_>) -> BodyFile {
    let inertia = look.scene.body.inertia();
    let moments = look.scene.file.body.moments.unwrap_or([inertia.x_axis.x, inertia.y_axis.y, inertia.z_axis.z]);
    BodyFile { moments: Some(moments), ..BodyFile::default() }
}

fn edit(file: &SceneFile, commands: &mut Vec<Command>, body: BodyFile) {
    commands.push(Command::Edit(Box::new(SceneFile { body, ..file.clone() })));
}
