//! From the text of a scenario to its run, for programs.

use super::{Format, Scenario, ScenarioError, parse};
use crate::simulate::{RecordedRun, SimulateError};

/// Why a scenario cannot be simulated.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ScenarioRunError {
    /// It asks nothing but where the shaft stands.
    #[error("the scenario has no [time], so that nothing moves: add one, with a duration")]
    NoTime,
    /// The run failed.
    #[error(transparent)]
    Simulate(#[from] SimulateError),
}

impl Scenario {
    /// Reads and checks the text of a scenario in TOML; as [`parse`].
    ///
    /// # Errors
    /// [`ScenarioError`] with everything that is wrong.
    pub fn from_toml(text: &str) -> Result<Self, ScenarioError> {
        parse(text, "scenario.toml", Format::Toml)
    }

    /// Runs it and keeps all samples in memory; writes no file.
    ///
    /// # Errors
    /// [`ScenarioRunError`].
    pub fn simulate(&self) -> Result<RecordedRun, ScenarioRunError> {
        let model = self.model.as_ref().ok_or(ScenarioRunError::NoTime)?;
        Ok(RecordedRun::of(model)?)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHAFT: &str = "[shaft]\nmass = \"5 kg\"\nfreedoms = \"translational\"\n\
        [speed]\nconstant = \"500 rad/s\"\n[[bearing]]\ncatalogue = \"7205C\"\n\
        [[load]]\nconstant = { z = \"1000 N\" }\n[damping]\nratio = 0.02\n";

    #[test]
    fn a_run_gives_its_columns_and_its_error() {
        let text = format!("{SHAFT}[time]\nduration = \"0.02 s\"\n");
        let scenario = Scenario::from_toml(&text).expect("a scenario");
        let recorded = scenario.simulate().expect("a run");
        let [time, x, acceleration] = ["t", "x", "x_acceleration"].map(|name| {
            let column = recorded.column(name);
            column.expect("a column")
        });
        assert_eq!(time.len() as u64, recorded.run.samples);
        assert_eq!([x.len(), acceleration.len()], [time.len(); 2]);
        assert!(x.iter().chain(&acceleration).all(|value| value.is_finite()));
        assert!(recorded.error().is_some());
        let unknown = recorded.column("bump").expect_err("no such column");
        assert!(
            unknown
                .to_string()
                .contains("`bump`; the columns are t, angle")
        );
    }

    #[test]
    fn a_scenario_without_time_has_no_run() {
        let scenario = Scenario::from_toml(SHAFT).expect("a scenario");
        let refused = scenario.simulate().expect_err("no run");
        assert!(matches!(refused, ScenarioRunError::NoTime));
    }
}
