//! Films through an installed `ffmpeg`, which is fed a YUV4MPEG2 stream, or raw pixels where they keep their opacity.

use std::ffi::OsString;
use std::io::{self, BufRead, BufReader, BufWriter, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStderr, Command, Stdio};
use std::thread::JoinHandle;

use dzhanibekov::headless::{FrameRate, Movie, MovieError, Rgba, Y4m};
use dzhanibekov::render::Pixels;

use super::film::{CONTAINERS, Codec, Container, list};
use crate::cli::failure::Failure;

/// Bits for a pixel of a frame, of an encoder that is given a rate: for line drawings, many.
const BITS_PER_PIXEL: f64 = 0.15;
/// Colours as the stream has them, for an input and for an output.
const COLOURS: [&str; 8] =
    ["-color_range", "tv", "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709"];

/// What turns RGB into these colours.
const TO_BT709: &str = concat!(
    "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int+area,",
    "setparams=range=tv:colorspace=bt709:color_primaries=bt709:color_trc=bt709"
);

/// A running ffmpeg.
pub(super) struct Ffmpeg {
    child: Child,
    stream: Option<Box<dyn Movie>>,
    /// Reads its words, so that it never waits for someone to do so; the first of them is kept.
    words: Option<JoinHandle<String>>,
}

/// What a film is encoded by.
#[derive(Clone, Copy, Debug)]
pub(super) struct Encoder {
    container: Container,
    is_transparent: bool,
    codec: &'static Codec,
    name: &'static str,
    settings: &'static [&'static str],
}

impl Ffmpeg {
    /// Starts it on a file, which it may write over.
    pub(super) fn new(path: &Path, size: [u32; 2], rate: FrameRate, encoder: Encoder) -> Result<Self, Failure> {
        let Encoder { container, is_transparent, codec, name, settings } = encoder;
        let bits = BITS_PER_PIXEL * f64::from(size[0]) * f64::from(size[1]) * rate.per_second();
        let bits = format!("{:.0}", bits.clamp(1e6, 1e9));
        // Said to be a file, no name is taken for a protocol, a pattern or a flag.
        let mut file = OsString::from("file:");
        file.push(path);
        let is_rgb = codec.pixels == "bgra";
        let mut command = ffmpeg();
        command.args(["-nostdin", "-loglevel", "error", "-y"]);
        if is_transparent {
            let [width, height] = size;
            command.args(["-f", "rawvideo", "-pix_fmt", "rgba", "-video_size", &format!("{width}x{height}")]);
            command.args(["-framerate", &format!("{}/{}", rate.frames, rate.seconds), "-i", "-"]);
            if !is_rgb {
                command.args(["-vf", TO_BT709]);
            }
        } else {
            command.args(["-f", "yuv4mpegpipe"]).args(COLOURS).args(["-i", "-"]);
        }
        command.args(["-c:v", name]).args(settings);
        if settings.is_empty() {
            command.args(["-b:v", &bits]);
        }
        command.args(["-pix_fmt", codec.pixels]);
        if !is_rgb {
            command.args(COLOURS);
        }
        command.args(container.muxer()).arg(file);
        let mut child = command
            .stdin(Stdio::piped())
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(|error| not_started(&error, container))?;
        let stdin = child.stdin.take().ok_or_else(|| Failure::could_not("ffmpeg takes no input"))?;
        let listen = |stderr| std::thread::Builder::new().spawn(move || first_words(stderr));
        let words = child.stderr.take().map(listen).transpose();
        let words =
            words.map_err(|error| Failure::could_not(format!("no thread could be had beside ffmpeg: {error}")))?;
        let stdin = BufWriter::new(stdin);
        let stream: Box<dyn Movie> = if is_transparent {
            Box::new(Rgba::new(stdin, !is_rgb))
        } else {
            let stream = Y4m::new(stdin, size, rate);
            Box::new(stream.map_err(|error| Failure::could_not(format!("ffmpeg takes no input: {error}")))?)
        };
        Ok(Self { child, stream: Some(stream), words })
    }

    /// Waits for it to end and says how, where that was not well.
    fn end(&mut self) -> Result<(), MovieError> {
        self.stream = None;
        let words = self.words.take().and_then(|words| words.join().ok()).unwrap_or_default();
        let status = self.child.wait()?;
        // It calls it a success where the disk was full at the end; only its errors are let through to standard error.
        if status.success() && words.is_empty() {
            return Ok(());
        }
        let reason = if words.is_empty() { String::new() } else { format!(": {words}") };
        Err(MovieError::Format(format!("ffmpeg ended with {status}{reason}")))
    }
}

/// The program, out of the reach of a terminal's Ctrl-C: that is for this one, which then says what becomes of the film.
fn ffmpeg() -> Command {
    let mut command = Command::new("ffmpeg");
    #[cfg(unix)]
    std::os::unix::process::CommandExt::process_group(&mut command, 0);
    // CREATE_NEW_PROCESS_GROUP
    #[cfg(windows)]
    std::os::windows::process::CommandExt::creation_flags(&mut command, 0x200);
    command
}

