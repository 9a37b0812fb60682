//! The elliptic functions against 80-digit values, another crate, and the identities they live by.
#![allow(
    clippy::expect_used,
    clippy::unreadable_literal,
    reason = "a test fails by the one; values stand as they were computed"
)]

mod common;

use std::f64::consts::{FRAC_PI_2, PI};

use common::{EPS, Random, assert_at_most};
use dzhanibekov::physics::elliptic::{
    Jacobi, arithmetic_geometric_mean, complete_first_kind, complete_second_kind, incomplete_first_kind,
};

/// `(k′², u, [sn, cn, dn])`, from 80-digit arithmetic with these binary k′² and u.
#[rustfmt::skip]
const FUNCTIONS: [(f64, f64, [f64; 3]); 20] = [
    (1e-30, 0.1, [0.09966799462495582, 0.9950207489532265, 0.9950207489532265]),
    (1e-30, 1.5, [0.9051482536448664, 0.4250960349422805, 0.4250960349422805]),
    (1e-30, 7.25, [0.9999989913051835, 0.0014203480613358733, 0.0014203480613358733]),
    (1e-30, -30.5, [-1.0, 1.1351150227541053e-13, 1.1351590702989837e-13]),
    (1e-16, 1.5, [0.9051482536448665, 0.42509603494228043, 0.42509603494228054]),
    (1e-16, 7.25, [0.9999989913051837, 0.0014203480613182724, 0.001420348061353475]),
    (1e-16, -30.5, [-0.9999999757476727, -0.00022023772160779283, 0.00022023772183482024]),
    (1e-8, 1.5, [0.9051482552300871, 0.4250960315669025, 0.4250960412034704]),
    (1e-8, 7.25, [0.9999989938035955, 0.0014185879587023556, 0.0014221082154503566]),
    (1e-8, -30.5, [0.9999999859119999, -0.00016785708233984985, 0.00019538679538261313]),
    (0.01, 1.5, [0.9067272595112288, 0.4217175320747961, 0.4313550974437002]),
    (0.01, 7.25, [0.14034691513193648, -0.9901023903682634, 0.9902018561782338]),
    (0.01, -30.5, [-0.7336207464573877, 0.6795591220543693, 0.6835075671590126]),
    (0.3, 1.5, [0.9469465262132326, 0.32139115808107055, 0.6101676765815149]),
    (0.3, -30.5, [0.9354941999953701, -0.35334204642955036, 0.6224109745517955]),
    (0.5, 7.25, [-0.16515762392802943, 0.9862671845187021, 0.9931573287396231]),
    (0.5, -30.5, [-0.712460573755624, 0.7017121424372013, 0.8638286667053273]),
    (0.75, 7.25, [0.48105173181064004, 0.8766922101410415, 0.9706427292420708]),
    (0.999999, 1.5, [0.9974949613253432, 0.07073755813252242, 0.9999995025017773]),
    (0.999999, -30.5, [0.7931319570389728, 0.6090498327095485, 0.9999996854707999]),
];

/// `(sine, cosine, k′², F)`, from 60-digit arithmetic: angles beyond the digits of their sine, k′ far below the square of the cosine and far above.
#[rustfmt::skip]
const INCOMPLETE: [(f64, f64, f64, f64); 6] = [
    (1.0, 2.008318038325701e-27, 2.3303206360420486e-278, 62.165647116491),
    (1.0, 1e-100, 1e-200, 230.7634300735049),
    (1.0, 3e-08, 1e-30, 18.0152156358442),
    (-1.0, 1e-05, 1e-19, -12.206072645305174),
    (1.0, 0.5, 1e-17, 1.4436354751788103),
    (1.0, 1e-150, 1e-20, 24.412145291060348),
];

/// `(k′², K, E)`.
#[rustfmt::skip]
const INTEGRALS: [(f64, f64, f64); 8] = [
    (1e-30, 35.92507075603058, 1.0),
    (1e-16, 19.806975105072258, 1.0000000000000009),
    (1e-8, 10.59663475708766, 1.0000000504831739),
    (0.01, 3.6956373629898747, 1.015993545025224),
    (0.3, 2.075363135292469, 1.2416705679458226),
    (0.5, 1.8540746773013719, 1.3506438810476755),
    (0.75, 1.685750354812596, 1.4674622093394272),
    (0.999999, 1.5707967194941992, 1.5707959340957414),
];

