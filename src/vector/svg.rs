//! A drawing as SVG 1.1, as browsers, Inkscape and librsvg read it.

use std::fmt::Write as _;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use glam::DVec2;

use super::FigureOptions;
use super::drawing::{Drawing, Paint, Path, Picture, Shape, Step, Words};
use super::fonts::UsedFont;
use super::metadata::{description, escaped};
use crate::frame::Color;
use crate::render::Letter;
use crate::render::png::{EncodingError, Remark, encode_small};

/// Parts of a pixel that places are written in.
const PER_PIXEL: f64 = 100.0;
/// Names of the typefaces, their weights and what stands for them where a reader takes no font of the file.
const FAMILIES: [(&str, u16, &str); 2] = [("Roboto", 500, "sans-serif"), ("Hack", 400, "monospace")];

/// Writes a drawing.
pub(super) fn write(drawing: &Drawing, options: &FigureOptions, remarks: &[Remark]) -> Result<String, EncodingError> {
    let [width, height] = drawing.size;
    let mut writer = Writer::default();
    if let Some(color) = drawing.background {
        let _ = writeln!(writer.body, "<rect width=\"{width}\" height=\"{height}\" {}/>", paint_of("fill", color));
    }
    for shape in &drawing.shapes {
        writer.shape(shape)?;
    }
    let [wide, high] = lengths(drawing.size, options.paper);
    let mut file = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" \
         width=\"{wide}\" height=\"{high}\" viewBox=\"0 0 {width} {height}\">\n"
    );
    for (element, keyword) in [("title", "Title"), ("desc", "Description")] {
        if let Some((_, text)) = remarks.iter().find(|(name, text)| *name == keyword && !text.is_empty()) {
            let _ = writeln!(file, "<{element}>{}</{element}>", escaped(text));
        }
    }
    if !remarks.is_empty() {
        let _ = writeln!(file, "<metadata>\n{}\n</metadata>", description(remarks));
    }
    let style = writer.style();
    if !(style.is_empty() && writer.definitions.is_empty()) {
        let _ = writeln!(file, "<defs>\n{style}{}</defs>", writer.definitions);
    }
    file.push_str("<g fill=\"none\" stroke-linejoin=\"round\" xml:space=\"preserve\">\n");
    file.push_str(&writer.body);
    file.push_str("</g>\n</svg>\n");
    Ok(file)
}

/// Width and height, on paper where they are said there.
fn lengths(pixels: [u32; 2], paper: Option<[f64; 2]>) -> [String; 2] {
    let thousandths = |points: f64| decimal((points / 72.0 * 25.4 * 1000.0).round() as i64, 3) + "mm";
    paper.map_or_else(|| pixels.map(|pixels| pixels.to_string()), |points| points.map(thousandths))
}

/// What is written so far.
#[derive(Default)]
struct Writer {
    body: String,
    definitions: String,
    /// How many definitions have a name.
    named: usize,
    letters: Vec<Letter>,
}

impl Writer {
    fn shape(&mut self, shape: &Shape) -> Result<(), EncodingError> {
        match shape {
            Shape::Picture(picture) => self.picture(picture)?,
            Shape::Stroke { path, pen, paint } => {
                let paint = self.paint("stroke", paint);
                let width = number(pen.width);
                let cap = if pen.is_round { " stroke-linecap=\"round\"" } else { "" };
                let _ = writeln!(self.body, "<path {paint} stroke-width=\"{width}\"{cap} d=\"{}\"/>", steps(path));
            }
            Shape::Fill { path, even_odd, paint } => {
                let paint = self.paint("fill", paint);
                let rule = if *even_odd { " fill-rule=\"evenodd\"" } else { "" };
                let _ = writeln!(self.body, "<path {paint}{rule} d=\"{}\"/>", steps(path));
            }
            Shape::Words(words) => self.words(words),
            Shape::Group { clip, shapes } => {
                let name = self.name();
                let _ = writeln!(
                    self.definitions,
                    "<clipPath id=\"{name}\"><path clip-rule=\"evenodd\" d=\"{}\"/></clipPath>",
                    steps(clip)
                );
                let _ = writeln!(self.body, "<g clip-path=\"url(#{name})\">");
                for shape in shapes {
                    self.shape(shape)?;
                }
                self.body.push_str("</g>\n");
            }
        }
        Ok(())
    }

