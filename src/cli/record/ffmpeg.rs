//! MP4 through an installed `ffmpeg`, which is fed a YUV4MPEG2 stream.

use std::io::{self, BufWriter, Read};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};

use dzhanibekov::headless::{FrameRate, Movie, MovieError, Y4m};
use dzhanibekov::render::Pixels;

use crate::cli::failure::Failure;

/// A running ffmpeg.
pub(super) struct Ffmpeg {
    child: Child,
    stream: Option<Box<Y4m<BufWriter<ChildStdin>>>>,
}

impl Ffmpeg {
    /// Starts it on a file, which it may write over.
    pub(super) fn new(path: &Path, size: [u32; 2], rate: FrameRate) -> Result<Self, Failure> {
        let mut command = Command::new("ffmpeg");
        // A terminal's Ctrl-C is for this program, which then says what becomes of the film.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut child = command
            .args(["-nostdin", "-loglevel", "error", "-y", "-f", "yuv4mpegpipe", "-i", "-"])
            .args(["-c:v", "libx264", "-preset", "veryfast", "-crf", "16", "-pix_fmt", "yuv420p"])
            .args(["-color_range", "tv", "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709"])
            .args(["-movflags", "+faststart", "-f", "mp4"])
            .arg(path)
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(|error| match error.kind() {
                io::ErrorKind::NotFound => Failure::could(
                    "an .mp4 needs ffmpeg, which was not found: install it (on Debian apt-get install ffmpeg) or record .apng or .gif",
                ),
                _ => Failure::could(format!("ffmpeg could not be started: {error}")),
            })?;
        let stdin = child.stdin.take().ok_or_else(|| Failure::could("ffmpeg takes no input"))?;
        let stream = Y4m::new(BufWriter::new(stdin), size, rate)?;
        Ok(Self { child, stream: Some(Box::new(stream)) })
    }

    /// Waits for it to end and says how, where that was not well.
    fn end(&mut self) -> Result<(), MovieError> {
        self.stream = None;
        let mut words = String::new();
        if let Some(mut stderr) = self.child.stderr.take() {
            stderr.read_to_string(&mut words)?;
        }
        let status = self.child.wait()?;
        // It calls it a success where the disk was full at the end; only its errors are let through to standard error.
        if status.success() && words.trim().is_empty() {
            return Ok(());
        }
        let reason = words.lines().last().map_or_else(String::new, |line| format!(": {}", line.trim()));
        Err(MovieError::Format(format!("ffmpeg ended with {status}{reason}")))
    }
}

impl Movie for Ffmpeg {
    fn frame(&mut self, pixels: &Pixels) -> Result<(), MovieError> {
        let written = match &mut self.stream {
            Some(stream) => stream.frame(pixels),
            None => Ok(()),
        };
        match written {
            // It ended early: its own words say more than a closed pipe.
            Err(error) => self.end().and(Err(error)),
            Ok(()) => Ok(()),
        }
    }

    fn finish(mut self: Box<Self>) -> Result<(), MovieError> {
        if let Some(stream) = self.stream.take() {
            let flushed = stream.finish();
            return self.end().and(flushed);
        }
        self.end()
    }
}

impl Drop for Ffmpeg {
    fn drop(&mut self) {
        // Still running only where the recording was given up.
        if matches!(self.child.try_wait(), Ok(None)) {
            let _ = self.child.kill();
            let _ = self.child.wait();
        }
    }
}
