//! A picture as a PNG file, encoded fast: for pictures written with no window, and for those that the window or the page writes.

use std::io::{self, Write};

use super::readback::Pixels;

pub use png::EncodingError;

/// The most bytes that a piece of a file holds.
const CHUNK: usize = 1 << 16;

/// What the file says of itself: a keyword of the PNG standard and its text.
pub type Remark = (&'static str, String);

/// The picture as a PNG file. One drawn transparent keeps its opacity, with straight colours as PNG wants them; any
/// other is written without.
///
/// # Errors
/// None but for a picture with no pixels.
pub fn encode(pixels: &Pixels, transparent: bool, remarks: &[Remark]) -> Result<Vec<u8>, EncodingError> {
    encode_marked(pixels, transparent, remarks, None)
}

/// As [`encode`], marked with this many pixels a metre, by which programs that set pages know how large it is.
///
/// # Errors
/// None but for a picture with no pixels.
pub fn encode_marked(
    pixels: &Pixels,
    transparent: bool,
    remarks: &[Remark],
    pixels_per_metre: Option<u32>,
) -> Result<Vec<u8>, EncodingError> {
    encode_rows(pixels.size, transparent, remarks, pixels_per_metre, |take| {
        pixels.rgba.chunks_exact(4 * pixels.size[0].max(1) as usize).try_for_each(take)
    })
}

/// As [`encode_marked`], from rows (as those of [`Pixels`]) that are handed over one by one, from the top: the picture is never
/// in memory as a whole.
///
/// # Errors
/// Those of `draw`, and where it hands over too few rows.
pub fn encode_rows<E: From<EncodingError>>(
    size: [u32; 2],
    transparent: bool,
    remarks: &[Remark],
    pixels_per_metre: Option<u32>,
    draw: impl FnOnce(&mut dyn FnMut(&[u8]) -> Result<(), EncodingError>) -> Result<(), E>,
) -> Result<Vec<u8>, E> {
    let mut bytes = vec![];
    let mut encoder = encoder(&mut bytes, size, transparent);
    encoder.set_pixel_dims(pixels_per_metre.map(density));
    say(&mut encoder, remarks)?;
    let mut writer = encoder.write_header()?;
    let mut stream = writer.stream_writer_with_size(CHUNK)?;
    let mut row = vec![];
    draw(&mut |rgba| {
        append_colours(rgba, transparent, &mut row);
        let outcome = stream.write_all(&row).map_err(EncodingError::IoError);
        row.clear();
        outcome
    })?;
    stream.finish()?;
    writer.finish()?;
    Ok(bytes)
}

/// Lets a file say this of itself: in plain text where ASCII does, which programs that write a picture again keep more often.
///
/// # Errors
/// None but for a keyword that PNG does not take.
pub fn say<W: io::Write>(encoder: &mut png::Encoder<'_, W>, remarks: &[Remark]) -> Result<(), EncodingError> {
    for (keyword, text) in remarks {
        // A PNG's text ends at a NUL.
        let (keyword, text) = ((*keyword).to_owned(), text.replace('\0', "\u{fffd}"));
        if text.is_ascii() {
            encoder.add_text_chunk(keyword, text)?;
        } else {
            encoder.add_itxt_chunk(keyword, text)?;
        }
    }
    Ok(())
}

/// Pixels inside of another file as a small PNG, with so many bytes a pixel: grey, colours, or colours with their straight opacity.
///
/// # Errors
/// None but for a picture with no pixels.
pub fn encode_small(size: [u32; 2], channels: usize, bytes: &[u8]) -> Result<Vec<u8>, EncodingError> {
    let mut file = vec![];
    let mut encoder = encoder(&mut file, size, channels == 4);
    // Shades of a surface stand in long rows of the same bytes, which differences between neighbours would break up.
    encoder.set_deflate_compression(png::DeflateCompression::Level(5));
    encoder.set_filter(png::Filter::NoFilter);
    if channels == 1 {
        encoder.set_color(png::ColorType::Grayscale);
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(bytes)?;
    writer.finish()?;
    Ok(file)
}

/// The packed rows of a PNG file, as other formats take them too: each filtered by the filter that its first byte names.
#[must_use]
pub fn packed_rows(file: &[u8]) -> Vec<u8> {
    let mut rows = vec![];
    let mut rest = file.get(8..).unwrap_or_default();
    while let Some((head, after)) = rest.split_at_checked(8) {
        let length = head.iter().take(4).fold(0_usize, |length, byte| length << 8 | usize::from(*byte));
        let Some((data, after)) = after.split_at_checked(length) else { break };
        if head.ends_with(b"IDAT") {
            rows.extend_from_slice(data);
        }
        // Behind it is a check sum.
        rest = after.get(4..).unwrap_or_default();
    }
    rows
}

/// How every picture is encoded, those of a moving one too: eight bits of sRGB, fast.
pub fn encoder<W: io::Write>(writer: W, [width, height]: [u32; 2], transparent: bool) -> png::Encoder<'static, W> {
    let mut encoder = png::Encoder::new(writer, width, height);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.set_color(if transparent { png::ColorType::Rgba } else { png::ColorType::Rgb });
    encoder
}

/// The bytes that [`encoder`] takes.
#[must_use]
pub fn colours(pixels: &Pixels, transparent: bool) -> Vec<u8> {
    let mut colours = Vec::with_capacity(pixels.rgba.len());
    append_colours(&pixels.rgba, transparent, &mut colours);
    colours
}

/// Adds the bytes that stand for some pixels.
fn append_colours(rgba: &[u8], transparent: bool, colours: &mut Vec<u8>) {
    if transparent {
        append_straight(rgba, colours);
    } else {
        colours.extend(rgba.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]));
    }
}

