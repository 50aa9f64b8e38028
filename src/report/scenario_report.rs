//! Which files the run of a scenario writes.

use std::path::Path;

use super::{Outputs, ReportError, RunReport};
use crate::scenario::Scenario;
use crate::simulate::Model;

impl RunReport {
    /// Opens `folder` for the run of a scenario's model, with the files that its `[output]` asks for.
    ///
    /// ```no_run
    /// use std::sync::atomic::AtomicBool;
    /// use jeffcott::report::RunReport;
    /// use jeffcott::simulate::{Monitor, simulate};
    ///
    /// let scenario = jeffcott::scenario::load("scenarios/steady-7205c.toml".as_ref())?;
    /// let model = scenario.model.as_ref().ok_or("nothing moves")?;
    /// let mut report = RunReport::of(&scenario, model, "output/steady".as_ref())?;
    /// let stop = AtomicBool::new(false);
    /// let mut monitor = Monitor { stop: &stop, progress: &mut |_part| {} };
    /// let run = simulate(model, &mut report, &mut monitor)?;
    /// let files = report.finish(model, &run)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ReportError::File`] where folder or trace cannot be created.
    pub fn of(scenario: &Scenario, model: &Model, folder: &Path) -> Result<Self, ReportError> {
        let Scenario {
            title,
            output,
            echo,
            contact_choice,
            ..
        } = scenario;
        let outputs = Outputs {
            trace: output.trace,
            energy: model.energy || model.rotor.drive.is_some(),
            drive: model.rotor.drive.is_some(),
            balls: output.balls,
            events: output.events,
            spectrum: output.spectrum,
            figures: output.figures,
            page: output.report,
            formats: output.formats.clone(),
            every: output.every,
            channels: output.channels.clone(),
        };
        let kept = model.rotor.shaft.freedoms.count();
        let report = Self::open(folder, outputs, title, echo.clone(), kept)?;
        Ok(report.with_choice(contact_choice.as_ref()))
    }
}
