//! See, teach and measure how a free rigid body turns: the Dzhanibekov effect (tennis-racket theorem).
#[cfg(feature = "picture")]
pub mod camera;
#[cfg(feature = "picture")]
pub mod frame;
#[cfg(feature = "picture")]
pub mod headless;
#[cfg(feature = "picture")]
pub mod objects;
pub mod physics;
#[cfg(feature = "picture")]
pub mod render;
#[cfg(feature = "report")]
pub mod report;
pub mod scene;
pub mod sim;
