//! The closed form of many motions at one time. See [`crate::physics::exact`] for the formulas.
#![allow(clippy::inline_always, reason = "what is not inlined has not the instructions of its caller")]

use std::f64::consts::TAU;

use fearless_simd::{Level, dispatch, prelude::*};
use glam::{DMat3, DVec3};

use super::Member;
use super::column::{Column, GROUP, get, load, set, store};
use super::functions::{SplitTime, beyond_whole, exponential, halves, phase, sine_and_cosine};
use crate::physics::double_double::DoubleDouble;
use crate::physics::exact::{Path, SeriesNumbers};
use crate::physics::{State, so3};

/// Turns beyond which the phases are reduced one by one.
const MOST_TURNS: f64 = 1e15;

/// The motions, several side by side, and those that are taken one by one.
#[derive(Clone, Debug, Default)]
pub(super) struct Closed {
    groups: Vec<Group>,
    alone: Vec<usize>,
    /// The largest rate of a phase (turns a second).
    largest_rate: f64,
}

/// Motions of one kind of series. A lane that is empty repeats one that is not.
#[derive(Clone, Debug)]
struct Group {
    members: Vec<usize>,
    is_real: bool,
    numbers: Box<Numbers>,
}

/// A column each.
#[derive(Clone, Copy, Debug)]
struct Numbers {
    /// `λ/4K` in three parts and `u₀/4K`.
    turn_rate: [Column; 3],
    start_turns: Column,
    /// Real: q and the factors of sn, cn, dn. Complementary: q′, the factors, √q′ and its decay.
    series: [Column; 6],
    /// Takes cn, sn, dn to the body momentum, by columns.
    momentum: [Column; 9],
    /// `ψ̄/4π` in three parts.
    half_angle_rate: [Column; 3],
    /// σχ. Real: two sines and two cosines. Complementary: sine and cosine of the slope, and it in turns.
    chi: [Column; 4],
    /// M over ℓ by cn, sn, dn.
    directions: [Column; 3],
    /// Quaternions x, y, z, w: what stands to the left and to the right of the turn.
    left: [Column; 4],
    right: [Column; 4],
    world_momentum: [Column; 3],
}

/// cn, sn, dn and what goes into χ.
struct Point<S: Simd> {
    functions: [S::f64s; 3],
    chi: [S::f64s; 2],
    linear: S::f64s,
}

impl Closed {
    pub(super) fn new(members: &[Member]) -> Self {
        let mut closed = Self::default();
        // The group that is being filled, of either kind.
        let mut open: [Option<usize>; 2] = [None; 2];
        for (index, member) in members.iter().enumerate() {
            let Some((is_real, lane_numbers)) = LaneNumbers::new(member) else {
                closed.alone.push(index);
                continue;
            };
            closed.largest_rate = closed.largest_rate.max(lane_numbers.rate);
            let slot = &mut open[usize::from(is_real)];
            let place = match *slot {
                Some(place) if closed.groups[place].members.len() < GROUP => place,
                _ => {
                    closed.groups.push(Group { members: Vec::new(), is_real, numbers: Box::new(Numbers::new()) });
                    *slot = Some(closed.groups.len() - 1);
                    closed.groups.len() - 1
                }
            };
            let group = &mut closed.groups[place];
            let first = group.members.len();
            group.members.push(index);
            // The lanes after it, which the next ones will have, are not to hold what no motion has.
            for lane in first..GROUP {
                lane_numbers.put(&mut group.numbers, lane);
            }
        }
        closed
    }

    /// Whether the phases at this time are within what is reduced side by side.
    fn reaches(&self, time: f64) -> bool {
        self.largest_rate * time.abs() < MOST_TURNS
    }

    /// The body momenta at a time (s).
    pub(super) fn momenta(&self, level: Level, members: &[Member], time: f64, momenta: &mut [DVec3]) {
        if !self.reaches(time) {
            for (momentum, member) in momenta.iter_mut().zip(members) {
                *momentum = member.motion.momentum(time);
            }
            return;
        }
        let split = SplitTime::new(time);
        dispatch!(level, simd => {
            for group in &self.groups {
                let mut found = [Column::ZERO; 3];
                group.momenta(simd, split, &mut found);
                for (lane, index) in group.members.iter().enumerate() {
                    momenta[*index] = DVec3::from_array(get(&found, lane));
                }
            }
        });
        for index in &self.alone {
            momenta[*index] = members[*index].motion.momentum(time);
        }
    }

