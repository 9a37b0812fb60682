//! What is laid over the surfaces: lines, marks and texts, each a quad with the same few numbers in one buffer, drawn family by family.
//! Surfaces hide it by the depths that they left, and not by the device's own test: what is seen faintly through them is
//! drawn by the same pipeline.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use glam::{Vec2, Vec3, Vec4};

use super::buffer::{FrameBuffer, QuadBuffer, stride};
use super::gpu::Gpu;
use super::part::Part;
use super::pipeline::{Lazy, Recipe};
use crate::frame::Color;

/// `Quad` of shaders/overlay.wgsl, once for each corner.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct QuadData {
    pub(super) position: [f32; 3],
    /// Ends of a line; centre of a mark and the direction of its first axis; corner of a glyph in the picture and in the atlas.
    pub(super) place: [f32; 4],
    /// Normals of a line's bisectors, the two straight measures of a mark.
    pub(super) form: [f32; 4],
    /// Of a line: length at both ends, period of its dashes, half width. Of a mark: its two extents, its fold, half its stroke.
    pub(super) measures: [f32; 4],
    /// Kind, factor on the opacity where it is hidden, width of a mark's rim.
    pub(super) style: [f32; 3],
    pub(super) color: [f32; 4],
    pub(super) other_color: [f32; 4],
}

/// `View` of shaders/overlay.wgsl.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
pub(super) struct ViewUniform {
    pub(super) ndc_from_pixel: Vec4,
    pub(super) corner: Vec4,
    pub(super) strength: Vec4,
}

/// What a quad is drawn as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum Kind {
    /// An unbroken line.
    Solid,
    /// A dashed one.
    Dashed,
    /// A dotted one.
    Dotted,
    /// A ball; all that follow are no lines.
    Disc,
    /// A mark of constant distance from its centre.
    Round,
    /// A mark measured by |x| and y.
    Upright,
    /// A mark measured by |x| and |y|.
    Upset,
    /// A mark measured by the larger and the smaller of |x| and |y|.
    Fourfold,
    /// A glyph.
    Text,
}

/// The names of the kinds in the shader, by their places in [`Kind`].
const KINDS: [(Kind, &str); 9] = [
    (Kind::Solid, "SOLID"),
    (Kind::Dashed, "DASHED"),
    (Kind::Dotted, "DOTTED"),
    (Kind::Disc, "DISC"),
    (Kind::Round, "ROUND"),
    (Kind::Upright, "UPRIGHT"),
    (Kind::Upset, "UPSET"),
    (Kind::Fourfold, "FOURFOLD"),
    (Kind::Text, "TEXT"),
];

/// What one shader draws. Each has its own: where there is no GPU every pixel pays for all that a shader tells apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub(super) enum Family {
    Strokes,
    /// Marks and glyphs.
    Signs,
}

impl Family {
    /// That of a quad, of which this is a corner.
    fn of(corner: &QuadData) -> Self {
        let kind = corner.style[0];
        if kind < f32::from(Kind::Disc as u8) { Self::Strokes } else { Self::Signs }
    }

    /// The entry of its shader.
    fn entry(self) -> &'static str {
        match self {
            Self::Strokes => "strokes",
            Self::Signs => "signs",
        }
    }
}

/// The shaders of all families, after what they have in common and the numbers of the kinds, which they name.
pub(super) fn source() -> String {
    let numbers = KINDS.iter().map(|(kind, name)| format!("const {name} = {}.0;\n", *kind as u8));
    let shaders = [
        include_str!("../../shaders/overlay.wgsl"),
        include_str!("../../shaders/strokes.wgsl"),
        include_str!("../../shaders/signs.wgsl"),
    ];
    numbers.collect::<String>() + &shaders.concat()
}

/// Quads one after the other that one shader draws.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Run {
    family: Family,
    quads: Range<u32>,
}

/// What the quads with these numbers are, of which all corners are given, in their order.
pub(super) fn runs(corners: &[QuadData], quads: Range<u32>) -> Vec<Run> {
    let mut runs: Vec<Run> = vec![];
    for number in quads {
        let family = Family::of(&corners[4 * number as usize]);
        match runs.last_mut() {
            Some(run) if run.family == family => run.quads.end = number + 1,
            _ => runs.push(Run { family, quads: number..number + 1 }),
        }
    }
    runs
}

/// All that one quad is, but for its corners.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quad {
    pub(super) kind: Kind,
    pub(super) place: [Vec2; 2],
    pub(super) form: [Vec2; 2],
    pub(super) measures: [f32; 4],
    /// Factor on the opacity where a surface hides it.
    pub(super) hidden: f32,
    pub(super) rim: f32,
    pub(super) colors: [Color; 2],
}

