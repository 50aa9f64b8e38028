//! What the command says about its files and about itself: `jeffcott schema`, `completions` and `man`.

use std::io;
use std::path::PathBuf;

use clap::CommandFactory;
use clap_complete::Shell;
use clap_mangen::Man;

use super::{Outcome, terminal};
use crate::report::write_whole;
use crate::scenario;

/// Prints the JSON Schema of scenario, study, fit or record files, for editors.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  jeffcott schema > scenario.schema.json")]
pub struct Schema {
    /// That of study files
    #[arg(long)]
    study: bool,
    /// That of files that describe a record
    #[arg(long, conflicts_with = "study")]
    record: bool,
    /// That of fit files
    #[arg(long, conflicts_with_all = ["study", "record"])]
    fit: bool,
}

/// Prints what lets a shell complete verbs, options and their values.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  jeffcott completions bash > ~/.local/share/bash-completion/completions/jeffcott\n  \
                  jeffcott completions zsh > ~/.zfunc/_jeffcott\n  \
                  jeffcott completions fish > ~/.config/fish/completions/jeffcott.fish"
)]
pub struct Completions {
    /// The shell
    #[arg(value_name = "SHELL")]
    shell: Shell,
}

/// Writes the manual: one page of the command, and one a verb.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  jeffcott man | man -l -\n  jeffcott man --out ~/.local/share/man/man1"
)]
pub struct Manual {
    /// Write jeffcott.1 and jeffcott-VERB.1 to this folder; otherwise the page of the command is printed
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// Prints the schema.
pub fn schema(arguments: &Schema) -> io::Result<Outcome> {
    let schema = match arguments {
        Schema { study: true, .. } => scenario::study_schema(),
        Schema { record: true, .. } => scenario::record_schema(),
        Schema { fit: true, .. } => scenario::fit_schema(),
        _ => scenario::schema(),
    };
    terminal::print(&format!("{schema:#}\n"))?;
    Ok(Outcome::Done)
}

/// Prints the completions.
pub fn completions(arguments: &Completions) -> io::Result<Outcome> {
    let mut command = super::Arguments::command();
    let mut script = Vec::new();
    clap_complete::generate(arguments.shell, &mut command, "jeffcott", &mut script);
    terminal::print(&String::from_utf8_lossy(&script))?;
    Ok(Outcome::Done)
}

/// Prints the page of the command, or writes all pages and prints their paths.
pub fn manual(arguments: &Manual) -> io::Result<Outcome> {
    let mut command = super::Arguments::command();
    command.build();
    let Some(folder) = &arguments.out else {
        terminal::print(&String::from_utf8_lossy(&page(command)?))?;
        return Ok(Outcome::Done);
    };
    let verbs = command.get_subcommands().cloned();
    let verbs = verbs.filter(|verb| verb.get_name() != "help");
    for subject in verbs.chain([command.clone()]) {
        let name = subject.get_display_name().unwrap_or(subject.get_name());
        let path = folder.join(format!("{name}.1"));
        if let Err(error) = write_whole(&path, &page(subject.clone())?) {
            terminal::tell(&format!("error: {error}\n"));
            return Ok(Outcome::Failed);
        }
        terminal::print(&format!("{}\n", path.display()))?;
    }
    Ok(Outcome::Done)
}

/// The page of a verb or of the command.
fn page(command: clap::Command) -> io::Result<Vec<u8>> {
    let mut page = Vec::new();
    Man::new(command).render(&mut page)?;
    Ok(page)
}
