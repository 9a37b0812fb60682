//! Times that are asked for: decimals multiplied exactly, lists from files, and how long anything may take.

use std::ffi::OsString;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use dzhanibekov::files;
use dzhanibekov::physics::{Integration, METHODS, Method};
use dzhanibekov::scene::{Scene, one_number};

pub(super) use dzhanibekov::physics::number as short;

use super::arguments::number_list;
use super::failure::Failure;

/// Largest file of times read (bytes).
const LARGEST_FILE: u64 = 16 << 20;
/// Digits of a decimal that are kept: with a count below 2³¹ the product stays below 2¹²⁸, and the first digit cut off
/// is 10⁻¹¹ of the last that a number of 64 bits can tell.
const MOST_DIGITS: u32 = 28;
/// Steps that are waited for: hours.
const MOST_STEPS: f64 = 1e11;
/// Steps taken to see how long one takes.
const TRIAL: i64 = 10_000;

/// A number as it was written: `digits · 10^exponent`, and the nearest number of 64 bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Decimal {
    /// The nearest number; the two below are its size alone.
    pub(super) value: f64,
    digits: u128,
    exponent: i32,
}

impl Decimal {
    /// Reads a number as every flag does.
    pub(super) fn parse(text: &str) -> Result<Self, String> {
        let (text, value) = (text.trim(), one_number(text)?);
        let mut decimal = Self { value, digits: 0, exponent: 0 };
        if !value.is_finite() {
            return Ok(decimal);
        }
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        // Where this is too long, the number is 0 and refused as a step.
        decimal.exponent = exponent.parse().unwrap_or(0);
        let mut is_behind_point = false;
        for character in mantissa.chars() {
            let Some(digit) = character.to_digit(10) else {
                is_behind_point |= character == '.';
                continue;
            };
            let is_kept = decimal.digits < 10_u128.pow(MOST_DIGITS - 1);
            if is_kept {
                decimal.digits = decimal.digits * 10 + u128::from(digit);
            }
            decimal.exponent = decimal.exponent.saturating_add(i32::from(!is_kept) - i32::from(is_behind_point));
        }
        Ok(decimal)
    }

    /// So many times the decimal, rounded once.
    pub(super) fn times(self, count: u64) -> f64 {
        let exact = self.digits.checked_mul(u128::from(count));
        let rounded = exact.and_then(|digits| format!("{digits}e{}", self.exponent).parse().ok());
        rounded.unwrap_or(count as f64 * self.value)
    }

    /// How often `part` goes into it; `None` where that is more often than can be counted.
    pub(super) fn whole_parts(self, part: Self) -> Option<u128> {
        let shift = self.exponent.saturating_sub(part.exponent);
        let scale = 10_u128.checked_pow(shift.unsigned_abs());
        if shift >= 0 {
            if self.digits == 0 {
                return Some(0);
            }
            self.digits.checked_mul(scale?)?.checked_div(part.digits)
        } else {
            // A part past the range is more than the whole.
            Some(scale.and_then(|scale| part.digits.checked_mul(scale)).map_or(0, |part| self.digits / part.max(1)))
        }
    }
}

/// Times given one by one.
#[derive(Clone, Debug)]
pub(super) enum Times {
    /// On the command line.
    List(Vec<f64>),
    /// In a file.
    File(PathBuf),
    /// On standard input.
    Standard,
}

impl Times {
    /// Reads `0,1,10`, `@FILE`, `@-` or `-`.
    pub(super) fn parse(text: OsString) -> Result<Self, String> {
        if text == "-" || text == "@-" {
            return Ok(Self::Standard);
        }
        match text.into_string() {
            Ok(text) => match text.strip_prefix('@') {
                Some("") => Err("`@` names no file: give @FILE, or - for standard input".to_owned()),
                Some(path) => Ok(Self::File(path.into())),
                None => finite(number_list(&text)?).map(Self::List),
            },
            Err(text) => after_at(&text).map(Self::File).ok_or_else(|| {
                format!("`{}` holds no times: give numbers with commas between them", text.to_string_lossy())
            }),
        }
    }

    /// The times, in the order in which they are given.
    pub(super) fn read(&self) -> Result<Vec<f64>, Failure> {
        let (text, name) = match self {
            Self::List(times) => return Ok(times.clone()),
            Self::File(path) => (files::read_text(path, LARGEST_FILE)?, path.display().to_string()),
            Self::Standard => (files::read_standard_input(LARGEST_FILE)?, "standard input".to_owned()),
        };
        let mut times = vec![];
        for (index, line) in text.lines().enumerate() {
            let wrong = |reason| Failure::request(format!("{name}, line {}: {reason}", index + 1));
            for word in line.split(|character: char| character.is_whitespace() || character == ',') {
                if !word.is_empty() {
                    times.extend(number_list(word).and_then(finite).map_err(wrong)?);
                }
            }
        }
        if times.is_empty() {
            return Err(Failure::request(format!(
                "{name} holds no times: give numbers with blanks, commas or lines between them"
            )));
        }
        Ok(times)
    }
}

