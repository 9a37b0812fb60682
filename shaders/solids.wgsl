// Lays the solids, drawn beside the picture, on their place in it: the mean of a pixel's samples.

struct Corner {
    @builtin(position) clip: vec4f,
    // where among the solids, less where in the picture (pixels)
    @location(0) @interpolate(flat) shift: vec2f,
}

@vertex
fn vertex(@location(0) ndc: vec2f, @location(1) shift: vec2f) -> Corner {
    return Corner(vec4f(ndc, 0.0, 1.0), shift);
}