/// So many pixels a metre both ways.
fn density(pixels_per_metre: u32) -> png::PixelDimensions {
    png::PixelDimensions { xppu: pixels_per_metre, yppu: pixels_per_metre, unit: png::Unit::Meter }
}

/// Whether the bytes are a whole PNG file of this size with these remarks and this mark: every check sum and the last row
/// are there.
#[must_use]
pub fn is_whole(bytes: &[u8], size: [u32; 2], remarks: &[Remark], pixels_per_metre: Option<u32>) -> bool {
    let Ok(mut reader) = png::Decoder::new(io::Cursor::new(bytes)).read_info() else { return false };
    let Some(length) = reader.output_buffer_size() else { return false };
    let mut pixels = vec![0; length];
    if reader.next_frame(&mut pixels).is_err() || reader.finish().is_err() {
        return false;
    }
    let info = reader.info();
    let is_said = |(keyword, text): &Remark| {
        let is_plain = |said: &png::text_metadata::TEXtChunk| said.keyword == *keyword && said.text == *text;
        let is_wide = |said: &png::text_metadata::ITXtChunk| {
            said.keyword == *keyword && said.get_text().is_ok_and(|said| said == *text)
        };
        info.uncompressed_latin1_text.iter().any(is_plain) || info.utf8_text.iter().any(is_wide)
    };
    let is_marked = info.pixel_dims.map(|dims| (dims.xppu, dims.yppu)) == pixels_per_metre.map(|count| (count, count));
    is_marked && [info.width, info.height] == size && remarks.iter().all(is_said)
}

/// Adds colours divided by their opacity.
fn append_straight(premultiplied: &[u8], colours: &mut Vec<u8>) {
    let start = colours.len();
    colours.extend_from_slice(premultiplied);
    for pixel in colours[start..].chunks_exact_mut(4) {
        let alpha = u32::from(pixel[3]);
        if alpha == 0 || alpha == 255 {
            continue;
        }
        for channel in &mut pixel[..3] {
            *channel = ((u32::from(*channel) * 255 + alpha / 2) / alpha).min(255) as u8;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{EncodingError, Pixels, Remark, encode, encode_marked, is_whole};

    #[test]
    fn a_picture_comes_back_whole_with_what_it_says_of_itself() -> Result<(), EncodingError> {
        let pixels = Pixels { size: [2, 1], rgba: vec![64, 32, 0, 128, 9, 8, 7, 255] };
        let remarks: [Remark; 2] = [("Title", "Ω and ω".to_owned()), ("Comment", "made by a test".to_owned())];
        for (transparent, expected) in [(true, vec![128, 64, 0, 128, 9, 8, 7, 255]), (false, vec![64, 32, 0, 9, 8, 7])]
        {
            let bytes = encode(&pixels, transparent, &remarks)?;
            assert!(is_whole(&bytes, [2, 1], &remarks, None));
            assert!(!is_whole(&bytes[..bytes.len() - 1], [2, 1], &remarks, None));
            assert!(!is_whole(&bytes, [1, 2], &remarks, None));
            assert!(!is_whole(&bytes, [2, 1], &[("Title", "another".to_owned())], None));
            let marked = encode_marked(&pixels, transparent, &remarks, Some(23_622))?;
            assert!(is_whole(&marked, [2, 1], &remarks, Some(23_622)));
            assert!(!is_whole(&marked, [2, 1], &remarks, None) && !is_whole(&bytes, [2, 1], &remarks, Some(1)));
            let mut decoded = vec![0; expected.len()];
            let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().ok();
            assert!(reader.as_mut().is_some_and(|reader| reader.next_frame(&mut decoded).is_ok()));
            // Half opaque, the colours are doubled: PNG's are straight.
            assert_eq!(decoded, expected);
        }
        Ok(())
    }
}
