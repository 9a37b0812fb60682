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
    // the ray in unit-sphere space
    origin: vec3f,
    ray: vec3f,
    near: f32,
    far: f32,
    coverage: f32,
}

fn meet(quadric: Quadric, ray: vec3f) -> Meeting {
    let o = quadric.eye.xyz;
    let d = quadric.unit_from_world * ray;
    let squared = dot(d, d);
    let middle = -dot(o, d) / squared;
    // The ray's distance from the centre in unit-sphere space; 1 at the silhouette.
    let miss = length(o + middle * d);
    let coverage = clamp((1.0 - miss) / fwidth(miss) + 0.5, 0.0, 1.0);
    let half = sqrt(max(1.0 - miss * miss, 0.0) / squared);
    return Meeting(o, d, middle - half, middle + half, coverage);
}

struct Wall {
    depth: f32,
    // premultiplied
    color: vec4f,
}

// What is the same for all walls along a ray.
struct Sight {
    to_eye: vec3f,
    half_way: vec3f,
}

// The near wall shows its outer side, the far one its inner side. (The sign of `facing` would not tell on the soft edge.)
fn wall(quadric: Quadric, meeting: Meeting, sight: Sight, outer: bool, coverage: f32) -> Wall {
    let depth = select(meeting.far, meeting.near, outer);
    let unit = meeting.origin + depth * meeting.ray;
    let outward = normalize(unit * quadric.unit_from_world);
    let facing = dot(outward, sight.to_eye);
    // A thin wall takes more light the more aslant it is seen, so the rim reads as a rim.
    let alpha = quadric.color.a;
    let opacity = alpha / (alpha + (1.0 - alpha) * max(abs(facing), 0.2));
    let color = lit(quadric.color.rgb, select(-outward, outward, outer), sight.half_way, select(0.0, 0.12, outer));
    let shown = select(0.0, opacity * coverage, depth > pane.eye.w);
    return Wall(depth, vec4f(color * (select(0.8, 1.0, outer) * shown), shown));
}

fn over(front: vec4f, back: Wall) -> vec4f {
    return front + (1.0 - front.a) * back.color;
}

struct Fragment {
    @location(0) color: vec4f,
    @builtin(frag_depth) depth: f32,
}

@fragment
fn fragment(corner: Corner) -> Fragment {
    let ray = corner.ray;
    let to_eye = -normalize(ray);
    let sight = Sight(to_eye, normalize(pane.key_light.xyz + to_eye));
    let one = meet(pair.first, ray);
    let two = meet(pair.second, ray);
    let first = one.coverage;
    let second = two.coverage * pair.choice.x;
    if first + second <= 0.0 {
        discard;
    }
    let near = pair.choice.y;
    let far = pair.choice.z;
    let absent = Wall(1e30, vec4f(0.0));
    var a = absent;
    var b = absent;
    var c = absent;
    var d = absent;
    if first > 0.0 {
        a = wall(pair.first, one, sight, true, first * near);
        c = wall(pair.first, one, sight, false, first * far);
    }
    if second > 0.0 {
        b = wall(pair.second, two, sight, true, second * near);
        d = wall(pair.second, two, sight, false, second * far);
    }
    // Near to far: a sorting network of four, the pairs (a, c) and (b, d) being in order already.
    var t = a;
    if a.depth > b.depth { t = a; a = b; b = t; }
    if c.depth > d.depth { t = c; c = d; d = t; }
    if b.depth > c.depth { t = b; b = c; c = t; }
    let color = over(over(over(a.color, b), c), d);
    // The nearest wall that is drawn hides the lines behind it.
    var depth = a.depth;
    if near < 0.5 {
        depth = min(select(1e30, one.far, first > 0.0), select(1e30, two.far, second > 0.0));
    }
    return Fragment(color, clamp(pane.eye.w / max(depth, pane.eye.w), 0.0, 1.0));
}
