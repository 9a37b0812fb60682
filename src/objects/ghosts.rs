//! The same start under other methods, beside the scene's own: each method has its colour, line and mark.

use super::{Context, body};
use crate::frame::{Color, Dash, Line, Mark, Point, Solid, View};
use crate::physics::{METHODS, Method, poinsot};
use crate::scene::Theme;

/// Colours by the place of a method in the table: near Okabe–Ito's, then two more.
const COLORS: [u32; 9] = [
    0x00e5_6a0c,
    0x00d6_86b4,
    0x0000_b080,
    0x0056_b4e9,
    0x00e6_b400,
    0x0030_80d0,
    0x00b0_98e8,
    0x00f0_e442,
    0x00a8_a8a8,
];
/// Opacity of a ghost's faces, reached where it lies this far from the body.
const OPACITY: f32 = 0.17;
const APART: f32 = 0.2;
/// Marks by the place of a method in the table: none is the disc of the scene's own M.
const MARKS: [Mark; 9] = [
    Mark::Square,
    Mark::TriangleDown,
    Mark::Diamond,
    Mark::Ring,
    Mark::Triangle,
    Mark::OpenDiamond,
    Mark::OpenSquare,
    Mark::Star,
    Mark::OpenTriangle,
];

/// How a method is drawn wherever it is a ghost.
#[must_use]
pub fn method_color(method: &Method, theme: Theme) -> Color {
    let color = Color::hex(COLORS[place(method) % COLORS.len()]);
    match theme {
        Theme::Dark => color,
        Theme::Light => color.mix(Color([0.0, 0.0, 0.0, 1.0]), 0.25),
    }
}

fn place(method: &Method) -> usize {
    METHODS.iter().position(|known| known.name == method.name).unwrap_or(0)
}

/// The pattern of its lines, lengths times this.
pub(super) fn dash(method: &Method, scale: f32) -> Dash {
    [Dash::Solid, Dash::Dashed(0.06 * scale), Dash::Dotted(0.035 * scale), Dash::Dashed(0.12 * scale)]
        [place(method) % 4]
}

pub(super) fn mark(method: &Method) -> Mark {
    MARKS[place(method) % MARKS.len()]
}

/// Translucent bodies.
pub(super) fn bodies(context: &Context<'_>, view: &mut View) {
    let own = body::mesh_of(context, context.simulation.state(), context.palette.faces);
    for ghost in context.simulation.ghosts() {
        let state = ghost.state();
        let color = method_color(ghost.method(), context.settings.theme);
        let mut mesh = body::mesh_of(context, state, [[color; 3]; 2]);
        // As long as it lies on the body itself a ghost leaves the body's own colours alone.
        let apart = mesh.vertices.iter().zip(&own.vertices).map(|(a, b)| a.position.distance(b.position));
        let apart = (apart.fold(0.0, f32::max) / APART).min(1.0);
        for vertex in &mut mesh.vertices {
            vertex.color = color.alpha(OPACITY * apart);
        }
        // A method that blows the body up is drawn until it leaves all bounds.
        if mesh.vertices.iter().all(|vertex| vertex.position.is_finite() && vertex.position.length() < 1e3) {
            view.solids.push(Solid { mesh, opaque: false });
            let before = view.lines.len();
            body::edges(context, state, view, color, 2.2);
            for line in &mut view.lines[before..] {
                line.dash = dash(ghost.method(), 1.0);
                line.hidden = 0.5 * apart;
            }
        }
    }
}

/// A mark each where M is, and the path that it would follow from here.
pub(super) fn marks(context: &Context<'_>, view: &mut View) {
    let body = context.simulation.body();
    for ghost in context.simulation.ghosts() {
        let method = ghost.method();
        let color = method_color(method, context.settings.theme);
        let momentum = ghost.state().body_momentum;
        let position = context.body_momentum(momentum);
        if !(position.is_finite() && position.length() < 10.0 && position.length() > 0.0) {
            continue;
        }
        let curve = poinsot::polhode(body, momentum, super::polhode::POINTS);
        let points = curve.into_iter().map(|m| context.body_momentum(m));
        view.lines.push(Line::new(points, 2.0, color.fade(0.8)).dashed(dash(method, 1.0)).through(0.3));
        let rim = context.palette.background;
        view.points.push(Point { position, size: 16.0, mark: mark(method), color, rim, hidden: 0.7, moves: true });
    }
}
