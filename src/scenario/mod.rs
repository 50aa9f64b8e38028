//! Scenario files: text in, checked and typed model out.
//!
//! A file is read into one tree for both formats, the tree is checked against the schema that
//! the structs of `input` give, the structs are filled, and each builds its part of the model.
//! Every step reports all that it finds; the messages carry the place in the text.
//!
//! ```
//! use jeffcott::scenario::{self, Format};
//!
//! let error = scenario::parse("[shaft]\nmass = 5\n", "shaft.toml", Format::Toml).unwrap_err();
//! assert!(error.render(false).contains("`mass` needs a unit, as in \"5 kg\""));
//! ```

mod axis;
pub(crate) mod catalogue_file;
mod coefficients_file;
pub(crate) mod document;
pub(crate) mod fit_file;
mod fit_input;
mod input;
mod keep_input;
mod key;
mod key_path;
mod matrices_file;
mod measured_value;
mod node;
mod observation;
mod open;
mod problems;
mod quantity;
mod range;
mod reader;
mod record_file;
mod removed;
mod schema;
mod series_file;
mod set_input;
mod setting;
mod signals;
pub(crate) mod study_file;
mod study_input;
mod tolerance_file;
pub(crate) mod typed;
mod unit;
mod unit_words;
mod visible;
mod wrong_value;

use std::path::{Path, PathBuf};

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

use super::bearing::{CatalogueLine, Oil, RollerLine};
use super::quasi_static::StaticQuestion;
use super::simulate::{Model, RecordedRun, SimulateError};
use super::study::ContactChoice;
use document::{Document, FileKind};
use fit_file::check_fit;
use input::{Questions, RatingsInput, ScenarioInput};
use node::Node;
use problems::Problems;

pub(crate) use document::{STDIN, STDIN_NAME};
pub(crate) use fit_file::{Balance, FitFile, fit_schema, load_fit};
pub(crate) use input::Output;
#[doc(hidden)]
pub use input::TableFormat;
pub(crate) use open::OpenScenario;
pub use problems::{Issue, ScenarioError};
use record_file::check_record;
pub(crate) use record_file::{
    MeasuredFile, RecordDescription, describe_record, load_record, open_record, record_schema,
};
pub(crate) use removed::way_left;
pub use schema::schema;
use study_file::check_study;
pub(crate) use study_file::{StudyFile, load_study, study_schema};
pub(crate) use tolerance_file::ToleranceFile;
pub use typed::methods;
pub(crate) use typed::{frequency, method, number, position, speed, time, tolerance};
pub(crate) use visible::{is_visible, visible};

/// Language of a scenario file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Format {
    /// TOML 1.0.
    Toml,
    /// JSON of the same structure.
    Json,
}

/// A checked scenario.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Scenario {
    /// Its title, or the name of its file.
    pub title: String,
    /// The static equilibrium of the shaft.
    pub question: StaticQuestion,
    /// How it moves; none without a `[time]`.
    pub model: Option<Model>,
    /// The law of the contacts, where it was to be chosen.
    #[doc(hidden)]
    pub contact_choice: Option<ContactChoice>,
    /// Oil of each bearing, whether its films are simulated or not.
    pub oils: Vec<Option<Oil>>,
    /// What to keep of the run.
    pub(crate) output: Output,
    /// Folders and files of records that are laid over its spectra.
    pub(crate) measured: Vec<PathBuf>,
    /// The scenario with its defaults written out; itself a valid scenario in JSON.
    pub echo: Value,
    /// What the user should know although the scenario can be run.
    pub warnings: Vec<String>,
}

/// Reads and checks a scenario file, `.toml` or `.json`.
///
/// # Errors
/// [`ScenarioError`] with everything that is wrong, also where the file cannot be read.
pub fn load(path: &Path) -> Result<Scenario, ScenarioError> {
    load_with(path, &[])
}

/// Reads and checks a scenario file with some values in place of its own, each as `key=value`.
///
/// # Errors
/// As [`load`]; what is wrong with a value is shown at it.
pub(crate) fn load_with(path: &Path, settings: &[String]) -> Result<Scenario, ScenarioError> {
    check(&Document::open(path)?.with(settings)?)
}

/// What a file says.
pub(crate) enum Loaded {
    /// A scenario.
    Scenario(Box<Scenario>),
    /// A study.
    Study(Box<StudyFile>),
    /// A fit.
    Fit(Box<FitFile>),
    /// A record of sensors.
    Record(Box<MeasuredFile>),
}

