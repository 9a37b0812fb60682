//! The `shot` command that draws what is shown.

use crate::scene::{SceneFile, flags, quoted};

/// The command for a scene at a step and a time (s) in a picture of this size, said as what differs from the scene of this name.
pub(super) fn shot(
    name: &str,
    base: &SceneFile,
    file: &SceneFile,
    step: Option<usize>,
    time: f64,
    size: [u32; 2],
) -> String {
    let mut words = vec!["dzhanibekov".to_owned(), "shot".to_owned(), name.to_owned()];
    words.extend(flags(base, file));
    words.extend(step.into_iter().flat_map(|step| ["--scene-step".to_owned(), (step + 1).to_string()]));
    words.extend([
        "--time".to_owned(),
        rounded_time(time).to_string(),
        "--size".to_owned(),
        format!("{}x{}", size[0], size[1]),
    ]);
    words.extend(["-o".to_owned(), format!("{}.png", slug(&file.title))]);
    quoted(&words)
}

/// Without the digits that adding up steps leaves at the end: a nanosecond is nothing to see.
pub(super) fn rounded_time(time: f64) -> f64 {
    if time.abs() < 1e6 { (time * 1e9).round() / 1e9 } else { time }
}

/// A title as a file name: letters, digits and dashes.
#[must_use]
pub fn slug(title: &str) -> String {
    let mut slug = String::new();
    for character in title.chars().take(60) {
        if character.is_alphanumeric() {
            slug.extend(character.to_lowercase());
        } else if !slug.is_empty() && !slug.ends_with('-') {
            slug.push('-');
        }
    }
    let slug = slug.trim_end_matches('-');
    if slug.is_empty() { "scene".to_owned() } else { slug.to_owned() }
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_slug_is_a_file_name() {
        assert_eq!(super::slug("The flip"), "the-flip");
        assert_eq!(super::slug("../etc: x?"), "etc-x");
        assert_eq!(super::slug("  "), "scene");
    }
    #[test]
    fn a_time_is_said_to_the_nanosecond() {
        for (time, said) in [
            (0.1 + 0.2, 0.3),
            (-1.25, -1.25),
            (2.345_678_901_4, 2.345_678_901),
            (999_999.1 + 1e-10, 999_999.1),
            (1e6 + 1e-9, 1e6 + 1e-9),
        ] {
            assert_eq!(super::rounded_time(time), said);
        }
    }
}
