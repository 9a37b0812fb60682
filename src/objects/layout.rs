//! Which part of the picture shows which space, and from where.

use glam::{Vec2, Vec3};

use crate::camera::Camera;
use crate::frame::Area;
use crate::scene::{self, Layout};

/// The two spaces a picture can show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Space {
    /// The world, the angular momentum up.
    World,
    /// Momentum space in the body's principal axes.
    Body,
}

/// The spaces shown and their parts of a picture of this aspect: side by side, one above the other where it is tall.
#[must_use]
pub fn areas(layout: Layout, aspect: f32) -> Vec<(Space, Area)> {
    let half = |x: f32, y: f32| {
        let extent = if aspect >= 1.0 { Vec2::new(0.5, 1.0) } else { Vec2::new(1.0, 0.5) };
        Area { corner: Vec2::new(x, y), extent }
    };
    match layout {
        Layout::World => vec![(Space::World, Area::WHOLE)],
        Layout::Body => vec![(Space::Body, Area::WHOLE)],
        Layout::Both if aspect >= 1.0 => vec![(Space::World, half(0.0, 0.0)), (Space::Body, half(0.5, 0.0))],
        Layout::Both => vec![(Space::World, half(0.0, 0.0)), (Space::Body, half(0.0, 0.5))],
    }
}

/// The cameras of both spaces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cameras {
    /// Of the world.
    pub world: Camera,
    /// Of momentum space.
    pub body: Camera,
}

impl Cameras {
    /// As a scene sets them; the distance is a factor on the one that frames everything.
    #[must_use]
    pub fn new(view: &scene::View) -> Self {
        let camera = |azimuth_deg: f32, elevation_deg: f32, distance: f32, target: Vec3| {
            let azimuth = view.azimuth_deg.map_or(azimuth_deg, |given| given as f32).to_radians();
            let elevation = view.elevation_deg.map_or(elevation_deg, |given| given as f32).to_radians();
            let distance = view.distance.map_or(1.0, |given| given as f32) * distance;
            Camera { target, ..Camera::new(azimuth, elevation, distance) }
        };
        Self { world: camera(-60.0, 16.0, 5.85, Vec3::new(0.0, 0.0, 0.06)), body: camera(54.0, 22.0, 6.3, Vec3::ZERO) }
    }

    /// The camera of one space.
    #[must_use]
    pub fn of(&self, space: Space) -> &Camera {
        match space {
            Space::World => &self.world,
            Space::Body => &self.body,
        }
    }

    /// The camera of one space, to be moved.
    pub fn of_mut(&mut self, space: Space) -> &mut Camera {
        match space {
            Space::World => &mut self.world,
            Space::Body => &mut self.body,
        }
    }
}
