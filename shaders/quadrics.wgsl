// One or two translucent ellipsoids that may cut each other: each ray meets each of them twice; the up to four
// walls are sorted and composited exactly.
struct Quadric {
    // Takes directions of the world to the space in which it is the unit sphere.
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
    @location(0) ray: vec3f,
}

// The corners of a polygon of the screen that holds both (normalised device coordinates).
@vertex
fn vertex(@location(0) ndc: vec2f) -> Corner {
    let ray = pane.ray_forward.xyz + ndc.x * pane.ray_right.xyz + ndc.y * pane.ray_up.xyz;
    return Corner(vec4f(ndc, 0.5, 1.0), ray);
}

// Where a ray meets an ellipsoid, and how much of the pixel the ellipsoid covers.
struct Meeting {
    near: f32,
    far: f32,
    coverage: f32,
    // directions outward there, of some length
    near_normal: vec3f,
    far_normal: vec3f,
}

fn meet(quadric: Quadric, ray: vec3f) -> Meeting {
    // In the space in which it is the unit sphere.
    let d = quadric.unit_from_world * ray;
    let squared = dot(d, d);
    let middle = -dot(quadric.eye.xyz, d) / squared;
    let closest = quadric.eye.xyz + middle * d;
    // The ray's distance from the centre; 1 at the silhouette.
    let miss_squared = dot(closest, closest);
    let miss = sqrt(miss_squared);
    let coverage = clamp((1.0 - miss) / fwidth(miss) + 0.5, 0.0, 1.0);
    let half = sqrt(max(1.0 - miss_squared, 0.0) / squared);
    let across = closest * quadric.unit_from_world;
    let along = (half * d) * quadric.unit_from_world;
    return Meeting(middle - half, middle + half, coverage, across - along, across + along);
}

// The opacity of a wall. A thin one takes more light the more aslant it is seen, so the rim reads as a rim.
fn opacity(quadric: Quadric, normal: vec3f, to_eye: vec3f) -> f32 {
    let alpha = quadric.color.a;
    return alpha / (alpha + (1.0 - alpha) * max(abs(dot(normal, to_eye)), 0.2));
}

struct Fragment {
    @location(0) color: vec4f,
    @builtin(frag_depth) depth: f32,
}

@fragment
fn fragment(corner: Corner) -> Fragment {
    let ray = corner.ray;
    let to_eye = -normalize(ray);
    let half_way = normalize(pane.key_light.xyz + to_eye);
    let one = meet(pair.first, ray);
    let two = meet(pair.second, ray);
    let first = one.coverage;
    let second = two.coverage * pair.choice.x;
    if first + second <= 0.0 {
        discard;
    }
    // Of four walls, the near and the far one of both: a and c, b and d. What is not there has no opacity. (All are reckoned in every
    // pixel: where there is no GPU a branch costs more than it leaves out.)
    let normal_a = normalize(one.near_normal);
    let normal_b = normalize(two.near_normal);
    let normal_c = normalize(one.far_normal);
    let normal_d = normalize(two.far_normal);
    let depths = vec4f(one.near, two.near, one.far, two.far);
    let opacities = vec4f(
        opacity(pair.first, normal_a, to_eye),
        opacity(pair.second, normal_b, to_eye),
        opacity(pair.first, normal_c, to_eye),
        opacity(pair.second, normal_d, to_eye),
    );
    let covers = vec4f(first, second, first, second) * pair.choice.yyzz;
    let shown = select(vec4f(0.0), opacities * covers, depths > vec4f(pane.eye.w));
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
    let bright_first = light(normal_a) * seen.x + 0.8 * light(-normal_c) * seen.z;
    let bright_second = light(normal_b) * seen.y + 0.8 * light(-normal_d) * seen.w;
    let gleams = 0.12 * (gleam(normal_a, half_way) * seen.x + gleam(normal_b, half_way) * seen.y);
    let color = pair.first.color.rgb * bright_first + pair.second.color.rgb * bright_second + vec3f(gleams);
    // The nearest wall that is drawn hides the lines behind it.
    let nearest = select(vec2f(one.far, two.far), vec2f(one.near, two.near), pair.choice.y >= 0.5);
    let depth = min(select(1e30, nearest.x, first > 0.0), select(1e30, nearest.y, second > 0.0));
    let alpha = seen.x + seen.y + seen.z + seen.w;
    return Fragment(vec4f(color, alpha), clamp(pane.eye.w / max(depth, pane.eye.w), 0.0, 1.0));
}
