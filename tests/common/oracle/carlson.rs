//! Carlson's symmetric integrals by duplication (DLMF 19.36(i)): four times closer together at each step, then a series.

use super::real::{Real, exponent, root, size};

/// `R_F(x, y, z) = ½ ∫₀^∞ dt/√((t+x)(t+y)(t+z))`, none negative and one at most 0.
pub(crate) fn first_kind(x: &Real, y: &Real, z: &Real) -> Real {
    let bits = z.precision();
    let (mut x, mut y, mut z) = (x.clone(), y.clone(), z.clone());
    loop {
        let mean = (&x + &y + &z) / Real::from(3);
        if is_close(&mean, &[&x, &y, &z], bits) {
            let (x, y) = ((&mean - &x) / &mean, (&mean - &y) / &mean);
            let z = -(&x + &y);
            let e2 = &x * &y - &z * &z;
            let e3 = &x * &y * &z;
            let (e22, e33) = (&e2 * &e2, &e3 * &e3);
            let sum = Real::from(1) - &e2 / Real::from(10) + &e3 / Real::from(14) + &e22 / Real::from(24)
                - Real::from(3) * &e2 * &e3 / Real::from(44)
                - Real::from(5) * &e22 * &e2 / Real::from(208)
                + Real::from(3) * &e33 / Real::from(104)
                + &e22 * &e3 / Real::from(16);
            return sum / root(&mean);
        }
        let (a, b, c) = (root(&x), root(&y), root(&z));
        let shift = &a * &b + &a * &c + &b * &c;
        x = (&x + &shift) >> 2;
        y = (&y + &shift) >> 2;
        z = (&z + &shift) >> 2;
    }
}

/// `R_J(x, y, z, p) = 3/2 ∫₀^∞ dt/(√((t+x)(t+y)(t+z)) (t+p))`, `p > 0`, no other negative and one at most 0.
pub(crate) fn third_kind(x: &Real, y: &Real, z: &Real, p: &Real) -> Real {
    let bits = z.precision();
    let (mut x, mut y, mut z, mut p) = (x.clone(), y.clone(), z.clone(), p.clone());
    let mut delta = (&p - &x) * (&p - &y) * (&p - &z);
    let mut sum = Real::ZERO;
    let mut quarters = 0;
    loop {
        let mean = (&x + &y + &z + &p + &p) / Real::from(5);
        if is_close(&mean, &[&x, &y, &z, &p], bits) {
            let [x, y, z] = [&x, &y, &z].map(|x| (&mean - x) / &mean);
            let p = -(&x + &y + &z) >> 1;
            let p2 = &p * &p;
            let xyz = &x * &y * &z;
            let e2 = &x * &y + &x * &z + &y * &z - Real::from(3) * &p2;
            let e3 = &xyz + Real::from(2) * &e2 * &p + Real::from(4) * &p2 * &p;
            let e4 = (Real::from(2) * &xyz + &e2 * &p + Real::from(3) * &p2 * &p) * &p;
            let e5 = &xyz * &p2;
            let e22 = &e2 * &e2;
            let series = Real::from(1) - Real::from(3) * &e2 / Real::from(14)
                + &e3 / Real::from(6)
                + Real::from(9) * &e22 / Real::from(88)
                - Real::from(3) * &e4 / Real::from(22)
                - Real::from(9) * &e2 * &e3 / Real::from(52)
                + Real::from(3) * &e5 / Real::from(26)
                - &e22 * &e2 / Real::from(16)
                + Real::from(3) * &e3 * &e3 / Real::from(40)
                + Real::from(3) * &e2 * &e4 / Real::from(20)
                + Real::from(45) * &e22 * &e3 / Real::from(272)
                - Real::from(9) * (&e3 * &e4 + &e2 * &e5) / Real::from(68);
            return ((series / (&mean * root(&mean))) >> (2 * quarters)) + Real::from(6) * sum;
        }
        let (a, b, c, d) = (root(&x), root(&y), root(&z), root(&p));
        let shift = &a * &b + &a * &c + &b * &c;
        let d = (&d + &a) * (&d + &b) * (&d + &c);
        let e = &delta / (&d * &d);
        sum += (beside_one(&e, bits) / &d) >> (2 * quarters);
        x = (&x + &shift) >> 2;
        y = (&y + &shift) >> 2;
        z = (&z + &shift) >> 2;
        p = (&p + &shift) >> 2;
        delta >>= 6;
        quarters += 1;
    }
}

/// `R_C(1, 1 + e) = arctan(√e)/√e`, `e > −1`.
fn beside_one(e: &Real, bits: usize) -> Real {
    if exponent(e) < -12 {
        // 1 − e/3 + e²/5 − …
        let mut power = super::real::real(1.0, bits);
        let mut sum = power.clone();
        for n in 1.. {
            power = -(&power * e);
            if exponent(&power) < -bits.cast_signed() {
                break;
            }
            sum += &power / Real::from(2 * n + 1);
        }
        return sum;
    }
    let (mut x, mut y) = (super::real::real(1.0, bits), Real::from(1) + e);
    loop {
        let mean = (&x + &y + &y) / Real::from(3);
        if is_close(&mean, &[&x, &y], bits) {
            let s = (&y - &mean) / &mean;
            let s2 = &s * &s;
            let s3 = &s2 * &s;
            let sum = Real::from(1)
                + Real::from(3) * &s2 / Real::from(10)
                + &s3 / Real::from(7)
                + Real::from(3) * &s2 * &s2 / Real::from(8)
                + Real::from(9) * &s2 * &s3 / Real::from(22)
                + Real::from(159) * &s3 * &s3 / Real::from(208)
                + Real::from(9) * &s3 * &s3 * &s / Real::from(8);
            return sum / root(&mean);
        }
        let shift = ((root(&x) * root(&y)) << 1) + &y;
        x = (&x + &shift) >> 2;
        y = (&y + &shift) >> 2;
    }
}

/// Whether the eighth power of the distance from the mean is lost.
fn is_close(mean: &Real, of: &[&Real], bits: usize) -> bool {
    let bound = exponent(mean) - bits.cast_signed() / 8 - 2;
    of.iter().all(|x| exponent(&size(&(mean - *x))) < bound)
}
