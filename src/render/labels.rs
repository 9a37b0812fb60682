//! Where the labels of a view go: beside what they name, clear of each other and inside the view.

use glam::{Vec2, Vec4};

use super::view::ViewUniform;
use crate::camera::NEAR;
use crate::frame::{Label, View};

/// Free space between labels and at the rim of the view (points).
const CLEARANCE: f32 = 5.0;
/// How much a label gives to stay near its wanted direction, against covering a mark.
const MARK_COST: f32 = 1.5;

/// A rectangle in pixels of the view, y down.
#[derive(Clone, Copy, Debug)]
pub(super) struct Box2 {
    pub(super) low: Vec2,
    pub(super) high: Vec2,
}

impl Box2 {
    fn around(centre: Vec2, half: Vec2) -> Self {
        Self { low: centre - half, high: centre + half }
    }

    fn meets(&self, other: &Self) -> bool {
        self.low.cmplt(other.high).all() && other.low.cmplt(self.high).all()
    }
}

/// Places the labels, given each one's width and height in pixels and what else stands in the view: the top left corners, none for a label that is
/// out of sight or finds no room.
pub(super) fn place(
    view: &View,
    uniform: &ViewUniform,
    extents: &[Vec2],
    notes: &[Box2],
    pixels: Vec2,
    point: f32,
) -> Vec<Option<Vec2>> {
    let project = |position: glam::Vec3| {
        let clip: Vec4 = uniform.clip_from_world * position.extend(1.0);
        let ndc = Vec2::new(clip.x, clip.y) / clip.w;
        (clip.w > NEAR && ndc.abs().max_element() <= 1.0).then(|| (ndc * Vec2::new(0.5, -0.5) + 0.5) * pixels)
    };
    let marks = view.points.iter().map(|mark| (mark.position, 0.5 * mark.size, mark.moves));
    // Straight strokes, as axes are, count by some places along them.
    let strokes = view.lines.iter().filter(|line| line.points.len() == 2).flat_map(|line| {
        let [from, to] = [line.points[0].position, line.points[1].position];
        [0.1, 0.35, 0.6, 0.85].map(|part| (from.lerp(to, part), line.width, false))
    });
    let marks: Vec<(Box2, bool)> = marks
        .chain(strokes)
        .filter_map(|(position, half, moves)| {
            Some((Box2::around(project(position)?, Vec2::splat(half * point)), moves))
        })
        .collect();
    let mut order: Vec<usize> = (0..view.labels.len().min(extents.len())).collect();
    order.sort_by_key(|&number| (view.labels[number].moves, std::cmp::Reverse(view.labels[number].priority)));
    let mut taken: Vec<Box2> = notes.to_vec();
    let mut places = vec![None; view.labels.len()];
    for number in order {
        let label = &view.labels[number];
        let Some(anchor) = project(label.anchor) else { continue };
        let half = 0.5 * extents[number];
        let best = candidates(label, anchor, half, point)
            .filter_map(|(centre, cost)| {
                let inside = centre.clamp(
                    (half + CLEARANCE * point).min(0.5 * pixels),
                    (pixels - half - CLEARANCE * point).max(0.5 * pixels),
                );
                let own = Box2::around(inside, half + 0.5 * CLEARANCE * point);
                if taken.iter().any(|other| own.meets(other)) {
                    return None;
                }
                let heeded = marks.iter().filter(|(_, moves)| label.moves || !moves);
                let covered = heeded.filter(|(mark, _)| own.meets(mark)).count() as f32;
                let pushed = inside.distance(centre) / (20.0 * point);
                Some((inside, cost + pushed + MARK_COST * covered))
            })
            .min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((centre, _)) = best {
            taken.push(Box2::around(centre, half + 0.5 * CLEARANCE * point));
            places[number] = Some((centre - half).round());
        }
    }
    places
}

/// Centres to try, each with what it costs: turned away from the wanted direction, and farther out.
fn candidates(label: &Label, anchor: Vec2, half: Vec2, point: f32) -> impl Iterator<Item = (Vec2, f32)> {
    const TURNS: [f32; 11] = [0.0, 25.0, -25.0, 50.0, -50.0, 80.0, -80.0, 115.0, -115.0, 150.0, 180.0];
    let wanted = Vec2::new(label.toward.x, -label.toward.y).normalize_or(Vec2::X);
    let gap = label.gap * point;
    TURNS.into_iter().flat_map(move |turn| {
        [1.0, 2.2].map(|reach| {
            let direction = Vec2::from_angle(turn.to_radians()).rotate(wanted);
            // Far enough out that the whole box lies beyond the gap, seen in that direction.
            let clear = half.dot(direction.abs());
            let centre = anchor + direction * (clear + gap * reach);
            (centre, turn.abs() / 60.0 + (reach - 1.0))
        })
    })
}
