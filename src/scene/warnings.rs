//! What is unusual about a scene that can all the same be run.

use super::Scene;
use crate::physics::number;

impl Scene {
    /// What is unusual about a scene that can all the same be run: a sentence each.
    #[must_use]
    pub fn warnings(&self) -> Vec<String> {
        let moments = || self.body.principal_moments().to_array().map(number).join(", ");
        let excess = self.body.triangle_excess().map(|ratio| {
            format!(
                "moments {}: the largest is {} the sum of the others and no solid has such moments; it goes on all the same",
                moments(),
                times(ratio)
            )
        });
        let beyond = (!self.body.is_within_bounds()).then(|| {
            format!("moments {}: where moments are so far apart no error of the attitude is promised", moments())
        });
        let names = &self.file.motion.compare;
        let repeated =
            names.iter().enumerate().find(|(index, name)| names.iter().take(*index).any(|other| other == *name));
        let repeated = repeated.map(|(_, name)| {
            format!("method `{name}` stands more than once among those beside the body's own: it is followed once")
        });
        excess.into_iter().chain(beyond).chain(repeated).collect()
    }
}

/// How a ratio above 1 compares, before "the sum": by times, or by what it has above where a rounded ratio would be 1.
fn times(ratio: f64) -> String {
    match ratio {
        ratio if !ratio.is_finite() => "more than 1e308 times".to_owned(),
        ratio if ratio >= 1e6 => format!("{ratio:.2e} times").replace(".00e", "e"),
        ratio if ratio >= 1.001 => format!("{} times", number((ratio * 1000.0).round() / 1000.0)),
        ratio => format!("1 + {:.1e} times", ratio - 1.0),
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::{Scene, SceneError, SceneFile};

    fn warnings(text: &str) -> Result<Vec<String>, SceneError> {
        Ok(Scene::check(&SceneFile::parse(text)?)?.warnings())
    }

    #[test]
    fn moments_no_solid_has_are_said() -> Result<(), SceneError> {
        for (moments, largest) in [
            ("1, 5, 1e-9", "moments 1e-9, 1, 5: the largest is 5 times"),
            ("1, 2, 3.5", "moments 1, 2, 3.5: the largest is 1.167 times"),
            ("1, 2, 3.0000003", "moments 1, 2, 3.0000003: the largest is 1 + 1.0e-7 times"),
            ("1e-300, 1, 1e300", "moments 1e-300, 1, 1e300: the largest is 1e300 times"),
            ("1e-300, 1, 1.234e6", "moments 1e-300, 1, 1234000: the largest is 1.23e6 times"),
        ] {
            let said =
                format!("{largest} the sum of the others and no solid has such moments; it goes on all the same");
            assert_eq!(warnings(&format!("body.moments = [{moments}]"))?.first(), Some(&said));
        }
        Ok(())
    }

    #[test]
    fn moments_too_far_apart_for_the_bounds_are_said() -> Result<(), SceneError> {
        let said = "moments 1e-60, 1, 1: where moments are so far apart no error of the attitude is promised";
        assert_eq!(warnings("body.moments = [1, 1e-60, 1]")?, [said]);
        for (moments, count) in [("1, 1, 1e-50", 0), ("1, 2, 1e5", 1), ("1, 2, 1e6", 2), ("1e-300, 1, 1e300", 2)] {
            assert_eq!(warnings(&format!("body.moments = [{moments}]"))?.len(), count, "{moments}");
        }
        Ok(())
    }

    #[test]
    fn a_method_named_twice_is_followed_once_and_said() -> Result<(), SceneError> {
        let text = "motion.compare = ['rk4', 'buss', 'rk4', 'buss', 'exact-step']";
        let scene = Scene::check(&SceneFile::parse(text)?)?;
        assert_eq!(scene.compare.iter().map(|method| method.name).collect::<Vec<_>>(), ["rk4", "buss"]);
        let said = "method `rk4` stands more than once among those beside the body's own: it is followed once";
        assert_eq!(scene.warnings(), [said]);
        assert_eq!(warnings("motion.compare = ['rk4', 'buss']")?, [""; 0]);
        Ok(())
    }
}
