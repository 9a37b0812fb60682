//! Starts close together: what a scene says of its cloud.

use super::{SceneError, SceneFile};

/// Starts of a scene's cloud that names no number, and most that there may be.
const DEFAULT_STARTS: i64 = 900;
const MOST_STARTS: i64 = 100_000;
/// How far (degrees) they are from their axis at most, where the scene does not say.
const DEFAULT_SPREAD: f64 = 3.0;

/// Starts close together, of the same momentum as the scene's own.
#[derive(Clone, Debug, PartialEq)]
pub struct Cloud {
    /// How many in all.
    pub count: usize,
    /// How far (rad) from their axis they are at most.
    pub spread: f64,
    /// The principal axes, from 1, round which they are.
    pub axes: Vec<u8>,
}

impl Cloud {
    /// Checks what a file says of it.
    pub(super) fn check(file: &SceneFile) -> Result<Self, SceneError> {
        let cloud = &file.cloud;
        let count = cloud.count.unwrap_or(DEFAULT_STARTS);
        if !(1..=MOST_STARTS).contains(&count) {
            let value = count as f64;
            return Err(SceneError::OutOfRange { name: "count of the cloud", value, wanted: "between 1 and 100000" });
        }
        let spread = cloud.spread_deg.unwrap_or(DEFAULT_SPREAD);
        if !(0.0..=90.0).contains(&spread) {
            let wanted = "between 0 and 90 degrees";
            return Err(SceneError::OutOfRange { name: "spread of the cloud", value: spread, wanted });
        }
        let is_meant = |axis: &u8| cloud.axes.is_empty() || cloud.axes.contains(axis);
        let axes = [1, 2, 3].into_iter().filter(is_meant).collect();
        Ok(Self { count: count as usize, spread: spread.to_radians(), axes })
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::{Cloud, Scene, SceneError, SceneFile};

    fn check(text: &str) -> Result<Cloud, SceneError> {
        Ok(Scene::check(&SceneFile::parse(text)?)?.cloud)
    }

    #[test]
    fn a_cloud_is_as_it_is_said() -> Result<(), SceneError> {
        let cloud = check("cloud = { count = 10000, spread_deg = 90, axes = [3, 2, 3] }")?;
        assert_eq!((cloud.count, &cloud.axes[..]), (10_000, &[2, 3][..]));
        assert_eq!(cloud.spread, std::f64::consts::FRAC_PI_2);
        assert_eq!(check("cloud.spread_deg = 0")?.axes, [1, 2, 3]);
        Ok(())
    }

    #[test]
    fn a_cloud_that_cannot_be_is_refused() {
        for (text, sentence) in [
            ("cloud.count = 0", "count of the cloud 0 is not valid: it must be between 1 and 100000"),
            ("cloud.count = 100001", "count of the cloud 100001 is not valid: it must be between 1 and 100000"),
            ("cloud.spread_deg = -1", "spread of the cloud -1 is not valid: it must be between 0 and 90 degrees"),
            ("cloud.spread_deg = nan", "spread of the cloud NaN is not valid: it must be between 0 and 90 degrees"),
        ] {
            let said = check(text).map_or_else(|error| error.to_string(), |_| "no refusal".to_owned());
            assert_eq!(said, sentence, "{text}");
        }
    }
}
