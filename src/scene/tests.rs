//! Scenes at random, and every built-in scene, through all that reads and writes them.

use super::edit::Edits;
use super::keys::{KEYS, Key};
use super::{
    BodyFile, CameraFile, CloudFile, Layout, MotionFile, PartKind, Scene, SceneError, SceneFile, SolidFile, SpinFile,
    StepFile, Theme, TimeUnit, ViewFile, flags, link, presets,
};
use crate::physics::{METHODS, Method, methods::LOSS_METHOD};

/// How many random scenes are tried.
const SCENES: u64 = 10_000;

/// A small generator (splitmix64), so that a seed gives the same scene everywhere.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, end: u64) -> u64 {
        self.next() % end
    }

    fn is(&mut self, one_in: u64) -> bool {
        self.below(one_in) == 0
    }

    /// From 0 to 1, with digits to the last place.
    fn share(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// A number above 0 of any size between these powers of ten, now and then a whole one.
    fn positive(&mut self, low: i32, high: i32) -> f64 {
        if self.is(4) {
            return (1 + self.below(9)) as f64;
        }
        (1.0 + self.share()) * 10f64.powi(low + self.below((high - low) as u64) as i32)
    }

    /// A number of any size and sign, now and then a zero of either sign.
    fn number(&mut self) -> f64 {
        match self.below(8) {
            0 => 0.0,
            1 => -0.0,
            2..5 => self.positive(-9, 9),
            _ => -self.positive(-9, 9),
        }
    }

    fn numbers<const N: usize>(&mut self) -> [f64; N] {
        [(); N].map(|()| self.number())
    }

    fn maybe<T>(&mut self, make: impl FnOnce(&mut Self) -> T) -> Option<T> {
        if self.is(2) { Some(make(self)) } else { None }
    }

    fn pick<T: Clone>(&mut self, from: &[T]) -> T {
        from[self.below(from.len() as u64) as usize].clone()
    }

    fn text(&mut self) -> String {
        let letters = [
            'a', 'Z', '0', ' ', '"', '\'', '\\', '\n', '\r', '\t', '#', '&', '=', '%', 'é', '∥', '\u{7f}', '\u{1}',
            '[', '{', '.',
        ];
        (0..self.below(12)).map(|_| self.pick(&letters)).collect()
    }

    fn names(&mut self, from: &[&str]) -> Vec<String> {
        (0..self.below(4)).map(|_| self.pick(from).to_owned()).collect()
    }

    fn body(&mut self) -> BodyFile {
        let form = self.maybe(Self::form);
        match self.below(5) {
            0 => BodyFile { form, ..BodyFile::default() },
            1 => BodyFile {
                edges: Some([(); 3].map(|()| self.positive(-3, 3))),
                mass: self.maybe(|it| it.positive(-9, 9)),
                ..BodyFile::default()
            },
            2 => BodyFile { moments: Some([(); 3].map(|()| self.positive(-9, 9))), form, ..BodyFile::default() },
            3 => {
                let xx = self.positive(-9, 9);
                let small = |it: &mut Self| xx * 0.1 * (it.share() - 0.5);
                let inertia = [xx, xx * (1.0 + self.share()), xx * 1.5, small(self), small(self), small(self)];
                BodyFile { inertia: Some(inertia), form, ..BodyFile::default() }
            }
            _ => BodyFile { solids: (0..=self.below(3)).map(|_| self.solid()).collect(), ..BodyFile::default() },
        }
    }

    fn form(&mut self) -> PartKind {
        self.pick(&[PartKind::Box, PartKind::Cylinder, PartKind::Ellipsoid])
    }

    fn solid(&mut self) -> SolidFile {
        let kind = self.form();
        let width = self.positive(-2, 2);
        let size = if kind == PartKind::Cylinder {
            [width, width, self.positive(-2, 2)]
        } else {
            [width, self.positive(-2, 2), self.positive(-2, 2)]
        };
        let mut solid = SolidFile { kind, size, ..SolidFile::default() };
        if self.is(2) {
            solid.position = [(); 3].map(|()| self.share() - 0.5);
            solid.rotation_deg = [(); 3].map(|()| 360.0 * self.share());
            solid.density = self.positive(-2, 4);
        }
        solid
    }

    fn spin(&mut self) -> SpinFile {
        let attitude = self.maybe(|it| [1.0, it.share(), -it.share(), it.number()]);
        if self.is(3) {
            return SpinFile { omega: Some(self.numbers()), attitude, ..SpinFile::default() };
        }
        SpinFile {
            omega: None,
            axis: self.maybe(|it| it.pick(&[1, 2, 3])),
            tilt_deg: self.maybe(|it| 360.0 * it.share() - 180.0),
            rate: self.maybe(Self::number),
            attitude,
        }
    }

    fn camera(&mut self) -> CameraFile {
        if self.is(2) {
            return CameraFile::default();
        }
        let all = self.is(2);
        let mut maybe = |make: fn(&mut Self) -> f64| if all || self.is(2) { Some(make(self)) } else { None };
        let (azimuth_deg, elevation_deg, distance) =
            (maybe(Self::number), maybe(Self::number), maybe(|it| it.positive(-3, 3)));
        CameraFile {
            azimuth_deg,
            elevation_deg,
            distance,
            target: if all || self.is(2) { Some(self.numbers()) } else { None },
        }
    }

    fn view(&mut self) -> ViewFile {
        let objects = ["body", "plane", "axis-trail", "omega", "tip"];
        ViewFile {
            layout: self.maybe(|it| it.pick(&[Layout::Both, Layout::World, Layout::Body])),
            theme: self.maybe(|it| it.pick(&[Theme::Dark, Theme::Light])),
            time_unit: self.maybe(|it| it.pick(&[TimeUnit::Second, TimeUnit::Day])),
            show: self.names(&objects),
            hide: self.names(&objects),
            labels: self.maybe(|it| it.is(2)),
            font_scale: self.maybe(|it| 0.25 + it.share()),
            slow_at_flip: self.maybe(|it| it.is(2)),
            azimuth_deg: self.maybe(Self::number),
            elevation_deg: self.maybe(Self::number),
            distance: self.maybe(|it| it.positive(-3, 3)),
            world_camera: self.camera(),
            body_camera: self.camera(),
        }
    }

    fn step(&mut self) -> StepFile {
        let objects = ["all", "body", "plane", "tip"];
        StepFile {
            title: self.text(),
            text: self.text(),
            show: self.names(&objects),
            hide: self.names(&objects),
            layout: self.maybe(|it| it.pick(&[Layout::Both, Layout::World, Layout::Body])),
            world_camera: self.camera(),
            body_camera: self.camera(),
            time: self.maybe(Self::number),
            speed: self.maybe(|it| it.pick(&[0.25, 0.1, 1.0, -2.0])),
            pause: self.maybe(|it| it.is(2)),
            slow_at_flip: self.maybe(|it| it.is(2)),
        }
    }

    fn scene(&mut self) -> SceneFile {
        SceneFile {
            title: self.text(),
            text: self.text(),
            question: self.text(),
            answer: self.text(),
            order: self.maybe(|it| it.next().cast_signed()),
            body: self.body(),
            spin: self.spin(),
            motion: self.motion(),
            cloud: self.cloud(),
            view: self.view(),
            steps: if self.is(2) { vec![] } else { (0..self.below(4)).map(|_| self.step()).collect() },
        }
    }

    /// Where energy is lost only one method knows it.
    fn motion(&mut self) -> MotionFile {
        let energy_loss = self.maybe(|it| if it.is(3) { 0.0 } else { it.positive(-9, 1) });
        let known = |method: &&Method| energy_loss.is_none_or(|loss| loss == 0.0) || method.name == LOSS_METHOD;
        let methods: Vec<&str> = METHODS.iter().filter(|method| known(method)).map(|method| method.name).collect();
        MotionFile {
            method: self.maybe(|it| it.pick(&methods).to_owned()),
            step: self.maybe(|it| it.positive(-9, 9)),
            compare: self.names(&methods),
            energy_loss,
        }
    }

    fn cloud(&mut self) -> CloudFile {
        CloudFile {
            count: self.maybe(|it| 1 + it.below(100_000).cast_signed()),
            spread_deg: self.maybe(|it| 90.0 * it.share()),
            axes: (0..self.below(4)).map(|_| self.pick(&[1, 2, 3])).collect(),
        }
    }

    /// A scene with some of its parts those of another: body, spin and motion whole, so that it stays one that can be run.
    fn mixed(&mut self, of: &SceneFile, with: &SceneFile) -> SceneFile {
        let mut mixed = of.clone();
        let is_whole = |key: &&Key| ["body.", "spin.", "motion."].iter().any(|table| key.name.starts_with(table));
        for key in KEYS.iter().filter(|key| !is_whole(key)) {
            if self.is(2) {
                key.copy(with, &mut mixed);
            }
        }
        if self.is(2) {
            mixed.body = with.body.clone();
        }
        if self.is(2) {
            mixed.spin = with.spin.clone();
        }
        if self.is(2) {
            mixed.motion = with.motion.clone();
        }
        mixed
    }
}

