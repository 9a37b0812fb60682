//! Which parts of a picture anything is drawn to, so that nothing is done for the rest where every pixel is paid for.

use glam::{Vec2, Vec3};

use super::pane::PaneUniform;
use super::quadrics::covering_triangles;
use crate::frame::{Frame, Pane};

/// Side of a tile (pixels).
const TILE: f32 = 32.0;
/// Soft edges reach this much farther (pixels).
const SOFT: f32 = 2.0;
/// The largest mark reaches this many of its sizes from its middle: a diamond's tip, and its rim.
const MARK_REACH: f32 = 0.75;

/// The tiles of a picture, touched or not.
#[derive(Debug)]
pub(super) struct Touched {
    columns: usize,
    rows: usize,
    tiles: Vec<bool>,
}

impl Touched {
    /// None of a picture of this size.
    pub(super) fn none(picture: Vec2) -> Self {
        let count = (picture / TILE).ceil().max(Vec2::ONE);
        let (columns, rows) = (count.x as usize, count.y as usize);
        Self { columns, rows, tiles: vec![false; columns * rows] }
    }

    /// Adds a rectangle of the picture (pixels).
    pub(super) fn add(&mut self, low: Vec2, high: Vec2) {
        let most = Vec2::new(self.columns as f32, self.rows as f32);
        let from = (low / TILE).floor().clamp(Vec2::ZERO, most);
        let to = (high / TILE).ceil().clamp(Vec2::ZERO, most);
        for row in from.y as usize..to.y as usize {
            let start = row * self.columns;
            if let Some(touched) =
                self.tiles.get_mut(start + from.x as usize..start + (to.x as usize).max(from.x as usize))
            {
                touched.fill(true);
            }
        }
    }

    /// Adds all that a frame draws, texts aside, where `point` pixels are a point.
    pub(super) fn add_frame(&mut self, frame: &Frame, uniforms: &[PaneUniform], picture: Vec2, point: f32) {
        for (pane, uniform) in frame.panes.iter().zip(uniforms) {
            self.add_view(pane, uniform, picture, point);
        }
    }

    fn add_view(&mut self, pane: &Pane, uniform: &PaneUniform, picture: Vec2, point: f32) {
        let (corner, extent) = (pane.area.corner * picture, pane.area.extent * picture);
        let pixel = |ndc: Vec2| corner + (ndc * Vec2::new(0.5, -0.5) + 0.5) * extent;
        // What reaches behind the eye may be anywhere.
        let project = |at: Vec3| uniform.ndc(at).map(pixel);
        let mut add = |points: &mut dyn Iterator<Item = Option<Vec2>>, margin: f32| {
            let (mut low, mut high) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
            for point in points {
                let Some(point) = point else {
                    (low, high) = (corner, corner + extent);
                    break;
                };
                (low, high) = (low.min(point), high.max(point));
            }
            // Nothing is drawn outside the pane.
            self.add((low - margin).max(corner), (high + margin).min(corner + extent));
        };
        for mesh in &pane.meshes {
            add(&mut mesh.vertices.iter().map(|vertex| project(vertex.position)), SOFT);
        }
        for pair in &pane.quadrics {
            add(&mut covering_triangles(pair, uniform.clip_from_world).into_iter().map(|ndc| Some(pixel(ndc))), SOFT);
        }
        for line in &pane.lines {
            let margin = 0.5 * (line.width * point).max(1.0) + SOFT;
            for ends in line.points.windows(2) {
                add(&mut ends.iter().map(|end| project(end.position)), margin);
            }
        }
        if let Some(dot) = pane.dots.first() {
            // They may be anywhere on the unit sphere, and so within the cube round it.
            let corner = |n: u32| Vec3::new(sign(n), sign(n >> 1), sign(n >> 2));
            add(&mut (0..8).map(|n| project(corner(n))), dot.size * point + SOFT);
        }
        for mark in &pane.markers {
            add(&mut std::iter::once(project(mark.position)), (MARK_REACH * mark.size + 2.0) * point + SOFT);
        }
    }

    /// The touched tiles as few rectangles: low and high corners (pixels).
    pub(super) fn rectangles(&self) -> Vec<[Vec2; 2]> {
        let mut rectangles: Vec<[Vec2; 2]> = vec![];
        for row in 0..self.rows {
            let tiles = &self.tiles[row * self.columns..(row + 1) * self.columns];
            let mut column = 0;
            while column < self.columns {
                let run = tiles[column..].iter().take_while(|touched| **touched).count();
                if run > 0 {
                    let low = Vec2::new(column as f32, row as f32) * TILE;
                    let high = Vec2::new((column + run) as f32, (row + 1) as f32) * TILE;
                    // Goes on from the row above where it is as wide.
                    match rectangles.iter_mut().find(|[l, h]| l.x == low.x && h.x == high.x && h.y == low.y) {
                        Some([_, h]) => h.y = high.y,
                        None => rectangles.push([low, high]),
                    }
                }
                column += run.max(1);
            }
        }
        rectangles
    }
}

/// 1 or −1, by the last bit.
fn sign(bits: u32) -> f32 {
    if bits & 1 == 0 { 1.0 } else { -1.0 }
}

#[cfg(test)]
mod tests {
    use super::{TILE, Touched};
    use glam::Vec2;

    #[test]
    fn rectangles_hold_the_touched_tiles_and_no_other() {
        let mut touched = Touched::none(Vec2::new(10.0 * TILE, 6.0 * TILE));
        assert!(touched.rectangles().is_empty());
        let tile = |x: f32, y: f32| Vec2::new(x, y) * TILE;
        touched.add(tile(1.1, 1.1), tile(2.9, 3.9));
        touched.add(tile(5.2, 2.2), tile(5.4, 2.3));
        touched.add(tile(-4.0, 5.5), tile(40.0, 40.0));
        touched.add(Vec2::INFINITY, Vec2::NEG_INFINITY);
        let mut found = touched.rectangles();
        found.sort_by(|a, b| a[0].y.total_cmp(&b[0].y).then(a[0].x.total_cmp(&b[0].x)));
        let expected =
            [[tile(1.0, 1.0), tile(3.0, 4.0)], [tile(5.0, 2.0), tile(6.0, 3.0)], [tile(0.0, 5.0), tile(10.0, 6.0)]];
        assert_eq!(found, expected);
    }
}
