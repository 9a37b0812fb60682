// Lines of constant width: a quad a segment, round joins and caps. Neighbours are cut along the bisector of their
// corner, so that no pixel is blended twice.
struct Segment {
    @location(0) before: vec3f,
    @location(1) start: vec3f,
    @location(2) end: vec3f,
    @location(3) after: vec3f,
    // width (points), opacity where hidden, dash period, dash kind (0 solid, 1 dashed, 2 dotted)
    @location(4) style: vec4f,
    // length of the line at start and end, lift
    @location(5) along: vec3f,
    @location(6) start_color: vec4f,
    @location(7) end_color: vec4f,
}

struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) pixel: vec2f,
    @location(1) @interpolate(flat) ends: vec4f,
    // directions of the segments before and after, unit length, or 0 at a free end
    @location(2) @interpolate(flat) neighbours: vec4f,
    @location(3) @interpolate(flat) start_color: vec4f,
    @location(4) @interpolate(flat) end_color: vec4f,
    // half width (pixels), factor on the opacity
    @location(5) @interpolate(flat) pen: vec2f,
    // length at start and end, period, kind
    @location(6) @interpolate(flat) dash: vec4f,
}

fn pixels(clip: vec4f) -> vec2f {
    return (0.5 + 0.5 * clip.xy / clip.w) * pane.metrics.xy;
}

// The point of the way from one to other where the near plane cuts it, or one itself where it is in sight.
fn clipped(one: vec4f, other: vec4f) -> vec4f {
    let near = pane.eye.w;
    if one.w >= near || other.w <= near {
        return one;
    }
    return mix(one, other, (near - one.w) / (other.w - one.w));
}

fn direction(from_pixel: vec2f, to_pixel: vec2f) -> vec2f {
    let way = to_pixel - from_pixel;
    let far = length(way);
    return select(vec2f(0.0), way / max(far, 1e-6), far > 1e-3);
}

// How far a segment reaches beyond its end to the bisector of the corner there: tan of half the bend, and most of a pixel,
// since a pixel whose middle lies before the bisector is wholly this segment's. A free end needs its whole cap. No
// farther: every covered block of pixels is paid for where there is no GPU.
fn overhang(one: vec2f, other: vec2f, reach: f32) -> f32 {
    let bend = abs(one.x * other.y - one.y * other.x) / max(1.0 + dot(one, other), 1e-3);
    let free = dot(one, one) < 0.5 || dot(other, other) < 0.5;
    return select(min(bend * reach + 0.8, reach), reach, free);
}

fn corner(segment: Segment, index: u32, hidden: bool) -> Corner {
    let whole_start = pane.clip_from_world * vec4f(segment.start, 1.0);
    let whole_end = pane.clip_from_world * vec4f(segment.end, 1.0);
    let start = clipped(whole_start, whole_end);
    let end = clipped(whole_end, whole_start);
    let before = clipped(pane.clip_from_world * vec4f(segment.before, 1.0), start);
    let after = clipped(pane.clip_from_world * vec4f(segment.after, 1.0), end);
    let p = pixels(start);
    let q = pixels(end);

    let wide = segment.style.x * pane.metrics.z;
    // Thinner than a pixel is drawn as a fainter pixel.
    let half_width = 0.5 * max(wide, 1.0);
    var out: Corner;
    out.pen = vec2f(half_width, min(wide, 1.0) * select(1.0, segment.style.y, hidden));
    let forward = direction(p, q);
    let tangent = select(vec2f(1.0, 0.0), forward, dot(forward, forward) > 0.5);
    let side = vec2f(-tangent.y, tangent.x);
    let reach = half_width + 1.0;
    let at = quad_corner(index);
    out.neighbours = vec4f(direction(pixels(before), p), direction(q, pixels(after)));
    let behind = overhang(out.neighbours.xy, tangent, reach);
    let beyond = select(behind, overhang(tangent, out.neighbours.zw, reach), at.x > 0.5);
    let pixel = select(p - tangent * beyond, q + tangent * beyond, at.x > 0.5) + side * reach * (2.0 * at.y - 1.0);
    let depth = mix(start.z / start.w, end.z / end.w, at.x);
    out.clip = vec4f(2.0 * pixel / pane.metrics.xy - 1.0, min(depth * (1.0 + segment.along.z), 1.0), 1.0);
    if whole_start.w < pane.eye.w && whole_end.w < pane.eye.w || out.pen.y <= 0.0 {
        out.clip = vec4f(2.0, 2.0, 0.0, 1.0);
    }
    out.pixel = pixel;
    out.ends = vec4f(p, q);
    out.start_color = segment.start_color;
    out.end_color = segment.end_color;
    out.dash = vec4f(segment.along.xy, segment.style.zw);
    return out;
}

@vertex
fn vertex_seen(segment: Segment, @builtin(vertex_index) index: u32) -> Corner {
    return corner(segment, index, false);
}

@vertex
fn vertex_hidden(segment: Segment, @builtin(vertex_index) index: u32) -> Corner {
    return corner(segment, index, true);
}

@fragment
fn fragment(in: Corner) -> @location(0) vec4f {
    let p = in.ends.xy;
    let q = in.ends.zw;
    let way = q - p;
    let squared = dot(way, way);
    let part = clamp(dot(in.pixel - p, way) / max(squared, 1e-12), 0.0, 1.0);
    let forward = direction(p, q);
    // Beyond a bisector the neighbour draws. A half-open test, so that exactly one of the two does.
    let before = in.neighbours.xy;
    let after = in.neighbours.zw;
    if dot(before, before) > 0.5 && dot(in.pixel - p, before + forward) < 0.0 {
        discard;
    }
    if dot(after, after) > 0.5 && dot(in.pixel - q, forward + after) >= 0.0 {
        discard;
    }
    var away = distance(in.pixel, p + part * way);
    let period = in.dash.z;
    if in.dash.w > 0.5 {
        // The distance to the nearest dash's middle line, in pixels.
        let per_pixel = max((in.dash.y - in.dash.x) / max(sqrt(squared), 1e-6), 1e-9);
        let across = abs(dot(in.pixel - p, vec2f(-forward.y, forward.x)));
        let phase = mix(in.dash.x, in.dash.y, part);
        let from_middle = abs(phase - (floor(phase / period) + 0.5) * period) / per_pixel;
        let half_dash = select(0.0, 0.25 * period / per_pixel - in.pen.x * 0.5, in.dash.w < 1.5);
        away = length(vec2f(max(from_middle - half_dash, 0.0), across));
    }
    let coverage = clamp(in.pen.x - away + 0.5, 0.0, 1.0);
    if coverage <= 0.0 {
        discard;
    }
    let color = mix(in.start_color, in.end_color, part);
    let opacity = color.a * coverage * in.pen.y;
    return vec4f(color.rgb * opacity, opacity);
}
