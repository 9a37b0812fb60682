//! The kinds of starts that a free body can be given, each a generator of random ones. `|Ω|` is near 1 rad/s where its size is not
//! the point, and times go from 1e-3 to 1e12 s, both ways.

#![allow(clippy::unreadable_literal, reason = "values stand as they were computed")]

use std::f64::consts::PI;

use dzhanibekov::physics::so3;
use dzhanibekov::physics::solids::{Shape, Solid};
use glam::{DMat3, DVec3};

use crate::common::Random;
use crate::oracle::Inertia;

/// A body, its angular velocity with the attitude at the identity, and a time (s).
#[derive(Clone, Debug)]
pub(crate) struct Start {
    pub(crate) inertia: Inertia,
    pub(crate) angular_velocity: [f64; 3],
    /// Whether that is along the principal axes.
    pub(crate) is_along_axes: bool,
    pub(crate) time: f64,
}

/// A kind of starts.
pub(crate) struct Kind {
    pub(crate) name: &'static str,
    pub(crate) make: fn(&mut Random) -> Start,
}

const fn kind(name: &'static str, make: fn(&mut Random) -> Start) -> Kind {
    Kind { name, make }
}

/// All of them.
pub(crate) const KINDS: &[Kind] = &[
    kind("any body", |r| moments(r, |r| r.vector().to_array())),
    kind("a box", |r| {
        let edges = [0.0; 3].map(|_| r.between(0.1, 1.0));
        Start {
            inertia: Inertia::Box { edges, mass: power(r, -3.0, 3.0) },
            angular_velocity: spin(r),
            is_along_axes: false,
            time: time(r),
        }
    }),
    kind("a box of extreme edges", |r| {
        let edges = [0.0; 3].map(|_| power(r, -7.0, 0.0));
        Start {
            inertia: Inertia::Box { edges, mass: power(r, -3.0, 3.0) },
            angular_velocity: spin(r),
            is_along_axes: false,
            time: time(r),
        }
    }),
    kind("a box of nearly equal edges", |r| {
        let a = r.between(0.1, 1.0);
        let mut edges = [a, a * (1.0 + sign(r) * power(r, -16.0, -2.0)), r.between(0.1, 1.0)];
        if r.below(2) == 0 {
            edges[2] = a * (1.0 + sign(r) * power(r, -16.0, -2.0));
        }
        Start {
            inertia: Inertia::Box { edges, mass: 1.0 },
            angular_velocity: spin(r),
            is_along_axes: false,
            time: time(r),
        }
    }),
    kind("a box on the separatrix to rounding", |r| {
        let edges = [0.0; 3].map(|_| r.between(0.1, 1.0));
        let [a, b, c] = edges.map(|edge| edge * edge);
        let mut sums = [b + c, c + a, a + b];
        sums.sort_by(f64::total_cmp);
        let (angular_velocity, time) = near_separatrix_of(r, sums, 0.0);
        Start { inertia: Inertia::Box { edges, mass: 0.7 }, angular_velocity, is_along_axes: true, time }
    }),
    kind("near the separatrix", |r| {
        let off = power(r, -16.0, -1.0);
        near_separatrix(r, off)
    }),
    kind("on the separatrix to rounding", |r| near_separatrix(r, 0.0)),
    kind("exactly on the separatrix", on_separatrix),
    kind("the separatrix missed by 1e-30", missed_by_squares),
    kind("the separatrix missed by 1e-43", missed_by_cubes),
    kind("beside the middle axis", |r| {
        let mut omega =
            [r.between(-1.0, 1.0) * power(r, -16.0, -2.0), sign(r), r.between(-1.0, 1.0) * power(r, -16.0, -2.0)];
        drop_one(r, &mut omega);
        beside_middle(r, omega)
    }),
    kind("beside the middle axis, down to denormals", |r| {
        let mut omega = [sign(r) * power(r, -322.0, -16.0), sign(r), sign(r) * power(r, -322.0, -16.0)];
        drop_one(r, &mut omega);
        beside_middle(r, omega)
    }),
    kind("beside a stable axis, down to denormals", |r| {
        moments(r, |r| {
            let mut omega = [0.0; 3].map(|_| sign(r) * power(r, -322.0, -1.0));
            omega[2 * r.below(2) as usize] = sign(r);
            omega
        })
    }),
    kind("about an axis", |r| {
        moments(r, |r| {
            let mut omega = [0.0; 3];
            omega[r.below(3) as usize] = sign(r) * r.between(0.1, 2.0);
            omega
        })
    }),
    kind("one component of the spin zero", |r| {
        moments(r, |r| {
            let mut omega = spin(r);
            omega[r.below(3) as usize] = 0.0;
            omega
        })
    }),
    kind("two equal moments", |r| {
        let (a, b) = (r.between(0.3, 1.0), r.between(0.3, 1.0));
        own_axes(r, [a, a, b], spin)
    }),
    kind("two nearly equal moments", |r| {
        let (a, b) = (r.between(0.3, 1.0), r.between(0.3, 1.0));
        let off = sign(r) * power(r, -16.0, -2.0);
        own_axes(r, [a, a * (1.0 + off), b], spin)
    }),
    kind("three nearly equal moments", |r| {
        let (off, other) = (sign(r) * power(r, -15.0, -2.0), sign(r) * power(r, -15.0, -2.0));
        own_axes(r, [1.0, 1.0 + off, 1.0 + other], spin)
    }),
    kind("a sphere", |r| {
        let a = r.between(0.3, 1.0);
        own_axes(r, [a; 3], spin)
    }),
    kind("a needle", |r| {
        let thin = power(r, -13.0, -4.0);
        let off = thin * r.unit();
        own_axes(r, [thin, 1.0, 1.0 + off], spin)
    }),
    kind("a needle nearly round", |r| {
        let thin = power(r, -13.0, -4.0);
        let off = thin * power(r, -6.0, 0.0);
        own_axes(r, [thin, 1.0, 1.0 + off], spin)
    }),
    kind("a flat plate", |r| {
        let (a, b) = (power(r, -3.0, 0.0), r.between(0.3, 1.0));
        own_axes(r, [a, b, a + b], spin)
    }),
    kind("moments that no solid has", |r| {
        // It nutates 1/√(ab) times as fast as it turns: the phases are to stay below some 1e13 rad.
        let (a, b) = (power(r, -8.0, 0.0), power(r, -8.0, 0.0));
        let start = own_axes(r, [a, b, 1.0], spin);
        Start { time: start.time * (a * b).sqrt(), ..start }
    }),
    kind("the farthest from a solid's that the bounds hold for", |r| {
        // (I₃ − I₁)(I₃ − I₂) just below 10¹¹ I₁I₂.
        let (i1, i2) = (power(r, -3.0, 0.0), power(r, 0.0, 3.0));
        let start = own_axes(r, [i1, i2, 0.999 * (1e11 * i1 * i2).sqrt()], spin);
        Start { time: sign(r) * power(r, 10.0, 12.0), ..start }
    }),
    kind("tiny and huge momentum", |r| {
        let unit = power(r, -290.0, 150.0);
        let any = solid_moments(r).map(|m| m * unit);
        own_axes(r, any, spin)
    }),
    kind("slow and fast", |r| {
        let unit = power(r, -150.0, 120.0);
        let any = solid_moments(r);
        let start = own_axes(r, any, spin);
        Start { angular_velocity: start.angular_velocity.map(|x| x * unit), time: start.time / unit, ..start }
    }),
    kind("a published body", |r| {
        let bodies =
            [[0.5, 0.85, 1.0], [3.0, 5.0, 9.0], [10.0, 20.0, 26.0], [1.0, 3.0836, 3.235], [1.49e-3, 2.33e-3, 3.7e-3]];
        let body = bodies[r.below(5) as usize];
        own_axes(r, body, spin)
    }),
    kind("an axis, a tilt and a rate", |r| {
        // As scenes give them: the middle axis tilted towards another.
        let (sine, cosine) = power(r, -12.0, 1.5).to_radians().sin_cos();
        let rate = sign(r) * r.between(0.5, 2.0);
        let mut omega = [0.0, rate * cosine, 0.0];
        omega[2 * r.below(2) as usize] = rate * sine;
        beside_middle(r, omega)
    }),
    kind("a tensor", |r| {
        let any = solid_moments(r);
        let turn = r.rotation();
        turned(r, any, turn, spin)
    }),
    kind("a tensor of a needle", |r| {
        let thin = power(r, -7.0, -3.0);
        let off = thin * r.unit();
        let turn = r.rotation();
        turned(r, [thin, 1.0, 1.0 + off], turn, spin)
    }),
    kind("a tensor of two nearly equal moments", |r| {
        let (a, b, off) = (r.between(0.5, 1.0), r.between(0.5, 1.0), power(r, -15.0, -2.0));
        let turn = r.rotation();
        turned(r, [a, a * (1.0 + off), b], turn, spin)
    }),
    kind("a tensor beside the middle axis", |r| {
        let any = solid_moments(r);
        let turn = r.rotation();
        let tilt = power(r, -17.0, -1.0);
        let mut start = turned(r, any, turn, |r| [tilt * r.between(-1.0, 1.0), sign(r), tilt * r.between(-1.0, 1.0)]);
        start.time = sign(r) * power(r, 0.0, 3.0);
        start
    }),
    kind("a tensor near the separatrix", |r| {
        let any = solid_moments(r);
        let off = power(r, -16.0, -1.0);
        let (omega, _) = near_separatrix_of(r, any, off);
        let turn = r.rotation();
        turned(r, any, turn, |_| omega)
    }),
    kind("a tensor with a small entry", |r| {
        let [xx, yy, zz] = solid_moments(r);
        let mut entries = [xx, yy, zz, 0.0, 0.0, 0.0];
        entries[3 + r.below(3) as usize] = sign(r) * power(r, -300.0, -3.0);
        Start { inertia: Inertia::Tensor(entries), angular_velocity: spin(r), is_along_axes: false, time: time(r) }
    }),
    kind("a tensor with a plane of symmetry", |r| {
        let [xx, yy, zz] = solid_moments(r);
        let mut entries = [xx, yy, zz, 0.0, 0.0, 0.0];
        entries[3 + r.below(3) as usize] = 0.3 * xx.min(yy).min(zz) * r.between(-1.0, 1.0);
        Start { inertia: Inertia::Tensor(entries), angular_velocity: spin(r), is_along_axes: false, time: time(r) }
    }),
    kind("a tensor along its axes", |r| {
        let any = solid_moments(r);
        let turn = r.rotation();
        let start = turned(r, any, turn, spin);
        let like = match r.below(4) {
            0 => near_separatrix_of(r, any, 0.0).0,
            1 => [sign(r) * power(r, -322.0, -3.0), sign(r), sign(r) * power(r, -322.0, -3.0)],
            2 => [0.0, sign(r), 0.0],
            _ => spin(r),
        };
        let time = if r.below(2) == 0 { start.time } else { sign(r) * power(r, 0.0, 4.0) };
        Start { angular_velocity: like, is_along_axes: true, time, ..start }
    }),
    kind("a tensor of known axes, on the separatrix", |r| {
        let (moments, first, third) = WHOLE[r.below(WHOLE.len() as u64) as usize];
        let rate = short(r) / 64.0;
        let middle = short(r) * sign(r) / 4.0;
        of_known_axes(r, moments, [first * rate, middle, third * rate])
    }),
    kind("a tensor of known axes, about one or beside it", |r| {
        let (moments, _, _) = WHOLE[r.below(WHOLE.len() as u64) as usize];
        let mut omega = [0.0; 3];
        omega[r.below(3) as usize] = short(r) * sign(r) / 8.0;
        let mut start = of_known_axes(r, moments, omega);
        if r.below(2) == 0 {
            start.angular_velocity = start.angular_velocity.map(|x| if x == 0.0 { power(r, -322.0, -16.0) } else { x });
        }
        start
    }),
    kind("a tensor of two equal moments", |r| {
        // λ 1 + μ u uᵀ, u = (1, 2, 2)/3, times nine.
        let round = short(r);
        let along = if r.below(2) == 0 { short(r) } else { -0.5 * round };
        let diagonal = 9.0 * round;
        let entries = [1.0, 4.0, 4.0].map(|square| diagonal + along * square);
        let others = [2.0, 2.0, 4.0].map(|product| along * product);
        let [xx, yy, zz] = entries;
        let [xy, xz, yz] = others;
        let inertia = Inertia::Tensor([xx, yy, zz, xy, xz, yz]);
        Start { inertia, angular_velocity: spin(r), is_along_axes: false, time: time(r) }
    }),
    kind("solids", |r| {
        let count = 1 + r.below(4);
        let solids = (0..count).map(|_| solid(r, 1.0)).collect();
        Start { inertia: Inertia::Solids(solids), angular_velocity: spin(r), is_along_axes: false, time: time(r) }
    }),
    kind("solids, turned about or beside an axis of theirs", |r| {
        let solids = vec![solid(r, 1.0), solid(r, 0.5)];
        let mut omega = [sign(r), sign(r) * power(r, -322.0, -1.0), sign(r) * power(r, -322.0, -1.0)];
        let axis = r.below(3) as usize;
        omega.swap(0, axis);
        if r.below(3) == 0 {
            omega[(axis + 1) % 3] = 0.0;
        }
        if r.below(3) == 0 {
            omega[(axis + 2) % 3] = 0.0;
        }
        let time = if r.below(3) == 0 { time(r) } else { sign(r) * power(r, 0.0, 4.0) };
        Start { inertia: Inertia::Solids(solids), angular_velocity: omega, is_along_axes: true, time }
    }),
    kind("solids, a light one far away", |r| {
        let size = power(r, -2.0, 0.0);
        let mut far = solid(r, size);
        far.density *= power(r, -12.0, -3.0);
        far.position *= power(r, 1.0, 5.0);
        let mut solids = vec![far, solid(r, 1.0)];
        if r.below(2) == 0 {
            solids.reverse();
        }
        Start { inertia: Inertia::Solids(solids), angular_velocity: spin(r), is_along_axes: false, time: time(r) }
    }),
    kind("solids along the axes", |r| {
        let solids = (0..3)
            .map(|_| {
                let mut part = solid(r, 1.0);
                part.body_from_solid = DMat3::IDENTITY;
                part.position = DVec3::Z * part.position.z;
                part
            })
            .collect();
        Start { inertia: Inertia::Solids(solids), angular_velocity: spin(r), is_along_axes: false, time: time(r) }
    }),
];

