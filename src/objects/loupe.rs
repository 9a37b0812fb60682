//! An end of axis 2 as through a magnifying glass: there two paths pass so near each other that the eye takes them for one.
//!
//! Seen along axis 2 every path is a hyperbola, `M₁² − κ²M₃² = c`, on the sphere too, so that no magnification is too large.

use std::f32::consts::TAU;

use glam::{DVec2, Mat2, Vec2, Vec3};

use super::{Context, axes, labels};
use crate::camera::Camera;
use crate::frame::{Color, Dash, Label, Line, Mark, Marker, Mesh, Pane, Vertex, halved};
use crate::physics::poinsot;

/// Radius of the glass, its distance from the sides of the view, the room for its name below it, and how far from the view's middle it
/// is held at the most: parts of half the smaller side.
const RADIUS: f32 = 0.235;
const ASIDE: f32 = 0.03;
const BELOW: f32 = 0.17;
const FARTHEST: f32 = 1.15;
/// How near the eye the glass is held, as a part of the distance of what is seen: before all else.
const NEARNESS: f32 = 0.4;
/// So far from the middle of the glass, as a part of its radius, M's path passes it at the most.
const GAP: f64 = 0.62;
/// A radius of the sphere's: the magnification is the same in all views in which the glass has at least this one.
const USUAL: f32 = 0.3;
/// What is not magnified more than this needs no glass.
const LEAST: f64 = 4.0;
/// Where M's path goes through the end itself there is no nearest magnification.
const AT_THE_END: f64 = 20.0;
/// Lines end within its rim, round ends and all.
const WITHIN: f64 = 0.96;
const POINTS: u32 = 64;

/// What of momentum space is seen through the glass: the surroundings of an end of axis 2.
struct Sight {
    /// The components 1 and 3 (of length 1) of the separatrix there.
    separatrix: DVec2,
    /// `M₁² − κ²M₃²` of M's path, in units of ℓ².
    level: f64,
    /// Which of the two branches is its own: a sign.
    own: f64,
}

impl Sight {
    fn of(context: &Context<'_>) -> Option<Self> {
        let body = context.simulation.body();
        let separatrix = DVec2::from_array(poinsot::separatrix_direction(body)?);
        let start = context.principal_unit(context.scene.start.body_momentum);
        let border = separatrix.x / separatrix.y * start.z;
        let level = (start.x - border) * (start.x + border);
        Some(Self { separatrix, level, own: if level < 0.0 { start.z } else { start.x }.signum() })
    }

    fn kappa(&self) -> f64 {
        self.separatrix.x / self.separatrix.y
    }

    /// How near M's path comes to the end.
    fn gap(&self) -> f64 {
        let root = self.level.abs().sqrt();
        if self.level < 0.0 { root / self.kappa() } else { root }
    }

    /// Times as large: a short number, of one digit before a power of ten; none where M's path keeps well away.
    fn magnification(&self, radius: f64) -> Option<f64> {
        let gap = self.gap();
        let most = if gap > 0.0 { GAP * radius / gap } else { AT_THE_END };
        let power = 10_f64.powf(most.log10().floor());
        let nice =
            [8.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.0].into_iter().map(|digit| digit * power).find(|&nice| nice <= most)?;
        (nice >= LEAST && nice.is_finite()).then_some(nice)
    }

    /// One of the two branches of M's path within this distance of the end: components 1 and 3.
    fn branch(&self, sign: f64, reach: f64) -> Vec<DVec2> {
        let (kappa, root) = (self.kappa(), self.level.abs().sqrt());
        let gap = self.gap();
        // cosh² = 1 + sinh², so that |(M₁, M₃)|² = gap² + root²(1 + 1/κ²) sinh².
        let most = ((reach * reach - gap * gap).max(0.0) / (1.0 + kappa.powi(-2))).sqrt() / root;
        let end = most.asinh();
        let point = |n: u32| {
            let u = end * (2.0 * f64::from(n) / f64::from(POINTS) - 1.0);
            let (along, beside) = (root * u.sinh(), sign * root * u.cosh());
            if self.level < 0.0 { DVec2::new(along, beside / kappa) } else { DVec2::new(beside, along / kappa) }
        };
        (0..=POINTS).map(point).collect()
    }
}

