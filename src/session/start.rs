//! Other starts with the same momentum: a given energy, the separatrix, a nudge. Principal components throughout.

use glam::{DMat3, DVec3};

use crate::physics::{Body, State, so3};

/// Angle (rad) of a nudge.
const POKE: f64 = std::f64::consts::PI / 180.0;
/// Tilt (rad) from the middle axis of a start on the separatrix that would else stay on the axis for ever.
const OFF_AXIS: f64 = 1e-3;

/// Squares of the components of `M/ℓ`, with signs kept aside.
struct Shares {
    squares: DVec3,
    signs: DVec3,
    ell: f64,
}

impl Shares {
    fn of(momentum: DVec3) -> Option<Self> {
        let ell = so3::norm(momentum);
        if !(ell > 0.0 && ell.is_finite()) {
            return None;
        }
        let unit = momentum / ell;
        let signs = unit.map(|component| if component < 0.0 { -1.0 } else { 1.0 });
        Some(Self { squares: unit * unit, signs, ell })
    }

    fn momentum(&self) -> DVec3 {
        self.signs * self.squares.max(DVec3::ZERO).map(f64::sqrt) * self.ell
    }
}

/// The momentum of this length and energy (J) that is nearest to the present one along the middle axis: where it can,
/// `M₂` stays. `None` where two moments are equal or nothing turns.
pub(super) fn with_energy(body: &Body, momentum: DVec3, energy: f64) -> Option<DVec3> {
    let inverse = body.principal_moments().recip();
    let mut start = Shares::of(momentum)?;
    if inverse.x == inverse.y || inverse.y == inverse.z {
        return None;
    }
    // Σ sᵢ = 1 and Σ sᵢ/Iᵢ = e.
    let e = (2.0 * energy / start.ell / start.ell).clamp(inverse.z, inverse.x);
    let middle = start.squares.y;
    let first = (e - middle * inverse.y - (1.0 - middle) * inverse.z) / (inverse.x - inverse.z);
    let third = 1.0 - middle - first;
    start.squares = if first < 0.0 {
        let middle = (e - inverse.z) / (inverse.y - inverse.z);
        DVec3::new(0.0, middle, 1.0 - middle)
    } else if third < 0.0 {
        let middle = (inverse.x - e) / (inverse.x - inverse.y);
        DVec3::new(1.0 - middle, middle, 0.0)
    } else {
        DVec3::new(first, middle, third)
    };
    Some(start.momentum())
}

/// The momentum of this length on the separatrix, as near to the middle axis as the present one but never on it,
/// on the branch that leaves the axis.
pub(super) fn on_separatrix(body: &Body, momentum: DVec3) -> Option<DVec3> {
    let i = body.principal_moments();
    let mut start = Shares::of(momentum)?;
    if i.x == i.y || i.y == i.z {
        return None;
    }
    let aside = (1.0 - start.squares.y).max(OFF_AXIS * OFF_AXIS);
    // M₁ = ±κ M₃ with κ² = I₁(I₃−I₂)/(I₃(I₂−I₁)).
    let slope_squared = i.x * (i.z - i.y) / (i.z * (i.y - i.x));
    let third = aside / (1.0 + slope_squared);
    start.squares = DVec3::new(aside - third, 1.0 - aside, third);
    // Ṁ₂ = M₁M₃(1/I₁ − 1/I₃): towards the axis where it has the sign of M₂.
    if start.signs.x * start.signs.z * start.signs.y > 0.0 {
        start.signs.x = -start.signs.x;
    }
    Some(start.momentum())
}

/// A small nudge that keeps the world momentum: the body is turned a little under it.
pub(super) fn poked(body: &Body, state: &State) -> State {
    let momentum = state.body_momentum;
    let axes = body.body_from_principal();
    // Across the momentum, towards both stable axes alike: any motion notices it.
    let across = momentum.cross(axes.x_axis + axes.z_axis);
    if across == DVec3::ZERO {
        return *state;
    }
    let turn: DMat3 = so3::exp(across.normalize() * POKE);
    let world_from_body = state.world_from_body * turn.transpose();
    State::new(body, world_from_body, body.angular_velocity(turn * momentum))
}

#[cfg(test)]
mod tests {
    use super::{on_separatrix, poked, with_energy};
    use crate::physics::{Body, BodyError, MotionClass, State, poinsot};
    use glam::{DMat3, DVec3};