/// The name behind an `@`, of a file whose name is no text.
#[cfg(unix)]
fn after_at(text: &OsString) -> Option<PathBuf> {
    use std::os::unix::ffi::OsStrExt;
    text.as_bytes().strip_prefix(b"@").map(|name| PathBuf::from(std::ffi::OsStr::from_bytes(name)))
}

/// Where every name is text.
#[cfg(not(unix))]
fn after_at(_text: &OsString) -> Option<PathBuf> {
    None
}

/// Refuses a time that is not finite.
fn finite(times: Vec<f64>) -> Result<Vec<f64>, String> {
    match times.iter().find(|time| !time.is_finite()) {
        Some(time) => Err(format!("the time {time} is not finite")),
        None => Ok(times),
    }
}

/// The order in which a method that goes by steps reaches all times in one sweep each way; `None` where they are in it.
pub(super) fn sweep(times: &[f64]) -> Option<Vec<usize>> {
    let before = |a: &f64, b: &f64| (*a < 0.0, a.abs()) <= (*b < 0.0, b.abs());
    if times.is_sorted_by(before) {
        return None;
    }
    let mut order: Vec<usize> = (0..times.len()).collect();
    order.sort_by(|&a, &b| (times[a] < 0.0).cmp(&(times[b] < 0.0)).then(times[a].abs().total_cmp(&times[b].abs())));
    Some(order)
}

/// Refuses times (s) from the start that are more steps away than anyone waits for; `what` names them. Whoever draws follows the
/// methods of the comparison too.
pub(super) fn check_steps<'a>(
    scene: &Scene,
    what: &str,
    farthest: f64,
    methods: impl IntoIterator<Item = &'a &'static Method>,
) -> Result<(), Failure> {
    let steps = farthest.abs() / scene.step;
    if steps <= MOST_STEPS {
        return Ok(());
    }
    for &method in methods {
        if method.is_direct {
            continue;
        }
        let mut integration =
            Integration::with_energy_loss(method, &scene.body, scene.start, scene.step, scene.energy_loss);
        let begun = Instant::now();
        let trial = integration.advance(TRIAL);
        let seconds = begun.elapsed().as_secs_f64() / TRIAL as f64 * steps;
        let lasting = if trial.is_ok() { format!(", about {}", span(seconds)) } else { String::new() };
        // Where energy is lost none goes there at once.
        let direct = METHODS.iter().find(|method| method.is_direct && scene.energy_loss == 0.0);
        let instead = direct.map_or_else(String::new, |method| {
            format!("--method {}, which goes to any time at once, or ", method.name)
        });
        return Err(Failure::request(format!(
            "{what} is {} steps of {} s away by {}{lasting}: take {instead}a longer --step",
            rough(steps),
            short(scene.step),
            method.name,
        )));
    }
    Ok(())
}

/// A count in two digits.
pub(super) fn rough(count: f64) -> String {
    if !count.is_finite() {
        return "more than 1e308".to_owned();
    }
    if count < 1e4 { format!("{count:.0}") } else { format!("{count:.1e}").replace(".0e", "e") }
}

/// A length of time (s) in words.
pub(super) fn span(seconds: f64) -> String {
    const YEAR: f64 = 365.25 * 86_400.0;
    let (count, unit) = match seconds {
        s if s < 120.0 => (s, "s"),
        s if s < 7_200.0 => (s / 60.0, "minutes"),
        s if s < 172_800.0 => (s / 3_600.0, "hours"),
        s if s < 2.0 * YEAR => (s / 86_400.0, "days"),
        s => (s / YEAR, "years"),
    };
    format!("{} {unit}", rough(count))
}

/// How long a thousand calls take, and so `count` of them (s).
pub(super) fn time_of(count: f64, mut call: impl FnMut()) -> f64 {
    let begun = Instant::now();
    for _ in 0..1000 {
        call();
    }
    let one: Duration = begun.elapsed() / 1000;
    one.as_secs_f64() * count
}

#[cfg(test)]
mod tests {
    use super::{Decimal, Times};

    #[test]
    fn what_is_no_time_is_refused_with_what_was_given() {
        let at = |text: &str| Times::parse(text.into()).map(|_| ());
        assert_eq!(at("@"), Err("`@` names no file: give @FILE, or - for standard input".to_owned()));
        assert_eq!(at("1,1e400"), Err("`1e400` is past the range of numbers".to_owned()));
        assert!(at("@times.txt").is_ok() && at("@-").is_ok() && at("0,1e12").is_ok());
        let every = |text: &str| Decimal::parse(text).map(|decimal| decimal.value);
        assert_eq!(every("1e400"), Err("`1e400` is past the range of numbers".to_owned()));
        assert!(every("1e-400").is_err_and(|why| why.starts_with("`1e-400` is past the range of numbers")));
        assert_eq!((every(" 0.5 "), every("1e-3")), (Ok(0.5), Ok(1e-3)));
    }
}
