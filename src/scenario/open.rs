//! A scenario some of whose numbers are left open.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::input::{Questions, ScenarioInput};
use super::key::{Key, find, number_keys};
use super::problems::Problems;
use super::{Issue, Scenario, questions, read_input, reader, without};
use crate::quasi_static::StaticQuestion;
use crate::rotor::RotorDefinition;
use crate::simulate::Model;
use crate::study::Variable;

/// Tables whose numbers a motion that repeats does not depend on.
const OF_RUNS: [&str; 5] = ["static", "initial", "time", "integrator", "output"];

/// A checked scenario with some numbers left open.
#[derive(Debug, Clone, PartialEq)]
pub struct OpenScenario {
    base: Value,
    folder: PathBuf,
    keys: Vec<Key>,
    /// Whether all of them have values in the scenario: then other values are all that there is to check.
    are_given: bool,
}

impl OpenScenario {
    /// The scenario with the numbers at some paths open, for instance `speed.constant` or `bearing[*].preload`; the files
    /// that it names are in `folder`.
    ///
    /// # Errors
    /// [`Issue`] where there is no such number, where it is a whole number, and where the law of the
    /// contacts may change with it.
    pub fn new<'p>(
        scenario: &Scenario,
        paths: impl IntoIterator<Item = &'p str>,
        folder: &Path,
    ) -> Result<Self, Issue> {
        let known = number_keys(&scenario.echo, &OF_RUNS);
        let key = |path: &'p str| {
            let key = find(&known, &[path.to_owned()], path)?;
            check(scenario, &key, path)?;
            Ok(key)
        };
        let base = without(&scenario.echo, &["output"]);
        let keys: Vec<_> = paths.into_iter().map(key).collect::<Result<_, Issue>>()?;
        Ok(Self {
            are_given: keys.iter().all(|key| key.is_given(&base)),
            base,
            folder: folder.to_owned(),
            keys,
        })
    }

    /// A value as it is written in a scenario, in SI units, and the first number that varies, shown in the unit
    /// that it was written in.
    ///
    /// # Errors
    /// [`Issue`] where the text is none.
    pub fn value(&self, text: &str) -> Result<(f64, Variable), Issue> {
        let path = &self.keys[0].path;
        let value = self.keys[0].typed(text, path).map_err(|issue| Issue {
            message: format!("`{text}` is no value of `{path}`: {}", issue.message),
            ..issue
        })?;
        Ok((self.keys[0].si(&value), self.keys[0].variable(&value)))
    }

    /// The values of the numbers in the scenario, SI units, each shown in the unit that it was written in.
    ///
    /// # Errors
    /// [`Issue`] where one has none.
    pub fn values(&self) -> Result<Vec<(f64, Variable)>, Issue> {
        let value = |key: &Key| {
            let value = key.value_in(&self.base).ok_or_else(|| {
                let path = &key.path;
                let message = format!("`{path}` has no value in the scenario, or not one alone");
                let help =
                    "write its value there, or by --set; name keys of different values one by one";
                Issue::new(path, message).help(help)
            })?;
            Ok((key.si(value), key.variable(value)))
        };
        self.keys.iter().map(value).collect()
    }

    /// The rotor at a value of the first number in SI units.
    ///
    /// # Errors
    /// [`Issue`] with what is wrong with it there.
    pub fn rotor(&self, si: f64) -> Result<RotorDefinition, Issue> {
        Ok(self.questions(&[si])?.motion()?.rotor)
    }

    /// The static equilibrium of the shaft and, with a `[time]`, how it moves, at values in SI units.
    ///
    /// # Errors
    /// [`Issue`] with what is wrong there.
    pub fn asked(&self, values: &[f64]) -> Result<(StaticQuestion, Option<Model>), Issue> {
        let Questions {
            question, model, ..
        } = self.questions(values)?;
        Ok((question, model))
    }

    fn questions(&self, values: &[f64]) -> Result<Questions, Issue> {
        let mut scenario = self.base.clone();
        let mut reported = Vec::new();
        for (key, si) in self.keys.iter().zip(values) {
            let value = key.written(*si);
            key.set(&mut scenario, &value);
            reported.push(format!("{} = {value}", key.path));
        }
        let read = |problems: &mut Problems<'_>| match self.are_given {
            true => self.read_again(&scenario, problems),
            false => read_input(problems),
        };
        questions(&scenario, &self.folder, read).map_err(|issue| Issue {
            message: format!("with {}: {}", reported.join(", "), issue.message),
            ..issue
        })
    }

    /// The tables of a scenario that was checked but for the numbers left open.
    fn read_again(&self, scenario: &Value, problems: &mut Problems<'_>) -> Option<ScenarioInput> {
        for key in &self.keys {
            key.check_in(problems);
        }
        let is_right = problems.issues.is_empty();
        is_right.then(|| reader::typed(scenario.clone(), problems))?
    }
}

/// Refuses numbers that answers do not change with little by little.
pub(super) fn check(scenario: &Scenario, key: &Key, place: &str) -> Result<(), Issue> {
    let path = &key.path;
    if key.is_whole() {
        let message = format!("`{path}` is a whole number: it does not change little by little");
        return Err(Issue::new(place, message));
    }
    if scenario.contact_choice.is_some() {
        let message = format!(
            "contact = \"auto\" may choose another law at another value of `{path}`: set the law that it chose here"
        );
        return Err(Issue::new(place, message));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenario::{Format, parse};

    const SCENE: &str = r#"
        shaft.mass = "5 kg"
        shaft.freedoms = "radial"
        speed.constant = "100 rad/s"
        time = { duration = "1 s" }
        damping.coefficients = { x = "1 N s/m", y = "1 N s/m" }
        bearing = [{ catalogue = "6205" }]
    "#;

    /// A number that the scenario gives is checked by its own range alone, one that it does not give with all that it brings.
    #[test]
    fn what_is_wrong_with_an_open_number_is_told_with_its_value() {
        let scenario = parse(SCENE, "scene", Format::Toml).expect("a scenario");
        let open = |path: &str| OpenScenario::new(&scenario, [path], Path::new("")).expect(path);
        let mass = open("shaft.mass");
        assert!(mass.are_given);
        assert_eq!(mass.rotor(7.0).expect("a rotor").shaft.mass, 7.0);
        let wrong = mass.rotor(-1.0).expect_err("no mass").message;
        assert!(
            wrong.starts_with("with shaft.mass = \"-1 kg\": `mass` must be "),
            "{wrong}"
        );
        let preload = open("bearing[1].preload");
        assert!(!preload.are_given);
        assert!(preload.rotor(1.0).is_ok());
        let wrong = preload.rotor(-1.0).expect_err("no preload").message;
        assert!(
            wrong.starts_with("with bearing[1].preload = \"-1 N\": "),
            "{wrong}"
        );
    }
}
