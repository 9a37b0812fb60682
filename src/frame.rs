//! What a picture consists of, as plain f32 data: the one place where f64 becomes f32.
//!
//! Objects write a [`Frame`], the renderer reads it. Lengths in a pane are in units of what it shows (about 1);
//! widths and text sizes are in points: 1/720 of the height of a 16:9 picture, whatever its size in pixels.

use glam::{DMat3, DVec3, Mat3, Mat4, Vec2, Vec3};

use crate::camera::Camera;

/// A vector rounded to f32.
#[must_use]
pub fn single(v: DVec3) -> Vec3 {
    v.as_vec3()
}

/// A matrix rounded to f32.
#[must_use]
pub fn single_matrix(m: DMat3) -> Mat3 {
    m.as_mat3()
}

/// A colour: red, green, blue as sRGB encodes them (0 to 1), and straight (not premultiplied) opacity. Pictures are blended in
/// these values too, as browsers and slides blend the PNGs that they are given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Color(pub [f32; 4]);

impl Color {
    /// An opaque colour from the usual `0xRRGGBB` notation.
    #[must_use]
    pub fn hex(rgb: u32) -> Self {
        let channel = |shift: u32| ((rgb >> shift) & 0xff) as f32 / 255.0;
        Self([channel(16), channel(8), channel(0), 1.0])
    }

    /// The same colour with this opacity.
    #[must_use]
    pub fn alpha(self, alpha: f32) -> Self {
        let [r, g, b, _] = self.0;
        Self([r, g, b, alpha])
    }

    /// The same colour, its opacity times this.
    #[must_use]
    pub fn fade(self, factor: f32) -> Self {
        self.alpha(self.0[3] * factor)
    }

    /// The colour this part of the way to another.
    #[must_use]
    pub fn mix(self, other: Self, part: f32) -> Self {
        let [a, b] = [self.0, other.0];
        Self(std::array::from_fn(|i| a[i] + (b[i] - a[i]) * part))
    }
}

/// A whole picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Behind everything, and the halo of the labels.
    pub background: Color,
    /// Leave the background out: the picture keeps its own opacity (premultiplied).
    pub transparent: bool,
    /// Factor on every width and text size.
    pub font_scale: f32,
    /// The parts of the picture, left to right or top to bottom.
    pub panes: Vec<Pane>,
}

/// A part of the picture, as fractions of its width and height from the top left corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// The top left corner.
    pub corner: Vec2,
    /// Width and height.
    pub extent: Vec2,
}

impl Area {
    /// The whole picture.
    pub const WHOLE: Self = Self { corner: Vec2::ZERO, extent: Vec2::ONE };

    /// Whether a point (fractions of the picture) lies within.
    #[must_use]
    pub fn contains(&self, point: Vec2) -> bool {
        let inside = point - self.corner;
        inside.cmpge(Vec2::ZERO).all() && inside.cmplt(self.extent).all()
    }
}

/// One scene seen by one camera in one part of the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Pane {
    /// Where in the picture.
    pub area: Area,
    /// From where it is seen.
    pub camera: Camera,
    /// How far before its place a line is tested against surfaces, as a part of its distance from the eye: it may lie on one.
    pub lift: f32,
    /// Surfaces made of triangles.
    pub meshes: Vec<Mesh>,
    /// Translucent quadrics, drawn pair by pair after the meshes.
    pub quadrics: Vec<QuadricPair>,
    /// Lines of constant width on the screen.
    pub lines: Vec<Line>,
    /// Dots of the unit sphere, of which there may be many thousands.
    pub dots: Vec<Dot>,
    /// Marks of constant size on the screen.
    pub markers: Vec<Marker>,
    /// Texts beside points of the scene.
    pub labels: Vec<Label>,
    /// Texts in the upper left corner, the first one highest.
    pub notes: Vec<Note>,
    /// Ways on which something moves with its label, drawn or not: names that stand still keep off them.
    pub ways: Vec<Vec<Vec3>>,
    /// Upper left and lower right corners, as the eye sees them, of what labels that stand still do not cover.
    pub kept_clear: Vec<[Vec3; 2]>,
}

impl Pane {
    /// An empty pane.
    #[must_use]
    pub fn new(area: Area, camera: Camera, lift: f32) -> Self {
        let (meshes, quadrics, lines, dots, markers) = (vec![], vec![], vec![], vec![], vec![]);
        let (labels, notes, ways, kept_clear) = (vec![], vec![], vec![], vec![]);
        Self { area, camera, lift, meshes, quadrics, lines, dots, markers, labels, notes, ways, kept_clear }
    }

    /// Adds a surface that is cut by the other one of its kind, where that is drawn: the two are composited together.
    pub fn add_cutting(&mut self, quadric: Quadric) {
        match self.quadrics.iter_mut().find(|pair| pair.is_open) {
            Some(pair) => (pair.second, pair.is_open) = (Some(quadric), false),
            None => self.quadrics.push(QuadricPair { is_open: true, ..QuadricPair::one(quadric, false) }),
        }
    }
}

