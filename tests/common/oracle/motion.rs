//! The free motion by Euler's angles about L.
//!
//! Axis 3 of the standard position precesses about L at `φ̇ = ℓ/I₃ + ℓ(1/I₁ − 1/I₃)/(1 − n sn²u)`, `n = −I₃(I₂−I₁)/(I₁(I₃−I₂)) ≤ 0`
//! (Landau & Lifshitz, Mechanics, §37), so that φ is ℓt/I₃ and Legendre's integral of the third kind.

use glam::{DMat3, DVec3};

use super::carlson;
use super::inertia::{Inertia, Principal};
use super::jacobi::Modulus;
use super::real::{
    Matrix, Real, Vector, cross, dot, exponent, is_negative, is_zero, nearest, product, real, root, sign, signed, size,
    times, transposed, vector, with_bits,
};

/// What a motion is evaluated in.
pub(crate) const BITS: usize = 384;
/// What its start is prepared in, until no difference has lost too much; what is lost in the last one is 0.
const PREPARATION: [usize; 3] = [576, 1536, 4608];

/// What the angular velocity is given by (rad/s).
#[derive(Clone, Copy, Debug)]
pub(crate) enum Spin {
    /// Its components in the body frame.
    Body([f64; 3]),
    /// Its components along principal axes 1, 2, 3, and the rounded axes, which say which way they point.
    AlongAxes([f64; 3], DMat3),
}

/// What the momentum does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Turning {
    /// It stays, exactly.
    Steady,
    /// It circles axis 1 or 3.
    About(u8),
    /// Exactly between.
    Separatrix,
}

/// A motion, prepared.
#[derive(Clone, Debug)]
pub(crate) struct Oracle {
    bits: usize,
    pub(crate) turning: Turning,
    /// Whether two principal moments are equal.
    pub(crate) is_symmetric: bool,
    /// `|M|`, `|Ω|` at the start, and the largest on the orbit.
    pub(crate) ell: Real,
    pub(crate) speed: Real,
    pub(crate) fastest: Real,
    /// The kinetic energy.
    pub(crate) energy: Real,
    /// In ascending order, with their axes as rows.
    pub(crate) principal: Principal,
    /// The signed permutation of the principal frame, and the principal frame.
    standard_from_body: Matrix,
    /// Of the standard position.
    angular_velocity: Vector,
    direction: Vector,
    orbit: Option<Orbit>,
}

/// Jacobi's motion on its orbit.
#[derive(Clone, Debug)]
struct Orbit {
    modulus: Modulus,
    /// Half a period of the functions; none on the separatrix.
    quarter: Option<Real>,
    rate: Real,
    start: Real,
    /// Over ℓ, with signs.
    amplitudes: Vector,
    characteristic: Real,
    /// `ℓ/I₃` and `ℓ(1/I₁ − 1/I₃)/λ`.
    even_rate: Real,
    third_weight: Real,
    start_third: Real,
    complete_third: Real,
}

/// Attitude and momentum at a time.
#[derive(Clone, Debug)]
pub(crate) struct Moment {
    /// World from body, by rows.
    pub(crate) attitude: Matrix,
    /// `M/ℓ` in the body frame.
    pub(crate) direction: Vector,
}

impl Moment {
    /// The largest difference of two entries.
    pub(crate) fn distance(&self, other: &Self) -> f64 {
        let attitudes = self.attitude.iter().flatten().zip(other.attitude.iter().flatten());
        let directions = self.direction.iter().zip(&other.direction);
        attitudes.chain(directions).map(|(a, b)| nearest(&size(&(a - b)))).fold(0.0, f64::max)
    }

    /// Rounded.
    pub(crate) fn world_from_body(&self) -> DMat3 {
        let rows = self.attitude.clone().map(|row| DVec3::from_array(row.map(|x| nearest(&x))));
        DMat3::from_cols(rows[0], rows[1], rows[2]).transpose()
    }

    /// Rounded.
    pub(crate) fn momentum_direction(&self) -> DVec3 {
        DVec3::from_array(self.direction.clone().map(|x| nearest(&x)))
    }
}

/// What is known of a start in numbers of some length, and whether that was long enough.
struct Start {
    principal: Principal,
    angular_velocity: Vector,
    /// `I₂−I₁, I₃−I₁, I₃−I₂`.
    differences: Vector,
    second: Real,
    is_sure: bool,
}

