//! Raw pixels with straight opacity, for pipes into an encoder that keeps it.

use std::io::Write;

use super::movie::{Movie, MovieError};
use crate::render::Pixels;
use crate::render::png::colours;

/// A raw stream under way: four bytes a pixel, frame after frame.
pub struct Rgba<W: Write> {
    writer: W,
    /// Whether the encoder mixes the colours of neighbours.
    is_mixed: bool,
}

impl<W: Write> Rgba<W> {
    /// Begins a stream. Where its encoder mixes the colours of neighbours, what is wholly transparent takes its colour from beside
    /// it: its own, black, would darken the rims of things.
    pub fn new(writer: W, is_mixed: bool) -> Self {
        Self { writer, is_mixed }
    }
}

impl<W: Write + Send> Movie for Rgba<W> {
    fn frame(&mut self, pixels: &Pixels) -> Result<(), MovieError> {
        let mut straight = colours(pixels, true);
        if self.is_mixed {
            bleed(&mut straight, pixels.size);
        }
        Ok(self.writer.write_all(&straight)?)
    }

    fn finish(mut self: Box<Self>) -> Result<(), MovieError> {
        Ok(self.writer.flush()?)
    }
}

/// Gives every pixel that is wholly transparent the mean colour of its eight neighbours, each as far as it is opaque.
fn bleed(straight: &mut [u8], [width, height]: [u32; 2]) {
    let [width, height] = [width as usize, height as usize];
    let before = straight.to_vec();
    let alpha = |column: usize, row: usize| before[4 * (row * width + column) + 3];
    // Of each column, whether anything is seen of it in three rows: most of a picture is empty.
    let mut is_seen = vec![false; width];
    for row in 0..height {
        let rows = row.saturating_sub(1)..(row + 2).min(height);
        for (column, is_seen) in is_seen.iter_mut().enumerate() {
            *is_seen = rows.clone().any(|row| alpha(column, row) != 0);
        }
        for column in 0..width {
            let columns = column.saturating_sub(1)..(column + 2).min(width);
            if alpha(column, row) != 0 || !is_seen[columns.clone()].contains(&true) {
                continue;
            }
            let mut sums = [0_u32; 4];
            for (row, column) in rows.clone().flat_map(|row| columns.clone().map(move |column| (row, column))) {
                let at = 4 * (row * width + column);
                let weight = u32::from(before[at + 3]);
                for (sum, byte) in sums.iter_mut().zip(&before[at..at + 3]) {
                    *sum += weight * u32::from(*byte);
                }
                sums[3] += weight;
            }
            let at = 4 * (row * width + column);
            for (byte, sum) in straight[at..at + 3].iter_mut().zip(sums) {
                *byte = (sum + sums[3] / 2).checked_div(sums[3]).unwrap_or(0) as u8;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Movie, MovieError, Rgba};
    use crate::render::Pixels;

    #[test]
    fn what_is_transparent_takes_its_colour_from_beside_it() -> Result<(), MovieError> {
        // Half opaque 200, 100, 0 (premultiplied), opaque 0, 0, 40, and nothing.
        let row = [[100, 50, 0, 128], [0, 0, 40, 255], [0; 4], [0; 4]];
        let pixels = Pixels { size: [4, 1], rgba: row.concat() };
        let written = |is_mixed| {
            let mut bytes = vec![];
            Rgba::new(&mut bytes, is_mixed).frame(&pixels)?;
            Ok::<_, MovieError>(bytes)
        };
        // 100 · 255/128 = 199.2, 50 · 255/128 = 99.6: straight.
        assert_eq!(written(false)?, [[199, 100, 0, 128], [0, 0, 40, 255], [0; 4], [0; 4]].concat());
        assert_eq!(written(true)?, [[199, 100, 0, 128], [0, 0, 40, 255], [0, 0, 40, 0], [0; 4]].concat());
        let pixels = Pixels { size: [1, 3], rgba: [[100, 0, 0, 100], [0; 4], [0, 0, 200, 200]].concat() };
        let mut bytes = vec![];
        Rgba::new(&mut bytes, true).frame(&pixels)?;
        // 255 · 100/300 and 255 · 200/300.
        assert_eq!(bytes[4..8], [85, 0, 170, 0]);
        Ok(())
    }
}
