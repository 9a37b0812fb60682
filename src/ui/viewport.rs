//! The picture's place in the window: dragging and the wheel over it move its cameras, a click picks a start.

use egui::{Color32, PointerButton, Pos2, Rect, Sense, Stroke, Ui, Vec2};

use super::widgets::explained;
use super::{Command, Look, command::Pixels, style};
use crate::frame::PlacedName;
use crate::objects::{Word, word_of};
use crate::physics::poinsot;

/// How long (s) the polhode under a pointer at rest is shown.
const PREVIEW_SECONDS: f32 = 2.5;
/// How much one point of wheel movement zooms.
const ZOOM_PER_POINT: f32 = 0.0015;

/// How near the tip of M (points) one takes hold of it.
const GRASP: f32 = 14.0;

/// Room for the words beside a previewed start (points).
const WORDS_WIDTH: f32 = 240.0;

/// The picture's place.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Viewport {
    pointer: Option<Pixels>,
    /// From where the pointer took hold of M to M's tip.
    grasp: Option<Pixels>,
}

impl Viewport {
    /// Takes the rest of the window and gives its rectangle (points).
    pub(super) fn ui(&mut self, ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) -> Rect {
        let rect = ui.available_rect_before_wrap();
        let response = ui.interact(rect, ui.scope_id().with("picture"), Sense::click_and_drag());
        response.widget_info(|| {
            let class = poinsot::class_of(&look.scene.body, &look.scene.start).label();
            let seen = format!("{}: the body seen from the world, and its momentum sphere; {class}", look.title());
            egui::WidgetInfo::labeled(egui::accesskit::Role::Image, true, seen)
        });
        let scale = ui.ctx().pixels_per_point();
        let pixels = |v: Vec2| Pixels::new(v.x, v.y) * scale;
        let within = |p: Pos2| pixels(p - rect.min);
        let to_tip = |pointer: Pos2| {
            let way = look.tip? - within(pointer);
            (way.length() < GRASP * scale).then_some(way)
        };
        // Decided where the press was: by the time that it is a drag, M may have run on, and in a slow frame the pointer too.
        let (is_pressed, origin, shift) =
            ui.input(|input| (input.pointer.primary_pressed(), input.pointer.press_origin(), input.modifiers.shift));
        if is_pressed {
            let is_here = response.hovered() || response.is_pointer_button_down_on();
            self.grasp = origin.or(response.hover_pos()).filter(|_| is_here && !shift).and_then(to_tip);
        }
        let held = self.grasp.filter(|_| response.dragged_by(PointerButton::Primary));
        if let (Some(way), Some(pointer)) = (held, response.interact_pointer_pos()) {
            ui.ctx().set_cursor_icon(egui::CursorIcon::Grabbing);
            commands.push(Command::DragTip(within(pointer) + way));
        } else if response.hover_pos().and_then(to_tip).is_some() {
            ui.ctx().set_cursor_icon(egui::CursorIcon::Grab);
        }
        if response.dragged()
            && held.is_none()
            && let Some(pointer) = response.interact_pointer_pos()
        {
            let by = response.drag_delta();
            // The view that the drag began in keeps it, also where the pointer leaves that view.
            let origin = origin.unwrap_or(pointer);
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
        if response.clicked()
            && self.grasp.is_none()
            && let Some(pointer) = response.interact_pointer_pos()
        {
            commands.push(Command::Pick(within(pointer)));
        }
        // A pointer left lying on the sphere asks for nothing.
        let still = ui.input(|input| input.pointer.time_since_last_movement());
        if response.hovered() && still < PREVIEW_SECONDS {
            ui.ctx().request_repaint_after_secs(PREVIEW_SECONDS - still);
        }
        let is_asking = |pointer: &Pos2| !response.dragged() && still < PREVIEW_SECONDS && to_tip(*pointer).is_none();
        let pointer = response.hover_pos().filter(is_asking).map(within);
        if pointer != self.pointer {
            self.pointer = pointer;
            commands.push(Command::Hover(pointer));
        }
        let word = response.hover_pos().and_then(|pointer| word_under(look, within(pointer)));
        preview(ui, rect, scale, look);
        if let Some(word) = word.filter(|_| !response.dragged()) {
            response.on_hover_text_at_pointer(explained(word));
        }
        rect
    }
}

/// What the name under a point of the picture means.
fn word_under(look: &Look<'_>, at: Pixels) -> Option<&'static Word> {
    let is_under = |name: &&PlacedName| at.cmpge(name.low).all() && at.cmple(name.high).all();
    word_of(&look.names.iter().find(is_under)?.text)
}

/// The polhode that a click would start, dashed where it lies behind the sphere.
fn preview(ui: &Ui, rect: Rect, scale: f32, look: &Look<'_>) {
    let Some(preview) = look.preview else { return };
    let at = |p: &Pixels| rect.min + Vec2::new(p.x, p.y) / scale;
    let is_dark = ui.visuals().dark_mode;
    let front = Stroke::new(2.0, if is_dark { Color32::WHITE } else { Color32::BLACK });
    let behind = Stroke::new(1.0, front.color.gamma_multiply(0.45));
    let painter = ui.painter().with_clip_rect(rect);
    for (index, pair) in preview.path.windows(2).enumerate() {
        if let [(from, is_front), (to, _)] = pair
            && (*is_front || index % 2 == 0)
        {
            painter.line_segment([at(from), at(to)], if *is_front { front } else { behind });
        }
    }
    painter.circle(at(&preview.at), 5.0, style::accent(is_dark), front);
    // Towards the middle of the view, so that the edge cuts nothing off.
    let (align, aside) = if at(&preview.at).x + WORDS_WIDTH > rect.right() {
        (egui::Align2::RIGHT_BOTTOM, -12.0)
    } else {
        (egui::Align2::LEFT_BOTTOM, 12.0)
    };
    let place = at(&preview.at) + Vec2::new(aside, -12.0);
    let words = painter.layout_no_wrap(preview.words.to_owned(), egui::FontId::proportional(17.0), front.color);
    let ground = align.anchor_size(place, words.size());
    painter.rect_filled(ground.expand(4.0), 4.0, look.ground().gamma_multiply(0.8));
    painter.galley(ground.min, words, front.color);
}