impl Start {
    fn new(inertia: &Inertia, spin: &Spin, bits: usize, keep: usize) -> Self {
        let mut principal = inertia.principal(bits);
        let mut is_sure = true;
        // A result of which too little is left of what it was the difference of.
        let mut checked = |result: Real, of: isize| {
            let left = exponent(&result) - of + bits.cast_signed() - 32;
            if is_zero(&result) || left >= keep.cast_signed() {
                return result;
            }
            is_sure = false;
            real(0.0, bits)
        };
        let omega = match spin {
            Spin::Body(components) => {
                let given = vector(*components, bits);
                let omega = times(&principal.principal_from_body, &given);
                let whole = |x: &Real| is_zero(x) || size(x) == Real::from(1);
                if principal.principal_from_body.iter().flatten().all(whole) {
                    omega
                } else {
                    // Turned by rounded axes.
                    let largest = given.iter().map(exponent).max().expect("three");
                    omega.map(|x| checked(x, largest))
                }
            }
            Spin::AlongAxes(components, body_from_principal) => {
                for (n, row) in principal.principal_from_body.iter_mut().enumerate() {
                    let named = vector(body_from_principal.col(n).to_array(), bits);
                    if is_negative(&dot(row, &named)) {
                        *row = row.clone().map(|x| -x);
                    }
                }
                vector(*components, bits)
            }
        };
        let [i1, i2, i3] = &principal.moments;
        let largest = exponent(i3);
        let differences = match inertia {
            // Exact but for moments 2⁵⁰⁰ apart, whose difference is the larger one.
            Inertia::Moments(_) => [i2 - i1, i3 - i1, i3 - i2],
            _ => [i2 - i1, i3 - i1, i3 - i2].map(|x| checked(x, largest)),
        };
        let about_3 = i3 * omega[2].sqr() * &differences[2];
        let about_1 = i1 * omega[0].sqr() * &differences[0];
        let second = checked(&about_3 - &about_1, exponent(&about_3).max(exponent(&about_1)));
        Self { principal, angular_velocity: omega, differences, second, is_sure }
    }
}

impl Oracle {
    /// From what the body and its spin are given by; the attitude at the start is the identity.
    pub(crate) fn new(inertia: &Inertia, spin: &Spin) -> Self {
        Self::with_bits(inertia, spin, BITS)
    }

    /// In numbers of another length.
    pub(crate) fn with_bits(inertia: &Inertia, spin: &Spin, bits: usize) -> Self {
        let mut start = None;
        for preparation in PREPARATION {
            let at = Start::new(inertia, spin, preparation + (bits - BITS), bits);
            let is_sure = at.is_sure;
            start = Some(at);
            if is_sure {
                break;
            }
        }
        Self::of(start.expect("three lengths"), bits)
    }

    fn of(start: Start, bits: usize) -> Self {
        let short = |v: Vector| v.map(|x| with_bits(x, bits));
        let mut axes = start.principal.principal_from_body.map(short);
        let mut i = short(start.principal.moments);
        let principal = Principal { moments: i.clone(), principal_from_body: axes.clone() };
        let mut omega = short(start.angular_velocity);
        let [mut d21, mut d31, mut d32] = short(start.differences);
        let mut second = with_bits(start.second, bits);
        let is_symmetric = is_zero(&d21) || is_zero(&d32);
        let mut turning = Turning::About(3);
        if is_negative(&second) {
            // About axis 1: half a turn about the diagonal of axes 1 and 3 brings it to axis 3.
            turning = Turning::About(1);
            let reversed = |v: Vector| {
                let [x, y, z] = v;
                [z, -y, x]
            };
            let [first, middle, last] = axes;
            axes = [last, middle.map(|x| -x), first];
            omega = reversed(omega);
            let [i1, i2, i3] = i;
            i = [i3, i2, i1];
            (d21, d31, d32) = (-d32, -d31, -d21);
            second = -second;
        }
        let momentum = [0, 1, 2].map(|n| &i[n] * &omega[n]);
        let ell = root(&dot(&momentum, &momentum));
        let speed = root(&dot(&omega, &omega));
        let direction = if is_zero(&ell) { momentum.clone() } else { momentum.clone().map(|x| x / &ell) };
        let pairs = [[1, 2], [0, 2], [0, 1]];
        let is_steady = pairs
            .iter()
            .zip([&d32, &d31, &d21])
            .all(|([a, b], difference)| is_zero(&momentum[*a]) || is_zero(&momentum[*b]) || is_zero(difference));
        let mut oracle = Self {
            bits,
            turning,
            is_symmetric,
            ell,
            energy: dot(&momentum, &omega) / Real::from(2),
            principal,
            fastest: speed.clone(),
            speed,
            standard_from_body: axes,
            angular_velocity: omega,
            direction,
            orbit: None,
        };
        if is_steady {
            oracle.turning = Turning::Steady;
            return oracle;
        }
        if is_zero(&second) {
            oracle.turning = Turning::Separatrix;
        }
        let orbit = Orbit::new(&i, &oracle.angular_velocity, &oracle.ell, [&d21, &d31, &d32], &second);
        oracle.fastest = orbit.fastest(&i, &oracle.ell);
        oracle.orbit = Some(orbit);
        oracle
    }

