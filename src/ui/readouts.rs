//! What is measured, live: what kind of motion it is, and how far each method strays.

use egui::{Align, Grid, Layout, RichText, Sense, Stroke, StrokeKind, Ui};

use super::widgets::{note, section};
use super::{Look, numbers, style};
use crate::physics::{poinsot, so3};
use crate::sim::Errors;

/// Drift that reaches the edge of an invariant's frame (relative).
const FRAME: f64 = 0.01;

/// What stays the same and what turns.
pub(super) fn motion(ui: &mut Ui, look: &Look<'_>) {
    let scene = look.scene;
    let start = &scene.start;
    section(ui, "Motion");
    note(ui, poinsot::classify(&scene.body, start.body_momentum).label());
    let state = look.sim.state();
    let omega = scene.body.body_from_principal().transpose() * state.body_angular_velocity(&scene.body);
    let rate = so3::norm(omega);
    line(ui, "energy K", &format!("{} J", numbers::significant(state.energy(&scene.body), 4)));
    line(ui, "momentum |L|", &format!("{} kg m²/s", numbers::significant(so3::norm(state.world_momentum), 4)));
    let angle = |along: f64| if rate > 0.0 { (along.abs() / rate).min(1.0).acos().to_degrees() } else { 0.0 };
    let angles = omega.to_array().map(|along| format!("{:.0}°", angle(along)));
    line(ui, "ω from axes 1, 2, 3", &angles.join("  "));

    note(ui, "what stays the same, and its drift");
    kept(ui, look, "energy K", look.sim.energy_error(), |errors| errors.energy);
    kept(ui, look, "momentum L", look.sim.momentum_error(), |errors| errors.momentum);
}

/// An invariant over the time of the scrub bar, drawn so that one per cent is well seen, and how far it has drifted.
fn kept(ui: &mut Ui, look: &Look<'_>, name: &str, drift: f64, value: fn(&Errors) -> f64) {
    ui.horizontal(|ui| {
        ui.allocate_ui_with_layout(egui::vec2(92.0, 18.0), Layout::left_to_right(Align::Center), |ui| {
            ui.set_width(92.0);
            ui.label(RichText::new(name).weak());
        });
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let width = 70.0;
            ui.allocate_ui_with_layout(egui::vec2(width, 18.0), Layout::right_to_left(Align::Center), |ui| {
                ui.set_width(width);
                ui.label(RichText::new(numbers::scientific_short(drift)).monospace());
            });
            let (rect, response) = ui.allocate_exact_size(egui::vec2(ui.available_width(), 18.0), Sense::hover());
            response.on_hover_text("From the start on; the frame is ±1 %. Behind it: the drift now");
            let painter = ui.painter().with_clip_rect(rect);
            let rail = ui.visuals().widgets.inactive.bg_fill;
            painter.rect_stroke(rect.shrink(0.5), 3.0, Stroke::new(1.0, rail), StrokeKind::Inside);
            let (low, high) = (look.timeline.low, look.timeline.high);
            let stroke = Stroke::new(2.0, style::accent(ui.visuals().dark_mode));
            for piece in look.history.pieces(|sample| sample.errors.first().map(value)) {
                let points = piece.into_iter().map(|[time, error]| {
                    let across = ((time - low) / (high - low)) as f32;
                    let up = (error / FRAME).clamp(-1.0, 1.0) as f32;
                    egui::pos2(rect.left() + across * rect.width(), rect.center().y - 0.5 * up * (rect.height() - 4.0))
                });
                painter.line(points.collect(), stroke);
            }
        });
    });
}

/// How far each method strays.
pub(super) fn errors(ui: &mut Ui, look: &Look<'_>) {
    section(ui, "Errors");
    let scene = look.scene;
    let time = look.sim.time();
    let is_dark = ui.visuals().dark_mode;
    Grid::new("errors").num_columns(4).spacing([6.0, 4.0]).min_col_width(46.0).show(ui, |ui| {
        ui.label("");
        for head in ["energy", "L", "attitude"] {
            ui.label(RichText::new(head).small().weak());
        }
        ui.end_row();
        for runner in std::iter::once(look.sim.main()).chain(look.sim.ghosts()) {
            let errors = Errors::of(scene, look.motion, time, runner.state());
            ui.allocate_ui_with_layout(egui::vec2(112.0, 16.0), Layout::left_to_right(Align::Center), |ui| {
                ui.set_width(112.0);
                let name = egui::Label::new(look.method_text(runner.method()).small()).truncate();
                ui.add(name).on_hover_text(runner.method().label);
            });
            for error in [errors.energy.abs(), errors.momentum, errors.attitude] {
                ui.label(RichText::new(numbers::scientific_short(error)).monospace().size(12.5));
            }
            ui.end_row();
        }
    });
    for runner in std::iter::once(look.sim.main()).chain(look.sim.ghosts()) {
        if let Some(failure) = runner.failure() {
            ui.label(RichText::new(failure.to_string()).small().color(style::warning(is_dark)));
        }
    }
}

fn line(ui: &mut Ui, name: &str, value: &str) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(name).weak());
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| ui.label(RichText::new(value).monospace()));
    });
}
