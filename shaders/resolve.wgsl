// The mean of a pixel's samples.
@group(0) @binding(0) var samples: texture_multisampled_2d<f32>;

// The corners of what is to be resolved (normalised device coordinates).
@vertex
fn vertex(@location(0) ndc: vec2f) -> @builtin(position) vec4f {
    return vec4f(ndc, 0.0, 1.0);
}

@fragment
fn fragment(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let pixel = vec2i(at.xy);
    let two = textureLoad(samples, pixel, 0) + textureLoad(samples, pixel, 1);
    return 0.25 * (two + textureLoad(samples, pixel, 2) + textureLoad(samples, pixel, 3));
}