    /// At a time.
    pub(crate) fn at(&self, time: f64) -> Moment {
        self.at_exactly(&real(time, self.bits))
    }

    pub(crate) fn at_exactly(&self, time: &Real) -> Moment {
        let Some(orbit) = &self.orbit else { return self.steady(time) };
        let (now, angle) = orbit.at(time);
        let [from, to] = [triad(&self.direction), triad(&now)];
        let (sine, cosine) = within_a_turn(&angle).sin_cos();
        let turned: Matrix = [
            from[0].clone(),
            [0, 1, 2].map(|n| &cosine * &from[1][n] + &sine * &from[2][n]),
            [0, 1, 2].map(|n| &cosine * &from[2][n] - &sine * &from[1][n]),
        ];
        self.in_body(&product(&transposed(&turned), &to), &now)
    }

    /// About Ω, which stays.
    fn steady(&self, time: &Real) -> Moment {
        let mut attitude = super::real::identity(self.bits);
        if !is_zero(&self.speed) {
            let axis = self.angular_velocity.clone().map(|x| x / &self.speed);
            let (sine, cosine) = within_a_turn(&(&self.speed * time)).sin_cos();
            for (column, e) in super::real::identity(self.bits).iter().enumerate() {
                let across = cross(&axis, e);
                let along = &axis[column] * (Real::from(1) - &cosine);
                for row in 0..3 {
                    attitude[row][column] = &cosine * &e[row] + &sine * &across[row] + &along * &axis[row];
                }
            }
        }
        self.in_body(&attitude, &self.direction)
    }

    fn in_body(&self, standard: &Matrix, direction: &Vector) -> Moment {
        let body_from_standard = transposed(&self.standard_from_body);
        Moment {
            attitude: product(&product(&body_from_standard, standard), &self.standard_from_body),
            direction: times(&body_from_standard, direction),
        }
    }

    /// Time between reversals of the momentum along the middle axis, where there is one and they come again.
    pub(crate) fn flip_period(&self) -> Option<Real> {
        let orbit = self.orbit.as_ref().filter(|_| !self.is_symmetric)?;
        Some((orbit.quarter.clone()? << 1) / &orbit.rate)
    }

    /// Time of the first reversal after the start.
    pub(crate) fn next_flip(&self) -> Option<Real> {
        let orbit = self.orbit.as_ref().filter(|_| !self.is_symmetric)?;
        let is_past = !is_negative(&orbit.start);
        let wait = match orbit.quarter.clone() {
            Some(quarter) if is_past => (quarter << 1) - &orbit.start,
            None if is_past => return None,
            _ => -&orbit.start,
        };
        Some(wait / &orbit.rate)
    }
}

impl Orbit {
    fn new(i: &Vector, omega: &Vector, ell: &Real, [d21, d31, d32]: [&Real; 3], second: &Real) -> Self {
        let [i1, i2, i3] = i;
        let bits = ell.precision();
        let m = [0, 1, 2].map(|n| &i[n] * &omega[n]);
        // ℓ² − 2K I₁ and 2K I₃ − ℓ², each with the sign of I₃ − I₁.
        let first = i2 * omega[1].sqr() * d21 + i3 * omega[2].sqr() * d31;
        let third = i1 * omega[0].sqr() * d31 + i2 * omega[1].sqr() * d32;
        let b1 = signed(sign(&m[0]), root(&(&third * i1 / d31)));
        let b3 = signed(sign(&m[2]), root(&(&first * i3 / d31)));
        let b2_sign = sign(&b1) * sign(&b3) * sign(d32);
        let b2 = signed(b2_sign, root(&(&third * i2 / d32)));
        let rate = root(&(&first * d32 / (i1 * i2 * i3)));
        let modulus =
            Modulus { k2: &third * d21 / (&first * d32), k1: root(&(second * size(d31) / (size(&first) * size(d32)))) };
        let characteristic = -(i3 * d21 / (i1 * d32));
        let [cn, sn, dn] = [&m[0] / &b1, &m[1] / &b2, &m[2] / &b3];
        let quarter = (!is_zero(&modulus.k1)).then(|| modulus.quarter_period());
        let mut orbit = Self {
            amplitudes: [b1 / ell, b2 / ell, b3 / ell],
            even_rate: ell / i3,
            third_weight: ell * d31 / (i1 * i3) / &rate,
            start: real(0.0, bits),
            start_third: real(0.0, bits),
            complete_third: real(0.0, bits),
            modulus,
            quarter,
            rate,
            characteristic,
        };
        orbit.start = if orbit.quarter.is_none() {
            // sinh u = sn/cn.
            signed(sign(&sn), (size(&sn) / &cn).asinh())
        } else {
            &sn * carlson::first_kind(&cn.sqr(), &dn.sqr(), &real(1.0, bits))
        };
        orbit.start_third = orbit.third_kind(&orbit.start, &[sn, cn, dn]);
        if let Some(quarter) = &orbit.quarter {
            let at_quarter = [real(1.0, bits), real(0.0, bits), orbit.modulus.k1.clone()];
            orbit.complete_third = orbit.third_kind(quarter, &at_quarter);
        }
        orbit
    }