fn sign(r: &mut Random) -> f64 {
    if r.below(2) == 0 { 1.0 } else { -1.0 }
}

/// Ten to a power between two.
fn power(r: &mut Random, low: f64, high: f64) -> f64 {
    10f64.powf(r.between(low, high))
}

fn spin(r: &mut Random) -> [f64; 3] {
    (1.5 * r.vector()).to_array()
}

fn time(r: &mut Random) -> f64 {
    sign(r) * power(r, -3.0, 12.0)
}

/// Moments of a box, ascending.
fn solid_moments(r: &mut Random) -> [f64; 3] {
    let squares = [0.0; 3].map(|_| r.between(0.1, 1.0).powi(2));
    let mut moments = [squares[1] + squares[2], squares[2] + squares[0], squares[0] + squares[1]];
    moments.sort_by(f64::total_cmp);
    moments
}

/// With moments, angular velocity and axes in an order and with signs of their own.
fn shuffled(r: &mut Random, mut moments: [f64; 3], mut angular_velocity: [f64; 3], time: f64) -> Start {
    for n in [2, 1] {
        let other = r.below(n + 1) as usize;
        moments.swap(n as usize, other);
        angular_velocity.swap(n as usize, other);
    }
    for component in &mut angular_velocity {
        *component *= sign(r);
    }
    Start { inertia: Inertia::Moments(moments), angular_velocity, is_along_axes: false, time }
}

