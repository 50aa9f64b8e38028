//! The questions of the verbs: a checked scenario and what is asked of it in, findings out.
//!
//! Every question is checked when it is made and answered later, so that whoever asks several is told first what is
//! wrong with any of them. The command and the Python package both rest on this floor: their answers, documents and
//! warnings are the same.

mod accuracy;
mod analyze;
mod bearing;
mod campbell;
mod fit;
mod linear_response;
mod matrices;
mod response;
mod run;
mod sensitivity;
mod steady;
mod study;

use std::error::Error;

use crate::scenario::{Issue, Scenario};
use crate::simulate::Model;

pub use crate::report::WrittenFindings;
pub use crate::report::findings::Findings;
pub use crate::report::run::recorded::RunFindings;
pub use accuracy::AccuracyQuestion;
pub use analyze::{AnalyzeQuestion, record_setting};
pub use bearing::BearingQuestion;
pub use campbell::{CampbellQuestion, Order};
pub use fit::FitQuestion;
pub use linear_response::{COUNTS, LinearRange, LinearResponseQuestion, Place};
pub use matrices::MatricesQuestion;
pub use response::{Followed, ResponseQuestion};
pub use run::RunQuestion;
pub use sensitivity::Sensitivity;
pub use steady::SteadyQuestion;
pub use study::{Asked, Making, StudyQuestion, StudyWatch, merge};

/// Why a question has no answer.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AskError {
    /// What is asked is wrong: a key, a value, or a table that the scenario lacks.
    #[error("{0}")]
    Asked(Issue),
    /// The question is right, but there is no answer.
    #[error(transparent)]
    Failed(Box<dyn Error + Send + Sync>),
}

impl AskError {
    /// Any error of a question that is right.
    pub(crate) fn failed(error: impl Error + Send + Sync + 'static) -> Self {
        Self::Failed(Box::new(error))
    }
}

impl From<Issue> for AskError {
    fn from(issue: Issue) -> Self {
        Self::Asked(issue)
    }
}

/// How the shaft of a scenario moves.
///
/// # Errors
/// [`AskError::Asked`] where it has no `[time]`.
fn motion(scenario: &Scenario) -> Result<&Model, AskError> {
    let missing = || {
        Issue::new("time", "the scenario has no [time], so that nothing moves")
            .help("add one, with a duration; `jeffcott bearing` and `campbell` do without")
    };
    Ok(scenario.model.as_ref().ok_or_else(missing)?)
}
