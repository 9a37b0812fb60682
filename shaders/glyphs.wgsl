// Glyphs of the atlas.

struct Corner {
    @builtin(position) clip: vec4f,
    // where in the atlas, less where in the part of the picture that is drawn (texels)
    @location(0) @interpolate(flat) shift: vec2f,
    @location(1) @interpolate(flat) strengths: vec2f,
    @location(2) @interpolate(flat) color: vec4f,
}

@vertex
fn vertex(quad: Quad) -> Corner {
    let shift = quad.place.zw - quad.place.xy + view.corner.xy;
    return Corner(placed(quad), shift, strengths(quad), quad.color);
}

@fragment
fn fragment(in: Corner) -> @location(0) vec4f {
    let cover = textureLoad(atlas, vec2i(in.clip.xy + in.shift), 0).r;
    return vec4f(in.color.rgb, 1.0) * (in.color.a * cover * strength(in.clip, in.strengths));
}
