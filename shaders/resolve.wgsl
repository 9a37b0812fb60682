// The mean of a pixel's samples.
@group(0) @binding(0) var samples: texture_multisampled_2d<f32>;

// One triangle that covers the picture.
@vertex
fn vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(4.0 * vec2f(f32(index & 1u), f32(index >> 1u)) - 1.0, 0.0, 1.0);
}

@fragment
fn fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(at.xy);
    let two = textureLoad(samples, pixel, 0) + textureLoad(samples, pixel, 1);
    return 0.25 * (two + textureLoad(samples, pixel, 2) + textureLoad(samples, pixel, 3));
}