    /// The states at a time (s), which is not 0.
    pub(super) fn states(&self, level: Level, members: &[Member], time: f64, states: &mut [State]) {
        if !self.reaches(time) {
            for (state, member) in states.iter_mut().zip(members) {
                *state = member.motion.state(time);
            }
            return;
        }
        let split = SplitTime::new(time);
        dispatch!(level, simd => {
            for group in &self.groups {
                let mut found = [Column::ZERO; 12];
                group.states(simd, split, &mut found);
                for (lane, index) in group.members.iter().enumerate() {
                    let [a, b, c, d, e, f, g, h, i, x, y, z] = get(&found, lane);
                    let attitude = DMat3::from_cols_array(&[a, b, c, d, e, f, g, h, i]);
                    let world_momentum = DVec3::from_array(get(&group.numbers.world_momentum, lane));
                    states[*index] = State::from_parts(attitude, DVec3::new(x, y, z), world_momentum);
                }
            }
        });
        for index in &self.alone {
            states[*index] = members[*index].motion.state(time);
        }
    }
}

/// The numbers of one motion.
struct LaneNumbers {
    rate: f64,
    turn_rate: [f64; 3],
    start_turns: f64,
    series: [f64; 6],
    momentum: [f64; 9],
    half_angle_rate: [f64; 3],
    chi: [f64; 4],
    directions: [f64; 3],
    left: [f64; 4],
    right: [f64; 4],
    world_momentum: [f64; 3],
}

impl LaneNumbers {
    /// Whether its series are real ones, and its numbers; `None` where it is taken alone.
    fn new(member: &Member) -> Option<(bool, Self)> {
        let numbers = Path::numbers(member.motion.path())?;
        let [left, right, body_from_orbit] = member.motion.frames();
        let parts = |rate: DoubleDouble| {
            let [high, low] = halves(rate.high);
            [high, low, rate.low]
        };
        let sigma = numbers.handedness;
        let (is_real, series, chi) = match numbers.series {
            SeriesNumbers::Real { series, sines, cosines } => {
                let [sn, cn, dn] = series.factors;
                let chi = [sigma * sines[0], sigma * sines[1], cosines[0], cosines[1]];
                (true, [series.nome(), sn, cn, dn, 0.0, 0.0], chi)
            }
            SeriesNumbers::Complementary { series, slope } => {
                let [sn, cn, dn] = series.factors;
                let (sine, cosine) = (sigma * slope).sin_cos();
                let chi = [sine, cosine, sigma * slope / TAU, 0.0];
                (false, [series.nome, sn, cn, dn, series.root_of_nome, series.decay], chi)
            }
        };
        let momentum = body_from_orbit * DMat3::from_diagonal(numbers.amplitudes);
        let lane_numbers = Self {
            rate: numbers.turn_rate.high.abs().max(numbers.half_angle_rate.high.abs()),
            turn_rate: parts(numbers.turn_rate),
            start_turns: numbers.start_turns,
            series,
            momentum: momentum.to_cols_array(),
            half_angle_rate: parts(numbers.half_angle_rate),
            chi,
            directions: numbers.directions.to_array(),
            left: so3::quaternion(left).to_array(),
            right: so3::quaternion(right).to_array(),
            world_momentum: member.motion.start().world_momentum.to_array(),
        };
        Some((is_real, lane_numbers))
    }

    fn put(&self, numbers: &mut Numbers, lane: usize) {
        set(&mut numbers.turn_rate, lane, self.turn_rate);
        numbers.start_turns.0[lane] = self.start_turns;
        set(&mut numbers.series, lane, self.series);
        set(&mut numbers.momentum, lane, self.momentum);
        set(&mut numbers.half_angle_rate, lane, self.half_angle_rate);
        set(&mut numbers.chi, lane, self.chi);
        set(&mut numbers.directions, lane, self.directions);
        set(&mut numbers.left, lane, self.left);
        set(&mut numbers.right, lane, self.right);
        set(&mut numbers.world_momentum, lane, self.world_momentum);
    }
}

impl Numbers {
    fn new() -> Self {
        let zero = Column::ZERO;
        Self {
            turn_rate: [zero; 3],
            start_turns: zero,
            series: [zero; 6],
            momentum: [zero; 9],
            half_angle_rate: [zero; 3],
            chi: [zero; 4],
            directions: [zero; 3],
            left: [zero; 4],
            right: [zero; 4],
            world_momentum: [zero; 3],
        }
    }
}

