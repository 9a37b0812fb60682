//! Numbers as people read them.

/// `1.2 × 10⁻¹⁶`: two digits and a power of ten; 0 as it is.
#[must_use]
pub fn scientific(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return "not finite".to_owned();
    }
    let written = format!("{value:.1e}");
    let (digits, exponent) = written.split_once('e').unwrap_or((written.as_str(), "0"));
    format!("{}×10{}", digits.replace('-', "−"), superscript(exponent))
}

/// A number with about `digits` significant digits, without an exponent where it is neither large nor small.
#[must_use]
pub fn significant(value: f64, digits: i32) -> String {
    let magnitude = value.abs();
    if magnitude != 0.0 && !(1e-4..1e6).contains(&magnitude) {
        return scientific(value);
    }
    let before = if magnitude == 0.0 { 1 } else { magnitude.log10().floor() as i32 + 1 };
    let decimals = (digits - before).clamp(0, 9) as usize;
    format!("{value:.decimals$}").replace('-', "−")
}

/// Without the zeros at the end of a decimal fraction.
#[must_use]
pub fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// A speed as teachers say it: `1/8×`, `2×`.
#[must_use]
pub fn speed(factor: f64) -> String {
    let size = factor.abs();
    let sign = if factor < 0.0 { "−" } else { "" };
    let inverse = 1.0 / size;
    if size < 1.0 && (inverse - inverse.round()).abs() < 1e-9 {
        format!("{sign}1/{inverse:.0}×")
    } else {
        format!("{sign}{}×", trimmed(&format!("{size:.2}")))
    }
}

/// A length of time (s) in the unit that people would say it in.
#[must_use]
pub fn duration(seconds: f64) -> String {
    const MINUTE: f64 = 60.0;
    const HOUR: f64 = 3600.0;
    const DAY: f64 = 86_400.0;
    const YEAR: f64 = 365.25 * DAY;
    let said = |value: f64, unit: &str| format!("{} {unit}", trimmed(&significant(value, 3)));
    match seconds.abs() {
        size if size < 100.0 => format!("{seconds:.1} s").replace('-', "−"),
        size if size < 20.0 * MINUTE => format!("{seconds:.0} s").replace('-', "−"),
        size if size < 3.0 * HOUR => said(seconds / MINUTE, "min"),
        size if size < 2.0 * DAY => said(seconds / HOUR, "h"),
        size if size < 2.0 * YEAR => said(seconds / DAY, "days"),
        _ => said(seconds / YEAR, "years"),
    }
}

fn superscript(digits: &str) -> String {
    digits
        .chars()
        .map(|digit| match digit {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            '0' | '4'..='9' => char::from_u32(0x2070 + digit as u32 - '0' as u32).unwrap_or(digit),
            other => other,
        })
        .collect()
}

/// One digit and a power of ten: for numbers that only matter by their size.
#[must_use]
pub fn scientific_short(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return scientific(value);
    }
    let written = format!("{value:.0e}");
    let (digits, exponent) = written.split_once('e').unwrap_or((written.as_str(), "0"));
    format!("{}·10{}", digits.replace('-', "−"), superscript(exponent))
}

/// `10⁻³` for -3.
#[must_use]
pub fn power_of_ten(exponent: f64) -> String {
    format!("10{}", superscript(&format!("{exponent:.0}")))
}

#[cfg(test)]
mod tests {
    use super::duration;

    #[test]
    fn a_long_time_is_said_in_years() {
        assert_eq!(duration(4.021), "4.0 s");
        assert_eq!(duration(135.1), "135 s");
        assert_eq!(duration(5400.0), "90 min");
        assert_eq!(duration(100_000.0), "27.8 h");
        assert_eq!(duration(12_060_919_784.8), "382 years");
        assert_eq!(duration(-0.3), "−0.3 s");
    }
}
