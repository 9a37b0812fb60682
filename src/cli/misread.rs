//! Command lines on which a command stands where none is read, or is misspelt: what is said of them.

use std::path::Path;

use clap::{Arg, Command, CommandFactory};
use dzhanibekov::scene::{link, nearest, preset, presets, quoted};

/// A flag as it stands, with its value.
struct Given {
    name: String,
    words: Vec<String>,
}

/// What is wrong with the words of a command line in which no command was read, if it is this. Where they were refused no name
/// is taken for a scene's that is a command's too.
pub(super) fn sentence(words: &[String], is_refused: bool) -> Option<String> {
    let mut program = super::Arguments::command();
    program.build();
    let (mut scenes, mut flags): (Vec<&str>, Vec<Given>) = (vec![], vec![]);
    let mut rest = words.iter();
    while let Some(word) = rest.next() {
        if word == "--" {
            return None;
        }
        if word.starts_with('-') && word.len() > 1 {
            let name = word.split('=').next().unwrap_or_default().to_owned();
            let mut words = vec![word.clone()];
            if !word.contains('=') && takes_value(&program, &name) {
                words.extend(rest.next().cloned());
            }
            flags.push(Given { name, words });
        } else if let Some(command) = program.find_subcommand(word) {
            let is_in_place = scenes.is_empty() && flags.is_empty();
            let is_scene = !is_refused && preset(word).is_ok();
            return (!is_in_place && !is_scene).then(|| before(command, &scenes, &flags, rest.len() > 0));
        } else {
            scenes.push(word);
        }
    }
    let (first, second) = (scenes.first()?, scenes.get(1));
    let commands: Vec<&str> = program.get_subcommands().map(Command::get_name).collect();
    let near = nearest(first, commands.iter().copied().chain(presets().iter().map(|preset| preset.name)));
    match (near.filter(|near| commands.contains(near) && !is_scene(first)), second) {
        (Some(near), _) => Some(format!("no scene or command is called `{first}`: did you mean `{near}`?")),
        (None, Some(second)) if is_refused => Some(format!(
            "`{second}` is one scene too many beside `{first}`: the window shows one, or a folder of scene files"
        )),
        _ => None,
    }
}

/// What is said of a command that a misspelt name was given for: after `help`.
pub(super) fn unknown_command(name: &str) -> String {
    let program = super::Arguments::command();
    match nearest(name, program.get_subcommands().map(Command::get_name)) {
        Some(near) => format!("no command is called `{name}`: did you mean `{near}`?"),
        None => format!("no command is called `{name}`: `dzhanibekov --help` lists them"),
    }
}

/// What is said where a scene or flags stand before a command, of which more is said after it or not.
fn before(command: &Command, scenes: &[&str], flags: &[Given], has_more: bool) -> String {
    let name = command.get_name();
    let folder =
        if Path::new(name).exists() { format!("; what is here by this name is ./{name}") } else { String::new() };
    if let Some(flag) = flags.iter().find(|flag| !has_flag(command, &flag.name)) {
        return format!(
            "`{}` stands before the command `{name}`, which has no such flag: `dzhanibekov {name} --help` lists its flags{folder}",
            flag.name
        );
    }
    let takes_scene = command.get_positionals().next().is_some();
    let words = |given: &[String]| quoted(given);
    let flags: Vec<String> = flags.iter().flat_map(|flag| flag.words.clone()).collect();
    let scenes: Vec<String> = scenes.iter().map(|scene| (*scene).to_owned()).collect();
    let stands = [scenes.clone(), flags.clone()].concat();
    let mut line = format!("dzhanibekov {name}");
    let more = if has_more { vec!["…".to_owned()] } else { vec![] };
    let scenes = if takes_scene { scenes } else { vec![] };
    for part in [words(&scenes), more.concat(), words(&flags)].iter().filter(|part| !part.is_empty()) {
        line.push(' ');
        line.push_str(part);
    }
    format!("`{}` stands before the command: write `{line}`{folder}", words(&stands))
}

