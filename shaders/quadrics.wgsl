// One or two translucent ellipsoids that may cut each other: each ray meets each of them twice; the up to four
// walls are composited exactly. All is reckoned in the spaces in which each is the unit sphere.
struct Quadric {
    // Takes directions of the world to the space in which it is the unit sphere. Its rows are at right angles.
    unit_from_world: mat3x3f,
    // where the eye is in that space
    eye: vec4f,
    color: vec4f,
}

struct Pair {
    first: Quadric,
    second: Quadric,
    // x: 1 where there is a second one; y, z: 1 to draw the near, the far walls
    choice: vec4f,
}

@group(1) @binding(0) var<uniform> pair: Pair;

struct Corner {
    @builtin(position) clip: vec4f,
    // the ray, and its product with the direction to the key light
    @location(0) ray: vec4f,
    // the ray in the space of each
    @location(1) first_ray: vec3f,
    @location(2) second_ray: vec3f,
    // strengths of the lights as `light` takes them, distance of the near plane
    @location(3) @interpolate(flat) scene: vec4f,
    // of each: eye, squares of the lengths of its map's rows, directions to both lights taken to its space, colour
    @location(4) @interpolate(flat) first_eye: vec3f,
    @location(5) @interpolate(flat) first_rows: vec3f,
    @location(6) @interpolate(flat) first_key: vec3f,
    @location(7) @interpolate(flat) first_fill: vec3f,
    @location(8) @interpolate(flat) first_color: vec4f,
    // w: 1 to draw the near, the far walls
    @location(9) @interpolate(flat) second_eye: vec4f,
    @location(10) @interpolate(flat) second_rows: vec4f,
    @location(11) @interpolate(flat) second_key: vec3f,
    @location(12) @interpolate(flat) second_fill: vec3f,
    @location(13) @interpolate(flat) second_color: vec4f,
}

// The corners of a polygon of the screen that holds both (normalised device coordinates).
@vertex
fn vertex(@location(0) ndc: vec2f) -> Corner {
    let ray = pane.ray_forward.xyz + ndc.x * pane.ray_right.xyz + ndc.y * pane.ray_up.xyz;
    let key = pane.key_light.xyz;
    let fill = pane.fill_light.xyz;
    let first = pair.first.unit_from_world;
    let second = pair.second.unit_from_world;
    // One that is not there is passed by.
    let is_pair = pair.choice.x > 0.5;
    let second_ray = select(vec3f(0.0, 0.0, 1.0), second * ray, is_pair);
    let second_eye = select(vec3f(4.0, 0.0, 0.0), pair.second.eye.xyz, is_pair);
    return Corner(
        vec4f(ndc, 0.5, 1.0),
        vec4f(ray, dot(ray, key)),
        first * ray,
        second_ray,
        vec4f(pane.key_light.w, pane.fill_light.w, pane.metrics.w, pane.eye.w),
        pair.first.eye.xyz,
        rows(first),
        first * key,
        first * fill,
        pair.first.color,
        vec4f(second_eye, pair.choice.y),
        vec4f(rows(second), pair.choice.z),
        second * key,
        second * fill,
        pair.second.color,
    );
}

fn rows(map: mat3x3f) -> vec3f {
    return map[0] * map[0] + map[1] * map[1] + map[2] * map[2];
}

// Where a ray meets an ellipsoid, and how much of the pixel the ellipsoid covers.
struct Meeting {
    near: f32,
    far: f32,
    coverage: f32,
    // both places
    near_place: vec3f,
    far_place: vec3f,
    // product of the outward direction at the near one and the ray back to the eye, neither of unit length; at the far one it is the
    // opposite
    facing: f32,
}

fn meet(eye: vec3f, ray: vec3f) -> Meeting {
    let squared = dot(ray, ray);
    let middle = -dot(eye, ray) / squared;
    let closest = eye + middle * ray;
    // The ray's distance from the centre; 1 at the silhouette.
    let miss_squared = dot(closest, closest);
    let miss = sqrt(miss_squared);
    let coverage = clamp((1.0 - miss) / fwidth(miss) + 0.5, 0.0, 1.0);
    let half = sqrt(max(1.0 - miss_squared, 0.0) / squared);
    return Meeting(middle - half, middle + half, coverage, closest - half * ray, closest + half * ray, half * squared);
}

struct Wall {
    opacity: f32,
    brightness: f32,
    // product of the outward direction and the sum of those to the key light and to the eye
    gloss: f32,
}

