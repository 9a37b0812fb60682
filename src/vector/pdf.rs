//! Drawings as PDF 1.7, each a page as large as the figure.

use std::collections::BTreeMap;

use glam::{DAffine2, DVec2};
use miniz_oxide::deflate::compress_to_vec_zlib;
use pdf_writer::types::{
    CidFontType, ColorSpaceOperand, FontFlags, FunctionShadingType, LineCapStyle, LineJoinStyle, MaskType, Predictor,
    SystemInfo, UnicodeCmap,
};
use pdf_writer::{Content, Filter, Finish, Name, Pdf, Rect, Ref, Str, TextStr};

use super::FigureOptions;
use super::drawing::{Drawing, Paint, Path, Picture, Shape, Step, Words};
use super::fonts::{UsedFont, outlines};
use super::metadata::packet;
use crate::frame::Color;
use crate::render::Letter;
use crate::render::png::{EncodingError, Remark, encode_small, packed_rows};

/// Points of 1/72 in of a pixel for screens.
const SCREEN: f64 = 0.75;
/// Parts of a pixel that places are written in.
const PER_PIXEL: f64 = 100.0;
/// Colours of a gradient that are written, evenly from end to end.
const SAMPLES: u8 = 33;
/// So much (pixels) of a picture's place is left out on all sides: poppler takes one that ends between two pixels for one that
/// reaches into the next, and stretches it.
const INSET: f32 = 0.02;
/// Effort of packing, of 10.
const EFFORT: u8 = 8;
/// Names of the typefaces.
const FONTS: [&str; 2] = ["DZHANI+Roboto-Medium", "DZHANI+Hack-Regular"];
/// How letters are numbered in both: by their place in the font.
const ORDERING: SystemInfo<'_> = SystemInfo { registry: Str(b"Adobe"), ordering: Str(b"Identity"), supplement: 0 };

/// Writes drawings of the size that the options say.
pub(super) fn write(
    drawings: &[Drawing],
    options: &FigureOptions,
    remarks: &[Remark],
) -> Result<Vec<u8>, EncodingError> {
    let [width, height] = options.size.map(f64::from);
    let page_size = options.paper.unwrap_or([width * SCREEN, height * SCREEN]);
    let page_from_pixel = DAffine2::from_cols(
        DVec2::new(page_size[0] / width, 0.0),
        DVec2::new(0.0, -page_size[1] / height),
        DVec2::new(0.0, page_size[1]),
    );
    let mut writer = Writer::new(page_from_pixel, drawings);
    for drawing in drawings {
        writer.content.transform(matrix(page_from_pixel)).set_line_join(LineJoinStyle::RoundJoin);
        if let Some(color) = drawing.background {
            let whole = Path::rectangle(DVec2::ZERO, DVec2::new(width, height));
            writer.shape(&Shape::Fill { path: whole, even_odd: false, paint: Paint::Flat(color) })?;
        }
        for shape in &drawing.shapes {
            writer.shape(shape)?;
        }
        writer.end_page();
    }
    Ok(writer.finish(page_size, remarks))
}

/// A kind of resource that a page names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    State,
    Pattern,
    Picture,
}

/// What is written so far.
struct Writer {
    pdf: Pdf,
    content: Content,
    /// The contents of the pages that are written.
    bodies: Vec<Ref>,
    last: i32,
    page_from_pixel: DAffine2,
    /// What the pages name: a letter of the kind and a number each.
    named: BTreeMap<(Kind, i32), Ref>,
    /// The states of opacities: of pen and of areas, in thousandths.
    opacities: BTreeMap<u16, i32>,
    fonts: Vec<UsedFont>,
}

impl Writer {
    fn new(page_from_pixel: DAffine2, drawings: &[Drawing]) -> Self {
        let mut letters = vec![];
        for drawing in drawings {
            collect(&drawing.shapes, &mut letters);
        }
        Self {
            pdf: Pdf::new(),
            content: Content::new(),
            bodies: vec![],
            // The first two: catalogue, pages.
            last: 2,
            page_from_pixel,
            named: BTreeMap::new(),
            opacities: BTreeMap::new(),
            fonts: UsedFont::all(letters.iter()),
        }
    }

    fn next(&mut self) -> Ref {
        self.last += 1;
        Ref::new(self.last)
    }

    /// Names an object for the page.
    fn name(&mut self, kind: Kind, object: Ref) -> i32 {
        self.named.insert((kind, object.get()), object);
        object.get()
    }

