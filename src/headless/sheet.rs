//! A sheet of moments: pictures of several times in rows, each under its time, as papers print them.

use super::figure::{FigureFormat, figure_of};
use super::paper::{Length, PictureSize};
use super::shot::{HeadlessError, ShotOptions, Studio};
use crate::frame::{Area, Color, Frame, Note, Pane};
use crate::objects::{Cameras, Palette};
use crate::render::png::{Remark, encode_marked};
use crate::render::{Gpu, Pixels, point_size};
use crate::scene::Scene;
use crate::sim::Simulation;
use crate::vector::FigureStyle;

/// Most pictures in a row where nobody says how many.
const MOST_IN_A_ROW: usize = 4;
/// Most pixels of a sheet: four bytes each are held at once.
const MOST_PIXELS: u64 = 1 << 27;
/// Height of a time, of the row that it stands in, and of the free space between pictures (points of the frame).
const TIME_SIZE: f32 = 20.0;
const TIME_ROW: f32 = 36.0;
const GAP: f32 = 8.0;

/// How a sheet is laid out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sheet {
    /// How large the sheet is.
    pub whole: PictureSize,
    /// How large the picture of each moment is.
    pub each: PictureSize,
    columns: u32,
    /// Height of the row of times above each row of pictures, and the space between pictures (pixels).
    time_row: u32,
    gap: u32,
    /// Pixels a point, type's own factor with it.
    point: f32,
}

impl Sheet {
    /// Lays out so many moments. A size in pixels is that of each picture; a width or a height, as [`PictureSize::new`] takes them,
    /// that of the sheet, and the size then gives the aspect of each. Type is larger by `font_scale`.
    ///
    /// # Errors
    /// No moment, no column, or more pixels than can be held: one sentence.
    pub fn new(
        count: usize,
        columns: Option<usize>,
        (size, width, height, density): ([u32; 2], Option<Length>, Option<Length>, Option<f64>),
        font_scale: f32,
    ) -> Result<Self, String> {
        let columns = columns.unwrap_or_else(|| count.div_ceil(count.div_ceil(MOST_IN_A_ROW).max(1)));
        if count == 0 || columns == 0 {
            return Err("a sheet has at least one moment in at least one column".to_owned());
        }
        let columns = columns.min(count);
        let rows = count.div_ceil(columns);
        let said = PictureSize::new(size, width, height, density);
        let (across, down) = (columns as f64, rows as f64);
        let is_each = width.is_none() && height.is_none();
        let share = if is_each {
            said.pixels
        } else {
            // Of a sheet as wide or as high: what the gaps and times then take of it makes no difference to type.
            let [wide, high] = said.pixels.map(f64::from);
            [(wide / across).max(1.0) as u32, (high / down).max(1.0) as u32]
        };
        let one = PictureSize { pixels: share, ..said };
        let point = point_size(share) * one.type_scale() * font_scale;
        let whole_points = |points: f32| (points * point).round().max(1.0) as u32;
        let (time_row, gap) = (whole_points(TIME_ROW), whole_points(GAP));
        let gaps = |count: f64| (count - 1.0) * f64::from(gap);
        let aspect = f64::from(size[0]) / f64::from(size[1]);
        let each = if is_each {
            said.pixels.map(f64::from)
        } else {
            let [wide, high] = said.pixels.map(f64::from);
            let wide = (wide - gaps(across)) / across;
            let high = (high - gaps(down)) / down - f64::from(time_row);
            match (width, height) {
                (Some(_), None) => [wide, wide / aspect],
                (None, _) => [high * aspect, high],
                _ => [wide, high],
            }
        };
        let each = each.map(|side| side.floor().max(1.0));
        let [wide, high] = each;
        let needed = [across * wide + gaps(across), down * (high + f64::from(time_row)) + gaps(down)];
        // As wide and as high as is said, whatever whole pixels leave over.
        let whole = [
            if width.is_some() { f64::from(said.pixels[0]).max(needed[0]) } else { needed[0] },
            if height.is_some() { f64::from(said.pixels[1]).max(needed[1]) } else { needed[1] },
        ];
        if whole[0] * whole[1] > MOST_PIXELS as f64 {
            return Err(format!(
                "a sheet of {count} pictures of {wide}x{high} pixels is {}x{} pixels large: at most {MOST_PIXELS} are drawn",
                whole[0], whole[1]
            ));
        }
        let on_paper = |pixels: [f64; 2]| {
            let density = said.density.filter(|_| said.paper.is_some())?;
            Some(pixels.map(|side| side / density * 72.0))
        };
        let sized = |pixels: [f64; 2]| PictureSize {
            pixels: pixels.map(|side| side as u32),
            paper: on_paper(pixels),
            density: said.density,
        };
        let each = sized(each);
        // The type of each picture is that of its own size, and the times' with it.
        let point = point_size(each.pixels) * each.type_scale() * font_scale;
        // As long as is said: a pixel more or less is not seen.
        let exact = |side: usize, length: Option<Length>| Some(said.paper?[side]).filter(|_| length.is_some());
        let mut whole = sized(whole);
        if let Some(paper) = &mut whole.paper {
            *paper = [exact(0, width).unwrap_or(paper[0]), exact(1, height).unwrap_or(paper[1])];
        }
        Ok(Self { whole, each, columns: columns as u32, time_row, gap, point })
    }

