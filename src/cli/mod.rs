//! What was typed, to an exit code: 0 done, 1 a run failed or a comparison differs, 2 the input
//! or the command line is wrong.
//!
//! Results go to stdout, messages to stderr, each verb in its own file.

mod accuracy;
mod analyze;
mod bearing;
mod campbell;
mod catalogue;
mod check;
mod compare;
mod demand;
mod describe;
mod estimate;
mod fit;
mod jobs;
mod matrices;
mod new;
mod pace;
mod removed;
mod response;
mod run;
mod steady;
mod study;
mod terminal;
mod written;

use std::ffi::OsString;
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// Simulates a shaft on rolling bearings: transient response and spectra.
#[derive(Debug, Parser)]
#[command(
    name = "jeffcott",
    version,
    arg_required_else_help = true,
    after_help = "Examples:\n  jeffcott new shaft.toml\n  jeffcott run shaft.toml --open"
)]
struct Arguments {
    /// CSV file of your own bearings; also $JEFFCOTT_CATALOGUE
    #[arg(long, global = true, value_name = "FILE")]
    catalogue: Option<PathBuf>,
    #[command(subcommand)]
    verb: Verb,
    #[command(flatten)]
    manner: terminal::Manner,
}

#[derive(Debug, Subcommand)]
enum Verb {
    New(new::Arguments),
    Run(run::Arguments),
    Steady(steady::Arguments),
    Bearing(bearing::Arguments),
    Campbell(campbell::Arguments),
    Response(response::Arguments),
    Matrices(matrices::Arguments),
    Analyze(analyze::Arguments),
    Study(study::Arguments),
    Fit(fit::Arguments),
    Accuracy(accuracy::Arguments),
    Check(check::Arguments),
    Compare(compare::Arguments),
    Catalogue(catalogue::Arguments),
    Estimate(estimate::Arguments),
    Schema(describe::Schema),
    Completions(describe::Completions),
    Man(describe::Manual),
}

/// How a verb ended, the worse the later: what is wrong with a file weighs more than a result that cannot be had.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Outcome {
    Done,
    /// A run failed, or results differ.
    Failed,
    WrongInput,
}

impl From<Outcome> for ExitCode {
    fn from(outcome: Outcome) -> Self {
        match outcome {
            Outcome::Done => Self::SUCCESS,
            Outcome::Failed => Self::FAILURE,
            Outcome::WrongInput => Self::from(2),
        }
    }
}

/// Runs the command line, the name of the program first.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> ExitCode {
    let Arguments {
        verb,
        manner,
        catalogue,
    } = match Arguments::try_parse_from(arguments) {
        Ok(arguments) => arguments,
        Err(usage) => {
            let usage = removed::with_way_left(usage);
            // A closed terminal is no reason to fail: the exit code already tells.
            let _ = usage.print();
            return if usage.use_stderr() {
                Outcome::WrongInput.into()
            } else {
                ExitCode::SUCCESS
            };
        }
    };
    manner.set();
    if !catalogue::add_own(catalogue.as_deref()) {
        return Outcome::WrongInput.into();
    }
    terminal::survive_limits();
    let outcome = match verb {
        Verb::New(arguments) => new::run(&arguments),
        Verb::Run(arguments) => run::run(&arguments),
        Verb::Steady(arguments) => steady::run(&arguments),
        Verb::Bearing(arguments) => bearing::run(&arguments),
        Verb::Campbell(arguments) => campbell::run(&arguments),
        Verb::Response(arguments) => response::run(&arguments),
        Verb::Matrices(arguments) => matrices::run(&arguments),
        Verb::Analyze(arguments) => analyze::run(&arguments),
        Verb::Study(arguments) => study::run(&arguments),
        Verb::Fit(arguments) => fit::run(&arguments),
        Verb::Accuracy(arguments) => accuracy::run(&arguments),
        Verb::Check(arguments) => check::run(&arguments),
        Verb::Compare(arguments) => compare::run(&arguments),
        Verb::Catalogue(arguments) => catalogue::run(&arguments),
        Verb::Estimate(arguments) => estimate::run(&arguments),
        Verb::Schema(arguments) => describe::schema(&arguments),
        Verb::Completions(arguments) => describe::completions(&arguments),
        Verb::Man(arguments) => describe::manual(&arguments),
    };
    terminal::finish(outcome)
}
