//! A static question at many values of one number.

use crate::bearing::Around;
use crate::quasi_static::{QuasiStatic, StaticQuestion, answer_on};
use crate::rotor::{RotorError, build_supports};
use crate::study::plan::Variable;

/// One value and the question it makes.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyPoint {
    /// Value of the variable, SI.
    pub value: f64,
    /// The static question with this value.
    pub question: StaticQuestion,
}

/// A one-dimensional study.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Study {
    /// What varies.
    pub variable: Variable,
    /// Its values and questions, in the order given.
    pub(crate) points: Vec<StudyPoint>,
    /// Number of azimuths around a bearing that are evaluated, from +X on; where `None`, those of its
    /// balls.
    pub(crate) positions: Option<usize>,
    /// What the reader should know of the scenario whatever the value.
    pub(crate) warnings: Vec<String>,
}

/// The answer at one value.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct StudyRow {
    /// Value of the variable, SI.
    pub value: f64,
    /// The answer to the question with this value.
    pub answer: QuasiStatic,
    /// Every bearing all around.
    pub around: Vec<Vec<Around>>,
}

/// A value whose question has no answer.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{key} = {shown} {unit}: {source}")]
#[non_exhaustive]
pub struct StudyError {
    /// Key that varies.
    pub key: String,
    /// Its value in the unit that it was written in.
    pub shown: f64,
    /// That unit.
    pub unit: String,
    /// Why there is no answer.
    pub source: RotorError,
}

impl Study {
    /// The same with the warnings of the scenario; the questions keep those that it has not.
    pub(crate) fn with_warnings(mut self, warnings: &[String]) -> Self {
        for point in &mut self.points {
            let own = &mut point.question.rotor.warnings;
            own.retain(|warning| !warnings.contains(warning));
        }
        self.warnings = warnings.to_vec();
        self
    }

    /// What the reader should know: of the scenario, then at every value.
    pub(crate) fn warnings(&self, rows: &[StudyRow]) -> Vec<String> {
        let at_values = rows.iter().flat_map(|row| {
            let Variable {
                key, shown_unit, ..
            } = &self.variable;
            let place = format!("{key} = {} {shown_unit}", self.variable.shown(row.value));
            let warnings = row.answer.warnings.iter();
            warnings.map(move |warning| format!("{}: {warning}", place.trim_end()))
        });
        self.warnings.iter().cloned().chain(at_values).collect()
    }

    /// Answers the question at every value.
    ///
    /// # Errors
    /// [`StudyError`] names the first value that has no answer.
    pub fn run(&self) -> Result<Vec<StudyRow>, StudyError> {
        let answer = |point: &StudyPoint| {
            self.answer(point).map_err(|source| StudyError {
                key: self.variable.key.clone(),
                shown: self.variable.shown(point.value),
                unit: self.variable.shown_unit.clone(),
                source,
            })
        };
        self.points.iter().map(answer).collect()
    }

    fn answer(&self, point: &StudyPoint) -> Result<StudyRow, RotorError> {
        let rotor = &point.question.rotor;
        let supports = build_supports(rotor)?;
        let answer = answer_on(&point.question, &supports)?;
        let around = supports
            .iter()
            .map(|support| support.around(&answer.displacement, rotor.speed, self.positions))
            .collect();
        Ok(StudyRow {
            value: point.value,
            answer,
            around,
        })
    }
}
