//! From real time to steps of simulated time.

/// What a frame's time came to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tick {
    /// Nothing: the clock is paused, or the time does not fill a step yet.
    Still,
    /// This many steps, backwards where negative.
    Steps(i64),
    /// This many steps; there was time for more, but a frame that took them all would freeze the window,
    /// so the clock runs slow instead.
    Capped(i64),
}

/// Turns the real time of a frame into whole steps. Speed changes the number of steps, never the step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    /// Whether time stands.
    pub paused: bool,
    /// Simulated seconds a real second; negative runs backwards.
    pub speed: f64,
    /// Most steps that one frame takes.
    pub most_steps: i64,
    /// Simulated time (s) not yet filled into a step.
    carried: f64,
}

impl Default for Clock {
    fn default() -> Self {
        Self { paused: false, speed: 1.0, most_steps: 200_000, carried: 0.0 }
    }
}

impl Clock {
    /// The steps that `real_seconds` of real time come to.
    pub fn tick(&mut self, real_seconds: f64, step: f64) -> Tick {
        if self.paused || !real_seconds.is_finite() || real_seconds <= 0.0 {
            return Tick::Still;
        }
        self.carried += real_seconds * self.speed;
        let wanted = (self.carried / step).trunc();
        if wanted == 0.0 {
            return Tick::Still;
        }
        let most = self.most_steps as f64;
        if wanted.abs() > most {
            self.carried = 0.0;
            return Tick::Capped(most.copysign(wanted) as i64);
        }
        self.carried -= wanted * step;
        Tick::Steps(wanted as i64)
    }

    /// Forgets the time not yet filled into a step, as after a restart.
    pub fn clear(&mut self) {
        self.carried = 0.0;
    }
}