    /// A name that nothing else in the file has.
    fn name(&mut self) -> String {
        self.named += 1;
        format!("d{}", self.named)
    }

    fn picture(&mut self, picture: &Picture) -> Result<(), EncodingError> {
        let [x, y] = picture.corner;
        let [width, height] = picture.size;
        let bytes = encode_small(picture.size, picture.channels(), &picture.bytes)?;
        let _ = write!(
            self.body,
            "<image x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" preserveAspectRatio=\"none\" \
             xlink:href=\"data:image/png;base64,"
        );
        STANDARD.encode_string(bytes, &mut self.body);
        self.body.push_str("\"/>\n");
        Ok(())
    }

    /// The attributes of a paint; what is no single colour is defined once for all that have it.
    fn paint(&mut self, attribute: &str, paint: &Paint) -> String {
        let (element, attributes, stops) = match paint {
            Paint::Flat(color) => return paint_of(attribute, *color),
            Paint::Along { from, to, stops } => {
                let [x1, y1, x2, y2] = [from.x, from.y, to.x, to.y].map(number);
                ("linearGradient", format!("x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\""), stops)
            }
            Paint::Around { axes: [x, y, middle], stops } => {
                let matrix = [x.x, x.y, y.x, y.y, middle.x, middle.y].map(number).join(" ");
                ("radialGradient", format!("cx=\"0\" cy=\"0\" r=\"1\" gradientTransform=\"matrix({matrix})\""), stops)
            }
        };
        let name = self.name();
        let _ = write!(self.definitions, "<{element} id=\"{name}\" gradientUnits=\"userSpaceOnUse\" {attributes}>");
        for (at, color) in stops {
            let at = fraction(*at);
            let _ =
                write!(self.definitions, "<stop offset=\"{at}\" {}/>", color_of("stop-color", "stop-opacity", *color));
        }
        let _ = writeln!(self.definitions, "</{element}>");
        format!("{attribute}=\"url(#{name})\"")
    }

    fn words(&mut self, words: &Words) {
        self.letters.extend_from_slice(&words.letters);
        let paint = match words.halo {
            None => paint_of("fill", words.color),
            // Read out once.
            Some(reach) => {
                format!(
                    "{} stroke-width=\"{}\" aria-hidden=\"true\"",
                    paint_of("stroke", words.color),
                    number(2.0 * reach)
                )
            }
        };
        let mut runs = words.letters.chunk_by(|a, b| a.font == b.font && a.em == b.em && a.pen[1] == b.pen[1]);
        let is_same = |run: &[Letter]| run.len() == words.letters.len();
        let Some(first) = runs.next() else { return };
        if is_same(first) {
            let _ = writeln!(self.body, "<text {paint} {}>{}</text>", place(first), characters(first));
            return;
        }
        let _ = write!(self.body, "<text {paint}>");
        for run in std::iter::once(first).chain(runs) {
            let _ = write!(self.body, "<tspan {}>{}</tspan>", place(run), characters(run));
        }
        self.body.push_str("</text>\n");
    }

    /// The fonts of the texts.
    fn style(&self) -> String {
        let fonts = UsedFont::all(self.letters.iter());
        if fonts.is_empty() {
            return String::new();
        }
        let mut style = String::from("<style>\n");
        for font in fonts {
            let Some((family, weight, _)) = FAMILIES.get(font.number) else { continue };
            let Some(bytes) = font.for_browsers() else { continue };
            let _ = writeln!(
                style,
                "@font-face{{font-family:{family};font-weight:{weight};src:url(data:font/ttf;base64,{})}}",
                STANDARD.encode(bytes)
            );
        }
        let (family, weight, else_family) = FAMILIES[0];
        let _ = writeln!(
            style,
            "text{{font-family:{family},{else_family};font-weight:{weight};font-kerning:none;\
             text-rendering:geometricPrecision}}"
        );
        style.push_str("</style>\n");
        style
    }
}

/// Where a run of letters begins, and its size; its font where it is not the usual one.
fn place(run: &[Letter]) -> String {
    let Some(first) = run.first() else { return String::new() };
    let [x, y, size] = [first.pen[0], first.pen[1], first.em].map(|value| number(f64::from(value)));
    let font = match FAMILIES.get(first.font) {
        Some((family, weight, else_family)) if first.font > 0 => {
            format!(" font-family=\"{family},{else_family}\" font-weight=\"{weight}\"")
        }
        _ => String::new(),
    };
    format!("x=\"{x}\" y=\"{y}\" font-size=\"{size}\"{font}")
}

