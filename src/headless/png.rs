//! PNG, fast.

use crate::render::Pixels;

/// The picture as a PNG file. One drawn transparent keeps its opacity, with straight colours as PNG wants them; any
/// other is written without.
///
/// # Errors
/// None but for a picture with no pixels.
pub fn encode(pixels: &Pixels, transparent: bool) -> Result<Vec<u8>, png::EncodingError> {
    let [width, height] = pixels.size;
    let mut bytes = vec![];
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::Fast);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let data: Vec<u8> = if transparent {
        encoder.set_color(png::ColorType::Rgba);
        straight(&pixels.rgba)
    } else {
        encoder.set_color(png::ColorType::Rgb);
        pixels.rgba.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect()
    };
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&data)?;
    writer.finish()?;
    Ok(bytes)
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
