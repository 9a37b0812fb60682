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
    Momentum,
}

impl Space {
    /// How far before its place a line is tested against the surfaces of this space. On the round ones of momentum space a flat
    /// stroke dips in near the outline; no thin body is there for it to shine through.
    pub(super) fn lift(self) -> f32 {
        match self {
            Self::World => 0.005,
            Self::Momentum => 0.014,
        }
    }
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
        Layout::Body => vec![(Space::Momentum, Area::WHOLE)],
        Layout::Both if aspect >= 1.0 => vec![(Space::World, half(0.0, 0.0)), (Space::Momentum, half(0.5, 0.0))],
        Layout::Both => vec![(Space::World, half(0.0, 0.0)), (Space::Momentum, half(0.0, 0.5))],
    }
}

/// Distances that frame everything.
const WORLD_DISTANCE: f32 = 6.6;
const MOMENTUM_DISTANCE: f32 = 6.7;

/// A camera as a scene sets it (see [`scene::View::world_camera`]), where this distance frames everything.
fn set(setting: [f64; 6], distance: f32) -> Camera {
    let [azimuth_deg, elevation_deg, factor, x, y, z] = setting.map(|value| value as f32);
    let camera = Camera::new(azimuth_deg.to_radians(), elevation_deg.to_radians(), factor * distance);
    Camera { target: Vec3::new(x, y, z), ..camera }
}

/// What sets a camera as it is: the opposite of [`set`], to a hundredth of a pixel.
fn setting(camera: &Camera, distance: f32) -> [f64; 6] {
    let Vec3 { x, y, z } = camera.target;
    let exact = [camera.azimuth.to_degrees(), camera.elevation.to_degrees(), camera.distance / distance, x, y, z];
    exact.map(|value| (f64::from(value) * 1e4).round() / 1e4)
}

/// The cameras of both spaces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cameras {
    /// Of the world.
    pub world: Camera,
    /// Of momentum space.
    pub momentum: Camera,
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
        let usual = Self {
            world: camera(-60.0, 16.0, WORLD_DISTANCE, Vec3::new(0.0, 0.0, 0.12)),
            momentum: camera(54.0, 22.0, MOMENTUM_DISTANCE, Vec3::new(0.0, 0.0, 0.19)),
        };
        Self {
            world: view.world_camera.map_or(usual.world, |setting| set(setting, WORLD_DISTANCE)),
            momentum: view.body_camera.map_or(usual.momentum, |setting| set(setting, MOMENTUM_DISTANCE)),
        }
    }

    /// Writes into a view's settings what makes these cameras of it, where it has others.
    pub fn write(&self, view: &scene::View, file: &mut scene::ViewFile) {
        let before = Self::new(view);
        if self.world != before.world {
            file.world_camera = Some(setting(&self.world, WORLD_DISTANCE));
        }
        if self.momentum != before.momentum {
            file.body_camera = Some(setting(&self.momentum, MOMENTUM_DISTANCE));
        }
    }

    /// The camera of one space.
    #[must_use]
    pub fn of(&self, space: Space) -> &Camera {
        match space {
            Space::World => &self.world,
            Space::Momentum => &self.momentum,
        }
    }

    /// The camera of one space, to be moved.
    pub fn of_mut(&mut self, space: Space) -> &mut Camera {
        match space {
            Space::World => &mut self.world,
            Space::Momentum => &mut self.momentum,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Cameras;
    use crate::scene::{Scene, SceneError, SceneFile};
    use glam::Vec2;

    #[test]
    fn moved_cameras_are_written_and_come_back() -> Result<(), SceneError> {
        let mut file = SceneFile::default();
        let view = Scene::check(&file)?.view;
        let mut cameras = Cameras::new(&view);
        cameras.write(&view, &mut file.view);
        assert_eq!(file, SceneFile::default());
        cameras.world.orbit(Vec2::new(0.3, -0.1));
        cameras.momentum.pan(Vec2::new(0.1, 0.2));
        cameras.momentum.zoom(2.0);
        cameras.write(&view, &mut file.view);
        let back = Cameras::new(&Scene::check(&file)?.view);
        for (one, other) in [(cameras.world, back.world), (cameras.momentum, back.momentum)] {
            // Four decimals are written: of degrees, and of lengths about 1 to 6 times as large.
            assert!(one.eye().distance(other.eye()) < 1e-3 && one.target.distance(other.target) < 1e-4);
        }
        Ok(())
    }
}
