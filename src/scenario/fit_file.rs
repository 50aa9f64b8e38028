//! Fit files: quantities of a scenario whose values are sought, and what was measured.

use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::axis::Scalar;
use super::document::Document;
use super::input::Questions;
use super::key::{self, Key, KeyPaths, number_keys};
use super::observation::ObservationInput;
use super::problems::Problems;
use super::quantity::{Length, Quantity};
use super::schema::schema_of;
use super::study_file::SetInput;
use super::{Format, Issue, Scenario, ScenarioError, echo, open, questions, reader};
use crate::fit::{Effort, Kind, Observation, Question, Unknown, Wanted};
use crate::study::Variable;
use crate::study::campbell::CampbellQuestion;
use crate::study::many::number_columns;

/// Searches where no number is given.
const STARTS: u32 = 4;
/// Most of them.
const MOST_STARTS: u32 = 1000;
/// Speeds of a diagram whose critical speeds are sought, and up to which part of the highest speed.
const SPEEDS: usize = 61;
const BEYOND: f64 = 1.5;
/// Tolerance of a motion that a search far from its end asks for, where that of the scenario is tighter.
const COARSE: f64 = 1e-6;
/// Tables that no fitted quantity is in.
const LEFT_OUT: [&str; 4] = ["static", "time", "integrator", "output"];
/// A full turn: the range of an angle whose ends are one.
const TURN: f64 = std::f64::consts::TAU;

/// A checked fit: what is sought, and what was measured.
#[derive(Debug, Clone)]
pub struct FitFile {
    /// Its title, or the name of its file.
    pub title: String,
    /// What is sought.
    pub unknowns: Vec<Unknown>,
    /// What was measured.
    pub observations: Vec<Observation>,
    /// For every observation the question that has the number, and which that is.
    pub readings: Vec<(usize, Wanted)>,
    /// Searches from different starts.
    pub starts: usize,
    /// Masses that balance fitted unbalances.
    pub corrections: Vec<Correction>,
    /// Folders of records that lines were taken from.
    pub records: Vec<PathBuf>,
    /// The fit with its defaults and the scenario that it starts from.
    pub echo: Value,
    /// What the user should know of the base.
    pub warnings: Vec<String>,
    /// The base, and what was otherwise than there when something was measured.
    scenarios: Vec<Value>,
    /// Of every question its kind and its scenario.
    questions: Vec<(Kind, usize)>,
    folder: PathBuf,
    keys: Vec<Key>,
}

/// A mass that balances an unbalance of the scenario.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Correction {
    /// Which `[[unbalance]]`, from 0.
    pub plane: usize,
    /// Distance of the mass from the axis, m.
    pub radius: f64,
}

/// A mass that balances an unbalance, where people mount it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Balance {
    /// Which `[[unbalance]]`, from 0.
    pub plane: usize,
    /// Its position along the shaft, m.
    pub position: f64,
    /// The mass to add, kg.
    pub mass: f64,
    /// Distance of the mass from the axis, m.
    pub radius: f64,
    /// Angle of the mass on the shaft, rad, 0 … 2π.
    pub angle: f64,
}

/// JSON Schema (draft 7) of a fit file.
pub fn fit_schema() -> &'static Value {
    static SCHEMA: std::sync::LazyLock<Value> = std::sync::LazyLock::new(schema_of::<FitFileInput>);
    &SCHEMA
}

