//! Every method that advances the body, in one table.
//!
//! A method is one file in this folder and one row of [`METHODS`]; the window's list, the command line's names, the
//! report, every figure's colours and marks, and the tests all read that table.

mod backward_euler;
mod buss;
mod clamped_gyroscopic;
mod closed_form;
mod exact_step;
mod forward_euler;
mod free_momentum;
mod implicit_gyroscopic;
mod implicit_midpoint;
mod integration;
mod lie_euler;
mod lie_group;
mod linear;
mod magnus4;
mod moser_veselov;
mod rk4;
mod sign;

use glam::{DMat3, DVec3};

use super::start::Start;

pub(crate) use exact_step::{Increment, ShortIncrement, StepRotation, can_step};
pub use integration::{Integration, MethodError};
pub use sign::{Dash, Hue, Mark};

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

/// What a solver is started with: a body at its start, in its principal frame there.
///
/// Units are powers of two near the body's own inertia and momentum, so that all numbers are near 1 at any scale.
#[derive(Clone, Copy, Debug)]
pub struct Problem {
    /// Principal moments, ascending.
    pub moments: DVec3,
    /// Momentum in the principal frame.
    pub momentum: DVec3,
    /// The same before rounding.
    pub(crate) start: Start,
    /// Energy lost inside the body, as [`Integration::with_energy_loss`] has it; 0 for none.
    pub energy_loss: f64,
}

/// Why a solver could not take its steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The equation of an implicit step was not solved.
    NotSolved,
    /// The state grew past the range of f64.
    Overflow,
}

/// The solver a method runs on, in the principal frame of the body at the start, in the units of its [`Problem`].
///
/// All its quantities are relative to the start: `attitude` begins at the identity, so world components are
/// the principal components of the start, and the world momentum is the momentum it was started with.
pub trait Stepper: Send {
    /// Takes `count` steps of length `step`, which may be negative.
    ///
    /// # Errors
    /// A step that cannot be solved, or a state that is no longer finite; the state is then what it was before the call.
    fn advance(&mut self, step: f64, count: u64) -> Result<(), Failure>;

    /// Attitude relative to the start: takes principal components now to principal components of the start.
    fn attitude(&self) -> DMat3;

    /// Momentum in the principal frame.
    fn momentum(&self) -> DVec3;

    /// Both at once, for those that need the one for the other.
    fn now(&self) -> (DMat3, DVec3) {
        (self.attitude(), self.momentum())
    }

    /// The frame that takes the place of the principal one in what it says, where that is another: a rotation that never changes.
    fn principal_from_own(&self) -> DMat3 {
        DMat3::IDENTITY
    }

    /// Attitude and momentum at a time from the start, of a method that needs no steps to get there.
    fn directly(&self, _time: f64) -> Option<(DMat3, DVec3)> {
        None
    }

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
    /// Whether it goes to any time at once, with no steps between.
    pub is_direct: bool,
    /// What a step costs, in words.
    pub cost: &'static str,
    /// Where the method is published.
    pub source: &'static str,
    /// Its colour in every figure: no other method's.
    pub hue: Hue,
    /// The pattern of its lines.
    pub dash: Dash,
    /// Its mark. No other method has this mark and this pattern both, so that figures can be read without colours.
    pub mark: Mark,
    /// Starts a solver.
    pub start: fn(&Problem) -> Box<dyn Stepper>,
}

impl Method {
    /// The name for people without what is said of it after a comma.
    #[must_use]
    pub fn short_label(&self) -> &'static str {
        self.label.split(',').next().unwrap_or(self.label)
    }
}

/// A method is its row in the table, and rows differ by name.
impl PartialEq for Method {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Method {}

/// The methods, in the order in which lists show them: those of the lectures and the exact ones, then what engines do, as contrast.
pub static METHODS: &[Method] = &[
    forward_euler::METHOD,
    backward_euler::METHOD,
    rk4::METHOD,
    lie_euler::METHOD,
    buss::METHOD,
    magnus4::METHOD,
    moser_veselov::METHOD,
    exact_step::METHOD,
    closed_form::METHOD,
    implicit_midpoint::METHOD,
    implicit_gyroscopic::METHOD,
    clamped_gyroscopic::METHOD,
];

/// The method a scene has that names none.
pub const DEFAULT_METHOD: &str = "exact-step";

/// The method that knows energy loss. All others follow a body that loses none, and so do the exact motion and all that is predicted from it.
pub const LOSS_METHOD: &str = "magnus4";

/// Looks a method up by its name.
#[must_use]
pub fn method(name: &str) -> Option<&'static Method> {
    METHODS.iter().find(|method| method.name == name)
}
