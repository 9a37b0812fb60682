// Signs: marks of constant size, each measured by its kind, and the glyphs of texts.

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
fn signs(in: Corner) -> @location(0) vec4f {
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

    let cover = textureLoad(atlas, vec2i(from_centre + in.place.zw), 0).r * in.color.a;
    let glyph = vec4f(in.color.rgb, 1.0) * cover;
    return select(mark, glyph, in.style.x == TEXT) * strength(in);
}
