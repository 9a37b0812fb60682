// One or two translucent ellipsoids that may cut each other: each ray meets each of them twice; the up to four
// walls are sorted and composited exactly.
struct Quadric {
    unit_from_world: mat4x4f,
    color: vec4f,
}

struct Pair {
    first: Quadric,
    second: Quadric,
    // the rectangle of the screen that holds both: low x, low y, high x, high y (normalised device coordinates)
    bounds: vec4f,
    // x: 1 where there is a second one; y, z: 1 to draw the near, the far walls
    choice: vec4f,
}

@group(1) @binding(0) var<uniform> pair: Pair;

struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) ndc: vec2f,
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Corner {
    let ndc = mix(pair.bounds.xy, pair.bounds.zw, strip_corner(index));
    return Corner(vec4f(ndc, 0.5, 1.0), ndc);
}

// Where a ray meets an ellipsoid, and how much of the pixel the ellipsoid covers.
struct Meeting {
    near: f32,
    far: f32,
    coverage: f32,
}

fn meet(quadric: Quadric, origin: vec3f, ray: vec3f) -> Meeting {
    let o = (quadric.unit_from_world * vec4f(origin, 1.0)).xyz;
    let d = (quadric.unit_from_world * vec4f(ray, 0.0)).xyz;
    let squared = dot(d, d);
    let middle = -dot(o, d) / squared;
    // The ray's distance from the centre in unit-sphere space; 1 at the silhouette.
    let miss = length(o + middle * d);
    let coverage = clamp((1.0 - miss) / fwidth(miss) + 0.5, 0.0, 1.0);
    let half = sqrt(max(1.0 - miss * miss, 0.0) / squared);
    return Meeting(middle - half, middle + half, coverage);
}

struct Wall {
    depth: f32,
    // premultiplied
    color: vec4f,
}

fn wall(quadric: Quadric, origin: vec3f, ray: vec3f, depth: f32, coverage: f32) -> Wall {
    let position = origin + depth * ray;
    let unit = (quadric.unit_from_world * vec4f(position, 1.0)).xyz;
    let outward = normalize((vec4f(unit, 0.0) * quadric.unit_from_world).xyz);
    let to_eye = -normalize(ray);
    let facing = dot(outward, to_eye);
    let normal = select(-outward, outward, facing > 0.0);
    // A thin wall absorbs by the length of the way through it, so the rim reads as a rim.
    let way = 1.0 / max(abs(facing), 0.16);
    let opacity = (1.0 - pow(1.0 - quadric.color.a, way)) * coverage;
    let inner = select(0.8, 1.0, facing > 0.0);
    let color = lit(quadric.color.rgb, normal, to_eye, select(0.0, 0.12, facing > 0.0)) * inner;
    let shown = step(view.eye.w, depth) * opacity;
    return Wall(depth, vec4f(color * shown, shown));
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
    let origin = view.eye.xyz;
    let ray = view.ray_forward.xyz + corner.ndc.x * view.ray_right.xyz + corner.ndc.y * view.ray_up.xyz;
    let one = meet(pair.first, origin, ray);
    let two = meet(pair.second, origin, ray);
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
        a = wall(pair.first, origin, ray, one.near, first * near);
        c = wall(pair.first, origin, ray, one.far, first * far);
    }
    if second > 0.0 {
        b = wall(pair.second, origin, ray, two.near, second * near);
        d = wall(pair.second, origin, ray, two.far, second * far);
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
    return Fragment(color, clamp(view.eye.w / max(depth, view.eye.w), 0.0, 1.0));
}
