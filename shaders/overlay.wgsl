// Lines, marks and texts: quads laid over the surfaces, their edges smooth by what each covers of a pixel. One shader for all, since
// each is compiled anew where there is no GPU. What a quad holds is told in src/render/overlay.rs.

struct View {
    // Takes pixels of the picture to normalised device coordinates: scale, offset.
    ndc_from_pixel: vec4f,
    // xy: the upper left corner of the part of the picture that is drawn
    corner: vec4f,
    // Factors on the opacity: x where a surface is before it (times its own for that), y where none is, z where none is (times that too).
    strength: vec4f,
}

@group(0) @binding(0) var<uniform> view: View;
@group(0) @binding(1) var depths: texture_2d<f32>;
@group(0) @binding(2) var atlas: texture_2d<f32>;

struct Quad {
    // pixels of the picture, depth
    @location(0) position: vec3f,
    @location(1) place: vec4f,
    @location(2) form: vec4f,
    @location(3) measures: vec4f,
    // kind, opacity where hidden, width of a rim
    @location(4) style: vec3f,
    @location(5) color: vec4f,
    @location(6) other_color: vec4f,
}

struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) @interpolate(flat) place: vec4f,
    @location(1) @interpolate(flat) form: vec4f,
    @location(2) @interpolate(flat) measures: vec4f,
    // kind, width of a rim, opacity where something is before it, where nothing is
    @location(3) @interpolate(flat) style: vec4f,
    @location(4) @interpolate(flat) color: vec4f,
    @location(5) @interpolate(flat) other_color: vec4f,
}

@vertex
fn vertex(quad: Quad) -> Corner {
    let behind = view.strength.x * quad.style.y;
    let before = view.strength.y + view.strength.z * quad.style.y;
    let ndc = quad.position.xy * view.ndc_from_pixel.xy + view.ndc_from_pixel.zw;
    // What would not be seen lies outside.
    let clip = vec4f(select(vec2f(2.0), ndc, max(behind, before) > 0.0), quad.position.z, 1.0);
    let style = vec4f(quad.style.xz, behind, before);
    return Corner(clip, quad.place, quad.form, quad.measures, style, quad.color, quad.other_color);
}

// Where along a segment a pixel lies (0 to 1), and how much of it the line covers.
fn line(pixel: vec2f, in: Corner) -> vec2f {
    let start = in.place.xy;
    let end = in.place.zw;
    let way = end - start;
    let squared = max(dot(way, way), 1e-12);
    let part = clamp(dot(pixel - start, way) / squared, 0.0, 1.0);
    // Beyond a bisector the neighbour draws. A half-open test, so that exactly one of the two does.
    let bisectors = in.form;
    let is_cut = dot(pixel - start, bisectors.xy) < 0.0
        || (dot(pixel - end, bisectors.zw) >= 0.0 && any(bisectors.zw != vec2f(0.0)));
    let half_width = in.measures.w;
    let nearest = pixel - (start + part * way);
    // The distance to the nearest dash's middle line.
    let long = sqrt(squared);
    let per_pixel = max((in.measures.y - in.measures.x) / long, 1e-9);
    let period = in.measures.z;
    let across = (way.x * (pixel.y - start.y) - way.y * (pixel.x - start.x)) / long;
    let phase = mix(in.measures.x, in.measures.y, part);
    let from_middle = abs(phase - (floor(phase / period) + 0.5) * period) / per_pixel;
    let half_dash = select(0.0, 0.25 * period / per_pixel - half_width * 0.5, in.style.x == DASHED);
    let from_dash = vec2f(max(from_middle - half_dash, 0.0), across);
    let away = length(select(from_dash, nearest, in.style.x == SOLID));
    return vec2f(part, select(clamp(half_width - away + 0.5, 0.0, 1.0), 0.0, is_cut));
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
    let pixel = in.clip.xy + view.corner.xy;
    let kind = in.style.x;
    let is_behind = textureLoad(depths, vec2i(in.clip.xy), 0).r > in.clip.z;
    let strength = select(in.style.w, in.style.z, is_behind);

    let drawn = line(pixel, in);
    let color = mix(in.color, in.other_color, drawn.x);
    let stroke = vec4f(color.rgb, 1.0) * (color.a * drawn.y);

    let from_centre = pixel - in.place.xy;
    let turn = in.place.zw;
    let at = vec2f(dot(from_centre, turn), dot(from_centre, vec2f(turn.y, -turn.x)));
    let away = outline(at, in);
    let inner = clamp(0.5 - away, 0.0, 1.0) * in.color.a;
    let outer = clamp(0.5 + in.style.y - away, 0.0, 1.0) * in.other_color.a;
    // A ball: lighter towards the upper left.
    let high = 1.0 - clamp(length(at / in.measures.x - vec2f(-0.35, 0.35)), 0.0, 1.0);
    let ball = mix(in.color.rgb * (0.82 + 0.3 * high), vec3f(1.0), 0.25 * high * high);
    let paint = select(in.color.rgb, ball, kind == DISC);
    let mark = vec4f(paint * inner, inner) + (1.0 - inner) * vec4f(in.other_color.rgb * outer, outer);

    let cover = textureLoad(atlas, vec2i(from_centre + in.place.zw), 0).r * in.color.a;
    let text = vec4f(in.color.rgb, 1.0) * cover;

    return select(select(stroke, mark, kind >= DISC), text, kind == TEXT) * strength;
}
