//! Why a command failed: one sentence and the exit code.

use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue};
use dzhanibekov::scene::SceneError;

/// A failure, by what the caller can do about it.
#[derive(Debug)]
pub(super) enum Failure {
    /// The request was wrong: exit code 2.
    Request(String),
    /// The request was right and could not be carried out: exit code 1.
    CouldNot(String),
    /// Who read the result went away, which is no fault: `| head -1`. Nothing is said, exit code 0.
    ReaderGone,
}

impl Failure {
    pub(super) fn request(message: impl Into<String>) -> Self {
        Self::Request(message.into())
    }

    pub(super) fn could_not(message: impl Into<String>) -> Self {
        Self::CouldNot(message.into())
    }

    /// A part that this build of the program was made without.
    pub(super) fn not_built(what: &str, feature: &str) -> Self {
        Self::could_not(format!("this program was built without {what}: build it with `--features {feature}`"))
    }

    /// Prints the sentence and gives the exit code.
    pub(super) fn report(self) -> ExitCode {
        let (message, code) = match self {
            Self::Request(message) => (message, 2),
            Self::CouldNot(message) => (message, 1),
            Self::ReaderGone => return ExitCode::SUCCESS,
        };
        say(&message);
        ExitCode::from(code)
    }
}

/// Says something on standard error. Where even that is closed or full there is nobody left to tell, and the result
/// is worth more than the words.
pub(super) fn say(message: &str) {
    let _ = std::io::Write::write_all(&mut std::io::stderr(), format!("dzhanibekov: {message}\n").as_bytes());
}

impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        Self::Request(error.to_string())
    }
}

/// A command line that clap refuses, in one sentence; `None` where help or the version was asked for.
pub(super) fn of_command_line(error: &clap::Error) -> Option<Failure> {
    use clap::error::ErrorKind;
    if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) {
        return None;
    }
    let file = (error.kind() == ErrorKind::UnknownArgument).then(|| dashed_file(error)).flatten();
    let text = error.to_string();
    let mut sentence = String::new();
    for line in text.lines().map(str::trim) {
        if file.is_some() && line.starts_with("tip:") {
            continue;
        }
        if line.starts_with("Usage:") || line.starts_with("For more information") {
            break;
        }
        if line.is_empty() {
            continue;
        }
        let line = line.trim_start_matches("error: ");
        if !sentence.is_empty() {
            sentence.push_str(if sentence.ends_with(':') { " " } else { "; " });
        }
        sentence.push_str(line.trim_start_matches("tip: "));
    }
    if let Some(file) = file {
        sentence.push_str("; a file of this name is written ./");
        sentence.push_str(&file);
    }
    Some(Failure::Request(sentence))
}

/// The argument that clap does not know, where it is a file's name that begins with a dash.
fn dashed_file(error: &clap::Error) -> Option<String> {
    const NAMES_A_FILE: [&str; 4] = ["-o", "--output", "--json", "--peers"];
    let Some(ContextValue::String(unknown)) = error.get(ContextKind::InvalidArg) else { return None };
    let arguments: Vec<String> = std::env::args_os().map(|argument| argument.to_string_lossy().into_owned()).collect();
    // Clap reads `-x.csv` as a row of flags of one letter and names the first alone.
    arguments.windows(2).find_map(|pair| {
        let [before, argument] = pair else { return None };
        let is_file = argument.contains('.') || NAMES_A_FILE.contains(&before.as_str());
        (argument.starts_with(unknown) && is_file).then(|| argument.clone())
    })
}
