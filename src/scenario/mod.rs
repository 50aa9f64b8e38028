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

mod argument;
mod dimension;
mod error;
mod input;
mod issue;
mod node;
mod passed;
mod problems;
mod quantity;
mod read_json;
mod read_toml;
mod scalar;
mod schema;
mod series_file;
mod study_file;
mod tolerance_file;
mod varied;
mod vary;
mod walk;

use std::path::Path;

use serde::Serialize;
use serde_json::Value;

pub use argument::{ArgumentError, method, methods, speed, time, tolerance};
pub use error::ScenarioError;
pub use input::{Output, TableFormat, TraceChannel};
pub use issue::Issue;
pub use schema::schema;
pub use study_file::{RunError, StudyFile, load_study, study_schema};
pub use tolerance_file::ToleranceFile;
pub use varied::{Varied, VariedError};

use crate::bearing::Oil;
use crate::quasi_static::StaticQuestion;
use crate::simulate::Model;
use crate::study::{ContactChoice, Study};
use input::{Questions, ScenarioInput};
use node::Node;
use problems::Problems;

/// Language of a scenario file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// TOML 1.0.
    Toml,
    /// JSON of the same structure.
    Json,
}

/// A checked scenario.
#[derive(Debug, Clone, PartialEq)]
pub struct Scenario {
    /// Its title, or the name of its file.
    pub title: String,
    /// Where the shaft stands.
    pub question: StaticQuestion,
    /// How it moves; none without a `[time]`.
    pub model: Option<Model>,
    /// The law of the contacts, where it was to be chosen.
    pub contact_choice: Option<ContactChoice>,
    /// Oil of each bearing, whether its films are simulated or not.
    pub oils: Vec<Option<Oil>>,
    /// The static question at many values of one number.
    pub study: Option<Study>,
    /// What to keep of the run.
    pub output: Output,
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
    let (name, text, root) = read_tree(path)?;
    check(&root, &name).map_err(|issues| ScenarioError::new(&name, &text, issues))
}

/// Name, text and tree of a file.
fn read_tree(path: &Path) -> Result<(String, String, Node), ScenarioError> {
    let name = path.display().to_string();
    let unreadable = |message: String| ScenarioError::new(&name, "", vec![Issue::new("", message)]);
    let extension = path
        .extension()
        .map(|extension| extension.to_ascii_lowercase());
    let format = match extension.as_ref().and_then(|extension| extension.to_str()) {
        Some("toml") => Format::Toml,
        Some("json") => Format::Json,
        _ => {
            return Err(unreadable(
                "a scenario file ends in .toml or .json".to_owned(),
            ));
        }
    };
    let bytes = std::fs::read(path)
        .map_err(|error| unreadable(format!("cannot read the file: {error}")))?;
    let mut text = String::from_utf8(bytes).map_err(|error| {
        let place = error.utf8_error().valid_up_to();
        unreadable(format!("the file is not UTF-8 text: byte {place} is wrong"))
    })?;
    // spans count from behind a byte order mark
    if text.starts_with('\u{feff}') {
        text.remove(0);
    }
    let root = tree(&text, format).map_err(|issues| ScenarioError::new(&name, &text, issues))?;
    Ok((name, text, root))
}

fn tree(text: &str, format: Format) -> Result<Node, Vec<Issue>> {
    match format {
        Format::Toml => read_toml::read(text),
        Format::Json => read_json::read(text),
    }
}

/// Reads and checks the text of a scenario; `name` is what messages call it.
///
/// # Errors
/// [`ScenarioError`] with everything that is wrong.
pub fn parse(text: &str, name: &str, format: Format) -> Result<Scenario, ScenarioError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    tree(text, format)
        .and_then(|root| check(&root, name))
        .map_err(|issues| ScenarioError::new(name, text, issues))
}

fn check(root: &Node, name: &str) -> Result<Scenario, Vec<Issue>> {
    let mut problems = Problems::new(root, Path::new(name).parent().unwrap_or(Path::new("")));
    let built = build(root, &mut problems);
    let echo = built.as_ref().map(|(input, _)| echo(input));
    let study = match (&built, &echo) {
        (Some((input, _)), Some(echo)) if problems.is_clean() => input
            .study
            .as_ref()
            .and_then(|study| vary::build(study, echo, &mut problems)),
        _ => None,
    };
    let (issues, warnings) = problems.finish();
    match (built, echo) {
        (Some((input, questions)), Some(echo)) if issues.is_empty() => Ok(Scenario {
            title: input.title.clone().unwrap_or_else(|| stem(name)),
            question: questions.question,
            model: questions.model,
            contact_choice: questions.contact_choice,
            oils: questions.oils,
            study,
            output: input.output,
            echo,
            warnings,
        }),
        _ => Err(issues),
    }
}

/// The tables of a tree and what they ask.
fn build(root: &Node, problems: &mut Problems<'_>) -> Option<(ScenarioInput, Questions)> {
    let value = walk::value(root, schema(), "", problems)?;
    let input = fill(value, problems)?;
    let questions = input.build(problems)?;
    Some((input, questions))
}

/// The structs of a value that the schema has passed.
fn fill(value: Value, problems: &mut Problems<'_>) -> Option<ScenarioInput> {
    serde_json::from_value(value)
        .map_err(|error| problems.add(Issue::new("", error.to_string())))
        .ok()
}

fn stem(name: &str) -> String {
    let stem = Path::new(name).file_stem();
    stem.map_or_else(
        || name.to_owned(),
        |stem| stem.to_string_lossy().into_owned(),
    )
}

/// The scenario as JSON, without the keys that are not given and have no default.
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