/// Where a link may start from: nowhere, or a built-in scene.
const STARTS: [Option<&str>; 3] = [None, Some("flip"), Some("methods")];

/// Whether text, flags and links from these starts give a scene again; what does not, in a sentence.
fn round_trips(base: &SceneFile, file: &SceneFile, starts: &[Option<&str>]) -> Result<(), String> {
    let text = file.to_toml();
    let read = SceneFile::parse(&text).map_err(|error| format!("{error}:\n{text}"))?;
    // Compared as text too: numbers that are equal may differ in the sign of zero.
    if read != *file || read.to_toml() != text {
        return Err(format!("the text reads back to another scene:\n{text}\n{read:#?}"));
    }
    let words = flags(base, file);
    let mut reached = base.clone();
    Edits::of_words(&words).map_err(|error| format!("{error}: {words:?}"))?.apply(&mut reached);
    if reached != *file {
        return Err(format!("{words:?} give another scene:\n{reached:#?}\n{file:#?}"));
    }
    for name in starts {
        let written = link::write(*name, file, Some(0.1));
        let read = link::read(&written).map_err(|error| format!("{error}: {written}"))?;
        if read.file != *file || read.time != Some(0.1) {
            return Err(format!("{written} gives another scene:\n{:#?}\n{file:#?}", read.file));
        }
    }
    Ok(())
}

