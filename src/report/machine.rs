//! What the measurements were taken on.

use serde::Serialize;
use web_time::{SystemTime, UNIX_EPOCH};

/// The machine and the program.
#[derive(Clone, Debug, Serialize)]
pub struct Machine {
    /// Model of the processor, where the system tells it.
    pub cpu: String,
    /// Threads that can run at once; the measurements use one.
    pub threads: usize,
    /// Architecture and system.
    pub system: String,
    /// Version of this program.
    pub version: &'static str,
    /// Whether the program was built optimised.
    pub is_optimised: bool,
    /// Day of the measurement (UTC), as in 2026-01-31.
    pub date: String,
}

impl Machine {
    /// This machine, today.
    #[must_use]
    pub fn this() -> Self {
        let days = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |since| since.as_secs() / 86_400);
        Self {
            cpu: cpu().unwrap_or_else(|| "unknown processor".to_owned()),
            threads: std::thread::available_parallelism().map_or(1, usize::from),
            system: format!("{} {}", std::env::consts::ARCH, std::env::consts::OS),
            version: env!("CARGO_PKG_VERSION"),
            is_optimised: !cfg!(debug_assertions),
            date: date(days),
        }
    }

    /// In one line.
    #[must_use]
    pub fn line(&self) -> String {
        let build = if self.is_optimised { "" } else { ", built without optimisation" };
        format!(
            "{}, {} threads, {}, dzhanibekov {}{build}, {}",
            self.cpu, self.threads, self.system, self.version, self.date
        )
    }
}

fn cpu() -> Option<String> {
    let text = std::fs::read_to_string("/proc/cpuinfo").ok()?;
    let line = text.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_owned())
}

/// The Gregorian date of a day counted from 1970-01-01 (Hinnant, "chrono-compatible low-level date algorithms").
fn date(days: u64) -> String {
    let shifted = days + 719_468;
    let (era, day_of_era) = (shifted / 146_097, shifted % 146_097);
    let year_of_era = (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    let year = year_of_era + era * 400 + u64::from(month <= 2);
    format!("{year:04}-{month:02}-{day:02}")
}

#[cfg(test)]
mod tests {
    use super::date;

    #[test]
    fn days_have_their_dates() {
        assert_eq!(date(0), "1970-01-01");
        assert_eq!(date(11_016), "2000-02-29");
        assert_eq!(date(20_454), "2026-01-01");
    }
}
