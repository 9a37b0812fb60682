//! The flags that say something over a scene, made from the table of its keys.

use clap::builder::{PossibleValuesParser, TypedValueParser, ValueParser};
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches};

use dzhanibekov::scene::{Edit, KEYS, Key, Kind, SceneError};

/// What the flags of body, spin and motion say.
#[derive(Debug)]
pub(super) struct SceneFlags(pub(super) Vec<Edit>);

/// What the flags of the view say.
#[derive(Debug)]
pub(super) struct ViewFlags(pub(super) Vec<Edit>);

/// Whether a key is one of the view's.
fn is_of_view(key: &Key) -> bool {
    key.name.starts_with("view.")
}

/// The keys that have a flag, of the view or not.
fn keys(of_view: bool) -> impl Iterator<Item = &'static Key> {
    KEYS.iter().filter(move |key| key.flag.is_some() && is_of_view(key) == of_view)
}

/// Adds the flags to a command.
fn add(command: Command, of_view: bool) -> Command {
    keys(of_view).filter_map(argument).fold(command, Command::arg)
}

/// The flag of a key.
fn argument(key: &'static Key) -> Option<Arg> {
    let flag = key.flag?;
    let help = if key.unit.is_empty() { flag.help.to_owned() } else { format!("{} ({})", flag.help, key.unit) };
    let argument = Arg::new(key.name)
        .long(flag.name)
        .value_name(flag.value)
        .help(help)
        .help_heading(if is_of_view(key) { "Picture" } else { "Scene" })
        // Names that are given in several flags are one list.
        .action(if key.kind == Kind::Names { ArgAction::Append } else { ArgAction::Set })
        .value_parser(parser(key));
    // Negative numbers stand after a blank as after `=`; a name never begins with a dash.
    Some(argument.allow_hyphen_values(!matches!(key.kind, Kind::Text | Kind::Names | Kind::Choice(_) | Kind::Switch)))
}

/// Reads the word after the flag of a key.
fn parser(key: &'static Key) -> ValueParser {
    let read = move |word: String| Edit::flag(key, &word);
    match key.kind {
        Kind::Choice(names) => PossibleValuesParser::new(names).try_map(read).into(),
        Kind::Switch => PossibleValuesParser::new(["on", "off"]).try_map(read).into(),
        _ => ValueParser::new(move |word: &str| -> Result<Edit, SceneError> { Edit::flag(key, word) }),
    }
}

/// What the flags say that were given, each list of names as one.
fn given(matches: &ArgMatches, of_view: bool) -> Vec<Edit> {
    let given = keys(of_view).filter_map(|key| {
        let edits = matches.get_many::<Edit>(key.name)?;
        edits.cloned().reduce(|edit, other| edit.and(&other))
    });
    given.collect()
}

/// Makes a set of flags of the command line out of those of one half of the table.
macro_rules! flags {
    ($type:ident, $of_view:literal) => {
        impl Args for $type {
            fn augment_args(command: Command) -> Command {
                add(command, $of_view)
            }

            fn augment_args_for_update(command: Command) -> Command {
                add(command, $of_view)
            }
        }

        impl FromArgMatches for $type {
            fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
                Ok(Self(given(matches, $of_view)))
            }

            fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
                self.0 = given(matches, $of_view);
                Ok(())
            }
        }
    };
}

flags!(SceneFlags, false);
flags!(ViewFlags, true);
