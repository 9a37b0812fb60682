//! A sequence of pictures: frames are exact functions of time, never of how fast the machine was.

use std::num::NonZeroU32;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, channel, sync_channel};

use super::fault;
use super::shot::{HeadlessError, ShotOptions};
use crate::objects::Cameras;
use crate::render::{Canvas, Gpu, Painter, Pixels, Reading};
use crate::scene::Scene;
use crate::sim::Simulation;

/// Pictures drawn and not yet taken: one being encoded, one waiting. More would only cost memory.
const WAITING: usize = 1;

/// Frames a second, a ratio of whole numbers so that no rounding of times piles up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameRate {
    /// Frames.
    pub frames: NonZeroU32,
    /// In so many seconds.
    pub seconds: NonZeroU32,
}

impl FrameRate {
    /// Time (s) from the first frame to frame `index`, one rounding.
    #[must_use]
    pub fn time(self, index: u64) -> f64 {
        (index as f64 * f64::from(self.seconds.get())) / f64::from(self.frames.get())
    }

    /// Frames a second.
    #[must_use]
    pub fn per_second(self) -> f64 {
        f64::from(self.frames.get()) / f64::from(self.seconds.get())
    }
}

/// Which frames of which motion.
#[derive(Clone, Debug)]
pub struct Recording {
    /// Size, adapter, transparency.
    pub shot: ShotOptions,
    /// Simulated time (s) of frame 0.
    pub start: f64,
    /// Frames a second.
    pub rate: FrameRate,
    /// The frames wanted; part of a longer recording where it does not begin at 0.
    pub frames: Range<u64>,
}

impl Recording {
    /// Simulated time (s) of a frame.
    #[must_use]
    pub fn time(&self, index: u64) -> f64 {
        self.start + self.rate.time(index)
    }
}

/// Draws the wanted frames in order, on the device that the options opened, and hands each to `take` on a thread of its
/// own, so that drawing, read-back and encoding overlap; memory does not grow with the number of frames. `skip` says which frames are not needed.
///
/// Stops early, with `false`, once `stop` is set: the frames handed over until then are whole.
///
/// # Errors
/// What the device reports, or the method, or what `take` returns.
pub fn record<E: From<HeadlessError> + Send>(
    gpu: &Gpu,
    scene: &Scene,
    recording: &Recording,
    stop: &AtomicBool,
    mut skip: impl FnMut(u64) -> bool,
    mut take: impl FnMut(u64, &Pixels) -> Result<(), E> + Send,
) -> Result<bool, E> {
    let mut artist = Artist::new(gpu, scene, recording)?;
    std::thread::scope(|scope| {
        let (sender, receiver) = sync_channel::<(u64, Pixels)>(WAITING);
        // The memory of pictures that were taken, for those to come.
        let (back, used) = channel::<Vec<u8>>();
        let taker = std::thread::Builder::new().spawn_scoped(scope, move || {
            for (index, pixels) in receiver {
                take(index, &pixels)?;
                // Nobody wants it after the last one.
                let _ = back.send(pixels.rgba);
            }
            Ok::<(), E>(())
        });
        let taker = taker.map_err(HeadlessError::Thread)?;
        let drawn = draw_all(&mut artist, recording, stop, &mut skip, (&sender, &used));
        // Ends the taker's loop once it has taken what waits.
        drop(sender);
        match taker.join() {
            Ok(taken) => taken?,
            Err(panic) => std::panic::resume_unwind(panic),
        }
        Ok(drawn?)
    })
}

/// Draws frame after frame, each read back while the next is prepared.
fn draw_all(
    artist: &mut Artist<'_>,
    recording: &Recording,
    stop: &AtomicBool,
    skip: &mut impl FnMut(u64) -> bool,
    (sender, used): (&SyncSender<(u64, Pixels)>, &Receiver<Vec<u8>>),
) -> Result<bool, HeadlessError> {
    let mut under_way: Option<(u64, usize, Reading)> = None;
    let mut next_canvas = 0;
    let mut drawn = 0;
    for index in recording.frames.clone() {
        if stop.load(Ordering::Relaxed) {
            return Ok(false);
        }
        if skip(index) {
            continue;
        }
        let reading = artist.draw(next_canvas, recording.time(index))?;
        drawn += 1;
        fault::after(drawn, artist.gpu);
        let before = under_way.replace((index, next_canvas, reading));
        next_canvas = 1 - next_canvas;
        if let Some((index, canvas, reading)) = before
            && sender.send((index, artist.finish(canvas, &reading, used.try_recv().unwrap_or_default())?)).is_err()
        {
            // The taker failed; its error is reported.
            return Ok(false);
        }
    }
    if let Some((index, canvas, reading)) = under_way
        && sender.send((index, artist.finish(canvas, &reading, used.try_recv().unwrap_or_default())?)).is_err()
    {
        return Ok(false);
    }
    Ok(true)
}

/// The simulation with what draws it, on two canvases in turn.
struct Artist<'a> {
    scene: &'a Scene,
    simulation: Simulation,
    cameras: Cameras,
    options: &'a ShotOptions,
    gpu: &'a Gpu,
    painter: Painter,
    canvases: [Canvas; 2],
}

impl<'a> Artist<'a> {
    fn new(gpu: &'a Gpu, scene: &'a Scene, recording: &'a Recording) -> Result<Self, HeadlessError> {
        let painter = Painter::new(gpu);
        let canvases = [(); 2].map(|()| Canvas::new(gpu, recording.shot.size.pixels));
        gpu.check()?;
        Ok(Self {
            scene,
            simulation: Simulation::new(scene),
            cameras: Cameras::new(&scene.view),
            options: &recording.shot,
            gpu,
            painter,
            canvases,
        })
    }

    fn draw(&mut self, canvas: usize, time: f64) -> Result<Reading, HeadlessError> {
        self.simulation.go_to(time);
        if let Some(failure) = self.simulation.main().failure() {
            return Err(HeadlessError::Method(failure.to_string()));
        }
        let canvas = &self.canvases[canvas];
        let frame = self.options.frame(self.scene, &self.simulation, &self.cameras);
        Ok(self.painter.draw_on(self.gpu, canvas, &frame))
    }

    fn finish(&self, canvas: usize, reading: &Reading, memory: Vec<u8>) -> Result<Pixels, HeadlessError> {
        Ok(self.canvases[canvas].finish_read_into(self.gpu, reading, memory)?)
    }
}
