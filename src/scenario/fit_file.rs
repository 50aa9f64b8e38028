//! Fit files: quantities of a scenario whose values are sought, and what was measured.

use std::path::{Path, PathBuf};
use std::sync::LazyLock;

use serde_json::{Value, json};

use super::document::{Document, FileKind};
use super::fit_input::FitFileInput;
use super::input::Questions;
use super::key::Key;
use super::schema::schema_of;
use super::typed::number;
use super::{Format, Issue, Scenario, ScenarioError, questions, read_input, read_titled};
use crate::fit::{Effort, Kind, Observation, Question, Unknown, Wanted};
use crate::study::Variable;
use crate::study::campbell::CampbellQuestion;
use crate::study::many::number_columns;

/// Speeds of a diagram whose critical speeds are sought, and up to which part of the highest speed.
const SPEEDS: usize = 61;
const BEYOND: f64 = 1.5;
/// Tolerance of a motion that a search far from its end asks for, where that of the scenario is tighter.
const COARSE: f64 = 1e-6;
/// A full turn: the range of an angle whose ends are one.
pub(super) const TURN: f64 = std::f64::consts::TAU;

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
    pub(super) scenarios: Vec<Value>,
    /// Of every question its kind and its scenario.
    pub(super) questions: Vec<(Kind, usize)>,
    pub(super) folder: PathBuf,
    pub(super) keys: Vec<Key>,
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
    static SCHEMA: LazyLock<Value> = LazyLock::new(schema_of::<FitFileInput>);
    &SCHEMA
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
    document.check_kind(FileKind::Fit)?;
    let mut problems = document.problems().about("the fit");
    let fit = match read_titled::<FitFileInput>(fit_schema(), &mut problems) {
        Some(input) => input.on_base(document, &mut problems)?,
        None => None,
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
    let read = read_titled::<FitFileInput>(fit_schema(), &mut problems);
    let fit = read.and_then(|input| {
        let title = input.title.as_ref().unwrap_or(&scenario.title).clone();
        input.fit(scenario, title, [folder; 2], &mut problems)
    });
    document.finish(fit, problems).map(|(fit, _)| fit)
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
                    .and_then(|text| number(text, &path, key).ok())
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
        } = questions(
            &self.with_values(scenario, values),
            &self.folder,
            read_input,
        )?;
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
                    highest_frequency: None,
                });
                Question::Campbell(Box::new(rotor), critical.map(Box::new))
            }
            Kind::Steady => Question::Steady(motion()?, None),
            Kind::Run => {
                let model = motion()?;
                let mut columns = number_columns(&model.rotor);
                columns.retain(|own| own.is_error() || names.contains(&&*own.column.name()));
                Question::Run(model, columns, None)
            }
        })
    }
}
