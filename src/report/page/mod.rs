//! The page of an answer: one file that any browser opens from disk, without a network.
//!
//! Its data are the document of the answer, what people are told and the figures, as JSON that the scripts in it read.

use std::io::{self, Write};
use std::path::Path;

use serde_json::{Value, json};

use super::figure::{Figure, Label, escaped, heading};
use super::terminal::{Lines, shown_column};
use super::{FileAction, ReportError, write_whole};
use crate::table::{ColumnKind, Table};

const FRAME: &str = include_str!("page.html");
const STYLE: &str = include_str!("page.css");

/// In order, each building on those before it.
const SCRIPTS: [&str; 6] = [
    include_str!("frame.js"),
    include_str!("pen.js"),
    include_str!("figure.js"),
    include_str!("reading.js"),
    include_str!("film.js"),
    include_str!("page.js"),
];

/// Most rows of a table that are shown.
const MOST_ROWS: usize = 200;

/// What a page shows.
#[derive(Debug, Clone, Copy)]
pub(super) struct Page<'a> {
    /// Its title, any text.
    pub title: &'a str,
    /// File beside the page that holds all numbers.
    pub sealed: &'a str,
    /// What people are told.
    pub text: &'a Lines,
    /// The figures.
    pub figures: &'a [Figure],
    /// The end of a run in motion.
    pub film: Option<&'a Value>,
    /// Tables by their names without ending.
    pub tables: &'a [(&'static str, Table<'static>)],
    /// The document of the answer.
    pub document: &'a Value,
}

impl Page<'_> {
    /// Writes the page.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let data = json!({
            "document": self.document,
            "sealed": self.sealed,
            "parts": self.text.parts().collect::<Vec<_>>(),
            "figures": self.figures,
            "film": self.film,
            "tables": self.tables.iter().map(|(name, table)| rows(name, table)).collect::<Value>(),
        });
        let parts = [
            ("title", escaped(self.title)),
            ("sealed", escaped(self.sealed)),
            ("version", env!("CARGO_PKG_VERSION").to_owned()),
            ("style", STYLE.to_owned()),
            // no text in the data can end the element that holds it
            ("data", data.to_string().replace('<', "\\u003c")),
            ("script", SCRIPTS.concat()),
        ];
        fill(FRAME, &parts, out)
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
        let (label, factor) = shown_column(column);
        let cell = |value: &f64| match column.kind {
            ColumnKind::Count | ColumnKind::Word(_) => column.kind.json(*value),
            _ => json!(factor * value),
        };
        json!({ "name": Label::from(label).to_string(), "cells": shown.map(cell).collect::<Value>() })
    });
    json!({
        "name": name,
        "heading": table.heading.map_or_else(|| heading(name), str::to_owned),
        "columns": columns.collect::<Value>(),
        "rows": table.iter().next().map_or(0, |(_, values)| values.len()),
    })
}

/// Writes the frame with every `{{name}}` replaced by the part of that name.
fn fill(frame: &str, parts: &[(&str, String)], out: &mut impl Write) -> io::Result<()> {
    let mut pieces = frame.split("{{");
    out.write_all(pieces.next().unwrap_or_default().as_bytes())?;
    for piece in pieces {
        let (name, rest) = piece.split_once("}}").unwrap_or(("", piece));
        let part = parts.iter().find(|(part, _)| *part == name);
        if let Some((_, text)) = part {
            out.write_all(text.as_bytes())?;
        }
        out.write_all(rest.as_bytes())?;
    }
    Ok(())
}
