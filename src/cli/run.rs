//! `jeffcott run`.

use std::io;
use std::sync::atomic::Ordering;
use std::time::Instant;

use super::demand::check_memory;
use super::jobs::{Answer, Failure, Files, Job};
use super::pace::PaceWatch;
use super::written::Written;
use super::{Outcome, terminal};
use crate::ask::RunQuestion;
use crate::integrate::Progress;
use crate::scenario::Scenario;
use crate::simulate::{Model, RunSize};

/// Runs scenarios and writes their traces, spectra and figures.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  jeffcott run scenarios/steady-7205c.toml\n  \
                  jeffcott run scenarios/steady-7205c.toml --every 4 --channels \
                  x,y,force_x\n\n\
                  Each file writes to DIR/<its name without ending>/: trace.csv, events.csv,\n\
                  spectrum.csv, peaks.csv, trace.svg, spectrum.svg, report.html and, last, summary.json;\n\
                  poincare.csv and orbit.svg at constant speed; waterfall, order_tracks and campbell\n\
                  (.csv and .svg) where the speed changes; trace_balls.csv and energy.csv where the\n\
                  scenario asks for them, spectrum_NAME.csv for each of its `[[spectrum]]`,\n\
                  drive.csv where there is a drive, run_sensitivity\n\
                  and run_tornado (.csv and .svg) with --sensitivity. A run\n\
                  that cannot go on leaves trace.until-failure.csv and failure.json instead.\n\
                  With --format the tables have other formats.\n\n\
                  Exit code: 0 all runs are done, 1 a run failed or was interrupted, 2 a file is wrong."
)]
pub struct Arguments {
    #[command(flatten)]
    files: Files,
    /// Leave out the second pass, which measures the error, whatever `[integrator] verify` says
    #[arg(long)]
    no_verify: bool,
    /// Keys of the scenario that the numbers of a settled motion are differentiated by, as "bearing[*].preload,shaft.mass"
    #[arg(long, value_name = "KEY,KEY", value_delimiter = ',')]
    sensitivity: Vec<String>,
    #[command(flatten)]
    written: Written,
}

/// Checks all files, then runs them in turn.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let set = |scenario: &mut Scenario| {
        scenario.leave_out_verification(arguments.no_verify);
        arguments.written.apply(scenario);
    };
    arguments.files.answer(set, |job| {
        let question = arguments.question(job)?;
        Ok(Box::new(move || {
            if terminal::stop().load(Ordering::Relaxed) {
                return Err("interrupted before it began".into());
            }
            run_motion(job, question)
        }))
    })
}

impl Arguments {
    /// The motion of a job, where it fits into memory and has the columns that are asked for.
    fn question<'j>(&self, job: &'j Job) -> Result<RunQuestion<'j>, Failure> {
        let mut question = RunQuestion::new(&job.scenario)?;
        question.sensitivity = job.sensitivity(&self.sensitivity)?;
        // what keeps a run from beginning it tells itself
        if let Ok(size) = RunSize::from_model(question.model) {
            check_memory(&size, 1)?;
        }
        self.written.check(&question.model.rotor)?;
        Ok(question)
    }
}

/// Runs a checked scenario and writes its files.
pub fn run_motion(job: &Job, question: RunQuestion<'_>) -> Result<Answer, Failure> {
    let started = Instant::now();
    tell_of_thinning(job, question.model);
    let progress: [Progress; 3] = Default::default();
    let mut watch = PaceWatch::new(job, question.model, &progress);
    let found = terminal::watched(
        move || watch.look(),
        || question.write(&job.folder, terminal::stop(), &progress),
    )?;
    Ok(job.answer(found).timed(started))
}

/// Says where the tables leave samples out though nobody asked for it.
fn tell_of_thinning(job: &Job, model: &Model) {
    let output = &job.scenario.output;
    let written = output.written_of(model.samples());
    if output.every.is_none() && output.trace && written.get() > 1 {
        job.note(&format!(
            "the trace holds one of every {written} samples, at most 100 000 rows; `every` in [output], or \
             --every, asks for more or fewer"
        ));
    }
}
