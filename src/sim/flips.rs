//! Flips as they happen: the momentum along the middle axis changes its sign.

use super::Simulation;

/// Notes the flips that a simulation goes through and measures the time between them.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FlipWatch {
    last: Option<(f64, f64)>,
    latest: Option<f64>,
    between: Option<f64>,
}

impl FlipWatch {
    /// Looks at the simulation; to be called at short intervals.
    pub fn watch(&mut self, simulation: &Simulation) {
        let body = simulation.body();
        let along_middle = (body.body_from_principal().transpose() * simulation.state().body_momentum).y;
        let now = (simulation.time(), along_middle);
        if let Some((time, before)) = self.last.replace(now)
            && before * along_middle < 0.0
        {
            // Between two looks the momentum runs as good as straight through 0.
            let crossed = time + (now.0 - time) * before / (before - along_middle);
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
