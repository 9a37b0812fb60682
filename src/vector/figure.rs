//! A frame as shapes: its surfaces, and over them pane by pane lines, marks and texts, in the renderer's order.

use glam::{DMat4, DVec2, DVec3, Vec2};

use super::drawing::{Drawing, Path, Picture, Shape, Words};
use super::facets::{self, Facet};
use super::lines::{self, Part, Projection};
use super::shells::{self, Wall};
use super::sight::Sight;
use super::{FigureOptions, Letters, Shading, dots, flats, fonts, marks};
use crate::camera::{Camera, NEAR};
use crate::frame::{Color, Frame, Pane, Walls};
use crate::render::{self, Pixels, PlacedText, ScreenLayer};

/// What transparent figures are mostly put on.
const PAPER: Color = Color([1.0; 4]);

/// The surfaces of a frame as pixels of the figure's size.
#[derive(Debug, Default)]
pub struct Surfaces {
    /// Under everything.
    pub below: Option<Pixels>,
    /// Over the lines that are looked at through the near walls of hollow surfaces, and under all others; transparent.
    pub above: Option<Pixels>,
}

/// What the renderer is to draw for [`Surfaces`]: the surfaces alone, those below and, where any are hollow, the near walls.
#[must_use]
pub fn surfaces(frame: &Frame) -> [Option<Frame>; 2] {
    let mut below = Frame { panes: frame.panes.iter().map(bare).collect(), ..frame.clone() };
    let mut above = Frame { transparent: true, ..below.clone() };
    for (low, high) in below.panes.iter_mut().zip(&mut above.panes) {
        if is_hollow(low) {
            low.quadrics.retain(|pair| pair.hollow);
            low.quadrics.iter_mut().for_each(|pair| pair.walls = Walls::Far);
            for pair in high.quadrics.iter_mut().filter(|pair| pair.hollow) {
                pair.walls = Walls::Near;
            }
            // Bodies hide the walls behind them, and are seen below.
            high.meshes.retain(|mesh| mesh.opaque);
            for vertex in high.meshes.iter_mut().flat_map(|mesh| &mut mesh.vertices) {
                vertex.color = vertex.color.alpha(0.0);
            }
        } else {
            (high.quadrics, high.meshes) = (vec![], vec![]);
        }
    }
    let shows = |frame: &Frame| frame.panes.iter().any(|pane| !pane.quadrics.is_empty() || !pane.meshes.is_empty());
    [Some(below).filter(shows), Some(above).filter(shows)]
}

/// A pane's surfaces without what is drawn over them.
fn bare(pane: &Pane) -> Pane {
    let (meshes, quadrics) = (pane.meshes.clone(), pane.quadrics.clone());
    Pane { meshes, quadrics, ..Pane::new(pane.area, pane.camera, pane.lift) }
}

/// Whether lines are looked at through walls.
fn is_hollow(pane: &Pane) -> bool {
    pane.quadrics.iter().any(|pair| pair.hollow)
}

/// A figure whose surfaces are still to be laid under it: what takes no pixels to find out.
#[derive(Debug)]
pub struct Sketch {
    options: FigureOptions,
    is_transparent: bool,
    base: Option<Color>,
    /// What is seen through the near walls of hollow surfaces.
    inside: Vec<Shape>,
    /// What lies over all surfaces.
    over: Vec<Shape>,
}

impl Sketch {
    /// The lines, marks and texts of a frame, and its surfaces where they are areas.
    #[must_use]
    pub fn new(frame: &Frame, options: &FigureOptions) -> Self {
        let overlays = render::screen_layers(frame, options.size);
        let base = (!frame.transparent).then_some(frame.background);
        let is_flat = options.style.shading == Shading::Flat;
        let (mut inside, mut over) = (vec![], vec![]);
        for (pane, overlay) in frame.panes.iter().zip(&overlays) {
            let view = View::new(pane, frame, options);
            let mut drawn = if is_flat { view.surfaces(base.unwrap_or(PAPER)) } else { vec![] };
            dots::draw(view.pane, &view.sight, &view.projection, &mut drawn);
            if !is_hollow(view.pane) {
                drawn.extend(view.lines(Part::Hidden));
            } else if !is_flat {
                view.group(view.lines(Part::Inside), &mut inside);
            }
            drawn.extend(view.lines(Part::Seen));
            marks::draw(&view.pane.markers, &view.sight, view.across, &view.projection, &mut drawn);
            view.overlay(overlay, frame, options, &mut drawn);
            view.group(drawn, &mut over);
        }
        Self { options: *options, is_transparent: frame.transparent, base, inside, over }
    }

