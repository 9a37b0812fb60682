//! Lines of constant width: a quad a segment, round joins and caps. Neighbours are cut along the bisector of their corner, so
//! that no pixel is blended twice.

use glam::{Vec2, Vec4};

use super::overlay::{Kind, Quad, QuadData};
use super::pane::Projection;
use crate::camera::NEAR;
use crate::frame::{Dash, Line};

/// What quads are larger by on each side (pixels): corners are rounded to a 256th of a pixel.
const SPARE: f32 = 0.02;

/// Adds the corners of a line's segments, `point` pixels a point, drawn before their places by this part of their distance.
pub(super) fn append(line: &Line, lift: f32, projection: &Projection<'_>, point: f32, corners: &mut Vec<QuadData>) {
    let points = &line.points;
    let last = points.len().saturating_sub(1);
    if last == 0 {
        return;
    }
    let closed = points.len() > 2 && points[0].position == points[last].position;
    let (kind, period) = match line.dash {
        Dash::Solid => (Kind::Solid, 1.0),
        Dash::Dashed(period) => (Kind::Dashed, period),
        Dash::Dotted(period) => (Kind::Dotted, period),
    };
    // Thinner than a pixel is drawn as a fainter pixel.
    let wide = line.width * point;
    let (half_width, strength) = (0.5 * wide.max(1.0), wide.min(1.0));
    let clips: Vec<Vec4> = points.iter().map(|point| projection.clip(point.position)).collect();
    let mut along = 0.0;
    for i in 0..last {
        let (from, to) = (points[i], points[i + 1]);
        let next = along + from.position.distance(to.position);
        let lengths = [std::mem::replace(&mut along, next), next];
        let ends = [clips[i], clips[i + 1]];
        if ends.iter().all(|end| end.w < NEAR) {
            continue;
        }
        let (start, end) = (cut(ends[0], ends[1]), cut(ends[1], ends[0]));
        let (p, q) = (projection.pixel(start), projection.pixel(end));
        let forward = direction(p, q);
        let tangent = if forward == Vec2::ZERO { Vec2::X } else { forward };
        // A free end has no neighbour.
        let before = if i > 0 { Some(i - 1) } else { closed.then_some(last - 1) };
        let after = if i + 1 < last { Some(i + 2) } else { closed.then_some(1) };
        let before = before.map_or(Vec2::ZERO, |other| direction(projection.pixel(cut(clips[other], start)), p));
        let after = after.map_or(Vec2::ZERO, |other| direction(q, projection.pixel(cut(clips[other], end))));
        let bisector = |other: Vec2| if other == Vec2::ZERO { other } else { other + forward };
        // What is farther from the middle line than this covers nothing of a pixel.
        let reach = half_width + 0.5 + SPARE;
        let (behind, beyond) = (overhang(before, tangent, reach), overhang(tangent, after, reach));
        let side = tangent.perp() * reach;
        let depth = |end: Vec4| (end.z / end.w * (1.0 + lift)).min(1.0);
        let (low, high) = ((p - tangent * behind, depth(start)), (q + tangent * beyond, depth(end)));
        let places = [(low, -side), (high, -side), (low, side), (high, side)];
        let places = places.map(|((at, depth), aside)| (at + aside).extend(depth));
        if !projection.may_show(&places) {
            continue;
        }
        let quad = Quad {
            kind,
            place: [p, q],
            form: [bisector(before), bisector(after)],
            measures: [lengths[0], lengths[1], period, half_width],
            hidden: line.hidden,
            rim: 0.0,
            colors: [from.color.fade(strength), to.color.fade(strength)],
        };
        corners.extend(quad.at(places));
    }
}

/// The place of the way from one to other where the near plane cuts it, or one itself where it is in sight.
fn cut(one: Vec4, other: Vec4) -> Vec4 {
    if one.w >= NEAR || other.w <= NEAR {
        return one;
    }
    one.lerp(other, (NEAR - one.w) / (other.w - one.w))
}

