//! An integrator that shares nothing with the crate: Taylor series of order 24 of quaternion and angular velocity.

use glam::{DMat3, DQuat, DVec3};

const ORDER: usize = 24;

/// Attitude relative to the start and momentum in the principal frame after a time, from principal moments and momentum.
///
/// Steps of at most 0.3 of the fastest rate there is: the series then fall as `0.3ⁿ` at least and 24 terms leave 1e-13 · 0.3⁻…,
/// below rounding; each step adds some 4ε.
pub(crate) fn integrate(moments: DVec3, momentum: DVec3, time: f64) -> (DMat3, DVec3) {
    let ratios = DVec3::new(
        (moments.y - moments.z) / moments.x,
        (moments.z - moments.x) / moments.y,
        (moments.x - moments.y) / moments.z,
    );
    let mut omega = momentum / moments;
    let mut q = [1.0, 0.0, 0.0, 0.0];
    // Sizes that Ω may reach on the orbit: |M_i| ≤ ℓ.
    let largest = momentum.length() / moments.min_element();
    let steps = (time.abs() * largest / 0.3).ceil().max(1.0);
    let h = time / steps;
    for _ in 0..steps as u64 {
        (omega, q) = step(ratios, omega, q, h);
    }
    let attitude = DMat3::from_quat(DQuat::from_xyzw(q[1], q[2], q[3], q[0]).normalize());
    (attitude, moments * omega)
}

fn step(ratios: DVec3, omega: DVec3, q: [f64; 4], h: f64) -> (DVec3, [f64; 4]) {
    let mut w = [DVec3::ZERO; ORDER + 1];
    let mut a = [[0.0; 4]; ORDER + 1];
    w[0] = omega;
    a[0] = q;
    for n in 0..ORDER {
        let mut rate = DVec3::ZERO;
        let mut turn = [0.0; 4];
        for k in 0..=n {
            let (u, v) = (w[k], w[n - k]);
            rate += DVec3::new(u.y * v.z, u.z * v.x, u.x * v.y);
            let [p, x, y, z] = a[k];
            // ½ q (0, Ω).
            turn[0] += -x * v.x - y * v.y - z * v.z;
            turn[1] += p * v.x + y * v.z - z * v.y;
            turn[2] += p * v.y + z * v.x - x * v.z;
            turn[3] += p * v.z + x * v.y - y * v.x;
        }
        let scale = 1.0 / (n + 1) as f64;
        w[n + 1] = ratios * rate * scale;
        a[n + 1] = turn.map(|t| 0.5 * t * scale);
    }
    let mut omega = w[ORDER];
    let mut q = a[ORDER];
    for n in (0..ORDER).rev() {
        omega = omega * h + w[n];
        for i in 0..4 {
            q[i] = q[i] * h + a[n][i];
        }
    }
    (omega, q)
}
