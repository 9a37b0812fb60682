// Marks of constant size, each measured by its kind.

struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) @interpolate(flat) place: vec4f,
    @location(1) @interpolate(flat) form: vec4f,
    @location(2) @interpolate(flat) measures: vec4f,
    // kind, width of the rim, opacity where something is before it, where nothing is
    @location(3) @interpolate(flat) style: vec4f,
    @location(4) @interpolate(flat) color: vec4f,
    @location(5) @interpolate(flat) other_color: vec4f,
}

@vertex
fn vertex(quad: Quad) -> Corner {
    let style = vec4f(quad.style.xz, strengths(quad));
    let place = vec4f(quad.place.xy - view.corner.xy, quad.place.zw);
    return Corner(placed(quad), place, quad.form, quad.measures, style, quad.color, quad.other_color);
}

// Distance to the outline of a mark, negative inside.
fn outline(at: vec2f, in: Corner) -> f32 {
    let kind = in.style.x;
    let a = abs(vec2f(abs(at.x) - in.measures.z, at.y));
    let sorted = vec2f(max(a.x, a.y), min(a.x, a.y));
    let upright = select(a, vec2f(a.x, at.y), kind == UPRIGHT);
    let v = select(upright, sorted, kind == FOURFOLD);
    let straight = max(dot(v, in.form.xy) - in.measures.x, dot(v, in.form.zw) - in.measures.y);
    let away = select(straight, length(at) - in.measures.x, kind == DISC || kind == ROUND);
    let stroke = in.measures.w;
    return select(away, abs(away) - stroke, stroke > 0.0);
}

@fragment
fn fragment(in: Corner) -> @location(0) vec4f {
    let from_centre = in.clip.xy - in.place.xy;
    let turn = in.place.zw;
    let at = vec2f(dot(from_centre, turn), dot(from_centre, vec2f(turn.y, -turn.x)));
    let away = outline(at, in);
    let inner = clamp(0.5 - away, 0.0, 1.0) * in.color.a;
    let outer = clamp(0.5 + in.style.y - away, 0.0, 1.0) * in.other_color.a;
    // A ball: lighter towards the upper left.
    let high = 1.0 - clamp(length(at / in.measures.x - vec2f(-0.35, 0.35)), 0.0, 1.0);
    let ball = mix(in.color.rgb * (0.82 + 0.3 * high), vec3f(1.0), 0.25 * high * high);
    let paint = select(in.color.rgb, ball, in.style.x == DISC);
    let mark = vec4f(paint * inner, inner) + (1.0 - inner) * vec4f(in.other_color.rgb * outer, outer);
    return mark * strength(in.clip, in.style.zw);
}
