//! A study as JSON.

use std::collections::BTreeMap;

use serde::Serialize;
use serde_json::Value;

use super::super::Destination;
use super::column_name;
use crate::bearing::Around;
use crate::quasi_static::QuasiStatic;
use crate::study::{Study, StudyRow};

/// What a study is about.
#[derive(Serialize)]
struct Cover<'a> {
    /// What varies.
    varied: Varied<'a>,
    /// How many values it has.
    points: usize,
}

/// A number of the scenario by its key.
#[derive(Serialize)]
struct Varied<'a> {
    key: &'a str,
    unit: &'a str,
}

/// The whole study.
#[derive(Serialize)]
struct Whole<'a> {
    #[serde(flatten)]
    cover: Cover<'a>,
    rows: Vec<RowSummary<'a>>,
}

/// The answer at a value.
#[derive(Serialize)]
struct RowSummary<'a> {
    #[serde(flatten)]
    answer: &'a QuasiStatic,
    /// The value, under the name of its column.
    #[serde(flatten)]
    value: BTreeMap<&'a str, f64>,
    /// Every bearing all around.
    around: &'a [Vec<Around>],
}

fn about<'a>(study: &'a Study, rows: &[StudyRow]) -> Cover<'a> {
    Cover {
        varied: Varied {
            key: &study.variable.key,
            unit: study.variable.unit,
        },
        points: rows.len(),
    }
}

/// What a study is about: the scenario as it is, what varies and how often. The numbers are in the
/// tables beside it.
pub(super) fn cover(destination: &Destination<'_>, study: &Study, rows: &[StudyRow]) -> Value {
    destination.document(about(study, rows))
}

/// The whole study with every answer.
pub fn study_json(destination: &Destination<'_>, study: &Study, rows: &[StudyRow]) -> Value {
    let varied = column_name(&study.variable);
    destination.document(Whole {
        cover: about(study, rows),
        rows: rows
            .iter()
            .map(|row| RowSummary {
                answer: &row.answer,
                value: BTreeMap::from([(varied.as_str(), row.value)]),
                around: &row.around,
            })
            .collect(),
    })
}
