//! Feeds mutated scenes to the reader and random command lines to the program, and fails on a panic, on an exit code
//! that is none of 0, 1, 2, on more than one sentence, and on anything that takes a second.

use std::panic::catch_unwind;
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};
use std::time::{Duration, Instant};

use dzhanibekov::scene::{Edits, Scene, SceneFile, flags, link, presets};

/// Longest time that one input may take.
const LIMIT: Duration = Duration::from_secs(1);
/// Address space that the program may have for a command without a picture (KiB): far more than 200 MB resident.
const MEMORY: u32 = 200_000;

/// A small generator (splitmix64), so that a seed gives the same inputs everywhere.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, end: usize) -> usize {
        (self.next() % end.max(1) as u64) as usize
    }

    fn pick<'a, T: ?Sized>(&mut self, from: &[&'a T]) -> &'a T {
        from[self.below(from.len())]
    }
}

const NUMBERS: &[&str] = &[
    "0", "-1", "1", "1e-320", "1e308", "1e400", "nan", "inf", "-inf", "+nan", "0.1", "1e-150", "1e150", "-0.0", "9999999999999999999999",
    "0x10", "1_000", "true", "\"x\"", "[]", "{}", "1979-05-27", "1.7976931348623157e308", "5e-324",
];

const PIECES: &[&str] = &[
    "\n", "[", "]", "[[", "]]", "=", ",", ".", "\"", "\"\"\"", "'", "#", "\0", "\u{feff}", "\r\n", "é", "[body]", "[spin]", "[motion]",
    "[view]", "[[body.solids]]", "box", "moments", "inertia", "omega", "axis", "tilt_deg", "rate", "method", "step", "compare", "solids", "energy_loss", "[cloud]", "count", "spread_deg", "axes",
    "kind", "size", "show", "hide", "[[step]]", "\n[[step]]\n", "text = \"\"", "answer = 'x'", "time", "speed", "pause", "all", "a.b.c.d.e", "{a={a={a={a=1}}}}", "\\u0000", "\u{202e}",
];

