//! PNG, fast.

use super::Pixels;

/// The picture as a PNG file. One drawn transparent keeps its opacity, with straight colours as PNG wants them; any
/// other is written without.
///
/// # Errors
/// None but for a picture with no pixels.
pub fn encode_png(pixels: &Pixels, transparent: bool) -> Result<Vec<u8>, png::EncodingError> {
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

/// Divides the colours by the opacity, in linear light.
fn straight(premultiplied: &[u8]) -> Vec<u8> {
    let linear: [f32; 256] = std::array::from_fn(|code| {
        let value = code as f32 / 255.0;
        if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
    });
    let mut straight = premultiplied.to_vec();
    for pixel in straight.chunks_exact_mut(4) {
        let alpha = pixel[3];
        if alpha == 0 || alpha == 255 {
            continue;
        }
        for channel in &mut pixel[..3] {
            let value = (linear[usize::from(*channel)] * 255.0 / f32::from(alpha)).min(1.0);
            let coded = if value <= 0.003_130_8 { value * 12.92 } else { 1.055 * value.powf(1.0 / 2.4) - 0.055 };
            *channel = (coded * 255.0).round() as u8;
        }
    }
    straight
}
