//! The running simulation: its clock, the body under its method, and the same start under others beside it.

mod checkpoints;
mod clock;
mod cloud;
mod flips;
mod history;
mod simulation;
mod slowing;
#[cfg(test)]
mod tests;

pub use clock::{Clock, Tick};
pub use cloud::Cloud;
pub use flips::FlipWatch;
pub use history::{Errors, History, Sample};
pub use simulation::{Runner, Simulation};
pub use slowing::Slowing;
