// From the samples themselves.
@group(0) @binding(0) var colors: texture_multisampled_2d<f32>;
@group(0) @binding(1) var depths: texture_depth_multisampled_2d;

struct Fragment {
    @location(0) color: vec4f,
    @builtin(frag_depth) depth: f32,
}

@fragment
fn fragment(in: Corner) -> Fragment {
    let pixel = vec2i(in.clip.xy + in.shift);
    let two = textureLoad(colors, pixel, 0) + textureLoad(colors, pixel, 1);
    let color = 0.25 * (two + textureLoad(colors, pixel, 2) + textureLoad(colors, pixel, 3));
    // The second nearest of the four: a pixel is the solid's where half of it is.
    let a = textureLoad(depths, pixel, 0);
    let b = textureLoad(depths, pixel, 1);
    let c = textureLoad(depths, pixel, 2);
    let d = textureLoad(depths, pixel, 3);
    let depth = max(min(max(a, b), max(c, d)), max(min(a, b), min(c, d)));
    return Fragment(color, depth);
}
