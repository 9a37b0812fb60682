// What every primitive of a view knows. Mirrored by `PaneUniform` in src/render/pane.rs.
struct Pane {
    clip_from_world: mat4x4f,
    // The ray through a pixel is ray_forward + ndc.x ray_right + ndc.y ray_up; its parameter is the view depth.
    ray_right: vec4f,
    ray_up: vec4f,
    ray_forward: vec4f,
    // w: distance of the near plane
    eye: vec4f,
    // towards the lights; w: strength
    key_light: vec4f,
    fill_light: vec4f,
    // width and height of the view, pixels per point, ambient light
    metrics: vec4f,
}

@group(0) @binding(0) var<uniform> pane: Pane;

// What a fragment needs of this it gets from its vertices: without a GPU a uniform is read for every pixel anew.

// How bright soft light makes a side whose normal has these products with the directions to the key and the fill light. Strengths: of
// both, and of what comes from everywhere.
fn light(to_key: f32, to_fill: f32, strengths: vec3f) -> f32 {
    // Wrapped: no face goes black, and the turn from light to shade is soft.
    let key = 0.5 + 0.5 * to_key;
    let fill = 0.5 + 0.5 * to_fill;
    // Colours are encoded, light is not: the root stands for the encoding.
    return sqrt(strengths.z + key * (0.3 + 0.7 * key) * strengths.x + fill * strengths.y);
}

// The gleam of a light, by the products of the normal with the sum of the directions to the light and to the eye, half way between
// which that sum lies, and of those two with each other.
fn gleam(to_sum: f32, light_to_eye: f32) -> f32 {
    // The 32nd power, by squaring: cheap where there is no special hardware for powers.
    let s = max(to_sum * inverseSqrt(max(2.0 + 2.0 * light_to_eye, 1e-6)), 0.0);
    let s2 = s * s;
    let s4 = s2 * s2;
    let s8 = s4 * s4;
    let s16 = s8 * s8;
    return s16 * s16;
}

// The corners of a quad: (0,0), (1,0), (0,1), (1,1).
fn quad_corner(index: u32) -> vec2f {
    return vec2f(f32(index & 1u), f32((index >> 1u) & 1u));
}
