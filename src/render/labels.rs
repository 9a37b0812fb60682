//! Where the labels of a view go: beside what they name and inside the view. Those that stand still keep clear of each
//! other. Those that move stay where they want to be, since a label that jumps aside draws the eye; what they pass gives
//! way to them, or they to it, by fading.

use glam::Vec2;

use super::view::ViewUniform;
use crate::frame::{Label, View};

/// Free space between labels and at the rim of the view (points).
const CLEARANCE: f32 = 5.0;
/// How much a label gives to stay near its wanted direction, against covering a mark.
const MARK_COST: f32 = 1.5;

/// Distance (points) at which a label begins to fade before a more important one; where they meet it is gone.
const FADES_WITHIN: f32 = 12.0;

/// Where a label stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// Its top left corner, in pixels of the view.
    pub(super) low: Vec2,
    /// Factor on its opacity.
    pub(super) opacity: f32,
}

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

    /// Width of the gap between two; 0 where they meet.
    fn gap(&self, other: &Self) -> f32 {
        (other.low - self.high).max(self.low - other.high).max(Vec2::ZERO).length()
    }
}

/// Places the labels, given each one's width and height in pixels and what else stands in the view; none for a label
/// that is out of sight or finds no room.
pub(super) fn place(
    view: &View,
    uniform: &ViewUniform,
    extents: &[Vec2],
    notes: &[Box2],
    pixels: Vec2,
    point: f32,
) -> Vec<Option<Place>> {
    let project = |position: glam::Vec3| {
        let ndc = uniform.ndc(position).filter(|ndc| ndc.abs().max_element() <= 1.0)?;
        Some((ndc * Vec2::new(0.5, -0.5) + 0.5) * pixels)
    };
    let marks = view.points.iter().filter(|mark| !mark.moves).map(|mark| (mark.position, 0.5 * mark.size));
    // Straight strokes, as axes are, count by some places along them.
    let strokes = view.lines.iter().filter(|line| line.points.len() == 2).flat_map(|line| {
        let [from, to] = [line.points[0].position, line.points[1].position];
        [0.1, 0.35, 0.6, 0.85].map(|part| (from.lerp(to, part), line.width))
    });
    let marks: Vec<Box2> = marks
        .chain(strokes)
        .filter_map(|(position, half)| Some(Box2::around(project(position)?, Vec2::splat(half * point))))
        .collect();
    let mut order: Vec<usize> = (0..view.labels.len().min(extents.len())).collect();
    order.sort_by_key(|&number| (view.labels[number].moves, std::cmp::Reverse(view.labels[number].priority)));
    let mut taken: Vec<Box2> = notes.to_vec();
    let mut places: Vec<Option<Box2>> = vec![None; view.labels.len()];
    for number in order {
        let label = &view.labels[number];
        let Some(anchor) = project(label.anchor) else { continue };
        let half = 0.5 * extents[number];
        let kept_inside = |centre: Vec2| {
            let rim = half + CLEARANCE * point;
            centre.clamp(rim.min(0.5 * pixels), (pixels - rim).max(0.5 * pixels))
        };
        if label.moves {
            let wanted = candidates(label, anchor, half, point).next();
            places[number] = wanted.map(|(centre, _)| Box2::around(kept_inside(centre), half));
            continue;
        }
        let best = candidates(label, anchor, half, point)
            .filter_map(|(centre, cost)| {
                let inside = kept_inside(centre);
                let own = Box2::around(inside, half + 0.5 * CLEARANCE * point);
                if taken.iter().any(|other| own.meets(other)) {
                    return None;
                }
                let covered = marks.iter().filter(|mark| own.meets(mark)).count() as f32;
                let pushed = inside.distance(centre) / (20.0 * point);
                Some((inside, cost + pushed + MARK_COST * covered))
            })
            .min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((centre, _)) = best {
            taken.push(Box2::around(centre, half + 0.5 * CLEARANCE * point));
            places[number] = Some(Box2::around(centre, half));
        }
    }
    let opacity = |number: usize, own: &Box2| {
        let label = &view.labels[number];
        let rank = |number: usize| (view.labels[number].priority, std::cmp::Reverse(number));
        let others = places.iter().enumerate().filter_map(|(other, place)| Some((other, (*place)?)));
        let others =
            others.filter(|(other, _)| (view.labels[*other].moves || label.moves) && rank(*other) > rank(number));
        // A label that stands still gives way to moving marks as well, one that moves to what is written in the corner.
        let marks = view.points.iter().filter(|mark| mark.moves && !label.moves);
        let marks =
            marks.filter_map(|mark| Some(Box2::around(project(mark.position)?, Vec2::splat(0.5 * mark.size * point))));
        let notes = notes.iter().filter(|_| label.moves).copied();
        let gaps = others.map(|(_, place)| place).chain(marks).chain(notes).map(|other| own.gap(&other));
        gaps.fold(1.0, |least: f32, gap| least.min(gap / (FADES_WITHIN * point)))
    };
    let stand = |(number, place): (usize, &Option<Box2>)| {
        place.as_ref().map(|own| Place { low: own.low.round(), opacity: opacity(number, own) })
    };
    places.iter().enumerate().map(stand).collect()
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

#[cfg(test)]
mod tests {
    use super::place;
    use crate::camera::Camera;
    use crate::frame::{Area, Color, Label, View};
    use crate::render::view::ViewUniform;
    use glam::{Vec2, Vec3};

    fn label(anchor: Vec3, priority: i32, moves: bool) -> Label {
        let color = Color::hex(0);
        Label { anchor, toward: Vec2::X, gap: 5.0, text: String::new(), size: 20.0, color, priority, moves }
    }

    fn opacities(labels: Vec<Label>) -> Vec<f32> {
        let mut view = View::new(Area::WHOLE, Camera::new(0.3, 0.2, 5.0));
        let extents = vec![Vec2::new(60.0, 20.0); labels.len()];
        view.labels = labels;
        let pixels = Vec2::new(640.0, 480.0);
        let places = place(&view, &ViewUniform::new(&view, pixels, 1.0), &extents, &[], pixels, 1.0);
        places.into_iter().map(|place| place.map_or(-1.0, |place| place.opacity)).collect()
    }

    #[test]
    fn of_two_labels_in_one_place_the_more_important_one_is_seen() {
        // Those that stand still make room for each other.
        assert_eq!(opacities(vec![label(Vec3::ZERO, 1, false), label(Vec3::ZERO, 2, false)]), [1.0, 1.0]);
        // One that moves does not, and what it covers is gone.
        assert_eq!(opacities(vec![label(Vec3::ZERO, 1, false), label(Vec3::ZERO, 2, true)]), [0.0, 1.0]);
        assert_eq!(opacities(vec![label(Vec3::ZERO, 2, false), label(Vec3::ZERO, 1, true)]), [1.0, 0.0]);
        assert_eq!(opacities(vec![label(Vec3::ZERO, 1, true), label(Vec3::ZERO, 1, true)]), [1.0, 0.0]);
        assert_eq!(opacities(vec![label(Vec3::ZERO, 1, false), label(Vec3::Z * 0.8, 2, true)]), [1.0, 1.0]);
    }
}
