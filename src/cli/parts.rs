//! A run in parts: what is asked for on the command line.

use super::jobs::Job;
use crate::report::{
    ReportError, RestartError, RestartReader, RestartWriter, RunIdentity, RunReport, restart_path,
};
use crate::scenario;
use crate::simulate::Model;

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
