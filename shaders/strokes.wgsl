// Lines: a quad a segment.

struct Corner {
    @builtin(position) clip: vec4f,
    // both ends (pixels of the part of the picture that is drawn)
    @location(0) @interpolate(flat) ends: vec4f,
    @location(1) @interpolate(flat) bisectors: vec4f,
    // unit vector from one end to the other, their distance, half the width
    @location(2) @interpolate(flat) way: vec4f,
    // periods of the dashes before the segment, of a pixel; pixels of a period (0 where there are none) and of half a dash's straight part
    @location(3) @interpolate(flat) dashes: vec4f,
    @location(4) @interpolate(flat) strengths: vec2f,
    @location(5) @interpolate(flat) color: vec4f,
    @location(6) @interpolate(flat) other_color: vec4f,
}

@vertex
fn vertex(quad: Quad) -> Corner {
    let ends = quad.place - view.corner.xyxy;
    let long = max(distance(ends.xy, ends.zw), 1e-6);
    let half_width = quad.measures.w;
    let way = vec4f((ends.zw - ends.xy) / long, long, half_width);
    let kind = quad.style.x;
    let period = quad.measures.z;
    let per_pixel = max((quad.measures.y - quad.measures.x) / long, 1e-9);
    let half_dash = select(0.0, 0.25 * period / per_pixel - half_width * 0.5, kind == DASHED);
    let dashes = vec4f(quad.measures.x / period, per_pixel / period, select(period / per_pixel, 0.0, kind == SOLID), half_dash);
    return Corner(placed(quad), ends, quad.form, way, dashes, strengths(quad), quad.color, quad.other_color);
}

@fragment
fn fragment(in: Corner) -> @location(0) vec4f {
    let from_start = in.clip.xy - in.ends.xy;
    let from_end = in.clip.xy - in.ends.zw;
    let long = in.way.z;
    let half_width = in.way.w;
    let along = dot(from_start, in.way.xy);
    let across = in.way.x * from_start.y - in.way.y * from_start.x;
    let on_way = clamp(along, 0.0, long);
    // Beyond a bisector the neighbour draws. A half-open test, so that exactly one of the two does; a free end has none.
    let is_cut = dot(from_start, in.bisectors.xy) < 0.0
        || (dot(from_end, in.bisectors.zw) >= 0.0 && any(in.bisectors.zw != vec2f(0.0)));
    // The distance to the nearest dash's middle line.
    let phase = in.dashes.x + on_way * in.dashes.y;
    let from_dash = max(abs(phase - floor(phase) - 0.5) * in.dashes.z - in.dashes.w, 0.0);
    let beyond = select(from_dash, along - on_way, in.dashes.z == 0.0);
    let cover = select(clamp(half_width - length(vec2f(beyond, across)) + 0.5, 0.0, 1.0), 0.0, is_cut);
    let color = mix(in.color, in.other_color, on_way / long);
    return vec4f(color.rgb, 1.0) * (color.a * cover * strength(in.clip, in.strengths));
}