impl Group {
    #[inline(always)]
    fn momenta<S: Simd>(&self, simd: S, time: SplitTime, found: &mut [Column; 3]) {
        for lane in (0..GROUP).step_by(S::f64s::LEN) {
            let point = self.point(simd, lane, time);
            self.store_momentum(simd, lane, &point, found);
        }
    }

    #[inline(always)]
    fn store_momentum<S: Simd>(&self, simd: S, lane: usize, point: &Point<S>, found: &mut [Column]) {
        let [cn, sn, dn] = point.functions;
        for (i, column) in found.iter_mut().enumerate() {
            let [a, b, c] = [0, 3, 6].map(|first| load(simd, &self.numbers.momentum[first + i], lane));
            store::<S>(a * cn + (b * sn + c * dn), column, lane);
        }
    }

    #[inline(always)]
    fn states<S: Simd>(&self, simd: S, time: SplitTime, found: &mut [Column; 12]) {
        let numbers = &self.numbers;
        let one = S::f64s::splat(simd, 1.0);
        for lane in (0..GROUP).step_by(S::f64s::LEN) {
            let of = |column: &Column| load(simd, column, lane);
            let point = self.point(simd, lane, time);
            self.store_momentum(simd, lane, &point, &mut found[9..]);
            // R_z(ψ) P(M), of any length.
            let turns = phase(simd, numbers.half_angle_rate.each_ref().map(of), time) + point.linear;
            let [sine, cosine] = sine_and_cosine(simd, turns);
            let [chi_cosine, chi_sine] = point.chi;
            let c = cosine.mul_sub(chi_cosine, sine * chi_sine);
            let s = sine.mul_add(chi_cosine, cosine * chi_sine);
            let [cn, sn, dn] = point.functions;
            let [b1, b2, b3] = numbers.directions.each_ref().map(of);
            let (x, y, w) = (b2 * sn, -(b1 * cn), b3.mul_add(dn, one));
            let frame = [c.mul_sub(x, s * y), c.mul_add(y, s * x), s * w, c * w];
            let turned = product::<S>(numbers.left.each_ref().map(of), frame);
            let [x, y, z, w] = product::<S>(turned, numbers.right.each_ref().map(of));
            let square = (x * x + y * y) + (z * z + w * w);
            let twice = S::f64s::splat(simd, 2.0) / square;
            let (x2, y2, z2) = (x * twice, y * twice, z * twice);
            let (xx, yy, zz) = (x * x2, y * y2, z * z2);
            let (xy, xz, yz) = (x * y2, x * z2, y * z2);
            let (wx, wy, wz) = (w * x2, w * y2, w * z2);
            let attitude = [
                one - (yy + zz),
                xy + wz,
                xz - wy,
                xy - wz,
                one - (xx + zz),
                yz + wx,
                xz + wy,
                yz - wx,
                one - (xx + yy),
            ];
            for (value, column) in attitude.into_iter().zip(found.iter_mut()) {
                store::<S>(value, column, lane);
            }
        }
    }

    #[inline(always)]
    fn point<S: Simd>(&self, simd: S, lane: usize, time: SplitTime) -> Point<S> {
        let numbers = &self.numbers;
        let turns = phase(simd, numbers.turn_rate.each_ref().map(|column| load(simd, column, lane)), time);
        let turns = beyond_whole(simd, turns + load(simd, &numbers.start_turns, lane));
        let series = numbers.series.each_ref().map(|column| load(simd, column, lane));
        let chi = numbers.chi.each_ref().map(|column| load(simd, column, lane));
        if self.is_real { real(simd, turns, series, chi) } else { complementary(simd, turns, series, chi) }
    }
}

/// `ab`, of quaternions x, y, z, w.
#[inline(always)]
fn product<S: Simd>(a: [S::f64s; 4], b: [S::f64s; 4]) -> [S::f64s; 4] {
    let ([ax, ay, az, aw], [bx, by, bz, bw]) = (a, b);
    [
        aw.mul_add(bx, ax * bw) + ay.mul_sub(bz, az * by),
        aw.mul_add(by, ay * bw) + az.mul_sub(bx, ax * bz),
        aw.mul_add(bz, az * bw) + ax.mul_sub(by, ay * bx),
        aw.mul_sub(bw, ax * bx) - ay.mul_add(by, az * bz),
    ]
}