/// The glass: a disc across the line of sight.
struct Glass {
    middle: Vec3,
    right: Vec3,
    up: Vec3,
    /// Takes components 1 and 3, magnified, to the glass, square on and upright as the eye sees the sphere beside it.
    from_components: Mat2,
}

impl Glass {
    /// A place on it: parts of its radius.
    fn at(&self, place: Vec2) -> Vec3 {
        self.middle + self.right * place.x + self.up * place.y
    }
}

pub(super) fn draw(context: &Context<'_>, pane: &mut Pane) {
    if context.unit_momentum().is_none() {
        return;
    }
    let Some(sight) = Sight::of(context) else { return };
    let (right, up, forward) = pane.camera.axes();
    let end = if Vec3::Y.dot(forward) > 0.0 { -1.0 } else { 1.0 };
    let flat = |axis: Vec3| Vec2::new(axis.dot(right), axis.dot(up));
    let (distance, half_side) = (pane.camera.distance, (0.5 * Camera::vertical_field(1.0)).tan());
    let radius = RADIUS * half_side * distance;
    let Some(times) = sight.magnification(f64::from(radius.min(USUAL))) else { return };
    // In the lower corner that is nearest to the end.
    let on = Vec3::Y * end;
    let aspect = context.aspect * pane.area.extent.x / pane.area.extent.y.max(1e-6);
    let half = Vec2::new(aspect, 1.0) / aspect.min(1.0);
    let corner = half - RADIUS - Vec2::new(ASIDE, BELOW * context.type_scale.max(1.0));
    let side = if flat(on).x < 0.0 { -1.0 } else { 1.0 };
    let corner = Vec2::new(side * corner.x.min(FARTHEST), -corner.y) * half_side * distance;
    let near = |at: Vec2| pane.camera.eye() + (forward * distance + right * at.x + up * at.y) * NEARNESS;
    let scale = radius * NEARNESS;
    let glass = Glass {
        middle: near(corner),
        right: right * scale,
        up: up * scale,
        from_components: nearest_turn(flat(Vec3::X), flat(Vec3::Z)),
    };
    let seen = |components: DVec2| {
        let magnified = components * (times / f64::from(radius));
        glass.from_components * magnified.as_vec2()
    };
    let palette = &context.palette;
    disc(pane, &glass, palette.background.mix(palette.ink, 0.06));
    let line = |points: &mut dyn Iterator<Item = Vec2>, width: f32, color: Color| {
        Line::new(points.map(|place| glass.at(place)), width, color)
    };
    let rim = line(&mut circle(), 1.6, palette.ink.alpha(0.7));
    let from = on + (glass.middle - on).normalize_or_zero() * 0.04;
    let toward = flat(on - pane.camera.target) - corner;
    let leader = Line::new([from, glass.at(toward.normalize_or(Vec2::Y))], 1.4, palette.ink.alpha(0.7));
    pane.lines.extend([rim, leader]);
    let reach = f64::from(radius) / times;
    if context.shows(&super::SEPARATRIX) {
        for sign in [1.0, -1.0] {
            let tip = seen(sight.separatrix * DVec2::new(sign, 1.0) * WITHIN * reach);
            let border = line(&mut [tip, -tip].into_iter(), 2.2, palette.separatrix);
            pane.lines.push(border.dashed(Dash::Dashed(0.28 * scale)));
        }
    }
    if sight.level != 0.0 {
        for (sign, width, color) in [(-sight.own, 2.0, palette.polhode.alpha(0.6)), (sight.own, 4.5, palette.polhode)] {
            pane.lines.push(line(&mut sight.branch(sign, WITHIN * reach).into_iter().map(seen), width, color));
        }
    }
    let mark = |position: Vec3, size: f32, mark: Mark, color: Color| Marker {
        position,
        size,
        mark,
        color,
        rim: palette.background,
        hidden: 0.0,
        moves: mark == Mark::Disc,
    };
    pane.markers.push(mark(glass.middle, 19.0, Mark::Cross, palette.axes[1]));
    // What is magnified has a mark of its own, or this one.
    if !context.shows(&super::POLES) {
        pane.markers.push(mark(on, 13.0, Mark::Ring, palette.ink));
    }
    let momentum = context.principal_unit(context.simulation.state().body_momentum);
    let place = seen(DVec2::new(momentum.x, momentum.z));
    if momentum.y * f64::from(end) > 0.0 && place.length() < 1.0 && context.shows(&super::TIP) {
        pane.markers.push(mark(glass.at(place), 17.0, Mark::Disc, palette.momentum));
    }
    pane.kept_clear.push([Vec2::new(-1.0, 1.0), Vec2::new(1.0, -1.0)].map(|corner| glass.at(corner)));
    let text = format!("{} ×", number(times));
    pane.labels.push(Label::new(glass.at(Vec2::NEG_Y), Vec2::NEG_Y, &text, palette.ink, labels::GLASS));
}

