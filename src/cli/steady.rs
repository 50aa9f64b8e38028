//! `jeffcott steady`.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use serde_json::Value;

use super::jobs::{Job, Shown, jobs, show, with_files};
use super::progress::Progress;
use super::{Outcome, stream};
use crate::report;
use crate::scenario::{Varied, VariedError};
use crate::simulate::Model;
use crate::steady::{ResponseQuestion, SteadyError, SteadyQuestion, response, steady};
use crate::study::Variable;

/// Finds the motion that the shaft settles to, without waiting for it, and whether it is stable.
///
/// The motion that repeats with the forcing is found by Newton's method from the state at rest. Where it
/// is not stable, a stable one of several periods is looked for beside it. Unbalance and passing balls
/// that have no common period make a motion of two frequencies. With --over, the motion is followed along
/// a number of the scenario, past turning points and doublings of its period.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  jeffcott steady scenarios/steady-7205c.toml\n  \
                  jeffcott steady scenarios/varying-compliance-6306.toml --over speed.constant \\\n    \
                  --from \"100 rad/s\" --to \"200 rad/s\"\n\n\
                  Each file writes to DIR/<its name without ending>/: steady_trace.csv,\n\
                  steady_spectrum.csv, steady_trace.svg, steady_spectrum.svg and, last, steady.json; with\n\
                  --over response.csv, response_specials.csv, response.svg and, last, response.json.\n\n\
                  Exit code: 0 all motions are found, 1 a scene has none, none was found or the search\n\
                  was interrupted, 2 a file or the command line is wrong."
)]
pub struct Arguments {
    /// Scenario files, .toml or .json
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Folder that the folders of the answers are written to
    #[arg(long, value_name = "DIR", default_value = "output")]
    out: PathBuf,
    /// Print the answers as JSON: an object, or an array for several files
    #[arg(long)]
    json: bool,
    /// Leave out the second search, which measures the error, whatever `[integrator] verify` says
    #[arg(long)]
    no_verify: bool,
    /// How many periods of the forcing the motion takes. Default: one, or those of a stable motion beside
    /// it
    #[arg(long, value_name = "M", value_parser = clap::value_parser!(u32).range(1..=64))]
    period: Option<u32>,
    /// Number of the scenario to follow the motion along, as "speed.constant" or "load[0].constant.z"
    #[arg(long, value_name = "KEY", requires_all = ["from", "to"])]
    over: Option<String>,
    /// Its first value, as it is written in a scenario
    #[arg(
        long,
        value_name = "VALUE",
        requires = "over",
        allow_hyphen_values = true
    )]
    from: Option<String>,
    /// Its last value
    #[arg(
        long,
        value_name = "VALUE",
        requires = "over",
        allow_hyphen_values = true
    )]
    to: Option<String>,
    /// Most motions of a branch
    #[arg(long, value_name = "N", requires = "over", default_value_t = 2000)]
    points: usize,
    /// Leave out the motions of doubled period
    #[arg(long, requires = "over")]
    no_doubled: bool,
}

/// Set by Ctrl-C and by a request to terminate.
static STOP: AtomicBool = AtomicBool::new(false);

/// Checks all files, then finds their motions in turn.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let jobs = jobs(&arguments.files, &arguments.out);
    let Some(tasks) = jobs.and_then(|jobs| tasks(jobs, arguments)) else {
        return Ok(Outcome::WrongInput);
    };
    // Without a handler an interrupt ends the process at once; the run folder stays safe as well.
    let _ = ctrlc::set_handler(|| STOP.store(true, Ordering::Relaxed));
    let answers = tasks
        .iter()
        .map(|task| (task.job.name.as_str(), task.answer(arguments)));
    show(arguments.json, answers)
}

/// A checked scenario, its motion, and what to follow it along.
struct Task {
    job: Job,
    model: Model,
    stretch: Option<Stretch>,
}

/// A number of the scenario and its first and last value.
struct Stretch {
    varied: Varied,
    variable: Variable,
    ends: [f64; 2],
}

/// The tasks of all jobs; `None` where one is wrong, after telling of all of them.
fn tasks(jobs: Vec<Job>, arguments: &Arguments) -> Option<Vec<Task>> {
    let task = |mut job: Job| {
        let found = take_model(&mut job, arguments).and_then(|model| {
            let stretch = stretch(&job, arguments).transpose();
            Ok((model, stretch?))
        });
        match found {
            Ok((model, stretch)) => Some(Task {
                job,
                model,
                stretch,
            }),
            Err(message) => {
                stream::tell(&format!("error: {}: {message}\n", job.name));
                None
            }
        }
    };
    let tasks: Vec<_> = jobs.into_iter().map(task).collect();
    tasks.into_iter().collect()
}

