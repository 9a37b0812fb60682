//! Translucent ellipsoids, one or two at a time, composited exactly by one shader.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use glam::{Vec2, Vec4};

use super::buffer::{FrameBuffer, UniformBuffer};
use super::pane::PaneUniform;
use super::pipeline::{Lazy, PipelineMaker, Recipe};
use crate::frame::{Frame, Quadric, QuadricPair, Walls, halved};

/// Sides of a polygon round a silhouette: with so many it is larger by a twenty-fifth than what it holds.
const SIDES: usize = 16;
/// Beyond the silhouette nothing is covered from here on (pixels).
const SOFT: f32 = 1.0;

/// `Pair` of shaders/quadrics.wgsl.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct PairUniform {
    pub(super) first: QuadricData,
    pub(super) second: QuadricData,
    pub(super) choice: Vec4,
}

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct QuadricData {
    /// The columns of its linear part.
    pub(super) unit_from_world: [Vec4; 3],
    /// The eye in the space in which it is the unit sphere.
    pub(super) eye: Vec4,
    pub(super) color: [f32; 4],
}

/// Draws the quadrics of a frame.
pub(super) struct Quadrics {
    module: Option<wgpu::ShaderModule>,
    /// Near walls, or all: they hide the lines behind them.
    hiding: Lazy,
    /// Far walls behind something opaque that is still to show through.
    far_walls: Lazy,
    uniforms: UniformBuffer,
    corners: FrameBuffer,
    panes: Vec<Vec<Draw>>,
}

/// One drawing of a pair.
struct Draw {
    /// Number of its uniform.
    number: usize,
    far_only: bool,
    /// Its corners of triangles.
    corners: Range<u32>,
}

impl Quadrics {
    pub(super) fn new(device: &wgpu::Device) -> Self {
        Self {
            module: None,
            hiding: Lazy::default(),
            far_walls: Lazy::default(),
            uniforms: UniformBuffer::new(device, "quadric pair", size_of::<PairUniform>()),
            corners: FrameBuffer::new("quadric corners", wgpu::BufferUsages::VERTEX),
            panes: vec![],
        }
    }

    pub(super) fn upload(
        &mut self,
        maker: &PipelineMaker<'_>,
        queue: &wgpu::Queue,
        frame: &Frame,
        pane_uniforms: &[PaneUniform],
    ) {
        let (mut pairs, mut corners) = (vec![], vec![]);
        self.panes.clear();
        for (pane, uniform) in frame.panes.iter().zip(pane_uniforms) {
            let mut draws = vec![];
            for pair in &pane.quadrics {
                let start = corners.len() as u32;
                corners.extend(covering_triangles(pair, uniform));
                let corners = start..corners.len() as u32;
                let passes: &[[f32; 2]] = match (pair.hollow, pair.walls) {
                    (false, _) => &[[1.0, 1.0]],
                    (true, Walls::Both) => &[[0.0, 1.0], [1.0, 0.0]],
                    (true, Walls::Far) => &[[0.0, 1.0]],
                    (true, Walls::Near) => &[[1.0, 0.0]],
                };
                for &[near, far] in passes {
                    draws.push(Draw { number: pairs.len(), far_only: near == 0.0, corners: corners.clone() });
                    pairs.push(pair_uniform(pair, [near, far], uniform.eye));
                }
            }
            self.panes.push(draws);
        }
        if !pairs.is_empty() {
            self.uniforms.write(&maker.gpu.device, queue, &pairs);
            self.corners.write(&maker.gpu.device, queue, bytemuck::cast_slice(&corners));
            self.make(maker);
        }
    }

    fn make(&mut self, maker: &PipelineMaker<'_>) {
        let source = include_str!("../../shaders/quadrics.wgsl");
        let module: &wgpu::ShaderModule = self.module.get_or_insert_with(|| maker.module("quadrics", source));
        let groups = [maker.pane_layout, self.uniforms.layout()];
        let pipeline = |label, writes_depth| {
            Recipe {
                buffer: Some(wgpu::VertexBufferLayout {
                    array_stride: size_of::<Vec2>() as u64,
                    step_mode: wgpu::VertexStepMode::Vertex,
                    attributes: &wgpu::vertex_attr_array![0 => Float32x2],
                }),
                groups: &groups,
                depth: Some((wgpu::CompareFunction::GreaterEqual, writes_depth)),
                ..Recipe::new(label, module)
            }
            .pipeline(maker.gpu)
        };
        self.hiding.want(true, || pipeline("quadrics", true));
        let is_hollow = self.panes.iter().flatten().any(|draw| draw.far_only);
        self.far_walls.want(is_hollow, || pipeline("far walls of quadrics", false));
    }

