//! Marks of constant size on the screen, told apart by their form: a quad each.

use glam::Vec2;

use super::overlay::{Kind, Quad, QuadData};
use super::pane::Projection;
use crate::camera::NEAR;
use crate::frame::{Mark, Marker};

/// How far marks are drawn before the surfaces they lie on, as a factor on their depth.
const LIFT: f32 = 1.014;
/// Width of the rim (points).
const RIM: f32 = 1.4;

/// How a form is measured, in radii of the mark: its outline is where the larger of `normals[i] · v − extents[i]` is 0, `v` as
/// its kind has it, in axes of which the first is `turn`.
struct Form {
    kind: Kind,
    normals: [Vec2; 2],
    extents: [f32; 2],
    turn: Vec2,
    /// |x| is measured from here.
    fold: f32,
    /// Half the stroke of an empty form.
    stroke: f32,
}

/// Half the stroke of the empty forms.
const STROKE: f32 = 0.2;
/// Both axes at 45°.
const DIAGONAL: Vec2 = Vec2::splat(std::f32::consts::FRAC_1_SQRT_2);

impl Form {
    const fn new(kind: Kind, normals: [Vec2; 2], extents: [f32; 2]) -> Self {
        Self { kind, normals, extents, turn: Vec2::X, fold: 0.0, stroke: 0.0 }
    }

    const fn empty(self) -> Self {
        Self { stroke: STROKE, ..self }
    }

    const fn turned(self, turn: Vec2) -> Self {
        Self { turn, ..self }
    }

    const fn square(half: f32) -> Self {
        Self::new(Kind::Fourfold, [Vec2::X, Vec2::X], [half, half])
    }

    const fn triangle(inner: f32) -> Self {
        Self::new(Kind::Upright, [Vec2::new(0.866, 0.5), Vec2::NEG_Y], [inner, inner])
    }

    const fn hourglass() -> Self {
        Self::new(Kind::Upset, [Vec2::Y, Vec2::new(0.743, -0.9 * 0.743)], [0.95, 0.0])
    }

    const fn of(mark: Mark) -> Self {
        const HALF: f32 = std::f32::consts::FRAC_1_SQRT_2;
        match mark {
            Mark::Disc => Self::new(Kind::Disc, [Vec2::ZERO; 2], [1.0, 0.0]),
            Mark::Ring => Self::new(Kind::Round, [Vec2::ZERO; 2], [0.8, 0.0]).empty(),
            Mark::Diamond => Self::square(1.2 * HALF).turned(DIAGONAL),
            Mark::Cross => Self::new(Kind::Fourfold, [Vec2::X, Vec2::Y], [1.15, 0.26]).turned(DIAGONAL),
            Mark::Square => Self::square(0.85),
            Mark::Triangle => Self::triangle(0.6),
            Mark::TriangleDown => Self::triangle(0.6).turned(Vec2::NEG_X),
            Mark::OpenSquare => Self::square(0.68).empty(),
            Mark::OpenDiamond => Self::square(0.95 * HALF).empty().turned(DIAGONAL),
            Mark::OpenTriangle => Self::triangle(0.45).empty(),
            Mark::OpenTriangleDown => Self::triangle(0.45).empty().turned(Vec2::NEG_X),
            Mark::Hourglass => Self::hourglass(),
            Mark::Bow => Self::hourglass().turned(Vec2::Y),
            Mark::Bars => Self { fold: 0.55, ..Self::new(Kind::Upset, [Vec2::X, Vec2::Y], [0.27, 0.9]) },
            // From a tip of one axis to the waist on the diagonal.
            Mark::Star => Self::new(Kind::Fourfold, [Vec2::new(0.36, 0.933); 2], [0.43, 0.43]),
        }
    }
}

/// Adds the corners of a mark, `point` pixels a point.
pub(super) fn append(marker: &Marker, projection: &Projection<'_>, point: f32, corners: &mut Vec<QuadData>) {
    let clip = projection.clip(marker.position);
    if clip.w <= NEAR {
        return;
    }
    let centre = projection.pixel(clip);
    let radius = 0.5 * marker.size * point;
    let form = Form::of(marker.mark);
    let rim = RIM * point;
    let reach = Vec2::splat(match form.kind {
        // As far as its rim and the soft edge of that.
        Kind::Disc | Kind::Round => (form.extents[0] + form.stroke) * radius + rim + 1.0,
        _ => 1.5 * radius + 2.0,
    });
    let places = Quad::rectangle(centre - reach, centre + reach, (clip.z / clip.w * LIFT).min(1.0));
    if !projection.may_show(&places) {
        return;
    }
    let [one, other] = form.extents.map(|extent| extent * radius);
    let quad = Quad {
        kind: form.kind,
        place: [centre, form.turn],
        form: form.normals,
        measures: [one, other, form.fold * radius, form.stroke * radius],
        hidden: marker.hidden,
        rim,
        colors: [marker.color, marker.rim],
    };
    corners.extend(quad.at(places));
}
