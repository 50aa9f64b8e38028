//! A run in parts: what is asked for on the command line, and what is said and kept where a run ends early.

use std::path::PathBuf;

use serde_json::json;

use super::jobs::{Answer, Job};
use crate::integrate::IntegrateError;
use crate::report::{
    KeptFiles, ReportError, RestartError, RestartReader, RestartWriter, RunIdentity, RunReport,
    restart_path,
};
use crate::scenario;
use crate::simulate::{Model, Standing};

/// Where a run begins and stops.
#[derive(Debug, clap::Args)]
pub struct Parts {
    /// Stop at the first whole block of samples (4096) at or after this time, as in "0.25 s", and
    /// leave restart.bin in the run folder
    #[arg(long, value_name = "TIME", value_parser = scenario::time, allow_hyphen_values = true)]
    stop_at: Option<f64>,
    /// Leave restart.bin in the run folder when Ctrl-C stops the run; it grows with the run
    #[arg(long)]
    restartable: bool,
    /// Go on from restart.bin in the run folder; all files are those of a run in one go. Can be
    /// stopped again
    #[arg(long)]
    resume: bool,
}

impl Parts {
    /// Time at which the run stops, s.
    pub fn stop_at(&self) -> f64 {
        self.stop_at.unwrap_or(f64::INFINITY)
    }

    /// The restart file that a job goes on from.
    ///
    /// # Errors
    /// [`RestartError`] where the job is to go on and cannot.
    pub fn restart(&self, job: &Job, model: &Model) -> Result<Option<RestartReader>, RestartError> {
        let open = || RestartReader::open(&restart_path(&job.folder), &identity(job, model));
        self.resume.then(open).transpose()
    }

    /// What keeps the states of a run that can be stopped.
    ///
    /// # Errors
    /// [`ReportError::File`] where its file cannot be created.
    pub fn keeper(
        &self,
        report: &RunReport,
        job: &Job,
        model: &Model,
    ) -> Result<Option<RestartWriter>, ReportError> {
        let wanted = self.restartable || self.resume || self.stop_at.is_some();
        wanted
            .then(|| report.keep_states(&identity(job, model)))
            .transpose()
    }
}

fn identity<'a>(job: &'a Job, model: &'a Model) -> RunIdentity<'a> {
    RunIdentity {
        scenario: &job.scenario.echo,
        model,
    }
}

/// A restart file that was written.
#[derive(Debug)]
pub struct Kept {
    /// Its path.
    pub path: PathBuf,
    /// Samples up to it.
    pub samples: u64,
    /// Time of the sample after them, s.
    pub time: f64,
}

impl Kept {
    /// The restart file of a run that was stopped; none where no states were kept.
    ///
    /// # Errors
    /// [`ReportError::File`] where it cannot be written.
    pub fn of(
        keeper: Option<RestartWriter>,
        standing: Option<Standing>,
    ) -> Result<Option<Self>, ReportError> {
        let Some((keeper, standing)) = keeper.zip(standing) else {
            return Ok(None);
        };
        Ok(Some(Self {
            samples: standing.main.next,
            time: standing.time,
            path: keeper.finish(&standing)?,
        }))
    }
}

/// A run that was stopped as asked before a `time` in s; `resume` is the command that goes on.
pub fn stopped(title: &str, time: f64, kept: Option<&Kept>, resume: &str) -> Answer {
    let mut text = format!("{title}\n  stopped       at t = {time:.6e} s\n");
    if let Some(Kept { path, samples, .. }) = kept {
        text += &format!("  samples       {samples}\n  wrote {}\n", path.display());
    }
    let json = json!({
        "title": title,
        "stopped_at_s": time,
        "samples": kept.map(|kept| kept.samples),
    });
    let files: Vec<_> = kept.iter().map(|kept| kept.path.clone()).collect();
    Answer {
        told: format!("it goes on with: {resume}\n"),
        ..Answer::new(text, json, &files)
    }
}

/// A run that cannot go on.
pub fn failed(error: &IntegrateError, kept: &KeptFiles) -> String {
    let files = kept.files.iter().map(|file| file.display().to_string());
    let files = files.collect::<Vec<_>>().join(" and ");
    let beside = match kept.beside_earlier {
        true => "; the other results there are those of an earlier run",
        false => "",
    };
    format!("{error}\n  kept {files}{beside}")
}

/// A run that somebody stopped; `resumed` tells whether it went on from a restart file, which still stands.
pub fn interrupted(
    error: &IntegrateError,
    kept: Option<&Kept>,
    resumed: bool,
    resume: &str,
) -> String {
    match kept {
        Some(Kept {
            path,
            samples,
            time,
        }) => format!(
            "{error}\n  kept {}: {samples} samples, up to t = {time:.6e} s\n  it goes on with: {resume}",
            path.display()
        ),
        None if resumed => {
            format!("{error}; the restart file stands as it was\n  it goes on with: {resume}")
        }
        None => {
            format!("{error}; nothing was written (--restartable keeps what it takes to go on)")
        }
    }
}
