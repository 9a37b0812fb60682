//! A block of bodies as columns of numbers, and the exact step on it.
#![allow(clippy::inline_always, reason = "what is not inlined has not the instructions of its caller")]

use fearless_simd::prelude::*;

use super::column::{Column, GROUP, get, load, set, store};
use crate::physics::methods::{Increment, ShortIncrement, StepRotation};

/// Groups that take each step in turn: enough of them that none waits for the divisions and roots of another, and few enough for
/// the nearest cache.
const GROUPS: usize = 4;

/// Bodies in a block.
pub(super) const BLOCK: usize = GROUP * GROUPS;

/// Bodies all of whose steps are short, or none's. See [`crate::physics::methods`] for the step; the increments are those of one step
/// here.
#[derive(Clone, Debug)]
pub(super) struct Block {
    is_short: bool,
    groups: Box<[Group; GROUPS]>,
}

/// A body that is not there stands still.
#[derive(Clone, Copy, Debug)]
struct Group {
    /// Halfway through the next step: cn, sn, dn, and what the sums left out of the first two.
    functions: [Column; 3],
    functions_rest: [Column; 2],
    /// x, y, z, w, of any length, and what the sums left out.
    attitude: [Column; 4],
    attitude_rest: [Column; 4],
    /// `p₀ − 1`, `p₁, p₂, p₃`.
    rotation: [Column; 4],
    /// Short: sn, sn dn, k² sn², 1 − cn, 1 − cn dn, k², k′². Others: cn, sn, cn dn, sn dn, cn², sn², dn², k′² sn², k², k′².
    increment: [Column; 10],
}

/// The columns of [`Group::increment`] that are 1 where nothing is added.
const ONES_OF_SHORT: [usize; 1] = [6];
const ONES_OF_OTHERS: [usize; 5] = [0, 2, 4, 6, 9];

impl Block {
    /// An empty one for bodies whose steps are short, or for the others.
    pub(super) fn new(is_short: bool) -> Self {
        let (zero, one) = (Column::ZERO, Column::ONE);
        let mut increment = [zero; 10];
        for place in if is_short { ONES_OF_SHORT.as_slice() } else { &ONES_OF_OTHERS } {
            increment[*place] = one;
        }
        let group = Group {
            functions: [one, zero, one],
            functions_rest: [zero; 2],
            attitude: [zero, zero, zero, one],
            attitude_rest: [zero; 4],
            rotation: [zero; 4],
            increment,
        };
        Self { is_short, groups: Box::new([group; GROUPS]) }
    }

    /// Puts a body in a place: its functions halfway through the next step, its attitude and its step.
    pub(super) fn put(&mut self, place: usize, functions: [f64; 3], attitude: Attitude, rotation: &StepRotation) {
        let (group, lane) = (&mut self.groups[place / GROUP], place % GROUP);
        set(&mut group.functions, lane, functions);
        set(&mut group.attitude, lane, attitude.value);
        set(&mut group.attitude_rest, lane, attitude.rest);
        let w = rotation.weights;
        set(&mut group.rotation, lane, [rotation.scalar, w.x, w.y, w.z]);
    }

    /// What a short step adds to a body's phase.
    pub(super) fn put_short(&mut self, place: usize, i: &ShortIncrement) {
        let values = [i.sn, i.sn_dn, i.squared, i.beyond_cn, i.beyond_cn_dn, i.k2, i.k1_2, 0.0, 0.0, 0.0];
        set(&mut self.groups[place / GROUP].increment, place % GROUP, values);
    }

    /// What any other step adds.
    pub(super) fn put_long(&mut self, place: usize, i: &Increment) {
        let values = [i.cn, i.sn, i.cn_dn, i.sn_dn, i.cn_squared, i.sn_squared, i.dn_squared, i.least, i.k2, i.k1_2];
        set(&mut self.groups[place / GROUP].increment, place % GROUP, values);
    }

    /// A body's `[cn, sn, dn]` halfway through the next step.
    pub(super) fn functions(&self, place: usize) -> [f64; 3] {
        get(&self.groups[place / GROUP].functions, place % GROUP)
    }

    /// A body's attitude.
    pub(super) fn attitude(&self, place: usize) -> Attitude {
        let (group, lane) = (&self.groups[place / GROUP], place % GROUP);
        Attitude { value: get(&group.attitude, lane), rest: get(&group.attitude_rest, lane) }
    }

    /// Takes steps with all bodies of the block.
    #[inline(always)]
    pub(super) fn advance<S: Simd>(&mut self, simd: S, steps: u32) {
        for _ in 0..steps {
            for group in self.groups.iter_mut() {
                for lane in (0..GROUP).step_by(S::f64s::LEN) {
                    turn(simd, lane, group);
                    if self.is_short {
                        add_short(simd, lane, group);
                    } else {
                        add(simd, lane, group);
                    }
                }
            }
        }
    }

    /// Brings the attitudes back to a length near 1 by powers of two, which round nothing.
    #[inline(always)]
    pub(super) fn restore_length(&mut self) {
        for group in self.groups.iter_mut() {
            for lane in 0..GROUP {
                let largest = group.attitude.iter().fold(0.0, |largest: f64, column| largest.max(column.0[lane].abs()));
                // The power of two at or below it.
                let scale = 1.0 / f64::from_bits(largest.to_bits() & 0x7ff0_0000_0000_0000);
                for column in group.attitude.iter_mut().chain(&mut group.attitude_rest) {
                    column.0[lane] *= scale;
                }
            }
        }
    }
}