    /// Whether a pane has hollow ones, whose far walls are drawn by themselves.
    pub(super) fn are_hollow(&self, pane: usize) -> bool {
        self.panes.get(pane).is_some_and(|draws| draws.iter().any(|draw| draw.far_only))
    }

    /// Draws the far walls of the hollow ones of a pane.
    pub(super) fn draw_far_walls(&self, pass: &mut wgpu::RenderPass<'_>, pane: usize) {
        self.draw(pass, pane, true);
    }

    /// Draws all the rest.
    pub(super) fn draw_near_walls(&self, pass: &mut wgpu::RenderPass<'_>, pane: usize) {
        self.draw(pass, pane, false);
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>, pane: usize, far_only: bool) {
        let (Some(corners), Some(draws)) = (self.corners.get(), self.panes.get(pane)) else { return };
        for draw in draws.iter().filter(|draw| draw.far_only == far_only) {
            let pipeline = if draw.far_only { &self.far_walls } else { &self.hiding };
            if pipeline.set(pass) {
                pass.set_vertex_buffer(0, corners.slice(..));
                self.uniforms.bind(pass, 1, draw.number);
                pass.draw(draw.corners.clone(), 0..1);
            }
        }
    }
}

/// Whether walls of a pane hide what is at this depth of the screen, seen at this place of it (normalised device coordinates).
pub(super) fn hide(pairs: &[QuadricPair], uniform: &PaneUniform, ndc: Vec2, depth: f32) -> bool {
    let ray = uniform.ray_forward + ndc.x * uniform.ray_right + ndc.y * uniform.ray_up;
    let quadrics = pairs.iter().flat_map(|pair| [Some(pair.first), pair.second]).flatten();
    quadrics.into_iter().any(|quadric| {
        let map = quadric.unit_from_world;
        let (origin, way) = (map * uniform.eye.truncate().extend(1.0), map * ray);
        let (origin, way) = (origin.truncate(), way.truncate());
        let squared = way.length_squared();
        let middle = -origin.dot(way) / squared;
        let left = 1.0 - (origin + middle * way).length_squared();
        let near = middle - (left.max(0.0) / squared).sqrt();
        left > 0.0 && near > uniform.eye.w && uniform.eye.w / near > depth
    })
}

fn pair_uniform(pair: &QuadricPair, [near, far]: [f32; 2], eye: Vec4) -> PairUniform {
    let data = |quadric: Quadric| {
        let map = quadric.unit_from_world;
        QuadricData {
            unit_from_world: [map.x_axis, map.y_axis, map.z_axis],
            eye: map * eye.truncate().extend(1.0),
            color: quadric.color.0,
        }
    };
    let second = pair.second.unwrap_or(pair.first);
    PairUniform {
        first: data(pair.first),
        second: data(second),
        choice: Vec4::new(f32::from(pair.second.is_some()), near, far, 0.0),
    }
}

/// Triangles of the screen that hold both quadrics and little else: the convex hull of polygons round them. The whole screen where one
/// reaches behind the eye.
fn covering_triangles(pair: &QuadricPair, uniform: &PaneUniform) -> Vec<Vec2> {
    let mut points = vec![];
    for quadric in [Some(pair.first), pair.second].into_iter().flatten() {
        let Some(polygon) = polygon_round(quadric, uniform) else {
            let [a, b, c, d] = [Vec2::NEG_ONE, Vec2::new(1.0, -1.0), Vec2::ONE, Vec2::new(-1.0, 1.0)];
            return vec![a, b, c, a, c, d];
        };
        points.extend(polygon);
    }
    let hull = convex_hull(points);
    halved(hull.len() as u32).into_iter().flatten().map(|corner| hull[corner as usize]).collect()
}

