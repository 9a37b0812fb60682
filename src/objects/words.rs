//! The words of the field, each said in one sentence: what a hover over a name, the keyboard on it and the sheet of keys show.

/// A word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// The word itself.
    pub name: &'static str,
    /// How names in the picture and in the panels begin or end that speak of it, or the whole of them.
    marks: &'static [&'static str],
    /// What it is, in one sentence.
    pub about: &'static str,
}

/// All words. Of two that a name speaks of the first one counts.
pub static WORDS: &[Word] = &[
    word(
        "L",
        &["L", "momentum L"],
        "The angular momentum seen from the world: how much spin the body holds, and about which direction. Nothing pushes the body, so L stays.",
    ),
    word(
        "M",
        &["M"],
        "The same angular momentum seen from the body: it stays as long as L is, and its direction moves unless the spin is steady.",
    ),
    word(
        "ω",
        &["ω"],
        "The angular velocity: at this moment the body turns about this arrow, the faster the longer it is.",
    ),
    word(
        "K",
        &["K", "energy"],
        "The energy of the spin, ½ ω·L: it stays while nothing inside the body takes it; all M of this energy end on an ellipsoid.",
    ),
    word(
        "sphere",
        &["|L|"],
        "All M that are as long as L, which M must keep to. Where it crosses the ellipsoid of the energy M runs.",
    ),
    word(
        "herpolhode",
        &["herpolhode"],
        "The path on the invariable plane of the point in which the ellipsoid of inertia rolls on it: the tip of ω, seen from the world.",
    ),
    word(
        "polhode",
        &["polhode", "polhode of this energy"],
        "The path of M, seen from the body: the line where the sphere and the ellipsoid of the energy cross. ω's path on the ellipsoid of inertia has the same name.",
    ),
    word(
        "separatrix",
        &["separatrix"],
        "The border between the paths of M round axis 1 and those round axis 3. It crosses itself at the ends of axis 2.",
    ),
    word(
        "magnified",
        &["×"],
        "The end of axis 2 as through a magnifying glass, so many times as large: M's path passes it without touching the other one.",
    ),
    word(
        "summit, valley, pass",
        &["summit", "valley", "pass"],
        "With K as the height on the sphere: both ends of axis 1 are summits, both of axis 3 valleys; from those of axis 2 it is uphill to axis 1 and downhill to axis 3: passes.",
    ),
    word(
        "level set",
        &["levels of the energy", "level set"],
        "A level set of the energy: all M of one length and one energy, the path of a spin with that energy.",
    ),
    word(
        "Λ",
        &["Λ"],
        "The solid angle of M's path: how much of the sphere it goes round, on M's side; the whole sphere has 4π.",
    ),
    word("Δψ", &["Δψ"], "The angle by which the body has turned about L when M has come round its path once."),
    word(
        "axes 1, 2, 3",
        &["1", "2", "3", "axes 1, 2, 3", "axis"],
        "The principal axes of the body: 1 is the one about which it is easiest to turn (the smallest moment of inertia I₁), 3 the hardest, 2 between.",
    ),
    word(
        "invariable plane",
        &["invariable plane"],
        "The plane across L on which the ellipsoid of inertia rolls: it is as far from the centre as K and L say, so it stays.",
    ),
];

const fn word(name: &'static str, marks: &'static [&'static str], about: &'static str) -> Word {
    Word { name, marks, about }
}

/// The word that a name in the picture or the panel speaks of: `path of M (polhode)`, `3: I₃ = 0.00453`, `|M| = |L|`.
#[must_use]
pub fn word_of(name: &str) -> Option<&'static Word> {
    let bare = |part: &str| {
        part.trim_matches(|sign: char| sign == '(' || sign == ')' || sign == ':' || sign == ',').to_owned()
    };
    let parts: Vec<String> = name.split_whitespace().map(bare).collect();
    let (first, last) = (parts.first()?, parts.last()?);
    // The field's word stands last, in brackets or after its value's name; the number of an axis stands first.
    let found = |text: &str| WORDS.iter().find(|word| word.name == text || word.marks.contains(&text));
    let lower = name.trim().to_lowercase();
    found(name.trim()).or_else(|| found(&lower)).or_else(|| found(last)).or_else(|| found(first))
}

#[cfg(test)]
mod tests {
    use super::{WORDS, word_of};

    #[test]
    fn names_of_the_picture_and_the_panel_find_their_word() {
        for (name, word) in [
            ("L", "L"),
            ("momentum L", "L"),
            ("energy K", "K"),
            ("same energy (K)", "K"),
            ("M", "M"),
            ("ω", "ω"),
            ("ω from axes 1, 2, 3", "axes 1, 2, 3"),
            ("path of M (polhode)", "polhode"),
            ("polhode of this energy", "polhode"),
            ("path of ω (herpolhode)", "herpolhode"),
            ("border (separatrix)", "separatrix"),
            ("same length |L|", "sphere"),
            ("Levels of the energy", "level set"),
            ("2: top", "axes 1, 2, 3"),
            ("1: summit", "summit, valley, pass"),
            ("2 (bottom): pass", "summit, valley, pass"),
            ("3: I₃ = 0.00453", "axes 1, 2, 3"),
            ("invariable plane", "invariable plane"),
            ("6·10⁶ ×", "magnified"),
        ] {
            assert_eq!(word_of(name).map(|word| word.name), Some(word), "{name}");
        }
        for name in ["", "top", "spins this way round, always", "Runge–Kutta 4"] {
            assert_eq!(word_of(name), None, "{name}");
        }
    }

    #[test]
    fn every_word_is_said_in_a_few_sentences_of_its_own() {
        for (number, word) in WORDS.iter().enumerate() {
            assert!(word.about.ends_with('.') && word.about.chars().count() < 190, "{}", word.name);
            assert!(WORDS[..number].iter().all(|other| other.name != word.name && other.about != word.about));
            assert_eq!(word_of(word.name), Some(word));
        }
        for name in ["L", "M", "ω", "K", "polhode", "herpolhode", "separatrix", "level set"] {
            assert!(WORDS.iter().any(|word| word.name == name), "{name}");
        }
    }
}