    /// The largest `|Ω|`: its square is linear in sn², so that is at one end of a quarter period.
    fn fastest(&self, i: &Vector, ell: &Real) -> Real {
        let [x, y, z] = [0, 1, 2].map(|n| &self.amplitudes[n] * ell / &i[n]);
        let at_start = root(&(x.sqr() + z.sqr()));
        let at_quarter = root(&(y.sqr() + (z * &self.modulus.k1).sqr()));
        if at_start > at_quarter { at_start } else { at_quarter }
    }

    /// `∫₀^u du/(1 − n sn²u)` within a quarter period.
    fn third_kind(&self, u: &Real, [sn, cn, dn]: &[Real; 3]) -> Real {
        if is_zero(&self.characteristic) {
            return u.clone();
        }
        let one = real(1.0, u.precision());
        if self.quarter.is_none() {
            // 1/(1 + ν² tanh²u).
            let nu = root(&-&self.characteristic);
            return (u + &nu * (&nu * sn).atan()) / (one + nu.sqr());
        }
        let square = sn.sqr();
        let p = &one - &self.characteristic * &square;
        let integral = carlson::third_kind(&cn.sqr(), &dn.sqr(), &one, &p);
        u + &self.characteristic * sn * square * integral / Real::from(3)
    }

    /// `M/ℓ`, and φ.
    fn at(&self, time: &Real) -> (Vector, Real) {
        let mut u = &self.rate * time + &self.start;
        let mut complete = Real::ZERO;
        let mut is_odd = false;
        let functions = if let Some(quarter) = &self.quarter {
            let half = quarter.clone() << 1;
            let halves = (&u / &half).round();
            u -= &halves * half;
            complete = Real::from(2) * &halves * &self.complete_third;
            let pairs = (halves.clone() >> 1).floor();
            is_odd = halves != pairs << 1;
            let [s, c, d] = self.modulus.at(&size(&u));
            [signed(sign(&u), s), c, d]
        } else {
            hyperbolic(&u)
        };
        let third = self.third_kind(&u, &functions) + complete - &self.start_third;
        let angle = &self.even_rate * time + &self.third_weight * third;
        let [s, c, d] = functions;
        let parity = if is_odd { -1 } else { 1 };
        let [b1, b2, b3] = &self.amplitudes;
        ([b1 * signed(parity, c), b2 * signed(parity, s), b3 * d], angle)
    }
}

/// `[tanh, sech, sech]`; sech is 0 where it is below the last digit of tanh.
fn hyperbolic(u: &Real) -> [Real; 3] {
    let bits = u.precision();
    if size(u) > Real::from(bits) {
        return [real(f64::from(sign(u)), bits), real(0.0, bits), real(0.0, bits)];
    }
    let e = u.exp();
    let inverse = Real::from(1) / &e;
    let twice_cosh = &e + &inverse;
    let sech = Real::from(2) / &twice_cosh;
    [(e - inverse) / twice_cosh, sech.clone(), sech]
}

/// The direction of M, and the two perpendicular to it in and across the plane of axis 3, as rows; the rows of a rotation.
fn triad(m: &Vector) -> Matrix {
    let [x, y, z] = m;
    let r = root(&(x.sqr() + y.sqr()));
    [m.clone(), [-(z * x / &r), -(z * y / &r), r.clone()], [y / &r, -x / &r, Real::ZERO * x]]
}

fn within_a_turn(angle: &Real) -> Real {
    let turn = Real::pi(angle.precision()) << 1;
    let turns = (angle / &turn).round();
    angle - turns * turn
}