fn own_axes(r: &mut Random, moments: [f64; 3], omega: fn(&mut Random) -> [f64; 3]) -> Start {
    let omega = omega(r);
    let time = time(r);
    shuffled(r, moments, omega, time)
}

fn moments(r: &mut Random, omega: fn(&mut Random) -> [f64; 3]) -> Start {
    let moments = solid_moments(r);
    own_axes(r, moments, omega)
}

/// Zeroes, one time in three, the first or the last.
fn drop_one(r: &mut Random, omega: &mut [f64; 3]) {
    match r.below(6) {
        0 => omega[0] = 0.0,
        1 => omega[2] = 0.0,
        _ => {}
    }
}

/// Near the middle axis, at times of some flips, or any.
fn beside_middle(r: &mut Random, omega: [f64; 3]) -> Start {
    let moments = solid_moments(r);
    let [a, b, c] = moments;
    let growth = ((c - b) * (b - a) / (a * c)).sqrt() * omega[1].abs();
    let tilt = omega[0].abs().max(omega[2].abs()).max(1e-323);
    let flips = -tilt.ln() / growth.max(1e-3) * r.between(0.0, 8.0);
    let time = if r.below(3) == 0 { time(r) } else { sign(r) * flips };
    shuffled(r, moments, omega, time)
}

