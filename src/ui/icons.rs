//! Buttons with drawn signs: the fonts have no signs for pausing and stepping.

use egui::{Color32, Painter, Pos2, Rect, Response, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, pos2, vec2};

/// A sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Icon {
    /// A triangle to the right.
    Play,
    /// Two bars.
    Pause,
    /// A bar and a triangle to the right.
    StepOn,
    /// A triangle to the left and a bar.
    StepBack,
    /// Two triangles to the left.
    Reverse,
    /// A bar on the left and two triangles to the left.
    Restart,
    /// Two triangles to the right and a bar.
    Next,
    /// An angle that opens to the right: what comes before.
    Before,
    /// One that opens to the left: what comes after.
    After,
    /// Three bars: all the rest.
    Menu,
}

/// A button with a sign; `name` says what it does, to readers of hints and of the screen alike. One that holds a state is
/// on or off.
pub(super) fn icon_button(ui: &mut Ui, icon: Icon, name: &str, size: f32, state: Option<bool>) -> Response {
    let (rect, response) = ui.allocate_exact_size(Vec2::splat(size), Sense::click());
    let is_on = state.unwrap_or(false);
    response.widget_info(|| match state {
        Some(is_on) => WidgetInfo::selected(egui::accesskit::Role::Button, ui.is_enabled(), is_on, name),
        None => WidgetInfo::labeled(egui::accesskit::Role::Button, ui.is_enabled(), name),
    });
    let visuals = ui.style().interact_selectable(&response, is_on);
    let painter = ui.painter();
    painter.rect(
        rect,
        visuals.corner_radius,
        visuals.weak_bg_fill,
        if response.has_focus() { ui.visuals().selection.stroke } else { Stroke::NONE },
        egui::StrokeKind::Inside,
    );
    draw(painter, icon, Rect::from_center_size(rect.center(), Vec2::splat(size * 0.42)), visuals.fg_stroke.color);
    response.on_hover_text(name)
}

fn draw(painter: &Painter, icon: Icon, area: Rect, colour: Color32) {
    let at = |x: f32, y: f32| pos2(area.left() + x * area.width(), area.top() + y * area.height());
    let right = |from: f32, to: f32| triangle(painter, [at(from, 0.0), at(to, 0.5), at(from, 1.0)], colour);
    let left = |from: f32, to: f32| triangle(painter, [at(to, 0.0), at(to, 1.0), at(from, 0.5)], colour);
    let bar = |centre: f32, width: f32| {
        let size = vec2(width * area.width(), area.height());
        painter.rect_filled(Rect::from_center_size(at(centre, 0.5), size), 1.0, colour);
    };
    match icon {
        Icon::Play => right(0.1, 1.0),
        Icon::Pause => {
            bar(0.24, 0.26);
            bar(0.76, 0.26);
        }
        Icon::StepOn => {
            bar(0.1, 0.18);
            right(0.34, 1.0);
        }
        Icon::StepBack => {
            left(0.0, 0.66);
            bar(0.9, 0.18);
        }
        Icon::Reverse => {
            left(-0.08, 0.5);
            left(0.5, 1.08);
        }
        Icon::Next => {
            right(-0.14, 0.36);
            right(0.36, 0.86);
            bar(0.98, 0.14);
        }
        Icon::Before => angle(painter, [at(0.72, 0.0), at(0.28, 0.5), at(0.72, 1.0)], colour),
        Icon::After => angle(painter, [at(0.28, 0.0), at(0.72, 0.5), at(0.28, 1.0)], colour),
        Icon::Menu => {
            for y in [0.12, 0.5, 0.88] {
                painter.line_segment([at(0.0, y), at(1.0, y)], Stroke::new(2.5, colour));
            }
        }
        Icon::Restart => {
            bar(0.06, 0.16);
            left(0.2, 1.0);
        }
    }
}

fn angle(painter: &Painter, corners: [Pos2; 3], colour: Color32) {
    painter.line(corners.to_vec(), Stroke::new(3.0, colour));
}

fn triangle(painter: &Painter, corners: [Pos2; 3], colour: Color32) {
    painter.add(Shape::convex_polygon(corners.to_vec(), colour, Stroke::NONE));
}
