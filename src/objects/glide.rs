//! A picture on its way from one view of a scene to another: what comes or goes is faded, and the border between the two spaces
//! moves.

use super::{Object, Space, is_shown};
use crate::frame::{Area, Color, Pane, Quadric};
use crate::scene::{self, Layout};
use glam::Vec2;

/// Least share of the picture that a space is drawn in.
const LEAST: f32 = 0.03;

/// From where a picture comes, and how far it has got to the scene's own view.
#[derive(Clone, Copy, Debug)]
pub struct Glide<'a> {
    /// The view that it comes from.
    pub from: &'a scene::View,
    /// How far it has come, from 0 to 1.
    pub part: f32,
}

impl Glide<'_> {
    /// How strongly an object is drawn on the way to a view.
    pub(super) fn weight(&self, object: &Object, to: &scene::View) -> f32 {
        match (is_shown(object, self.from), is_shown(object, to)) {
            (true, true) => 1.0,
            (false, true) => self.part,
            (true, false) => 1.0 - self.part,
            (false, false) => 0.0,
        }
    }

    /// The spaces shown on the way to a layout, and their parts of a picture of this aspect.
    pub(super) fn areas(&self, to: Layout, aspect: f32) -> Vec<(Space, Area)> {
        let share = |layout| match layout {
            Layout::World => 1.0,
            Layout::Both => 0.5,
            Layout::Body => 0.0,
        };
        let share = share(self.from.layout) + (share(to) - share(self.from.layout)) * self.part;
        let area = |from: f32, to: f32| {
            let along = if aspect >= 1.0 { Vec2::X } else { Vec2::Y };
            Area { corner: along * from, extent: Vec2::ONE + along * (to - from - 1.0) }
        };
        let spaces = [(Space::World, 0.0, share), (Space::Momentum, share, 1.0)];
        let wide = spaces.into_iter().filter(|(_, from, to)| to - from > LEAST);
        wide.map(|(space, from, to)| (space, area(from, to))).collect()
    }
}

/// How much a pane holds, so that what is added to it can be told apart.
pub(super) struct Held {
    meshes: usize,
    quadrics: usize,
    is_open: bool,
    lines: usize,
    dots: usize,
    markers: usize,
    labels: usize,
    notes: usize,
}

impl Held {
    /// By this pane now.
    pub(super) fn by(pane: &Pane) -> Self {
        Self {
            meshes: pane.meshes.len(),
            quadrics: pane.quadrics.len(),
            is_open: pane.quadrics.iter().any(|pair| pair.is_open),
            lines: pane.lines.len(),
            dots: pane.dots.len(),
            markers: pane.markers.len(),
            labels: pane.labels.len(),
            notes: pane.notes.len(),
        }
    }

    /// Draws all that was added to the pane since only this strongly.
    pub(super) fn fade_since(&self, pane: &mut Pane, weight: f32) {
        let fade = |color: &mut Color| *color = color.fade(weight);
        for mesh in pane.meshes.iter_mut().skip(self.meshes) {
            mesh.opaque = false;
            mesh.vertices.iter_mut().for_each(|vertex| fade(&mut vertex.color));
        }
        for (index, pair) in pane.quadrics.iter_mut().enumerate() {
            let fade = |quadric: &mut Quadric| quadric.color = quadric.color.fade(weight);
            if index >= self.quadrics {
                fade(&mut pair.first);
            }
            // One that waited for a second has it now.
            if index >= self.quadrics || (self.is_open && !pair.is_open) {
                pair.second.iter_mut().for_each(fade);
            }
        }
        for line in pane.lines.iter_mut().skip(self.lines) {
            line.points.iter_mut().for_each(|point| fade(&mut point.color));
        }
        pane.dots.iter_mut().skip(self.dots).for_each(|dot| fade(&mut dot.color));
        for marker in pane.markers.iter_mut().skip(self.markers) {
            fade(&mut marker.color);
            fade(&mut marker.rim);
        }
        pane.labels.iter_mut().skip(self.labels).for_each(|label| fade(&mut label.color));
        for note in pane.notes.iter_mut().skip(self.notes) {
            fade(&mut note.color);
            if let Some(swatch) = &mut note.swatch {
                fade(&mut swatch.color);
                fade(&mut swatch.rim);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Glide;
    use crate::objects::{Cameras, areas, build_frame, build_frame_on_the_way};
    use crate::scene::{Scene, SceneError, SceneFile};
    use crate::sim::Simulation;

    #[test]
    fn a_picture_glides_from_one_view_to_the_other() -> Result<(), SceneError> {
        let from = Scene::check(&SceneFile::parse("view = { layout = 'world', hide = ['all'], show = ['body'] }")?)?;
        let to = Scene::check(&SceneFile::default())?;
        let (simulation, cameras) = (Simulation::new(&to), Cameras::new(&to.view));
        let frame = |part| {
            let glide = Glide { from: &from.view, part };
            build_frame_on_the_way(&to, &simulation, &cameras, 1.5, 1.0, Some(glide))
        };
        assert_eq!(frame(1.0), build_frame(&to, &simulation, &cameras, 1.5));
        // At the beginning all that comes is there and not seen; the body is as it was.
        let first = frame(0.0);
        assert_eq!(first.panes.len(), 1);
        let strongest =
            |labels: &[crate::frame::Label]| labels.iter().map(|label| label.color.0[3]).fold(0.0, f32::max);
        assert!(!first.panes[0].labels.is_empty() && strongest(&first.panes[0].labels) == 0.0);
        assert!(first.panes[0].meshes.iter().any(|mesh| mesh.opaque && !mesh.vertices.is_empty()));
        let half = frame(0.5);
        assert!((half.panes[0].area.extent.x - 0.75).abs() < 1e-6 && (half.panes[1].area.corner.x - 0.75).abs() < 1e-6);
        assert!((strongest(&half.panes[0].labels) - 0.5).abs() < 1e-6);
        // Both surfaces are half as strong, although they are one pair.
        let whole = frame(1.0);
        for (half, whole) in half.panes[1].quadrics.iter().zip(&whole.panes[1].quadrics) {
            assert!((half.first.color.0[3] - 0.5 * whole.first.color.0[3]).abs() < 1e-6);
            let second = |pair: &crate::frame::QuadricPair| pair.second.map(|quadric| quadric.color.0[3]);
            assert_eq!(second(half).map(|strength| 2.0 * strength), second(whole));
        }
        // The dots of a cloud likewise.
        let without = Scene::check(&SceneFile::default())?;
        let with = Scene::check(&SceneFile::parse("view = { show = ['cloud'] }\ncloud = { count = 3 }")?)?;
        let simulation = Simulation::new(&with);
        let glide = Some(Glide { from: &without.view, part: 0.25 });
        let frame = build_frame_on_the_way(&with, &simulation, &cameras, 1.5, 1.0, glide);
        assert_eq!(frame.panes[1].dots.iter().map(|dot| dot.color.0[3]).collect::<Vec<_>>(), [0.25; 3]);
        let still = Glide { from: &to.view, part: 0.3 };
        for aspect in [0.5, 1.5] {
            assert_eq!(still.areas(to.view.layout, aspect), areas(to.view.layout, aspect));
        }
        Ok(())
    }
}
