//! Where the labels of a pane go: beside what they name and inside the pane. Those that stand still keep clear of each
//! other, and off the way of what moves as far as it is known. Those that move stay where they want to be, since a label that jumps aside draws the eye; what they pass gives
//! way to them, or they to it, by fading.

use glam::{Vec2, Vec3};

use super::pane::PaneUniform;
use crate::frame::{Label, Pane};

/// Free space between labels, and at the rim of the pane (points).
const CLEARANCE: f32 = 5.0;
const RIM: f32 = 9.0;
/// Free space between a label and its leader, and the shortest that is drawn (points).
const OFF_LEADER: f32 = 3.0;
const SHORTEST_LEADER: f32 = 6.0;
/// How much a label gives to stay near its wanted direction, against covering a mark.
const MARK_COST: f32 = 1.5;
/// And against standing where something passes at times, and for the part of its way on which it does so.
const PASSED_COST: [f32; 2] = [1.0, 8.0];
/// And against naming what it names at another place than the wanted one; where one place is about as good as another.
const ELSEWHERE_COST: f32 = 2.0;
const ANYWHERE_COST: f32 = 1.0;
/// Places along a way at which what passes is looked at, and how near to the way (in the pane's world) what follows it is.
const PLACES: usize = 96;
const FOLLOWS_WITHIN: f32 = 0.06;

/// Distance (points) at which a label begins to fade before a more important one; where they meet it is gone.
const FADES_WITHIN: f32 = 12.0;

/// Where a label stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// Its top left corner, in pixels of the pane.
    pub(super) low: Vec2,
    /// Factor on its opacity.
    pub(super) opacity: f32,
    /// The stroke that joins it to what it names, in pixels of the pane, where it has one.
    pub(super) leader: Option<[Vec2; 2]>,
}

/// A rectangle in pixels of the pane, y down.
#[derive(Clone, Copy, Debug)]
pub(super) struct Box2 {
    pub(super) low: Vec2,
    pub(super) high: Vec2,
}

impl Box2 {
    fn around(centre: Vec2, half: Vec2) -> Self {
        Self { low: centre - half, high: centre + half }
    }

    pub(super) fn meets(&self, other: &Self) -> bool {
        self.low.cmplt(other.high).all() && other.low.cmplt(self.high).all()
    }

    /// The stroke from just beside it to a place; none where that is too near.
    fn leader_to(&self, place: Vec2, point: f32) -> Option<[Vec2; 2]> {
        let from = place.clamp(self.low, self.high);
        let way = place - from;
        let long = way.length() - OFF_LEADER * point;
        (long >= SHORTEST_LEADER * point).then(|| [place - way.normalize_or_zero() * long, place])
    }

    /// Width of the gap between two; 0 where they meet.
    fn gap(&self, other: &Self) -> f32 {
        (other.low - self.high).max(self.low - other.high).max(Vec2::ZERO).length()
    }
}

