//! A table that is compared: a CSV file, or a spectrum.

use std::collections::HashSet;
use std::fs::File;
use std::path::{Path, PathBuf};

use super::words::Words;
use super::{CompareError, Difference};
use crate::analysis::Spectrum;
use crate::record::open_regular;
use crate::report::spectra::spectrum_table;
use crate::table::{Column, Table};

/// Most bytes of a file.
const LARGEST: u64 = 4 << 30;

/// A table of numbers, of at least one row, and where it comes from.
pub(super) struct Source<'a> {
    /// Its file, or what messages call it.
    pub path: PathBuf,
    pub table: Table<'a>,
    /// Its columns of words.
    pub words: Vec<Words>,
}

impl Source<'static> {
    /// Reads a file.
    pub fn open(path: &Path) -> Result<Self, CompareError> {
        let bad = |source| bad_csv(path, source);
        let mut reader = reader(path)?;
        let names = reader.headers().map_err(bad)?.clone();
        let mut earlier = HashSet::new();
        if let Some(twice) = names.iter().find(|name| !earlier.insert(*name)) {
            return Err(CompareError::Duplicate {
                path: path.to_owned(),
                column: twice.to_owned(),
            });
        }
        let mut columns: Vec<_> = names.iter().map(Cells::of_nothing).collect();
        for record in reader.records() {
            let record = record.map_err(bad)?;
            let line = record.position().map_or(0, csv::Position::line);
            for (column, text) in columns.iter_mut().zip(&record) {
                column.push(path, line, text)?;
            }
        }
        let mut source = Self {
            path: path.to_owned(),
            table: Table::default(),
            words: Vec::new(),
        };
        for column in columns {
            match column {
                Cells::Words(words) => source.words.push(words),
                Cells::Numbers(name, values) => source.table.add(Column::from_name(name), values),
            }
        }
        let axis = source.table.iter().next();
        match axis.is_none_or(|(_, values)| values.is_empty()) {
            true => Err(CompareError::Empty { path: source.path }),
            false => Ok(source),
        }
    }
}

impl<'a> Source<'a> {
    /// The table of a spectrum, as its file would be; `name` is what messages call it.
    pub fn of_spectrum(name: &str, spectrum: &'a Spectrum) -> Self {
        Self {
            path: PathBuf::from(name),
            table: spectrum_table(spectrum),
            words: Vec::new(),
        }
    }

    /// The columns.
    pub fn columns(&self) -> impl Iterator<Item = &Column> {
        self.table.iter().map(|(column, _)| column)
    }

    /// The first column: times, frequencies or orders.
    pub fn axis(&self) -> (&Column, &[f64]) {
        let first = self.table.iter().next();
        first.expect("a table that is compared has a column")
    }

    /// Values of a column that it has.
    pub fn values(&self, column: &Column) -> Option<&[f64]> {
        let found = self.table.iter().find(|(known, _)| *known == column);
        found.map(|(_, values)| values)
    }

    /// Whether it has a column of a name.
    pub fn knows(&self, name: &str) -> bool {
        let mut columns = self.columns();
        self.words.iter().any(|own| own.name == name) || columns.any(|own| own.name() == name)
    }

    /// The word of a row in a column; empty where there is none.
    pub fn word(&self, name: &str, row: usize) -> &str {
        let words = self.words.iter().find(|own| own.name == name);
        let cell = words.and_then(|own| own.cells.get(row));
        cell.map_or("", String::as_str)
    }

    /// Largest finite magnitude of a column; zero where there is none.
    pub fn largest(&self, column: &Column) -> f64 {
        self.largest_at(column, |_| true)
    }

    /// Largest finite magnitude of a column at places of the axis; zero where there is none.
    pub fn largest_at(&self, column: &Column, counts: impl Fn(f64) -> bool) -> f64 {
        let values = self.values(column).unwrap_or_default().iter();
        let places = values.zip(self.axis().1);
        let sizes = places.map(|(value, place)| (value.abs(), *place));
        let sizes = sizes.filter(|(size, place)| size.is_finite() && counts(*place));
        sizes.map(|(size, _)| size).fold(0.0, f64::max)
    }

    /// Columns that count and that only one of two tables has.
    pub fn alone(both: &[Self; 2], counts: fn(&Column) -> bool) -> Vec<Difference> {
        let [first, second] = both;
        let alone = |own: &Self, other: &Self| {
            let words = own.words.iter().map(|words| Column::from_name(&words.name));
            let columns = own.columns().cloned().chain(words);
            let names = columns.filter(counts).map(|column| column.name());
            let names: Vec<_> = names.filter(|name| !other.knows(name)).collect();
            let noun = if names.len() == 1 {
                "column"
            } else {
                "columns"
            };
            let (path, listed) = (own.path.display(), names.join(", "));
            (!names.is_empty())
                .then(|| Difference::partial(format!("only {path} has the {noun} {listed}")))
        };
        let both = [alone(first, second), alone(second, first)];
        both.into_iter().flatten().collect()
    }

    /// The columns of both tables, in the order of the first.
    pub fn known([first, second]: &[Self; 2]) -> Vec<Column> {
        let further = second.columns();
        let further = further.filter(|column| first.values(column).is_none());
        first.columns().chain(further).cloned().collect()
    }
}

/// Reads the rows of a CSV file.
fn reader(path: &Path) -> Result<csv::Reader<File>, CompareError> {
    let file = open_regular(path, LARGEST).map_err(|source| CompareError::Read {
        path: path.to_owned(),
        source,
    })?;
    let mut builder = csv::ReaderBuilder::new();
    Ok(builder.trim(csv::Trim::All).from_reader(file))
}

/// What a column has been found to hold.
enum Cells<'a> {
    /// Its name, and a number a row, NaN where a cell is empty.
    Numbers(&'a str, Vec<f64>),
    Words(Words),
}

impl<'a> Cells<'a> {
    fn of_nothing(name: &'a str) -> Self {
        Self::Numbers(name, Vec::new())
    }

    /// Takes the next cell: a word where there is no number above it.
    fn push(&mut self, path: &Path, line: u64, text: &str) -> Result<(), CompareError> {
        let (name, values) = match self {
            Self::Words(words) => {
                words.cells.push(text.to_owned());
                return Ok(());
            }
            Self::Numbers(name, values) => (*name, values),
        };
        if text.is_empty() {
            values.push(f64::NAN);
            return Ok(());
        }
        if let Ok(number) = text.parse() {
            values.push(number);
            return Ok(());
        }
        if values.iter().any(|value| !value.is_nan()) {
            return Err(CompareError::Number {
                path: path.to_owned(),
                line,
                column: name.to_owned(),
                text: text.to_owned(),
            });
        }
        let mut cells = vec![String::new(); values.len()];
        cells.push(text.to_owned());
        let name = name.to_owned();
        *self = Self::Words(Words { name, line, cells });
        Ok(())
    }
}

/// A failure to read is told apart from a file that is not CSV.
fn bad_csv(path: &Path, source: csv::Error) -> CompareError {
    let path = path.to_owned();
    if !source.is_io_error() {
        return CompareError::Csv { path, source };
    }
    CompareError::Read {
        path,
        source: source.into(),
    }
}
