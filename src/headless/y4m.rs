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

/// One in the fixed-point weights below.
const ONE: i32 = 1 << 16;

/// Luma of every pixel, then both chromas of every block of two by two: ITU-R BT.709, luma 16 to 235, chroma 16 to 240.
fn to_planes(pixels: &Pixels, planes: &mut Vec<u8>) {
    let [width, height] = pixels.size.map(|side| side as usize);
    planes.clear();
    // 65536 · 219/255 · (0.2126, 0.7152, 0.0722)
    planes.extend(pixels.rgba.chunks_exact(4).map(|pixel| {
        let [r, g, b] = [pixel[0], pixel[1], pixel[2]].map(i32::from);
        (16 + ((11_966 * r + 40_254 * g + 4_064 * b + ONE / 2) >> 16)) as u8
    }));
    let (across, down) = (width.div_ceil(2), height.div_ceil(2));
    let blue_at = planes.len();
    planes.resize(blue_at + 2 * across * down, 0);
    for y in 0..down {
        for x in 0..across {
            let mut sum = [0_i32; 3];
            for (column, row) in [(2 * x, 2 * y), (2 * x + 1, 2 * y), (2 * x, 2 * y + 1), (2 * x + 1, 2 * y + 1)] {
                // The last pixel stands for the missing one beside an odd edge.
                let at = 4 * (row.min(height - 1) * width + column.min(width - 1));
                for (sum, byte) in sum.iter_mut().zip(&pixels.rgba[at..at + 3]) {
                    *sum += i32::from(*byte);
                }
            }
            let [r, g, b] = sum;
            // 65536/4 · 224/255 · ((b − luma)/1.8556, (r − luma)/1.5748)
            let blue = 128 + ((-1_649 * r - 5_547 * g + 7_196 * b + ONE / 2) >> 16);
            let red = 128 + ((7_196 * r - 6_536 * g - 660 * b + ONE / 2) >> 16);
            planes[blue_at + y * across + x] = blue as u8;
            planes[blue_at + across * down + y * across + x] = red as u8;
        }
    }
}
