//! `report.html`: what a study found, in one file that any browser opens from disk.

use std::io::{self, Write};

use serde_json::{Value, json};

use super::digest::Digest;
use super::tables::{run_names, run_row};
use crate::report::FileSet;
use crate::report::figure::Figure;
use crate::report::page::Frame;
use crate::report::variable::{axis_label, variable_column};

const SCRIPT: &str = include_str!("page.js");

/// Most values of a list that are told.
const MOST_VALUES: usize = 20;
/// Columns of the table of runs that are shown beside those of the figures.
const ALWAYS_SHOWN: [&str; 2] = ["period_cycles", "measured_error"];

/// Writes the page of a study: its plan, its digest, its figures and its first runs.
///
/// It holds nothing that depends on threads, parts or the clock.
pub(super) fn write_page(
    digest: &Digest,
    figures: &[Figure],
    out: &mut impl Write,
) -> io::Result<()> {
    let head = &digest.head;
    let shown = digest.shown().into_iter();
    let shown: Vec<_> = shown.map(|shown| &head.numbers[shown.column]).collect();
    let data = json!({
        "title": head.title,
        "jeffcott": head.jeffcott,
        "study": shortened(head.study.clone()),
        "base": head.base,
        "axes": head.axes.iter().map(|axis| variable_column(axis).name()).collect::<Value>(),
        "labels": head.axes.iter().map(axis_label).collect::<Vec<_>>(),
        "digest": digest.json(),
        "shown": shown,
        "rows": first_rows(digest),
        "figures": figures,
    });
    let frame = Frame {
        title: &head.title,
        sealed: FileSet::RUNS.seal,
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
fn first_rows(digest: &Digest) -> Value {
    let head = &digest.head;
    let start = 2 + head.axes.len();
    let mut places: Vec<usize> = (0..start).filter(|k| head.swept || *k != 1).collect();
    let shown = digest.shown().into_iter().map(|shown| shown.column);
    let always = ALWAYS_SHOWN.iter().filter_map(|name| digest.column(name));
    for column in shown.chain(always) {
        if !places.contains(&(start + column)) {
            places.push(start + column);
        }
    }
    places.push(start + digest.columns.len());
    let cells = |row: Vec<String>| -> Value { places.iter().map(|place| &*row[*place]).collect() };
    let rows = digest.first.iter().map(|row| run_row(head, row));
    json!({ "names": cells(run_names(head)), "cells": rows.map(cells).collect::<Value>() })
}