/// Parameters from 1e-30 to 1, thickest at the ends and where the two series meet.
fn parameters(random: &mut Random, count: usize) -> Vec<f64> {
    let mut all = vec![0.0, 1e-30, 0.5, 0.5 - EPS, 0.5 + EPS, 1.0 - EPS, 1.0];
    for _ in 0..count {
        all.push(10f64.powf(random.between(-30.0, 0.0)));
        all.push(1.0 - 10f64.powf(random.between(-16.0, 0.0)));
        all.push(0.5 + 1e-3 * random.between(-1.0, 1.0));
    }
    all
}

/// The documented bound: 4ε(1 + |u|).
#[test]
fn functions_to_a_few_ulps() {
    for (parameter, u, expected) in FUNCTIONS {
        let values = Jacobi::new(parameter).at(u);
        for (value, expected) in values.iter().zip(expected) {
            assert_at_most((value - expected).abs(), 4.0 * EPS * (1.0 + u.abs()), &format!("k'2 {parameter} u {u}"));
        }
    }
}

#[test]
fn complete_integrals() {
    for (parameter, first, second) in INTEGRALS {
        assert_at_most((complete_first_kind(parameter) / first - 1.0).abs(), 4.0 * EPS, &format!("K {parameter}"));
        let bound = 4.0 * EPS * (1.0 + first);
        assert_at_most((complete_second_kind(parameter) / second - 1.0).abs(), bound, &format!("E {parameter}"));
    }
    assert_eq!(complete_first_kind(1.0), FRAC_PI_2);
    assert_eq!(complete_second_kind(1.0), FRAC_PI_2);
    assert_eq!(complete_first_kind(0.0), f64::INFINITY);
    assert_eq!(complete_second_kind(0.0), 1.0);
    assert_eq!(arithmetic_geometric_mean(0.0, 3.0), 0.0);
    // Gauss' constant.
    let gauss = 1.0 / arithmetic_geometric_mean(1.0, 2f64.sqrt());
    assert_at_most((gauss - 0.834_626_841_674_073_2).abs(), 2.0 * EPS, "Gauss' constant");
}

#[test]
fn incomplete_integrals() {
    for (sine, cosine, parameter, expected) in INCOMPLETE {
        let error = (incomplete_first_kind(sine, cosine, parameter) / expected - 1.0).abs();
        assert_at_most(error, 8.0 * EPS, &format!("F of {sine}, {cosine:e}, k'2 {parameter:e}"));
    }
}

/// Another crate, from the parameter m = 1 − k′²: where m itself is exact, and to its own 7e-16.
#[test]
fn integrals_of_another_crate() {
    let mut random = Random::new(11);
    for _ in 0..2_000 {
        let parameter = random.between(0.5, 1.0);
        let m = 1.0 - parameter;
        let first = ellip::ellipk(m).expect("in its domain");
        let second = ellip::ellipe(m).expect("in its domain");
        assert_at_most((complete_first_kind(parameter) / first - 1.0).abs(), 8.0 * EPS, "K");
        assert_at_most((complete_second_kind(parameter) / second - 1.0).abs(), 16.0 * EPS, "E");
        let angle = random.between(-FRAC_PI_2, FRAC_PI_2);
        let incomplete = ellip::ellipf(angle, m).expect("in its domain");
        let ours = incomplete_first_kind(angle.sin(), angle.cos(), parameter);
        assert_at_most((ours - incomplete).abs(), 8.0 * EPS * (1.0 + incomplete.abs()), "F");
    }
}

/// `EK′ + E′K − KK′ = π/2`, Legendre's relation; each product may be some K K′ in size.
#[test]
fn legendre_relation() {
    let mut random = Random::new(12);
    for _ in 0..1_000 {
        let parameter = random.between(0.01, 0.99);
        let (k, e) = (complete_first_kind(parameter), complete_second_kind(parameter));
        let (k1, e1) = (complete_first_kind(1.0 - parameter), complete_second_kind(1.0 - parameter));
        assert_at_most((e * k1 + e1 * k - k * k1 - FRAC_PI_2).abs(), 16.0 * EPS * k * k1 * (k + k1), "Legendre");
    }
}

