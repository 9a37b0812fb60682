// What is laid over the surfaces: lines, marks and texts, quads whose edges are smooth by what each covers of a pixel. This is what all
// three have in common; each has a shader of its own after it, since without a GPU every pixel pays for all that is in one, and for every
// uniform that it reads. What a quad holds is told in src/render/overlay.rs.

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

// Factors on the opacity where something is before a quad, and where nothing is.
fn strengths(quad: Quad) -> vec2f {
    return vec2f(view.strength.x * quad.style.y, view.strength.y + view.strength.z * quad.style.y);
}

// Where a corner lies: outside, where nothing would be seen of its quad.
fn placed(quad: Quad) -> vec4f {
    let ndc = quad.position.xy * view.ndc_from_pixel.xy + view.ndc_from_pixel.zw;
    let strongest = strengths(quad);
    return vec4f(select(vec2f(2.0), ndc, max(strongest.x, strongest.y) > 0.0), quad.position.z, 1.0);
}

// The factor at a pixel of what is drawn.
fn strength(clip: vec4f, factors: vec2f) -> f32 {
    let is_behind = textureLoad(depths, vec2i(clip.xy), 0).r > clip.z;
    return select(factors.y, factors.x, is_behind);
}
