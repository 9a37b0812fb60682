//! The structs that the shaders read, held against the shaders themselves: every field at its offset.

use std::mem::offset_of;

use wgpu::naga;

use super::dots::DotData;
use super::mesh::VertexData;
use super::overlay::{self, QuadData, ViewUniform};
use super::pane::PaneUniform;
use super::quadrics::{PairUniform, QuadricData};
use super::solids::PlacedData;

const PANE: &str = include_str!("../../shaders/pane.wgsl");

fn module(source: &str) -> naga::Module {
    naga::front::wgsl::parse_str(&[PANE, source].concat()).unwrap_or_default()
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
        "Pane",
        PaneUniform,
        clip_from_world,
        ray_right,
        ray_up,
        ray_forward,
        eye,
        key_light,
        fill_light,
        metrics
    );
    same_layout!(&module(&overlay::source()), "View", ViewUniform, ndc_from_pixel, corner, strength);
    same_layout!(&quadrics, "Quadric", QuadricData, unit_from_world, eye, color);
    same_layout!(&quadrics, "Pair", PairUniform, first, second, choice);
}

/// Names and places (bytes) of what a shader reads a corner: its located inputs, in order and without a gap; and their end.
fn inputs(source: &str) -> (Vec<(String, usize)>, usize) {
    let module = module(source);
    let entry = module.entry_points.iter().find(|entry| entry.stage == naga::ShaderStage::Vertex);
    let arguments = entry.map(|entry| &*entry.function.arguments).unwrap_or_default();
    let mut located = vec![];
    for argument in arguments {
        match (&module.types[argument.ty].inner, &argument.binding) {
            (naga::TypeInner::Struct { members, .. }, _) => {
                located.extend(members.iter().map(|member| (&member.name, &member.binding, member.ty)));
            }
            (_, binding) => located.push((&argument.name, binding, argument.ty)),
        }
    }
    let (mut fields, mut end) = (vec![], 0);
    for (name, binding, ty) in located {
        let Some(naga::Binding::Location { location, .. }) = binding else { continue };
        assert_eq!(*location as usize, fields.len(), "{name:?} is out of order");
        fields.push((name.clone().unwrap_or_default(), end));
        end += module.types[ty].inner.size(module.to_ctx()) as usize;
    }
    (fields, end)
}

macro_rules! same_inputs {
    ($source:expr, $type:ty, $($field:ident),+) => {
        let expected = vec![$((stringify!($field).to_owned(), offset_of!($type, $field))),+];
        assert_eq!(inputs($source), (expected, size_of::<$type>()), stringify!($type));
    };
}

#[test]
fn vertices_hold_what_the_shaders_read() {
    same_inputs!(include_str!("../../shaders/mesh.wgsl"), VertexData, position, normal, color);
    // Its colour is of bytes, which the device makes four numbers of.
    let dots = inputs(include_str!("../../shaders/dots.wgsl"));
    let expected =
        vec![("place".to_owned(), offset_of!(DotData, place)), ("color".to_owned(), offset_of!(DotData, color))];
    assert_eq!((dots.0, size_of::<DotData>()), (expected, 16 + 4));
    same_inputs!(&overlay::source(), QuadData, position, place, form, measures, style, color, other_color);
    let solids = [include_str!("../../shaders/solids.wgsl"), include_str!("../../shaders/solids_of_pixels.wgsl")];
    same_inputs!(&solids.concat(), PlacedData, ndc, shift);
}