    fn shape(&mut self, shape: &Shape) -> Result<(), EncodingError> {
        match shape {
            Shape::Picture(picture) => self.picture(picture)?,
            Shape::Stroke { path, pen, paint } => {
                self.content.save_state();
                let cap = if pen.is_round { LineCapStyle::RoundCap } else { LineCapStyle::ButtCap };
                self.content.set_line_width(rounded(pen.width)).set_line_cap(cap);
                self.paint(paint, true, bounds(path, 0.5 * pen.width));
                self.steps(path);
                self.content.stroke().restore_state();
            }
            Shape::Fill { path, even_odd, paint } => {
                self.content.save_state();
                self.paint(paint, false, bounds(path, 0.0));
                self.steps(path);
                if *even_odd {
                    self.content.fill_even_odd()
                } else {
                    self.content.fill_nonzero()
                };
                self.content.restore_state();
            }
            // A halo is no text: it would be read twice.
            Shape::Words(words) if words.halo.is_some() => {
                if let Some(shape) = outlines(words) {
                    self.shape(&shape)?;
                }
            }
            Shape::Words(words) => self.words(words),
            Shape::Group { clip, shapes } => {
                self.content.save_state();
                self.steps(clip);
                self.content.clip_even_odd().end_path();
                for shape in shapes {
                    self.shape(shape)?;
                }
                self.content.restore_state();
            }
        }
        Ok(())
    }

    fn steps(&mut self, path: &Path) {
        let (mut at, mut start) = (DVec2::ZERO, DVec2::ZERO);
        let content = &mut self.content;
        let place = |at: DVec2| (rounded(at.x), rounded(at.y));
        for step in &path.0 {
            match *step {
                Step::Move(to) => {
                    let (x, y) = place(to);
                    content.move_to(x, y);
                    (at, start) = (to, to);
                }
                Step::Line(to) => {
                    let (x, y) = place(to);
                    content.line_to(x, y);
                    at = to;
                }
                Step::Quadratic(control, to) => {
                    let [(a, b), (c, d)] = [at, to].map(|end| place(end.lerp(control, 2.0 / 3.0)));
                    let (x, y) = place(to);
                    content.cubic_to(a, b, c, d, x, y);
                    at = to;
                }
                Step::Cubic(one, two, to) => {
                    let [(a, b), (c, d), (x, y)] = [one, two, to].map(place);
                    content.cubic_to(a, b, c, d, x, y);
                    at = to;
                }
                Step::Close => {
                    content.close_path();
                    at = start;
                }
            }
        }
    }

    /// Sets what a pen, or an area, is painted with.
    fn paint(&mut self, paint: &Paint, is_pen: bool, bounds: Rect) {
        let (kind, axes, stops) = match paint {
            Paint::Flat(color) => {
                self.opacity(color.0[3]);
                self.color(*color, is_pen);
                return;
            }
            Paint::Along { from, to, stops } => {
                let way = *to - *from;
                (FunctionShadingType::Axial, DAffine2::from_cols(way, way.perp(), *from), stops)
            }
            Paint::Around { axes: [x, y, middle], stops } => {
                (FunctionShadingType::Radial, DAffine2::from_cols(*x, *y, *middle), stops)
            }
        };
        let Some(&(_, first)) = stops.first() else { return };
        if stops.iter().all(|(_, color)| color.0[3] == first.0[3]) {
            self.opacity(first.0[3]);
        } else {
            self.mask(kind, axes, stops, bounds);
        }
        if stops.iter().all(|(_, color)| color.0[..3] == first.0[..3]) {
            self.color(first, is_pen);
            return;
        }
        let function = self.function(stops, &[0, 1, 2]);
        let pattern = self.next();
        let mut writer = self.pdf.shading_pattern(pattern);
        writer.matrix(matrix(self.page_from_pixel * axes));
        let mut shading = writer.function_shading();
        shading.shading_type(kind).coords(coordinates(kind).iter().copied()).function(function).extend([true; 2]);
        shading.color_space().device_rgb();
        shading.finish();
        writer.finish();
        let number = self.name(Kind::Pattern, pattern);
        let name = format!("P{number}");
        let name = Name(name.as_bytes());
        if is_pen {
            self.content.set_stroke_color_space(ColorSpaceOperand::Pattern).set_stroke_pattern(None, name);
        } else {
            self.content.set_fill_color_space(ColorSpaceOperand::Pattern).set_fill_pattern(None, name);
        }
    }

