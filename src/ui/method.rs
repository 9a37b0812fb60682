//! The method's part of the panel: which one follows the motion, and its step.

use egui::{ComboBox, Ui};

use super::widgets::{NumberRow, note, section};
use super::{Command, Look};
use crate::physics::METHODS;
use crate::physics::methods::LOSS_METHOD;

/// Height of a list that shows every method without scrolling (points).
const LONGEST: f32 = 420.0;

/// The method, the methods beside it, and their step.
pub(super) fn show(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    section(ui, "Method");
    let scene = look.scene;
    let combo = ComboBox::from_id_salt("method").width(ui.available_width()).height(LONGEST);
    let combo = combo.selected_text(scene.method.label);
    let shown = combo.show_ui(ui, |ui| {
        for method in METHODS.iter().filter(|method| !look.loses_energy() || method.name == LOSS_METHOD) {
            let row = ui.selectable_label(*method == *scene.method, method.label);
            if row.on_hover_text(method.source).clicked() {
                commands.push(Command::SetMethod(method.name));
            }
        }
    });
    let label = format!("method: {}", scene.method.label);
    shown.response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::ComboBox, true, &label));
    if look.loses_energy() {
        note(ui, "The only method that knows energy loss; with none there are the others, too.");
    } else {
        compare(ui, look, commands);
    }
    let mut milliseconds = scene.step * 1e3;
    let step = NumberRow {
        label: "step",
        unit: " ms",
        range: (0.01, 200.0),
        logarithmic: Some(0.01),
        hint: "Simulated time that one step of the method covers",
    };
    if step.ui(ui, &mut milliseconds, commands).changed() && milliseconds > 0.0 {
        commands.push(Command::SetStep(milliseconds * 1e-3));
    }
    let mut loss = scene.energy_loss;
    let row = NumberRow {
        label: "energy loss",
        unit: "",
        range: (0.0, 0.5),
        logarithmic: Some(0.001),
        hint: "Energy lost inside a body that is not quite rigid, at constant L: 0 for none, 0.02 in tens of turns",
    };
    if row.ui(ui, &mut loss, commands).changed() {
        commands.push(Command::SetEnergyLoss(loss));
    }
}

/// Which methods run beside it from the same start.
fn compare(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let scene = look.scene;
    let count = scene.compare.len();
    let name = if count == 0 { "compare with…".to_owned() } else { format!("compared with {count} more") };
    let width = ui.available_width();
    let close = egui::PopupCloseBehavior::CloseOnClickOutside;
    let combo =
        ComboBox::from_id_salt("compare").width(width).height(LONGEST).selected_text(&name).close_behavior(close);
    let shown = combo.show_ui(ui, |ui| {
        for method in METHODS.iter().filter(|method| **method != *scene.method) {
            let mut is_on = scene.compare.iter().any(|other| **other == *method);
            if ui.checkbox(&mut is_on, look.method_text(method)).changed() {
                commands.push(Command::Compare { method: method.name, is_on });
            }
        }
    });
    shown.response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::ComboBox, true, &name));
}
