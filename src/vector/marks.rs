//! Marks as areas: the forms of `shaders/marker.wgsl`, and their rims.

use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2, TAU};

use glam::{DVec2, DVec3};

use super::drawing::{Paint, Path, Shape};
use super::lines::Projection;
use super::sight::Sight;
use crate::frame::{Color, Mark, Marker};

/// Width of the rim (points).
const RIM: f64 = 1.4;
/// How far marks are drawn before the surfaces they lie on, as a factor on their depth.
const LIFT: f64 = 1.014;
/// Directions in which the border between what is seen of a mark and what is not is looked for, and the steps to it.
const DIRECTIONS: usize = 48;
const STEPS: usize = 8;
const HALVINGS: usize = 12;

/// What of a mark is hidden.
enum Hidden {
    /// All or nothing.
    Whole(bool),
    /// What lies outside of this border; or inside.
    Beyond { border: Path, middle_is_hidden: bool },
}

/// Adds the marks of a pane: what is hidden of all of them first.
pub(super) fn draw(
    markers: &[Marker],
    sight: &Sight,
    across: [DVec3; 2],
    projection: &Projection,
    shapes: &mut Vec<Shape>,
) {
    let mut seen = vec![];
    for marker in markers {
        let Some(middle) = projection.pixel(marker.position.as_dvec3()) else { continue };
        let radius = 0.5 * f64::from(marker.size) * projection.point;
        let reach = 1.5 * radius + 2.0 + RIM * projection.point;
        let paint = |opacity: f32, is_hidden: bool, shapes: &mut Vec<Shape>| {
            let list = painted(marker, middle, radius, RIM * projection.point, opacity);
            match hidden(marker, middle, reach, sight, across, projection) {
                Hidden::Whole(hidden) if hidden == is_hidden => shapes.extend(list),
                Hidden::Beyond { mut border, middle_is_hidden } => {
                    if is_hidden != middle_is_hidden {
                        let rim = DVec2::splat(2.0 * reach);
                        border.append(Path::rectangle(middle - rim, middle + rim));
                    }
                    shapes.push(Shape::Group { clip: border, shapes: list });
                }
                Hidden::Whole(_) => {}
            }
        };
        if marker.hidden > 0.0 {
            paint(marker.hidden, true, shapes);
        }
        paint(1.0, false, &mut seen);
    }
    shapes.extend(seen);
}

/// Looks round the middle of a mark, which is drawn flat at its depth, for where surfaces begin to hide it.
fn hidden(
    marker: &Marker,
    middle: DVec2,
    reach: f64,
    sight: &Sight,
    [right, down]: [DVec3; 2],
    projection: &Projection,
) -> Hidden {
    let centre = marker.position.as_dvec3();
    // How far a pixel reaches at the mark's depth.
    let at = |offset: DVec2| {
        let depth = (projection.clip * centre.extend(1.0)).w;
        centre + (right * offset.x + down * offset.y) * depth
    };
    let is_hidden = |offset: DVec2| sight.hides(at(offset), LIFT);
    let middle_is_hidden = is_hidden(DVec2::ZERO);
    let mut border = vec![];
    let mut is_whole = true;
    for number in 0..DIRECTIONS {
        let direction = DVec2::from_angle(TAU * number as f64 / DIRECTIONS as f64);
        let step = reach / STEPS as f64;
        let changed = (1..=STEPS).map(|n| n as f64 * step).find(|far| is_hidden(direction * *far) != middle_is_hidden);
        let mut far = reach;
        if let Some(first) = changed {
            is_whole = false;
            let (mut low, mut high) = (first - step, first);
            for _ in 0..HALVINGS {
                let half = 0.5 * (low + high);
                if is_hidden(direction * half) == middle_is_hidden { low = half } else { high = half }
            }
            far = 0.5 * (low + high);
        }
        border.push(middle + direction * far);
    }
    if is_whole {
        Hidden::Whole(middle_is_hidden)
    } else {
        Hidden::Beyond { border: Path::through(border, true), middle_is_hidden }
    }
}

/// A mark with its rim at this strength.
fn painted(marker: &Marker, middle: DVec2, radius: f64, rim: f64, opacity: f32) -> Vec<Shape> {
    let inner = outline(marker.mark, middle, radius, 0.0);
    let mut outer = outline(marker.mark, middle, radius, rim);
    let is_opaque = marker.rim.0[3] * opacity >= 1.0 && marker.color.0[3] >= 1.0;
    if !is_opaque {
        // The rim alone: nothing shows through twice.
        outer.append(inner.clone());
    }
    let paint = if marker.mark == Mark::Disc {
        ball(marker.color.fade(opacity), middle, radius)
    } else {
        Paint::Flat(marker.color.fade(opacity))
    };
    vec![
        Shape::Fill { path: outer, even_odd: true, paint: Paint::Flat(marker.rim.fade(opacity)) },
        Shape::Fill { path: inner, even_odd: true, paint },
    ]
}

