//! YUV4MPEG2: raw video for pipes, 4:2:0, BT.709 colours in limited range.

use std::io::Write;

use super::FrameRate;
use super::movie::{Movie, MovieError};
use crate::render::Pixels;

/// A YUV4MPEG2 stream under way.
pub struct Y4m<W: Write> {
    writer: W,
    planes: Vec<u8>,
}

impl<W: Write> Y4m<W> {
    /// Begins a stream.
    ///
    /// # Errors
    /// A refused write.
    pub fn new(mut writer: W, [width, height]: [u32; 2], rate: FrameRate) -> Result<Self, MovieError> {
        writeln!(
            writer,
            "YUV4MPEG2 W{width} H{height} F{}:{} Ip A1:1 C420jpeg XCOLORRANGE=LIMITED",
            rate.frames, rate.seconds
        )?;
        Ok(Self { writer, planes: vec![] })
    }
}

impl<W: Write + Send> Movie for Y4m<W> {
    fn frame(&mut self, pixels: &Pixels) -> Result<(), MovieError> {
        to_planes(pixels, &mut self.planes);
        self.writer.write_all(b"FRAME\n")?;
        Ok(self.writer.write_all(&self.planes)?)
    }

    fn finish(mut self: Box<Self>) -> Result<(), MovieError> {
        Ok(self.writer.flush()?)
    }
}

// The weights below are in parts of 2¹⁶. All sums of them times bytes are whole numbers below 2²⁴, which f32 holds exactly: that is faster
// than whole numbers where no instruction multiplies those side by side.

/// The whole part, modulo 256, of a number in parts of 2¹⁶ that is not halfway between two: above 2³⁹ numbers are that far apart.
fn nearest(parts: f32) -> u8 {
    const APART: f32 = 1.5 * (1_u64 << 39) as f32;
    (parts + APART).to_bits() as u8
}

/// Luma of every pixel, then both chromas of every block of two by two: ITU-R BT.709, luma 16 to 235, chroma 16 to 240.
fn to_planes(pixels: &Pixels, planes: &mut Vec<u8>) {
    let [width, height] = pixels.size.map(|side| side as usize);
    let (rgba, _) = pixels.rgba.as_chunks::<4>();
    let (across, down) = (width.div_ceil(2), height.div_ceil(2));
    planes.resize(rgba.len() + 2 * across * down, 0);
    let (lumas, chromas) = planes.split_at_mut(rgba.len());
    // Loops over slices, pixel by pixel: the compiler then takes several at once.
    for (luma, pixel) in lumas.iter_mut().zip(rgba) {
        let [r, g, b] = Channels::of(*pixel).sums();
        // 65536 · 219/255 · (0.2126, 0.7152, 0.0722). The weights are even: one more decides what would be halfway, upwards.
        *luma = nearest(11_966.0 * r + 40_254.0 * g + 4_064.0 * b + 1.0).wrapping_add(16);
    }
    let (blues, reds) = chromas.split_at_mut(across * down);
    let rows = blues.chunks_exact_mut(across.max(1)).zip(reds.chunks_exact_mut(across.max(1)));
    for ((blues, reds), pair) in rows.zip(rgba.chunks(2 * width.max(1))) {
        // The last pixel stands for the missing one beside an odd edge.
        let (above, below) = pair.split_at(width);
        let below = if below.is_empty() { above } else { below };
        let blocks = above.as_chunks::<2>().0.iter().zip(below.as_chunks::<2>().0);
        for ((blue, red), ([a, b], [c, d])) in blues.iter_mut().zip(reds.iter_mut()).zip(blocks) {
            [*blue, *red] = chroma(Channels::of(*a) + Channels::of(*b) + Channels::of(*c) + Channels::of(*d));
        }
        if width % 2 == 1 {
            let edge = Channels::of(above[width - 1]) + Channels::of(below[width - 1]);
            [blues[across - 1], reds[across - 1]] = chroma(edge + edge);
        }
    }
}

