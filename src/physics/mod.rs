//! The physics, pure f64: no clock, no input or output, no picture.
//!
//! Conventions: `R = world_from_body`; body angular velocity `Ω`, world `ω = RΩ`; body momentum `M = IΩ`, world
//! momentum `L = RM`, constant; energy `K = ½ M·I⁻¹M`. SI units and radians.

pub mod batch;
pub mod body;
pub mod bounds;
mod double_double;
mod dyadic;
pub mod elliptic;
pub mod exact;
pub mod methods;
pub mod motion;
mod number;
mod orbit;
pub mod period;
pub mod poinsot;
mod principal;
pub mod so3;
pub mod solids;
mod start;

pub use batch::Batch;
pub use body::{Body, BodyError};
pub use exact::Motion;
pub use methods::{Integration, METHODS, Method, MethodError, method};
pub use motion::State;
pub use number::number;
pub use poinsot::MotionClass;