/// A corner of a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Where, in the pane's world.
    pub position: Vec3,
    /// Outward unit normal; zero for a surface that takes no light.
    pub normal: Vec3,
    /// Colour at the corner, blended across the triangle.
    pub color: Color,
}

/// Triangles with their colours.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Opaque ones hide what is behind; the others are blended over the opaque ones, farthest first.
    pub opaque: bool,
    /// The corners.
    pub vertices: Vec<Vertex>,
    /// Three indices a triangle, counter-clockwise seen from outside.
    pub indices: Vec<u32>,
}

/// The triangles of a convex polygon of so many corners, by their numbers, the way round that they go: cut in halves again and again.
/// Where there is no GPU what two triangles share of a block of pixels is paid for twice, and the sides of a fan are all long.
#[must_use]
pub fn halved(corners: u32) -> Vec<[u32; 3]> {
    fn cut(first: u32, last: u32, triangles: &mut Vec<[u32; 3]>) {
        if last > first + 1 {
            let middle = first.midpoint(last);
            triangles.push([first, middle, last]);
            cut(first, middle, triangles);
            cut(middle, last, triangles);
        }
    }
    let mut triangles = vec![];
    cut(0, corners.saturating_sub(1), &mut triangles);
    triangles
}

/// A closed quadric surface `|unit_from_world p| = 1` (ellipsoid), translucent.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadric {
    /// Takes the surface to the unit sphere.
    pub unit_from_world: Mat4,
    /// Colour, with the opacity of one wall seen square on.
    pub color: Color,
}

impl Quadric {
    /// The ellipsoid with these semi-axes along the columns of `axes`, about `centre`.
    #[must_use]
    pub fn ellipsoid(centre: Vec3, axes: Mat3, semi_axes: Vec3, color: Color) -> Self {
        let inverse = Mat3::from_diagonal(semi_axes.max(Vec3::splat(1e-6)).recip()) * axes.transpose();
        let unit_from_world = Mat4::from_mat3(inverse) * Mat4::from_translation(-centre);
        Self { unit_from_world, color }
    }
}

/// Walls of a hollow surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Walls {
    /// Those away from the eye, and over them those towards it.
    #[default]
    Both,
    /// Those away from the eye.
    Far,
    /// Those towards the eye.
    Near,
}

/// One or two quadrics about the same centre, composited exactly where they cut each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuadricPair {
    /// The one that is always there.
    pub first: Quadric,
    /// The one that cuts it.
    pub second: Option<Quadric>,
    /// Something opaque may lie inside: the far walls are then blended before the near ones, each against it.
    pub hollow: bool,
    /// Which of the walls of a hollow one are drawn.
    pub walls: Walls,
    /// Whether a second one is still waited for (see [`Pane::add_cutting`]).
    pub is_open: bool,
}

impl QuadricPair {
    /// One by itself.
    #[must_use]
    pub fn one(first: Quadric, hollow: bool) -> Self {
        Self { first, second: None, hollow, walls: Walls::Both, is_open: false }
    }

    /// Two that cut each other.
    #[must_use]
    pub fn two(first: Quadric, second: Quadric, hollow: bool) -> Self {
        Self { second: Some(second), ..Self::one(first, hollow) }
    }
}

/// One point of a [`Line`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinePoint {
    /// Where, in the pane's world.
    pub position: Vec3,
    /// Colour here, blended along the line.
    pub color: Color,
}

/// The pattern of a line, in lengths of the pane's world.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Dash {
    /// Unbroken.
    #[default]
    Solid,
    /// Dashes of this period, half of it drawn.
    Dashed(f32),
    /// Round dots of this period.
    Dotted(f32),
}

/// A line of constant width on the screen, with round joins and caps.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// The points it goes through; a closed line repeats its first point.
    pub points: Vec<LinePoint>,
    /// Width in points.
    pub width: f32,
    /// Its pattern.
    pub dash: Dash,
    /// Factor on the opacity where a surface hides the line; 0 hides it wholly.
    pub hidden: f32,
}

impl Line {
    /// An unbroken line of one colour, hidden by what is before it.
    #[must_use]
    pub fn new(points: impl IntoIterator<Item = Vec3>, width: f32, color: Color) -> Self {
        let points = points.into_iter().map(|position| LinePoint { position, color }).collect();
        Self { points, width, dash: Dash::Solid, hidden: 0.0 }
    }

    /// The same line, seen this strongly through surfaces.
    #[must_use]
    pub fn through(mut self, hidden: f32) -> Self {
        self.hidden = hidden;
        self
    }

    /// The same line in this pattern.
    #[must_use]
    pub fn dashed(mut self, dash: Dash) -> Self {
        self.dash = dash;
        self
    }
}