    fn body() -> Result<Body, BodyError> {
        Body::from_moments(DVec3::new(0.5, 0.85, 1.0))
    }

    #[test]
    fn a_start_of_any_energy_has_it_and_the_same_momentum() -> Result<(), BodyError> {
        let body = body()?;
        for momentum in [DVec3::new(0.2, 0.9, -0.1), DVec3::new(0.0, 2.0, 1e-7), DVec3::new(1.0, 0.0, 0.3)] {
            let ell = momentum.length();
            for energy in [0.5, 0.55, 1.0 / 1.7, 0.6, 0.8, 1.0].map(|share| share * ell * ell) {
                let found = with_energy(&body, momentum, energy).unwrap_or_default();
                assert!((body.energy(found) - energy).abs() < 1e-14 * energy, "{found} {energy}");
                assert!((found.length() - ell).abs() < 1e-14 * ell, "{found}");
                // A component keeps its side; of one that is naught it is the positive one.
                let sides = found.to_array().into_iter().zip(momentum.to_array());
                assert!(sides.into_iter().all(|(now, then)| now == 0.0 || (now < 0.0) == (then < 0.0)), "{found}");
            }
        }
        Ok(())
    }

    #[test]
    fn the_separatrix_is_the_separatrix_and_flips_once() -> Result<(), BodyError> {
        let body = body()?;
        // On the axis, and off it to all sides.
        let sides = |n: i32| [0, 1, 2].map(|axis| if n >> axis & 1 == 0 { 1.0 } else { -1.0 });
        let aside = (0..8).map(|n| DVec3::new(0.3, 0.6, 0.2) * DVec3::from(sides(n)));
        for momentum in aside.chain([DVec3::Y, DVec3::NEG_Y, DVec3::ONE]) {
            let found = on_separatrix(&body, momentum).unwrap_or_default();
            assert_eq!(poinsot::classify(&body, found), MotionClass::Separatrix, "{found}");
            assert!(poinsot::next_flip(&body, found).is_some(), "{found} must flip");
            // Euler's equation, Ṁ = M×Ω: it leaves the end of the axis that it is near.
            let rate = found.cross(body.angular_velocity(found));
            assert!(rate.y * found.y < 0.0, "{found} moves by {rate}");
            // Of the same length and as near to the axis, but for a start on it.
            assert!((found.length() - momentum.length()).abs() < 1e-15 * 4.0, "{found}");
            let nearest = momentum.length() * (1.0 - 1e-6_f64).sqrt();
            assert!((found.y.abs() - momentum.y.abs().min(nearest)).abs() < 1e-15 * 4.0, "{found}");
            assert_eq!(found.y < 0.0, momentum.y < 0.0);
        }
        Ok(())
    }

    #[test]
    fn where_nothing_turns_there_is_nothing_to_choose() -> Result<(), BodyError> {
        let body = body()?;
        for momentum in [DVec3::ZERO, DVec3::NAN, DVec3::INFINITY] {
            assert_eq!((with_energy(&body, momentum, 1.0), on_separatrix(&body, momentum)), (None, None), "{momentum}");
        }
        for moments in [DVec3::new(0.5, 1.0, 1.0), DVec3::new(0.5, 0.5, 0.8)] {
            let body = Body::from_moments(moments)?;
            assert_eq!((with_energy(&body, DVec3::ONE, 1.0), on_separatrix(&body, DVec3::ONE)), (None, None));
        }
        Ok(())
    }

    #[test]
    fn a_poke_keeps_the_world_momentum() -> Result<(), BodyError> {
        let body = body()?;
        let state = State::new(&body, DMat3::from_rotation_x(0.7), DVec3::new(0.1, 2.0, 0.3));
        let after = poked(&body, &state);
        assert!((after.world_momentum - state.world_momentum).length() < 1e-15);
        assert!((after.body_momentum - state.body_momentum).length() > 0.01);
        // From the middle axis to between the others' positive ends.
        let after = poked(&body, &State::new(&body, DMat3::IDENTITY, DVec3::Y)).body_momentum;
        assert!(after.x > 0.005 && (after.x - after.z).abs() < 1e-15, "{after}");
        Ok(())
    }
}
