//! The tip of M, the momentum as the body sees it.

use glam::{Vec2, Vec3};

use super::{Context, arrow};
use crate::frame::{Label, Mark, Point, View};

pub(super) fn draw(context: &Context<'_>, view: &mut View) {
    let color = context.palette.momentum;
    let tip = context.body_momentum(context.simulation.state().body_momentum);
    if tip == Vec3::ZERO {
        return;
    }
    arrow::add(view, Vec3::ZERO, tip * 0.985, color);
    let rim = context.palette.background;
    view.points.push(Point { position: tip, size: 15.0, mark: Mark::Disc, color, rim, hidden: 0.6 });
    let text = "M".to_owned();
    let toward = Vec2::new(0.6, 1.0);
    view.labels.push(Label { anchor: tip, toward, gap: 14.0, text, size: 26.0, color, priority: 9 });
}
