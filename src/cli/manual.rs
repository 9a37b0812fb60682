//! The man page and shell completions, made from the command line's own definition.

use clap::{Args, CommandFactory};
use clap_complete::Shell;

use super::failure::Failure;
use super::lists::print;

/// Flags of `completions`.
#[derive(Args, Debug)]
pub(super) struct CompletionArguments {
    /// The shell
    shell: Shell,
}

/// Completions for a shell, on standard output.
pub(super) fn completions(arguments: &CompletionArguments) -> Result<(), Failure> {
    let mut text = vec![];
    clap_complete::generate(arguments.shell, &mut super::Arguments::command(), "dzhanibekov", &mut text);
    print(&String::from_utf8_lossy(&text))
}

/// The man page, its commands included, on standard output.
pub(super) fn man() -> Result<(), Failure> {
    let command = super::Arguments::command();
    let mut text = vec![];
    let failed = |error| Failure::could_not(format!("the man page could not be made: {error}"));
    clap_mangen::Man::new(command.clone()).render(&mut text).map_err(failed)?;
    // Flags and a scene are the window's; those of a command stand behind it.
    let commands = "\n.br\n\\fBdzhanibekov\\fR \\fICOMMAND\\fR [\\fIOPTIONS\\fR]";
    let mut text = String::from_utf8_lossy(&text).replacen(" [\\fIsubcommands\\fR]", commands, 1).into_bytes();
    for part in command.get_subcommands().filter(|part| !part.is_hide_set()) {
        let man = clap_mangen::Man::new(part.clone().display_name(format!("dzhanibekov {}", part.get_name())));
        man.render_synopsis_section(&mut text).map_err(failed)?;
        man.render_description_section(&mut text).map_err(failed)?;
        man.render_options_section(&mut text).map_err(failed)?;
        man.render_extra_section(&mut text).map_err(failed)?;
    }
    print(&String::from_utf8_lossy(&text))
}
