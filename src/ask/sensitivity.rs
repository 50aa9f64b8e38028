//! How the numbers of an answer change with quantities of its scenario.

use std::num::NonZeroUsize;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::thread;

use super::AskError;
use crate::fit::{Answer, Effort, NamedLine, NoAnswer, Number, Point, Question, Work, slopes};
use crate::quasi_static::StaticQuestion;
use crate::report::SensitivityTable;
use crate::rotor::RotorDefinition;
use crate::scenario::{Issue, OpenScenario, Scenario};
use crate::simulate::Model;
use crate::study::Variable;
use crate::study::many::{NumberColumn, number_columns};

/// Steps of the differences, in parts of the values.
const STEP: f64 = 1e-3;
/// Tolerance that motions are found to at least: what it leaves is to be far below what a step changes.
const TOLERANCE: f64 = 1e-10;
/// Numbers that say how an answer was computed, and change with nothing in particular.
const OF_THE_SEARCH: [&str; 6] = [
    "condition",
    "residual",
    "period_cycles",
    "drift",
    "measured_error",
    "evaluations",
];
/// Lines of each displacement, besides the first orders of the shaft.
const LINES: usize = 3;

/// Quantities of a scenario by which the numbers of an answer are differentiated.
#[derive(Debug, Clone)]
pub struct Sensitivity {
    keys: OpenScenario,
    values: Vec<f64>,
    variables: Vec<Variable>,
}

/// Threads to work on where nobody says how many.
pub(super) fn all_threads() -> usize {
    thread::available_parallelism().map_or(1, NonZeroUsize::get)
}

impl Sensitivity {
    /// Asks by some keys of a scenario whose files are in `folder`; nothing where none is named.
    ///
    /// # Errors
    /// [`AskError::Asked`] where there is no such number, or it has no value to change.
    pub fn new(
        scenario: &Scenario,
        keys: &[String],
        folder: &Path,
    ) -> Result<Option<Self>, AskError> {
        if keys.is_empty() {
            return Ok(None);
        }
        let keys = OpenScenario::new(scenario, keys.iter().map(String::as_str), folder)?;
        let (values, variables) = keys.values()?.into_iter().unzip();
        let asked = Self {
            keys,
            values,
            variables,
        };
        let mut pairs = asked.values.iter().zip(&asked.variables);
        match pairs.find(|(value, variable)| **value == 0.0 && variable.unit != "rad") {
            Some((_, variable)) => {
                let path = &variable.key;
                let message = format!("`{path}` is zero: there is no part of it to change it by");
                let help = "give it a small value by --set";
                Err(Issue::new(path, message).help(help).into())
            }
            None => Ok(Some(asked)),
        }
    }

    /// The numbers of a run that are differentiated.
    pub(super) fn columns_of_run(rotor: &RotorDefinition) -> Vec<NumberColumn> {
        let mut columns = number_columns(rotor);
        columns.retain(|own| !own.on_request && !OF_THE_SEARCH.contains(&&*own.column.name()));
        columns
    }

    /// How fast the numbers change, of the question that is made of the scenario at values of the keys.
    ///
    /// # Errors
    /// [`AskError::Failed`] where the scenario itself has no answer, or it was to stop.
    pub(super) fn answer(
        &self,
        question: impl Fn(StaticQuestion, Option<Model>) -> Question + Sync,
        stop: &AtomicBool,
    ) -> Result<SensitivityTable, AskError> {
        let answer = |values: &[f64], near: Option<&Point>| {
            let asked = self.keys.asked(values);
            let (statics, model) = asked.map_err(|issue| NoAnswer::Failed(issue.to_string()))?;
            let model = model.map(exactly);
            let near = near.and_then(|near| near.orbits.first()?.as_ref());
            question(statics, model).answer(near, stop)
        };
        let here = answer(&self.values, None).map_err(AskError::failed)?;
        let (lines, numbers) = (strongest(&here.lines), names(&here));
        let point = |found: Answer| Point {
            numbers: numbers_of(&found, &numbers, &lines),
            orbits: vec![found.orbit],
        };
        let scene =
            |values: &[f64], near: Option<&Point>, _: Effort| answer(values, near).map(point);
        let at = point(here);
        let steps = self.values.iter().map(|value| match *value {
            0.0 => STEP,
            value => STEP * value.abs(),
        });
        let work = Work {
            threads: all_threads(),
            stop,
        };
        let bounds = vec![[f64::NEG_INFINITY, f64::INFINITY]; self.values.len()];
        let steps: Vec<f64> = steps.collect();
        let slopes = slopes(&scene, (&self.values, &at), &steps, &bounds, work);
        Ok(SensitivityTable {
            variables: self.variables.clone(),
            values: self.values.clone(),
            numbers: at.numbers,
            slopes: slopes.map_err(AskError::failed)?,
        })
    }
}

/// A motion without the measurement of its error, found more exactly.
fn exactly(mut model: Model) -> Model {
    model.verify = false;
    model.integrator.tolerance = model.integrator.tolerance.min(TOLERANCE);
    model
}

/// Names of the numbers that an answer has.
fn names(answer: &Answer) -> Vec<String> {
    let numbers = answer.numbers.iter();
    let has = numbers.filter(|own| own.value.is_finite() && !OF_THE_SEARCH.contains(&&*own.name));
    has.map(|own| own.name.clone()).collect()
}

/// The strongest lines of every displacement that is a length, without the first orders of the shaft.
fn strongest(lines: &[NamedLine]) -> Vec<NamedLine> {
    let mut found: Vec<NamedLine> = Vec::new();
    let is_numbered = |line: &NamedLine| ["1×", "2×", "3×"].contains(&&*line.name);
    let mut all: Vec<&NamedLine> = lines
        .iter()
        .filter(|line| line.channel.unit() == "m")
        .collect();
    all.retain(|line| !is_numbered(line));
    all.sort_by(|a, b| {
        let by_channel = a.channel.cmp(&b.channel);
        by_channel.then(b.amplitude.total_cmp(&a.amplitude))
    });
    for line in all {
        let same = found.iter().filter(|known| known.channel == line.channel);
        if same.count() < LINES {
            found.push(line.clone());
        }
    }
    found
}

/// Numbers by their names, then the amplitudes of lines; NaN of one that the answer does not have.
fn numbers_of(answer: &Answer, names: &[String], lines: &[NamedLine]) -> Vec<Number> {
    let missing = |name: &str, unit: &str| Number {
        name: name.to_owned(),
        unit: unit.to_owned(),
        value: f64::NAN,
        error: f64::NAN,
    };
    let number = |name: &String| {
        let found = answer.numbers.iter().find(|own| own.name == *name);
        found.cloned().unwrap_or_else(|| missing(name, ""))
    };
    let line = |line: &NamedLine| {
        let mut lines = answer.lines.iter();
        let found = lines.find(|own| own.channel == line.channel && own.name == line.name);
        Number {
            value: found.map_or(f64::NAN, |found| found.amplitude),
            ..missing(
                &format!("{} {}", line.channel, line.name),
                line.channel.unit(),
            )
        }
    };
    names
        .iter()
        .map(number)
        .chain(lines.iter().map(line))
        .collect()
}
