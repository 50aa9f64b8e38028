//! A study as JSON.

use serde_json::{Value, json};

use super::super::document::value;
use super::column_name;
use crate::bearing::Around;
use crate::study::{Study, StudyRow};

/// What a study is about: the scenario as it is, what varies and how often. The numbers are in the
/// tables beside it.
pub(super) fn cover(title: &str, scenario: &Value, study: &Study, rows: &[StudyRow]) -> Value {
    json!({
        "jeffcott": env!("CARGO_PKG_VERSION"),
        "title": title,
        "scenario": scenario,
        "varied": { "key": study.variable.key, "unit": study.variable.unit },
        "points": rows.len(),
    })
}

/// The whole study with every answer.
pub fn study_json(title: &str, scenario: &Value, study: &Study, rows: &[StudyRow]) -> Value {
    let varied = column_name(&study.variable);
    let mut whole = cover(title, scenario, study, rows);
    whole["rows"] = rows.iter().map(|found| row(&varied, found)).collect();
    whole
}

fn row(varied: &str, row: &StudyRow) -> Value {
    let mut entries = value(&row.answer);
    entries[varied] = row.value.into();
    let around = row.around.iter();
    entries["around"] = around
        .map(|places| places.iter().map(place).collect::<Value>())
        .collect();
    entries
}

fn place(place: &Around) -> Value {
    json!({
        "azimuth_rad": place.azimuth,
        "deformation_m": place.deformation,
        "load_inner_N": place.contact.load_inner,
        "load_outer_N": place.contact.load_outer,
        "angle_inner_rad": place.contact.angle_inner,
        "angle_outer_rad": place.contact.angle_outer,
    })
}
