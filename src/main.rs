//! The command `jeffcott`.

use std::process::ExitCode;

fn main() -> ExitCode {
    jeffcott::cli::run(std::env::args_os())
}