    fn color(&mut self, color: Color, is_pen: bool) {
        let [r, g, b] = [0, 1, 2].map(|channel| (color.0[channel].clamp(0.0, 1.0) * 255.0).round() / 255.0);
        // As many digits as tell 255 steps apart.
        let [r, g, b] = [r, g, b].map(|channel| (channel * 1e4).round() / 1e4);
        if is_pen {
            self.content.set_stroke_rgb(r, g, b)
        } else {
            self.content.set_fill_rgb(r, g, b)
        };
    }

    fn opacity(&mut self, alpha: f32) {
        let thousandths = (alpha.clamp(0.0, 1.0) * 1000.0).round() as u16;
        if thousandths == 1000 {
            return;
        }
        let known = self.opacities.get(&thousandths).copied();
        let number = known.unwrap_or_else(|| {
            let state = self.next();
            let alpha = f32::from(thousandths) / 1000.0;
            self.pdf.ext_graphics(state).stroking_alpha(alpha).non_stroking_alpha(alpha);
            self.opacities.insert(thousandths, state.get());
            self.name(Kind::State, state)
        });
        self.set_state(number);
    }

    fn set_state(&mut self, number: i32) {
        self.content.set_parameters(Name(format!("S{number}").as_bytes()));
    }

    /// Sets an opacity that changes from place to place: by the brightness of a group in which it is drawn.
    fn mask(&mut self, kind: FunctionShadingType, axes: DAffine2, stops: &[(f64, Color)], bounds: Rect) {
        let function = self.function(stops, &[3]);
        let (group, state) = (self.next(), self.next());
        let mut content = Content::new();
        content.transform(matrix(axes)).shading(Name(b"H"));
        let bytes = content.finish();
        let mut form = self.pdf.form_xobject(group, &bytes);
        form.bbox(bounds);
        let mut transparency = form.group();
        transparency.transparency().isolated(true);
        transparency.color_space().device_gray();
        transparency.finish();
        let mut resources = form.resources();
        let mut shadings = resources.shadings();
        let mut shading = shadings.insert(Name(b"H")).start::<pdf_writer::writers::FunctionShading<'_>>();
        shading.shading_type(kind).coords(coordinates(kind).iter().copied()).function(function).extend([true; 2]);
        shading.color_space().device_gray();
        shading.finish();
        shadings.finish();
        resources.finish();
        form.finish();
        let mut writer = self.pdf.ext_graphics(state);
        writer.soft_mask().subtype(MaskType::Luminosity).group(group);
        writer.finish();
        let number = self.name(Kind::State, state);
        self.set_state(number);
    }

    /// Colours, or opacities, along a way from 0 to 1.
    fn function(&mut self, stops: &[(f64, Color)], channels: &[usize]) -> Ref {
        let samples = (0..SAMPLES).flat_map(|n| {
            let color = color_at(stops, f64::from(n) / f64::from(SAMPLES - 1));
            channels.iter().map(move |channel| (color.0[*channel].clamp(0.0, 1.0) * 255.0).round() as u8)
        });
        let samples: Vec<u8> = samples.collect();
        let function = self.next();
        let mut writer = self.pdf.sampled_function(function, &samples);
        writer.domain([0.0, 1.0]).range(channels.iter().flat_map(|_| [0.0, 1.0]));
        writer.size([i32::from(SAMPLES)]).bits_per_sample(8);
        function
    }

    fn picture(&mut self, picture: &Picture) -> Result<(), EncodingError> {
        let [width, height] = picture.size.map(u32::cast_signed);
        let mut colors: Vec<u8> = vec![];
        let mut opacities: Vec<u8> = vec![];
        for pixel in picture.bytes.chunks_exact(picture.channels()) {
            colors.extend(&pixel[..3]);
            opacities.extend(&pixel[3..]);
        }
        let mut mask = None;
        if picture.has_opacity {
            let rows = packed_rows(&encode_small(picture.size, 1, &opacities)?);
            let object = self.next();
            let mut image = self.pdf.image_xobject(object, &rows);
            image.width(width).height(height).color_space().device_gray();
            image.bits_per_component(8).interpolate(true).filter(Filter::FlateDecode);
            image.decode_parms().predictor(Predictor::PngOptimum).colors(1).columns(width);
            mask = Some(object);
        }
        let rows = packed_rows(&encode_small(picture.size, 3, &colors)?);
        let object = self.next();
        let mut image = self.pdf.image_xobject(object, &rows);
        image.width(width).height(height).color_space().device_rgb();
        image.bits_per_component(8).interpolate(true).filter(Filter::FlateDecode);
        image.decode_parms().predictor(Predictor::PngOptimum).colors(3).columns(width);
        if let Some(mask) = mask {
            image.s_mask(mask);
        }
        image.finish();
        let number = self.name(Kind::Picture, object);
        let [x, y] = picture.corner.map(|pixels| pixels as f32 + INSET);
        let [width, height] = picture.size.map(|pixels| pixels as f32 - 2.0 * INSET);
        // A picture is the unit square, up.
        self.content.save_state().transform([width, 0.0, 0.0, -height, x, y + height]);
        self.content.x_object(Name(format!("I{number}").as_bytes())).restore_state();
        Ok(())
    }