fn characters(run: &[Letter]) -> String {
    escaped(&run.iter().map(|letter| letter.character).collect::<String>())
}

/// An attribute that paints with one colour.
fn paint_of(attribute: &str, color: Color) -> String {
    color_of(attribute, if attribute == "stroke" { "stroke-opacity" } else { "fill-opacity" }, color)
}

fn color_of(attribute: &str, opacity: &str, color: Color) -> String {
    let [r, g, b, alpha] = color.0;
    let [r, g, b] = [r, g, b].map(|channel| (channel.clamp(0.0, 1.0) * 255.0).round() as u8);
    let mut text = format!("{attribute}=\"#{r:02x}{g:02x}{b:02x}\"");
    if alpha < 1.0 {
        let _ = write!(text, " {opacity}=\"{}\"", fraction(f64::from(alpha)));
    }
    text
}

/// A part of 1, in thousandths.
fn fraction(part: f64) -> String {
    decimal((part * 1000.0).round() as i64, 3)
}

/// A length in pixels, in hundredths.
fn number(pixels: f64) -> String {
    decimal((pixels * PER_PIXEL).round() as i64, 2)
}

/// A whole number of such decimal parts, as short as it can be written.
fn decimal(value: i64, places: u32) -> String {
    let unit = 10_i64.pow(places);
    let (whole, rest) = (value.abs() / unit, value.abs() % unit);
    let mut text = String::new();
    if value < 0 {
        text.push('-');
    }
    if whole > 0 || rest == 0 {
        let _ = write!(text, "{whole}");
    }
    if rest > 0 {
        let digits = format!("{rest:0width$}", width = places as usize);
        let _ = write!(text, ".{}", digits.trim_end_matches('0'));
    }
    text
}

/// A path, each place from the one before it: rounded places do not drift.
fn steps(path: &Path) -> String {
    let mut text = String::new();
    let rounded = |at: DVec2| [(at.x * PER_PIXEL).round() as i64, (at.y * PER_PIXEL).round() as i64];
    let (mut at, mut start) = ([0_i64; 2], [0_i64; 2]);
    let mut letter_before = ' ';
    for step in &path.0 {
        let (letter, points): (char, Vec<DVec2>) = match *step {
            Step::Move(a) => ('m', vec![a]),
            Step::Line(a) => ('l', vec![a]),
            Step::Quadratic(a, b) => ('q', vec![a, b]),
            Step::Cubic(a, b, c) => ('c', vec![a, b, c]),
            Step::Close => ('z', vec![]),
        };
        if letter != letter_before || letter == 'm' || letter == 'z' {
            text.push(letter);
        }
        letter_before = letter;
        let mut next = at;
        for point in points {
            next = rounded(point);
            for axis in 0..2 {
                let value = decimal(next[axis] - at[axis], 2);
                if !value.starts_with('-') && !text.ends_with(char::is_alphabetic) {
                    text.push(' ');
                }
                text.push_str(&value);
            }
        }
        if letter == 'z' {
            next = start;
        }
        if letter == 'm' {
            start = next;
        }
        at = next;
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{decimal, steps};
    use crate::vector::drawing::{Path, Step};
    use glam::DVec2;

    #[test]
    fn places_are_written_short_and_do_not_drift() {
        assert_eq!([decimal(0, 2), decimal(-5, 2), decimal(150, 2), decimal(-300, 2)], ["0", "-.05", "1.5", "-3"]);
        let points = (0..100).map(|n| DVec2::new(f64::from(n) * 0.014, 1.0));
        let text = steps(&Path::through(points, false));
        // 99 · 0.014 = 1.386 pixels to the right, whatever the steps between were rounded to.
        let across: Vec<f64> = text[1..].split(['l', ' ']).filter_map(|word| word.parse().ok()).step_by(2).collect();
        assert!((across.iter().sum::<f64>() - 1.39).abs() < 1e-9, "{text}");
        let twice = Path(vec![Step::Move(DVec2::ONE), Step::Line(DVec2::ZERO), Step::Close, Step::Move(DVec2::ONE)]);
        assert_eq!(steps(&twice), "m1 1l-1-1zm0 0");
    }
}
