//! A page of a handout: title, words and question, the picture of a step, and below it M's course as a graph.

use std::f32::consts::FRAC_PI_2;

use glam::{Vec2, Vec3};

use super::{Cameras, Context, Palette, Space, body_axes, build_frame, check_at, labels};
use crate::camera::Camera;
use crate::frame::{Area, Color, Dash, Frame, Label, LabelStyle, Line, Mark, Marker, Note, Pane};
use crate::physics::poinsot;
use crate::scene::{Layout, Scene, SceneError, SceneFile, Theme};
use crate::sim::Simulation;

/// Width and height of a page in pixels: A4 across at 150 dpi.
pub const PAGE: [u32; 2] = [1754, 1240];
/// The same on paper (points of 1/72 in).
pub const PAGE_ON_PAPER: [f64; 2] = [841.89, 595.276];

/// Width and height of a page in points of its type.
const POINTS: [f32; 2] = [1280.0, 904.9];
/// Sizes of the title and of the words (points), height of a row in that, and free space above and below them.
const TITLE: f32 = 31.0;
const WORDS: f32 = 21.0;
const ROW: f32 = 1.36;
const SPACE: f32 = 22.0;
/// Mean width of a character in heights of its type: the wider guess, so that words never run into the picture.
const CHARACTER: f32 = 0.53;
/// Height of the graph as a part of the page.
const GRAPH: f32 = 0.21;
/// Where the curve of a whole momentum lies in the graph, whose half height is 1.
const WHOLE: f32 = 0.55;
/// How far the curves reach to the left and right, as parts of the half width.
const REACH: f32 = 0.9;
const CURVE: u32 = 400;
/// How much of the time to the first flip has passed where nobody says a time: the body is seen turning over.
const TELLING: f64 = 0.95;
/// Periods that the graph shows.
const SHOWN: f64 = 2.5;
/// Most flips that are marked.
const MOST_FLIPS: u32 = 12;
const TICK: LabelStyle = LabelStyle { size: 16.0, priority: 3, ..labels::FLOOR };

/// The pages of a scene: one a step, or one where it is told as a whole; for print where it says no theme.
///
/// # Errors
/// What is no scene: one sentence.
pub fn pages(file: &SceneFile) -> Result<Vec<Scene>, SceneError> {
    let mut file = file.clone();
    file.view.theme = file.view.theme.or(Some(Theme::Light));
    let steps = file.steps.len();
    if steps == 0 {
        return Ok(vec![check_at(&file, None)?]);
    }
    (0..steps).map(|step| check_at(&file, Some(step))).collect()
}

/// The time (s) that the page of a scene shows: that of its step, else one at which much is seen.
#[must_use]
pub fn page_time(scene: &Scene) -> f64 {
    let said = scene.file.pace_at(scene.at).time;
    let flip = poinsot::next_flip_of(&scene.body, &scene.start).filter(|_| scene.energy_loss == 0.0);
    said.or(flip.map(|flip| TELLING * flip)).filter(|time| time.is_finite()).unwrap_or(0.0)
}

/// The page of a scene as its simulation is now, with the answer to its question or without.
#[must_use]
pub fn build_page(scene: &Scene, simulation: &Simulation, has_answer: bool) -> Frame {
    let palette = Palette::new(scene.view.theme);
    let (notes, height) = words(scene, &palette, has_answer);
    let top = (height / POINTS[1]).min(0.5);
    let aspect = PAGE[0] as f32 / PAGE[1] as f32;
    let middle = Area { corner: Vec2::new(0.0, top), extent: Vec2::new(1.0, 1.0 - top - GRAPH) };
    let mut frame = build_frame(scene, simulation, &Cameras::new(&scene.view), aspect / middle.extent.y);
    for pane in &mut frame.panes {
        let Area { corner, extent } = pane.area;
        pane.area = Area { corner: middle.corner + corner * middle.extent, extent: extent * middle.extent };
        // On paper nothing moves: what would pass a name at other times stands where it is.
        if !pane.ways.is_empty() {
            pane.ways = pane.markers.iter().filter(|mark| mark.moves).map(|mark| vec![mark.position]).collect();
        }
    }
    let head = Area { corner: Vec2::ZERO, extent: Vec2::new(1.0, top) };
    let mut pane = Pane::new(head, *Cameras::new(&scene.view).of(Space::World), 0.0);
    pane.notes = notes;
    frame.panes.push(pane);
    let foot = Area { corner: Vec2::new(0.0, 1.0 - GRAPH), extent: Vec2::new(1.0, GRAPH) };
    frame.panes.push(graph(&Context::new(scene, simulation, &palette), foot, aspect / GRAPH));
    frame
}

