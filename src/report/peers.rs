//! Other programs' points, measured by themselves on the same motions, and how many times faster the methods here are.

use serde::{Deserialize, Serialize};

use super::work_precision::Row;
use super::{ReportError, is_direct};

/// One point of another program.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Peer {
    /// Name of the case.
    pub case: String,
    /// Time reached (s).
    pub t: f64,
    /// Name of the program.
    pub peer: String,
    /// Its setting.
    pub setting: String,
    /// Time taken (s).
    pub seconds: f64,
    /// Number of steps.
    #[serde(default)]
    pub steps: Option<f64>,
    /// Attitude error (rad).
    pub error: f64,
}

/// A peer's point beside the fastest here that is no less accurate.
#[derive(Clone, Debug, Serialize)]
pub struct Beside {
    /// The peer's point.
    #[serde(flatten)]
    pub peer: Peer,
    /// The fastest stepping method whose error is no larger.
    pub stepping: Option<Faster>,
    /// The closed form, where its error is no larger.
    pub closed_form: Option<Faster>,
}

/// A method that is no less accurate, and its time.
#[derive(Clone, Debug, Serialize)]
pub struct Faster {
    /// Name of the method.
    pub method: &'static str,
    /// Its median time (s).
    pub seconds: f64,
    /// Its error (rad).
    pub error: f64,
    /// The peer's time over its own.
    pub times_faster: f64,
}

/// Reads a list of points (JSON).
///
/// # Errors
/// A text that is no such list, or a number that no measurement gives.
pub fn parse(text: &str) -> Result<Vec<Peer>, ReportError> {
    let peers: Vec<Peer> = serde_json::from_str(text).map_err(|error| ReportError::Peers(error.to_string()))?;
    for peer in &peers {
        let wrong = |name: &str, value: f64, wanted: &str| {
            ReportError::Peers(format!("{name} {value:?} of `{}` on `{}` must be {wanted}", peer.peer, peer.case))
        };
        if !(peer.seconds.is_finite() && peer.seconds > 0.0) {
            return Err(wrong("seconds", peer.seconds, "finite and above 0"));
        }
        if !(peer.error.is_finite() && peer.error >= 0.0) {
            return Err(wrong("error", peer.error, "finite and not negative"));
        }
        if !peer.t.is_finite() {
            return Err(wrong("t", peer.t, "finite"));
        }
    }
    Ok(peers)
}

/// Every peer's point on a motion that was measured, beside the best here.
#[must_use]
pub fn beside(peers: &[Peer], rows: &[Row]) -> Vec<Beside> {
    peers
        .iter()
        .filter_map(|peer| {
            let same: Vec<&Row> = rows.iter().filter(|row| row.case == peer.case && row.t == peer.t).collect();
            if same.is_empty() {
                return None;
            }
            let fastest = |is_closed: bool| {
                same.iter()
                    .filter(|row| is_direct(row.method) == is_closed && row.errors.attitude_error <= peer.error)
                    .min_by(|a, b| a.timing.seconds.total_cmp(&b.timing.seconds))
                    .map(|row| Faster {
                        method: row.method,
                        seconds: row.timing.seconds,
                        error: row.errors.attitude_error,
                        times_faster: peer.seconds / row.timing.seconds,
                    })
            };
            Some(Beside { peer: peer.clone(), stepping: fastest(false), closed_form: fastest(true) })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_list_of_points_is_refused_in_one_line() {
        for text in ["", "{", "{}", "[1]", r#"[{"case": "x"}]"#] {
            assert!(parse(text).is_err_and(|error| error.to_string().lines().count() == 1), "{text}");
        }
        let row = |seconds: &str, error: &str| {
            format!(r#"[{{"case":"a","t":1,"peer":"p","setting":"s","seconds":{seconds},"steps":3,"error":{error}}}]"#)
        };
        assert!(parse(&row("1e-6", "1e-9")).is_ok_and(|peers| peers.len() == 1));
        assert!(parse(&row("0", "1e-9")).is_err());
        assert!(parse(&row("1", "-1")).is_err());
    }
}
