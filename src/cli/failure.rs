//! Why a command failed: one sentence and the exit code.

use std::ffi::OsString;
use std::process::ExitCode;

use clap::error::{ContextKind, ContextValue};
use dzhanibekov::scene::SceneError;

use super::misread;

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
    if let (ErrorKind::InvalidSubcommand, Some(ContextValue::String(name))) =
        (error.kind(), error.get(ContextKind::InvalidSubcommand))
    {
        return Some(Failure::Request(misread::unknown_command(name)));
    }
    if error.kind() == ErrorKind::InvalidUtf8 {
        return Some(Failure::Request(no_text(std::env::args_os().skip(1))));
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

/// What is said where a word that is to be text is none. Of several such words all but the last may be names of files, which need be
/// no text.
fn no_text(words: impl Iterator<Item = OsString>) -> String {
    const NAMES_A_FILE: [&str; 6] = ["-o", "--output", "--json", "--peers", "--page", "--at"];
    let words: Vec<OsString> = words.collect();
    let is_text = |index: &usize| words.get(*index).is_some_and(|word| word.to_str().is_some());
    let before = |index: usize| index.checked_sub(1).and_then(|before| words.get(before)?.to_str()).unwrap_or_default();
    let wrong: Vec<usize> = (0..words.len()).filter(|index| !is_text(index)).collect();
    let meant = wrong.iter().find(|index| before(**index).starts_with('-') && !NAMES_A_FILE.contains(&before(**index)));
    let Some(index) = meant.or(wrong.last()).copied() else {
        return "a word of the command line is no UTF-8 text: write it in UTF-8".to_owned();
    };
    let word = words.get(index).map(|word| word.to_string_lossy()).unwrap_or_default();
    match before(index) {
        flag if flag.starts_with('-') => format!("the value `{word}` of {flag} is no UTF-8 text: write it in UTF-8"),
        _ => format!("`{word}` is no UTF-8 text: write it in UTF-8"),
    }
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

#[cfg(all(test, unix))]
mod tests {
    use std::ffi::OsString;
    use std::os::unix::ffi::OsStringExt;

    use super::no_text;

    #[test]
    fn the_word_that_is_no_text_is_named() {
        let line = |words: &[&[u8]]| no_text(words.iter().map(|word| OsString::from_vec(word.to_vec())));
        let said = "the value `\u{fffd}` of --method is no UTF-8 text: write it in UTF-8";
        assert_eq!(line(&[b"trace", b"--method", b"\xff", b"--at", b"1"]), said);
        // Files may have such names.
        assert_eq!(line(&[b"trace", b"\xfe.toml", b"--method", b"\xff", b"-o", b"\xfd"]), said);
        assert_eq!(line(&[b"scenes", b"\xffx"]), "`\u{fffd}x` is no UTF-8 text: write it in UTF-8");
    }
}
