//! The picture's place in the window: dragging and the wheel over it move its cameras.

use egui::{PointerButton, Pos2, Rect, Sense, Ui, Vec2};

use super::{Command, command::Pixels};

/// How much one point of wheel movement zooms.
const ZOOM_PER_POINT: f32 = 0.0025;

/// Takes the rest of the window and gives its rectangle (points).
pub(super) fn show(ui: &mut Ui, commands: &mut Vec<Command>) -> Rect {
    let rect = ui.available_rect_before_wrap();
    let response = ui.interact(rect, ui.scope_id().with("picture"), Sense::click_and_drag());
    response.widget_info(|| {
        egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, "the body in the world and in its own frame")
    });
    let scale = ui.ctx().pixels_per_point();
    let pixels = |v: Vec2| Pixels::new(v.x, v.y) * scale;
    let within = |p: Pos2| pixels(p - rect.min);
    if response.dragged()
        && let Some(pointer) = response.interact_pointer_pos()
    {
        let by = response.drag_delta();
        // The view that the drag began in keeps it, also where the pointer leaves that view.
        let origin = ui.input(|input| input.pointer.press_origin()).unwrap_or(pointer);
        let shift = ui.input(|input| input.modifiers.shift);
        if by != Vec2::ZERO {
            let (at, by) = (within(origin), pixels(by));
            let pans = shift || !response.dragged_by(PointerButton::Primary);
            commands.push(if pans { Command::Pan { at, by } } else { Command::Orbit { at, by } });
        }
    }
    if let Some(pointer) = response.hover_pos() {
        let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
        let by = (scroll * ZOOM_PER_POINT).exp() * pinch;
        if by != 1.0 {
            commands.push(Command::Zoom { at: within(pointer), by });
        }
    }
    rect
}
