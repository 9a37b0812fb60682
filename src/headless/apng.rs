//! Animated PNG: every colour, and opacity where it is wanted.

use std::io::Write;

use super::FrameRate;
use super::movie::{Movie, MovieError};
use crate::render::Pixels;
use crate::render::png::{Remark, colours, encoder, say};

/// An animated PNG under way.
pub struct Apng<W: Write> {
    writer: png::Writer<W>,
    transparent: bool,
}

impl<W: Write> Apng<W> {
    /// Refuses what the format cannot hold, before there is anything to write.
    ///
    /// # Errors
    /// Too many frames, or a rate whose ratio has a number past 65 535.
    pub fn check(rate: FrameRate, frames: u64) -> Result<(), MovieError> {
        header(rate, frames).map(|_| ())
    }

    /// Begins a file of exactly `frames` frames that repeats for ever and says this of itself.
    ///
    /// # Errors
    /// No frames, a rate that the format cannot hold (both numbers of its ratio within 65 535), or a refused write.
    pub fn new(
        writer: W,
        size: [u32; 2],
        rate: FrameRate,
        frames: u64,
        transparent: bool,
        remarks: &[Remark],
    ) -> Result<Self, MovieError> {
        let (frames, [numerator, denominator]) = header(rate, frames)?;
        let mut encoder = encoder(writer, size, transparent);
        say(&mut encoder, remarks)?;
        encoder.set_animated(frames, 0)?;
        encoder.set_frame_delay(numerator, denominator)?;
        Ok(Self { writer: encoder.write_header()?, transparent })
    }
}

/// The number of frames and the two numbers of the time each is shown, as the format holds them.
fn header(rate: FrameRate, frames: u64) -> Result<(u32, [u16; 2]), MovieError> {
    let FrameRate { frames: many, seconds } = rate;
    let count = u32::try_from(frames)
        .map_err(|_| MovieError::Format(format!("an animated PNG cannot hold {frames} frames")))?;
    match (u16::try_from(seconds.get()), u16::try_from(many.get())) {
        (Ok(numerator), Ok(denominator)) => Ok((count, [numerator, denominator])),
        _ => Err(MovieError::Format(format!(
            "an animated PNG cannot hold {many} frames in {seconds} s: both numbers are at most 65535"
        ))),
    }
}

impl<W: Write + Send> Movie for Apng<W> {
    fn frame(&mut self, pixels: &Pixels) -> Result<(), MovieError> {
        Ok(self.writer.write_image_data(&colours(pixels, self.transparent))?)
    }

    fn finish(self: Box<Self>) -> Result<(), MovieError> {
        Ok(self.writer.finish()?)
    }
}
