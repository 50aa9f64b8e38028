//! `jeffcott run`.

use std::collections::HashMap;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use serde_json::Value;

use super::progress::Progress;
use super::{Outcome, stream};
use crate::integrate::IntegrateError;
use crate::report::{self, Outputs, RunReport};
use crate::scenario::{self, Scenario};
use crate::simulate::{Monitor, Run, SimulateError, simulate};

/// Runs scenarios and writes their traces, spectra and figures.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Example:\n  jeffcott run scenarios/steady-7205c.toml\n\n\
                  Each file writes to DIR/<its name without ending>/: trace.csv, spectrum.csv,\n\
                  trace.svg, spectrum.svg and, last, summary.json.\n\n\
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
    let Some(jobs) = jobs(arguments) else {
        return Ok(Outcome::WrongInput);
    };
    // Without a handler an interrupt ends the process at once; the run folder stays safe as well.
    let _ = ctrlc::set_handler(|| STOP.store(true, Ordering::Relaxed));
    let mut outcome = Outcome::Done;
    let mut summaries = Vec::new();
    for job in &jobs {
        if STOP.load(Ordering::Relaxed) {
            break;
        }
        match job.run() {
            Ok(done) if arguments.json => summaries.push(done.json(&job.scenario)),
            Ok(done) => done.print(&job.scenario)?,
            Err(failure) => {
                stream::tell(&format!("error: {}: {failure}\n", job.name));
                outcome = Outcome::Failed;
            }
        }
    }
    if arguments.json {
        let document = match (jobs.len(), summaries.pop()) {
            (1, Some(summary)) => summary,
            (_, last) => summaries.into_iter().chain(last).collect(),
        };
        stream::print(&format!("{document:#}\n"))?;
    }
    Ok(outcome)
}

/// A checked scenario and where its results go.
struct Job {
    name: String,
    scenario: Scenario,
    folder: PathBuf,
}

/// One job a file; `None` where a file is wrong, after telling all that is wrong with all of them.
fn jobs(arguments: &Arguments) -> Option<Vec<Job>> {
    let mut jobs = Vec::new();
    let mut folders: HashMap<PathBuf, &Path> = HashMap::new();
    let mut complete = true;
    for file in &arguments.files {
        let name = file.display().to_string();
        let scenario = match scenario::load(file) {
            Ok(scenario) => scenario,
            Err(error) => {
                stream::tell(&error.render(stream::color()));
                complete = false;
                continue;
            }
        };
        let folder = arguments.out.join(file.file_stem().unwrap_or_default());
        if let Some(other) = folders.insert(folder.clone(), file) {
            stream::tell(&format!(
                "error: {name} and {} would both write to {}; rename one or run them apart\n",
                other.display(),
                folder.display()
            ));
            complete = false;
        }
        for warning in &scenario.warnings {
            stream::tell(&format!("warning: {name}: {warning}\n"));
        }
        jobs.push(Job {
            name,
            scenario,
            folder,
        });
    }
    complete.then_some(jobs)
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

impl Job {
    fn run(&self) -> Result<Done, Failure> {
        let started = Instant::now();
        let Scenario {
            title,
            model,
            output,
            echo,
            ..
        } = &self.scenario;
        let outputs = Outputs {
            trace: output.trace,
            spectrum: output.spectrum,
            figures: output.figures,
        };
        let kept = model.rotor.shaft.freedoms.count();
        let mut report = RunReport::open(&self.folder, outputs, title, echo.clone(), kept)?;
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
            stream::tell(&format!("warning: {}: {warning}\n", self.name));
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
    fn print(&self, scenario: &Scenario) -> io::Result<()> {
        let text = report::text(&scenario.title, &scenario.model, &self.run, &self.files);
        stream::print(&text)?;
        stream::tell(&format!("done in {:.3} s\n", self.seconds));
        Ok(())
    }

    fn json(&self, scenario: &Scenario) -> Value {
        let Scenario {
            title, model, echo, ..
        } = scenario;
        let mut summary = report::summary(title, echo, model, &self.run);
        let files = self.files.iter().map(|file| file.display().to_string());
        if let Value::Object(entries) = &mut summary {
            entries.insert("wall_time_s".to_owned(), self.seconds.into());
            entries.insert("files".to_owned(), files.collect());
        }
        summary
    }
}