/// Reads and checks a scenario, study, fit or record file with some values in place of its own.
///
/// # Errors
/// As [`load`].
pub(crate) fn load_any(path: &Path, settings: &[String]) -> Result<Loaded, ScenarioError> {
    let document = Document::open(path)?.with(settings)?;
    Ok(match document.kind() {
        Some(FileKind::Study) => Loaded::Study(check_study(&document)?.into()),
        Some(FileKind::Fit) => Loaded::Fit(check_fit(&document)?.into()),
        Some(FileKind::Record) => Loaded::Record(check_record(&document)?.into()),
        Some(FileKind::Scenario) | None => Loaded::Scenario(check(&document)?.into()),
    })
}

/// What a catalogue prints of a bearing.
pub(crate) enum RatedLine {
    /// Of a ball bearing.
    Balls(CatalogueLine),
    /// Of a roller bearing.
    Rollers(RollerLine),
}

/// A catalogue line from the texts of the keys of `[bearing.ratings]`, quantities with their units.
///
/// # Errors
/// Everything that is wrong with them.
pub(crate) fn ratings<'a>(
    given: impl Iterator<Item = (&'a str, &'a str)>,
) -> Result<RatedLine, Vec<Issue>> {
    let schema = &schema()["properties"]["bearing"]["items"]["properties"]["ratings"];
    let value = |(key, text): (&str, &str)| {
        let plain = schema["properties"][key]["x-dimension"].is_null();
        let number = plain.then(|| serde_json::from_str(text).ok()).flatten();
        (key.to_owned(), number.unwrap_or_else(|| Value::from(text)))
    };
    let root = Node::from(&Value::Object(given.map(value).collect()));
    let mut problems = Problems::new(&root, Path::new("")).about("the line");
    let input: Option<RatingsInput> = reader::read(schema, &mut problems);
    let line = input.and_then(|input| match input.kind {
        None => Some(RatedLine::Balls(input.line())),
        Some(kind) => {
            let line = input.roller_line(kind, &mut problems);
            line.map(RatedLine::Rollers)
        }
    });
    line.filter(|_| problems.issues.is_empty())
        .ok_or(problems.issues)
}

/// Reads and checks the text of a scenario; `name` is what messages call it, and files that it names are looked for
/// from the folder of that path.
///
/// # Errors
/// [`ScenarioError`] with everything that is wrong.
pub fn parse(text: &str, name: &str, format: Format) -> Result<Scenario, ScenarioError> {
    check(&Document::parse(text, name, format)?)
}

fn check(document: &Document) -> Result<Scenario, ScenarioError> {
    document.check_kind(FileKind::Scenario)?;
    let mut problems = document.problems();
    let built = build(read_input(&mut problems), &mut problems);
    let ((input, questions), warnings) = document.finish(built, problems)?;
    let name = || document.stem();
    Ok(Scenario::new(input, questions, warnings, name))
}

/// The tables of a scenario, each key checked by itself.
fn read_input(problems: &mut Problems<'_>) -> Option<ScenarioInput> {
    read_titled(schema(), problems)
}

/// The tables of a scenario and what they ask.
fn build(
    input: Option<ScenarioInput>,
    problems: &mut Problems<'_>,
) -> Option<(ScenarioInput, Questions)> {
    let mut input = input?;
    input.shaft.choose_freedoms(problems);
    let questions = input.build(problems)?;
    Some((input, questions))
}

/// Reads a file with a title; refuses one that a terminal or a figure would take for a command.
fn read_titled<T: DeserializeOwned>(schema: &Value, problems: &mut Problems<'_>) -> Option<T> {
    let input = reader::read(schema, problems)?;
    let title = problems.node("title").map(Value::from);
    let title = title.as_ref().and_then(Value::as_str);
    if title.is_some_and(|title| title.contains(['\n', '\t']) || !is_visible(title)) {
        let message = "a title is one line without control characters and marks of direction";
        problems.refuse(Issue::new("title", message));
    }
    Some(input)
}