fn take_model(job: &mut Job, arguments: &Arguments) -> Result<Model, String> {
    let model = job.scenario.model.clone();
    let mut model = model.ok_or("`steady` needs a table `[time]`, as `run` does")?;
    if arguments.no_verify {
        model.verify = false;
        // the summary tells what was asked
        job.scenario.echo["integrator"]["verify"] = false.into();
    }
    Ok(model)
}

fn stretch(job: &Job, arguments: &Arguments) -> Option<Result<Stretch, String>> {
    let Arguments { over, from, to, .. } = arguments;
    let ((over, from), to) = over.as_ref().zip(from.as_ref()).zip(to.as_ref())?;
    let folder = Path::new(&job.name).parent().unwrap_or(Path::new(""));
    let read = || -> Result<Stretch, VariedError> {
        let varied = Varied::new(&job.scenario, over, folder)?;
        let ((first, variable), (last, _)) = (varied.value(from)?, varied.value(to)?);
        Ok(Stretch {
            varied,
            variable,
            ends: [first, last],
        })
    };
    let checked = read().map_err(|error| error.to_string());
    Some(checked.and_then(|stretch| stretch.checked()))
}

impl Stretch {
    /// The same, where the scenario exists at both ends and they differ.
    fn checked(self) -> Result<Self, String> {
        let [first, last] = self.ends;
        if first == last {
            return Err("--from and --to are the same value".to_owned());
        }
        self.varied.rotor(first)?;
        self.varied.rotor(last)?;
        Ok(self)
    }
}

/// Why a task failed, in words.
#[derive(Debug, thiserror::Error)]
enum Failure {
    #[error(transparent)]
    Steady(#[from] SteadyError),
    #[error(transparent)]
    Report(#[from] report::ReportError),
}

impl Task {
    fn answer(&self, arguments: &Arguments) -> Result<Shown, Failure> {
        let started = Instant::now();
        let (mut json, text, files) = match &self.stretch {
            Some(stretch) => self.response(stretch, arguments)?,
            None => self.steady(arguments)?,
        };
        if !arguments.json {
            let seconds = started.elapsed().as_secs_f64();
            stream::tell(&format!("done in {seconds:.3} s\n"));
            return Ok(Shown::Text(text));
        }
        json["wall_time_s"] = started.elapsed().as_secs_f64().into();
        Ok(Shown::Json(with_files(json, &files)))
    }

    fn steady(&self, arguments: &Arguments) -> Result<(Value, String, Vec<PathBuf>), Failure> {
        let (title, echo) = (&self.job.scenario.title, &self.job.scenario.echo);
        let found = steady(&SteadyQuestion {
            model: &self.model,
            multiple: arguments.period,
            stop: &STOP,
        })?;
        for warning in &found.warnings {
            stream::tell(&format!("warning: {}: {warning}\n", self.job.name));
        }
        let files = report::write_steady(&self.job.folder, title, echo, &self.model, &found)?;
        let json = report::steady_json(title, echo, &self.model, &found);
        let text = report::steady_text(title, &self.model, &found, &files);
        Ok((json, text, files))
    }

    fn response(
        &self,
        stretch: &Stretch,
        arguments: &Arguments,
    ) -> Result<(Value, String, Vec<PathBuf>), Failure> {
        let (title, echo) = (&self.job.scenario.title, &self.job.scenario.echo);
        let mut progress = Progress::new(title);
        let question = ResponseQuestion {
            model: &self.model,
            family: &|value| stretch.varied.rotor(value),
            stretch: stretch.ends,
            multiple: arguments.period.unwrap_or(1),
            points: arguments.points,
            doubled: !arguments.no_doubled,
            stop: &STOP,
        };
        let branches = response(&question, &mut |part| progress.show(part))?;
        drop(progress);
        for branch in branches.iter().filter(|branch| branch.lost) {
            stream::tell(&format!("warning: {}: {}\n", self.job.name, branch.end));
        }
        let variable = &stretch.variable;
        let files = report::write_response(&self.job.folder, title, echo, variable, &branches)?;
        let json = report::response_json(title, echo, variable, &branches);
        let text = report::response_text(title, variable, &branches, &files);
        Ok((json, text, files))
    }
}