/// By the real nome, as [`crate::physics::elliptic`]'s `Real` and the path.
#[inline(always)]
fn real<S: Simd>(simd: S, turns: S::f64s, series: [S::f64s; 6], chi: [S::f64s; 4]) -> Point<S> {
    let of = |x: f64| S::f64s::splat(simd, x);
    let (one, two) = (of(1.0), of(2.0));
    let [q, sn_factor, cn_factor, dn_factor, ..] = series;
    let [sine, cosine] = sine_and_cosine(simd, turns);
    let s2 = two * sine * cosine;
    let c2 = one - two * sine * sine;
    let c4 = two * c2 * c2 - one;
    let c6 = c2 * (two * c4 - one);
    let q2 = q * q;
    let q4 = q2 * q2;
    let q6 = q4 * q2;
    let same = one + two * q4 * c4;
    let other = two * q * (c2 + (q4 * q4) * c6);
    let first = one - q2 * (one + two * c2) + q6 * (one + two * (c2 + c4));
    let second = one - q2 * (one - two * c2) + q6 * (one - two * (c2 - c4));
    let inverse = one / (same - other);
    let functions = [
        cn_factor * cosine * second * inverse,
        sn_factor * sine * first * inverse,
        dn_factor * (same + other) * inverse,
    ];
    let [sine_1, sine_2, cosine_1, cosine_2] = chi;
    let numerator = s2 * (sine_1 + two * sine_2 * c2);
    let denominator = of(0.5) + cosine_1 * c2 + cosine_2 * c4;
    Point { functions, chi: [denominator, numerator], linear: of(0.0) }
}

/// By the complementary nome, as [`crate::physics::elliptic`]'s `Complementary` and the path.
#[inline(always)]
fn complementary<S: Simd>(simd: S, turns: S::f64s, series: [S::f64s; 6], chi: [S::f64s; 4]) -> Point<S> {
    let of = |x: f64| S::f64s::splat(simd, x);
    let (zero, one) = (of(0.0), of(1.0));
    let [q, sn_factor, cn_factor, dn_factor, root, decay] = series;
    // u/K within ±1, half a period being 2K.
    let is_behind = turns.abs().simd_gt(of(0.25));
    let rest = is_behind.select(turns - of(0.5).copysign(turns), turns);
    let sign = is_behind.select(of(-1.0), one);
    let quarters = rest * 4.0;
    let e = exponential(simd, -(decay * quarters.abs()));
    let p = root / e;
    let (q2, e2, p2) = (q * q, e * e, p * p);
    let (q4, e4, p4) = (q2 * q2, e2 * e2, p2 * p2);
    let same = one + q2 * (p4 + q2 * e4);
    let other = p2 + q * e2 + q4 * q2 * (p4 * p2 + q2 * q * e4 * e2);
    let up = one + q4 * p4;
    let up_odd = q * p2 + q4 * q4 * q * p4 * p2;
    let down = e2 * (one + q4 * q2 * e4);
    let down_odd = q2 * e4;
    let inverse = one / (up + up_odd + down + down_odd);
    let sn = sn_factor * (up - up_odd - down + down_odd) * inverse;
    let functions = [
        sign * (cn_factor * e * (same - other) * inverse),
        sign * sn.copysign(quarters),
        dn_factor * e * (same + other) * inverse,
    ];
    // Sine and cosine of a, 3a, 5a, 7a, 9a with the powers 0, 1, 4, 9, 16 of √q′.
    let [mut sine, mut cosine, turns_of_slope, _] = chi;
    let (sine_of_two, cosine_of_two) = (of(2.0) * sine * cosine, one - of(2.0) * sine * sine);
    let (mut numerator, mut denominator) = (zero, zero);
    let (mut weight, mut ratio) = (one, root * p);
    let mut odd = e;
    for _ in 0..5 {
        numerator += sine * weight * (one - odd);
        denominator += cosine * weight * (one + odd);
        (sine, cosine) = (sine * cosine_of_two + cosine * sine_of_two, cosine * cosine_of_two - sine * sine_of_two);
        weight *= ratio;
        ratio *= q;
        odd *= e2;
    }
    // χ = slope u/K − atan2(…), odd in u.
    let numerator = quarters.simd_lt(zero).select(numerator, -numerator);
    Point { functions, chi: [denominator, numerator], linear: turns_of_slope * quarters }
}