/// One digit before a power of ten.
fn number(times: f64) -> String {
    if times < 1e4 {
        return format!("{times:.0}");
    }
    let exponent = times.log10().floor();
    let digit = (times / 10_f64.powf(exponent)).round();
    let factor = if digit == 1.0 { String::new() } else { format!("{digit:.0}·") };
    format!("{factor}10{}", axes::superscript(exponent as i32))
}

/// The turn, or the turn and mirror image, that comes nearest to taking the axes of the plane to these directions.
fn nearest_turn(first: Vec2, second: Vec2) -> Mat2 {
    let side = if first.perp_dot(second) < 0.0 { -1.0 } else { 1.0 };
    // A matrix plus or minus its cofactors is a multiple of what is nearest to it.
    let sum = Vec2::new(first.x + side * second.y, first.y - side * second.x).normalize_or(Vec2::X);
    Mat2::from_cols(sum, sum.perp() * side)
}

fn circle() -> impl Iterator<Item = Vec2> {
    (0..=POINTS).map(|n| Vec2::from_angle(TAU * (n % POINTS) as f32 / POINTS as f32))
}

/// What the glass is made of: nothing is seen through it.
fn disc(pane: &mut Pane, glass: &Glass, color: Color) {
    let vertex = |place: Vec2| Vertex { position: glass.at(place), normal: Vec3::ZERO, color };
    let vertices: Vec<Vertex> = circle().take(POINTS as usize).map(vertex).collect();
    pane.meshes.push(Mesh { opaque: true, vertices, indices: halved(POINTS).concat() });
}

#[cfg(test)]
mod tests {
    use glam::{DVec2, Vec2};

    use super::{AT_THE_END, Sight, nearest_turn, number};
    use crate::objects::{Context, Palette};
    use crate::physics::{Motion, poinsot};
    use crate::scene::{Scene, SceneError, SceneFile, Theme};
    use crate::sim::Simulation;

