//! The scrub bar: past and future on one line, with a tick at each flip.

use egui::accesskit::{Action, ActionData};
use egui::{Align2, FontId, Key, Rect, Sense, Stroke, Ui, WidgetInfo, pos2, vec2};

use super::numbers::{significant, trimmed};
use super::{Command, Look, style};

/// Height of the bar with its numbers (points); fingers want more.
const HEIGHT: f32 = 38.0;
/// What an arrow key moves, as a part of the bar.
const STEP: f64 = 0.01;

/// What is known of a motion before it is run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timeline {
    /// Earliest time on the bar (s).
    pub low: f64,
    /// Latest time on the bar (s).
    pub high: f64,
    /// A flip (s), where there is any.
    pub first_flip: Option<f64>,
    /// Time between flips (s), where there is more than one.
    pub period: Option<f64>,
}

impl Timeline {
    /// The first flip after a time (s), or before it where time runs backwards.
    #[must_use]
    pub fn next_flip(&self, time: f64, is_backwards: bool) -> Option<f64> {
        let first = self.first_flip?;
        let Some(period) = self.period else {
            return ((first > time) != is_backwards).then_some(first);
        };
        // A flip that has just been gone to is not the next one.
        let passed = (time - first) / period;
        let next = if is_backwards { (passed - 1e-9).ceil() - 1.0 } else { (passed + 1e-9).floor() + 1.0 };
        Some(first + next * period)
    }

    /// The flips on the bar (s); none where they would lie closer than this (s).
    fn flips(&self, closest: f64) -> Vec<f64> {
        match (self.first_flip, self.period) {
            (Some(first), Some(period)) if period > closest => {
                let from = ((self.low - first) / period).ceil();
                let count = ((self.high - first) / period).floor() - from + 1.0;
                (0..count.max(0.0) as u32).map(|index| first + (from + f64::from(index)) * period).collect()
            }
            (Some(first), None) => vec![first],
            _ => Vec::new(),
        }
    }
}

/// The scrub bar with its flips; dragged, clicked or moved by arrows it goes to a time.
pub(super) fn show(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    let Timeline { low, high, .. } = *look.timeline;
    let time = look.sim.time();
    let height = HEIGHT.max(ui.spacing().interact_size.y);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::slider(true, time, "time (s)"));
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_min_numeric_value(low);
        node.set_max_numeric_value(high);
        node.set_numeric_value_step((high - low) * STEP);
        for action in [Action::SetValue, Action::Increment, Action::Decrement] {
            node.add_action(action);
        }
    });
    let track = rect.shrink2(vec2(6.0, 0.0));
    let at = |t: f64| track.left() + ((t - low) / (high - low)) as f32 * track.width();
    let is_dark = ui.visuals().dark_mode;
    let accent = style::accent(is_dark);
    let rail = ui.visuals().widgets.inactive.bg_fill;
    let soft = ui.visuals().weak_text_color.unwrap_or(rail);
    let y = rect.top() + 18.0;
    let painter = ui.painter();
    let bar = |from: f32, to: f32| Rect::from_min_max(pos2(from.min(to), y - 2.0), pos2(from.max(to), y + 2.0));
    painter.rect_filled(bar(track.left(), track.right()), 2.0, rail);
    painter.rect_filled(bar(at(0.0), at(time.clamp(low, high))), 2.0, accent);
    let flip_color = style::warning(is_dark);
    for flip in look.timeline.flips((high - low) / f64::from(track.width()) * 5.0) {
        // A form of its own: the marks of the seconds are straight.
        let corners = [vec2(0.0, -6.0), vec2(5.0, 0.0), vec2(0.0, 6.0), vec2(-5.0, 0.0)];
        let corners = corners.map(|corner| pos2(at(flip), y) + corner).to_vec();
        painter.add(egui::Shape::convex_polygon(corners, flip_color, Stroke::NONE));
    }
    // One tick says what they are.
    if let Some(next) =
        look.timeline.next_flip(time, look.sim.clock.speed < 0.0).filter(|next| (low..=high).contains(next))
    {
        let place = pos2(at(next).clamp(track.left() + 8.0, track.right() - 8.0), y - 7.0);
        painter.text(place, Align2::CENTER_BOTTOM, "flip", FontId::proportional(13.5), flip_color);
    }
    for mark in marks(low, high, f64::from(track.width()) / 90.0) {
        let text = format!("{} {}", trimmed(&significant(mark, 6)), look.time_unit());
        painter.text(
            pos2(at(mark), rect.bottom() + 1.0),
            Align2::CENTER_BOTTOM,
            text,
            FontId::proportional(13.5),
            soft,
        );
    }
    let handle = pos2(at(time.clamp(low, high)), y);
    let ring = if response.has_focus() { 2.5 } else { 1.5 };
    painter.circle(handle, 6.5, accent, Stroke::new(ring, ui.visuals().widgets.active.fg_stroke.color));
    if (response.clicked() || response.dragged())
        && let Some(pointer) = response.interact_pointer_pos()
    {
        let part = f64::from((pointer.x - track.left()) / track.width()).clamp(0.0, 1.0);
        let wanted = low + part * (high - low);
        if wanted != time {
            commands.push(Command::GoTo(wanted));
        }
    }
    for wanted in asked_by_reader(ui, response.id, time, (high - low) * STEP) {
        commands.push(Command::GoTo(wanted.clamp(low, high)));
    }
    if response.has_focus() {
        ui.memory_mut(|memory| {
            let filter = egui::EventFilter { horizontal_arrows: true, ..Default::default() };
            memory.set_focus_lock_filter(response.id, filter);
        });
        let by = ui.input(|input| {
            f64::from(input.num_presses(Key::ArrowRight) as u32) - f64::from(input.num_presses(Key::ArrowLeft) as u32)
        });
        if by != 0.0 {
            commands.push(Command::GoTo((time + by * (high - low) * STEP).clamp(low, high)));
        }
    }
}