    fn words(&mut self, words: &Words) {
        self.content.save_state();
        self.opacity(words.color.0[3]);
        self.color(words.color, false);
        self.content.begin_text();
        for run in words.letters.chunk_by(|a, b| a.font == b.font && a.em == b.em && a.pen[1] == b.pen[1]) {
            let (Some(first), Some(font)) = (run.first(), run.first().and_then(|first| self.font(first.font))) else {
                continue;
            };
            let numbers: Vec<u8> = run.iter().flat_map(|letter| font.glyph(letter.glyph).to_be_bytes()).collect();
            let [x, y] = first.pen.map(|at| rounded(f64::from(at)));
            self.content.set_font(Name(format!("F{}", first.font).as_bytes()), rounded(f64::from(first.em)));
            self.content.set_text_matrix([1.0, 0.0, 0.0, -1.0, x, y]).show(Str(&numbers));
        }
        self.content.end_text().restore_state();
    }

    fn font(&self, number: usize) -> Option<&UsedFont> {
        self.fonts.iter().find(|font| font.number == number)
    }

    /// Writes the fonts, each with its place among the typefaces.
    fn write_fonts(&mut self) -> Vec<(usize, Ref)> {
        let mut fonts = vec![];
        for font in std::mem::take(&mut self.fonts) {
            let [file, descriptor, by_number, whole, characters] = [(); 5].map(|()| self.next());
            let (Some(bytes), Some(name)) = (font.cut_out(), FONTS.get(font.number)) else { continue };
            let name = Name(name.as_bytes());
            let packed = compress_to_vec_zlib(&bytes, EFFORT);
            let mut stream = self.pdf.stream(file, &packed);
            stream.filter(Filter::FlateDecode).pair(Name(b"Length1"), i32::try_from(bytes.len()).unwrap_or_default());
            stream.finish();
            let [ascent, descent] = font.reach();
            self.pdf
                .font_descriptor(descriptor)
                .name(name)
                .flags(FontFlags::SYMBOLIC)
                .bbox(Rect::new(-500.0, descent, 1500.0, ascent))
                .italic_angle(0.0)
                .ascent(ascent)
                .descent(descent)
                .cap_height(711.0)
                .stem_v(100.0)
                .font_file2(file);
            let mut cid = self.pdf.cid_font(by_number);
            cid.subtype(CidFontType::Type2).base_font(name).system_info(ORDERING).font_descriptor(descriptor);
            cid.default_width(0.0).cid_to_gid_map_predefined(Name(b"Identity"));
            let mut widths = cid.widths();
            let mut map = UnicodeCmap::new(Name(b"Custom"), ORDERING);
            for (character, glyph) in &font.glyphs {
                let number = font.glyph(*glyph);
                widths.consecutive(number, [font.width(*glyph)]);
                map.pair(number, *character);
            }
            widths.finish();
            cid.finish();
            let map = compress_to_vec_zlib(&map.finish(), EFFORT);
            self.pdf.cmap(characters, &map).filter(Filter::FlateDecode);
            self.pdf
                .type0_font(whole)
                .base_font(name)
                .encoding_predefined(Name(b"Identity-H"))
                .descendant_font(by_number)
                .to_unicode(characters);
            fonts.push((font.number, whole));
        }
        fonts
    }

    /// Ends a page; the next one begins.
    fn end_page(&mut self) {
        let body = self.next();
        let content = compress_to_vec_zlib(&std::mem::replace(&mut self.content, Content::new()).finish(), EFFORT);
        self.pdf.stream(body, &content).filter(Filter::FlateDecode);
        self.bodies.push(body);
    }

