//! The program: reads the command line, does what it says, prints an error once.

mod cli;

fn main() -> std::process::ExitCode {
    cli::main()
}
