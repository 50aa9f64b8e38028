//! A scenario with one number left open.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::Scenario;
use super::quantity::parse;
use super::vary::{Key, find, keys, questions, without};
use crate::rotor::RotorDefinition;
use crate::study::Variable;

/// Tables whose numbers a motion that repeats does not depend on.
const LEFT_OUT: [&str; 6] = ["static", "initial", "time", "integrator", "output", "study"];

/// Why a number of a scenario cannot be left open.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum VariedError {
    /// There is no such number.
    #[error(
        "the scenario has no number `{key}` that its motion depends on{}",
        hint(nearest)
    )]
    NoKey {
        /// Path of the key as given.
        key: String,
        /// The nearest one that there is.
        nearest: Option<String>,
    },
    /// It is a whole number.
    #[error("`{key}` is a whole number: it does not change little by little")]
    Whole {
        /// Path of the key.
        key: String,
    },
    /// The law of the contacts changes with it.
    #[error(
        "contact = \"auto\" may choose another law at another value of `{key}`: set the law that it \
         chose here"
    )]
    Auto {
        /// Path of the key.
        key: String,
    },
    /// A text is no value of it.
    #[error("`{text}` is no value of `{key}`: {reason}")]
    Value {
        /// Path of the key.
        key: String,
        /// The text.
        text: String,
        /// What is wrong with it.
        reason: String,
    },
}

fn hint(nearest: &Option<String>) -> String {
    match nearest {
        Some(known) => format!("; did you mean `{known}`?"),
        None => String::new(),
    }
}

/// A checked scenario with one number left open.
#[derive(Debug, Clone, PartialEq)]
pub struct Varied {
    base: Value,
    folder: PathBuf,
    key: Key<'static>,
}

impl Varied {
    /// The scenario with the number at a path open, for instance `speed.constant`; the files that it
    /// names stand in `folder`.
    ///
    /// # Errors
    /// [`VariedError`] where there is no such number.
    pub fn new(scenario: &Scenario, key: &str, folder: &Path) -> Result<Self, VariedError> {
        let own = || key.to_owned();
        let found = find(keys(&scenario.echo, &LEFT_OUT), key);
        let found = found.map_err(|nearest| VariedError::NoKey {
            key: own(),
            nearest,
        })?;
        if found.is_whole() {
            return Err(VariedError::Whole { key: own() });
        }
        if scenario.contact_choice.is_some() {
            return Err(VariedError::Auto { key: own() });
        }
        Ok(Self {
            base: without(&scenario.echo, &["study", "output"]),
            folder: folder.to_owned(),
            key: found,
        })
    }

    /// A value as it is written in a scenario, in SI units, and the number that varies, shown in the unit
    /// that it was written in.
    ///
    /// # Errors
    /// [`VariedError::Value`] where the text is none.
    pub fn value(&self, text: &str) -> Result<(f64, Variable), VariedError> {
        let wrong = |reason: String| VariedError::Value {
            key: self.key.path.clone(),
            text: text.to_owned(),
            reason,
        };
        let si = match self.key.dimension() {
            Some(dimension) => parse(text, dimension)
                .map(|parsed| parsed.si)
                .map_err(|error| wrong(error.to_string()))?,
            None => text
                .trim()
                .parse()
                .map_err(|_| wrong("write a number".to_owned()))?,
        };
        Ok((si, self.key.variable(&text.into())))
    }

    /// The rotor at a value in SI units.
    ///
    /// # Errors
    /// What is wrong with it there, in words.
    pub fn rotor(&self, si: f64) -> Result<RotorDefinition, String> {
        let (key, value) = (&self.key.path, self.key.written(si));
        let wrong = |message| format!("with {key} = {value}: {message}");
        let questions = questions(&self.base, key, &value, &self.folder)
            .map_err(|issue| wrong(issue.message))?;
        let model = questions
            .model
            .ok_or_else(|| wrong("the scenario has no `[time]`".to_owned()))?;
        Ok(model.rotor)
    }
}
