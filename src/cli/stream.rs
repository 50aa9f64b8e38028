//! Stdout for results, stderr for messages, and what happens when a reader goes away.

use std::io::{self, ErrorKind, IsTerminal, Write};
use std::process::ExitCode;

use super::Outcome;

/// Writes a result to stdout.
///
/// # Errors
/// Whatever keeps stdout from taking it.
pub fn print(text: &str) -> io::Result<()> {
    let mut stdout = io::stdout().lock();
    stdout.write_all(text.as_bytes())?;
    stdout.flush()
}

/// Writes a message to stderr; there is nowhere to tell that it could not be written.
pub fn tell(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

/// Whether messages are coloured: on a terminal, unless `NO_COLOR` is set.
pub fn color() -> bool {
    let refused = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    !refused && io::stderr().is_terminal()
}

/// The exit code of a verb. A reader that closed the pipe has what it wanted.
pub fn finish(outcome: io::Result<Outcome>) -> ExitCode {
    match outcome {
        Ok(outcome) => outcome.into(),
        Err(error) if error.kind() == ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(error) => {
            tell(&format!("error: cannot write the result: {error}\n"));
            ExitCode::FAILURE
        }
    }
}
