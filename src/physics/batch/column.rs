//! Numbers of several bodies side by side.
#![allow(clippy::inline_always, reason = "what is not inlined has not the instructions of its caller")]

use fearless_simd::prelude::*;

/// Bodies in a group: the most that a register holds on any processor.
pub(super) const GROUP: usize = 8;

/// One number of each body of a group, where no register's worth of them lies across two lines of the cache.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Column(pub(super) [f64; GROUP]);

impl Column {
    pub(super) const ZERO: Self = Self([0.0; GROUP]);
    pub(super) const ONE: Self = Self([1.0; GROUP]);
}

/// Puts the numbers of a body in its lane.
pub(super) fn set<const N: usize>(columns: &mut [Column; N], lane: usize, values: [f64; N]) {
    for (column, value) in columns.iter_mut().zip(values) {
        column.0[lane] = value;
    }
}

/// The numbers of a body.
pub(super) fn get<const N: usize>(columns: &[Column; N], lane: usize) -> [f64; N] {
    columns.each_ref().map(|column| column.0[lane])
}

/// The numbers of some bodies.
#[inline(always)]
pub(super) fn load<S: Simd>(simd: S, column: &Column, lane: usize) -> S::f64s {
    S::f64s::from_slice(simd, &column.0[lane..lane + S::f64s::LEN])
}

/// Puts back the numbers of some bodies.
#[inline(always)]
pub(super) fn store<S: Simd>(value: S::f64s, column: &mut Column, lane: usize) {
    value.store_slice(&mut column.0[lane..lane + S::f64s::LEN]);
}