/// What a scenario asks, as `read` finds its tables; the files that it names are in `folder`.
fn questions(
    scenario: &Value,
    folder: &Path,
    read: impl FnOnce(&mut Problems<'_>) -> Option<ScenarioInput>,
) -> Result<Questions, Issue> {
    let (_, questions, warnings) = built(scenario, folder, read)?;
    Ok(questions.with_warnings(&warnings))
}

/// The tables of a scenario, what they ask and warnings; the files that it names are in `folder`.
fn built(
    scenario: &Value,
    folder: &Path,
    read: impl FnOnce(&mut Problems<'_>) -> Option<ScenarioInput>,
) -> Result<(ScenarioInput, Questions, Vec<String>), Issue> {
    let root = Node::from(scenario);
    let mut problems = Problems::new(&root, folder);
    let built = build(read(&mut problems), &mut problems);
    if let Some(issue) = problems.issues.into_iter().next() {
        return Err(issue);
    }
    let (input, questions) = built.ok_or_else(|| Issue::new("", "the scenario asks nothing"))?;
    Ok((input, questions, problems.warnings))
}

/// A scenario without some of its tables.
fn without(scenario: &Value, left_out: &[&str]) -> Value {
    let mut rest = scenario.clone();
    if let Value::Object(tables) = &mut rest {
        tables.retain(|name, _| !left_out.contains(&name.as_str()));
    }
    rest
}

/// What was read as JSON, without the keys that are not given and have no default.
fn echo(input: &impl Serialize) -> Value {
    let mut value = serde_json::to_value(input).unwrap_or_default();
    remove_null(&mut value);
    value
}

fn remove_null(value: &mut Value) {
    match value {
        Value::Object(entries) => {
            entries.retain(|_, entry| !entry.is_null());
            entries.values_mut().for_each(remove_null);
        }
        Value::Array(items) => items.iter_mut().for_each(remove_null),
        _ => {}
    }
}

/// Why a scenario cannot be simulated.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ScenarioRunError {
    /// It asks nothing but where the shaft is stationary.
    #[error("the scenario has no [time], so that nothing moves: add one, with a duration")]
    NoTime,
    /// The run failed.
    #[error(transparent)]
    Simulate(#[from] SimulateError),
}

impl Scenario {
    /// Some tables and what they ask, with the warnings that all answers repeat; `name` stands for a title that is not given.
    fn new(
        input: ScenarioInput,
        questions: Questions,
        warnings: Vec<String>,
        name: impl FnOnce() -> String,
    ) -> Self {
        let questions = questions.with_warnings(&warnings);
        Self {
            echo: echo(&input),
            title: input.title.unwrap_or_else(name),
            question: questions.question,
            model: questions.model,
            contact_choice: questions.contact_choice,
            oils: questions.oils,
            output: input.output,
            measured: questions.measured,
            warnings,
        }
    }

    /// Reads and checks the text of a scenario in TOML; as [`parse`].
    ///
    /// # Errors
    /// [`ScenarioError`] with everything that is wrong.
    pub fn from_toml(text: &str) -> Result<Self, ScenarioError> {
        parse(text, "scenario.toml", Format::Toml)
    }

    /// Formats that it asks for its tables to be written in.
    #[doc(hidden)]
    pub fn formats(&self) -> &[TableFormat] {
        &self.output.formats
    }

    /// Leaves out the pass that measures the error, if `left_out` says so; the scenario then says so, too.
    pub(crate) fn leave_out_verification(&mut self, left_out: bool) {
        if let Some(model) = self.model.as_mut().filter(|_| left_out) {
            model.verify = false;
            self.echo["integrator"]["verify"] = false.into();
        }
    }

    /// Runs it and keeps all samples in memory; writes no file.
    ///
    /// # Errors
    /// [`ScenarioRunError`].
    pub fn simulate(&self) -> Result<RecordedRun, ScenarioRunError> {
        let model = self.model.as_ref().ok_or(ScenarioRunError::NoTime)?;
        Ok(RecordedRun::from_model(model)?)
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
    fn whole_numbers_of_any_size_meet_their_limits() {
        let reported = |balls| {
            let line = [
                ("bore", "25 mm"),
                ("outside_diameter", "52 mm"),
                ("contact_angle", "0 deg"),
                ("dynamic", "14 kN"),
                ("static", "7.85 kN"),
                ("balls", balls),
            ];
            ratings(line.into_iter())
                .err()
                .map(|issues| issues[0].to_string())
        };
        for (balls, shown) in [
            ("18446744073709551615", "18446744073709551615"),
            ("-9223372036854775808", "-9223372036854775808"),
            ("1e300", "1e+300"),
            ("201", "201"),
        ] {
            let message = reported(balls).expect(balls);
            assert!(
                message.contains(shown) && message.contains("200"),
                "{message}"
            );
        }
        assert!(reported("9.0").is_none() && reported("8.5").is_some());
    }

    #[test]
    fn a_scenario_without_time_has_no_run() {
        let scenario = Scenario::from_toml(SHAFT).expect("a scenario");
        let refused = scenario.simulate().expect_err("no run");
        assert!(matches!(refused, ScenarioRunError::NoTime));
    }
}
