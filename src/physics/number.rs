//! How a number is written wherever a person reads it: in messages, scene files and flags.

/// Characters that a power of ten must save to be written.
const WORTH: usize = 4;

/// The shortest decimals that read back to the same number, with a power of ten where it is very large or small:
/// `3`, `0.1`, `1e-300`.
#[must_use]
pub fn number(value: f64) -> String {
    let (plain, power) = (value.to_string(), format!("{value:e}"));
    match plain.as_str() {
        // What TOML takes for a whole number has no −0.
        "-0" => "-0.0".to_owned(),
        _ if power.len() + WORTH > plain.len() => plain,
        _ => power,
    }
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_are_short_and_read_back() {
        let written = [
            (3.0, "3"),
            (-3.0, "-3"),
            (0.0, "0"),
            (-0.0, "-0.0"),
            (0.1, "0.1"),
            (1e-300, "1e-300"),
            (-2.5e-7, "-2.5e-7"),
            (1e6, "1e6"),
            (1e5, "100000"),
            (-1e5, "-100000"),
            (123_456_789.0, "123456789"),
            (1e-5, "0.00001"),
            (1e-6, "1e-6"),
            (5e-324, "5e-324"),
            (f64::INFINITY, "inf"),
            (f64::NAN, "NaN"),
        ];
        for (value, text) in written {
            assert_eq!(number(value), text);
            assert!(text.parse().is_ok_and(|back: f64| back.to_bits() == value.to_bits()), "{text}");
        }
    }
}
