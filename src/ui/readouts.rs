//! What is measured, live: what kind of motion it is, and how far each method strays.

use egui::{Align, Grid, Layout, RichText, Ui};

use super::charts::method_text;
use super::widgets::{note, section};
use super::{Look, numbers, style};
use crate::physics::{poinsot, so3};
use crate::sim::Errors;

/// What stays the same and what turns.
pub(super) fn motion(ui: &mut Ui, look: &Look<'_>) {
    section(ui, "Motion");
    let scene = look.scene;
    let start = &scene.start;
    note(ui, poinsot::classify(&scene.body, start.body_momentum).label());
    let state = look.sim.state();
    let omega = scene.body.body_from_principal().transpose() * state.body_angular_velocity(&scene.body);
    let rate = so3::norm(omega);
    line(ui, "energy K", &format!("{} J", numbers::significant(state.energy(&scene.body), 4)));
    line(ui, "momentum |L|", &format!("{} kg m²/s", numbers::significant(so3::norm(state.world_momentum), 4)));
    let angle = |along: f64| if rate > 0.0 { (along.abs() / rate).min(1.0).acos().to_degrees() } else { 0.0 };
    let angles = omega.to_array().map(|along| format!("{:.0}°", angle(along)));
    line(ui, "ω from axes 1, 2, 3", &angles.join("  "));

    let drift = [look.sim.energy_error(), look.sim.momentum_error()];
    line(ui, "drift of K and L", &drift.map(numbers::scientific_short).join("  "));
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
            let name = egui::Label::new(method_text(runner.method(), is_dark).small()).truncate().halign(Align::Min);
            ui.add_sized([112.0, 16.0], name).on_hover_text(runner.method().label);
            for error in [errors.energy, errors.momentum, errors.attitude] {
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