    /// The upper left corner (pixels) of the picture of a moment.
    fn corner(&self, number: usize) -> [u32; 2] {
        let (column, row) = (number as u32 % self.columns, number as u32 / self.columns);
        let [wide, high] = self.each.pixels;
        [column * (wide + self.gap), row * (self.time_row + high + self.gap) + self.time_row]
    }

    /// How each picture of it is drawn.
    #[must_use]
    pub fn options(&self, whole: &ShotOptions) -> ShotOptions {
        ShotOptions { size: self.each, ..whole.clone() }
    }

    /// The whole sheet as one frame.
    #[must_use]
    pub fn frame(&self, scene: &Scene, times: &[f64], options: &ShotOptions) -> Frame {
        let cameras = Cameras::new(&scene.view);
        let options = self.options(options);
        let mut sheet = self.times_frame(scene, 0.0, options.transparent, self.whole.pixels);
        sheet.panes.clear();
        for (number, time) in times.iter().enumerate() {
            let [left, top] = self.corner(number);
            let frame = options.frame(scene, &simulated(scene, *time), &cameras);
            sheet.panes.extend(self.placed(frame, [left, top], self.each.pixels));
            let size = [self.each.pixels[0], self.time_row];
            let frame = self.times_frame(scene, *time, options.transparent, size);
            sheet.panes.extend(self.placed(frame, [left, top - self.time_row], size));
        }
        sheet
    }

    /// The panes of a frame of this size (pixels) at a corner of the sheet.
    fn placed(&self, frame: Frame, corner: [u32; 2], size: [u32; 2]) -> impl Iterator<Item = Pane> {
        let part =
            |pixels: [u32; 2]| glam::UVec2::from(pixels).as_vec2() / glam::UVec2::from(self.whole.pixels).as_vec2();
        let (corner, extent) = (part(corner), part(size));
        frame.panes.into_iter().map(move |pane| {
            let area = Area { corner: corner + pane.area.corner * extent, extent: pane.area.extent * extent };
            Pane { area, ..pane }
        })
    }

    /// A time by itself in a frame of this size (pixels).
    fn times_frame(&self, scene: &Scene, time: f64, transparent: bool, size: [u32; 2]) -> Frame {
        let palette = Palette::new(scene.view.theme);
        let unit = scene.view.time_unit.sign();
        let text = format!("t = {time}\u{a0}{unit}").replace('-', "\u{2212}");
        let mut pane = Pane::new(Area::WHOLE, *Cameras::new(&scene.view).of(crate::objects::Space::World), 0.0);
        pane.notes.push(Note { text, size: TIME_SIZE, color: palette.ink, swatch: None });
        Frame {
            background: palette.background,
            transparent,
            font_scale: self.point / point_size(size),
            panes: vec![pane],
        }
    }

