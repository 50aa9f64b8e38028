//! `jeffcott report`.

use std::io;
use std::path::PathBuf;

use super::{Outcome, terminal};
use crate::report::side_by_side::write_side_by_side;
use crate::report::wrote;

/// Puts several runs on one page: their key numbers side by side, their traces and spectra over each other.
///
/// The page is one file that any browser opens from disk.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Example:\n  jeffcott report output/steady-7205c output/linear-7205c --out both.html\n\n\
                  Exit code: 0 the page is written, 2 a folder holds no run, or the page cannot be written."
)]
pub struct Arguments {
    /// Folders that `jeffcott run` has written
    #[arg(required = true, value_name = "DIR")]
    folders: Vec<PathBuf>,
    /// The page
    #[arg(long, value_name = "FILE.html", default_value = "output/report.html")]
    out: PathBuf,
}

/// Writes the page.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    match write_side_by_side(&arguments.folders, &arguments.out) {
        Ok(()) => {
            terminal::summarise(&wrote(std::slice::from_ref(&arguments.out)))?;
            Ok(Outcome::Done)
        }
        Err(error) => Ok(terminal::refuse(error.with_causes())),
    }
}
