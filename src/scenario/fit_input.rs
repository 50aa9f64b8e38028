//! The tables of a fit file, and what they become.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::json;

use super::axis::Scalar;
use super::document::Document;
use super::fit_file::{Correction, FitFile, TURN};
use super::key::{self, Key, number_keys};
use super::key_path::KeyPaths;
use super::observation::ObservationInput;
use super::problems::Problems;
use super::quantity::{Length, Quantity};
use super::set_input::SetInput;
use super::{Issue, Scenario, ScenarioError, echo, open};
use crate::fit::{Kind, Observation, Unknown};

/// Searches where no number is given.
const STARTS: u32 = 4;
/// Most of them.
const MOST_STARTS: u32 = 1000;
/// Tables that no fitted quantity is in.
const LEFT_OUT: [&str; 4] = ["static", "time", "integrator", "output"];

/// Quantities of a scenario whose values are sought, and what was measured. What has a dimension is a string with its unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "jeffcott fit")]
pub(super) struct FitFileInput {
    /// Where an editor finds the schema of this file; without effect.
    #[serde(rename = "$schema")]
    pub schema: Option<String>,
    /// What the fit is called. Default: the name of its file.
    pub title: Option<String>,
    /// The scenario whose quantities are sought, relative to this file.
    #[schemars(extend("examples" = ["../fan-6205.toml"]))]
    pub base: String,
    /// How many searches start, one at the given values and the others spread over the ranges. Default: 4.
    #[serde(default = "starts")]
    #[schemars(range(min = 1, max = MOST_STARTS))]
    pub starts: u32,
    /// What is sought, one `[[unknown]]` for each.
    #[schemars(extend("minItems" = 1, "maxItems" = 16))]
    pub unknown: Vec<UnknownInput>,
    /// What was measured, one `[[observation]]` for each.
    #[schemars(extend("minItems" = 1, "maxItems" = 1000))]
    pub observation: Vec<ObservationInput>,
    /// What is otherwise than in the base.
    #[serde(default)]
    pub set: Vec<SetInput>,
    /// Masses that balance unbalances of the scenario with their fitted values, one `[[correction]]` for each.
    #[serde(default)]
    pub correction: Vec<CorrectionInput>,
}

fn starts() -> u32 {
    STARTS
}

/// A quantity whose value is sought between two values.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct UnknownInput {
    /// Path of its key, for instance "bearing[1].geometry.diametral_clearance"; "bearing[*].preload", or a list of paths, are
    /// keys of one value.
    #[schemars(extend("examples" = ["bearing[*].preload"]))]
    pub key: KeyPaths,
    /// Its least value, written as that key is.
    pub from: Scalar,
    /// Its largest value. An angle over a full turn has no ends.
    pub to: Scalar,
    /// Where the first search starts. Default: the middle.
    pub start: Option<Scalar>,
}

/// A mass that balances an `[[unbalance]]` of the scenario.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(super) struct CorrectionInput {
    /// Number of the `[[unbalance]]`, from 1.
    #[schemars(range(min = 1, max = 1000))]
    pub unbalance: usize,
    /// Distance from the axis at which the mass is mounted.
    #[schemars(extend("examples" = ["60 mm"], "x-above" = 0.0))]
    pub radius: Quantity<Length>,
}

impl UnknownInput {
    fn build(
        &self,
        scenario: &Scenario,
        known: &[Key],
        problems: &mut Problems<'_>,
    ) -> Option<(Key, Unknown)> {
        let key = problems.take(key::find(known, self.key.all(), ".key"))?;
        problems.take(open::check(scenario, &key, ".key"))?;
        let mut value = |name: &str| {
            let value = key.read(&problems.path(name), problems)?;
            Some((key.si(&value), key.variable(&value)))
        };
        let ((from, variable), (to, _)) = (value(".from")?, value(".to")?);
        let start = match &self.start {
            Some(_) => value(".start")?.0,
            None => 0.5 * (from + to),
        };
        if from >= to {
            problems.refuse(Issue::new(".to", "`to` must be above `from`").against(".from"));
            return None;
        }
        if !(from..=to).contains(&start) {
            let message = "`start` must be between `from` and `to`";
            problems.refuse(Issue::new(".start", message).against_all([".from", ".to"]));
            return None;
        }
        let wraps = variable.unit == "rad" && ((to - from) / TURN - 1.0).abs() < 1e-6;
        let range = [from, if wraps { from + TURN } else { to }];
        Some((
            key,
            Unknown {
                variable,
                range,
                start,
                wraps,
            },
        ))
    }
}

/// Why an unknown is not set.
const SOUGHT: &str = "is sought";

