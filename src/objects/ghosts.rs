//! The same start under other methods, beside the scene's own: each method has its colour, line and mark.

use super::{Context, body};
use crate::frame::{Color, Dash, Line, Mark, Marker, Pane};
use crate::physics::{Method, methods, poinsot};
use crate::scene::Theme;

/// Opacity of a ghost's faces, reached where it lies this far from the body.
const OPACITY: f32 = 0.17;
const APART: f32 = 0.2;
/// Up to this opacity nothing changes by half of a level of 255.
const UNSEEN: f32 = 0.5 / 255.0;

/// How a method is drawn wherever it is a ghost.
#[must_use]
pub fn method_color(method: &Method, theme: Theme) -> Color {
    match theme {
        Theme::Dark => Color::hex(method.hue.on_dark),
        Theme::Light => Color::hex(method.hue.on_light),
    }
}

/// The pattern of its lines, lengths times this.
pub(super) fn dash(method: &Method, scale: f32) -> Dash {
    match method.dash {
        methods::Dash::Solid => Dash::Solid,
        methods::Dash::Short => Dash::Dashed(0.06 * scale),
        methods::Dash::Long => Dash::Dashed(0.12 * scale),
        methods::Dash::Dotted => Dash::Dotted(0.035 * scale),
    }
}

/// The form of its marks.
pub(super) fn mark(method: &Method) -> Mark {
    match method.mark {
        methods::Mark::Ring => Mark::Ring,
        methods::Mark::Diamond => Mark::Diamond,
        methods::Mark::Square => Mark::Square,
        methods::Mark::Triangle => Mark::Triangle,
        methods::Mark::TriangleDown => Mark::TriangleDown,
        methods::Mark::OpenSquare => Mark::OpenSquare,
        methods::Mark::OpenDiamond => Mark::OpenDiamond,
        methods::Mark::OpenTriangle => Mark::OpenTriangle,
        methods::Mark::OpenTriangleDown => Mark::OpenTriangleDown,
        methods::Mark::Star => Mark::Star,
        methods::Mark::Hourglass => Mark::Hourglass,
        methods::Mark::Bow => Mark::Bow,
        methods::Mark::Bars => Mark::Bars,
    }
}

/// Translucent bodies.
pub(super) fn bodies(context: &Context<'_>, pane: &mut Pane) {
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
            if OPACITY * apart > UNSEEN {
                pane.meshes.push(mesh);
            }
            let before = pane.lines.len();
            body::edges(context, state, pane, color, 2.2);
            for line in &mut pane.lines[before..] {
                line.dash = dash(ghost.method(), 1.0);
                line.hidden = 0.5 * apart;
            }
        }
    }
}

/// A mark each where M is, and the path that it would follow from here.
pub(super) fn marks(context: &Context<'_>, pane: &mut Pane) {
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
        pane.lines.push(Line::new(points, 2.0, color.fade(0.8)).dashed(dash(method, 1.0)).through(0.3));
        let rim = context.palette.background;
        pane.markers.push(Marker { position, size: 16.0, mark: mark(method), color, rim, hidden: 0.7, moves: true });
    }
}
