// Bodies of triangles, in soft light.
// Flat ones take no light, and shall not be made to wait for it.
override is_lit: bool = true;

struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) to_eye: vec3f,
    @location(1) normal: vec3f,
    @location(2) color: vec4f,
    // directions to the lights; w: light from everywhere
    @location(3) @interpolate(flat) key: vec4f,
    @location(4) @interpolate(flat) fill: vec3f,
    // strengths of both lights
    @location(5) @interpolate(flat) strengths: vec2f,
}

@vertex
fn vertex(@location(0) position: vec3f, @location(1) normal: vec3f, @location(2) color: vec4f) -> Corner {
    let clip = pane.clip_from_world * vec4f(position, 1.0);
    let key = vec4f(pane.key_light.xyz, pane.metrics.w);
    let strengths = vec2f(pane.key_light.w, pane.fill_light.w);
    return Corner(clip, pane.eye.xyz - position, normal, color, key, pane.fill_light.xyz, strengths);
}

@fragment
fn fragment(corner: Corner, @builtin(front_facing) front: bool) -> @location(0) vec4f {
    var color = corner.color.rgb;
    if is_lit && dot(corner.normal, corner.normal) > 0.25 {
        let key = corner.key.xyz;
        let normal = normalize(select(-corner.normal, corner.normal, front));
        let brightness = light(dot(normal, key), dot(normal, corner.fill), vec3f(corner.strengths, corner.key.w));
        let half_way = normalize(key + normalize(corner.to_eye));
        color = color * brightness + vec3f(0.06 * gleam(dot(normal, half_way)));
    }
    return vec4f(color * corner.color.a, corner.color.a);
}
