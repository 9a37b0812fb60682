//! Every method that advances the body, in one table.
//!
//! A method is one file in this folder and one row of [`METHODS`]; the window's list, the command line's names, the
//! report, the colours and the tests all read that table.

mod buss;
mod integration;
mod lie_euler;
mod lie_group;

use glam::{DMat3, DVec3};

pub use integration::{Integration, MethodError};

/// Order of accuracy: the attitude error at a fixed time falls as `step^order`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Error `O(step^p)`.
    Finite(u32),
    /// No error of method at any step: rounding alone.
    Exact,
}

/// What a method keeps of an invariant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keeps {
    /// Up to rounding, at any step.
    Exactly,
    /// The error stays bounded for all time: the method follows a nearby invariant exactly.
    Nearby,
    /// The error grows with time.
    No,
}

/// The solver a method runs on, in the principal frame of the body at the start.
///
/// All its quantities are relative to the start: `attitude` begins at the identity, so world components are
/// the principal components of the start, and the world momentum is the momentum it was started with.
pub trait Stepper: Send {
    /// Takes `count` steps of length `step` (s), which may be negative.
    ///
    /// # Errors
    /// A step that cannot be solved, or a state that is no longer finite; the state is then the last good one.
    fn advance(&mut self, step: f64, count: u64) -> Result<(), MethodError>;

    /// Attitude relative to the start: takes principal components now to principal components of the start.
    fn attitude(&self) -> DMat3;

    /// Momentum in the principal frame (kg m²/s).
    fn momentum(&self) -> DVec3;

    /// A copy that runs on its own.
    fn duplicate(&self) -> Box<dyn Stepper>;
}

/// A row of the table: a method and its claims, which the tests read and hold it to.
#[derive(Debug)]
pub struct Method {
    /// Name on the command line, in files and in the report.
    pub name: &'static str,
    /// Name for people.
    pub label: &'static str,
    /// Claimed order.
    pub order: Order,
    /// Whether a step needs no equation solved.
    pub explicit: bool,
    /// Whether a step preserves the symplectic form.
    pub symplectic: bool,
    /// Whether the world momentum `L` is kept.
    pub keeps_momentum: Keeps,
    /// Whether the attitude stays in SO(3).
    pub keeps_rotation: Keeps,
    /// Whether the energy is kept.
    pub keeps_energy: Keeps,
    /// What a step costs, in words.
    pub cost: &'static str,
    /// Where the method is published.
    pub source: &'static str,
    /// Starts a solver from principal moments (kg m², ascending) and the momentum in the principal frame.
    pub start: fn(moments: DVec3, momentum: DVec3) -> Box<dyn Stepper>,
}

/// The methods, in the order in which lists show them.
pub static METHODS: &[Method] = &[lie_euler::METHOD, buss::METHOD];

/// The method a scene has that names none.
pub const DEFAULT_METHOD: &str = "buss";

/// Looks a method up by its name.
#[must_use]
pub fn method(name: &str) -> Option<&'static Method> {
    METHODS.iter().find(|method| method.name == name)
}
