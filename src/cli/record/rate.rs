//! Frames a second, as they are said: whole, decimal, with a power, or a ratio.

use std::num::NonZeroU32;

use dzhanibekov::headless::FrameRate;
use dzhanibekov::scene::one_number;

const WANTED: &str = "a rate is a number above 0 such as 60, 29.97 or 30000/1001";
const TOO_FINE: &str = "a rate has at most three decimals; a ratio such as 30000/1001 is exact";
const TOO_LARGE: &str = "the two numbers of a rate, as a ratio, are below 2^32";
/// Decimals of a rate.
const MOST_DECIMALS: i64 = 3;

/// Reads a rate.
pub(super) fn frame_rate(text: &str) -> Result<FrameRate, String> {
    let text = text.trim();
    let (frames, seconds) = match text.split_once('/') {
        Some((frames, seconds)) => (whole(frames)?, whole(seconds)?),
        None => decimal(text)?,
    };
    // In lowest terms: formats hold the two numbers with a bound.
    let (mut divisor, mut rest) = (frames, seconds);
    while rest != 0 {
        (divisor, rest) = (rest, divisor % rest);
    }
    let [frames, seconds] = [frames, seconds].map(|part| part.checked_div(divisor).unwrap_or(0));
    if frames == 0 || seconds == 0 {
        return Err(WANTED.to_owned());
    }
    let part = |part: u64| u32::try_from(part).ok().and_then(NonZeroU32::new).ok_or_else(|| TOO_LARGE.to_owned());
    Ok(FrameRate { frames: part(frames)?, seconds: part(seconds)? })
}

/// A part of a ratio.
fn whole(text: &str) -> Result<u64, String> {
    let is_whole = !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    if is_whole { text.parse().map_err(|_| TOO_LARGE.to_owned()) } else { Err(WANTED.to_owned()) }
}

/// A decimal, as so many frames in so many seconds.
fn decimal(text: &str) -> Result<(u64, u64), String> {
    let value = one_number(text).map_err(|_| WANTED.to_owned())?;
    if !(value.is_finite() && value > 0.0) {
        return Err(WANTED.to_owned());
    }
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let exponent: i64 = exponent.parse().map_err(|_| WANTED.to_owned())?;
    let (before, after) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let after = after.trim_end_matches('0');
    let digits = format!("{}{after}", before.trim_start_matches('+'));
    // Noughts at the end are no decimals.
    let short = digits.trim_end_matches('0');
    let length = |text: &str| i64::try_from(text.len()).unwrap_or(i64::MAX);
    let decimals = length(after).saturating_sub(exponent).saturating_sub(length(&digits) - length(short));
    if decimals > MOST_DECIMALS {
        return Err(TOO_FINE.to_owned());
    }
    let frames: u64 = short.parse().map_err(|_| TOO_LARGE.to_owned())?;
    let power = |power: i64| u32::try_from(power).ok().and_then(|power| 10_u64.checked_pow(power));
    let scaled =
        if decimals <= 0 { power(-decimals).and_then(|power| frames.checked_mul(power)) } else { Some(frames) };
    Ok((scaled.ok_or(TOO_LARGE)?, power(decimals.max(0)).ok_or(TOO_LARGE)?))
}

#[cfg(test)]
mod tests {
    use super::{TOO_FINE, TOO_LARGE, WANTED, frame_rate};

    #[test]
    fn rates_are_read_exactly_or_refused_for_what_is_wrong() {
        for (text, frames, seconds) in [
            ("60", 60, 1),
            ("1000", 1000, 1),
            ("1e3", 1000, 1),
            ("2.5E1", 25, 1),
            ("29.97", 2997, 100),
            ("30000/1001", 30_000, 1001),
            ("60/2", 30, 1),
            ("1e-3", 1, 1000),
            ("0.50000", 1, 2),
            (".5", 1, 2),
            ("100e-2", 1, 1),
            ("5000000.5", 10_000_001, 2),
            ("4294967295", u32::MAX, 1),
        ] {
            let rate = frame_rate(text).map(|rate| (rate.frames.get(), rate.seconds.get()));
            assert_eq!(rate, Ok((frames, seconds)), "{text}");
        }
        for (text, why) in [
            ("1e-9", TOO_FINE),
            ("23.97602", TOO_FINE),
            ("4294967296", TOO_LARGE),
            ("1e300", TOO_LARGE),
            ("4294967296/1", TOO_LARGE),
            ("99999999999999999999999/1", TOO_LARGE),
            ("0", WANTED),
            ("-1", WANTED),
            ("0/1", WANTED),
            ("1/0", WANTED),
            ("nan", WANTED),
            ("inf", WANTED),
            ("fast", WANTED),
            ("", WANTED),
            ("1.5/2", WANTED),
        ] {
            assert_eq!(frame_rate(text).err().as_deref(), Some(why), "{text}");
        }
    }
}
