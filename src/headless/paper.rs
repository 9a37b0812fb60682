//! How large a picture is: in pixels, or on paper, where type and lines have their sizes whatever the width.

use std::fmt;
use std::str::FromStr;

use crate::render::point_size;
use crate::scene::one_number;

/// Points of paper (1/72 in) that a point of a frame takes there: captions, 20 of them high, are set in 8 pt.
pub const POINT: f64 = 0.4;
/// Least width (points of paper) of a line that is written as a line: presses lose thinner ones.
pub const THINNEST_LINE: f64 = 0.25;
/// Dots an inch where a size on paper is given and nothing is said of them.
const USUAL_DENSITY: f64 = 300.0;
/// Millimetres and points of an inch.
const MILLIMETRES: f64 = 25.4;
const POINTS: f64 = 72.0;

/// A unit of length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Unit {
    Millimetre,
    Centimetre,
    Inch,
    Point,
    Pixel,
}

/// Each unit with its name.
const UNITS: [(&str, Unit); 5] =
    [("mm", Unit::Millimetre), ("cm", Unit::Centimetre), ("in", Unit::Inch), ("pt", Unit::Point), ("px", Unit::Pixel)];

/// A length with its unit, as authors say it: `86mm`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Length {
    value: f64,
    unit: Unit,
}

impl Length {
    /// So many dots, where an inch has this many.
    fn dots(self, an_inch: f64) -> f64 {
        match self.unit {
            Unit::Millimetre => self.value / MILLIMETRES * an_inch,
            Unit::Centimetre => self.value * 10.0 / MILLIMETRES * an_inch,
            Unit::Inch => self.value * an_inch,
            Unit::Point => self.value / POINTS * an_inch,
            Unit::Pixel => self.value,
        }
    }
}

impl FromStr for Length {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim();
        UNITS
            .into_iter()
            .find_map(|(name, unit)| {
                let value = one_number(text.strip_suffix(name)?).ok()?;
                (value > 0.0 && value.is_finite()).then_some(Self { value, unit })
            })
            .ok_or_else(|| {
                "a length is a number above 0, in the range of numbers, with its unit: mm, cm, in, pt or px, as in 86mm"
                    .to_owned()
            })
    }
}

impl fmt::Display for Length {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = UNITS.iter().find_map(|(name, unit)| (*unit == self.unit).then_some(*name)).unwrap_or_default();
        let (plain, power) = (self.value.to_string(), format!("{:e}", self.value));
        // A power where it is much shorter.
        write!(formatter, "{}{name}", if power.len() + 2 < plain.len() { power } else { plain })
    }
}

/// How large a picture is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureSize {
    /// Width and height in pixels.
    pub pixels: [u32; 2],
    /// Width and height on paper in points of 1/72 in, where they are said.
    pub paper: Option<[f64; 2]>,
    /// Pixels an inch that its file is marked with.
    pub density: Option<f64>,
}

impl PictureSize {
    /// In pixels alone.
    #[must_use]
    pub fn in_pixels(pixels: [u32; 2]) -> Self {
        Self { pixels, paper: None, density: None }
    }

    /// From what is said of it: a size in pixels, which gives the aspect alone where a width or a height is there, and
    /// dots an inch, which alone only mark the file. A width or a height in pixels is one on paper where these are given.
    #[must_use]
    pub fn new(size: [u32; 2], width: Option<Length>, height: Option<Length>, density: Option<f64>) -> Self {
        let given = || width.into_iter().chain(height);
        if given().next().is_none() {
            return Self { density, ..Self::in_pixels(size) };
        }
        let is_on_paper = density.is_some() || given().any(|length| length.unit != Unit::Pixel);
        let dots = Self::dots(size, width, height, density);
        let density = density.unwrap_or(USUAL_DENSITY);
        Self {
            // A size past all bounds stays one, and is refused as what it is.
            pixels: dots.map(|side| side.round().clamp(1.0, f64::from(u32::MAX)) as u32),
            paper: is_on_paper.then(|| dots.map(|side| side / density * POINTS)),
            density: is_on_paper.then_some(density),
        }
    }

    /// Width and height in pixels, before they are made whole ones, of what [`Self::new`] takes.
    #[must_use]
    pub fn dots(size: [u32; 2], width: Option<Length>, height: Option<Length>, density: Option<f64>) -> [f64; 2] {
        let density = density.unwrap_or(USUAL_DENSITY);
        let [wide, high] = size.map(f64::from);
        let [width, height] = [width, height].map(|length| length.map(|length| length.dots(density)));
        match (width, height) {
            (Some(width), Some(height)) => [width, height],
            (Some(width), None) => [width, width * high / wide],
            (None, Some(height)) => [height * wide / high, height],
            (None, None) => [wide, high],
        }
    }

