//! The whole check of a scene: what [`Scene::check`] sees, and the names of what is drawn.

use super::{OBJECTS, object_named};
use crate::scene::{ALL, Scene, SceneError, SceneFile};

/// Checks a scene that is to be drawn. Every way in goes through here: command line, file, folder, clipboard, link.
///
/// # Errors
/// See [`SceneError`].
pub fn check(file: &SceneFile) -> Result<Scene, SceneError> {
    check_at(file, None)
}

/// The same, of a scene that is to be drawn as it is at this step, counted from 0.
///
/// # Errors
/// See [`SceneError`].
pub fn check_at(file: &SceneFile, at: Option<usize>) -> Result<Scene, SceneError> {
    let scene = Scene::check_at(file, at)?;
    let of_steps = file.steps.iter().flat_map(|step| step.show.iter().chain(&step.hide));
    let mut named = file.view.show.iter().chain(&file.view.hide).chain(of_steps);
    match named.find(|name| *name != ALL && object_named(name).is_none()) {
        None => Ok(scene),
        Some(name) => Err(SceneError::unknown_name("object", name, OBJECTS.iter().map(|object| object.name))),
    }
}

#[cfg(test)]
mod tests {
    use super::check;
    use crate::scene::{SceneError, SceneFile, presets};

    #[test]
    fn every_built_in_scene_names_what_is_drawn() -> Result<(), SceneError> {
        for preset in presets() {
            check(&preset.read()?)?;
        }
        Ok(())
    }

    #[test]
    fn a_name_that_is_not_drawn_is_refused_with_the_nearest_where_one_is_near() -> Result<(), SceneError> {
        for (key, name, hint) in [
            ("show", "axis-tail", "object `axis-tail` is not known: the nearest is `axis-trail`"),
            ("hide", "shadows", "object `shadows` is not known: the nearest is `shadow`"),
            ("hide", "carpet", "object `carpet` is not known: there are shadow, plane, "),
        ] {
            for place in [format!("view.{key}"), format!("[[step]]\n[[step]]\n{key}")] {
                let file = SceneFile::parse(&format!("{place} = [\"body\", \"all\", \"{name}\"]"))?;
                let said = check(&file).map_or_else(|error| error.to_string(), |_| "no refusal".to_owned());
                assert!(said.starts_with(hint), "{said}");
            }
        }
        Ok(())
    }
}
