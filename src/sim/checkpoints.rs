//! The way back of a method whose steps are not undone by steps the other way.

use crate::physics::{Integration, MethodError};

/// Most places kept; past that every second one goes.
const MOST: usize = 256;

/// Places along the way of an integration. Where energy is lost, steps the other way would magnify whatever was rounded, by as much as the
/// wobbles had died away: what lies behind is taken again from the last place before it, and has the same bits as the first time.
#[derive(Clone, Debug)]
pub(super) struct Checkpoints {
    /// At the start, then outwards from it, all to one side.
    kept: Vec<Integration>,
    /// Steps between them.
    spacing: i64,
}

impl Checkpoints {
    /// None but the start.
    pub(super) fn new(start: &Integration) -> Self {
        Self { kept: vec![start.clone()], spacing: 64 }
    }

    /// Brings the integration to this step, counted from the start.
    pub(super) fn go_to(&mut self, integration: &mut Integration, target: i64) -> Result<(), MethodError> {
        let is_before = |kept: &Integration| is_on_the_way(kept.steps(), target);
        if !is_on_the_way(integration.steps(), target) {
            let last = self.kept.iter().rev().find(|kept| is_before(kept));
            // The start is on the way to anything.
            integration.clone_from(last.unwrap_or(&self.kept[0]));
        }
        // The other side of the start has places of its own.
        if !self.kept.last().is_some_and(|last| last.steps() == 0 || last.steps().signum() * target.signum() >= 0) {
            self.kept.truncate(1);
        }
        while integration.steps() != target {
            let left = target - integration.steps();
            integration.advance(left.clamp(-self.spacing, self.spacing))?;
            self.note(integration);
        }
        Ok(())
    }

    /// Keeps a place that is far enough from the last one.
    fn note(&mut self, integration: &Integration) {
        let last = self.kept.last().map_or(0, Integration::steps);
        if integration.steps().abs() < last.abs() + self.spacing {
            return;
        }
        self.kept.push(integration.clone());
        if self.kept.len() > MOST {
            let mut index = 0;
            self.kept.retain(|_| {
                index += 1;
                index % 2 == 1
            });
            self.spacing *= 2;
        }
    }
}

#[cfg(test)]
impl Checkpoints {
    /// The steps of the places, counted from the start.
    pub(super) fn places(&self) -> Vec<i64> {
        self.kept.iter().map(Integration::steps).collect()
    }
}

/// Whether a step lies between the start and another, or is that one.
fn is_on_the_way(step: i64, target: i64) -> bool {
    step == 0 || step.signum() == target.signum() && step.abs() <= target.abs()
}

#[cfg(test)]
mod tests {
    use super::{Checkpoints, MOST};
    use crate::physics::{Integration, MethodError};
    use crate::scene::{Scene, SceneError, SceneFile};
    use crate::sim::Simulation;
    use crate::sim::tests::LOSING;

    fn integration() -> Result<Integration, SceneError> {
        let simulation = Simulation::new(&Scene::check(&SceneFile::parse(LOSING)?)?);
        let method = simulation.main().method();
        Ok(Integration::with_energy_loss(method, simulation.body(), *simulation.start(), 0.01, 0.05))
    }

    /// What makes a way back short: places evenly on the way, kept while time goes to and fro on one side of the start.
    #[test]
    fn places_lie_evenly_and_stay_until_the_other_side_is_asked_for() -> Result<(), SceneError> {
        let mut integration = integration()?;
        let mut checkpoints = Checkpoints::new(&integration);
        let mut go_to = |checkpoints: &mut Checkpoints, target| -> Result<i64, MethodError> {
            checkpoints.go_to(&mut integration, target)?;
            Ok(integration.steps())
        };
        assert_eq!(go_to(&mut checkpoints, 300).ok(), Some(300));
        assert_eq!(checkpoints.places(), [0, 64, 128, 192, 256]);
        assert_eq!(go_to(&mut checkpoints, 100).ok(), Some(100));
        assert_eq!(checkpoints.places(), [0, 64, 128, 192, 256]);
        assert_eq!(go_to(&mut checkpoints, -70).ok(), Some(-70));
        assert_eq!(checkpoints.places(), [0, -64]);
        assert_eq!(go_to(&mut checkpoints, 10).ok(), Some(10));
        assert_eq!(checkpoints.places(), [0]);
        // As many as there may be, and then half of them.
        assert_eq!(go_to(&mut checkpoints, 0).ok(), Some(0));
        let full = 64 * 255;
        assert_eq!(go_to(&mut checkpoints, full).ok(), Some(full));
        assert_eq!(checkpoints.places().len(), MOST);
        assert_eq!(go_to(&mut checkpoints, full + 64).ok(), Some(full + 64));
        let half: Vec<i64> = (0..=128).map(|place| 128 * place).collect();
        assert_eq!(checkpoints.places(), half);
        // From then on twice as far apart.
        assert_eq!(go_to(&mut checkpoints, full + 192).ok(), Some(full + 192));
        assert_eq!(checkpoints.places().split_last(), Some((&(full + 192), &half[..])));
        Ok(())
    }
}