impl Quad {
    /// Its four corners, each with all that the quad is.
    pub(super) fn at(&self, corners: [Vec3; 4]) -> [QuadData; 4] {
        let pair = |[a, b]: [Vec2; 2]| [a.x, a.y, b.x, b.y];
        let one = QuadData {
            position: [0.0; 3],
            place: pair(self.place),
            form: pair(self.form),
            measures: self.measures,
            style: [f32::from(self.kind as u8), self.hidden, self.rim],
            color: self.colors[0].0,
            other_color: self.colors[1].0,
        };
        corners.map(|position| QuadData { position: position.to_array(), ..one })
    }

    /// The corners of a rectangle of the picture at a depth.
    pub(super) fn rectangle(low: Vec2, high: Vec2, depth: f32) -> [Vec3; 4] {
        [low, Vec2::new(high.x, low.y), Vec2::new(low.x, high.y), high].map(|corner| corner.extend(depth))
    }
}

/// Brings quads (their corners) into an order in which those come first of which this is true of the middle; else they stay as they are.
pub(super) fn put_first(corners: &mut [QuadData], is_first: impl Fn(Vec3) -> bool) {
    let middle = |quad: &[QuadData]| quad.iter().map(|corner| Vec3::from_array(corner.position)).sum::<Vec3>() * 0.25;
    let (mut first, mut rest): (Vec<QuadData>, Vec<QuadData>) = (vec![], vec![]);
    for quad in corners.chunks_exact(4) {
        let place = if is_first(middle(quad)) { &mut first } else { &mut rest };
        place.extend_from_slice(quad);
    }
    first.append(&mut rest);
    corners[..first.len()].copy_from_slice(&first);
}

/// What of the quads is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shown {
    /// What a surface is before, at its own fainter strength.
    Hidden,
    /// What no surface is before.
    Seen,
    /// Both at once, each at its own strength: what is behind comes first by the order of the quads.
    Sorted,
    /// What no surface is before as yet, at the strength of what is hidden: a wall is still to come before it.
    Inside,
}

const ALL_SHOWN: [Shown; 4] = [Shown::Hidden, Shown::Seen, Shown::Sorted, Shown::Inside];

/// Draws the quads of a frame.
pub(super) struct Overlays {
    module: Option<wgpu::ShaderModule>,
    /// By the places of their families.
    pipelines: [Lazy; 2],
    layout: wgpu::BindGroupLayout,
    views: FrameBuffer,
    stride: usize,
    group: Option<wgpu::BindGroup>,
    quads: QuadBuffer,
}

impl Overlays {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let device = &gpu.device;
        let entry = |binding, visibility, ty| wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None };
        let texture = wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable: false },
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        };
        let uniform = wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: true,
            min_binding_size: std::num::NonZeroU64::new(size_of::<ViewUniform>() as u64),
        };
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("overlay"),
            entries: &[
                entry(0, wgpu::ShaderStages::VERTEX_FRAGMENT, uniform),
                entry(1, wgpu::ShaderStages::FRAGMENT, texture),
                entry(2, wgpu::ShaderStages::FRAGMENT, texture),
            ],
        });
        Self {
            module: None,
            pipelines: Default::default(),
            layout,
            views: FrameBuffer::new("overlay view", wgpu::BufferUsages::UNIFORM),
            stride: stride(device, size_of::<ViewUniform>()),
            group: None,
            quads: QuadBuffer::new("overlay quads"),
        }
    }

    /// Takes the corners of all quads, those of each quad one after the other, and makes what their runs are drawn by.
    pub(super) fn upload<'a>(&mut self, gpu: &Gpu, corners: &[QuadData], runs: impl Iterator<Item = &'a Run>) {
        self.quads.write(&gpu.device, &gpu.queue, corners);
        for run in runs {
            let module = self.module.get_or_insert_with(|| {
                gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
                    label: Some("overlay"),
                    source: wgpu::ShaderSource::Wgsl(source().into()),
                })
            });
            self.pipelines[run.family as usize].want(true, || pipeline_of(gpu, module, &self.layout, run.family));
        }
    }

    /// Turns to a part of a picture, with the depths that its surfaces left there.
    pub(super) fn turn_to(
        &mut self,
        (device, queue): (&wgpu::Device, &wgpu::Queue),
        part: Part,
        depths: &wgpu::TextureView,
        atlas: &wgpu::TextureView,
        is_new: bool,
    ) {
        let (corner, size) = (part.corner(), part.extent());
        let scale = Vec2::new(2.0, -2.0) / size;
        let offset = Vec2::new(-1.0, 1.0) - corner * scale;
        let mut bytes = vec![0; self.stride * ALL_SHOWN.len()];
        for (slot, shown) in bytes.chunks_exact_mut(self.stride).zip(ALL_SHOWN) {
            let view = ViewUniform {
                ndc_from_pixel: Vec4::new(scale.x, scale.y, offset.x, offset.y),
                corner: Vec4::new(corner.x, corner.y, 0.0, 0.0),
                strength: match shown {
                    Shown::Hidden => Vec4::X,
                    Shown::Seen => Vec4::Y,
                    Shown::Sorted => Vec4::X + Vec4::Y,
                    Shown::Inside => Vec4::Z,
                },
            };
            slot[..size_of::<ViewUniform>()].copy_from_slice(bytemuck::bytes_of(&view));
        }
        let replaced = self.views.write(device, queue, &bytes);
        let Some(buffer) = self.views.get().filter(|_| replaced || is_new || self.group.is_none()) else { return };
        let entry = |binding, resource| wgpu::BindGroupEntry { binding, resource };
        let views =
            wgpu::BufferBinding { buffer, offset: 0, size: std::num::NonZeroU64::new(size_of::<ViewUniform>() as u64) };
        self.group = Some(device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("overlay"),
            layout: &self.layout,
            entries: &[
                entry(0, wgpu::BindingResource::Buffer(views)),
                entry(1, wgpu::BindingResource::TextureView(depths)),
                entry(2, wgpu::BindingResource::TextureView(atlas)),
            ],
        }));
    }

    /// Makes ready for draws in this pass; false where there is nothing to draw.
    pub(super) fn begin(&self, pass: &mut wgpu::RenderPass<'_>) -> bool {
        self.quads.bind(pass)
    }

    /// Draws these quads.
    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, runs: &[Run], shown: Shown) {
        for run in runs {
            if self.pipelines[run.family as usize].set(pass) {
                pass.set_bind_group(0, self.group.as_ref(), &[(self.stride * shown as usize) as u32]);
                QuadBuffer::draw(pass, run.quads.clone());
            }
        }
    }
}

