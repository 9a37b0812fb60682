//! What is measured, live.

use egui::{Align, Layout, RichText, Ui};

use super::widgets::section;
use super::{Look, numbers, style};

/// Shows it.
pub(super) fn show(ui: &mut Ui, look: &Look<'_>) {
    section(ui, "What stays the same");
    let energy = look.scene.start.energy(&look.scene.body);
    let momentum = look.scene.start.world_momentum.length();
    line(ui, "energy K", &format!("{} J", numbers::significant(energy, 3)));
    line(ui, "its relative error", &numbers::scientific(look.sim.energy_error()));
    line(ui, "momentum |L|", &format!("{} kg m²/s", numbers::significant(momentum, 3)));
    line(ui, "its relative error", &numbers::scientific(look.sim.momentum_error()));
    if let Some(failure) = look.sim.main().failure() {
        ui.label(RichText::new(failure.to_string()).color(style::warning(ui.visuals().dark_mode)));
    }
}

fn line(ui: &mut Ui, name: &str, value: &str) {
    ui.horizontal(|ui| {
        ui.label(RichText::new(name).weak());
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| ui.label(RichText::new(value).monospace()));
    });
}
