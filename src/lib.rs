//! See, teach and measure how a free rigid body turns: the Dzhanibekov effect (tennis-racket theorem).
//!
//! # A tour
//!
//! A [`physics::Body`] has a moment of inertia; a [`physics::State`] says how it lies and spins. The motion is known in
//! closed form, so any moment can be gone to at once:
//!
//! ```
//! use dzhanibekov::glam::{DMat3, DVec3};
//! use dzhanibekov::physics::{Body, Motion, State, poinsot};
//!
//! fn main() -> Result<(), dzhanibekov::physics::BodyError> {
//!     // A box with three different edges, spun about its middle axis with a small tilt towards axis 3.
//!     let body = Body::solid_box(DVec3::new(0.20, 0.12, 0.04), 1.0)?;
//!     let start = State::new(&body, DMat3::IDENTITY, DVec3::new(0.0, 6.0, 0.01));
//!     let motion = Motion::new(&body, &start);
//!
//!     // It turns over: half a period after the first flip its middle axis points the other way round L.
//!     let period = poinsot::flip_period_of(&body, &start).expect("it flips");
//!     let first = poinsot::next_flip_of(&body, &start).expect("it flips");
//!     assert!(motion.momentum(first + 0.5 * period).y < -0.99 * start.body_momentum.y);
//!
//!     // A year later costs what a second later costs, and keeps the energy.
//!     let later = motion.state(3.15e7);
//!     assert!((later.energy(&body) / start.energy(&body) - 1.0).abs() < 1e-14);
//!     Ok(())
//! }
//! ```
//!
//! The methods that step from moment to moment are rows of one table, [`physics::METHODS`]; each row states what its
//! method keeps, and the tests hold it to that. An [`physics::Integration`] is a method at work:
//!
//! ```
//! use dzhanibekov::glam::{DMat3, DVec3};
//! use dzhanibekov::physics::{Body, Integration, Motion, State, method, so3};
//!
//! fn main() -> Result<(), Box<dyn std::error::Error>> {
//!     let body = Body::from_moments(DVec3::new(0.5, 0.85, 1.0))?;
//!     let start = State::new(&body, DMat3::IDENTITY, DVec3::new(0.4, 1.0, 0.4));
//!     let exact = Motion::new(&body, &start).attitude(10.0);
//!
//!     // Buss' second-order method: half the step, a quarter of the error.
//!     let error = |step| {
//!         let buss = method("buss").expect("it is in the table");
//!         let mut integration = Integration::new(buss, &body, start, step);
//!         integration.state_at(10.0).map(|state| so3::angle_between(state.world_from_body, exact))
//!     };
//!     let (coarse, fine) = (error(0.01)?, error(0.005)?);
//!     assert!((coarse / fine - 4.0).abs() < 0.4);
//!     Ok(())
//! }
//! ```
//!
//! Many bodies at a time are a [`physics::Batch`].
//!
//! A [`scene`] is the same thing in words, read from TOML and checked; a [`sim::Simulation`] sets it in motion:
//!
//! ```
//! use dzhanibekov::scene::{Scene, preset};
//! use dzhanibekov::sim::Simulation;
//!
//! fn main() -> Result<(), dzhanibekov::scene::SceneError> {
//!     let scene = Scene::check(&preset("flip")?.read()?)?;
//!     let mut simulation = Simulation::new(&scene);
//!     simulation.step(1000);
//!     assert_eq!(simulation.time(), 1.0);
//!     assert!(simulation.momentum_error() < 1e-14);
//!     Ok(())
//! }
//! ```
//!
//! # Rooms
//!
//! | room | what lives there | feature |
//! |---|---|---|
//! | [`physics`] | rotations, bodies, the exact motion, methods, Poinsot's geometry: pure f64 | – |
//! | [`scene`] | what a scene says: read, checked, written as text, flags and links; the presets | – |
//! | [`sim`] | the clock, the running simulation, its history | – |
//! | `files` | what people name is read and written | `files` |
//! | `objects`, `frame`, `camera` | what is drawn | `picture` |
//! | `render` | how it is drawn, by wgpu | `picture` |
//! | `vector` | a picture as lines and texts: SVG, PDF | `headless` |
//! | `headless` | pictures and films with no window | `headless` |
//! | `report` | speed against error, measured | `report` |
//! | `session` | the state behind any front end: a scene's text and what follows from it | `ui` |
//! | `ui` | the panels: they read, and return commands | `ui` |
//! | `stage` | panels and picture on a screen: what window and page do alike | `stage` |
//! | `app` | the window | `window` |
//! | `web` | the page | `web` |
//!
//! Data flows one way, from a scene to the simulation to objects to a frame to the picture. Without default features
//! the library is the first three rooms.

/// The vectors and matrices of this crate's functions: its own version of [glam](https://docs.rs/glam).
pub use glam;

#[cfg(feature = "window")]
pub mod app;
#[cfg(feature = "picture")]
pub mod camera;
#[cfg(feature = "files")]
pub mod files;
#[cfg(feature = "picture")]
pub mod frame;
#[cfg(feature = "headless")]
pub mod headless;
#[cfg(feature = "picture")]
pub mod objects;
pub mod physics;
#[cfg(feature = "picture")]
pub mod render;
#[cfg(feature = "report")]
pub mod report;
pub mod scene;
#[cfg(feature = "ui")]
pub mod session;
pub mod sim;
#[cfg(feature = "stage")]
pub mod stage;
#[cfg(feature = "picture")]
pub mod typeface;
#[cfg(feature = "ui")]
pub mod ui;
#[cfg(feature = "headless")]
pub mod vector;
#[cfg(feature = "web")]
pub mod web;