/// The components x, y, z, w of a quaternion as sums of two numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Attitude {
    pub(super) value: [f64; 4],
    pub(super) rest: [f64; 4],
}

/// `q ← q F` as `q + q(F − 1)`.
#[inline(always)]
fn turn<S: Simd>(simd: S, lane: usize, group: &mut Group) {
    let Group { functions, rotation, attitude, attitude_rest, .. } = group;
    let scalar = load(simd, &rotation[0], lane);
    let x = load(simd, &rotation[1], lane) * load(simd, &functions[0], lane);
    let y = load(simd, &rotation[2], lane) * load(simd, &functions[1], lane);
    let z = load(simd, &rotation[3], lane) * load(simd, &functions[2], lane);
    let [qx, qy, qz, qw] = attitude.each_ref().map(|column| load(simd, column, lane));
    let [rx, ry, rz, rw] = attitude_rest.each_ref().map(|column| load(simd, column, lane));
    let changes = [
        qw.mul_add(x, qx.mul_add(scalar, rx)) + qy.mul_sub(z, qz * y),
        qw.mul_add(y, qy.mul_add(scalar, ry)) + qz.mul_sub(x, qx * z),
        qw.mul_add(z, qz.mul_add(scalar, rz)) + qx.mul_sub(y, qy * x),
        (-qx).mul_add(x, qw.mul_add(scalar, rw)) - qy.mul_add(y, qz * z),
    ];
    for (i, (old, change)) in [qx, qy, qz, qw].into_iter().zip(changes).enumerate() {
        let sum = old + change;
        store::<S>(change - (sum - old), &mut attitude_rest[i], lane);
        store::<S>(sum, &mut attitude[i], lane);
    }
}

/// [`ShortIncrement`]: the changes of cn and sn, their circle to first order, and what the sums leave out.
#[inline(always)]
fn add_short<S: Simd>(simd: S, lane: usize, group: &mut Group) {
    let Group { functions, functions_rest, increment, .. } = group;
    let one = S::f64s::splat(simd, 1.0);
    let [c, s, d] = functions.each_ref().map(|column| load(simd, column, lane));
    let [cn_rest, sn_rest] = functions_rest.each_ref().map(|column| load(simd, column, lane));
    let [sn, sn_dn, squared, beyond_cn, beyond_cn_dn, k2, k1_2, ..] =
        increment.each_ref().map(|column| load(simd, column, lane));
    let common = squared * (s * s);
    let inverse = one / (one - common);
    let cn_change = c.mul_sub(common - beyond_cn, (s * d) * sn_dn).mul_add(inverse, cn_rest);
    let sn_change = s.mul_add(common - beyond_cn_dn, (c * d) * sn).mul_add(inverse, sn_rest);
    let (cosine, sine) = (c + cn_change, s + sn_change);
    let beyond = (-cosine).mul_add(cosine, (-sine).mul_add(sine, one)) * 0.5;
    let (cn_change, sn_change) = (cosine.mul_add(beyond, cn_change), sine.mul_add(beyond, sn_change));
    let (cosine, sine) = (c + cn_change, s + sn_change);
    store::<S>(cn_change - (cosine - c), &mut functions_rest[0], lane);
    store::<S>(sn_change - (sine - s), &mut functions_rest[1], lane);
    store::<S>(cosine, &mut functions[0], lane);
    store::<S>(sine, &mut functions[1], lane);
    store::<S>(k2.mul_add(cosine * cosine, k1_2).sqrt(), &mut functions[2], lane);
}

/// [`Increment::add`].
#[inline(always)]
fn add<S: Simd>(simd: S, lane: usize, group: &mut Group) {
    let Group { functions, increment, .. } = group;
    let one = S::f64s::splat(simd, 1.0);
    let [c, s, d] = functions.each_ref().map(|column| load(simd, column, lane));
    let [cn, sn, cn_dn, sn_dn, cn_squared, sn_squared, dn_squared, least, k2, k1_2] =
        increment.each_ref().map(|column| load(simd, column, lane));
    let denominator = sn_squared.mul_add(d * d, cn_squared);
    let inverse = one / denominator;
    let (minuend, subtrahend) = (c * cn, (s * d) * sn_dn);
    let square = c * c;
    let (sum, rest) = (minuend + subtrahend, minuend - subtrahend);
    let is_better = (sum * sum).simd_ge(denominator * square.mul_add(dn_squared, least));
    let is_quotient = sum.abs().simd_gt(rest.abs()) & is_better;
    // Where both are 0 the quotient is not taken.
    let difference = square.mul_sub(dn_squared, least);
    let cosine = is_quotient.select(difference / is_quotient.select(sum, one), rest * inverse);
    let sine = s.mul_add(cn_dn, (c * d) * sn) * inverse;
    let beyond = (-cosine).mul_add(cosine, (-sine).mul_add(sine, one)) * 0.5;
    let (cosine, sine) = (cosine.mul_add(beyond, cosine), sine.mul_add(beyond, sine));
    store::<S>(cosine, &mut functions[0], lane);
    store::<S>(sine, &mut functions[1], lane);
    store::<S>(k2.mul_add(cosine * cosine, k1_2).sqrt(), &mut functions[2], lane);
}
