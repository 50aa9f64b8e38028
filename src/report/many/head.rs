//! What every file of a study begins with.

use std::ops::Range;

use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

use super::identity::first_difference;
use crate::analysis::Channel;
use crate::study::Variable;
use crate::study::many::{Ask, Keep, Outcome, RunRecord, Shard};
use crate::table::Column;

/// The first line of a file of rows: the study, and all that its tables, figures and page say besides the rows.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StudyHead {
    /// Version of the program.
    pub jeffcott: String,
    /// Title of the study.
    pub title: String,
    /// The study with its defaults.
    pub study: Value,
    /// The scenario that its runs start from.
    pub base: Value,
    /// What it asks at every point.
    pub ask: Ask,
    /// Which part of it this is.
    pub shard: Shard,
    /// Numbers of the runs of the part.
    pub runs: Range<u64>,
    /// What varies, an entry an axis.
    pub axes: Vec<Variable>,
    /// The numbers of every run.
    pub numbers: Vec<Column>,
    /// The displacements that move.
    pub displacements: Vec<Channel>,
    /// What is kept besides the numbers.
    pub keep: Keep,
    /// Names of the numbers that the study keeps, where it names any.
    pub named: Option<Vec<String>>,
    /// Whether the values were drawn instead of lying on a grid.
    pub drawn: bool,
}

impl StudyHead {
    /// What differs from another head, with both values.
    pub(super) fn difference(&self, other: &Self) -> Option<[String; 3]> {
        first_difference(&json!(self), &json!(other))
    }

    /// The displacements that are lengths, each with its place among all.
    pub(super) fn lengths(&self) -> Vec<(usize, Channel)> {
        let all = self.displacements.iter().copied().enumerate();
        all.filter(|(_, channel)| channel.unit() == "m").collect()
    }

    /// Whether a row is one of its part, with all that belongs to it.
    pub(super) fn owns(&self, row: &RunRecord) -> bool {
        let moving = self.displacements.len();
        let is_whole = |outcome: &Outcome| {
            let mut lines = outcome.spectrum.iter();
            let mut points = outcome.points.iter();
            outcome.numbers.len() == self.numbers.len()
                && lines.all(|line| line.amplitudes.len() == moving)
                && points.all(|point| point.displacement.len() == moving)
        };
        self.runs.contains(&row.run)
            && row.values.len() == self.axes.len()
            && row.outcome.as_ref().map_or(true, is_whole)
    }
}

#[cfg(test)]
impl StudyHead {
    /// Of ten runs with a number each.
    pub(super) fn of_tests() -> Self {
        Self {
            jeffcott: "0".to_owned(),
            title: "a study".to_owned(),
            study: json!({ "seed": 1 }),
            base: Value::Null,
            ask: Ask::Run,
            shard: Shard::WHOLE,
            runs: 3..13,
            axes: Vec::new(),
            numbers: vec![Column::from_name("x_rms_m")],
            displacements: Vec::new(),
            keep: Keep::default(),
            named: None,
            drawn: false,
        }
    }
}