/// Why there is no ffmpeg at work.
fn not_started(error: &io::Error, container: Container) -> Failure {
    match error.kind() {
        io::ErrorKind::NotFound => Failure::could_not(format!(
            "a film ending in .{} needs ffmpeg, which was not found: install it (on Debian apt-get install ffmpeg) or record .apng or .gif",
            container.ending()
        )),
        _ => Failure::could_not(format!("ffmpeg could not be started: {error}")),
    }
}

impl Encoder {
    /// The best encoder that ffmpeg has for such a file.
    pub(super) fn find(container: Container, codec: &'static Codec, is_transparent: bool) -> Result<Self, Failure> {
        let chosen = |(name, settings)| Self { container, is_transparent, codec, name, settings };
        let listed = ffmpeg()
            .args(["-hide_banner", "-encoders"])
            .stdin(Stdio::null())
            .stderr(Stdio::null())
            .output()
            .map_err(|error| not_started(&error, container))?;
        let list = String::from_utf8_lossy(&listed.stdout);
        let has = |name: &str| list.lines().any(|line| line.split_whitespace().nth(1) == Some(name));
        let [first, others @ ..] = codec.encoders else { return Err(lacking(container, codec, is_transparent, has)) };
        // One that cannot even list them says itself what ails it.
        if !listed.status.success() || has(first.0) {
            return Ok(chosen(*first));
        }
        // The others may be listed and want a device that is not there.
        let other = others.iter().find(|(name, _)| has(name) && can_encode(name));
        other.map(|other| chosen(*other)).ok_or_else(|| lacking(container, codec, is_transparent, has))
    }
}

/// What is said where ffmpeg has no encoder for such a file: which it would be, and what it can write instead.
fn lacking(container: Container, codec: &Codec, is_transparent: bool, has: impl Fn(&str) -> bool) -> Failure {
    let names: Vec<&str> = codec.encoders.iter().map(|(name, _)| *name).collect();
    let can = |other: &Container| {
        let encoders = other.codec(is_transparent).map_or(&[][..], |codec| codec.encoders);
        *other != container && encoders.first().is_some_and(|(name, _)| has(name))
    };
    let mut served: Vec<&str> = CONTAINERS.iter().filter(|other| can(other)).map(|other| other.ending()).collect();
    served.push("apng");
    let sentence = format!(
        "the ffmpeg here has no encoder of {} that works ({}): install one with {} (Debian's has it), or record {}",
        codec.name,
        names.join(", "),
        names.first().unwrap_or(&"it"),
        list(&served, "or"),
    );
    match container {
        Container::Mp4 => Failure::could_not(sentence),
        _ => Failure::request(sentence),
    }
}

/// Whether an encoder takes a small grey picture.
fn can_encode(name: &str) -> bool {
    const SIZE: [usize; 2] = [320, 180];
    let child = ffmpeg()
        .args(["-loglevel", "quiet", "-f", "rawvideo", "-pix_fmt", "yuv420p", "-s"])
        .arg(format!("{}x{}", SIZE[0], SIZE[1]))
        .args(["-i", "-", "-frames:v", "1", "-c:v", name, "-b:v", "1M", "-f", "null", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
    let Ok(mut child) = child else { return false };
    if let Some(mut stdin) = child.stdin.take() {
        // Where it goes away early its exit code says so.
        let _ = stdin.write_all(&vec![128; SIZE[0] * SIZE[1] * 3 / 2]);
    }
    child.wait().is_ok_and(|status| status.success())
}

/// The first thing said, the rest read and left: what comes first is the cause, what follows its consequences.
fn first_words(stderr: ChildStderr) -> String {
    let mut reader = BufReader::new(stderr);
    let mut words = String::new();
    let mut line = vec![];
    while words.is_empty() && reader.read_until(b'\n', &mut line).is_ok_and(|length| length > 0) {
        words = without_address(String::from_utf8_lossy(&line).trim());
        line.clear();
    }
    let _ = io::copy(&mut reader.by_ref(), &mut io::sink());
    words
}

/// `[libx264 @ 0x55d0c8] no` as `[libx264] no`.
fn without_address(line: &str) -> String {
    match line.split_once(" @ 0x") {
        Some((before, after)) if before.starts_with('[') => {
            format!("{before}{}", after.trim_start_matches(|character: char| character.is_ascii_hexdigit()))
        }
        _ => line.to_owned(),
    }
}

impl Movie for Ffmpeg {
    fn frame(&mut self, pixels: &Pixels) -> Result<(), MovieError> {
        let written = match &mut self.stream {
            Some(stream) => stream.frame(pixels),
            None => Ok(()),
        };
        // It ended early: its own words say more than a closed pipe.
        written.or_else(|_| self.end().and_then(|()| ended_early()))
    }

    fn finish(mut self: Box<Self>) -> Result<(), MovieError> {
        let flushed = self.stream.take().map_or(Ok(()), Movie::finish);
        self.end()?;
        flushed.or_else(|_| ended_early())
    }
}

/// It went away before the last frame and called that a success.
fn ended_early() -> Result<(), MovieError> {
    Err(MovieError::Format("ffmpeg ended before the last frame and did not say why".to_owned()))
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
