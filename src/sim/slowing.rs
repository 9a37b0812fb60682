//! Slow motion round each flip: how fast time runs beside its own speed, a smooth function of simulated time alone.

/// How fast time runs in the middle of a flip, beside its own speed.
const SLOWEST: f64 = 0.2;
/// Reach of slow motion before and after a flip, in times in which a small tilt grows by e. The momentum along the middle axis is
/// about `tanh(σt)` of the whole there, so within two of them it goes from −0.96 to 0.96.
const REACH: f64 = 2.0;

/// The flips of a motion, as slow motion needs them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slowing {
    /// Any flip (s).
    first: f64,
    /// Time between flips (s), where there is more than one.
    period: Option<f64>,
    /// How far (s) from a flip time runs slowly.
    reach: f64,
}

impl Slowing {
    /// Round a flip at this time (s) and those a period (s) apart; the growth rate (1/s) of a tilt says how long a flip takes.
    #[must_use]
    pub fn new(first: f64, period: Option<f64>, growth_rate: f64) -> Option<Self> {
        let reach = REACH / growth_rate;
        (first.is_finite() && reach.is_normal()).then_some(Self { first, period, reach })
    }

    /// The flip (s) nearest to a time (s).
    #[must_use]
    pub fn nearest_flip(&self, time: f64) -> f64 {
        match self.period {
            Some(period) => self.first + ((time - self.first) / period).round() * period,
            None => self.first,
        }
    }

    /// How far (s) from a flip time runs slowly.
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.reach
    }

    /// How fast time runs at a time (s), beside its own speed: 1 far from a flip. It changes smoothly.
    #[must_use]
    pub fn factor(&self, time: f64) -> f64 {
        let far = ((time - self.nearest_flip(time)) / self.reach).abs().min(1.0);
        // The share is 0 at the flip and 1 from the reach on, level at both.
        SLOWEST + (1.0 - SLOWEST) * (far * far * (3.0 - 2.0 * far))
    }
}

#[cfg(test)]
mod tests {
    use super::{SLOWEST, Slowing};

    #[test]
    fn time_is_slowest_at_each_flip_and_its_own_far_from_them() -> Result<(), &'static str> {
        let slowing = Slowing::new(2.0, Some(4.0), 4.0).ok_or("it flips")?;
        assert_eq!(slowing.reach(), 0.5);
        for flip in [-2.0, 2.0, 6.0, 4002.0] {
            assert_eq!(slowing.factor(flip), SLOWEST);
            assert_eq!([flip - 0.5, flip + 0.5, flip + 1.9].map(|time| slowing.factor(time)), [1.0; 3]);
            // Half way out half of it is left, by symmetry.
            let half = 1.0 - 0.5 * (1.0 - SLOWEST);
            assert!((slowing.factor(flip + 0.25) - half).abs() < 1e-12 && slowing.nearest_flip(flip + 1.0) == flip);
        }
        let once = Slowing::new(2.0, None, 4.0);
        assert!(once.is_some_and(|once| once.factor(6.0) == 1.0 && once.factor(2.0) == SLOWEST));
        assert_eq!((Slowing::new(2.0, None, 0.0), Slowing::new(f64::NAN, None, 1.0)), (None, None));
        Ok(())
    }
}