    fn sight<T>(tilt: f64, axis: u8, see: impl FnOnce(&Context<'_>, Option<Sight>) -> T) -> Result<T, SceneError> {
        let text = format!("spin = {{ axis = {axis}, tilt_deg = {tilt:?}, rate = 6 }}");
        let scene = Scene::check(&SceneFile::parse(&text)?)?;
        let simulation = Simulation::new(&scene);
        let context = Context::new(&scene, &simulation, &Palette::new(Theme::Dark));
        let sight = Sight::of(&context);
        Ok(see(&context, sight))
    }

    #[test]
    fn both_branches_are_the_path_of_m() -> Result<(), SceneError> {
        for tilt in [3.0, 0.1, 1e-6, 1e-12, -0.1] {
            sight(tilt, 2, |context, sight| {
                assert!(sight.is_some(), "three moments");
                let Some(sight) = sight else { return };
                let scene = context.scene;
                let exact = Motion::new(&scene.body, &scene.start);
                let period = poinsot::flip_period_of(&scene.body, &scene.start).unwrap_or(0.0);
                let distance = |n: u32| {
                    let m = context.principal_unit(exact.momentum(2.0 * period * f64::from(n) / 4000.0));
                    DVec2::new(m.x, m.z).length()
                };
                let nearest = (0..4000).map(distance).fold(f64::INFINITY, f64::min);
                // Sampled, it may be missed by the square of a small angle.
                let ratio = nearest / sight.gap();
                assert!((1.0 - 1e-9..1.01).contains(&ratio), "{tilt}: {ratio}");
                let reach = 3.0 * sight.gap();
                for (sign, branch) in [1.0, -1.0].map(|sign| (sign, sight.branch(sign, reach))) {
                    let size = sight.level.abs();
                    for m in &branch {
                        let level = m.x * m.x - (sight.kappa() * m.y).powi(2);
                        // Rounding of the two terms, each up to ten times what is left of them.
                        assert!((level - sight.level).abs() < 1e-13 * size, "{tilt}: {m}");
                        assert!(m.length() <= reach * (1.0 + 1e-12), "{tilt}: {m}");
                        let beside = if sight.level < 0.0 { m.y } else { m.x };
                        assert!(beside * sign > 0.0, "{tilt}: {m}");
                    }
                    let ends = [branch.first(), branch.last()].into_iter().flatten();
                    assert!(ends.into_iter().all(|end| (end.length() / reach - 1.0).abs() < 1e-12), "{tilt}");
                }
            })?;
        }
        Ok(())
    }

    #[test]
    fn the_size_of_the_momentum_does_not_matter() -> Result<(), SceneError> {
        let level = |rate: f64| -> Result<Option<f64>, SceneError> {
            let text = format!("spin = {{ axis = 2, tilt_deg = 0.1, rate = {rate:?} }}");
            let scene = Scene::check(&SceneFile::parse(&text)?)?;
            let simulation = Simulation::new(&scene);
            let context = Context::new(&scene, &simulation, &Palette::new(Theme::Dark));
            Ok(Sight::of(&context).map(|sight| sight.level))
        };
        let usual = level(6.0)?.unwrap_or(0.0);
        // Its square is below all numbers.
        let small = level(1e-180)?.unwrap_or(0.0);
        assert!(usual < 0.0 && (small / usual - 1.0).abs() < 1e-12, "{small} {usual}");
        Ok(())
    }

    #[test]
    fn it_magnifies_as_much_as_is_needed() -> Result<(), SceneError> {
        // ω is tilted by 0.1°, M by I₃/I₂ times that, 2.28e-3; 0.62 of a glass of radius 0.2 is 54 of it.
        let times = |tilt, axis| sight(tilt, axis, |_, sight| sight.and_then(|sight| sight.magnification(0.2)));
        assert_eq!(times(0.1, 2)?, Some(50.0));
        assert_eq!(times(1e-6, 2)?.map(number).as_deref(), Some("5·10⁶"));
        assert_eq!(times(0.0, 2)?, Some(AT_THE_END));
        assert_eq!(times(30.0, 2)?, None);
        assert_eq!(times(5.0, 3)?, None);
        assert_eq!([50.0, 5e3, 1e5].map(number), ["50", "5000", "10⁵"]);
        Ok(())
    }

    #[test]
    fn it_is_seen_square_on() {
        // Squeezed and slanted, as from aside; and from behind, which mirrors.
        for (first, second) in [((0.5, 0.1), (-0.2, 0.9)), ((-0.5, 0.1), (-0.2, 0.9))] {
            let [first, second] = [first, second].map(Vec2::from);
            let turn = nearest_turn(first, second);
            assert!((turn.determinant().abs() - 1.0).abs() < 1e-6);
            assert!(turn.determinant() * first.perp_dot(second) > 0.0);
            assert!((turn * Vec2::X).dot(first) > 0.0 && (turn * Vec2::Y).dot(second) > 0.0);
        }
    }
}