/// `I₁Ω₁²(I₂−I₁) = I₃Ω₃²(I₃−I₂)` but for a relative distance.
fn near_separatrix(r: &mut Random, off: f64) -> Start {
    let [mut a, mut b, mut c] = solid_moments(r);
    if r.below(3) == 0 {
        (a, b, c) = (power(r, -2.0, 0.0), 1.0, 1.0 + power(r, -2.0, 0.0));
    }
    let (omega, time) = near_separatrix_of(r, [a, b, c], off);
    shuffled(r, [a, b, c], omega, time)
}

fn near_separatrix_of(r: &mut Random, [a, b, c]: [f64; 3], off: f64) -> ([f64; 3], f64) {
    let third = r.between(0.1, 1.0);
    let first = third * (c * (c - b) / (a * (b - a))).sqrt() * (1.0 + sign(r) * off).sqrt();
    let omega = [first, r.between(-1.0, 1.0), third];
    (omega.map(|x| x / first.max(1.0)), time(r))
}

/// Moments and `Ω₁ : Ω₃` with `I₁Ω₁²(I₂−I₁) = I₃Ω₃²(I₃−I₂)`.
const WHOLE: [([f64; 3], f64, f64); 12] = [
    ([4.0, 8.0, 9.0], 3.0, 4.0),
    ([1.0, 3.0, 6.0], 3.0, 1.0),
    ([2.0, 5.0, 6.0], 1.0, 1.0),
    ([1.0, 9.0, 18.0], 9.0, 2.0),
    ([3.0, 6.0, 8.0], 4.0, 3.0),
    ([3.0, 15.0, 16.0], 2.0, 3.0),
    ([5.0, 29.0, 30.0], 1.0, 2.0),
    ([7.0, 15.0, 21.0], 3.0, 2.0),
    ([8.0, 9.0, 18.0], 9.0, 2.0),
    ([6.0, 20.0, 21.0], 1.0, 2.0),
    ([4.0, 25.0, 28.0], 1.0, 1.0),
    ([5.0, 10.0, 18.0], 12.0, 5.0),
];