/// Blue and red of a block, of which this is the sum of its four pixels.
fn chroma(sum: Channels) -> [u8; 2] {
    let [r, g, b] = sum.sums();
    // 65536/4 · 224/255 · ((b − luma)/1.8556, (r − luma)/1.5748)
    let blue = -1_649.0 * r - 5_547.0 * g + 7_196.0 * b;
    let red = 7_196.0 * r - 6_536.0 * g - 660.0 * b;
    // Below 2²³ there is room for a half that decides.
    [blue, red].map(|parts| nearest(parts + 0.5).wrapping_add(128))
}

/// Red and blue, and green, of some pixels, each added up in half a word.
#[derive(Clone, Copy)]
struct Channels {
    red_and_blue: u32,
    green: u32,
}

impl Channels {
    fn of(pixel: [u8; 4]) -> Self {
        let word = u32::from_le_bytes(pixel);
        Self { red_and_blue: word & 0x00ff_00ff, green: word >> 8 & 0xff }
    }

    /// Red, green, blue.
    fn sums(self) -> [f32; 3] {
        [self.red_and_blue & 0xffff, self.green, self.red_and_blue >> 16].map(|sum| sum.cast_signed() as f32)
    }
}

impl std::ops::Add for Channels {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { red_and_blue: self.red_and_blue + other.red_and_blue, green: self.green + other.green }
    }
}

#[cfg(test)]
mod tests {
    use super::to_planes;
    use crate::render::Pixels;

    /// The same in whole numbers and rounded real ones, pixel by pixel.
    fn expected(pixels: &Pixels) -> Vec<u8> {
        let [width, height] = pixels.size.map(|side| side as usize);
        let at = |x: usize, y: usize| {
            let start = 4 * (y.min(height - 1) * width + x.min(width - 1));
            [0, 1, 2].map(|channel| i32::from(pixels.rgba[start + channel]))
        };
        let places = |across, down| (0..down).flat_map(move |y| (0..across).map(move |x| (x, y)));
        let luma = places(width, height).map(|(x, y)| {
            let [r, g, b] = at(x, y);
            (16 + ((11_966 * r + 40_254 * g + 4_064 * b + (1 << 15)) >> 16)) as u8
        });
        let chroma = |weights: [i32; 3]| {
            places(width.div_ceil(2), height.div_ceil(2)).map(move |(x, y)| {
                let block = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(right, below)| at(2 * x + right, 2 * y + below));
                let sum: i32 =
                    block.iter().flat_map(|rgb| rgb.iter().zip(weights)).map(|(byte, weight)| byte * weight).sum();
                (128 + ((sum + (1 << 15)) >> 16)) as u8
            })
        };
        luma.chain(chroma([-1_649, -5_547, 7_196])).chain(chroma([7_196, -6_536, -660])).collect()
    }

    #[test]
    fn the_planes_are_those_of_whole_numbers_to_the_bit() {
        let mut seed = 1_u32;
        let mut byte = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            // The ends of the range as often as not.
            [0, 255, (seed >> 24) as u8, (seed >> 16) as u8][(seed >> 8) as usize % 4]
        };
        for size in [[1, 1], [2, 2], [3, 1], [1, 4], [5, 3], [64, 48], [63, 47]] {
            let rgba = (0..4 * size[0] * size[1]).map(|_| byte()).collect();
            let pixels = Pixels { size, rgba };
            let mut planes = vec![7; 3];
            to_planes(&pixels, &mut planes);
            assert_eq!(planes, expected(&pixels), "{size:?}");
        }
    }

    #[test]
    fn white_black_and_the_primaries_are_those_of_the_standard() {
        // ITU-R BT.709 in limited range: luma, blue and red chroma.
        let known = [
            ([255, 255, 255], [235, 128, 128]),
            ([0, 0, 0], [16, 128, 128]),
            ([255, 0, 0], [63, 102, 240]),
            ([0, 255, 0], [173, 42, 26]),
            ([0, 0, 255], [32, 240, 118]),
        ];
        for ([r, g, b], planes) in known {
            let pixels = Pixels { size: [1, 1], rgba: vec![r, g, b, 255] };
            let mut found = vec![];
            to_planes(&pixels, &mut found);
            assert_eq!(found, planes);
        }
    }
}