/// Places the labels, given each one's width and height in pixels and what else stands in the pane; none for a label
/// that is out of sight or finds no room.
pub(super) fn place(
    pane: &Pane,
    uniform: &PaneUniform,
    extents: &[Vec2],
    notes: &[Box2],
    pixels: Vec2,
    point: f32,
) -> Vec<Option<Place>> {
    let project = |position: Vec3| {
        let ndc = uniform.ndc(position).filter(|ndc| ndc.abs().max_element() <= 1.0)?;
        Some((ndc * Vec2::new(0.5, -0.5) + 0.5) * pixels)
    };
    let passing = passing(pane, extents, point, project);
    let marks = pane.markers.iter().filter(|mark| !mark.moves).map(|mark| (mark.position, 0.5 * mark.size));
    // Straight strokes, as axes are, count by some places along them.
    let strokes = pane.lines.iter().filter(|line| line.points.len() == 2).flat_map(|line| {
        let [from, to] = [line.points[0].position, line.points[1].position];
        [0.1, 0.35, 0.6, 0.85].map(|part| (from.lerp(to, part), line.width))
    });
    let marks: Vec<Box2> = marks
        .chain(strokes)
        .filter_map(|(position, half)| Some(Box2::around(project(position)?, Vec2::splat(half * point))))
        .collect();
    let mut order: Vec<usize> = (0..pane.labels.len().min(extents.len())).collect();
    order.sort_by_key(|&number| {
        (pane.labels[number].style.moves, std::cmp::Reverse(pane.labels[number].style.priority))
    });
    let clear = pane.kept_clear.iter();
    let clear = clear.filter_map(|[low, high]| Some(Box2 { low: project(*low)?, high: project(*high)? }));
    let mut taken: Vec<Box2> = notes.iter().copied().chain(clear).collect();
    let mut places: Vec<Option<Box2>> = vec![None; pane.labels.len()];
    let mut leaders = vec![None; pane.labels.len()];
    for number in order {
        let label = &pane.labels[number];
        let Some(anchor) = project(label.anchor) else { continue };
        let half = 0.5 * extents[number];
        let kept_inside = |centre: Vec2| {
            let rim = half + RIM * point;
            centre.clamp(rim.min(0.5 * pixels), (pixels - rim).max(0.5 * pixels))
        };
        if label.style.moves {
            let wanted = candidates(label, (anchor, label.toward), half, point).next();
            places[number] = wanted.map(|(centre, _)| Box2::around(kept_inside(centre), half));
            continue;
        }
        let elsewhere = if label.style.is_anywhere { ANYWHERE_COST } else { ELSEWHERE_COST };
        let others = label.others.iter().filter_map(|&(at, toward)| Some((project(at)?, toward, elsewhere)));
        let best = std::iter::once((anchor, label.toward, 0.0))
            .chain(others)
            .flat_map(|(at, toward, extra)| {
                candidates(label, (at, toward), half, point).map(move |(centre, cost)| (centre, at, cost + extra))
            })
            .filter_map(|(centre, at, cost)| {
                let inside = kept_inside(centre);
                let own = Box2::around(inside, half + 0.5 * CLEARANCE * point);
                if taken.iter().any(|other| own.meets(other)) {
                    return None;
                }
                let covered = marks.iter().filter(|mark| own.meets(mark)).count() as f32;
                let passed = passing.iter().filter(|boxes| boxes.iter().any(|other| own.meets(other))).count() as f32;
                let passed =
                    if passed > 0.0 { PASSED_COST[0] + PASSED_COST[1] * passed / passing.len() as f32 } else { 0.0 };
                let pushed = inside.distance(centre) / (20.0 * point);
                Some((inside, at, cost + pushed + passed + MARK_COST * covered))
            })
            .min_by(|a, b| a.2.total_cmp(&b.2));
        if let Some((centre, at, _)) = best {
            taken.push(Box2::around(centre, half + 0.5 * CLEARANCE * point));
            let own = Box2::around(centre, half);
            places[number] = Some(own);
            leaders[number] = own.leader_to(at, point).filter(|_| label.style.leads);
        }
    }
    let opacity = |number: usize, own: &Box2| {
        let label = &pane.labels[number];
        let rank = |number: usize| (pane.labels[number].style.priority, std::cmp::Reverse(number));
        let others = places.iter().enumerate().filter_map(|(other, place)| Some((other, (*place)?)));
        let others = others
            .filter(|(other, _)| (pane.labels[*other].style.moves || label.style.moves) && rank(*other) > rank(number));
        // A label that stands still gives way to moving marks as well, one that moves to what is written in the corner.
        let marks = pane.markers.iter().filter(|mark| mark.moves && !label.style.moves);
        let marks =
            marks.filter_map(|mark| Some(Box2::around(project(mark.position)?, Vec2::splat(0.5 * mark.size * point))));
        let notes = notes.iter().filter(|_| label.style.moves).copied();
        let gaps = others.map(|(_, place)| place).chain(marks).chain(notes).map(|other| own.gap(&other));
        gaps.fold(1.0, |least: f32, gap| least.min(gap / (FADES_WITHIN * point)))
    };
    let stand = |(number, place): (usize, &Option<Box2>)| {
        let leader = leaders[number];
        place.as_ref().map(|own| Place { low: own.low.round(), opacity: opacity(number, own), leader })
    };
    places.iter().enumerate().map(stand).collect()
}

/// At each of some places along the ways: what then stands in the way of labels that stand still, with
/// the distance within which they fade before it.
fn passing(pane: &Pane, extents: &[Vec2], point: f32, project: impl Fn(Vec3) -> Option<Vec2>) -> Vec<Vec<Box2>> {
    let mut passing = vec![];
    for way in &pane.ways {
        let follows = |at: Vec3| way.iter().any(|on| on.distance(at) < FOLLOWS_WITHIN);
        let markers = pane.markers.iter().filter(|marker| marker.moves && follows(marker.position));
        let markers: Vec<Vec2> = markers.map(|marker| Vec2::splat(0.5 * marker.size * point)).collect();
        let labels = pane.labels.iter().zip(extents).filter(|(label, _)| label.style.moves && follows(label.anchor));
        let labels: Vec<(&Label, Vec2)> = labels.map(|(label, extent)| (label, 0.5 * *extent)).collect();
        let rim = Vec2::splat(FADES_WITHIN * point);
        let every = way.len().div_ceil(PLACES).max(1);
        for at in way.iter().step_by(every).filter_map(|on| project(*on)) {
            let beside = |(label, half): &(&Label, Vec2)| {
                let wanted = candidates(label, (at, label.toward), *half, point).next();
                wanted.map(|(centre, _)| Box2::around(centre, *half + rim))
            };
            let on_it = markers.iter().map(|half| Box2::around(at, *half + rim));
            passing.push(on_it.chain(labels.iter().filter_map(beside)).collect());
        }
    }
    passing
}

