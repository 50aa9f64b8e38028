//! `jeffcott schema`.

use std::io;

use super::{Outcome, stream};
use crate::scenario;

/// Prints the JSON Schema of scenario files, or of study files, for editors.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  jeffcott schema > scenario.schema.json")]
pub struct Arguments {
    /// That of study files
    #[arg(long)]
    study: bool,
}

/// Prints the schema.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let schema = if arguments.study {
        scenario::study_schema()
    } else {
        scenario::schema()
    };
    stream::print(&format!("{schema:#}\n"))?;
    Ok(Outcome::Done)
}
