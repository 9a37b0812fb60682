//! Flips as they happen: the momentum along the middle axis changes its sign.

use crate::physics::{State, poinsot};

use super::Simulation;

/// Notes the flips that a simulation goes through and measures the time between them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FlipWatch {
    last: Option<(f64, State)>,
    latest: Option<f64>,
    between: Option<f64>,
}

impl FlipWatch {
    /// Looks at the simulation; to be called at short intervals.
    pub fn watch(&mut self, simulation: &Simulation) {
        let body = simulation.body();
        let along_middle = |state: &State| (body.body_from_principal().transpose() * state.body_momentum).y;
        let now = (simulation.time(), *simulation.state());
        let Some((time, before)) = self.last.replace(now) else { return };
        if along_middle(&before) * along_middle(&now.1) >= 0.0 || time == now.0 {
            return;
        }
        // Where the motion that the method had reached at the earlier of the two moments goes through 0: however much time
        // lies between two looks, and whatever the method did before.
        let (earlier, state) = if time < now.0 { (time, before) } else { now };
        if let Some(after) = poinsot::next_flip_of(body, &state) {
            let crossed = earlier + after;
            self.between = self.latest.map(|latest| (crossed - latest).abs());
            self.latest = Some(crossed);
        }
    }

    /// Time was set anew: what comes is not measured from what was.
    pub fn jump(&mut self) {
        self.last = None;
        self.latest = None;
    }

    /// Time (s) between the last two flips seen.
    #[must_use]
    pub fn between(&self) -> Option<f64> {
        self.between
    }
}

#[cfg(test)]
mod tests {
    use super::FlipWatch;
    use crate::physics::poinsot;
    use crate::scene::{Scene, SceneError, preset};
    use crate::sim::Simulation;

    /// Looks an eighth of the period apart, of which a straight line makes a tenth of a second.
    #[test]
    fn the_time_between_flips_does_not_depend_on_how_often_one_looks() -> Result<(), SceneError> {
        let scene = Scene::check(&preset("flip")?.read()?)?;
        let period = poinsot::flip_period_of(&scene.body, &scene.start).unwrap_or_default();
        for direction in [1.0, -1.0] {
            let mut simulation = Simulation::new(&scene);
            let mut watch = FlipWatch::default();
            for look in 0..40 {
                simulation.go_to(direction * f64::from(look) * period / 8.0);
                watch.watch(&simulation);
            }
            // ε in the time of each crossing, at up to five periods.
            let measured = watch.between().unwrap_or_default();
            assert!((measured - period).abs() < 1e-12 * period, "{measured} {period}");
            // The last one lies on the way that was looked at, whole periods from the first that comes.
            let latest = watch.latest.unwrap_or_default();
            assert!((3.8..4.875).contains(&(latest * direction / period)), "{latest} {period}");
            let first = poinsot::next_flip_of(&scene.body, &scene.start).unwrap_or_default();
            let periods = (latest - first) / period;
            assert!((periods - periods.round()).abs() < 1e-12, "{latest} {first} {period}");
        }
        Ok(())
    }
}
