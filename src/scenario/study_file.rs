//! Study files: many runs of one scenario.

use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::sync::atomic::AtomicBool;

use serde_json::{Value, json};

use super::document::{Document, FileKind};
use super::input::Questions;
use super::key::Key;
use super::key_path::set_value;
use super::schema::schema_of;
use super::study_input::StudyFileInput;
use super::{Format, Issue, Scenario, ScenarioError, built, questions, read_input, read_titled};
use crate::quasi_static::StaticQuestion;
use crate::simulate::Model;
use crate::study::Variable;
use crate::study::many::{
    Ask, Cycles, Keep, Maker, NumberColumn, Outcome, Schedule, Sweep, static_outcome,
};
use crate::study::plan::Plan;

/// Keys of settle time and duration.
pub(super) const TIMES: [&str; 2] = ["time.settle", "time.duration"];

/// A checked study: which runs there are and how each is made.
#[derive(Debug, Clone)]
pub struct StudyFile {
    /// Its title, or the name of its file.
    pub title: String,
    /// What it asks at every point.
    pub ask: Ask,
    /// The values of every run.
    pub plan: Plan,
    /// What varies, an entry an axis.
    pub variables: Vec<Variable>,
    /// Order in which each run goes on from its neighbour, where it does.
    pub sweep: Option<Sweep>,
    /// Every so many runs the error is measured; 0 on none.
    pub verify_every: u64,
    /// What is kept of every run besides its numbers.
    pub keep: Keep,
    /// At how many azimuths around a bearing static answers are looked at; where `None`, at those of its balls.
    pub positions: Option<usize>,
    /// The numbers that are kept of every run, in the order of the table.
    pub columns: Vec<NumberColumn>,
    /// The study with its defaults and the scenario that it starts from.
    pub echo: Value,
    pub(super) base: Value,
    pub(super) folder: PathBuf,
    pub(super) keys: Vec<Key>,
    pub(super) cycles: Option<Cycles>,
    /// Warnings of the file of the base that its tables with their defaults do not give again.
    pub(super) warnings: Vec<String>,
}

/// JSON Schema (draft 7) of a study file.
pub fn study_schema() -> &'static Value {
    static SCHEMA: LazyLock<Value> = LazyLock::new(schema_of::<StudyFileInput>);
    &SCHEMA
}

/// Reads and checks a study file, with some values in place of its own, and the scenario that it starts from.
///
/// # Errors
/// [`ScenarioError`] with everything that is wrong, of the study or else of the scenario.
pub fn load_study(path: &Path, settings: &[String]) -> Result<StudyFile, ScenarioError> {
    check_study(&Document::open(path)?.with(settings)?)
}

/// Checks a study and the scenario that it starts from.
pub(super) fn check_study(document: &Document) -> Result<StudyFile, ScenarioError> {
    document.check_kind(FileKind::Study)?;
    let mut problems = document.problems().about("the study");
    let study = match read_titled::<StudyFileInput>(study_schema(), &mut problems) {
        Some(input) => input.on_base(document, &mut problems)?,
        None => None,
    };
    document.finish(study, problems).map(|(study, _)| study)
}

/// Reads and checks the text of a study of a scenario that is there already, whatever `base` says; the files that
/// the scenario names are in `folder`.
///
/// # Errors
/// [`ScenarioError`] with everything that is wrong.
pub fn parse_study(
    text: &str,
    format: Format,
    scenario: &Scenario,
    folder: &Path,
) -> Result<StudyFile, ScenarioError> {
    let document = Document::parse(text, "study", format)?;
    let mut problems = document.problems().about("the study");
    let read = read_titled::<StudyFileInput>(study_schema(), &mut problems);
    let study = read.and_then(|input| {
        let title = input.title.as_ref().unwrap_or(&scenario.title).clone();
        input.study(scenario, title, folder.to_owned(), &mut problems)
    });
    document.finish(study, problems).map(|(study, _)| study)
}

impl StudyFile {
    /// The scenario of a run with its values put in, as JSON.
    ///
    /// # Errors
    /// [`Issue`] where its values make no scenario.
    pub fn scenario(&self, values: &[f64]) -> Result<Value, Issue> {
        let mut scenario = self.base.clone();
        for ((key, variable), value) in self.keys.iter().zip(&self.variables).zip(values) {
            let word = variable.word(*value).map(Value::from);
            key.set(&mut scenario, &word.unwrap_or_else(|| key.written(*value)));
        }
        if let Some(cycles) = &self.cycles {
            let rotor = questions(&scenario, &self.folder, read_input)?
                .motion()?
                .rotor;
            let times = cycles.times(&rotor);
            let times = times.map_err(|error| Issue::new("cycles", error.to_string()))?;
            for (key, time) in TIMES.iter().zip(times) {
                set_value(&mut scenario, key, &json!(format!("{time} s")));
            }
        }
        Ok(scenario)
    }

    /// What makes its runs, without traces; `model` gives the motion of a run's values.
    pub(crate) fn maker<'a>(
        &'a self,
        schedule: Schedule,
        model: &'a (dyn Fn(&[f64]) -> Result<Model, String> + Sync),
        stop: &'a AtomicBool,
    ) -> Maker<'a> {
        Maker {
            plan: &self.plan,
            schedule,
            keep: self.keep,
            verify_every: self.verify_every,
            traces: None,
            columns: &self.columns,
            model,
            stop,
        }
    }

    /// The motion of a run.
    ///
    /// # Errors
    /// [`Issue`] where its values make no scenario.
    pub fn model(&self, values: &[f64]) -> Result<Model, Issue> {
        self.questions(values)?.motion()
    }

    /// The static question of a point.
    ///
    /// # Errors
    /// [`Issue`] where its values make no scenario.
    pub fn question(&self, values: &[f64]) -> Result<StaticQuestion, Issue> {
        Ok(self.questions(values)?.question)
    }

    fn questions(&self, values: &[f64]) -> Result<Questions, Issue> {
        let (_, questions, warnings) = built(&self.scenario(values)?, &self.folder, read_input)?;
        Ok(questions.with_warnings(&self.all_warnings(warnings)))
    }

    /// The scenario of a point by itself, under a title.
    ///
    /// # Errors
    /// [`Issue`] where its values make none.
    pub(crate) fn alone(&self, values: &[f64], title: String) -> Result<Scenario, Issue> {
        let mut scenario = self.scenario(values)?;
        scenario["title"] = title.into();
        let (input, questions, warnings) = built(&scenario, &self.folder, read_input)?;
        let warnings = self.all_warnings(warnings);
        Ok(Scenario::new(input, questions, warnings, String::new))
    }

    /// Warnings of the file of the base, and those of a point.
    fn all_warnings(&self, of_point: Vec<String>) -> Vec<String> {
        self.warnings.iter().cloned().chain(of_point).collect()
    }

    /// The answer to the static question of a point, or why there is none.
    pub(crate) fn static_outcome(&self, values: &[f64]) -> Result<Outcome, String> {
        let question = self.question(values).map_err(|error| error.message)?;
        let found = static_outcome(&question, &self.columns, self.positions);
        found.map_err(|error| error.to_string())
    }
}