/// A number of 40 bits between 0.5 and 1, times a power of two.
fn short(r: &mut Random) -> f64 {
    let whole = (1_u64 << 39) + r.below(1 << 39);
    whole as f64 * 2f64.powi(-40 + r.below(5) as i32)
}

fn on_separatrix(r: &mut Random) -> Start {
    let (moments, first, third) = WHOLE[r.below(WHOLE.len() as u64) as usize];
    let (size, rate) = (short(r), short(r) / 16.0);
    let omega = [first * rate, r.between(-1.0, 1.0), third * rate];
    let time = if r.below(2) == 0 { time(r) } else { r.between(-100.0, 100.0) };
    shuffled(r, moments.map(|m| m * size), omega, time)
}

/// Moments 4, 8, 9 and Ω₁ : Ω₃ = 3 : 4, each changed by some ulps so that to first order nothing changes:
/// `∂Δ₂ = −11.25 ∂I₂ + 10 ∂I₃ − 24 ∂Ω₁ + 18 ∂Ω₃`, and I₁ does not enter.
fn missed_by_squares(r: &mut Random) -> Start {
    let mut whole = |size: u64| r.below(2 * size + 1) as f64 - size as f64;
    let (a, b, c, first) = (whole(8), whole(4), whole(8), whole(12));
    let ulp = f64::EPSILON;
    let moments = [4.0 + 4.0 * first * ulp, 8.0 + 8.0 * a * ulp, 9.0 + 24.0 * b * ulp];
    let middle = r.between(-1.0, 1.0);
    let omega = [0.75 + (b + 3.0 * c) * ulp, middle, 1.0 + (5.0 * a + 4.0 * c - 12.0 * b) * ulp];
    let time = if r.below(3) == 0 { time(r) } else { r.between(-300.0, 300.0) };
    shuffled(r, moments, omega, time)
}