/// Centres to try, each with what it costs: turned away from the wanted direction, and farther out.
fn candidates(
    label: &Label,
    (anchor, toward): (Vec2, Vec2),
    half: Vec2,
    point: f32,
) -> impl Iterator<Item = (Vec2, f32)> {
    const TURNS: [f32; 11] = [0.0, 25.0, -25.0, 50.0, -50.0, 80.0, -80.0, 115.0, -115.0, 150.0, 180.0];
    let wanted = Vec2::new(toward.x, -toward.y).normalize_or(Vec2::X);
    let gap = label.style.gap * point;
    TURNS.into_iter().flat_map(move |turn| {
        [1.0, 2.2, 4.0].map(|reach| {
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
    use crate::frame::{Area, Color, Label, LabelStyle, Mark, Marker, Pane};
    use crate::render::pane::PaneUniform;
    use glam::{Vec2, Vec3};

    fn label(anchor: Vec3, priority: i32, moves: bool) -> Label {
        let color = Color::hex(0);
        let style = LabelStyle { size: 20.0, gap: 5.0, priority, moves, leads: false, is_anywhere: false };
        Label::new(anchor, Vec2::X, "", color, style)
    }

    fn opacities(labels: Vec<Label>) -> Vec<f32> {
        let mut pane = Pane::new(Area::WHOLE, Camera::new(0.3, 0.2, 5.0), 0.0);
        let extents = vec![Vec2::new(60.0, 20.0); labels.len()];
        pane.labels = labels;
        let pixels = Vec2::new(640.0, 480.0);
        let places = place(&pane, &PaneUniform::new(&pane, pixels, 1.0), &extents, &[], pixels, 1.0);
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

    #[test]
    fn a_stroke_leads_from_a_name_to_what_it_names() {
        let leader = |gap, leads| {
            let mut pane = Pane::new(Area::WHOLE, Camera::new(0.0, 0.0, 5.0), 0.0);
            let mut own = label(Vec3::ZERO, 1, false);
            own.style = LabelStyle { gap, leads, ..own.style };
            pane.labels.push(own);
            let pixels = Vec2::new(640.0, 480.0);
            let places =
                place(&pane, &PaneUniform::new(&pane, pixels, 1.0), &[Vec2::new(60.0, 20.0)], &[], pixels, 1.0);
            places[0].and_then(|place| place.leader)
        };
        // From the left edge of the name, 3 points off, to the middle of the picture.
        assert_eq!(leader(20.0, true), Some([Vec2::new(337.0, 240.0), Vec2::new(320.0, 240.0)]));
        assert_eq!((leader(20.0, false), leader(5.0, true)), (None, None));
    }

    #[test]
    fn a_name_keeps_off_the_way_of_what_will_pass_it() {
        let camera = Camera::new(0.0, 0.0, 5.0);
        let (pixels, extents) = (Vec2::new(640.0, 480.0), [Vec2::new(60.0, 20.0)]);
        let low = |is_known: bool| {
            let mut pane = Pane::new(Area::WHOLE, camera, 0.0);
            pane.labels = vec![label(Vec3::ZERO, 1, false)];
            // From the anchor to the right, where the name would like to stand; what moves is at its far end now.
            if is_known {
                pane.ways.push((0..=50).map(|n| Vec3::new(0.0, 0.006 * n as f32, 0.0)).collect());
            }
            let (position, color) = (Vec3::Y * 0.3, Color::hex(0));
            let (mark, rim) = (Mark::Disc, color);
            pane.markers.push(Marker { position, size: 16.0, mark, color, rim, hidden: 0.0, moves: true });
            let places = place(&pane, &PaneUniform::new(&pane, pixels, 1.0), &extents, &[], pixels, 1.0);
            places[0].map_or(Vec2::ZERO, |place| place.low)
        };
        // Beside the anchor, in the middle of the picture; else clear of the whole way.
        assert_eq!(low(false), Vec2::new(325.0, 230.0));
        let clear = low(true);
        assert!(clear.y + 20.0 < 240.0 - 8.0 || clear.y > 240.0 + 8.0 || clear.x + 60.0 < 320.0 - 8.0, "{clear}");
    }
}
