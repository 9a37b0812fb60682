//! The structs that the shaders read, held against the shaders themselves: every field at its offset.

use std::mem::offset_of;

use wgpu::naga;

use super::line::SegmentData;
use super::point::MarkData;
use super::quadrics::{PairUniform, QuadricData};
use super::solid::VertexData;
use super::text::GlyphData;
use super::view::ViewUniform;

const VIEW: &str = include_str!("../../shaders/view.wgsl");

fn module(source: &str) -> naga::Module {
    naga::front::wgsl::parse_str(&[VIEW, source].concat()).unwrap_or_default()
}

/// Names and offsets of a struct of the shader, and its size.
fn members(module: &naga::Module, name: &str) -> (Vec<(String, usize)>, usize) {
    for (_, ty) in module.types.iter() {
        if let (Some(found), naga::TypeInner::Struct { members, span }) = (&ty.name, &ty.inner)
            && found == name
        {
            let list = members
                .iter()
                .map(|member| (member.name.clone().unwrap_or_default(), member.offset as usize))
                .collect();
            return (list, *span as usize);
        }
    }
    (vec![], 0)
}

macro_rules! same_layout {
    ($module:expr, $name:literal, $type:ty, $($field:ident),+) => {
        let expected = vec![$((stringify!($field).to_owned(), offset_of!($type, $field))),+];
        assert_eq!(members($module, $name), (expected, size_of::<$type>()), $name);
    };
}

#[test]
fn uniforms_match_the_shaders() {
    let quadrics = module(include_str!("../../shaders/quadrics.wgsl"));
    same_layout!(
        &quadrics,
        "View",
        ViewUniform,
        clip_from_world,
        ray_right,
        ray_up,
        ray_forward,
        eye,
        key_light,
        fill_light,
        metrics
    );
    same_layout!(&quadrics, "Quadric", QuadricData, unit_from_world, color);
    same_layout!(&quadrics, "Pair", PairUniform, first, second, choice);
}

/// The number of floats that a shader reads a corner: its located inputs, in order and without a gap.
fn floats_read(source: &str) -> usize {
    let module = module(source);
    let Some(entry) = module.entry_points.iter().find(|entry| entry.stage == naga::ShaderStage::Vertex) else {
        return 0;
    };
    let mut read = 0;
    for argument in &entry.function.arguments {
        let types = match &module.types[argument.ty].inner {
            naga::TypeInner::Struct { members, .. } => members.iter().map(|member| member.ty).collect(),
            _ if matches!(argument.binding, Some(naga::Binding::Location { .. })) => vec![argument.ty],
            _ => vec![],
        };
        for ty in types {
            read += match module.types[ty].inner {
                naga::TypeInner::Vector { size, .. } => size as usize,
                _ => 1,
            };
        }
    }
    read
}

#[test]
fn vertices_hold_what_the_shaders_read() {
    assert_eq!(floats_read(include_str!("../../shaders/solid.wgsl")) * 4, size_of::<VertexData>());
    assert_eq!(floats_read(include_str!("../../shaders/line.wgsl")) * 4, size_of::<SegmentData>());
    assert_eq!(floats_read(&super::point::source()) * 4, size_of::<MarkData>());
    assert_eq!(floats_read(include_str!("../../shaders/text.wgsl")) * 4, size_of::<GlyphData>());
}
