//! `jeffcott man`.

use std::io;
use std::path::{Path, PathBuf};

use clap::CommandFactory;
use clap_mangen::Man;

use super::{Outcome, stream};
use crate::report::write_whole;

/// Writes the manual: one page of the command, and one a verb.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  jeffcott man | man -l -\n  jeffcott man --out ~/.local/share/man/man1"
)]
pub struct Arguments {
    /// Write jeffcott.1 and jeffcott-VERB.1 to this folder; otherwise the page of the command is printed
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// Prints the page of the command, or writes all pages.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let mut command = super::Arguments::command();
    command.build();
    let Some(folder) = &arguments.out else {
        stream::print(&String::from_utf8_lossy(&page(command)?))?;
        return Ok(Outcome::Done);
    };
    for verb in command
        .get_subcommands()
        .filter(|verb| verb.get_name() != "help")
    {
        let name = format!("jeffcott-{}.1", verb.get_name());
        if !written(&folder.join(name), &page(verb.clone())?)? {
            return Ok(Outcome::Failed);
        }
    }
    let whole = written(&folder.join("jeffcott.1"), &page(command)?)?;
    Ok(if whole {
        Outcome::Done
    } else {
        Outcome::Failed
    })
}

fn page(command: clap::Command) -> io::Result<Vec<u8>> {
    let mut page = Vec::new();
    Man::new(command).render(&mut page)?;
    Ok(page)
}

/// Writes a page and tells its path, or what kept it from being written.
fn written(path: &Path, page: &[u8]) -> io::Result<bool> {
    match write_whole(path, page) {
        Ok(()) => stream::print(&format!("{}\n", path.display())).map(|()| true),
        Err(error) => {
            stream::tell(&format!("error: {error}\n"));
            Ok(false)
        }
    }
}