impl FitFileInput {
    /// The fit of the scenario that it names, as far as nothing contradicts it.
    ///
    /// # Errors
    /// [`ScenarioError`] of that scenario.
    pub fn on_base(
        &self,
        document: &Document,
        problems: &mut Problems<'_>,
    ) -> Result<Option<FitFile>, ScenarioError> {
        let Some((scenario, folder)) = document.base(&self.base, problems)? else {
            return Ok(None);
        };
        let title = self.title.clone().unwrap_or_else(|| document.stem());
        let folders = [folder.as_path(), document.folder()];
        Ok(self.fit(&scenario, title, folders, problems))
    }

    /// The fit of a scenario whose files are in the first folder; those of the fit are in the second.
    pub fn fit(
        &self,
        scenario: &Scenario,
        title: String,
        [folder, own_folder]: [&Path; 2],
        problems: &mut Problems<'_>,
    ) -> Option<FitFile> {
        let mut base = scenario.echo.clone();
        let set = SetInput::apply(&self.set, &mut base, problems)?;
        let known = number_keys(&base, &LEFT_OUT);
        let found = problems.each("unknown", &self.unknown, |input, problems| {
            input.build(scenario, &known, problems)
        })?;
        let (keys, unknowns): (Vec<Key>, Vec<Unknown>) = found.into_iter().unzip();
        self.check_apart(&keys, problems);
        SetInput::refuse_decided(&set, &keys, SOUGHT, problems);
        let mut scenarios = vec![base.clone()];
        let (mut questions, mut observations, mut readings) = (Vec::new(), Vec::new(), Vec::new());
        let rotor = &scenario.question.rotor;
        problems.each("observation", &self.observation, |input, problems| {
            let mut there = base.clone();
            let set = SetInput::apply(&input.set, &mut there, problems)?;
            SetInput::refuse_decided(&set, &keys, SOUGHT, problems);
            let place = place_of(&mut scenarios, there);
            for (kind, wanted, observation) in input.build(rotor, own_folder, problems)? {
                if matches!(kind, Kind::Steady | Kind::Run) && scenario.model.is_none() {
                    let message = "a motion needs a scenario with a `[time]`";
                    problems.refuse(Issue::new("base", message));
                    return None;
                }
                readings.push((place_of(&mut questions, (kind, place)), wanted));
                observations.push(observation);
            }
            Some(())
        })?;
        self.check_observations(&observations, problems);
        let records = self
            .observation
            .iter()
            .filter_map(|own| own.record.as_ref());
        let records = records.map(|record| own_folder.join(record));
        let mut records: Vec<PathBuf> = records.collect();
        records.dedup();
        let corrections = problems.each("correction", &self.correction, |input, problems| {
            let planes = base["unbalance"].as_array().map_or(0, Vec::len);
            if input.unbalance > planes {
                let message = format!(
                    "the scenario has {planes} `[[unbalance]]`, not {}",
                    input.unbalance
                );
                problems.refuse(Issue::new(".unbalance", message));
                return None;
            }
            Some(Correction {
                plane: input.unbalance - 1,
                radius: input.radius.si(),
            })
        })?;
        problems.issues.is_empty().then(|| FitFile {
            title,
            unknowns,
            observations,
            readings,
            starts: self.starts as usize,
            corrections,
            records,
            echo: json!({ "fit": echo(self), "base": base }),
            warnings: scenario.warnings.clone(),
            scenarios,
            questions,
            folder: folder.to_owned(),
            keys,
        })
    }

    /// Refuses a key of two unknowns.
    fn check_apart(&self, keys: &[Key], problems: &mut Problems<'_>) {
        for (place, key) in keys.iter().enumerate() {
            if let Some(path) = keys[..place]
                .iter()
                .find_map(|other| key.shared_with(other))
            {
                let message = format!("`{path}` is sought already");
                problems.refuse(Issue::new(format!("unknown[{}].key", place + 1), message));
            }
        }
    }

    /// Refuses fewer observations than unknowns, and standard deviations of some only.
    fn check_observations(&self, observations: &[Observation], problems: &mut Problems<'_>) {
        let (seen, sought) = (observations.len(), self.unknown.len());
        let known = observations
            .iter()
            .filter(|one| one.sigma.is_some())
            .count();
        let message = if seen < sought {
            format!("{seen} observations cannot tell {sought} unknowns: measure more, or seek less")
        } else if known != 0 && known != seen {
            format!(
                "{known} of {seen} observations have a standard deviation: give `sigma` of all, or of none"
            )
        } else if known == 0 && seen == sought {
            "as many observations as unknowns always fit: their `sigma` is needed to tell how well"
                .to_owned()
        } else {
            return;
        };
        problems.refuse(Issue::new("observation", message));
    }
}

/// The place of something among others, where it is put if it is new.
fn place_of<T: PartialEq>(all: &mut Vec<T>, one: T) -> usize {
    let known = all.iter().position(|known| *known == one);
    known.unwrap_or_else(|| {
        all.push(one);
        all.len() - 1
    })
}