/// Corners of a polygon of the screen whose sides touch the silhouette of a quadric, moved outward by the width of its soft edge; none
/// where some of it is not before the eye.
fn polygon_round(quadric: Quadric, uniform: &PaneUniform) -> Option<[Vec2; SIDES]> {
    let clip_from_unit = uniform.clip_from_world * quadric.unit_from_world.inverse();
    let eye = (quadric.unit_from_world * uniform.eye.truncate().extend(1.0)).truncate();
    let squared = eye.length_squared();
    if squared <= 1.0 {
        return None;
    }
    // Where the unit sphere is touched by rays: a circle. A polygon round it is, seen from the eye, one round the silhouette.
    let (centre, radius) = (eye / squared, (1.0 - squared.recip()).sqrt());
    let (one, other) = (eye / squared.sqrt()).any_orthonormal_pair();
    let outer = radius / (std::f32::consts::PI / SIDES as f32).cos();
    let mut corners = [Vec2::ZERO; SIDES];
    let mut middle = Vec2::ZERO;
    for (n, corner) in corners.iter_mut().enumerate() {
        let (sin, cos) = (std::f32::consts::TAU * n as f32 / SIDES as f32).sin_cos();
        let clip = clip_from_unit * (centre + outer * (cos * one + sin * other)).extend(1.0);
        if clip.w <= crate::camera::NEAR {
            return None;
        }
        *corner = Vec2::new(clip.x, clip.y) / clip.w;
        middle += *corner / SIDES as f32;
    }
    // The soft edge reaches at most half a pixel's diagonal beyond; the least distance of a side from the middle grows by that.
    let pixel = Vec2::new(2.0 / uniform.metrics.x, 2.0 / uniform.metrics.y);
    let sides = (0..SIDES).map(|n| {
        let (a, b) = ((corners[n] - middle) / pixel, (corners[(n + 1) % SIDES] - middle) / pixel);
        a.perp_dot((b - a).normalize_or_zero()).abs()
    });
    let least = sides.fold(f32::INFINITY, f32::min).max(1.0);
    Some(corners.map(|corner| middle + (corner - middle) * (1.0 + SOFT / least)))
}

/// Andrew's monotone chain.
fn convex_hull(mut points: Vec<Vec2>) -> Vec<Vec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let mut hull: Vec<Vec2> = vec![];
    let mut half = |points: &mut dyn Iterator<Item = Vec2>| {
        let start = hull.len();
        for point in points {
            while let [.., a, b] = hull[start..]
                && (b - a).perp_dot(point - a) <= 0.0
            {
                hull.pop();
            }
            hull.push(point);
        }
        hull.pop();
    };
    half(&mut points.iter().copied());
    half(&mut points.iter().rev().copied());
    hull
}

#[cfg(test)]
mod tests {
    use super::{covering_triangles, hide};
    use crate::camera::{Camera, NEAR};
    use crate::frame::{Area, Color, Pane, Quadric, QuadricPair};
    use crate::render::pane::PaneUniform;
    use glam::{Mat3, Vec2, Vec3, Vec4};