    /// What it was made by.
    #[must_use]
    pub fn options(&self) -> &FigureOptions {
        &self.options
    }

    /// The figure, over its surfaces.
    pub(super) fn over(self, surfaces: &Surfaces) -> Drawing {
        let mut shapes = vec![];
        shapes.extend(surfaces.below.as_ref().and_then(|pixels| picture(pixels, self.is_transparent, self.base)));
        shapes.extend(self.inside);
        shapes.extend(surfaces.above.as_ref().and_then(|pixels| picture(pixels, true, None)));
        shapes.extend(self.over);
        Drawing { size: self.options.size, background: self.base, shapes }
    }
}

/// A pane, as it is seen in the figure.
struct View<'a> {
    pane: &'a Pane,
    sight: Sight,
    projection: Projection,
    /// A step of one pixel to the right, and down, at depth 1.
    across: [DVec3; 2],
}

impl<'a> View<'a> {
    fn new(pane: &'a Pane, frame: &Frame, options: &FigureOptions) -> Self {
        let picture = Vec2::new(options.size[0] as f32, options.size[1] as f32);
        let (corner, pixels) = (pane.area.corner * picture, (pane.area.extent * picture).max(Vec2::ONE));
        let aspect = pixels.x / pixels.y;
        let clip = pane.camera.clip_from_world(aspect).as_dmat4();
        let (right, up, _) = pane.camera.axes();
        let pixel = 2.0 * (0.5 * Camera::vertical_field(aspect)).tan() / pixels.y;
        let projection = Projection {
            clip,
            corner: corner.as_dvec2(),
            pixels: pixels.as_dvec2(),
            point: f64::from(render::point_size(options.size) * frame.font_scale),
            thinnest: options.thinnest,
        };
        let across = [right * pixel, up * -pixel].map(glam::Vec3::as_dvec3);
        Self { pane, sight: Sight::new(pane, clip), projection, across }
    }

    /// A part of all lines.
    fn lines(&self, part: Part) -> Vec<Shape> {
        let mut shapes = vec![];
        for line in &self.pane.lines {
            lines::draw(line, part, &self.sight, &self.projection, &mut shapes);
        }
        shapes
    }

    /// The surfaces as areas over a ground of this colour, and of hollow ones the lines within.
    fn surfaces(&self, ground: Color) -> Vec<Shape> {
        let (pane, projection) = (self.pane, &self.projection);
        let mut shapes = vec![];
        flats::draw(pane, projection, ground, false, &mut shapes);
        shells::draw(pane, projection, Wall::Far, &mut shapes);
        let facets = facets::facets(pane, &self.sight, projection);
        let eye = pane.camera.eye().as_dvec3();
        // Of what is within walls some may stand out of them: the walls are not before that.
        let cut = facets.into_iter().flat_map(|facet| facet.cut_at_walls(&self.sight, eye, projection));
        let facets: Vec<Facet> = cut.collect();
        shapes.extend(facets.iter().map(Facet::shape));
        if is_hollow(pane) {
            shapes.extend(self.lines(Part::Inside));
        }
        let walls = shapes.len();
        shells::draw(pane, projection, Wall::Near, &mut shapes);
        if shapes.len() > walls {
            shapes.extend(facets.iter().filter(|facet| facet.stands_out_of_walls(&self.sight)).map(Facet::shape));
        }
        flats::draw(pane, projection, ground, true, &mut shapes);
        shapes
    }

