//! `jeffcott completions`.

use std::io;

use clap::CommandFactory;
use clap_complete::Shell;

use super::{Outcome, stream};

/// Prints what lets a shell complete verbs, options and their values.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  jeffcott completions bash > ~/.local/share/bash-completion/completions/jeffcott\n  \
                  jeffcott completions zsh > ~/.zfunc/_jeffcott\n  \
                  jeffcott completions fish > ~/.config/fish/completions/jeffcott.fish"
)]
pub struct Arguments {
    /// The shell
    #[arg(value_name = "SHELL")]
    shell: Shell,
}

/// Prints the completions.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let mut command = super::Arguments::command();
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut command, "jeffcott", &mut script);
    stream::print(&String::from_utf8_lossy(&script))?;
    Ok(Outcome::Done)
}
