//! A cloud of starts close together: round the stable axes it stays together, round the middle one it is drawn out.

use glam::Vec3;

use super::{Context, body};
use crate::frame::{Color, Dot, Note, Pane};
use crate::physics::Motion;
use crate::scene;

/// Largest and smallest dot (points), and what comes between: this over the root of their number.
const LARGEST: f32 = 5.0;
const SMALLEST: f32 = 2.4;
const GROUND: f32 = 150.0;
/// Bodies that are drawn of it, and how much one hides of what is behind.
const BODIES: usize = 6;
const OPACITY: f32 = 0.13;

/// The momentum of each start, as a point on the sphere in the colour of its axis.
pub(super) fn points(context: &Context<'_>, pane: &mut Pane) {
    let simulation = context.simulation;
    if context.unit_momentum().is_none() {
        return;
    }
    if simulation.energy_loss() > 0.0 {
        return caption(pane, context.palette.ink, "the cloud of starts knows no energy loss");
    }
    // The more there are, the smaller each.
    let size = (GROUND / (context.scene.cloud.count as f32).sqrt()).clamp(SMALLEST, LARGEST);
    let mut taken = Cells::default();
    let dots = simulation.cloud().momenta_at(simulation.time()).filter_map(|(axis, momentum)| {
        let position = context.body_momentum(momentum);
        taken.take(position).then_some(Dot { position, size, color: context.palette.axes[axis] })
    });
    pane.dots.extend(dots);
    caption(pane, context.palette.ink, &said(&context.scene.cloud));
}

/// What the cloud is, in words.
fn said(cloud: &scene::Cloud) -> String {
    let axes = match cloud.axes[..] {
        [one] => format!("axis {one}"),
        [one, other] => format!("axis {one} or {other}"),
        _ => "axis 1, 2 or 3".to_owned(),
    };
    // Of degrees that were radians, without the last digits.
    let spread = (cloud.spread.to_degrees() * 1e6).round() / 1e6;
    let starts = if cloud.count == 1 { "start" } else { "starts" };
    format!("{} {starts} within {spread}° of {axes}, all exact", cloud.count)
}

/// Cells of the sphere, smaller than a dot: of those in one cell only the first is drawn, for it hides the others.
struct Cells(Vec<u64>);

/// Cells along an edge of the cube round the sphere: a word holds 64 of them.
const CELLS: usize = 256;

impl Default for Cells {
    fn default() -> Self {
        Self(vec![0; 6 * CELLS * CELLS / 64])
    }
}

impl Cells {
    /// Takes the cell of a place; false where it was taken.
    fn take(&mut self, place: Vec3) -> bool {
        let axis = place.abs().max_position();
        let size = place[axis].abs();
        let step =
            |other: usize| (((0.5 + 0.5 * place[(axis + other) % 3] / size) * CELLS as f32) as usize).min(CELLS - 1);
        let face = 2 * axis + usize::from(place[axis] < 0.0);
        let cell = (face * CELLS + step(1)) * CELLS + step(2);
        let Some(word) = self.0.get_mut(cell / 64) else { return true };
        let bit = 1 << (cell % 64);
        let is_free = *word & bit == 0;
        *word |= bit;
        is_free
    }
}

/// A handful of the bodies that started so, seen through.
pub(super) fn bodies(context: &Context<'_>, pane: &mut Pane) {
    let simulation = context.simulation;
    if context.unit_momentum().is_none() || simulation.energy_loss() > 0.0 {
        return;
    }
    let color = context.palette.ink;
    for start in simulation.cloud().handful(BODIES) {
        let state = Motion::new(simulation.body(), &start).state(simulation.time());
        let faces = context.palette.faces.map(|side| side.map(|face: Color| face.alpha(OPACITY)));
        pane.meshes.push(body::mesh_of(context, &state, faces));
        let before = pane.lines.len();
        body::edges(context, &state, pane, color.alpha(0.5), 1.2);
        for line in &mut pane.lines[before..] {
            line.hidden = 0.3;
        }
    }
}

/// A line of words about something in the pane: what it is, or that it knows no energy loss where some is lost.
pub(super) fn caption(pane: &mut Pane, ink: Color, text: &str) {
    pane.notes.push(Note { text: text.to_owned(), size: 17.0, color: ink, swatch: None });
}
