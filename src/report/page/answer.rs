//! The page of any verb that answers: what it tells people, its figures and its tables.

use std::io::{self, Write};
use std::path::Path;

use serde_json::{Value, json};

use super::frame::Frame;
use crate::report::figure::Figure;
use crate::report::terminal::Lines;
use crate::report::{FileAction, ReportError, write_whole};
use crate::table::{ColumnKind, Table};

const SCRIPT: &str = include_str!("answer.js");

/// Most rows of a table that are shown.
const MOST_ROWS: usize = 200;

/// What a page shows of an answer.
#[derive(Debug, Clone, Copy)]
pub(in crate::report) struct AnswerPage<'a> {
    /// Title of the scenario.
    pub title: &'a str,
    /// File beside the page that holds all numbers.
    pub sealed: &'a str,
    /// What people are told.
    pub text: &'a Lines,
    /// The figures.
    pub figures: &'a [Figure],
    /// Tables by their names without ending.
    pub tables: &'a [(&'static str, Table<'static>)],
    /// The document that seals the files.
    pub document: &'a Value,
}

impl AnswerPage<'_> {
    /// Writes the page.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let data = json!({
            "jeffcott": env!("CARGO_PKG_VERSION"),
            "sealed": self.sealed,
            "parts": self.text.parts().collect::<Vec<_>>(),
            "warnings": self.document["warnings"],
            "figures": self.figures,
            "tables": self.tables.iter().map(|(name, table)| rows(name, table)).collect::<Value>(),
            "scenario": self.document["scenario"],
        });
        let frame = Frame {
            title: self.title,
            sealed: self.sealed,
            scripts: &[SCRIPT],
        };
        frame.write(&data, out)
    }

    /// Writes the page as a file that belongs to no set.
    ///
    /// # Errors
    /// [`ReportError::File`] where it cannot be written.
    pub fn write_alone(&self, file: &Path) -> Result<(), ReportError> {
        let mut text = Vec::new();
        let written = self.write(&mut text);
        written.map_err(ReportError::file(FileAction::Write, file))?;
        write_whole(file, &text)
    }
}

/// The first rows of a table, and how many there are.
fn rows(name: &str, table: &Table<'_>) -> Value {
    let columns = table.iter().map(|(column, values)| {
        let shown = values.iter().take(MOST_ROWS);
        let cell = |value: &f64| match &column.kind {
            ColumnKind::Word(words) => json!(words.get(*value as usize)),
            _ => json!(value),
        };
        json!({ "name": column, "cells": shown.map(cell).collect::<Value>() })
    });
    json!({
        "name": name,
        "columns": columns.collect::<Value>(),
        "rows": table.iter().next().map_or(0, |(_, values)| values.len()),
    })
}