#[test]
fn random_scenes_come_back_from_text_flags_and_links() -> Result<(), String> {
    let presets: Vec<SceneFile> =
        presets().iter().map(super::Preset::read).collect::<Result<_, _>>().map_err(|error| error.to_string())?;
    for seed in 0..SCENES {
        let mut random = Random(seed);
        let base = if random.is(2) { random.pick(&presets) } else { random.scene() };
        let other = random.scene();
        let file = if random.is(2) { random.mixed(&base, &other) } else { other };
        Scene::check(&file).map_err(|error| format!("seed {seed}: {error}: {}", file.to_toml()))?;
        for step in 0..file.steps.len() {
            Scene::check_at(&file, Some(step)).map_err(|error| format!("seed {seed}: step {step}: {error}"))?;
        }
        round_trips(&base, &file, &[random.pick(&STARTS)]).map_err(|error| format!("seed {seed}: {error}"))?;
    }
    Ok(())
}

#[test]
fn every_built_in_scene_comes_back_over_every_other() -> Result<(), String> {
    let read = |error: SceneError| error.to_string();
    for preset in presets() {
        let file = preset.read().map_err(read)?;
        Scene::check(&file).map_err(read)?;
        assert_eq!(flags(&file, &file), Vec::<String>::new(), "{}", preset.name);
        assert_eq!(link::write(Some(preset.name), &file, None), format!("#{}", preset.name));
        for base in presets() {
            round_trips(&base.read().map_err(read)?, &file, &STARTS)?;
        }
    }
    Ok(())
}
