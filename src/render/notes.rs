//! Notes: rows of text in the upper left corner of a view, each after a sample of what it explains.

use std::borrow::Cow;

use glam::{Vec2, Vec3};

use super::view::ViewUniform;
use crate::camera::NEAR;
use crate::frame::{Dash, Frame, Line, Note, Point, View};

/// From the rim of the view (points).
pub(super) const MARGIN: f32 = 14.0;
/// From the upper rim.
const ABOVE: f32 = 9.0;
/// Height of a row in heights of its text.
const ROW: f32 = 1.35;
/// Length of a sample and the gap after it (points).
const SAMPLE: f32 = 44.0;
const GAP: f32 = 10.0;
const LINE_WIDTH: f32 = 2.4;
const MARK_SIZE: f32 = 14.0;
/// View depth at which samples are drawn: before everything.
const DEPTH: f32 = 4.0 * NEAR;

/// Where the rows of a view stand, in pixels: left end of the text, and the middle of the row's height.
pub(super) fn rows(view: &View, point: f32) -> Vec<Vec2> {
    let mut bottom = ABOVE * point;
    let place = |note: &Note| {
        let height = ROW * note.size * point;
        bottom += height;
        let indent = if note.sample.is_some() { SAMPLE + GAP } else { 0.0 };
        Vec2::new((MARGIN + indent) * point, bottom - 0.5 * height)
    };
    view.notes.iter().map(place).collect()
}

/// The frame with the samples of its notes among the lines and points.
pub(super) fn with_samples<'a>(
    frame: &'a Frame,
    uniforms: &[ViewUniform],
    picture: Vec2,
    point: f32,
) -> Cow<'a, Frame> {
    if frame.views.iter().all(|view| view.notes.iter().all(|note| note.sample.is_none())) {
        return Cow::Borrowed(frame);
    }
    let mut frame = frame.clone();
    for (view, uniform) in frame.views.iter_mut().zip(uniforms) {
        let pixels = view.area.extent * picture;
        // Units of the view's world a pixel, at that depth.
        let per_pixel = 2.0 * DEPTH * uniform.ray_up.truncate().length() / pixels.y.max(1.0);
        for (row, note) in rows(view, point).into_iter().zip(std::mem::take(&mut view.notes)) {
            if let Some(sample) = note.sample {
                let ends = [SAMPLE + GAP, GAP].map(|back| place(uniform, row - Vec2::X * (back * point), pixels));
                let scale = |period: f32| period * point * per_pixel;
                let dash = match sample.dash {
                    Dash::Solid => Dash::Solid,
                    Dash::Dashed(period) => Dash::Dashed(scale(period)),
                    Dash::Dotted(period) => Dash::Dotted(scale(period)),
                };
                view.lines.push(Line::new(ends, LINE_WIDTH, sample.color).dashed(dash).through(1.0));
                let position = ends[0].midpoint(ends[1]);
                let (mark, color, rim) = (sample.mark, sample.color, sample.rim);
                view.points.push(Point { position, size: MARK_SIZE, mark, color, rim, hidden: 1.0, moves: false });
            }
            view.notes.push(note);
        }
    }
    Cow::Owned(frame)
}

/// The point of the view's world behind a pixel.
fn place(uniform: &ViewUniform, pixel: Vec2, pixels: Vec2) -> Vec3 {
    let ndc = Vec2::new(2.0, -2.0) * pixel / pixels.max(Vec2::ONE) + Vec2::new(-1.0, 1.0);
    let ray = uniform.ray_forward + ndc.x * uniform.ray_right + ndc.y * uniform.ray_up;
    uniform.eye.truncate() + DEPTH * ray.truncate()
}
