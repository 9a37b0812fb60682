//! Dots of the unit sphere, as the ends of a pen set down: one path for many of them.
//!
//! A path covers what it goes over twice no more than once. Where translucent dots lie over each other, as the picture's do, they
//! are of different paths, up to as many as the eye tells apart.

use std::collections::HashMap;

use glam::DVec2;

use super::drawing::{Paint, Path, Pen, Shape, Step};
use super::lines::Projection;
use super::sight::Sight;
use crate::frame::{Color, Dot, Pane};

/// How far dots are drawn before the sphere that they lie on, as a factor on their depth.
const LIFT: f64 = 1.014;
/// Opacity of those on the far side.
const FAR: f32 = 0.3;
/// Most dots over each other: of nine on the far side, each would change what is seen through the others by 2 %.
const LAYERS: usize = 9;

/// A dot on the screen.
struct Spot {
    pixel: DVec2,
    is_near: bool,
}

/// Adds the dots of a pane: of each colour and size those that shine through first.
pub(super) fn draw(pane: &Pane, sight: &Sight, projection: &Projection, shapes: &mut Vec<Shape>) {
    let eye = pane.camera.eye();
    let alike = |a: &Dot, b: &Dot| a.color == b.color && a.size.to_bits() == b.size.to_bits();
    for dots in pane.dots.chunk_by(alike) {
        let Some(&Dot { size, color, .. }) = dots.first() else { continue };
        let pen = Pen { width: (f64::from(size) * projection.point).max(projection.thinnest), is_round: true };
        let spots = dots.iter().filter_map(|dot| {
            let is_near = dot.position.dot(eye - dot.position) > 0.0;
            // The far side's are drawn before all surfaces.
            let is_hidden = || is_near && sight.hides(dot.position.as_dvec3(), LIFT);
            let pixel = projection.pixel(dot.position.as_dvec3())?;
            (!is_hidden()).then_some(Spot { pixel, is_near })
        });
        let spots: Vec<Spot> = spots.collect();
        for (is_near, color) in [(false, color.fade(FAR)), (true, color)] {
            let pixels = spots.iter().filter(|spot| spot.is_near == is_near).map(|spot| spot.pixel);
            strokes(pixels, pen, color, shapes);
        }
    }
}

/// Adds dots of one colour.
fn strokes(pixels: impl Iterator<Item = DVec2>, pen: Pen, color: Color, shapes: &mut Vec<Shape>) {
    let layers = if color.0[3] < 1.0 { LAYERS } else { 1 };
    let mut paths = vec![Path::default(); layers];
    for (pixel, layer) in layered(pixels, pen.width, layers) {
        paths[layer].0.extend([Step::Move(pixel), Step::Line(pixel + DVec2::new(0.01, 0.0))]);
    }
    let drawn = paths.into_iter().filter(|path| !path.0.is_empty());
    shapes.extend(drawn.map(|path| Shape::Stroke { path, pen, paint: Paint::Flat(color) }));
}

/// Each place with the first layer in which no other is nearer than this, or the last one.
fn layered(pixels: impl Iterator<Item = DVec2>, nearest: f64, layers: usize) -> Vec<(DVec2, usize)> {
    let cell = |pixel: DVec2| ((pixel.x / nearest).floor() as i64, (pixel.y / nearest).floor() as i64);
    let mut cells: HashMap<(i64, i64), Vec<(DVec2, usize)>> = HashMap::new();
    let mut placed = vec![];
    for pixel in pixels {
        let (x, y) = cell(pixel);
        let mut is_taken = vec![false; layers];
        for neighbour in (x - 1..=x + 1).flat_map(|x| (y - 1..=y + 1).map(move |y| (x, y))) {
            for (other, layer) in cells.get(&neighbour).into_iter().flatten() {
                is_taken[*layer] |= other.distance(pixel) < nearest;
            }
        }
        let layer = is_taken.iter().position(|taken| !taken).unwrap_or(layers - 1);
        cells.entry((x, y)).or_default().push((pixel, layer));
        placed.push((pixel, layer));
    }
    placed
}

#[cfg(test)]
mod tests {
    use super::layered;
    use glam::DVec2;

    #[test]
    fn dots_over_each_other_are_of_different_layers() {
        let at = [0.0, 1.9, 4.1, 0.5, 1.0].map(|x| DVec2::new(x, -0.1));
        let layers: Vec<usize> = layered(at.into_iter(), 2.0, 3).into_iter().map(|(_, layer)| layer).collect();
        assert_eq!(layers, [0, 1, 0, 2, 2]);
    }
}