/// A plain dot of constant size on the screen, at a place of the unit sphere: those of its far side shine through faintly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dot {
    /// Where, in the pane's world.
    pub position: Vec3,
    /// Diameter in points.
    pub size: f32,
    /// Its colour.
    pub color: Color,
}

/// The form of a mark: marks are told apart without their colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Mark {
    /// A ball.
    Disc,
    /// A circle.
    Ring,
    /// A square on its corner.
    Diamond,
    /// Two crossed strokes.
    Cross,
    /// A square.
    Square,
    /// A triangle.
    Triangle,
    /// A triangle on its tip.
    TriangleDown,
    /// An empty square.
    OpenSquare,
    /// An empty square on its corner.
    OpenDiamond,
    /// An empty triangle.
    OpenTriangle,
    /// A star of four points.
    Star,
    /// An empty triangle on its tip.
    OpenTriangleDown,
    /// Two triangles tip to tip, one above the other.
    Hourglass,
    /// Two triangles tip to tip, side by side.
    Bow,
    /// Two bars side by side.
    Bars,
}

/// A mark of constant size on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Marker {
    /// Where, in the pane's world.
    pub position: Vec3,
    /// Diameter in points.
    pub size: f32,
    /// Its form.
    pub mark: Mark,
    /// Its colour.
    pub color: Color,
    /// The colour of the rim round it.
    pub rim: Color,
    /// Factor on the opacity where a surface hides the mark.
    pub hidden: f32,
    /// Follows the motion.
    pub moves: bool,
}

/// A text beside a point of the scene. Labels stay in the picture, and those that stand still avoid each other.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// What is labelled, in the pane's world.
    pub anchor: Vec3,
    /// Where the text would like to be from there on the screen: direction (x right, y up), any length.
    pub toward: Vec2,
    /// The text.
    pub text: String,
    /// Its colour.
    pub color: Color,
    /// How it is set.
    pub style: LabelStyle,
    /// Other places of what is labelled, each with its direction, where a label that stands still may go instead.
    pub others: Vec<(Vec3, Vec2)>,
}

impl Label {
    /// A label at this one place.
    #[must_use]
    pub fn new(anchor: Vec3, toward: Vec2, text: &str, color: Color, style: LabelStyle) -> Self {
        Self { anchor, toward, text: text.to_owned(), color, style, others: vec![] }
    }
}

/// A label where it was drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedName {
    /// Its text.
    pub text: String,
    /// The upper left corner of its rectangle (pixels of the picture, y down).
    pub low: Vec2,
    /// The lower right corner.
    pub high: Vec2,
}

/// How the labels of one kind of thing are set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LabelStyle {
    /// Height of the text (points).
    pub size: f32,
    /// Free space between the anchor and the text (points).
    pub gap: f32,
    /// Higher ones choose their places first, and others fade where they come near.
    pub priority: i32,
    /// Follows the motion, and stays in its wanted direction; labels that do not stand still while time runs.
    pub moves: bool,
    /// A stroke joins it to its anchor where it stands aside: what else is near is not meant.
    pub leads: bool,
    /// Its other places are about as good as the wanted one.
    pub is_anywhere: bool,
}

/// A line of text in the corner of a pane: it lies on the screen and not in the pane's world. Those with a swatch stand side by
/// side where there is room.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// The text.
    pub text: String,
    /// Height of the text (points).
    pub size: f32,
    /// Its colour.
    pub color: Color,
    /// A piece of what it explains, before it.
    pub swatch: Option<Swatch>,
}

/// A short piece of a line with a mark on it, as a legend shows them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swatch {
    /// Pattern of the line, its period in points.
    pub dash: Dash,
    /// Form of the mark.
    pub mark: Mark,
    /// Colour of both.
    pub color: Color,
    /// Colour of the rim round the mark.
    pub rim: Color,
}

#[cfg(test)]
mod tests {
    use super::halved;
    use glam::Vec2;

    #[test]
    fn triangles_make_up_the_polygon_and_go_the_way_it_goes() {
        for count in [0, 1, 2, 3, 4, 7, 64] {
            let corner = |n: u32| Vec2::from_angle(std::f32::consts::TAU * n as f32 / count as f32);
            let areas = halved(count).into_iter().map(|[a, b, c]| {
                let (a, b, c) = (corner(a), corner(b), corner(c));
                0.5 * (b - a).perp_dot(c - a)
            });
            let areas: Vec<f32> = areas.collect();
            assert_eq!(areas.len(), count.saturating_sub(2) as usize);
            assert!(areas.iter().all(|area| *area > 0.0));
            let whole = 0.5 * count as f32 * (std::f32::consts::TAU / count.max(3) as f32).sin();
            assert!(count < 3 || (areas.iter().sum::<f32>() - whole).abs() < 1e-5);
        }
    }
}
