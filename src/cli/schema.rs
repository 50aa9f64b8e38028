//! `jeffcott schema`.

use std::io;

use super::{Outcome, stream};
use crate::scenario;

/// Prints the JSON Schema of scenario files, for editors.
#[derive(Debug, clap::Args)]
#[command(after_help = "Example:\n  jeffcott schema > scenario.schema.json")]
pub struct Arguments {}

/// Prints the schema.
pub fn run() -> io::Result<Outcome> {
    stream::print(&format!("{:#}\n", scenario::schema()))?;
    Ok(Outcome::Done)
}