/// `sn² + cn² = 1`, `dn² = cn² + k′² sn²`: a few roundings of numbers up to 1.
#[test]
fn pythagoras() {
    let mut random = Random::new(13);
    for parameter in parameters(&mut random, 3_000) {
        let jacobi = Jacobi::new(parameter);
        let [sn, cn, dn] = jacobi.at(random.between(-50.0, 50.0));
        assert_at_most((sn * sn + cn * cn - 1.0).abs(), 8.0 * EPS, "sn2 + cn2");
        assert_at_most((cn * cn + parameter * sn * sn - dn * dn).abs(), 8.0 * EPS, &format!("dn2, k'2 {parameter:e}"));
        assert!(dn >= 0.0);
    }
}

/// `am F(φ) = φ`, and `F = K` at a right angle. φ is conditioned by dn, at most 1.
#[test]
fn amplitude_inverts_the_integral() {
    let mut random = Random::new(14);
    for parameter in parameters(&mut random, 3_000) {
        let jacobi = Jacobi::new(parameter);
        let angle = random.between(-1.57, 1.57);
        let u = incomplete_first_kind(angle.sin(), angle.cos(), parameter);
        let bound = 16.0 * EPS * (1.0 + u.abs());
        assert_at_most((jacobi.amplitude(u) - angle).abs(), bound, &format!("k'2 {parameter:e}, {angle}"));
        if parameter > 0.0 {
            let quarter = incomplete_first_kind(1.0, 0.0, parameter);
            assert_at_most((quarter / jacobi.quarter_period() - 1.0).abs(), 8.0 * EPS, "F(π/2)");
            let turn = jacobi.amplitude(4.0 * jacobi.quarter_period() + u);
            let bound = 16.0 * EPS * (1.0 + 4.0 * jacobi.quarter_period() + u.abs());
            assert_at_most((turn - angle - 2.0 * PI).abs(), bound, &format!("a period on, k'2 {parameter:e}"));
        }
    }
}

/// Addition theorem (DLMF 22.8): the values at u + v from those at u and v.
#[test]
fn addition_theorem() {
    let mut random = Random::new(15);
    for parameter in parameters(&mut random, 1_000) {
        let jacobi = Jacobi::new(parameter);
        let (u, v) = (random.between(-3.0, 3.0), random.between(-1.0, 1.0));
        let ([s, c, d], [s1, c1, d1], [sn, cn, dn]) = (jacobi.at(u), jacobi.at(v), jacobi.at(u + v));
        // 1 − k² s² s₁², without 1 − k′².
        let denominator = (c * c + s * s * d1 * d1).max(1e-3);
        let bound = 64.0 * EPS / denominator;
        let what = format!("k'2 {parameter:e} u {u} v {v}");
        assert_at_most((sn * denominator - (s * c1 * d1 + c * s1 * d)).abs(), bound, &what);
        assert_at_most((cn * denominator - (c * c1 - s * s1 * d * d1)).abs(), bound, &what);
        assert_at_most((dn * denominator - (d * d1 - (1.0 - parameter) * s * s1 * c * c1)).abs(), bound, &what);
    }
}

/// The halves of a quarter period: `sn² = 1/(1 + k′)`, `dn² = k′`.
#[test]
fn half_a_quarter_period() {
    let mut random = Random::new(16);
    for parameter in parameters(&mut random, 1_000) {
        if parameter == 0.0 {
            continue;
        }
        let jacobi = Jacobi::new(parameter);
        let [sn, cn, dn] = jacobi.at(0.5 * jacobi.quarter_period());
        let k1 = parameter.sqrt();
        let bound = 4.0 * EPS * (1.0 + jacobi.quarter_period());
        assert_at_most((sn - (1.0 / (1.0 + k1)).sqrt()).abs(), bound, "sn");
        assert_at_most((cn - (k1 / (1.0 + k1)).sqrt()).abs(), bound, "cn");
        assert_at_most((dn - k1.sqrt()).abs(), bound, "dn");
    }
}

#[test]
fn limits() {
    for u in [0.0, 0.3, -1.0, 5.0, -40.0, 800.0] {
        let [sn, cn, dn] = Jacobi::new(0.0).at(u);
        assert_at_most((sn - u.tanh()).abs(), EPS, "tanh");
        assert_at_most((cn - 1.0 / u.cosh()).abs(), 2.0 * EPS, "sech");
        assert_eq!(cn, dn);
        let [sn, cn, dn] = Jacobi::new(1.0).at(u);
        let bound = 4.0 * EPS * (1.0 + u.abs());
        assert_at_most((sn - u.sin()).abs(), bound, "sin");
        assert_at_most((cn - u.cos()).abs(), bound, "cos");
        assert_eq!(dn, 1.0);
    }
}
