//! When the next frame is due. Presenting does not hold a software renderer back, so frames are paced here.

use web_time::{Duration, Instant};

/// A gap longer than this (the window was hidden, the machine slept) is not played after.
const LONGEST_FRAME: Duration = Duration::from_millis(250);
/// Over how long the real-time factor is measured.
const MEASURED: Duration = Duration::from_millis(500);

/// Paces frames and measures how fast simulated time really runs.
#[derive(Debug)]
pub struct Pacer {
    period: Duration,
    /// The earliest time of the next frame.
    due: Instant,
    last_tick: Option<Instant>,
    measured: Option<(Instant, f64)>,
    real_time_factor: Option<f64>,
}

impl Pacer {
    /// A pacer that begins now.
    #[must_use]
    pub fn new(now: Instant) -> Self {
        Self { period: Duration::from_millis(16), due: now, last_tick: None, measured: None, real_time_factor: None }
    }

    /// Fits the period to a monitor. Fast monitors get every second or third frame: more than 60 show nothing more.
    /// Slightly shorter than the monitor's own period, so that a display that does hold frames back sets the beat.
    pub fn set_refresh_rate(&mut self, millihertz: Option<u32>) {
        let hertz = f64::from(millihertz.unwrap_or(60_000)) / 1e3;
        let hertz = if (20.0..1000.0).contains(&hertz) { hertz } else { 60.0 };
        let every = (hertz / 76.0).ceil();
        self.period = Duration::from_secs_f64(0.97 * every / hertz);
    }

    /// The earliest time of the next frame.
    #[must_use]
    pub fn due(&self) -> Instant {
        self.due
    }

    /// A frame begins.
    pub fn begin(&mut self, now: Instant) {
        // After a late frame the beat starts anew rather than catching up.
        let next = self.due + self.period;
        self.due = if next > now { next } else { now + self.period };
    }

    /// The real time (s) since the last frame that was played.
    pub fn tick(&mut self, now: Instant) -> f64 {
        let passed = self.last_tick.replace(now).map_or(Duration::ZERO, |last| now - last);
        if passed > LONGEST_FRAME {
            // Not played, so not measured either.
            self.measured = None;
            return self.period.as_secs_f64();
        }
        passed.as_secs_f64()
    }

    /// Playing has stopped: the time until it goes on is not played.
    pub fn stand(&mut self) {
        self.last_tick = None;
        self.measured = None;
        self.real_time_factor = None;
    }

    /// Follows simulated time (s); it jumps after a restart, which starts the measurement anew.
    pub fn measure(&mut self, now: Instant, simulated: f64, has_jumped: bool) {
        match self.measured {
            Some((since, at)) if !has_jumped => {
                if now - since >= MEASURED {
                    self.real_time_factor = Some((simulated - at) / (now - since).as_secs_f64());
                    self.measured = Some((now, simulated));
                }
            }
            _ => self.measured = Some((now, simulated)),
        }
    }

    /// Simulated seconds a real second, as measured while playing.
    #[must_use]
    pub fn real_time_factor(&self) -> Option<f64> {
        self.real_time_factor
    }
}
