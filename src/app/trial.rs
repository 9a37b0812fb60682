//! What only trials of the program ask for, by the environment: nothing else reads these.
//!
//! `DZHANIBEKOV_LOSE_DEVICE=SECONDS` takes the graphics device away once, after so long; `SECONDS+` each new one too.
//! `DZHANIBEKOV_FRAME_LOG=FILE` notes the time of each frame and what it went to, written when the window closes.

use std::path::PathBuf;

use web_time::{Duration, Instant};

use super::files::write_whole;

/// Most frames noted: some hours.
const MOST: usize = 1_000_000;

/// What is to be tried.
#[derive(Debug)]
pub(super) struct Trial {
    began: Instant,
    lose_at: Option<Duration>,
    again: bool,
    log: Option<PathBuf>,
    frames: Vec<Frame>,
}

/// A frame as it went.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    /// When it began.
    pub(super) at: Instant,
    /// Simulated time (s).
    pub(super) simulated: f64,
    /// What the simulation took of it, the panels, the picture, and presenting.
    pub(super) spent: [Duration; 4],
}

impl Trial {
    /// Reads the environment.
    pub(super) fn from_environment() -> Self {
        let lose = std::env::var("DZHANIBEKOV_LOSE_DEVICE").unwrap_or_default();
        let seconds = lose.trim_end_matches('+').parse().ok();
        Self {
            began: Instant::now(),
            lose_at: seconds.and_then(|seconds| Duration::try_from_secs_f64(seconds).ok()),
            again: lose.ends_with('+'),
            log: std::env::var_os("DZHANIBEKOV_FRAME_LOG").map(PathBuf::from),
            frames: Vec::new(),
        }
    }

    /// Whether the device is to be taken away now.
    pub(super) fn loses_device(&mut self, now: Instant) -> bool {
        let is_time = self.lose_at.is_some_and(|after| now - self.began >= after);
        if is_time && !self.again {
            self.lose_at = None;
        }
        is_time
    }

    /// Notes a frame.
    pub(super) fn note(&mut self, frame: Frame) {
        if self.log.is_some() && self.frames.len() < MOST {
            self.frames.push(frame);
        }
    }

    /// Writes what was noted; says why where it cannot.
    pub(super) fn write(&self) -> Result<(), String> {
        use std::fmt::Write;
        let Some(path) = &self.log else { return Ok(()) };
        let mut text = String::from("at_s,simulated_s,simulation_ms,panels_ms,picture_ms,present_ms\n");
        for frame in &self.frames {
            let [simulation, panels, picture, present] = frame.spent.map(|part| part.as_secs_f64() * 1e3);
            let at = (frame.at - self.began).as_secs_f64();
            // Writing to a string cannot fail.
            let _ =
                writeln!(text, "{at:.6},{:.6},{simulation:.3},{panels:.3},{picture:.3},{present:.3}", frame.simulated);
        }
        write_whole(path, text.as_bytes())
    }
}
