//! GIF: one palette for the whole film, ordered dither, only what changed written again.

use std::borrow::Cow;
use std::io::Write;

use color_quant::NeuQuant;

use super::FrameRate;
use super::movie::{Movie, MovieError};
use crate::render::Pixels;

/// Colours of the palette; one more index means "as before".
const COLOURS: usize = 255;
/// The index that leaves a pixel as it was.
const UNCHANGED: u8 = 255;
/// The largest shift that dithering gives a channel: about half the distance of neighbouring palette colours.
const DITHER: i32 = 5;

/// A GIF under way.
pub struct Gif<W: Write> {
    encoder: gif::Encoder<W>,
    palette: Palette,
    rate: FrameRate,
    size: [u16; 2],
    frames: u64,
    before: Vec<u8>,
}

impl<W: Write> Gif<W> {
    /// Refuses what the format cannot hold, before there is anything to write.
    ///
    /// # Errors
    /// A side past 65 535 pixels, or a rate at which a frame is shown for less than a hundredth of a second or for more
    /// than 655.35 s.
    pub fn check(size: [u32; 2], rate: FrameRate) -> Result<(), MovieError> {
        sides(size, rate).map(|_| ())
    }

    /// Begins a film whose palette serves the sample pictures.
    ///
    /// # Errors
    /// What [`Self::check`] refuses, or a refused write.
    pub fn new(writer: W, size: [u32; 2], rate: FrameRate, samples: &[Pixels]) -> Result<Self, MovieError> {
        let size = sides(size, rate)?;
        let palette = Palette::of(samples);
        let mut encoder = gif::Encoder::new(writer, size[0], size[1], &palette.bytes)?;
        encoder.set_repeat(gif::Repeat::Infinite)?;
        Ok(Self { encoder, palette, rate, size, frames: 0, before: vec![] })
    }

    /// How long (hundredths of a second) a frame is shown. Rounded from the exact times of its two ends, so that
    /// the film as a whole keeps time at any rate.
    fn delay(&self) -> u16 {
        let hundredths = |index| (100.0 * self.rate.time(index)).round();
        (hundredths(self.frames + 1) - hundredths(self.frames)).clamp(0.0, 65_535.0) as u16
    }
}

/// The sides as the format holds them, where it holds them and the rate.
fn sides(size: [u32; 2], rate: FrameRate) -> Result<[u16; 2], MovieError> {
    if !(100.0 / 65_535.0..=100.0).contains(&rate.per_second()) {
        return Err(MovieError::Format(format!(
            "a GIF cannot show {} frames in {} s: it counts in hundredths of a second, so at most 100 a second and at least one in 655 s",
            rate.frames, rate.seconds
        )));
    }
    match size.map(u16::try_from) {
        [Ok(width), Ok(height)] => Ok([width, height]),
        _ => Err(MovieError::Format(format!("a GIF cannot be {} x {} pixels large: at most 65535", size[0], size[1]))),
    }
}