    /// Draws the moments: the bytes of a PNG file, in which each picture is, to the pixel, the one that is drawn by itself.
    ///
    /// # Errors
    /// See [`HeadlessError`].
    pub fn draw(
        &self,
        gpu: &Gpu,
        scene: &Scene,
        times: &[f64],
        options: &ShotOptions,
        remarks: &[Remark],
    ) -> Result<Vec<u8>, HeadlessError> {
        let options = self.options(options);
        let cameras = Cameras::new(&scene.view);
        let row = [self.each.pixels[0], self.time_row];
        let (mut pictures, mut captions) = (Studio::new(gpu, self.each.pixels)?, Studio::new(gpu, row)?);
        let ground = if options.transparent { [0; 4] } else { bytes_of(Palette::new(scene.view.theme).background) };
        let count = self.whole.pixels.map(|side| side as usize).iter().product();
        let mut sheet = Pixels { size: self.whole.pixels, rgba: [ground].repeat(count).concat() };
        for (number, time) in times.iter().enumerate() {
            let [left, top] = self.corner(number);
            let picture = pictures.draw(&options.frame(scene, &simulated(scene, *time), &cameras))?;
            put(&mut sheet, &picture, [left, top]);
            let caption = captions.draw(&self.times_frame(scene, *time, options.transparent, row))?;
            put(&mut sheet, &caption, [left, top - self.time_row]);
        }
        Ok(encode_marked(&sheet, options.transparent, remarks, self.whole.pixels_per_metre())?)
    }

    /// Draws the moments as one figure: the bytes of a file. A device is asked for only where surfaces are pixels.
    ///
    /// # Errors
    /// See [`HeadlessError`]; what `open` returns.
    pub fn figure<E: From<HeadlessError>>(
        &self,
        open: impl FnOnce() -> Result<Gpu, E>,
        scene: &Scene,
        times: &[f64],
        options: &ShotOptions,
        (style, format): (FigureStyle, FigureFormat),
        remarks: &[Remark],
    ) -> Result<Vec<u8>, E> {
        figure_of(open, &self.frame(scene, times, options), self.whole, (style, format), remarks)
    }
}

/// A scene's motion at a time (s), from its start: what was at other times leaves no trace.
fn simulated(scene: &Scene, time: f64) -> Simulation {
    let mut simulation = Simulation::new(scene);
    if time != 0.0 {
        simulation.go_to(time);
    }
    simulation
}

/// A colour as the picture holds it.
fn bytes_of(color: Color) -> [u8; 4] {
    color.alpha(1.0).0.map(|channel| (channel * 255.0).round() as u8)
}

/// Copies a picture into a larger one, which holds it whole.
fn put(sheet: &mut Pixels, picture: &Pixels, [left, top]: [u32; 2]) {
    let [wide, whole] = [picture.size[0], sheet.size[0]].map(|width| 4 * width as usize);
    let at = 4 * left as usize + top as usize * whole;
    let rows = sheet.rgba.get_mut(at..).unwrap_or_default().chunks_mut(whole);
    for (to, from) in rows.zip(picture.rgba.chunks_exact(wide)) {
        to[..wide].copy_from_slice(from);
    }
}

#[cfg(test)]
mod tests {
    use super::{Sheet, put};
    use crate::headless::ShotOptions;
    use crate::render::{Pixels, point_size};
    use crate::scene::{Scene, SceneError, SceneFile};

    const USUAL: [u32; 2] = [1280, 720];

    fn sheet(count: usize, columns: Option<usize>, width: &str, height: &str) -> Result<Sheet, String> {
        Sheet::new(count, columns, (USUAL, width.parse().ok(), height.parse().ok(), None), 1.0)
    }