    /// Writes a page, which may name whatever any of them does.
    fn write_page(&mut self, (page, pages): (Ref, Ref), body: Ref, [width, height]: [f64; 2], fonts: &[(usize, Ref)]) {
        let mut leaf = self.pdf.page(page);
        let size = [width, height].map(|points| ((points * 1000.0).round() / 1000.0) as f32);
        leaf.parent(pages).media_box(Rect::new(0.0, 0.0, size[0], size[1])).contents(body);
        let mut group = leaf.group();
        group.transparency().isolated(true);
        group.color_space().device_rgb();
        group.finish();
        let mut resources = leaf.resources();
        if !fonts.is_empty() {
            let mut names = resources.fonts();
            for &(number, font) in fonts {
                names.pair(Name(format!("F{number}").as_bytes()), font);
            }
        }
        for (kind, letter) in [(Kind::State, 'S'), (Kind::Pattern, 'P'), (Kind::Picture, 'I')] {
            let of_kind: Vec<_> = self.named.iter().filter(|((other, _), _)| *other == kind).collect();
            if of_kind.is_empty() {
                continue;
            }
            let mut names = match kind {
                Kind::State => resources.ext_g_states(),
                Kind::Pattern => resources.patterns(),
                Kind::Picture => resources.x_objects(),
            };
            for ((_, number), object) in of_kind {
                names.pair(Name(format!("{letter}{number}").as_bytes()), *object);
            }
        }
        resources.finish();
        leaf.finish();
    }

    fn finish(mut self, [width, height]: [f64; 2], remarks: &[Remark]) -> Vec<u8> {
        let fonts = self.write_fonts();
        let [catalogue, pages] = [1, 2].map(Ref::new);
        let [information, metadata] = [(); 2].map(|()| self.next());
        let bodies = std::mem::take(&mut self.bodies);
        let leaves: Vec<Ref> = bodies.iter().map(|_| self.next()).collect();
        let mut root = self.pdf.catalog(catalogue);
        root.pages(pages);
        if !remarks.is_empty() {
            root.metadata(metadata);
        }
        root.finish();
        self.pdf.pages(pages).kids(leaves.iter().copied()).count(i32::try_from(leaves.len()).unwrap_or_default());
        for (page, body) in leaves.into_iter().zip(bodies) {
            self.write_page((page, pages), body, [width, height], &fonts);
        }
        if !remarks.is_empty() {
            self.pdf.metadata(metadata, packet(remarks).as_bytes());
            let said = |keyword: &str| remarks.iter().find(|(name, _)| *name == keyword).map(|(_, text)| &**text);
            let mut document = self.pdf.document_info(information);
            if let Some(text) = said("Title") {
                document.title(TextStr(text));
            }
            if let Some(text) = said("Description") {
                document.subject(TextStr(text));
            }
            if let Some(text) = said("Software") {
                document.creator(TextStr(text));
            }
        }
        self.pdf.finish()
    }
}

/// The letters of all texts.
fn collect(shapes: &[Shape], letters: &mut Vec<Letter>) {
    for shape in shapes {
        match shape {
            Shape::Words(words) if words.halo.is_none() => letters.extend_from_slice(&words.letters),
            Shape::Group { shapes, .. } => collect(shapes, letters),
            _ => {}
        }
    }
}

/// The ends of a gradient in its own space: along the first axis, or from the middle to the unit circle.
fn coordinates(kind: FunctionShadingType) -> &'static [f32] {
    if kind == FunctionShadingType::Axial { &[0.0, 0.0, 1.0, 0.0] } else { &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0] }
}

/// The colour of a gradient at a part of its way.
fn color_at(stops: &[(f64, Color)], part: f64) -> Color {
    let next = stops.partition_point(|(at, _)| *at < part).clamp(1, stops.len().max(2) - 1);
    match (stops.get(next - 1), stops.get(next)) {
        (Some((from, a)), Some((to, b))) if to > from => {
            a.mix(*b, ((part - from) / (to - from)).clamp(0.0, 1.0) as f32)
        }
        (_, Some((_, color))) | (Some((_, color)), None) => *color,
        (None, None) => Color([0.0; 4]),
    }
}

/// A place in hundredths of a pixel.
fn rounded(pixels: f64) -> f32 {
    ((pixels * PER_PIXEL).round() / PER_PIXEL) as f32
}

fn matrix(map: DAffine2) -> [f32; 6] {
    map.to_cols_array().map(|value| value as f32)
}

/// What a path takes up, with a rim.
fn bounds(path: &Path, rim: f64) -> Rect {
    let (low, high) =
        path.points().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
    let (low, high) = (low - rim - 1.0, high + rim + 1.0);
    Rect::new(rounded(low.x), rounded(low.y), rounded(high.x), rounded(high.y))
}