fn mutated(random: &mut Random, texts: &[&'static str]) -> String {
    let mut text = random.pick(texts).to_owned();
    for _ in 0..1 + random.below(6) {
        let mut at = random.below(text.len() + 1);
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        match random.below(7) {
            0 => text.insert_str(at, random.pick(NUMBERS)),
            1 => text.insert_str(at, random.pick(PIECES)),
            2 => text.truncate(at),
            3 => text = text.split_off(at),
            4 => text.insert(at, char::from_u32(random.below(0x3000) as u32).unwrap_or('?')),
            5 => {
                // A number of the text replaced by another.
                if let Some(start) = text[at..].find(|c: char| c.is_ascii_digit()).map(|offset| at + offset) {
                    let end = text[start..].find(|c: char| !c.is_ascii_digit() && c != '.').map_or(text.len(), |offset| start + offset);
                    text.replace_range(start..end, random.pick(NUMBERS));
                }
            }
            _ => {
                let other = random.pick(texts);
                let end = other.len().min(random.below(200));
                if let Some(piece) = other.get(..end) {
                    text.insert_str(at, piece);
                }
            }
        }
    }
    if random.below(2000) == 0 {
        text.push_str(&"[".repeat(5000));
    }
    text
}

/// Reads one text; what is read and holds is written as text, flags and a link, and must read back the same.
fn read(text: &str) -> Result<(), String> {
    let Ok(file) = SceneFile::parse(text) else { return Ok(()) };
    let Ok(scene) = Scene::check(&file) else { return Ok(()) };
    for step in 0..file.steps.len() {
        Scene::check_at(&file, Some(step)).map_err(|error| format!("step {step} is refused alone: {error}"))?;
    }
    let state = scene.start;
    if !(state.world_from_body.is_finite() && state.body_momentum.is_finite()) {
        return Err("a scene that was let pass starts with no numbers".to_owned());
    }
    let written = scene.file.to_toml();
    match SceneFile::parse(&written) {
        Ok(again) if again == scene.file => {}
        Ok(_) => return Err(format!("reads back to another scene:\n{written}")),
        Err(error) => return Err(format!("does not read back: {error}:\n{written}")),
    }
    let words = flags(&SceneFile::default(), &scene.file);
    let mut reached = SceneFile::default();
    Edits::of_words(&words).map_err(|error| format!("{words:?} are not read: {error}"))?.apply(&mut reached);
    if reached != scene.file {
        return Err(format!("{words:?} give another scene:\n{written}"));
    }
    let link = link::write(Some("flip"), &scene.file, Some(1.0));
    match link::read(&link) {
        Ok(read) if read.file == scene.file => Ok(()),
        Ok(_) => Err(format!("{link} gives another scene:\n{written}")),
        Err(error) => Err(format!("{link} is not read: {error}:\n{written}")),
    }
}

fn scenes(random: &mut Random, count: usize) -> usize {
    let texts: Vec<&'static str> = presets().iter().map(|preset| preset.text).collect();
    let mut failures = 0;
    let mut slowest = Duration::ZERO;
    for _ in 0..count {
        let text = mutated(random, &texts);
        let begun = Instant::now();
        let outcome = catch_unwind(|| read(&text)).unwrap_or_else(|_| Err("panicked".to_owned()));
        let taken = begun.elapsed();
        slowest = slowest.max(taken);
        let complaint = outcome.err().or_else(|| (taken > LIMIT).then(|| format!("took {taken:?}")));
        if let Some(complaint) = complaint {
            failures += 1;
            eprintln!("fuzz: {complaint}\n----\n{text}\n----");
        }
    }
    println!("fuzz: {count} scene texts, {failures} failures, the slowest took {slowest:?}");
    failures
}

const WORDS: &[&str] = &[
    "trace", "scenes", "methods", "flip", "t-handle", "nosuch", "--json", "--help", "--at", "--every", "--duration", "--box", "--moments",
    "--inertia", "--omega", "--axis", "--tilt", "--rate", "--method", "--step", "--compare", "--mass", "--energy-loss", "0.02", "motion.energy_loss=1", "cloud.axes=[1,3]", "-o", "-", "--", "--quiet", "exact-step",
    "closed-form", "buss", "1,2,3", "0.1,0.2,0.3", "1,1,1,0,0,0", "-1,0,2", "1,nan,2", "inf,1,1", "1e-200,1e-200,1e-200", "1,1,1e300", "0,0,0",
    "2", "1", "0", "-5", "1e12", "1e-300", "nan", "é", "", "/dev/null", "/", ".", "💥", "--version", "--=", "-x", "--set", "spin.rate=3", "motion.compare=[]", "body.solids=[]", "spin=", "title=é", "#flip?spin.rate=8&time=1", "#scene=eJw", "#", "-o-", "--at=1,2,3",
];

fn command_lines(random: &mut Random, program: &Path, count: usize) -> usize {
    // Whatever a line happens to write is written there.
    let scratch = std::env::temp_dir().join(format!("dzhanibekov-fuzz-{}", std::process::id()));
    if let Err(error) = std::fs::create_dir_all(&scratch) {
        eprintln!("fuzz: {}: {error}", scratch.display());
        return 1;
    }
    let mut failures = 0;
    let mut slowest = Duration::ZERO;
    for _ in 0..count {
        // A trace of few rows first, so that most lines are understood; never a window or a picture.
        let mut words = vec!["trace", "--at", "0,0.5"];
        if random.below(4) == 0 {
            words = vec![random.pick(&["scenes", "methods", "trace"])];
            words.extend(["--at", "1"].iter().filter(|_| words[0] == "trace").copied().collect::<Vec<_>>());
        }
        for _ in 0..random.below(6) {
            words.push(random.pick(WORDS));
        }
        // A step so small, or a time so late, that honest work takes more than a second is no failure.
        let is_long = words.iter().any(|word| ["1e12", "1e-300", "--every", "--duration"].contains(word));
        if is_long {
            continue;
        }
        let begun = Instant::now();
        let output = Command::new("sh")
            .args(["-c", &format!("ulimit -v {MEMORY}; exec \"$0\" \"$@\"")])
            .arg(program)
            .args(&words)
            .current_dir(&scratch)
            .stdin(Stdio::null())
            .output();
        let taken = begun.elapsed();
        slowest = slowest.max(taken);
        let complaint = match output {
            Err(error) => Some(error.to_string()),
            Ok(output) => {
                let said = String::from_utf8_lossy(&output.stderr).into_owned();
                match output.status.code() {
                    None => Some(format!("was killed: {said}")),
                    Some(code) if code > 2 => Some(format!("exit code {code}: {said}")),
                    _ if said.contains("panicked") => Some(said),
                    Some(1 | 2) if said.lines().count() != 1 && !said.contains("no solid has") => Some(format!("not one sentence: {said}")),
                    _ if taken > LIMIT => Some(format!("took {taken:?}")),
                    _ => None,
                }
            }
        };
        if let Some(complaint) = complaint {
            failures += 1;
            eprintln!("fuzz: {words:?}: {complaint}");
        }
    }
    let _ = std::fs::remove_dir_all(&scratch);
    println!("fuzz: {count} command lines, {failures} failures, the slowest took {slowest:?}");
    failures
}

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let Some(program) = arguments.next() else {
        eprintln!("usage: fuzz PROGRAM [SCENE_TEXTS] [COMMAND_LINES] [SEED]");
        return ExitCode::from(2);
    };
    let mut number = |otherwise: u64| arguments.next().and_then(|text| text.parse().ok()).unwrap_or(otherwise);
    let (texts, lines, seed) = (number(1_000_000) as usize, number(10_000) as usize, number(1));
    // Each is said once, with its input, below.
    std::panic::set_hook(Box::new(|_| {}));
    let program = match Path::new(&program).canonicalize() {
        Ok(program) => program,
        Err(error) => {
            eprintln!("fuzz: {program}: {error}");
            return ExitCode::from(2);
        }
    };
    let failures = scenes(&mut Random(seed), texts) + command_lines(&mut Random(!seed), &program, lines);
    ExitCode::from(u8::from(failures > 0))
}
