//! The nearest known name to one that is not known.

use super::SceneError;

/// Lengths of a name that can stand for another: of two letters anything is far, and no known name is half as long as 64.
const LENGTHS: std::ops::RangeInclusive<usize> = 3..=64;

/// The known name nearest to `given`, where any is near enough to be meant: one slip in three or four letters and another
/// in every three more (a letter more, less, other, or two swapped), or a word of it (`symmetric` for `symmetric-top`).
pub fn nearest<'a>(given: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let length = given.chars().count();
    if !LENGTHS.contains(&length) {
        return None;
    }
    let given = given.to_lowercase().replace('_', "-");
    known
        .into_iter()
        .filter_map(|name| {
            let plain = name.replace('_', "-");
            let slips = strsim::damerau_levenshtein(&given, &plain);
            (slips <= (length + 1) / 3 || is_part(&given, &plain)).then_some((slips, name))
        })
        .min_by_key(|(slips, _)| *slips)
        .map(|(_, name)| name)
}

/// Whether one begins the other, or is a whole word of it.
fn is_part(given: &str, name: &str) -> bool {
    name.starts_with(given) || name.split('-').any(|word| word == given)
}

impl SceneError {
    /// An unknown name, with the nearest of those that are known, or all of them: that serves in every front end, also where
    /// no command would list them.
    pub(crate) fn unknown_name<'a>(kind: &'static str, given: &str, known: impl IntoIterator<Item = &'a str>) -> Self {
        let known: Vec<&str> = known.into_iter().collect();
        let hint = match nearest(given, known.iter().copied()) {
            Some(near) => format!("the nearest is `{near}`"),
            None => format!("there are {}", known.join(", ")),
        };
        Self::UnknownName { kind, given: given.to_owned(), hint }
    }
}

#[cfg(test)]
mod tests {
    use super::{SceneError, nearest};

    const KNOWN: [&str; 7] = ["flip", "symmetric-top", "near-separatrix", "rk4", "body", "poles", "spin"];

    #[test]
    fn a_slip_is_seen() {
        for (given, meant) in [
            ("flop", "flip"),
            ("filp", "flip"),
            ("FLIP", "flip"),
            ("spn", "spin"),
            ("xxles", "poles"),
            ("rk5", "rk4"),
            ("bodys", "body"),
            ("symetric_top", "symmetric-top"),
            ("symmetric", "symmetric-top"),
            ("separatrix", "near-separatrix"),
            ("sym", "symmetric-top"),
        ] {
            assert_eq!(nearest(given, KNOWN), Some(meant), "{given}");
        }
    }

    #[test]
    fn what_is_far_is_not_said() {
        let long = "flip".repeat(17);
        for given in ["", "x", "fl", "rk", "fxyp", "xxxes", "floor", "pole-star", "wheel", "separate", "parat", &long] {
            assert_eq!(nearest(given, KNOWN), None, "{given}");
        }
    }

    #[test]
    fn the_nearer_of_two_is_said() {
        assert_eq!(nearest("poley", ["polxx", "poles"]), Some("poles"));
        assert_eq!(nearest("abcdefghi", ["abcdefxyz", "abcdefghx"]), Some("abcdefghx"));
    }

    #[test]
    fn a_name_that_none_is_near_is_refused_with_all_that_there_are() {
        for (given, sentence) in [
            ("flop", "scene `flop` is not known: the nearest is `flip`"),
            (
                "qqqqq",
                "scene `qqqqq` is not known: there are flip, symmetric-top, near-separatrix, rk4, body, poles, spin",
            ),
            (
                "a\nb",
                r"scene `a\nb` is not known: there are flip, symmetric-top, near-separatrix, rk4, body, poles, spin",
            ),
        ] {
            assert_eq!(SceneError::unknown_name("scene", given, KNOWN).to_string(), sentence);
        }
    }
}
