//! `jeffcott accuracy`.

use std::io;

use super::jobs::{Answer, Failure, Files, Job};
use super::terminal::Progress;
use super::{Outcome, terminal};
use crate::ask::AccuracyQuestion;
use crate::integrate::Method;
use crate::scenario;
use crate::simulate::Monitor;

/// Measures speed against error: what each method and tolerance buys, and what each fidelity level of the physics
/// costs and changes.
///
/// Errors are measured against a reference that two different methods agree on, at tolerances as tight as
/// the scene allows; how far the two are apart is the uncertainty of every error. Times are those of the
/// integration alone, on one core, the shortest of some runs: on a busy machine they are too long. The
/// files hold times, and so differ from one measurement to the next.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Example:\n  jeffcott accuracy scenarios/steady-7205c.toml --tolerances 1e-4,1e-6,1e-8\n\n\
                  Each file writes to DIR/<its name without ending>/: accuracy.csv, ladder.csv,\n\
                  accuracy.svg, ladder.svg, accuracy.html and, last, accuracy.json.\n\n\
                  Exit code: 0 all is measured, 1 a scene has no reference, cannot be run or was\n\
                  interrupted, or a file cannot be written, 2 a file or the command line is wrong."
)]
pub struct Arguments {
    #[command(flatten)]
    files: Files,
    /// Methods to measure, as in [integrator]. Default: all
    #[arg(long, value_name = "A,B", value_delimiter = ',', value_parser = scenario::method)]
    methods: Vec<Method>,
    /// Tolerances to measure them at. Default: 1e-4,1e-6,1e-8,1e-10
    #[arg(long, value_name = "T,U", allow_hyphen_values = true, value_delimiter = ',', value_parser = scenario::tolerance)]
    tolerances: Vec<f64>,
    /// Leave out what would run longer than this; the reference may take four times as long
    #[arg(long, value_name = "TIME", default_value = "2 s", allow_hyphen_values = true, value_parser = scenario::time)]
    longest: f64,
}

/// Checks all files, then measures them in turn.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let (methods, tolerances) = (&arguments.methods, &arguments.tolerances);
    arguments.files.answer(
        |_| {},
        |job| {
            let longest = arguments.longest;
            let question = AccuracyQuestion::new(&job.scenario, methods, tolerances, longest)?;
            Ok(Box::new(move || measured(job, &question)))
        },
    )
}

fn measured(job: &Job, question: &AccuracyQuestion<'_>) -> Result<Answer, Failure> {
    let mut progress = Progress::new(&job.scenario.title);
    let found = question.answer(&mut Monitor {
        stop: terminal::stop(),
        progress: &mut |part| progress.show(part),
    })?;
    drop(progress);
    job.write(&found)
}
