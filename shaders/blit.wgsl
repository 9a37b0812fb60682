// Copies the picture to its place in the window, pixel by pixel.

// Whether the window encodes what is written to it: the picture's values are encoded already.
override decode: bool = false;

@group(0) @binding(0) var picture: texture_2d<f32>;

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) uv: vec2f,
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let uv = vec2f(f32((index << 1u) & 2u), f32(index & 2u));
    return Corner(vec4f(uv * vec2f(2.0, -2.0) + vec2f(-1.0, 1.0), 0.0, 1.0), uv);
}

@fragment
fn fragment(corner: Corner) -> @location(0) vec4f {
    let size = vec2f(textureDimensions(picture));
    let color = textureLoad(picture, vec2i(corner.uv * size), 0);
    if !decode {
        return vec4f(color.rgb, 1.0);
    }
    let low = color.rgb / 12.92;
    let high = pow((color.rgb + 0.055) / 1.055, vec3f(2.4));
    return vec4f(select(high, low, color.rgb <= vec3f(0.04045)), 1.0);
}