/// The unit vector from one pixel to another; zero where they are one.
fn direction(from: Vec2, to: Vec2) -> Vec2 {
    let way = to - from;
    let far = way.length();
    if far > 1e-3 { way / far } else { Vec2::ZERO }
}

/// How far a segment reaches beyond its end to the bisector of the corner there: tan of half the bend. A free end needs its whole
/// cap. No farther: every covered block of pixels is paid for where there is no GPU.
fn overhang(one: Vec2, other: Vec2, reach: f32) -> f32 {
    if one == Vec2::ZERO || other == Vec2::ZERO {
        return reach;
    }
    let bend = one.perp_dot(other).abs() / (1.0 + one.dot(other)).max(1e-3);
    (bend * reach + SPARE).min(reach)
}

#[cfg(test)]
mod tests {
    use super::{SPARE, append, overhang};
    use crate::camera::Camera;
    use crate::frame::{Area, Color, Line, Pane};
    use crate::render::pane::{PaneUniform, Projection};
    use glam::{Vec2, Vec3};

    /// The quads of a line on a pane of 200 by 100 pixels, one pixel a point.
    fn quads(points: &[Vec3]) -> Vec<[Vec2; 4]> {
        let size = Vec2::new(200.0, 100.0);
        let uniform = PaneUniform::flat(size, 1.0);
        let projection = Projection::new(&uniform, Vec2::ZERO);
        let mut corners = vec![];
        append(&Line::new(points.iter().copied(), 4.0, Color::hex(0)), 0.0, &projection, 1.0, &mut corners);
        corners
            .chunks_exact(4)
            .map(|quad| std::array::from_fn(|i| Vec2::new(quad[i].position[0], quad[i].position[1])))
            .collect()
    }

    #[test]
    fn a_segment_is_as_wide_as_the_line_with_its_caps() {
        let found = quads(&[Vec3::new(20.0, 50.0, 0.0), Vec3::new(120.0, 50.0, 0.0)]);
        assert_eq!(found.len(), 1);
        // Half a width of 2 pixels and half a pixel for the soft edge, on all sides.
        assert!(found[0][0].abs_diff_eq(Vec2::new(17.5 - SPARE, 47.5 - SPARE), 1e-4), "{found:?}");
        assert!(found[0][3].abs_diff_eq(Vec2::new(122.5 + SPARE, 52.5 + SPARE), 1e-4), "{found:?}");
        // A straight join needs no cap, a right angle half of a square.
        assert_eq!(overhang(Vec2::X, Vec2::X, 3.0), SPARE);
        assert!((overhang(Vec2::X, Vec2::Y, 2.0) - 2.0).abs() < 1e-6);
        // Nothing of what lies outside.
        assert!(quads(&[Vec3::new(20.0, -50.0, 0.0), Vec3::new(120.0, -50.0, 0.0)]).is_empty());
    }

    #[test]
    fn what_lies_behind_the_eye_is_left_out() {
        let camera = Camera::new(0.4, 0.3, 5.0);
        let pane = Pane::new(Area::WHOLE, camera, 0.0);
        let uniform = PaneUniform::new(&pane, Vec2::new(200.0, 100.0), 1.0);
        let projection = Projection::new(&uniform, Vec2::ZERO);
        let (eye, (_, _, forward)) = (camera.eye(), camera.axes());
        let mut corners = vec![];
        let behind = [eye - forward, eye - 2.0 * forward];
        append(&Line::new(behind, 1.0, Color::hex(0)), 0.0, &projection, 1.0, &mut corners);
        assert!(corners.is_empty());
        // From behind the eye to before it: what is in sight is drawn, at finite places.
        let through = [eye - forward, eye + 2.0 * forward];
        append(&Line::new(through, 1.0, Color::hex(0)), 0.0, &projection, 1.0, &mut corners);
        assert_eq!(corners.len(), 4);
        assert!(corners.iter().all(|corner| corner.position.iter().all(|side| side.is_finite())));
    }
}