    #[test]
    fn walls_hide_what_lies_behind_them_alone() {
        let camera = Camera::new(0.3, 0.2, 6.0);
        let pane = Pane::new(Area::WHOLE, camera, 0.0);
        let uniform = PaneUniform::new(&pane, Vec2::new(300.0, 200.0), 1.0);
        // Half as wide as the sphere, and longer along z.
        let second = Quadric::ellipsoid(Vec3::ZERO, Mat3::IDENTITY, Vec3::new(0.5, 0.5, 1.3), Color::hex(0));
        let sphere = Quadric::ellipsoid(Vec3::ZERO, Mat3::IDENTITY, Vec3::ONE, Color::hex(0));
        let pairs = [QuadricPair::two(sphere, second, false)];
        let (right, up, forward) = camera.axes();
        let is_hidden = |at: Vec3| {
            let depth = NEAR / (at - camera.eye()).dot(forward);
            uniform.ndc(at).is_some_and(|ndc| hide(&pairs, &uniform, ndc, depth))
        };
        assert!(is_hidden(0.99 * -forward) && is_hidden(forward) && is_hidden(20.0 * forward));
        assert!(!is_hidden(-1.01 * forward) && !is_hidden(-2.0 * forward));
        // Beside the sphere, and behind the end of the ellipsoid that stands out of it.
        assert!(!is_hidden(1.2 * right) && !is_hidden(2.5 * right + 3.0 * forward));
        assert!(is_hidden(1.2 * Vec3::Z + 0.6 * forward) && !is_hidden(1.2 * Vec3::Z + 0.6 * right + 0.6 * forward));
        assert!(!is_hidden(1.4 * up) && !hide(&[], &uniform, Vec2::ZERO, 0.0));
    }
    #[test]
    fn triangles_hold_the_silhouettes_with_their_soft_edges_and_little_else() {
        let pixels = Vec2::new(300.0, 200.0);
        let axes = Mat3::from_rotation_y(0.7) * Mat3::from_rotation_x(0.4);
        let long = Quadric::ellipsoid(Vec3::new(0.2, 0.0, 0.1), axes, Vec3::new(0.3, 0.6, 1.4), Color::hex(0));
        let uniform = PaneUniform::new(&Pane::new(Area::WHOLE, Camera::new(0.3, 0.2, 6.0), 0.0), pixels, 1.0);
        let triangles = covering_triangles(&QuadricPair::one(long, false), &uniform);
        let triangles = triangles.as_chunks::<3>().0;
        let holds = |place: Vec2| {
            let turns = |[a, b, c]: [Vec2; 3]| [(a, b), (b, c), (c, a)].map(|(p, q)| (q - p).perp_dot(place - p));
            triangles.iter().any(|triangle| {
                let turns = turns(*triangle);
                turns.iter().all(|turn| *turn >= 0.0) || turns.iter().all(|turn| *turn <= 0.0)
            })
        };
        // Where a pixel is covered at all, its middle is at most half its diagonal from the silhouette.
        let mut covered = 0;
        for n in 0..300 * 200 {
            let pixel = Vec2::new((n % 300) as f32 + 0.5, (n / 300) as f32 + 0.5);
            let ndc = |pixel: Vec2| (pixel / pixels * 2.0 - 1.0) * Vec2::new(1.0, -1.0);
            let ring = [Vec2::ZERO, Vec2::X, Vec2::Y, Vec2::NEG_X, Vec2::NEG_Y].map(|aside| pixel + 0.7 * aside);
            if ring.into_iter().any(|place| hide(&[QuadricPair::one(long, false)], &uniform, ndc(place), 0.0)) {
                covered += 1;
                assert!(holds(ndc(pixel)), "{pixel}");
            }
        }
        let area: f32 = triangles.iter().map(|[a, b, c]| 0.5 * (*b - *a).perp_dot(*c - *a).abs()).sum();
        let area = area * 0.25 * pixels.element_product();
        assert!(covered > 2000 && area < 1.1 * covered as f32, "{area} of {covered}");
        // From within it may be anywhere.
        let inside = PaneUniform::new(&Pane::new(Area::WHOLE, Camera::new(0.3, 0.2, 0.5), 0.0), pixels, 1.0);
        let sphere = Quadric::ellipsoid(Vec3::ZERO, Mat3::IDENTITY, Vec3::ONE, Color::hex(0));
        assert_eq!(covering_triangles(&QuadricPair::one(sphere, false), &inside).len(), 6);
    }

    #[test]
    fn rows_of_a_map_are_at_right_angles_as_the_shader_takes_them() {
        let axes = Mat3::from_rotation_z(1.1) * Mat3::from_rotation_x(0.4);
        let map = Quadric::ellipsoid(Vec3::X, axes, Vec3::new(0.3, 0.6, 1.4), Color::hex(0)).unit_from_world;
        let rows = [map.row(0), map.row(1), map.row(2)].map(Vec4::truncate);
        for (one, other) in [(0, 1), (1, 2), (2, 0)] {
            assert!(rows[one].dot(rows[other]).abs() < 1e-5, "{rows:?}");
        }
    }
}
