// Texts: a quad a glyph, its coverage read from the atlas; first the halos of all, then the ink.
struct Glyph {
    // low corner and extent on the screen (pixels of the view, y down)
    @location(0) place: vec4f,
    // low corner in the atlas (pixels), radius of the halo (pixels, 0 for ink)
    @location(1) source: vec3f,
    @location(2) color: vec4f,
}

@group(1) @binding(0) var atlas: texture_2d<f32>;
@group(1) @binding(1) var nearest_texel: sampler;

struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) texel: vec2f,
    @location(1) @interpolate(flat) box: vec4f,
    @location(2) @interpolate(flat) halo: f32,
    @location(3) @interpolate(flat) color: vec4f,
}

@vertex
fn vertex(glyph: Glyph, @builtin(vertex_index) index: u32) -> Corner {
    let halo = glyph.source.z;
    let at = quad_corner(index) * (glyph.place.zw + 2.0 * halo) - halo;
    let pixel = glyph.place.xy + at;
    let ndc = vec2f(2.0, -2.0) * pixel / pane.metrics.xy + vec2f(-1.0, 1.0);
    let box = vec4f(glyph.source.xy, glyph.source.xy + glyph.place.zw);
    return Corner(vec4f(ndc, 1.0, 1.0), glyph.source.xy + at, box, halo, glyph.color);
}

fn coverage(texel: vec2f, box: vec4f) -> f32 {
    let inside = all(texel > box.xy) && all(texel < box.zw);
    let size = vec2f(textureDimensions(atlas));
    let value = textureSampleLevel(atlas, nearest_texel, texel / size, 0.0).r;
    return select(0.0, value, inside);
}

@fragment
fn fragment(in: Corner) -> @location(0) vec4f {
    var cover = coverage(in.texel, in.box);
    if in.halo > 0.0 {
        for (var i = 0; i < 8; i += 1) {
            let angle = f32(i) * 0.7854;
            let away = vec2f(cos(angle), sin(angle)) * in.halo;
            cover = max(cover, 0.6 * coverage(in.texel + away, in.box));
            cover = max(cover, coverage(in.texel + 0.6 * away, in.box));
        }
    }
    let opacity = cover * in.color.a;
    if opacity <= 0.0 {
        discard;
    }
    return vec4f(in.color.rgb * opacity, opacity);
}