impl<W: Write + Send> Movie for Gif<W> {
    fn frame(&mut self, pixels: &Pixels) -> Result<(), MovieError> {
        let width = usize::from(self.size[0]);
        let indices = self.palette.indices(pixels);
        let mut frame = gif::Frame { delay: self.delay(), ..gif::Frame::default() };
        if self.before.is_empty() {
            (frame.width, frame.height) = (self.size[0], self.size[1]);
            frame.buffer = Cow::Borrowed(&indices);
            self.encoder.write_frame(&frame)?;
        } else {
            let (left, top, across, down) = changed(&self.before, &indices, width);
            let mut buffer = Vec::with_capacity(across * down);
            for y in top..top + down {
                let row = y * width + left..y * width + left + across;
                buffer.extend(
                    indices[row.clone()]
                        .iter()
                        .zip(&self.before[row])
                        .map(|(now, before)| if now == before { UNCHANGED } else { *now }),
                );
            }
            (frame.left, frame.top) = (left as u16, top as u16);
            (frame.width, frame.height) = (across as u16, down as u16);
            frame.transparent = Some(UNCHANGED);
            frame.dispose = gif::DisposalMethod::Keep;
            frame.buffer = Cow::Owned(buffer);
            self.encoder.write_frame(&frame)?;
        }
        self.before = indices;
        self.frames += 1;
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<(), MovieError> {
        self.encoder.into_inner()?.flush()?;
        Ok(())
    }
}

/// The smallest rectangle (left, top, width, height) in which two pictures differ; one pixel where they do not.
fn changed(before: &[u8], now: &[u8], width: usize) -> (usize, usize, usize, usize) {
    let rows: Vec<bool> = before.chunks_exact(width).zip(now.chunks_exact(width)).map(|(a, b)| a != b).collect();
    let (Some(top), Some(bottom)) =
        (rows.iter().position(|differs| *differs), rows.iter().rposition(|differs| *differs))
    else {
        return (0, 0, 1, 1);
    };
    let (mut left, mut right) = (width, 0);
    for y in top..=bottom {
        let row = y * width..(y + 1) * width;
        let (a, b) = (&before[row.clone()], &now[row]);
        if let Some(first) = (0..left).find(|&x| a[x] != b[x]) {
            left = first;
        }
        if let Some(last) = (right..width).rev().find(|&x| a[x] != b[x]) {
            right = last;
        }
    }
    (left, top, right - left + 1, bottom - top + 1)
}

/// A palette, and for each cell of colours (6 bits a channel) the nearest entry.
struct Palette {
    bytes: Vec<u8>,
    nearest: Vec<u8>,
    /// The most frequent colour, the background: kept exact and free of dither.
    background: [u8; 3],
}

impl Palette {
    fn of(samples: &[Pixels]) -> Self {
        let background = most_frequent(samples);
        // Without the background, which has its own entry, the rest gets the whole of the network.
        let rest: Vec<u8> = samples
            .iter()
            .flat_map(|pixels| pixels.rgba.chunks_exact(4))
            .filter(|pixel| pixel[..3] != background)
            .flatten()
            .copied()
            .collect();
        let mut bytes = background.to_vec();
        if rest.is_empty() {
            bytes.resize(3 * COLOURS, 0);
        } else {
            bytes.extend(NeuQuant::new(10, COLOURS - 1, &rest).color_map_rgb());
            bytes.resize(3 * COLOURS, 0);
        }
        let nearest = (0..1_i32 << 18)
            .map(|cell| {
                let middle = [cell >> 12, (cell >> 6) & 63, cell & 63].map(|six| 4 * six + 2);
                nearest(&bytes, middle)
            })
            .collect();
        // The 256th entry is there for the index that means "as before".
        bytes.extend([0; 3]);
        Self { bytes, nearest, background }
    }

    /// The palette's index of every pixel. The dither is a fixed pattern, so that what stands still does not flicker.
    fn indices(&self, pixels: &Pixels) -> Vec<u8> {
        let width = pixels.size[0] as usize;
        let mut indices = Vec::with_capacity(pixels.rgba.len() / 4);
        for (y, row) in pixels.rgba.chunks_exact(4 * width).enumerate() {
            let pattern = &BAYER[y % 4];
            for (x, pixel) in row.chunks_exact(4).enumerate() {
                if pixel[..3] == self.background {
                    indices.push(0);
                    continue;
                }
                let shift = (pattern[x % 4] * 2 - 15) * DITHER / 15;
                let [r, g, b] =
                    [pixel[0], pixel[1], pixel[2]].map(|byte| ((i32::from(byte) + shift).clamp(0, 255) >> 2) as usize);
                indices.push(self.nearest[r << 12 | g << 6 | b]);
            }
        }
        indices
    }
}

/// Bayer's matrix: the order in which a growing share of the pixels takes the next colour.
const BAYER: [[i32; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

fn nearest(palette: &[u8], colour: [i32; 3]) -> u8 {
    let distance = |entry: &[u8]| {
        let [r, g, b] = [0, 1, 2].map(|channel| i32::from(entry[channel]) - colour[channel]);
        // Weights near the eye's own for the three channels.
        3 * r * r + 6 * g * g + b * b
    };
    palette.chunks_exact(3).enumerate().min_by_key(|(_, entry)| distance(entry)).map_or(0, |(index, _)| index as u8)
}

fn most_frequent(samples: &[Pixels]) -> [u8; 3] {
    let mut counts = std::collections::HashMap::<[u8; 3], u32>::new();
    for pixel in samples.iter().flat_map(|pixels| pixels.rgba.chunks_exact(4)) {
        *counts.entry([pixel[0], pixel[1], pixel[2]]).or_default() += 1;
    }
    counts.into_iter().max_by_key(|(colour, count)| (*count, *colour)).map_or([0; 3], |(colour, _)| colour)
}
