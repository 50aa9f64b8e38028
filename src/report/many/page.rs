//! `report.html`: what a study found, in one file that any browser opens from disk.

use std::io::{self, Write};

use serde_json::{Value, json};

use super::digest::Digest;
use crate::report::figure::Figure;
use crate::report::page::{Frame, figures_json};

const SCRIPT: &str = include_str!("page.js");

/// Most values of a list that are told.
const MOST_VALUES: usize = 20;
/// Columns of the table of runs that are shown beside those of the figures.
const ALWAYS_SHOWN: [&str; 2] = ["period_cycles", "measured_error"];

/// Writes the page of a study: its plan, its digest, its figures and its first runs.
///
/// It holds nothing that depends on threads, parts or the clock.
pub(super) fn write_page(
    title: &str,
    identity: &Value,
    digest: &Digest,
    figures: &[Figure],
    out: &mut impl Write,
) -> io::Result<()> {
    let data = json!({
        "title": title,
        "jeffcott": env!("CARGO_PKG_VERSION"),
        "study": shortened(identity["study"].clone()),
        "base": identity["base"],
        "axes": digest.axes,
        "labels": digest.labels.iter().map(|(label, _)| label.clone()).collect::<Value>(),
        "digest": digest.summary(),
        "shown": digest.shown().iter().map(|shown| digest.columns[shown.column].name.clone()).collect::<Value>(),
        "rows": first_rows(digest, !identity["study"]["sweep"].is_null()),
        "figures": figures_json(figures),
    });
    let frame = Frame {
        title,
        sealed: "runs.json",
        styles: "",
        scripts: &[SCRIPT],
    };
    frame.write(&data, out)
}

/// The study with its long lists cut off, and how long they are.
fn shortened(mut study: Value) -> Value {
    let axes = study["axis"].as_array_mut().into_iter().flatten();
    for axis in axes {
        if let Some(values) = axis["values"].as_array_mut() {
            let count = values.len();
            values.truncate(MOST_VALUES);
            axis["values_in_all"] = json!(count);
        }
    }
    study
}

/// The first runs with the columns that say most.
fn first_rows(digest: &Digest, swept: bool) -> Value {
    let start = 2 + digest.axes.len();
    let mut places: Vec<usize> = (0..start).filter(|k| swept || *k != 1).collect();
    let shown = digest.shown().into_iter().map(|shown| shown.column);
    let always = ALWAYS_SHOWN.iter().filter_map(|name| digest.column(name));
    for column in shown.chain(always) {
        if !places.contains(&(start + column)) {
            places.push(start + column);
        }
    }
    places.push(start + digest.columns.len());
    let cells = |row: &csv::StringRecord| -> Value {
        let cells = places.iter().map(|place| row.get(*place));
        cells.map(Option::unwrap_or_default).collect()
    };
    json!({
        "names": cells(&digest.names),
        "cells": digest.first.iter().map(cells).collect::<Value>(),
    })
}
