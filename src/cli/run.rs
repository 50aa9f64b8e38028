//! `jeffcott run`.

use std::io;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use serde_json::Value;

use super::ending::{Failed, Interrupted, Kept, Stopped};
use super::jobs::{Job, document, jobs};
use super::parts::Parts;
use super::progress::Progress;
use super::written::Written;
use super::{Outcome, stream};
use crate::integrate::{Counters, IntegrateError};
use crate::report::{self, Failure as Cause, Outputs, RestartReader, RestartWriter, RunReport};
use crate::scenario::Scenario;
use crate::simulate::{
    Earlier, Model, Monitor, Part, Run, SimulateError, Standing, StateKeeper, simulate_part,
};
use crate::study::campbell::{Campbell, CampbellError, CampbellQuestion};

/// Runs scenarios and writes their traces, spectra and figures.
#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  jeffcott run scenarios/steady-7205c.toml\n  \
                  jeffcott run scenarios/steady-7205c.toml --format csv,mat --every 4 --channels \
                  x,y,force_x\n\n\
                  Each file writes to DIR/<its name without ending>/: trace.csv, events.csv,\n\
                  spectrum.csv, peaks.csv, trace.svg, spectrum.svg, report.html and, last, summary.json;\n\
                  poincare.csv and orbit.svg at constant speed; waterfall, order_tracks and campbell\n\
                  (.csv and .svg) where the speed changes; trace_balls.csv and energy.csv where the\n\
                  scenario asks for them, spectrum_NAME.csv for each of its `[[spectrum]]`,\n\
                  drive.csv where there is a drive. A run\n\
                  that cannot go on leaves trace.until-failure.csv and failure.json instead.\n\
                  With --format the tables have other formats.\n\n\
                  Exit code: 0 all runs are done, or stopped as asked, 1 a run failed or was\n\
                  interrupted, 2 a file is wrong."
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
    /// Leave out the second pass, which measures the error, whatever `[integrator] verify` says
    #[arg(long)]
    no_verify: bool,
    #[command(flatten)]
    written: Written,
    #[command(flatten)]
    parts: Parts,
}

impl Arguments {
    /// What goes on with a stopped run.
    fn resume_command(&self, job: &Job) -> String {
        let out = match self.out.to_str() {
            Some("output") => String::new(),
            _ => format!(" --out {}", self.out.display()),
        };
        let verify = if self.no_verify { " --no-verify" } else { "" };
        let written = &self.written;
        format!("jeffcott run {}{out}{verify}{written} --resume", job.name)
    }
}

/// Speeds of the diagram of a run-up.
const CAMPBELL_SPEEDS: usize = 61;

/// Set by Ctrl-C and by a request to terminate.
static STOP: AtomicBool = AtomicBool::new(false);