fn pipeline_of(
    gpu: &Gpu,
    module: &wgpu::ShaderModule,
    layout: &wgpu::BindGroupLayout,
    family: Family,
) -> wgpu::RenderPipeline {
    let attributes = wgpu::vertex_attr_array![
        0 => Float32x3, 1 => Float32x4, 2 => Float32x4, 3 => Float32x4, 4 => Float32x3, 5 => Float32x4, 6 => Float32x4
    ];
    Recipe {
        buffer: Some(wgpu::VertexBufferLayout {
            array_stride: size_of::<QuadData>() as u64,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &attributes,
        }),
        groups: &[layout],
        fragment: family.entry(),
        ..Recipe::new(family.entry(), module)
    }
    .pipeline(gpu)
}

#[cfg(test)]
mod tests {
    use super::{Family, Kind, Quad, QuadData, put_first, runs};
    use crate::frame::Color;
    use glam::Vec2;

    fn quad(kind: Kind, depth: f32) -> [QuadData; 4] {
        let place = [Vec2::ZERO; 2];
        let colors = [Color::hex(0); 2];
        let quad = Quad { kind, place, form: place, measures: [0.0; 4], hidden: 0.0, rim: 0.0, colors };
        quad.at(Quad::rectangle(Vec2::ZERO, Vec2::ONE, depth))
    }

    #[test]
    fn each_run_is_of_one_shader_and_all_are_in_their_order() {
        let kinds = [Kind::Disc, Kind::Solid, Kind::Dotted, Kind::Disc, Kind::Text, Kind::Fourfold, Kind::Dashed];
        let corners: Vec<QuadData> = kinds.into_iter().flat_map(|kind| quad(kind, 0.5)).collect();
        let found: Vec<_> = runs(&corners, 1..7).into_iter().map(|run| (run.family, run.quads)).collect();
        assert_eq!(found, [(Family::Strokes, 1..3), (Family::Signs, 3..6), (Family::Strokes, 6..7)]);
        assert!(runs(&corners, 3..3).is_empty());
    }

    #[test]
    fn what_comes_first_and_the_rest_stay_as_they_are_among_themselves() {
        let depths = [0.75, 0.25, 0.5, 0.125];
        let mut corners: Vec<QuadData> = depths.into_iter().flat_map(|depth| quad(Kind::Solid, depth)).collect();
        put_first(&mut corners, |middle| middle.z < 0.5 && middle.truncate() == Vec2::splat(0.5));
        let depths: Vec<f32> = corners.chunks_exact(4).map(|quad| quad[0].position[2]).collect();
        assert_eq!(depths, [0.25, 0.125, 0.75, 0.5]);
    }
}
