// Marks of constant size on the screen, told apart by their form.
struct Mark {
    @location(0) position: vec3f,
    // diameter (points), opacity where hidden, form
    @location(1) style: vec3f,
    @location(2) color: vec4f,
    @location(3) rim: vec4f,
}

// How far marks are drawn before the surfaces they lie on, as a factor on their depth.
const LIFT: f32 = 1.014;

struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) offset: vec2f,
    // radius (pixels), form, factor on the opacity, pixels per point
    @location(1) @interpolate(flat) shape: vec4f,
    @location(2) @interpolate(flat) color: vec4f,
    @location(3) @interpolate(flat) rim: vec4f,
}

fn corner(mark: Mark, index: u32, hidden: bool) -> Corner {
    let centre = pane.clip_from_world * vec4f(mark.position, 1.0);
    let radius = 0.5 * mark.style.x * pane.metrics.z;
    let offset = (2.0 * quad_corner(index) - 1.0) * (1.5 * radius + 2.0);
    let opacity = select(1.0, mark.style.y, hidden);
    var clip = vec4f(2.0, 2.0, 0.0, 1.0);
    if centre.w > pane.eye.w && opacity > 0.0 {
        let ndc = centre.xyz / centre.w;
        clip = vec4f(ndc.xy + 2.0 * offset / pane.metrics.xy, min(ndc.z * LIFT, 1.0), 1.0);
    }
    return Corner(clip, offset, vec4f(radius, mark.style.z, opacity, pane.metrics.z), mark.color, mark.rim);
}

@vertex
fn vertex_seen(mark: Mark, @builtin(vertex_index) index: u32) -> Corner {
    return corner(mark, index, false);
}

@vertex
fn vertex_hidden(mark: Mark, @builtin(vertex_index) index: u32) -> Corner {
    return corner(mark, index, true);
}

fn square(a: vec2f, half: f32) -> f32 {
    return max(a.x, a.y) - half;
}

fn diamond(a: vec2f, half: f32) -> f32 {
    return (a.x + a.y - half) * 0.7071;
}

fn triangle(a: vec2f, up: f32, inner: f32) -> f32 {
    return max(a.x * 0.866 + up * 0.5, -up) - inner;
}

fn hourglass(along: f32, across: f32, half: f32) -> f32 {
    return max(along - half, (across - 0.9 * along) * 0.743);
}

// Distance to the outline (pixels), negative inside. The forms are the marks of src/frame.rs, numbered by src/render/marker.rs.
fn outline(form: f32, p: vec2f, radius: f32) -> f32 {
    let a = abs(p);
    // Half the stroke of the empty forms.
    let stroke = 0.2 * radius;
    switch u32(form) {
        case DISC: { return length(p) - radius; }
        case RING: { return abs(length(p) - 0.8 * radius) - stroke; }
        case DIAMOND: { return diamond(a, 1.2 * radius); }
        case CROSS: {
            let turned = vec2f(a.x + a.y, abs(a.x - a.y)) * 0.7071;
            return max(turned.x - 1.15 * radius, turned.y - 0.26 * radius);
        }
        case SQUARE: { return square(a, 0.85 * radius); }
        case TRIANGLE: { return triangle(a, p.y, 0.6 * radius); }
        case TRIANGLE_DOWN: { return triangle(a, -p.y, 0.6 * radius); }
        case OPEN_SQUARE: { return abs(square(a, 0.68 * radius)) - stroke; }
        case OPEN_DIAMOND: { return abs(diamond(a, 0.95 * radius)) - stroke; }
        case OPEN_TRIANGLE: { return abs(triangle(a, p.y, 0.45 * radius)) - stroke; }
        case OPEN_TRIANGLE_DOWN: { return abs(triangle(a, -p.y, 0.45 * radius)) - stroke; }
        case HOURGLASS: { return hourglass(a.y, a.x, 0.95 * radius); }
        case BOW: { return hourglass(a.x, a.y, 0.95 * radius); }
        case BARS: { return max(abs(a.x - 0.55 * radius) - 0.27 * radius, a.y - 0.9 * radius); }
        case STAR, default: {
            // Where the edges from a tip of one axis to the waist on the diagonal cut.
            let far = max(a.x, a.y);
            let near = min(a.x, a.y);
            return (far * 0.36 + near * 0.933) - 0.43 * radius;
        }
    }
}

@fragment
fn fragment(in: Corner) -> @location(0) vec4f {
    let radius = in.shape.x;
    let away = outline(in.shape.y, in.offset, radius);
    let rim_width = 1.4 * in.shape.w;
    let inner = clamp(0.5 - away, 0.0, 1.0) * in.color.a;
    let outer = clamp(0.5 + rim_width - away, 0.0, 1.0) * in.rim.a;
    if max(inner, outer) <= 0.0 {
        discard;
    }
    var color = in.color.rgb;
    if u32(in.shape.y) == DISC {
        // A ball: lighter towards the upper left.
        let high = 1.0 - clamp(length(in.offset / radius - vec2f(-0.35, 0.35)), 0.0, 1.0);
        color = mix(color * (0.82 + 0.3 * high), vec3f(1.0), 0.25 * high * high);
    }
    let paint = vec4f(color * inner, inner);
    let rim = vec4f(in.rim.rgb * outer, outer);
    return (paint + (1.0 - inner) * rim) * in.shape.z;
}