/// What is said above the picture, and how high it is (points).
fn words(scene: &Scene, palette: &Palette, has_answer: bool) -> (Vec<Note>, f32) {
    let file = &scene.file;
    let count = file.steps.len();
    let place = scene.at.map_or(String::new(), |step| format!(" · step {} of {count}", step + 1));
    let asks = file.asks_at(scene.at);
    let question = if asks { flowing(&file.question) } else { String::new() };
    let answer = if asks && has_answer { flowing(&file.answer) } else { String::new() };
    let parts = [
        (format!("{}{place}", flowing(&file.title_at(scene.at))), TITLE, palette.ink),
        (flowing(file.text_at(scene.at)), WORDS, palette.ink),
        (question, WORDS, palette.axes[0]),
        (answer, WORDS, palette.ink),
    ];
    let mut height = SPACE;
    let mut notes = vec![];
    for (text, size, color) in parts.into_iter().filter(|(text, ..)| !text.is_empty()) {
        let in_a_row = (POINTS[0] - 28.0) / (CHARACTER * size);
        height += ROW * size * (text.chars().count() as f32 / in_a_row).ceil();
        notes.push(Note { text, size, color, swatch: None });
    }
    (notes, height)
}

/// A text in one line: where it is broken the page says.
fn flowing(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// M's components over time, in parts of its length at the start, with a line at the picture's time.
fn graph(context: &Context<'_>, area: Area, aspect: f32) -> Pane {
    // Seen straight from the front, x to the right and z up; the half height of the pane is 1.
    let distance = 1.0 / (0.5 * Camera::vertical_field(aspect)).tan();
    let mut pane = Pane::new(area, Camera::new(-FRAC_PI_2, 0.0, distance), 0.0);
    let palette = context.palette;
    let unit = context.scene.view.time_unit.sign();
    let time = context.simulation.time();
    // Before M is spoken of only how the body stands is: as L points up, that is M along the axis of the spin, too.
    let is_upright = context.settings.layout == Layout::World && context.shows(&super::ENDS);
    let what = if is_upright {
        "How far up its top points: 1 as at the start, −1 turned over"
    } else {
        "M along axes 1, 2, 3, in parts of its length"
    };
    let said = format!("{what}; the picture is that of t = {}", said(time, unit));
    pane.notes.push(Note { text: said, size: 17.0, color: palette.ink, swatch: None });
    let span = SHOWN * context.period();
    // From the start where that holds the picture's time, else about it.
    let low = if (0.0..=0.9 * span).contains(&time) { 0.0 } else { time - 0.5 * span };
    let width = REACH * aspect;
    let across = |at: f64| (2.0 * ((at - low) / span) as f32 - 1.0) * width;
    let soft = palette.ink.alpha(0.35);
    for (height, name) in [(1.0, "1"), (0.0, "0"), (-1.0, "−1")] {
        let [left, right] = [-width, width].map(|x| Vec3::new(x, 0.0, WHOLE * height));
        pane.lines.push(Line::new([left, right], 1.2, soft));
        pane.labels.push(Label::new(left, Vec2::NEG_X, name, palette.ink, TICK));
    }
    if context.unit_momentum().is_none() {
        return pane;
    }
    mark_flips(context, &mut pane, (low, low + span), across);
    let states = context.simulation.around(low - time, low + span - time, CURVE);
    let first = body_axes::started_about(context);
    let start = context.body_momentum(context.scene.start.body_momentum);
    let sign = if is_upright { start[first].signum() } else { 1.0 };
    let drawn = palette.axes.into_iter().enumerate().filter(|(axis, _)| !is_upright || *axis == first);
    for (axis, color) in drawn {
        let points = states.iter().enumerate().map(|(n, state)| {
            let at = low + span * n as f64 / f64::from(CURVE);
            Vec3::new(across(at), 0.0, WHOLE * sign * context.body_momentum(state.body_momentum)[axis])
        });
        let points: Vec<Vec3> = points.filter(|point| point.is_finite()).collect();
        let end = points.last().copied();
        pane.lines.push(Line::new(points, 2.6, color));
        let Some(end) = end else { continue };
        let name = if is_upright { "top" } else { body_axes::NUMBERS[axis] };
        pane.labels.push(Label::new(end, Vec2::X, name, color, labels::AXIS));
        let now = sign * context.body_momentum(context.simulation.state().body_momentum)[axis];
        let (rim, position) = (palette.background, Vec3::new(across(time), 0.0, WHOLE * now));
        pane.markers.push(Marker { position, size: 11.0, mark: Mark::Disc, color, rim, hidden: 1.0, moves: false });
    }
    let [foot, head] = [-1.15, 1.15].map(|height| Vec3::new(across(time), 0.0, WHOLE * height));
    pane.lines.push(Line::new([foot, head], 2.0, palette.momentum));
    for at in [low, low + span] {
        let place = Vec3::new(across(at), 0.0, -1.12 * WHOLE);
        pane.labels.push(Label::new(place, Vec2::NEG_Y, &said_short(at, unit), palette.ink, TICK));
    }
    pane
}

/// Marks the flips between two times.
fn mark_flips(context: &Context<'_>, pane: &mut Pane, (low, high): (f64, f64), across: impl Fn(f64) -> f32) {
    let scene = context.scene;
    let Some(first) = poinsot::next_flip_of(&scene.body, &scene.start).filter(|_| scene.energy_loss == 0.0) else {
        return;
    };
    let period = poinsot::flip_period_of(&scene.body, &scene.start).unwrap_or(f64::INFINITY);
    let color: Color = context.palette.ink.alpha(0.6);
    for n in 0..MOST_FLIPS {
        let number = ((low - first) / period).ceil().max(0.0) + f64::from(n);
        let at = if number == 0.0 { first } else { first + number * period };
        if !(low..=high).contains(&at) {
            break;
        }
        let [foot, head] = [-1.12, 1.12].map(|height| Vec3::new(across(at), 0.0, WHOLE * height));
        pane.lines.push(Line::new([foot, head], 1.4, color).dashed(Dash::Dashed(0.06)));
        pane.labels.push(Label::new(foot, Vec2::NEG_Y, "flip", color.alpha(1.0), TICK));
    }
}

/// A time with its unit.
fn said(time: f64, unit: &str) -> String {
    format!("{time:.2}\u{a0}{unit}").replace('-', "−")
}

/// The same in as few digits as a tick wants.
fn said_short(time: f64, unit: &str) -> String {
    let digits = usize::from(time.abs() < 10.0);
    format!("{time:.digits$}\u{a0}{unit}").replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::{build_page, page_time, pages};
    use crate::scene::{SceneError, Theme, presets};
    use crate::sim::Simulation;

    #[test]
    fn every_scene_has_a_page_a_step_with_its_words_its_picture_and_a_graph() -> Result<(), SceneError> {
        for preset in presets() {
            let file = preset.read()?;
            let pages = pages(&file)?;
            assert_eq!(pages.len(), file.steps.len().max(1));
            for scene in &pages {
                assert_eq!(scene.view.theme, file.view.theme.unwrap_or(Theme::Light));
                let mut simulation = Simulation::new(scene);
                simulation.go_to(page_time(scene).min(100.0));
                let frame = build_page(scene, &simulation, true);
                let texts: Vec<&str> =
                    frame.panes.iter().flat_map(|pane| &pane.notes).map(|note| note.text.as_str()).collect();
                let holds = |words: &str| {
                    let first = words.split_whitespace().next().unwrap_or_default();
                    texts.iter().any(|text| text.contains(first))
                };
                assert!(holds(&file.title) && holds(file.text_at(scene.at)), "{}", preset.name);
                assert!(!file.asks_at(scene.at) || (holds(&file.question) && holds(&file.answer)), "{}", preset.name);
                // The parts lie on the page and beside each other.
                let [.., head, graph] = frame.panes.as_slice() else { continue };
                assert!(frame.panes.len() > 2 && !graph.lines.is_empty() && !graph.labels.is_empty());
                for pane in &frame.panes[..frame.panes.len() - 2] {
                    let (low, high) = (pane.area.corner.y, pane.area.corner.y + pane.area.extent.y);
                    assert!(low >= head.area.extent.y - 1e-6 && high <= graph.area.corner.y + 1e-6);
                    assert!(pane.area.extent.y > 0.25, "{}: the words leave no room", preset.name);
                }
            }
        }
        Ok(())
    }
}
