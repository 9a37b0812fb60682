//! PNG, fast.

use std::io;

use crate::render::Pixels;

/// A line of text in the file: a keyword of the PNG standard and what it says.
pub type Note = (&'static str, String);

/// The picture as a PNG file. One drawn transparent keeps its opacity, with straight colours as PNG wants them; any
/// other is written without.
///
/// # Errors
/// None but for a picture with no pixels.
pub fn encode(pixels: &Pixels, transparent: bool, notes: &[Note]) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = vec![];
    let mut encoder = encoder(&mut bytes, pixels.size, transparent);
    for (keyword, text) in notes {
        encoder.add_itxt_chunk((*keyword).to_owned(), text.clone())?;
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&colours(pixels, transparent))?;
    writer.finish()?;
    Ok(bytes)
}

/// How every picture is encoded: eight bits of sRGB, fast.
pub(super) fn encoder<W: io::Write>(
    writer: W,
    [width, height]: [u32; 2],
    transparent: bool,
) -> png::Encoder<'static, W> {
    let mut encoder = png::Encoder::new(writer, width, height);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.set_color(if transparent { png::ColorType::Rgba } else { png::ColorType::Rgb });
    encoder
}

/// The bytes that [`encoder`] takes.
pub(super) fn colours(pixels: &Pixels, transparent: bool) -> Vec<u8> {
    if transparent {
        straight(&pixels.rgba)
    } else {
        pixels.rgba.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
    }
}

/// Whether the bytes are a whole PNG file of this size with these notes: every check sum and the last row are there.
#[must_use]
pub fn is_whole(bytes: &[u8], size: [u32; 2], notes: &[Note]) -> bool {
    let Ok(mut reader) = png::Decoder::new(io::Cursor::new(bytes)).read_info() else { return false };
    let Some(length) = reader.output_buffer_size() else { return false };
    let mut pixels = vec![0; length];
    if reader.next_frame(&mut pixels).is_err() || reader.finish().is_err() {
        return false;
    }
    let info = reader.info();
    let is_said = |(keyword, text): &Note| {
        info.utf8_text.iter().any(|chunk| chunk.keyword == *keyword && chunk.get_text().is_ok_and(|said| said == *text))
    };
    [info.width, info.height] == size && notes.iter().all(is_said)
}

/// Divides the colours by the opacity.
fn straight(premultiplied: &[u8]) -> Vec<u8> {
    let mut straight = premultiplied.to_vec();
    for pixel in straight.chunks_exact_mut(4) {
        let alpha = u32::from(pixel[3]);
        if alpha == 0 || alpha == 255 {
            continue;
        }
        for channel in &mut pixel[..3] {
            *channel = ((u32::from(*channel) * 255 + alpha / 2) / alpha).min(255) as u8;
        }
    }
    straight
}
