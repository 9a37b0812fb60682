//! The motion in closed form: attitude and momentum at any time, directly.

mod path;
mod rates;

use glam::{DMat3, DVec3};

pub(crate) use path::{Path, SeriesNumbers};
pub(crate) use rates::rates;

use super::orbit::Orbit;
use super::start::Start;
use super::{Body, State};

/// A motion prepared from a body and its state at time 0: [`Motion::state`] goes to any time at once.
///
/// Momentum in the principal frame, with the axes so named that it circles axis 3:
///
/// ```text
/// M = (B₁ cn u, s₂ B₂ sn u, B₃ dn u),   u = λt + u₀,   λ² = Δ₁(I₃−I₂)/(I₁I₂I₃)
/// ```
///
/// Attitude: `R(t) = R(0) P(0)ᵀ R_z(ψ(t)) P(t)`, where `P(t)` is the shortest rotation that takes `M(t)/ℓ` to `e₃`, and
/// `ψ = ψ̄ t + 2σ(χ(u) − χ(u₀))` with a constant mean rate `ψ̄` and a bounded `χ` that is a quotient of theta series.
///
/// Degenerate cases, each of them a limit that its neighbours approach: on the separatrix sn, cn, dn are tanh, sech, sech;
/// where the momentum stays put (a spin about a principal axis, the sphere, the plane of two equal moments, rest) the body turns
/// evenly about it; with two equal moments the series have one term.
///
/// SI units. Total: any finite time gives a rotation and a finite momentum, for every valid body. The motion is that of the numbers as they were
/// given: of a start's angular velocity, of a box's edges, of a tensor's entries, of solids. On which side of the separatrix they lie is
/// found without rounding, principal moments and axes to 106 bits and more, both rates to 100, and phases are reduced before use. So
/// attitude and momentum are good to 1e-13 up to some 10¹³ rad (seen: 1.1e-14), in turned frames too; beyond 10³⁰ turns no digit of a phase is left, and what
/// is returned is a state on the right orbit. Of moments that no solid has, the further the fewer digits of the attitude are left; moments further apart than
/// 2¹⁸⁰ are taken as that far apart. See [`bounds`](super::bounds) and [`Body::is_within_bounds`].
///
/// Preparing costs about a microsecond, two where a hard case needs digits; three where a tensor is turned beside an axis of its own.
///
/// Source: Jacobi, J. reine angew. Math. 39 (1849) 293, with the singularity of his angles removed; van Zon & Schofield,
/// J. Comput. Phys. 225 (2007) 145.
#[derive(Clone, Debug)]
pub struct Motion {
    path: Path,
    start: State,
    /// `R(0) P(0)ᵀ` with the share of ψ that belongs to `u₀`.
    world_from_start: DMat3,
    orbit_from_body: DMat3,
    /// With the unit of momentum.
    body_from_orbit: DMat3,
}

impl Motion {
    /// Prepares the motion of a body from its state at time 0.
    #[must_use]
    pub fn new(body: &Body, start: &State) -> Self {
        Self::with_orbit(body, start).0
    }

    /// The same with the orbit on which it lies.
    pub(crate) fn with_orbit(body: &Body, start: &State) -> (Self, Orbit) {
        let orbit = Orbit::new(&Start::new(body, start));
        let body_from_orbit = body.body_from_principal() * orbit.principal_from_standard;
        let path = Path::new(&orbit);
        let start_inverse = DMat3::from_quat(path.start_inverse());
        let motion = Self {
            path,
            start: *start,
            world_from_start: start.world_from_body * body_from_orbit * start_inverse,
            orbit_from_body: body_from_orbit.transpose(),
            body_from_orbit: orbit.with_momentum_unit(body_from_orbit),
        };
        (motion, orbit)
    }

    /// The motion on its orbit, without the frames of body and world.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// `R(0) P(0)ᵀ` with the share of ψ that belongs to `u₀`; what takes the body's frame to the orbit's; and momenta back, with
    /// their unit.
    pub(crate) fn frames(&self) -> [DMat3; 3] {
        [self.world_from_start, self.orbit_from_body, self.body_from_orbit]
    }

    /// The state that a rotation since the start and a momentum, both in the orbit's frame and units, amount to.
    pub(crate) fn state_of(&self, start_from_now: DMat3, momentum: DVec3) -> State {
        let world_from_orbit = self.start.world_from_body * self.orbit_from_body.transpose();
        let world_from_body = world_from_orbit * (start_from_now * self.orbit_from_body);
        State::from_parts(world_from_body, self.body_from_orbit * momentum, self.start.world_momentum)
    }

    /// The state at time 0.
    pub(crate) fn start(&self) -> &State {
        &self.start
    }

    /// Attitude `R`, `world_from_body`, and body momentum `M` (kg m²/s) at a time (s).
    #[must_use]
    pub fn at(&self, time: f64) -> (DMat3, DVec3) {
        let (frame, momentum) = self.path.frame_at(time);
        let attitude = self.world_from_start * (DMat3::from_quat(frame) * self.orbit_from_body);
        (attitude, self.body_from_orbit * momentum)
    }

    /// Attitude `R`, `world_from_body`, at a time (s).
    #[must_use]
    pub fn attitude(&self, time: f64) -> DMat3 {
        self.at(time).0
    }

    /// Body momentum `M` (kg m²/s) at a time (s).
    #[must_use]
    pub fn momentum(&self, time: f64) -> DVec3 {
        self.body_from_orbit * self.path.momentum(time)
    }

    /// The state at a time (s). At 0 the start itself, bit for bit; world momentum is the start's at any time.
    #[must_use]
    pub fn state(&self, time: f64) -> State {
        if time == 0.0 {
            return self.start;
        }
        let (world_from_body, body_momentum) = self.at(time);
        State::from_parts(world_from_body, body_momentum, self.start.world_momentum)
    }
}
