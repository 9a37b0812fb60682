// Lines: a quad a segment.
@fragment
fn strokes(in: Corner) -> @location(0) vec4f {
    let from_start = in.clip.xy - in.place.xy;
    let from_end = in.clip.xy - in.place.zw;
    let way = in.measures.xy;
    let long = in.measures.z;
    let half_width = in.measures.w;
    let along = dot(from_start, way);
    let across = way.x * from_start.y - way.y * from_start.x;
    let on_way = clamp(along, 0.0, long);
    // Beyond a bisector the neighbour draws. A half-open test, so that exactly one of the two does; a free end has none.
    let is_cut = dot(from_start, in.form.xy) < 0.0
        || (dot(from_end, in.form.zw) >= 0.0 && any(in.form.zw != vec2f(0.0)));
    // The distance to the nearest dash's middle line, or dot's middle.
    let per_pixel = abs(in.style.y);
    let period = 1.0 / per_pixel;
    let half_dash = select(0.0, 0.25 * period - 0.5 * half_width, in.style.y > 0.0);
    let phase = in.style.x + on_way * per_pixel;
    let from_dash = max(abs(phase - floor(phase) - 0.5) * period - half_dash, 0.0);
    let beyond = select(from_dash, along - on_way, in.style.y == 0.0);
    let cover = select(clamp(half_width - length(vec2f(beyond, across)) + 0.5, 0.0, 1.0), 0.0, is_cut);
    let color = mix(in.color, in.other_color, on_way / long);
    return vec4f(color.rgb, 1.0) * (color.a * cover * strength(in));
}
