//! Numbers for people.

/// Two digits and an exponent, all of one width: `1.2e-09`; zero as `0`.
#[must_use]
pub fn short(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return "–".to_owned();
    }
    let text = format!("{value:.1e}");
    match text.split_once('e') {
        Some((digits, exponent)) => {
            let (sign, exponent) = exponent.strip_prefix('-').map_or(('+', exponent), |exponent| ('-', exponent));
            format!("{digits}e{sign}{exponent:0>2}")
        }
        None => text,
    }
}

/// A time in the unit that suits it: `27.3 ns`, `1.2 ms`.
#[must_use]
pub fn time(seconds: f64) -> String {
    let (factor, unit) = match seconds {
        s if s < 1e-6 => (1e9, "ns"),
        s if s < 1e-3 => (1e6, "µs"),
        s if s < 1.0 => (1e3, "ms"),
        _ => (1.0, "s"),
    };
    let value = seconds * factor;
    let digits = usize::from(value < 99.95);
    format!("{value:.digits$} {unit}")
}

/// A factor: one decimal below a hundred, none above.
#[must_use]
pub fn times(factor: f64) -> String {
    let digits = usize::from(factor < 99.95);
    format!("{factor:.digits$}")
}

/// A power of ten with a raised exponent.
#[must_use]
pub fn power_of_ten(exponent: i32) -> String {
    let mut text = "10".to_owned();
    for character in exponent.to_string().chars() {
        text.push(match character {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            digit => char::from_u32('⁰' as u32 + digit.to_digit(10).unwrap_or(0)).unwrap_or('⁰'),
        });
    }
    text
}

/// Text that stands for itself in HTML and SVG.
#[must_use]
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_of_one_width() {
        assert_eq!(short(1.234e-9), "1.2e-09");
        assert_eq!(short(3.0e120), "3.0e+120");
        assert_eq!(short(0.0), "0");
        assert_eq!(time(27.34e-9), "27.3 ns");
        assert_eq!(time(1.2e-3), "1.2 ms");
        assert_eq!(power_of_ten(-12), "10⁻¹²");
        assert_eq!(power_of_ten(40), "10⁴⁰");
        assert_eq!(escape("<a & \"b\">"), "&lt;a &amp; &quot;b&quot;&gt;");
    }
}
