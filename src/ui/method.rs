//! The method's part of the panel: which one follows the motion, and its step.

use egui::{ComboBox, Ui};

use super::widgets::{NumberRow, section};
use super::{Command, Look};
use crate::physics::METHODS;
use crate::scene::{MotionFile, SceneFile};

/// Shows it.
pub(super) fn show(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    section(ui, "Method");
    let scene = look.scene;
    let edit = |motion: MotionFile| Command::Edit(Box::new(SceneFile { motion, ..scene.file.clone() }));
    let combo = ComboBox::from_id_salt("method").width(ui.available_width()).selected_text(scene.method.label);
    let shown = combo.show_ui(ui, |ui| {
        for method in METHODS {
            let row = ui.selectable_label(method.name == scene.method.name, method.label);
            if row.on_hover_text(method.source).clicked() {
                let method = Some(method.name.to_owned());
                commands.push(edit(MotionFile { method, ..scene.file.motion.clone() }));
            }
        }
    });
    let label = format!("method: {}", scene.method.label);
    shown.response.widget_info(|| egui::WidgetInfo::labeled(egui::accesskit::Role::ComboBox, true, &label));
    let mut milliseconds = scene.step * 1e3;
    let step = NumberRow {
        label: "step",
        unit: " ms",
        range: (0.01, 200.0),
        logarithmic: Some(0.01),
        hint: "Simulated time that one step of the method covers",
    };
    if step.ui(ui, &mut milliseconds).changed() && milliseconds > 0.0 {
        commands.push(edit(MotionFile { step: Some(milliseconds * 1e-3), ..scene.file.motion.clone() }));
    }
}