    /// What lies on the screen before the pane.
    fn overlay(&self, overlay: &ScreenLayer, frame: &Frame, options: &FigureOptions, shapes: &mut Vec<Shape>) {
        let pixels = self.projection.pixels;
        // Places are pixels from the upper left corner.
        let scale = DMat4::from_scale(DVec3::new(2.0 / pixels.x, -2.0 / pixels.y, 0.0));
        let clip = DMat4::from_translation(DVec3::new(-1.0, 1.0, f64::from(NEAR))) * scale;
        let flat = Projection { clip, ..self.projection };
        let nothing = Sight::default();
        for line in &overlay.lines {
            lines::draw(line, Part::Seen, &nothing, &flat, shapes);
        }
        marks::draw(&overlay.markers, &nothing, [DVec3::ZERO; 2], &flat, shapes);
        let halos = render::halo(frame, options.size);
        // From outside in: what is covered twice has the inmost part's strength.
        let outer = halos[1].1.0[3];
        let inner = 1.0 - (1.0 - halos[0].1.0[3]) / (1.0 - outer);
        for (reach, strength) in [(halos[1].0, outer), (halos[0].0, inner)] {
            for text in &overlay.texts {
                let color = frame.background.alpha(strength * text.color.0[3]);
                self.words(text, Some(f64::from(reach)), color, options.style.letters, shapes);
            }
        }
        for text in &overlay.texts {
            self.words(text, None, text.color, options.style.letters, shapes);
        }
    }

    fn words(&self, text: &PlacedText, halo: Option<f64>, color: Color, form: Letters, shapes: &mut Vec<Shape>) {
        if color.0[3] <= 0.0 || text.letters.is_empty() {
            return;
        }
        let corner = self.projection.corner.as_vec2() + text.corner;
        let mut letters = text.letters.clone();
        for letter in &mut letters {
            // Base lines are whole pixels, as the picture's are.
            letter.pen = [corner.x + letter.pen[0], (corner.y + letter.pen[1]).round()];
        }
        let words = Words { letters, halo, color };
        match form {
            Letters::Text => shapes.push(Shape::Words(words)),
            Letters::Outlines => shapes.extend(fonts::outlines(&words)),
        }
    }

    /// Adds shapes, cut off at the pane's border where they reach beyond it.
    fn group(&self, drawn: Vec<Shape>, shapes: &mut Vec<Shape>) {
        let (low, high) = (self.projection.corner, self.projection.corner + self.projection.pixels);
        let is_inside = |shape: &Shape| match shape {
            Shape::Stroke { path, pen, .. } => {
                let rim = DVec2::splat(0.5 * pen.width);
                path.points().all(|at| (at - rim).cmpge(low).all() && (at + rim).cmple(high).all())
            }
            Shape::Fill { path, .. } => path.points().all(|at| at.cmpge(low).all() && at.cmple(high).all()),
            // An em round each pen, and the halo, hold its letter.
            Shape::Words(words) => words.letters.iter().all(|letter| {
                let (pen, em) = (DVec2::new(letter.pen[0].into(), letter.pen[1].into()), f64::from(letter.em));
                let halo = words.halo.unwrap_or_default();
                (pen - DVec2::new(0.1 * em, em) - halo).cmpge(low).all()
                    && (pen + DVec2::new(em, 0.3 * em) + halo).cmple(high).all()
            }),
            Shape::Picture(_) | Shape::Group { .. } => true,
        };
        if drawn.iter().all(is_inside) {
            shapes.extend(drawn);
        } else {
            shapes.push(Shape::Group { clip: Path::rectangle(low, high), shapes: drawn });
        }
    }
}

/// The part of some pixels that shows anything.
fn picture(pixels: &Pixels, has_opacity: bool, background: Option<Color>) -> Option<Shape> {
    let [width, height] = pixels.size;
    let ground = background.map_or([0; 4], |color| color.0.map(|channel| (channel * 255.0).round() as u8));
    let row = |y: u32| &pixels.rgba[(4 * y * width) as usize..(4 * (y + 1) * width) as usize];
    let (mut low, mut high) = ([width, height], [0, 0]);
    for y in 0..height {
        for (x, pixel) in row(y).chunks_exact(4).enumerate() {
            if *pixel != ground {
                let x = x as u32;
                low = [low[0].min(x), low[1].min(y)];
                high = [high[0].max(x + 1), high[1].max(y + 1)];
            }
        }
    }
    if low[0] >= high[0] {
        return None;
    }
    let size = [high[0] - low[0], high[1] - low[1]];
    let mut part = Pixels { size, rgba: Vec::with_capacity((4 * size[0] * size[1]) as usize) };
    for y in low[1]..high[1] {
        part.rgba.extend_from_slice(&row(y)[4 * low[0] as usize..4 * high[0] as usize]);
    }
    let bytes = render::png::colours(&part, has_opacity);
    Some(Shape::Picture(Picture { corner: low, size, bytes, has_opacity }))
}