    /// How much larger type and lines are than in a picture of that many pixels alone, where they grow with it: on paper a
    /// point of the frame is [`POINT`] points.
    #[must_use]
    pub fn type_scale(&self) -> f32 {
        match (self.paper, self.density) {
            (Some(_), Some(density)) => (POINT / POINTS * density) as f32 / point_size(self.pixels),
            _ => 1.0,
        }
    }

    /// Pixels a metre, as PNG counts them, where the file is marked.
    #[must_use]
    pub fn pixels_per_metre(&self) -> Option<u32> {
        self.density.map(|density| (density * 1000.0 / MILLIMETRES).round() as u32)
    }
}

#[cfg(test)]
mod tests {
    use super::{Length, PictureSize};
    use crate::render::point_size;

    const USUAL: [u32; 2] = [1280, 720];

    fn length(text: &str) -> Option<Length> {
        text.parse().ok()
    }

    #[test]
    fn lengths_are_read_with_their_units_and_written_back() {
        for text in ["86mm", "8.6cm", "3.4in", "244pt", "1032px", "0.001mm", "1e9mm", "1e-300in"] {
            assert_eq!(length(text).map(|length| length.to_string()).as_deref(), Some(text));
        }
        assert_eq!(length(" 86 mm "), length("86mm"));
        for text in ["", "86", "mm", "-86mm", "0mm", "infmm", "nanpx", "86m", "86 ells", "1e999mm"] {
            assert_eq!(length(text), None, "{text}");
        }
    }

    #[test]
    fn a_width_on_paper_gives_pixels() {
        let size = |width, height, density| PictureSize::new(USUAL, length(width), length(height), density);
        // 86 / 25.4 · 600 = 2031.496…, and 9/16 of it 1142.7.
        let column = size("86mm", "", Some(600.0));
        assert_eq!((column.pixels, column.pixels_per_metre()), ([2031, 1143], Some(23_622)));
        assert_eq!(size("8.6cm", "", Some(600.0)), column);
        assert_eq!(size("3.4in", "", None).pixels, [1020, 574]);
        assert_eq!(size("240pt", "2in", Some(72.0)).pixels, [240, 144]);
        assert_eq!(size("", "2in", Some(72.0)).pixels, [256, 144]);
        let paper = size("86mm", "", Some(72.0)).paper.unwrap_or_default();
        // To half an ulp an operation, three of them.
        assert!((paper[0] - 86.0 / 25.4 * 72.0).abs() < 1e-12 && (paper[1] / paper[0] - 0.5625).abs() < 1e-15);
        // Past all bounds, and below them.
        assert_eq!(size("1e300mm", "", None).pixels, [u32::MAX; 2]);
        assert_eq!(size("0.001mm", "", None).pixels, [1, 1]);
    }

    #[test]
    fn type_is_as_large_on_paper_at_any_width() {
        for (width, density) in [("86mm", 600.0), ("178mm", 600.0), ("2in", 150.0), ("1032px", 300.0)] {
            let size = PictureSize::new(USUAL, length(width), None, Some(density));
            // A caption of 20 points of the frame, in points of paper.
            let caption = 20.0 * point_size(size.pixels) * size.type_scale() / density as f32 * 72.0;
            assert!((caption - 8.0).abs() < 1e-5, "{width}: {caption}");
        }
    }

    #[test]
    fn with_no_paper_nothing_is_another_size() {
        let plain = PictureSize::new(USUAL, None, None, None);
        assert_eq!((plain.pixels, plain.type_scale(), plain.pixels_per_metre()), (USUAL, 1.0, None));
        // Dots alone mark the file.
        let marked = PictureSize::new(USUAL, None, None, Some(300.0));
        assert_eq!((marked.pixels, marked.type_scale(), marked.pixels_per_metre()), (USUAL, 1.0, Some(11_811)));
        // Pixels alone are no paper, a width in them has the aspect of the size.
        let pixels = PictureSize::new([4, 3], length("1000px"), None, None);
        assert_eq!((pixels.pixels, pixels.type_scale(), pixels.paper), ([1000, 750], 1.0, None));
    }
}
