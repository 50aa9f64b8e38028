//! What a scenario asks.

use std::path::PathBuf;

use crate::bearing::Oil;
use crate::quasi_static::StaticQuestion;
use crate::scenario::Issue;
use crate::simulate::Model;
use crate::study::ContactChoice as ChosenContact;

/// What a scenario asks.
pub struct Questions {
    /// The static equilibrium of the shaft.
    pub question: StaticQuestion,
    /// How it moves, where `[time]` is given.
    pub model: Option<Model>,
    /// The law of the contacts, where it was to be chosen.
    pub contact_choice: Option<ChosenContact>,
    /// Oil of each bearing.
    pub oils: Vec<Option<Oil>>,
    /// Records that are laid over the run.
    pub measured: Vec<PathBuf>,
}

impl Questions {
    /// Adds the warnings of the scenario, which all answers repeat.
    pub fn with_warnings(mut self, warnings: &[String]) -> Self {
        let model = self.model.as_mut().map(|model| &mut model.rotor);
        for rotor in std::iter::once(&mut self.question.rotor).chain(model) {
            rotor.warnings = warnings.to_vec();
        }
        self
    }

    /// The motion, which a scenario may leave out.
    pub fn motion(self) -> Result<Model, Issue> {
        let missing = || Issue::new("time", "the scenario has no `[time]`");
        self.model.ok_or_else(missing)
    }
}
