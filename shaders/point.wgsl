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
    let centre = view.clip_from_world * vec4f(mark.position, 1.0);
    let radius = 0.5 * mark.style.x * view.metrics.z;
    let offset = (2.0 * quad_corner(index) - 1.0) * (1.5 * radius + 2.0);
    let opacity = select(1.0, mark.style.y, hidden);
    var clip = vec4f(2.0, 2.0, 0.0, 1.0);
    if centre.w > view.eye.w && opacity > 0.0 {
        let ndc = centre.xyz / centre.w;
        clip = vec4f(ndc.xy + 2.0 * offset / view.metrics.xy, min(ndc.z * LIFT, 1.0), 1.0);
    }
    return Corner(clip, offset, vec4f(radius, mark.style.z, opacity, view.metrics.z), mark.color, mark.rim);
}

@vertex
fn vertex_seen(mark: Mark, @builtin(vertex_index) index: u32) -> Corner {
    return corner(mark, index, false);
}

@vertex
fn vertex_hidden(mark: Mark, @builtin(vertex_index) index: u32) -> Corner {
    return corner(mark, index, true);
}

// Distance to the outline (pixels), negative inside.
fn outline(form: f32, p: vec2f, radius: f32) -> f32 {
    let a = abs(p);
    if form < 0.5 {
        return length(p) - radius;
    }
    if form < 1.5 {
        return abs(length(p) - 0.8 * radius) - 0.2 * radius;
    }
    if form < 2.5 {
        return (a.x + a.y - 1.2 * radius) * 0.7071;
    }
    if form < 3.5 {
        let turned = vec2f(a.x + a.y, abs(a.x - a.y)) * 0.7071;
        return max(turned.x - 1.15 * radius, turned.y - 0.26 * radius);
    }
    if form < 4.5 {
        return max(a.x, a.y) - 0.85 * radius;
    }
    return max(a.x * 0.866 + p.y * 0.5, -p.y) - 0.6 * radius;
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
    if in.shape.y < 0.5 {
        // A ball: lighter towards the upper left.
        let high = 1.0 - clamp(length(in.offset / radius - vec2f(-0.35, 0.35)), 0.0, 1.0);
        color = mix(color * (0.82 + 0.3 * high), vec3f(1.0), 0.25 * high * high);
    }
    let paint = vec4f(color * inner, inner);
    let rim = vec4f(in.rim.rgb * outer, outer);
    return (paint + (1.0 - inner) * rim) * in.shape.z;
}
