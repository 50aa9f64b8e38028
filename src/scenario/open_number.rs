//! A scenario with one number left open.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::key::{Key, find, number_keys};
use super::{Issue, Scenario, questions_at, without};
use crate::rotor::RotorDefinition;
use crate::study::Variable;

/// Tables whose numbers a motion that repeats does not depend on.
const LEFT_OUT: [&str; 6] = ["static", "initial", "time", "integrator", "output", "study"];

/// A checked scenario with one number left open.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenNumber {
    base: Value,
    folder: PathBuf,
    key: Key,
}

impl OpenNumber {
    /// The scenario with the number at a path open, for instance `speed.constant`; the files that it
    /// names stand in `folder`.
    ///
    /// # Errors
    /// [`Issue`] where there is no such number, where it is a whole number, and where the law of the
    /// contacts may change with it.
    pub fn new(scenario: &Scenario, path: &str, folder: &Path) -> Result<Self, Issue> {
        let known = number_keys(&scenario.echo, &LEFT_OUT);
        let key = find(&known, path, path).map_err(|issue| Issue {
            message: format!("{} that its motion depends on", issue.message),
            ..issue
        })?;
        let refused = |message| Err(Issue::new(path, message));
        if key.is_whole() {
            return refused(format!(
                "`{path}` is a whole number: it does not change little by little"
            ));
        }
        if scenario.contact_choice.is_some() {
            return refused(format!(
                "contact = \"auto\" may choose another law at another value of `{path}`: set the law \
                 that it chose here"
            ));
        }
        Ok(Self {
            base: without(&scenario.echo, &["study", "output"]),
            folder: folder.to_owned(),
            key: key.clone(),
        })
    }

    /// A value as it is written in a scenario, in SI units, and the number that varies, shown in the unit
    /// that it was written in.
    ///
    /// # Errors
    /// [`Issue`] where the text is none.
    pub fn value(&self, text: &str) -> Result<(f64, Variable), Issue> {
        let path = &self.key.path;
        let value = self.key.typed(text, path).map_err(|issue| Issue {
            message: format!("`{text}` is no value of `{path}`: {}", issue.message),
            ..issue
        })?;
        Ok((self.key.si(&value), self.key.variable(&value)))
    }

    /// The rotor at a value in SI units.
    ///
    /// # Errors
    /// [`Issue`] with what is wrong with it there.
    pub fn rotor(&self, si: f64) -> Result<RotorDefinition, Issue> {
        let questions = questions_at(&self.base, &self.key, si, &self.folder)?;
        Ok(questions.motion()?.rotor)
    }
}