/// Checks all files, then runs them in turn.
pub fn run(arguments: &Arguments) -> io::Result<Outcome> {
    let jobs = jobs(&arguments.files, &arguments.out);
    let Some(mut motions) = jobs.and_then(|jobs| motions(jobs, arguments)) else {
        return Ok(Outcome::WrongInput);
    };
    // Without a handler an interrupt ends the process at once; the run folder stays safe as well.
    let _ = ctrlc::set_handler(|| STOP.store(true, Ordering::Relaxed));
    let mut outcome = Outcome::Done;
    let mut summaries = Vec::new();
    for motion in &mut motions {
        if STOP.load(Ordering::Relaxed) {
            stream::tell(&format!(
                "error: {}: interrupted before it began\n",
                motion.job.name
            ));
            outcome = Outcome::Failed;
            continue;
        }
        match motion.run(arguments) {
            Ok(Ending::Done(done)) if arguments.json => summaries.push(done.json(motion)),
            Ok(Ending::Done(done)) => done.print(motion)?,
            Ok(Ending::Stopped(stopped)) if arguments.json => {
                summaries.push(stopped.json(&motion.job));
            }
            Ok(Ending::Stopped(stopped)) => stopped.print(&motion.job)?,
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

/// A checked scenario, its motion, where its results go, and where it goes on from.
struct Motion {
    job: Job,
    model: Model,
    restart: Option<RestartReader>,
}

/// The motions of all jobs; `None` where a scenario has none, or no restart file where one is to be,
/// after telling of all of them.
fn motions(jobs: Vec<Job>, arguments: &Arguments) -> Option<Vec<Motion>> {
    let motion = |mut job: Job| {
        let Some(mut model) = job.scenario.model.take() else {
            stream::tell(&format!(
                "error: {}: `run` needs a table `[time]`; `jeffcott bearing` does without\n",
                job.name
            ));
            return None;
        };
        if arguments.no_verify {
            model.verify = false;
            // the summary tells what was run
            job.scenario.echo["integrator"]["verify"] = false.into();
        }
        arguments.written.apply(&mut job.scenario);
        match arguments.parts.restart(&job, &model) {
            Ok(restart) => Some(Motion {
                job,
                model,
                restart,
            }),
            Err(error) => {
                stream::tell(&format!("error: {}: {error}\n", job.name));
                None
            }
        }
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
    #[error(transparent)]
    Failed(#[from] Failed),
    #[error(transparent)]
    Interrupted(#[from] Box<Interrupted>),
}

/// How a job ended that did not fail.
enum Ending {
    Done(Box<Done>),
    Stopped(Stopped),
}

impl Motion {
    fn run(&mut self, arguments: &Arguments) -> Result<Ending, Failure> {
        let started = Instant::now();
        let mut report = self.open_report()?;
        let (parts, resumed) = (&arguments.parts, self.restart.is_some());
        let mut keeper = parts.keeper(&report, &self.job, &self.model)?;
        let mut part = Part {
            earlier: self.restart.as_mut().map(|restart| Earlier {
                standing: restart.standing().clone(),
                states: restart,
            }),
            stop_at: parts.stop_at(),
            keeper: keeper.as_mut().map(|keeper| keeper as &mut dyn StateKeeper),
            ..Part::default()
        };
        let mut progress = Progress::new(&self.job.scenario.title);
        let mut monitor = Monitor {
            stop: &STOP,
            progress: &mut |part| progress.show(part),
        };
        let result = simulate_part(&self.model, &mut report, &mut monitor, &mut part);
        drop(progress);
        let (standing, counters) = (part.standing, part.counters);
        let resume = || arguments.resume_command(&self.job);
        match result {
            Ok(run) => Ok(Ending::Done(Box::new(self.finish(report, run, started)?))),
            Err(SimulateError::Stopped { time }) => Ok(Ending::Stopped(Stopped {
                time,
                restart: kept(keeper, standing)?,
                resume: resume(),
            })),
            Err(SimulateError::Integrate(error @ IntegrateError::Interrupted { .. })) => {
                let restart = kept(keeper, standing)?;
                Err(Box::new(Interrupted::new(error, restart, resumed, resume())).into())
            }
            Err(SimulateError::Integrate(error)) => Err(failed(report, error, counters)?.into()),
            Err(other) => Err(other.into()),
        }
    }

    fn open_report(&self) -> Result<RunReport, report::ReportError> {
        let Scenario {
            title,
            output,
            echo,
            ..
        } = &self.job.scenario;
        let outputs = Outputs {
            trace: output.trace,
            energy: self.model.energy || self.model.rotor.drive.is_some(),
            drive: self.model.rotor.drive.is_some(),
            balls: output.balls,
            events: output.events,
            spectrum: output.spectrum,
            figures: output.figures,
            page: output.report,
            formats: output.formats.clone(),
            every: output.every,
            channels: output.channels.clone(),
        };
        let kept = self.model.rotor.shaft.freedoms.count();
        let report = RunReport::open(&self.job.folder, outputs, title, echo.clone(), kept)?;
        let scenario = &self.job.scenario;
        Ok(report.with_choice(scenario.contact_choice.as_ref()))
    }

    /// Natural frequencies up to the highest speed, where the run is mapped.
    fn campbell(&self, run: &Run) -> Result<Option<Campbell>, CampbellError> {
        let highest = self.model.rotor.highest_speed();
        let Some(maps) = run.maps.as_ref().filter(|_| highest > 0.0) else {
            return Ok(None);
        };
        let orders = maps.tracks.orders.iter();
        let question = CampbellQuestion {
            rotor: self.model.rotor.clone(),
            from: 0.0,
            to: highest,
            count: CAMPBELL_SPEEDS,
            orders: orders.map(|order| order.order).collect(),
        };
        question.solve().map(Some)
    }

    /// The same; where there is no diagram the run tells why.
    fn campbell_or_warning(&self, run: &mut Run) -> Option<Campbell> {
        self.campbell(run).unwrap_or_else(|error| {
            run.warnings.push(format!(
                "there is no diagram of natural frequencies: {error}"
            ));
            None
        })
    }

    fn finish(&self, report: RunReport, mut run: Run, started: Instant) -> Result<Done, Failure> {
        let campbell = self.campbell_or_warning(&mut run);
        for warning in &run.warnings {
            stream::tell(&format!("warning: {}: {warning}\n", self.job.name));
        }
        let files = report
            .with_campbell(campbell.clone())
            .finish(&self.model, &run)?;
        Ok(Done {
            run,
            campbell,
            files,
            seconds: started.elapsed().as_secs_f64(),
        })
    }
}

/// Keeps what there is of a run that cannot go on.
fn failed(
    report: RunReport,
    error: IntegrateError,
    counters: Counters,
) -> Result<Failed, report::ReportError> {
    let cause = Cause {
        error: &error,
        counters,
    };
    let kept = report.fail(&cause)?;
    Ok(Failed { error, kept })
}

/// The restart file of a run that was stopped, and its samples; none where no states were kept.
fn kept(
    keeper: Option<RestartWriter>,
    standing: Option<Standing>,
) -> Result<Option<Kept>, report::ReportError> {
    let Some((keeper, standing)) = keeper.zip(standing) else {
        return Ok(None);
    };
    Ok(Some(Kept {
        samples: standing.main.next,
        time: standing.time,
        path: keeper.finish(&standing)?,
    }))
}

/// A run whose files are written.
struct Done {
    run: Run,
    campbell: Option<Campbell>,
    files: Vec<PathBuf>,
    seconds: f64,
}

impl Done {
    fn print(&self, motion: &Motion) -> io::Result<()> {
        let title = &motion.job.scenario.title;
        let text = report::text(title, &motion.model, &self.run, &self.files);
        stream::print(&text)?;
        if let Some(choice) = &motion.job.scenario.contact_choice {
            stream::print(&report::contact_choice_text(choice))?;
        }
        stream::tell(&format!("done in {:.3} s\n", self.seconds));
        Ok(())
    }

    fn json(&self, motion: &Motion) -> Value {
        let Scenario { title, echo, .. } = &motion.job.scenario;
        let mut summary = report::summary(title, echo, &motion.model, &self.run);
        let files = self.files.iter().map(|file| file.display().to_string());
        if let Some(choice) = &motion.job.scenario.contact_choice {
            summary["contact_choice"] = report::contact_choice_json(choice);
        }
        if let Some(campbell) = &self.campbell {
            summary["critical_speeds"] = report::critical_speeds(campbell);
        }
        if let Value::Object(entries) = &mut summary {
            entries.insert("wall_time_s".to_owned(), self.seconds.into());
            entries.insert("files".to_owned(), files.collect());
        }
        summary
    }
}
