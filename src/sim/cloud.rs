//! Starts close together and their motions, all exact.

use glam::{DMat3, DQuat, DVec3};

use crate::physics::{Batch, Body, State, so3};
use crate::scene;

/// The angle that is farthest from all fractions of a turn, `π(3 − √5)`: points a turn by it apart fill a disc evenly.
const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;

/// Starts round principal axes, each with the L of the scene's own, and where they are at any time.
#[derive(Clone, Debug)]
pub struct Cloud {
    batch: Batch,
    /// Of each start, the principal axis, from 0, round which it is.
    axes: Vec<usize>,
    /// The starts round the axis that the scene's own is nearest to.
    nearest: Vec<State>,
}

impl Cloud {
    /// The cloud that a scene has. Round each axis, at the end on the scene's own side, the starts fill a disc of the sphere evenly.
    pub(super) fn new(cloud: &scene::Cloud, body: &Body, start: &State) -> Self {
        let ell = so3::norm(start.body_momentum);
        let principal = body.body_from_principal().transpose() * start.body_momentum;
        let (mut states, mut axes) = (vec![], vec![]);
        if ell > 0.0 {
            for (place, axis) in cloud.axes.iter().map(|axis| usize::from(*axis) - 1).enumerate() {
                // What does not divide goes to the first ones.
                let count = (cloud.count + cloud.axes.len() - 1 - place) / cloud.axes.len();
                let side = if principal[axis] < 0.0 { -1.0 } else { 1.0 };
                for n in 0..count {
                    let momentum = on_disc(axis, side, cloud.spread, n, count) * ell;
                    states.push(turned_under(body, start, body.body_from_principal() * momentum));
                    axes.push(axis);
                }
            }
        }
        let size = |axis: &&usize| principal[**axis].abs();
        let nearest = axes.iter().max_by(|a, b| size(a).total_cmp(&size(b))).copied();
        let of_nearest = states.iter().zip(&axes).filter(|(_, axis)| Some(**axis) == nearest);
        let nearest = of_nearest.map(|(state, _)| *state).collect();
        Self { batch: Batch::of_starts(body, &states), axes, nearest }
    }

    /// Of each start the principal axis, from 0, round which it is, and its body momentum (kg m²/s) at a time (s).
    pub fn momenta_at(&self, time: f64) -> impl Iterator<Item = (usize, DVec3)> {
        self.axes.iter().copied().zip(self.batch.momenta_at(time))
    }

    /// At most so many of the starts round the axis that the scene's own is nearest to, from one side of their disc to the other.
    #[must_use]
    pub fn handful(&self, most: usize) -> Vec<State> {
        let step = self.nearest.len().div_ceil(most.max(1)).max(1);
        // From the rim: there they are farthest from each other.
        self.nearest.iter().rev().step_by(step).copied().collect()
    }
}

/// The direction of the `n`th of `count` points evenly over a disc of the sphere about an axis, the rim `spread` (rad) away from it.
fn on_disc(axis: usize, side: f64, spread: f64, n: usize, count: usize) -> DVec3 {
    // Equal areas: the height above the disc's plane is even.
    let part = (n as f64 + 0.5) / count as f64;
    let half_sine = (0.5 * spread).sin() * part.sqrt();
    // 1 − cos θ = 2 sin² θ/2.
    let along = 1.0 - 2.0 * half_sine * half_sine;
    let across = 2.0 * half_sine * (1.0 - half_sine * half_sine).sqrt();
    let (sine, cosine) = (GOLDEN_ANGLE * n as f64).sin_cos();
    let [next, last] = [(axis + 1) % 3, (axis + 2) % 3].map(|axis| DVec3::AXES[axis]);
    side * along * DVec3::AXES[axis] + across * (cosine * next + sine * last)
}