/// Quantities of a scenario whose values are sought, and what was measured. What has a dimension is a string with its unit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "jeffcott fit")]
struct FitFileInput {
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
struct UnknownInput {
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
struct CorrectionInput {
    /// Number of the `[[unbalance]]`, from 1.
    #[schemars(range(min = 1, max = 1000))]
    pub unbalance: usize,
    /// Distance from the axis at which the mass is mounted.
    #[schemars(extend("examples" = ["60 mm"], "x-above" = 0.0))]
    pub radius: Quantity<Length>,
}

/// Reads and checks a fit file, with some values in place of its own, and the scenario that it starts from.
///
/// # Errors
/// [`ScenarioError`] with everything that is wrong, of the fit or else of the scenario.
pub fn load_fit(path: &Path, settings: &[String]) -> Result<FitFile, ScenarioError> {
    check_fit(&Document::open(path)?.with(settings)?)
}

/// Checks a fit and the scenario that it starts from.
pub(super) fn check_fit(document: &Document) -> Result<FitFile, ScenarioError> {
    if !document.is_fit() {
        let message = "this is no fit file: it names a scenario by `base`, and has `[[unknown]]` and `[[observation]]`";
        return Err(document.refused(Issue::new("", message)));
    }
    let mut problems = document.problems().about("the fit");
    let fit = match read(&mut problems) {
        None => None,
        Some(input) => {
            match super::study_file::base_of(&input.base, document.folder(), &mut problems) {
                None => None,
                Some(base) => {
                    let scenario = super::load(&base)?;
                    let title = input.title.clone().unwrap_or_else(|| document.stem());
                    let folder = base.parent().unwrap_or(Path::new(""));
                    input.fit(&scenario, title, [folder, document.folder()], &mut problems)
                }
            }
        }
    };
    document.finish(fit, problems).map(|(fit, _)| fit)
}

/// Reads and checks the text of a fit of a scenario that is there already, whatever `base` says; the files that both name are in
/// `folder`.
///
/// # Errors
/// [`ScenarioError`] with everything that is wrong.
pub fn parse_fit(
    text: &str,
    format: Format,
    scenario: &Scenario,
    folder: &Path,
) -> Result<FitFile, ScenarioError> {
    let document = Document::parse(text, "fit", format)?;
    let mut problems = document.problems().about("the fit");
    let fit = read(&mut problems).and_then(|input| {
        let title = input.title.as_ref().unwrap_or(&scenario.title).clone();
        input.fit(scenario, title, [folder; 2], &mut problems)
    });
    document.finish(fit, problems).map(|(fit, _)| fit)
}

fn read(problems: &mut Problems<'_>) -> Option<FitFileInput> {
    let input: FitFileInput = reader::read(fit_schema(), problems)?;
    super::check_title(input.title.as_deref(), problems);
    Some(input)
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

impl FitFileInput {
    /// The fit of a scenario whose files are in the first folder; those of the fit are in the second.
    fn fit(
        &self,
        scenario: &Scenario,
        title: String,
        [folder, own_folder]: [&Path; 2],
        problems: &mut Problems<'_>,
    ) -> Option<FitFile> {
        let mut base = scenario.echo.clone();
        SetInput::apply(&self.set, &mut base, problems)?;
        let known = number_keys(&base, &LEFT_OUT);
        let found = problems.each("unknown", &self.unknown, |input, problems| {
            input.build(scenario, &known, problems)
        })?;
        let (keys, unknowns): (Vec<Key>, Vec<Unknown>) = found.into_iter().unzip();
        self.check_apart(&keys, problems);
        let mut scenarios = vec![base.clone()];
        let (mut questions, mut observations, mut readings) = (Vec::new(), Vec::new(), Vec::new());
        let rotor = &scenario.question.rotor;
        problems.each("observation", &self.observation, |input, problems| {
            let mut there = base.clone();
            SetInput::apply(&input.set, &mut there, problems)?;
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

impl FitFile {
    /// Number of questions that the observations ask.
    pub fn questions(&self) -> usize {
        self.questions.len()
    }

    /// The variables that are sought.
    pub fn variables(&self) -> impl Iterator<Item = &Variable> {
        self.unknowns.iter().map(|unknown| &unknown.variable)
    }

    fn with_values(&self, scenario: usize, values: &[f64]) -> Value {
        let mut scenario = self.scenarios[scenario].clone();
        for (key, value) in self.keys.iter().zip(values) {
            key.set(&mut scenario, &key.written(*value));
        }
        scenario
    }

    /// The scenario with values of the unknowns as TOML; it lays the records that lines were taken from over a run.
    pub fn fitted_toml(&self, values: &[f64]) -> String {
        let mut scenario = self.with_values(0, values);
        let records = self
            .records
            .iter()
            .filter_map(|path| path.canonicalize().ok());
        let records: Vec<Value> = records.map(|path| json!({ "file": path })).collect();
        if !records.is_empty() {
            scenario["measured"] = records.into();
        }
        let folder = self.folder.display();
        let text = toml::to_string(&scenario).unwrap_or_default();
        format!(
            "# As fitted by `jeffcott fit`; the files that it names are looked for from here, those of the base from {folder:?}.\n{text}"
        )
    }

    /// The masses that balance the fitted unbalances: opposite to each, at their radius.
    pub fn balance(&self, values: &[f64]) -> Vec<Balance> {
        let scenario = self.with_values(0, values);
        let mass = |correction: &Correction| {
            let plane = &scenario["unbalance"][correction.plane];
            let number = |key: &str| {
                let path = format!("unbalance[].{key}");
                plane[key]
                    .as_str()
                    .and_then(|text| key::number(text, &path, key).ok())
                    .unwrap_or(0.0)
            };
            Balance {
                plane: correction.plane,
                position: number("position"),
                mass: number("amount") / correction.radius,
                radius: correction.radius,
                angle: (number("angle") + 0.5 * TURN).rem_euclid(TURN),
            }
        };
        self.corrections.iter().map(mass).collect()
    }

    /// A question at values of the unknowns, to be answered with an effort.
    ///
    /// # Errors
    /// [`Issue`] where these make no scenario.
    pub fn question(
        &self,
        question: usize,
        values: &[f64],
        effort: Effort,
    ) -> Result<Question, Issue> {
        let (kind, scenario) = self.questions[question];
        let Questions {
            question: statics,
            mut model,
            ..
        } = questions(&self.with_values(scenario, values), &self.folder)?;
        if let Some(model) = &mut model {
            model.verify &= effort == Effort::Verified;
            if effort == Effort::Coarse {
                let tolerance = &mut model.integrator.tolerance;
                *tolerance = tolerance.max(COARSE);
            }
        }
        let own = self.readings.iter().filter(|(place, _)| *place == question);
        let names: Vec<&str> = own.filter_map(|(_, wanted)| wanted.name()).collect();
        let motion = || model.ok_or_else(|| Issue::new("time", "the scenario has no `[time]`"));
        Ok(match kind {
            Kind::Bearing => Question::Bearing(statics),
            Kind::Campbell => {
                let rotor = statics.rotor;
                let is_asked = names.iter().any(|name| name.starts_with("critical"));
                let critical = is_asked.then(|| CampbellQuestion {
                    to: BEYOND * rotor.highest_speed(),
                    rotor: rotor.clone(),
                    from: 0.0,
                    count: SPEEDS,
                    orders: vec![1.0],
                });
                Question::Campbell(Box::new(rotor), critical.map(Box::new))
            }
            Kind::Steady => Question::Steady(motion()?, None),
            Kind::Run => {
                let model = motion()?;
                let mut columns = number_columns(&model.rotor);
                columns.retain(|own| own.is_error() || names.contains(&&*own.column.name()));
                Question::Run(model, columns)
            }
        })
    }
}