/// Of those the ones where the squares go as well.
const CUBES: [([f64; 3], f64, f64); 12] = [
    ([3.9999999999999885, 7.999999999999984, 8.999999999999984], 0.7499999999999993, 0.999999999999998),
    ([3.9999999999999902, 7.999999999999988, 8.999999999999984], 0.749999999999998, 0.9999999999999984),
    ([3.999999999999984, 7.999999999999982, 8.999999999999984], 0.75, 0.9999999999999978),
    ([3.9999999999999876, 7.999999999999989, 8.999999999999984], 0.7499999999999973, 0.9999999999999987),
    ([3.9999999999999805, 7.999999999999982, 8.999999999999984], 0.7499999999999993, 0.9999999999999969),
    ([3.999999999999984, 7.999999999999989, 8.999999999999984], 0.749999999999998, 0.9999999999999996),
    ([3.9999999999999796, 7.9999999999999805, 8.999999999999984], 0.7500000000000007, 0.9999999999999976),
    ([3.999999999999985, 7.999999999999991, 8.999999999999984], 0.7499999999999967, 0.9999999999999989),
    ([4.000000000000006, 7.999999999999984, 8.999999999999984], 0.7499999999999953, 0.9999999999999927),
    ([3.9999999999999956, 7.999999999999991, 9.0], 0.7500000000000047, 1.0000000000000007),
    ([3.9999999999999893, 8.000000000000007, 9.0], 0.7499999999999973, 1.0000000000000009),
    ([4.000000000000018, 7.999999999999993, 8.999999999999984], 0.7499999999999973, 1.0000000000000009),
];

fn missed_by_cubes(r: &mut Random) -> Start {
    let (moments, first, third) = CUBES[r.below(CUBES.len() as u64) as usize];
    let (size, rate) = (2f64.powi(r.below(9) as i32 - 4), 2f64.powi(r.below(3) as i32 - 1));
    let middle = r.between(-1.0, 1.0);
    let omega = [first * rate, middle, third * rate];
    let time = if r.below(3) == 0 { time(r) } else { r.between(-400.0, 400.0) };
    shuffled(r, moments.map(|m| m * size), omega, time)
}

/// As a full tensor: the rotation and its products are rounded, and what comes of it is what the body is given by.
fn turned(r: &mut Random, moments: [f64; 3], turn: DMat3, omega: impl Fn(&mut Random) -> [f64; 3]) -> Start {
    let tensor = turn * DMat3::from_diagonal(DVec3::from_array(moments)) * turn.transpose();
    let (x, y, z) = (tensor.x_axis, tensor.y_axis, tensor.z_axis);
    let omega = turn * DVec3::from_array(omega(r));
    Start {
        inertia: Inertia::Tensor([x.x, y.y, z.z, x.y, x.z, y.z]),
        angular_velocity: omega.to_array(),
        is_along_axes: false,
        time: time(r),
    }
}

/// A tensor, without rounding, whose axes are (3, 4, 0)/5, (−4, 3, 0)/5 and (0, 0, 1) in some order: 25 times these moments,
/// and 5 times these components of the spin. Both are of 40 bits times small whole numbers.
fn of_known_axes(r: &mut Random, moments: [f64; 3], spin: [f64; 3]) -> Start {
    let size = short(r);
    let [a, b, c] = [[0, 1, 2], [1, 2, 0], [2, 0, 1]][r.below(3) as usize];
    let [p, q, s] = [a, b, c].map(|n| moments[n] * size);
    let [x, y, z] = [a, b, c].map(|n| spin[n]);
    let inertia = Inertia::Tensor([9.0 * p + 16.0 * q, 16.0 * p + 9.0 * q, 25.0 * s, 12.0 * (p - q), 0.0, 0.0]);
    let angular_velocity = [3.0 * x - 4.0 * y, 4.0 * x + 3.0 * y, 5.0 * z];
    let time = if r.below(2) == 0 { time(r) } else { r.between(-100.0, 100.0) };
    Start { inertia, angular_velocity, is_along_axes: false, time }
}

fn solid(r: &mut Random, size: f64) -> Solid {
    let mut length = || size * r.between(0.1, 1.0);
    let lengths = DVec3::new(length(), length(), length());
    let shape = match r.below(3) {
        0 => Shape::Box { edges: lengths },
        1 => Shape::Cylinder { radius: lengths.x, length: lengths.z },
        _ => Shape::Ellipsoid { semi_axes: lengths },
    };
    let turn = if r.below(3) == 0 { DVec3::ZERO } else { PI * r.vector() };
    Solid { shape, density: power(r, -1.0, 1.0), position: r.vector(), body_from_solid: so3::exp(turn) }
}
