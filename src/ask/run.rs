//! How the shaft of a scenario moves.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use super::{AskError, RunFindings, Sensitivity, motion};
use crate::analysis::Kind;
use crate::fit::Question;
use crate::integrate::{IntegrateError, Progress};
use crate::report::{KeptFiles, RunReport, SensitivityTable, WrittenFindings};
use crate::scenario::Scenario;
use crate::simulate::{Model, Monitor, Run, SimulateError, simulate_watched};

/// How the shaft of a scenario moves.
#[derive(Debug, Clone)]
pub struct RunQuestion<'a> {
    scenario: &'a Scenario,
    /// What runs.
    pub model: &'a Model,
    /// By what the numbers of the run are differentiated.
    pub sensitivity: Option<Sensitivity>,
}

/// Why the numbers of a run are not differentiated.
#[derive(Debug, Clone, Copy, thiserror::Error)]
enum NoSlopes {
    #[error(
        "no sensitivities: the motion has not settled, so that its numbers depend on where the run ends; make `settle` and \
         `duration` longer"
    )]
    NotSettled,
    #[error(
        "no sensitivities: the motion is irregular, and neighbouring ones part from it; those of `bearing` and `campbell` are known"
    )]
    Irregular,
    #[error(
        "no sensitivities: whether the motion settles is not known; they need a speed that is constant after `settle`, and \
         no motion = false in [output]"
    )]
    Unknown,
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

/// Highest order of the shaft whose named lines are differentiated.
const HIGHEST_ORDER: f64 = 40.0;

/// Refuses a motion whose numbers are not those that it settles to.
fn check_settled(run: &Run) -> Result<(), NoSlopes> {
    let motion = run.motion.as_ref().ok_or(NoSlopes::Unknown)?;
    match (motion.has_settled(), &motion.recognition.kind) {
        (Some(false), _) => Err(NoSlopes::NotSettled),
        (_, Kind::Irregular { .. }) => Err(NoSlopes::Irregular),
        _ => Ok(()),
    }
}

impl<'a> RunQuestion<'a> {
    /// Asks about the motion of a scenario.
    ///
    /// # Errors
    /// [`AskError::Asked`] where nothing moves.
    pub fn new(scenario: &'a Scenario) -> Result<Self, AskError> {
        let model = motion(scenario)?;
        Ok(Self {
            scenario,
            model,
            sensitivity: None,
        })
    }

    /// Runs and keeps all samples in memory.
    ///
    /// # Errors
    /// [`AskError::Failed`] where the run fails.
    pub fn answer(&self, monitor: &mut Monitor<'_>) -> Result<RunFindings, AskError> {
        let (scenario, model) = (self.scenario.clone(), self.model.clone());
        let mut found = RunFindings::new(scenario, model, monitor).map_err(AskError::Failed)?;
        if let Some(asked) = &self.sensitivity {
            check_settled(&found.recorded.run).map_err(AskError::failed)?;
            found.sensitivity = Some(self.slopes(asked, monitor.stop)?);
        }
        Ok(found)
    }

    /// How fast the numbers of the run change.
    fn slopes(&self, asked: &Sensitivity, stop: &AtomicBool) -> Result<SensitivityTable, AskError> {
        let question = |_, model: Option<Model>| {
            // sampled and analysed as the run itself
            let model = Model {
                sampling: self.model.sampling,
                spectrum: self.model.spectrum,
                analyses: self.model.analyses,
                ..model.unwrap_or_else(|| self.model.clone())
            };
            let columns = Sensitivity::columns_of_run(&model.rotor);
            Question::Run(model, columns, Some(HIGHEST_ORDER))
        };
        asked.answer(question, stop)
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
        let Self {
            scenario, model, ..
        } = *self;
        let mut report = RunReport::new(scenario, model, folder).map_err(AskError::failed)?;
        let mut monitor = Monitor {
            stop,
            progress: &mut |_| {},
        };
        let watched = progress.each_ref().map(Some);
        match simulate_watched(model, &mut report, &mut monitor, watched) {
            Ok(mut run) => {
                let mut is_refused = false;
                if let Some(asked) = &self.sensitivity {
                    match check_settled(&run) {
                        Ok(()) => report.sensitivity = Some(self.slopes(asked, stop)?),
                        Err(why) => {
                            run.warnings.push(why.to_string());
                            is_refused = true;
                        }
                    }
                }
                let mut written = report.finish(model, run).map_err(AskError::failed)?;
                written.incomplete |= is_refused;
                Ok(written)
            }
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