/// A ball is lighter towards the upper left.
fn ball(color: Color, middle: DVec2, radius: f64) -> Paint {
    let stops = (0..=4).map(|n| {
        let away = n as f32 / 4.0;
        let high = 1.0 - away;
        let [r, g, b, alpha] = color.0;
        let shaded = [r, g, b].map(|channel| {
            let channel = channel * (0.82 + 0.3 * high);
            (channel + (1.0 - channel) * 0.25 * high * high).clamp(0.0, 1.0)
        });
        (f64::from(away), Color([shaded[0], shaded[1], shaded[2], alpha]))
    });
    let axes = [DVec2::X * radius, DVec2::Y * radius, middle + DVec2::splat(-0.35 * radius)];
    Paint::Around { axes, stops: stops.collect() }
}

/// The outline of a form, drawn out by so many pixels; holes are gone round within what they are in (even and odd).
fn outline(mark: Mark, middle: DVec2, radius: f64, out: f64) -> Path {
    let polygon =
        |corners: &[[f64; 2]]| Path::through(corners.iter().map(|&[x, up]| middle + DVec2::new(x, -up)), true);
    // With a hole where a stroke goes round one.
    let open = |size: f64, form: &dyn Fn(f64) -> Path, widened: f64| {
        let mut path = form(size + widened);
        if size > widened {
            path.append(form(size - widened));
        }
        path
    };
    let stroke = 0.2 * radius + out;
    let square = |half: f64| polygon(&[[-half, -half], [half, -half], [half, half], [-half, half]]);
    let diamond = |half: f64| polygon(&[[half, 0.0], [0.0, half], [-half, 0.0], [0.0, -half]]);
    // By the radius of the circle in it; up or down.
    let triangle = |inner: f64, up: f64| {
        let side = 3.0_f64.sqrt() * inner;
        polygon(&[[-side, -inner * up], [side, -inner * up], [0.0, 2.0 * inner * up]])
    };
    let hourglass = |half: f64, turn: &dyn Fn(f64, f64) -> [f64; 2]| {
        let (high, waist) = (half + out, out / 0.743);
        let wide = waist + 0.9 * high;
        let corners = [(-wide, high), (wide, high), (waist, 0.0), (wide, -high), (-wide, -high), (-waist, 0.0)];
        polygon(&corners.map(|(across, along)| turn(across, along)))
    };
    match mark {
        Mark::Disc => Path::circle(middle, radius + out),
        Mark::Ring => open(0.8 * radius, &|size| Path::circle(middle, size), stroke),
        Mark::Diamond => diamond(1.2 * radius + SQRT_2 * out),
        Mark::Square => square(0.85 * radius + out),
        Mark::Triangle => triangle(0.6 * radius + out, 1.0),
        Mark::TriangleDown => triangle(0.6 * radius + out, -1.0),
        Mark::OpenSquare => open(0.68 * radius, &square, stroke),
        Mark::OpenDiamond => open(0.95 * radius, &diamond, SQRT_2 * stroke),
        Mark::OpenTriangle => open(0.45 * radius, &|size| triangle(size, 1.0), stroke),
        Mark::OpenTriangleDown => open(0.45 * radius, &|size| triangle(size, -1.0), stroke),
        Mark::Hourglass => hourglass(0.95 * radius, &|across, along| [across, along]),
        Mark::Bow => hourglass(0.95 * radius, &|across, along| [along, across]),
        Mark::Cross => {
            let (long, wide) = (1.15 * radius + out, 0.26 * radius + out);
            let quarter = [[long, wide], [wide, wide], [wide, long], [-wide, long], [-wide, wide], [-long, wide]];
            let opposite = quarter.map(|[x, y]| [-x, -y]);
            let turned = [quarter, opposite].concat();
            let turned: Vec<_> =
                turned.iter().map(|[x, y]| [(x - y) * FRAC_1_SQRT_2, (x + y) * FRAC_1_SQRT_2]).collect();
            polygon(&turned)
        }
        Mark::Bars => {
            let (near, far, high) = (0.28 * radius - out, 0.82 * radius + out, 0.9 * radius + out);
            let bar = |low: f64, high_x: f64| polygon(&[[low, -high], [high_x, -high], [high_x, high], [low, high]]);
            if near <= 0.0 {
                return bar(-far, far);
            }
            let mut path = bar(-far, -near);
            path.append(bar(near, far));
            path
        }
        Mark::Star => {
            let reach = 0.43 * radius + out;
            let (tip, waist) = (reach / 0.36, reach / (0.36 + 0.933));
            let quarter = [[tip, 0.0], [waist, waist], [0.0, tip], [-waist, waist]];
            polygon(&[quarter, quarter.map(|[x, y]| [-x, -y])].concat())
        }
    }
}
