// Bodies of triangles, in soft light.
// Flat ones take no light, and shall not be made to wait for it.
override is_lit: bool = true;

struct Corner {
    @builtin(position) clip: vec4f,
    // normal, and its product with the direction to the key light
    @location(0) normal: vec4f,
    // way to the eye, and the product of the normal with the direction to the fill light
    @location(1) to_eye: vec4f,
    @location(2) color: vec4f,
    // strengths of the light, and the product of the way to the eye with the direction to the key light
    @location(3) light: vec4f,
}

@vertex
fn vertex(@location(0) position: vec3f, @location(1) normal: vec3f, @location(2) color: vec4f) -> Corner {
    let clip = pane.clip_from_world * vec4f(position, 1.0);
    let key = pane.key_light.xyz;
    let to_eye = pane.eye.xyz - position;
    return Corner(
        clip,
        vec4f(normal, dot(normal, key)),
        vec4f(to_eye, dot(normal, pane.fill_light.xyz)),
        color,
        vec4f(pane.key_light.w, pane.fill_light.w, pane.metrics.w, dot(to_eye, key)),
    );
}

@fragment
fn fragment(corner: Corner, @builtin(front_facing) front: bool) -> @location(0) vec4f {
    var color = corner.color.rgb;
    let squared = dot(corner.normal.xyz, corner.normal.xyz);
    if is_lit && squared > 0.25 {
        let scale = select(-1.0, 1.0, front) * inverseSqrt(squared);
        let per_way = inverseSqrt(dot(corner.to_eye.xyz, corner.to_eye.xyz));
        let to_key = scale * corner.normal.w;
        let to_eye = scale * per_way * dot(corner.normal.xyz, corner.to_eye.xyz);
        let brightness = light(to_key, scale * corner.to_eye.w, corner.light.xyz);
        color = color * brightness + vec3f(0.06 * gleam(to_key + to_eye, per_way * corner.light.w));
    }
    return vec4f(color * corner.color.a, corner.color.a);
}