/// The times (s) that a screen reader asks for.
fn asked_by_reader(ui: &Ui, id: egui::Id, time: f64, step: f64) -> Vec<f64> {
    ui.input(|input| {
        let set = input.accesskit_action_requests(id, Action::SetValue).filter_map(|request| match request.data {
            Some(ActionData::NumericValue(wanted)) => Some(wanted),
            _ => None,
        });
        let on = input.accesskit_action_requests(id, Action::Increment).map(|_| time + step);
        let back = input.accesskit_action_requests(id, Action::Decrement).map(|_| time - step);
        set.chain(on).chain(back).collect()
    })
}

/// Round times for about `count` marks.
fn marks(low: f64, high: f64, count: f64) -> Vec<f64> {
    let Some(step) = round_step((high - low) / count.max(1.0)) else { return Vec::new() };
    let from = (low / step).ceil();
    let count = ((high / step).floor() - from + 1.0).clamp(0.0, 100.0);
    (0..count as u32).map(|index| (from + f64::from(index)) * step).collect()
}

/// The next of 1, 2, 5, 10, … from here on; none where there is no such number.
pub(super) fn round_step(rough: f64) -> Option<f64> {
    let power = 10f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].map(|factor| factor * power).into_iter().find(|step| *step >= rough);
    step.filter(|step| step.is_normal())
}

#[cfg(test)]
mod tests {
    use super::{Timeline, marks};

    #[test]
    fn the_next_flip_is_ahead_in_either_direction() {
        let line = Timeline { low: 0.0, high: 20.0, first_flip: Some(2.0), period: Some(4.0) };
        assert_eq!(line.next_flip(0.0, false), Some(2.0));
        assert_eq!(line.next_flip(2.0, false), Some(6.0));
        assert_eq!(line.next_flip(2.0, true), Some(-2.0));
        assert_eq!(line.next_flip(5.0, true), Some(2.0));
        assert_eq!(line.flips(0.1), [2.0, 6.0, 10.0, 14.0, 18.0]);
        let once = Timeline { period: None, ..line };
        assert_eq!(once.next_flip(3.0, false), None);
        assert_eq!(once.next_flip(3.0, true), Some(2.0));
    }

    #[test]
    fn marks_are_round() {
        assert_eq!(marks(0.0, 10.0, 5.0), [0.0, 2.0, 4.0, 6.0, 8.0, 10.0]);
        assert!(marks(0.0, 0.0, 5.0).is_empty());
    }
}
