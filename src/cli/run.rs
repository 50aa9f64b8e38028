//! `jeffcott run`.

use std::io;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use serde_json::Value;

use super::jobs::{Job, document, jobs};
use super::progress::Progress;
use super::{Outcome, stream};
use crate::integrate::IntegrateError;
use crate::report::{self, Outputs, RunReport};
use crate::scenario::Scenario;
use crate::simulate::{Model, Monitor, Run, SimulateError, simulate};

/// Runs scenarios and writes their traces, spectra and figures.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Example:\n  jeffcott run scenarios/steady-7205c.toml\n\n\
                  Each file writes to DIR/<its name without ending>/: trace.csv, events.csv,\n\
                  spectrum.csv, trace.svg, spectrum.svg and, last, summary.json; trace_balls.csv and\n\
                  energy.csv where the scenario asks for them, drive.csv where there is a drive.\n\n\
                  Exit code: 0 all runs are done, 1 a run failed or was interrupted, 2 a file is wrong."
)]
pub struct Arguments {
    /// Scenario files, .toml or .json
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Folder that the run folders are written to
    #[arg(long, value_name = "DIR", default_value = "output")]
    out: PathBuf,
    /// Print the summary as JSON, with the wall time: an object, or an array for several files
    #[arg(long)]
    json: bool,
}

/// Set by Ctrl-C and by a request to terminate.
static STOP: AtomicBool = AtomicBool::new(false);

/// Checks all files, then runs them in turn.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let jobs = jobs(&arguments.files, &arguments.out);
    let Some(motions) = jobs.and_then(motions) else {
        return Ok(Outcome::WrongInput);
    };
    // Without a handler an interrupt ends the process at once; the run folder stays safe as well.
    let _ = ctrlc::set_handler(|| STOP.store(true, Ordering::Relaxed));
    let mut outcome = Outcome::Done;
    let mut summaries = Vec::new();
    for motion in &motions {
        if STOP.load(Ordering::Relaxed) {
            break;
        }
        match motion.run() {
            Ok(done) if arguments.json => summaries.push(done.json(motion)),
            Ok(done) => done.print(motion)?,
            Err(failure) => {
                stream::tell(&format!("error: {}: {failure}\n", motion.job.name));
                outcome = Outcome::Failed;
            }
        }
    }
    if arguments.json {
        stream::print(&document(motions.len(), summaries))?;
    }
    Ok(outcome)
}

/// A checked scenario, its motion and where its results go.
struct Motion {
    job: Job,
    model: Model,
}

/// The motions of all jobs; `None` where a scenario has none, after telling of all of them.
fn motions(jobs: Vec<Job>) -> Option<Vec<Motion>> {
    let motion = |mut job: Job| {
        let model = job.scenario.model.take();
        if model.is_none() {
            stream::tell(&format!(
                "error: {}: `run` needs a table `[time]`; `jeffcott bearing` does without\n",
                job.name
            ));
        }
        model.map(|model| Motion { job, model })
    };
    let motions: Vec<_> = jobs.into_iter().map(motion).collect();
    motions.into_iter().collect()
}

/// Why a job failed, in words.
#[derive(Debug, thiserror::Error)]
enum Failure {
    #[error(transparent)]
    Report(#[from] report::ReportError),
    #[error(transparent)]
    Simulate(#[from] SimulateError),
    #[error("{0}; nothing was written")]
    Interrupted(IntegrateError),
}

impl Motion {
    fn run(&self) -> Result<Done, Failure> {
        let started = Instant::now();
        let (job, model) = (&self.job, &self.model);
        let Scenario {
            title,
            output,
            echo,
            ..
        } = &job.scenario;
        let outputs = Outputs {
            trace: output.trace,
            energy: model.energy || model.rotor.drive.is_some(),
            drive: model.rotor.drive.is_some(),
            balls: output.balls,
            events: output.events,
            spectrum: output.spectrum,
            figures: output.figures,
        };
        let kept = model.rotor.shaft.freedoms.count();
        let mut report = RunReport::open(&job.folder, outputs, title, echo.clone(), kept)?;
        let mut progress = Progress::new(title);
        let mut monitor = Monitor {
            stop: &STOP,
            progress: &mut |part| progress.show(part),
        };
        let run = simulate(model, &mut report, &mut monitor).map_err(|error| match error {
            SimulateError::Integrate(error @ IntegrateError::Interrupted { .. }) => {
                Failure::Interrupted(error)
            }
            other => other.into(),
        })?;
        for warning in &run.warnings {
            stream::tell(&format!("warning: {}: {warning}\n", job.name));
        }
        let files = report.finish(model, &run)?;
        Ok(Done {
            run,
            files,
            seconds: started.elapsed().as_secs_f64(),
        })
    }
}

/// A run whose files are written.
struct Done {
    run: Run,
    files: Vec<PathBuf>,
    seconds: f64,
}

impl Done {
    fn print(&self, motion: &Motion) -> io::Result<()> {
        let title = &motion.job.scenario.title;
        let text = report::text(title, &motion.model, &self.run, &self.files);
        stream::print(&text)?;
        stream::tell(&format!("done in {:.3} s\n", self.seconds));
        Ok(())
    }

    fn json(&self, motion: &Motion) -> Value {
        let Scenario { title, echo, .. } = &motion.job.scenario;
        let mut summary = report::summary(title, echo, &motion.model, &self.run);
        let files = self.files.iter().map(|file| file.display().to_string());
        if let Value::Object(entries) = &mut summary {
            entries.insert("wall_time_s".to_owned(), self.seconds.into());
            entries.insert("files".to_owned(), files.collect());
        }
        summary
    }
}
