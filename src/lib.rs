//! See, teach and measure how a free rigid body turns: the Dzhanibekov effect (tennis-racket theorem).
pub mod physics;
pub mod scene;
pub mod sim;