/// The start with this body momentum (kg m²/s, of the length of the start's own) and the same L: the body turned under it by the shortest way.
fn turned_under(body: &Body, start: &State, momentum: DVec3) -> State {
    let turn = DQuat::from_rotation_arc(momentum.normalize(), start.body_momentum.normalize());
    let world_from_body = start.world_from_body * DMat3::from_quat(turn);
    State::new(body, world_from_body, body.angular_velocity(momentum))
}

#[cfg(test)]
mod tests {
    use crate::physics::{Motion, so3};
    use crate::scene::{Scene, SceneError, SceneFile};
    use crate::sim::Simulation;

    fn simulation(text: &str) -> Result<Simulation, SceneError> {
        Ok(Simulation::new(&Scene::check(&SceneFile::parse(text)?)?))
    }

    #[test]
    fn the_starts_are_round_their_axes_with_the_momentum_of_the_scene() -> Result<(), SceneError> {
        let simulation = simulation(
            "cloud = { count = 100, spread_deg = 4, axes = [1, 3] }\nspin = { omega = [1, 5, -0.3], attitude = [0.5, 0.5, 0.5, -0.5] }",
        )?;
        let body = simulation.body();
        let ell = so3::norm(simulation.start().body_momentum);
        let momenta: Vec<_> = simulation.cloud().momenta_at(0.0).collect();
        assert_eq!(momenta.len(), 100);
        let mut farthest = 0.0_f64;
        for (axis, momentum) in momenta {
            assert!((so3::norm(momentum) / ell - 1.0).abs() < 1e-14);
            let principal = body.body_from_principal().transpose() * momentum / ell;
            assert!([(0, 1.0), (2, -1.0)].contains(&(axis, principal[axis].signum())), "{axis} {principal}");
            let angle = principal.cross(glam::DVec3::AXES[axis]).length().asin().to_degrees();
            farthest = farthest.max(angle);
        }
        // The outermost of fifty lies within √(1 − 1/100) of the rim.
        assert!((3.97..=4.0).contains(&farthest), "{farthest}");
        for state in simulation.cloud().handful(8) {
            let error = state.world_from_body * state.body_momentum - simulation.start().world_momentum;
            assert!(so3::norm(error) < 1e-14 * ell);
        }
        assert_eq!(simulation.cloud().handful(8).len(), 8);
        Ok(())
    }

    /// Round axes 1 and 3 they stay a clump; round axis 2 they go all the way.
    #[test]
    fn round_the_middle_axis_alone_they_are_drawn_out() -> Result<(), SceneError> {
        let simulation = simulation("cloud = { count = 300, spread_deg = 2 }\nspin = { rate = 6 }")?;
        let (body, ell) = (simulation.body(), so3::norm(simulation.start().body_momentum));
        let mut least = [1.0_f64; 3];
        for (axis, momentum) in simulation.cloud().momenta_at(20.0) {
            let principal = body.body_from_principal().transpose() * momentum / ell;
            least[axis] = least[axis].min(principal[axis]);
        }
        assert!(least[0] > 0.9 && least[2] > 0.9 && least[1] < -0.9, "{least:?}");
        Ok(())
    }

    #[test]
    fn every_one_is_exact() -> Result<(), SceneError> {
        let simulation = simulation("cloud = { count = 30, axes = [2] }\nspin = { rate = 6 }")?;
        let (body, ell) = (simulation.body(), so3::norm(simulation.start().body_momentum));
        let at_start = simulation.cloud().handful(30);
        let mut later: Vec<_> = simulation.cloud().momenta_at(7.0).map(|(_, momentum)| momentum).collect();
        later.reverse();
        for (start, momentum) in at_start.iter().zip(later) {
            let exact = Motion::new(body, start).momentum(7.0);
            assert!(so3::norm(exact - momentum) < 1e-12 * ell);
        }
        let at_rest = self::simulation("spin.rate = 0")?;
        assert_eq!(at_rest.cloud().momenta_at(1.0).count(), 0);
        Ok(())
    }
}
