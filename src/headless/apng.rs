//! Animated PNG: every colour, and opacity where it is wanted.

use std::io::Write;

use super::FrameRate;
use super::movie::{Movie, MovieError};
use crate::render::Pixels;
use crate::render::png::{colours, encoder};

/// An animated PNG under way.
pub struct Apng<W: Write> {
    writer: png::Writer<W>,
    transparent: bool,
}

impl<W: Write> Apng<W> {
    /// Begins a file of exactly `frames` frames that repeats for ever.
    ///
    /// # Errors
    /// No frames, a rate that the format cannot hold (both numbers of its ratio within 65 535), or a refused write.
    pub fn new(writer: W, size: [u32; 2], rate: FrameRate, frames: u64, transparent: bool) -> Result<Self, MovieError> {
        let too_many = || MovieError::Format(format!("an animated PNG cannot hold {frames} frames"));
        let too_fine =
            |_| MovieError::Format(format!("an animated PNG cannot hold {} frames in {} s", rate.frames, rate.seconds));
        let mut encoder = encoder(writer, size, transparent);
        encoder.set_animated(u32::try_from(frames).map_err(|_| too_many())?, 0)?;
        let (numerator, denominator) = (u16::try_from(rate.seconds.get()), u16::try_from(rate.frames.get()));
        encoder.set_frame_delay(numerator.map_err(too_fine)?, denominator.map_err(too_fine)?)?;
        Ok(Self { writer: encoder.write_header()?, transparent })
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
