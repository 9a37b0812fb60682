// Bodies of triangles, in soft light.
// Flat ones take no light, and shall not be made to wait for it.
override is_lit: bool = true;

struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) world: vec3f,
    @location(1) normal: vec3f,
    @location(2) color: vec4f,
}

@vertex
fn vertex(@location(0) position: vec3f, @location(1) normal: vec3f, @location(2) color: vec4f) -> Corner {
    return Corner(pane.clip_from_world * vec4f(position, 1.0), position, normal, color);
}

@fragment
fn fragment(corner: Corner, @builtin(front_facing) front: bool) -> @location(0) vec4f {
    var color = corner.color.rgb;
    if is_lit && dot(corner.normal, corner.normal) > 0.25 {
        let to_eye = normalize(pane.eye.xyz - corner.world);
        let normal = normalize(select(-corner.normal, corner.normal, front));
        color = color * light(normal) + vec3f(0.06 * gleam(normal, normalize(pane.key_light.xyz + to_eye)));
    }
    return vec4f(color * corner.color.a, corner.color.a);
}
