// From means that the device has taken.
@group(0) @binding(0) var colors: texture_2d<f32>;

@fragment
fn fragment(in: Corner) -> @location(0) vec4f {
    return textureLoad(colors, vec2i(in.clip.xy + in.shift), 0);
}