// The wall at a place, `side` 1 for its outer and -1 for its inner one. A thin wall takes more light the more aslant it is seen, so the
// rim reads as a rim.
fn wall(place: vec3f, rows: vec3f, key: vec3f, fill: vec3f, facing: f32, side: f32, alpha: f32, strengths: vec3f) -> Wall {
    // One over the length of the outward direction, which is the place by the map's transpose.
    let scale = inverseSqrt(dot(place * place, rows));
    let to_key = scale * dot(place, key);
    let to_fill = scale * dot(place, fill);
    let to_eye = scale * facing;
    let opacity = alpha / (alpha + (1.0 - alpha) * max(to_eye, 0.2));
    return Wall(opacity, light(side * to_key, side * to_fill, strengths), to_key + to_eye);
}

struct Fragment {
    @location(0) color: vec4f,
    @builtin(frag_depth) depth: f32,
}

@fragment
fn fragment(in: Corner) -> Fragment {
    let one = meet(in.first_eye, in.first_ray);
    let two = meet(in.second_eye.xyz, in.second_ray);
    if one.coverage + two.coverage <= 0.0 {
        discard;
    }
    let per_ray = inverseSqrt(dot(in.ray.xyz, in.ray.xyz));
    let facing = vec2f(one.facing, two.facing) * per_ray;
    let strengths = in.scene.xyz;
    let first = in.first_color;
    let second = in.second_color;
    let first_rows = in.first_rows;
    let second_rows = in.second_rows.xyz;
    // Of four walls, the near and the far one of both: a and c, b and d. What is not there has no opacity. (All are reckoned in every
    // pixel: where there is no GPU a branch costs more than it leaves out.)
    let a = wall(one.near_place, first_rows, in.first_key, in.first_fill, facing.x, 1.0, first.a, strengths);
    let b = wall(two.near_place, second_rows, in.second_key, in.second_fill, facing.y, 1.0, second.a, strengths);
    let c = wall(one.far_place, first_rows, in.first_key, in.first_fill, facing.x, -1.0, first.a, strengths);
    let d = wall(two.far_place, second_rows, in.second_key, in.second_fill, facing.y, -1.0, second.a, strengths);
    let near = in.second_eye.w;
    let far = in.second_rows.w;
    let depths = vec4f(one.near, two.near, one.far, two.far);
    let covers = vec4f(one.coverage, two.coverage, one.coverage, two.coverage) * vec4f(near, near, far, far);
    let opacities = vec4f(a.opacity, b.opacity, c.opacity, d.opacity);
    let shown = select(vec4f(0.0), opacities * covers, depths > vec4f(in.scene.w));
    // What passes through each, and which of two comes first.
    let past = 1.0 - shown;
    let b_then_a = depths.x > depths.y;
    let d_then_a = depths.x > depths.w;
    let b_then_c = depths.z > depths.y;
    let d_then_c = depths.z > depths.w;
    let seen = shown * vec4f(
        select(1.0, past.y, b_then_a) * select(1.0, past.w, d_then_a),
        select(past.x, 1.0, b_then_a) * select(past.z, 1.0, b_then_c),
        past.x * select(1.0, past.y, b_then_c) * select(1.0, past.w, d_then_c),
        past.y * select(past.x, 1.0, d_then_a) * select(past.z, 1.0, d_then_c),
    );
    // The near walls show their outer sides, which gleam, the far ones their inner sides.
    let key_to_eye = -in.ray.w * per_ray;
    let gleams = 0.12 * (gleam(a.gloss, key_to_eye) * seen.x + gleam(b.gloss, key_to_eye) * seen.y);
    let bright_first = a.brightness * seen.x + 0.8 * c.brightness * seen.z;
    let bright_second = b.brightness * seen.y + 0.8 * d.brightness * seen.w;
    let color = first.rgb * bright_first + second.rgb * bright_second + vec3f(gleams);
    // The nearest wall that is drawn hides the lines behind it.
    let nearest = select(vec2f(one.far, two.far), vec2f(one.near, two.near), near >= 0.5);
    let depth = min(select(1e30, nearest.x, one.coverage > 0.0), select(1e30, nearest.y, two.coverage > 0.0));
    let alpha = seen.x + seen.y + seen.z + seen.w;
    return Fragment(vec4f(color, alpha), clamp(in.scene.w / max(depth, in.scene.w), 0.0, 1.0));
}
