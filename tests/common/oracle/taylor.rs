//! Taylor series of quaternion and angular velocity in long numbers: Euler's equations themselves, for short times.

use super::inertia::Inertia;
use super::motion::Moment;
use super::real::{Matrix, Real, Vector, dot, nearest, product, real, root, times, transposed, vector};

const ORDER: usize = 40;

/// At a time, by steps of at most 0.1 of the fastest rate: the terms fall as `0.1ⁿ`, to 1e-41 at the first left out.
pub(crate) fn at(inertia: &Inertia, angular_velocity: [f64; 3], time: f64, bits: usize) -> Moment {
    let principal = inertia.principal(bits);
    let [i1, i2, i3] = &principal.moments;
    let ratios = [(i2 - i3) / i1, (i3 - i1) / i2, (i1 - i2) / i3];
    let mut omega = times(&principal.principal_from_body, &vector(angular_velocity, bits));
    let momentum = [0, 1, 2].map(|n| &principal.moments[n] * &omega[n]);
    let fastest = nearest(&(root(&dot(&momentum, &momentum)) / i1));
    let steps = (time.abs() * fastest / 0.1).ceil().max(1.0);
    let h = real(time, bits) / real(steps, bits);
    let mut q = [1.0, 0.0, 0.0, 0.0].map(|x| real(x, bits));
    for _ in 0..steps as u64 {
        (omega, q) = step(&ratios, omega, q, &h);
    }
    let [w, x, y, z] = &q;
    let two = Real::from(2);
    let one = Real::from(1);
    let standard: Matrix = [
        [&one - &two * (y * y + z * z), &two * (x * y - w * z), &two * (x * z + w * y)],
        [&two * (x * y + w * z), &one - &two * (x * x + z * z), &two * (y * z - w * x)],
        [&two * (x * z - w * y), &two * (y * z + w * x), &one - &two * (x * x + y * y)],
    ];
    let body_from_principal = transposed(&principal.principal_from_body);
    let m = [0, 1, 2].map(|n| &principal.moments[n] * &omega[n]);
    let ell = root(&dot(&m, &m));
    Moment {
        attitude: product(&product(&body_from_principal, &standard), &principal.principal_from_body),
        direction: times(&body_from_principal, &m.map(|x| x / &ell)),
    }
}

fn step(ratios: &Vector, omega: Vector, q: [Real; 4], h: &Real) -> (Vector, [Real; 4]) {
    let mut w = vec![omega];
    let mut a = vec![q];
    for n in 0..ORDER {
        let mut rate = [Real::ZERO; 3];
        let mut turn = [Real::ZERO; 4];
        for k in 0..=n {
            let (u, v) = (&w[k], &w[n - k]);
            let [p, x, y, z] = &a[k];
            rate[0] += &u[1] * &v[2];
            rate[1] += &u[2] * &v[0];
            rate[2] += &u[0] * &v[1];
            turn[0] -= x * &v[0] + y * &v[1] + z * &v[2];
            turn[1] += p * &v[0] + y * &v[2] - z * &v[1];
            turn[2] += p * &v[1] + z * &v[0] - x * &v[2];
            turn[3] += p * &v[2] + x * &v[1] - y * &v[0];
        }
        // With the powers of h in the coefficients.
        let scale = h / Real::from(n + 1);
        let half = scale.clone() >> 1;
        w.push([0, 1, 2].map(|i| &ratios[i] * &rate[i] * &scale));
        a.push(turn.map(|x| x * &half));
    }
    let omega = [0, 1, 2].map(|i| w.iter().map(|term| &term[i]).sum::<Real>());
    let q = [0, 1, 2, 3].map(|i| a.iter().map(|term| &term[i]).sum::<Real>());
    (omega, q)
}
