//! Which part of the picture shows which space, and from where.

use glam::{DVec3, Vec2, Vec3};

use crate::camera::Camera;
use crate::frame::Area;
use crate::scene::{self, CameraFile, Layout};

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

/// What sets a camera as it is, to a hundredth of a pixel, where this distance frames everything.
fn setting(camera: &Camera, distance: f32) -> CameraFile {
    let rounded = |value: f32| (f64::from(value) * 1e4).round() / 1e4;
    CameraFile {
        azimuth_deg: Some(rounded(camera.azimuth.to_degrees())),
        elevation_deg: Some(rounded(camera.elevation.to_degrees())),
        distance: Some(rounded(camera.distance / distance)),
        target: Some(camera.target.to_array().map(rounded)),
    }
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
        // What is said of one camera goes before what is said of both.
        let camera = |own: &CameraFile, azimuth_deg: f32, elevation_deg: f32, distance: f32, height: f32| {
            let given = |own: Option<f64>, of_both: Option<f64>, usual: f32| {
                own.or(of_both).map_or(usual, |given| given as f32)
            };
            let azimuth = given(own.azimuth_deg, view.azimuth_deg, azimuth_deg).to_radians();
            let elevation = given(own.elevation_deg, view.elevation_deg, elevation_deg).to_radians();
            let distance = given(own.distance, view.distance, 1.0) * distance;
            let target = own.target.map_or(Vec3::new(0.0, 0.0, height), |target| DVec3::from_array(target).as_vec3());
            Camera { target, ..Camera::new(azimuth, elevation, distance) }
        };
        Self {
            world: camera(&view.world_camera, -60.0, 16.0, WORLD_DISTANCE, 0.12),
            momentum: camera(&view.body_camera, 54.0, 22.0, MOMENTUM_DISTANCE, 0.19),
        }
    }

    /// Writes into a view's settings what makes these cameras of it, where it has others.
    pub fn write(&self, view: &scene::View, file: &mut scene::ViewFile) {
        let before = Self::new(view);
        if self.world != before.world {
            file.world_camera = setting(&self.world, WORLD_DISTANCE);
        }
        if self.momentum != before.momentum {
            file.body_camera = setting(&self.momentum, MOMENTUM_DISTANCE);
        }
    }

    /// The cameras this far (0 to 1) on the way from one pair to another.
    #[must_use]
    pub fn between(from: &Self, to: &Self, part: f32) -> Self {
        Self {
            world: Camera::between(&from.world, &to.world, part),
            momentum: Camera::between(&from.momentum, &to.momentum, part),
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