/// Whether a word names a scene, or a file that is read as one and then says what is wrong with it.
fn is_scene(word: &str) -> bool {
    let is_path = word.contains(['/', '\\', '.']) || Path::new(word).exists();
    is_path || link::is_link(word) || preset(word).is_ok()
}

/// Whether a flag, of whatever command, is followed by a value.
fn takes_value(program: &Command, name: &str) -> bool {
    let mut all = std::iter::once(program).chain(program.get_subcommands()).flat_map(Command::get_arguments);
    all.find(|flag| is_called(flag, name)).is_some_and(|flag| flag.get_action().takes_values())
}

/// Whether a command has a flag.
fn has_flag(command: &Command, name: &str) -> bool {
    command.get_arguments().any(|flag| is_called(flag, name))
}

/// Whether a flag is written so.
fn is_called(flag: &Arg, name: &str) -> bool {
    let long = flag.get_long().is_some_and(|long| name.strip_prefix("--") == Some(long));
    long || flag.get_short().is_some_and(|short| name.strip_prefix('-') == Some(short.encode_utf8(&mut [0; 4])))
}

#[cfg(all(test, feature = "headless"))]
mod tests {
    use super::{sentence, unknown_command};

    fn said(line: &str, is_refused: bool) -> Option<String> {
        let words: Vec<String> = line.split(' ').map(str::to_owned).collect();
        sentence(&words, is_refused)
    }

    #[test]
    fn what_stands_before_a_command_is_put_behind_it() {
        for (line, sentence) in [
            ("--quiet scenes", "`--quiet` stands before the command: write `dzhanibekov scenes --quiet`"),
            ("--quiet shot flip -o q.png", "`--quiet` stands before the command: write `dzhanibekov shot … --quiet`"),
            ("--quiet trace --at 0", "`--quiet` stands before the command: write `dzhanibekov trace … --quiet`"),
            ("--at 0,1 trace", "`--at 0,1` stands before the command: write `dzhanibekov trace --at 0,1`"),
            (
                "--omega -1,0,2 trace",
                "`--omega -1,0,2` stands before the command: write `dzhanibekov trace --omega -1,0,2`",
            ),
            ("-o a.png shot", "`-o a.png` stands before the command: write `dzhanibekov shot -o a.png`"),
            ("flip shot -o a.png", "`flip` stands before the command: write `dzhanibekov shot flip …`"),
            ("flip --rate=3 shot", "`flip --rate=3` stands before the command: write `dzhanibekov shot flip --rate=3`"),
            ("flip scenes", "`flip` stands before the command: write `dzhanibekov scenes`"),
            (
                "--quiet --size 9x9 trace",
                "`--size` stands before the command `trace`, which has no such flag: `dzhanibekov trace --help` lists its flags",
            ),
        ] {
            assert_eq!(said(line, true).as_deref(), Some(sentence), "{line}");
        }
        assert_eq!(said("--quiet scenes", false), said("--quiet scenes", true));
        // A built-in scene's name is one, where it can be.
        assert_eq!(said("--quiet methods", false), None);
        assert!(said("--quiet methods --json", true).is_some());
        for line in ["shot flip --nonsense", "--theme shot flip", "-- trace flip", "--nonsense", "flip --nonsense"] {
            assert_eq!(said(line, true), None, "{line}");
        }
    }

    #[test]
    fn a_misspelt_command_is_told_the_nearest() {
        for (line, near) in [("shott flip", "shott`: did you mean `shot`?"), ("trce", "trce`: did you mean `trace`?")] {
            let sentence = format!("no scene or command is called `{near}");
            assert_eq!(said(line, false).as_deref(), Some(&*sentence), "{line}");
        }
        for line in ["flop", "flip", "./shott", "shott.toml", "qqqqqqq", "methods"] {
            assert_eq!(said(line, false), None, "{line}");
        }
        let many = "`turn` is one scene too many beside `flip`: the window shows one, or a folder of scene files";
        assert_eq!(said("flip turn", true).as_deref(), Some(many));
        assert_eq!(unknown_command("trce"), "no command is called `trce`: did you mean `trace`?");
        assert_eq!(unknown_command("qqqqqqq"), "no command is called `qqqqqqq`: `dzhanibekov --help` lists them");
    }
}