    #[test]
    fn moments_stand_in_rows_of_about_the_same_length() -> Result<(), String> {
        for (count, columns) in [(1, 1), (2, 2), (4, 4), (5, 3), (6, 3), (7, 4), (8, 4), (9, 3), (12, 4)] {
            assert_eq!(sheet(count, None, "", "")?.columns, columns, "{count}");
        }
        assert_eq!(sheet(3, Some(1), "", "")?.columns, 1);
        assert_eq!(sheet(3, Some(9), "", "")?.columns, 3);
        assert!(sheet(0, None, "", "").is_err() && sheet(3, Some(0), "", "").is_err());
        assert!(sheet(400, None, "", "").is_err_and(|why| why.contains("400 pictures of 1280x720 pixels")));
        Ok(())
    }

    #[test]
    fn a_size_is_that_of_each_picture_and_a_width_that_of_the_sheet() -> Result<(), String> {
        // A time's row is 36 pixels high there, a gap 8 wide.
        let row = sheet(4, None, "", "")?;
        assert_eq!((row.each.pixels, row.whole.pixels), (USUAL, [4 * 1280 + 3 * 8, 720 + 36]));
        assert_eq!([row.corner(0), row.corner(3)], [[0, 36], [3 * 1288, 36]]);
        let grid = sheet(6, None, "", "")?;
        assert_eq!((grid.corner(5), grid.whole.pixels), ([2 * 1288, 720 + 36 + 8 + 36], [3 * 1280 + 16, 2 * 756 + 8]));
        // 178 / 25.4 · 300 = 2102.4; type on paper is 8 pt of 300/72 pixels each: a point of the frame 5/3 pixels, a gap 13.
        let paper = sheet(3, None, "178mm", "")?;
        assert_eq!((paper.whole.pixels, paper.each.pixels), ([2102, 389 + 60], [692, 389]));
        assert!((point_size(paper.each.pixels) * paper.each.type_scale() - 5.0 / 3.0).abs() < 1e-5);
        let both = sheet(2, Some(1), "60mm", "80mm")?;
        assert_eq!(both.whole.pixels, [709, 945]);
        assert_eq!(both.each.pixels, [709, (945 - 13) / 2 - 60]);
        Ok(())
    }

    #[test]
    fn as_one_frame_it_has_the_panes_of_every_moment_in_their_places() -> Result<(), SceneError> {
        let scene = Scene::check(&SceneFile::default())?;
        let sheet = sheet(2, None, "", "").unwrap_or_else(|why| unreachable!("{why}"));
        let options = ShotOptions::default();
        let frame = sheet.frame(&scene, &[0.0, -1.5], &options);
        // Two spaces and a time each.
        assert_eq!(frame.panes.len(), 6);
        let words: Vec<_> = frame.panes.iter().flat_map(|pane| &pane.notes).map(|note| &*note.text).collect();
        assert!(words.contains(&"t = 0\u{a0}s") && words.contains(&"t = \u{2212}1.5\u{a0}s"), "{words:?}");
        let whole = glam::UVec2::from(sheet.whole.pixels).as_vec2();
        let corner = (frame.panes[3].area.corner * whole, frame.panes[3].area.extent * whole);
        // To a thousandth of a pixel: ten roundings of 2⁻²⁴ of some thousands.
        assert!(corner.0.distance(glam::Vec2::new(1288.0, 36.0)) < 1e-3, "{corner:?}");
        assert!(corner.1.distance(glam::Vec2::new(640.0, 720.0)) < 1e-3, "{corner:?}");
        // Type as large as in a picture by itself.
        let alone = point_size(USUAL) * scene.view.font_scale as f32;
        assert!((frame.font_scale * point_size(sheet.whole.pixels) - alone).abs() < 1e-5);
        Ok(())
    }

    #[test]
    fn a_picture_is_copied_to_its_place() {
        let mut sheet = Pixels { size: [3, 3], rgba: vec![0; 36] };
        put(&mut sheet, &Pixels { size: [2, 1], rgba: (1..=8).collect() }, [1, 2]);
        assert_eq!(sheet.rgba[28..], [1, 2, 3, 4, 5, 6, 7, 8]);
        assert!(sheet.rgba[..28].iter().all(|byte| *byte == 0));
    }
}
