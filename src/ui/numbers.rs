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

/// A day (s).
pub const DAY: f64 = 86_400.0;

/// A length of time (s) in the unit that people would say it in.
#[must_use]
pub fn duration(seconds: f64) -> String {
    const MINUTE: f64 = 60.0;
    const HOUR: f64 = 3600.0;
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

/// What a unit measures; numbers are turned into one unit of the same kind from another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Measures {
    Length,
    Time,
    Angle,
    Rate,
    Inertia,
    Energy,
}

/// The units that a field takes, each with its size in SI units.
const UNITS: &[(&str, Measures, f64)] = &[
    ("m", Measures::Length, 1.0),
    ("cm", Measures::Length, 1e-2),
    ("mm", Measures::Length, 1e-3),
    ("s", Measures::Time, 1.0),
    ("ms", Measures::Time, 1e-3),
    ("µs", Measures::Time, 1e-6),
    ("us", Measures::Time, 1e-6),
    ("min", Measures::Time, 60.0),
    ("h", Measures::Time, 3600.0),
    ("d", Measures::Time, DAY),
    ("°", Measures::Angle, std::f64::consts::PI / 180.0),
    ("deg", Measures::Angle, std::f64::consts::PI / 180.0),
    ("rad", Measures::Angle, 1.0),
    ("rad/s", Measures::Rate, 1.0),
    ("°/s", Measures::Rate, std::f64::consts::PI / 180.0),
    ("deg/s", Measures::Rate, std::f64::consts::PI / 180.0),
    ("rpm", Measures::Rate, std::f64::consts::PI / 30.0),
    ("kgm²", Measures::Inertia, 1.0),
    ("kgm2", Measures::Inertia, 1.0),
    ("gm²", Measures::Inertia, 1e-3),
    ("gm2", Measures::Inertia, 1e-3),
    ("gcm²", Measures::Inertia, 1e-7),
    ("J", Measures::Energy, 1.0),
    ("mJ", Measures::Energy, 1e-3),
];

/// A number as people write it, in this unit: `9.5×10⁻⁵`, `1/3`, `0,5`, `5 mm` in a field of centimetres. None where it is no
/// number, or one of another kind.
#[must_use]
pub fn read(text: &str, unit: &str) -> Option<f64> {
    let mut marked: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    // A power that is set high stands after the 10; elsewhere a raised 2 belongs to a unit.
    for times in ["×10", "·10", "x10", "*10"] {
        if let Some((before, after)) = marked.split_once(times) {
            let power: String = after.trim_start_matches('^').replace('²', "2");
            marked = format!("{before}e{power}");
            break;
        }
    }
    let plain: String = marked.chars().map(plainly).collect();
    let plain = plain.strip_prefix('+').unwrap_or(&plain);
    let end = plain
        .char_indices()
        .rev()
        .find(|(_, c)| c.is_ascii_digit() || *c == '.')
        .map_or(0, |(at, c)| at + c.len_utf8());
    // The 2 of a unit squared is none of the number's.
    let end = plain.find("kgm2").or(plain.find("gm2")).map_or(end, |at| at.min(end));
    let (number, own) = plain.split_at(end);
    let value = match number.split_once('/') {
        Some((above, below)) => above.parse::<f64>().ok()? / below.parse::<f64>().ok()?,
        None => number.parse::<f64>().ok()?,
    };
    let of = |name: &str| UNITS.iter().find(|(known, ..)| *known == name);
    let wanted: String = unit.chars().filter(|c| !c.is_whitespace()).collect();
    let factor = if own.is_empty() || own == wanted {
        1.0
    } else {
        let (given, field) = (of(own)?, of(&wanted)?);
        if given.1 != field.1 {
            return None;
        }
        given.2 / field.2
    };
    (value * factor).is_finite().then_some(value * factor)
}

/// A sign as a computer writes it: of typeset minus signs, commas and powers.
fn plainly(character: char) -> char {
    match character {
        '−' | '–' | '⁻' => '-',
        ',' => '.',
        '⁰' => '0',
        '¹' => '1',
        '³' => '3',
        '⁴'..='⁹' => char::from(b'4' + (character as u32 - '⁴' as u32) as u8),
        other => other,
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
    use super::{duration, read, scientific, significant};

    #[test]
    fn what_a_field_shows_it_also_takes() {
        for (text, unit, value) in [
            ("9.5×10⁻⁵", "°", 9.5e-5),
            ("9.5×10⁻⁵°", "°", 9.5e-5),
            ("5", "cm", 5.0),
            ("5 cm", "cm", 5.0),
            ("5 mm", "cm", 0.5),
            ("1/3", "rad/s", 1.0 / 3.0),
            ("0,5", "J", 0.5),
            ("−30 °", "°", -30.0),
            ("3 kg m²", "g m²", 3000.0),
            ("1.5·10³", "s", 1500.0),
            ("2×10^-3 s", "ms", 2.0),
            ("+4e-2", "ms", 0.04),
            ("60 rpm", "rad/s", std::f64::consts::TAU),
            ("2×10²", "J", 200.0),
        ] {
            let found = read(text, unit).unwrap_or(f64::NAN);
            assert!((found - value).abs() <= 4.0 * f64::EPSILON * value.abs(), "{text}: {found}");
        }
        for (text, unit) in [("abc", "°"), ("", "°"), ("5 mm", "°"), ("1/0", "s"), ("5 parsec", "cm"), ("1e999", "s")]
        {
            assert_eq!(read(text, unit), None, "{text}");
        }
        for value in [1.2e-16, 9.5e-5, 0.0, 123.4, 7e9] {
            let digits = read(&scientific(value), "s").unwrap_or(f64::NAN);
            assert!((digits - value).abs() <= 0.05 * value, "{value}");
            let digits = read(&significant(value, 4), "s").unwrap_or(f64::NAN);
            assert!((digits - value).abs() <= 0.05 * value, "{value}");
        }
    }

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
