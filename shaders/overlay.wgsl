// What is laid over the surfaces: lines and signs, quads whose edges are smooth by what each covers of a pixel. This is what both have
// in common; each goes on in a shader of its own, since without a GPU every pixel pays for all that is in one, and for every uniform
// that it reads. What a quad holds is told in src/render/overlay.rs.

struct View {
    // Takes pixels of the picture to normalised device coordinates: scale, offset.
    ndc_from_pixel: vec4f,
    // xy: the upper left corner of the part of the picture that is drawn
    corner: vec4f,
    // Factors on the opacity: x where a surface is before it (times its own for that), y where none is, z where none is (times that too).
    strength: vec4f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var depths: texture_2d<f32>;
@group(0) @binding(2) var atlas: texture_2d<f32>;

struct Quad {
    // pixels of the picture, depth
    @location(0) position: vec3f,
    @location(1) place: vec4f,
    @location(2) form: vec4f,
    @location(3) measures: vec4f,
    // kind, opacity where hidden, width of a rim
    @location(4) style: vec3f,
    @location(5) color: vec4f,
    @location(6) other_color: vec4f,
}

struct Corner {
    @builtin(position) clip: vec4f,
    // Pixels are those of the part of the picture that is drawn. Of a line both ends; of a sign its centre or corner, and what it is turned
    // by or the corner in the atlas.
    @location(0) @interpolate(flat) place: vec4f,
    @location(1) @interpolate(flat) form: vec4f,
    // Of a line: unit vector from one end to the other, their distance, half its width. Of a sign as it is.
    @location(2) @interpolate(flat) measures: vec4f,
    // Of a line: periods of its dashes before it, and of a pixel, less than 0 for dots and 0 without any. Of a sign: kind, width of its rim.
    // z, w: opacity where something is before it, and where nothing is
    @location(3) @interpolate(flat) style: vec4f,
    @location(4) @interpolate(flat) color: vec4f,
    @location(5) @interpolate(flat) other_color: vec4f,
}

// The same for both to the last number that is handed on: it is then compiled once.
@vertex
fn vertex(quad: Quad) -> Corner {
    let kind = quad.style.x;
    let is_line = kind < DISC;
    let behind = view.strength.x * quad.style.y;
    let before = view.strength.y + view.strength.z * quad.style.y;
    let ndc = quad.position.xy * view.ndc_from_pixel.xy + view.ndc_from_pixel.zw;
    // What would not be seen lies outside.
    let clip = vec4f(select(vec2f(2.0), ndc, max(behind, before) > 0.0), quad.position.z, 1.0);
    let start = quad.place.xy - view.corner.xy;
    let end = quad.place.zw - view.corner.xy;
    let long = max(distance(start, end), 1e-6);
    let way = vec4f((end - start) / long, long, quad.measures.w);
    let period = quad.measures.z;
    let per_pixel = (quad.measures.y - quad.measures.x) / (long * period);
    let dashes = vec2f(quad.measures.x / period, select(max(per_pixel, 1e-9), -max(per_pixel, 1e-9), kind == DOTTED));
    let pattern = select(dashes, vec2f(0.0), kind == SOLID);
    return Corner(
        clip,
        vec4f(start, select(quad.place.zw, end, is_line)),
        quad.form,
        select(quad.measures, way, is_line),
        vec4f(select(quad.style.xz, pattern, is_line), behind, before),
        quad.color,
        quad.other_color,
    );
}

// The factor on the opacity at a pixel.
fn strength(in: Corner) -> f32 {
    let is_behind = textureLoad(depths, vec2i(in.clip.xy), 0).r > in.clip.z;
    return select(in.style.w, in.style.z, is_behind);
}
