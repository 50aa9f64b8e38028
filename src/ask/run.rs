//! How the shaft of a scenario moves.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use super::{AskError, RunFindings, motion};
use crate::integrate::{IntegrateError, Progress};
use crate::report::{KeptFiles, RunReport, WrittenFindings};
use crate::scenario::Scenario;
use crate::simulate::{Model, Monitor, SimulateError, simulate_watched};

/// How the shaft of a scenario moves.
#[derive(Debug, Clone, Copy)]
pub struct RunQuestion<'a> {
    scenario: &'a Scenario,
    /// What runs.
    pub model: &'a Model,
}

/// Why a run has no files of a whole run.
#[derive(Debug, thiserror::Error)]
enum RunFailure {
    #[error("{0}; nothing was written")]
    Interrupted(IntegrateError),
    #[error("{error}\n  {kept}")]
    CannotGoOn {
        error: IntegrateError,
        kept: KeptFiles,
    },
}

impl<'a> RunQuestion<'a> {
    /// Asks about the motion of a scenario.
    ///
    /// # Errors
    /// [`AskError::Asked`] where nothing moves.
    pub fn new(scenario: &'a Scenario) -> Result<Self, AskError> {
        let model = motion(scenario)?;
        Ok(Self { scenario, model })
    }

    /// Runs and keeps all samples in memory.
    ///
    /// # Errors
    /// [`AskError::Failed`] where the run fails.
    pub fn answer(&self, monitor: &mut Monitor<'_>) -> Result<RunFindings, AskError> {
        let (scenario, model) = (self.scenario.clone(), self.model.clone());
        RunFindings::new(scenario, model, monitor).map_err(AskError::Failed)
    }

    /// Runs and writes the files into a folder while the run goes on, until its end or `stop` is set; tells the progress of
    /// the run, of the pass that measures its error, and of that with more modes of a shaft that bends. What is known of a run
    /// that cannot go on is written, too.
    ///
    /// # Errors
    /// [`AskError::Failed`] where the run fails, or a file cannot be written.
    pub fn write(
        &self,
        folder: &Path,
        stop: &AtomicBool,
        progress: &[Progress; 3],
    ) -> Result<WrittenFindings, AskError> {
        let Self { scenario, model } = *self;
        let mut report = RunReport::new(scenario, model, folder).map_err(AskError::failed)?;
        let mut monitor = Monitor {
            stop,
            progress: &mut |_| {},
        };
        let watched = progress.each_ref().map(Some);
        match simulate_watched(model, &mut report, &mut monitor, watched) {
            Ok(run) => report.finish(model, run).map_err(AskError::failed),
            Err(SimulateError::Integrate(error @ IntegrateError::Interrupted { .. })) => {
                Err(AskError::failed(RunFailure::Interrupted(error)))
            }
            Err(SimulateError::Integrate(error)) => {
                let [(_, counters), ..] = progress.each_ref().map(Progress::latest);
                let kept = report.fail(&error, counters).map_err(AskError::failed)?;
                Err(AskError::failed(RunFailure::CannotGoOn { error, kept }))
            }
            Err(other) => Err(AskError::failed(other)),
        }
    }
}
