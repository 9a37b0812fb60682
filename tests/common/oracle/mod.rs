//! An evaluation of the free motion that shares no formula with the crate, in numbers of hundreds of digits: what the closed form and
//! the exact step are held to, for any start that can be written down.
//!
//! Euler's angles about L from Carlson's integrals and Jacobi's functions by the descending Landen transformation, from the exact
//! values of the binary64 numbers given. Nothing is tuned for speed: an evaluation takes about a millisecond.
#![allow(
    dead_code,
    unused_imports,
    clippy::expect_used,
    reason = "each test file uses its own part and fails by its own asserts"
)]

pub(crate) mod carlson;
pub(crate) mod inertia;
pub(crate) mod jacobi;
pub(crate) mod motion;
pub(crate) mod real;
pub(crate) mod taylor;

pub(crate) use inertia::Inertia;
pub(crate) use motion::{Oracle, Spin};
