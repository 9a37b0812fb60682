// Dots of constant size on the unit sphere, a triangle each: those of the far side shine through it.
struct Dot {
    // place, and diameter (points)
    @location(0) place: vec4f,
    @location(1) color: vec4f,
}

// How far dots are drawn before the sphere that they lie on, as a factor on their depth.
const LIFT: f32 = 1.014;
// Opacity of those on the far side.
const FAR: f32 = 0.3;

struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) offset: vec2f,
    // radius (pixels)
    @location(1) @interpolate(flat) radius: f32,
    @location(2) @interpolate(flat) color: vec4f,
}

@vertex
fn vertex(dot_: Dot, @builtin(vertex_index) index: u32) -> Corner {
    let at = dot_.place.xyz;
    let centre = pane.clip_from_world * vec4f(at, 1.0);
    let radius = 0.5 * dot_.place.w * pane.metrics.z;
    // The corners of a triangle round a disc of radius 1.
    let corner = index % 3u;
    let round = select(select(vec2f(-1.7320508, -1.0), vec2f(1.7320508, -1.0), corner == 1u), vec2f(0.0, 2.0), corner == 2u);
    let offset = round * (radius + 0.5);
    let is_near = dot(at, pane.eye.xyz - at) > 0.0;
    var clip = vec4f(2.0, 2.0, 0.0, 1.0);
    if centre.w > pane.eye.w {
        let ndc = centre.xyz / centre.w;
        clip = vec4f(ndc.xy + 2.0 * offset / pane.metrics.xy, select(1.0, min(ndc.z * LIFT, 1.0), is_near), 1.0);
    }
    return Corner(clip, offset, radius, dot_.color * vec4f(1.0, 1.0, 1.0, select(FAR, 1.0, is_near)));
}

@fragment
fn fragment(in: Corner) -> @location(0) vec4f {
    let alpha = clamp(in.radius + 0.5 - length(in.offset), 0.0, 1.0) * in.color.a;
    return vec4f(in.color.rgb * alpha, alpha);
}
