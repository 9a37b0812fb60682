//! The running simulation: its clock, the body under its method, and the same start under others beside it.

mod clock;
mod simulation;

pub use clock::{Clock, Tick};
pub use simulation::{Runner, Simulation};
