//! A table of numbers in memory: a CSV file, or a spectrum.

use std::collections::HashSet;
use std::fs::File;
use std::path::{Path, PathBuf};

use super::{CompareError, Difference};
use crate::analysis::Spectrum;
use crate::report::spectra::spectrum_table;
use crate::scenario::open_regular;

/// Most bytes of a file.
const LARGEST: u64 = 4 << 30;

/// A table with a header and numbers below, at least one row.
pub(super) struct Table {
    /// Its file, or what messages call it.
    pub path: PathBuf,
    /// Names of the columns.
    pub names: Vec<String>,
    /// Numbers column by column; NaN where one is missing.
    columns: Vec<Vec<f64>>,
}

impl Table {
    /// Reads a file.
    pub fn open(path: &Path) -> Result<Self, CompareError> {
        let bad = |source| bad_csv(path, source);
        let mut reader = reader(path)?;
        let header = reader.headers().map_err(bad)?;
        let names: Vec<String> = header.iter().map(str::to_owned).collect();
        let mut earlier = HashSet::new();
        if let Some(twice) = names.iter().find(|name| !earlier.insert(*name)) {
            return Err(CompareError::Duplicate {
                path: path.to_owned(),
                column: twice.clone(),
            });
        }
        let mut columns = vec![Vec::new(); names.len()];
        for record in reader.records() {
            let record = record.map_err(bad)?;
            for (place, column) in columns.iter_mut().enumerate() {
                column.push(number(path, &record, place, &names[place])?);
            }
        }
        if columns.first().is_none_or(Vec::is_empty) {
            return Err(CompareError::Empty {
                path: path.to_owned(),
            });
        }
        Ok(Self {
            path: path.to_owned(),
            names,
            columns,
        })
    }

    /// The table of a spectrum, as its file would be; `name` is what messages call it.
    pub fn of_spectrum(name: &str, spectrum: &Spectrum) -> Self {
        let table = spectrum_table(spectrum);
        let columns = table
            .iter()
            .map(|(column, values)| (column.name(), values.to_vec()));
        let (names, columns) = columns.unzip();
        Self {
            path: PathBuf::from(name),
            names,
            columns,
        }
    }

    /// The first column: times or frequencies.
    pub fn axis(&self) -> &[f64] {
        &self.columns[0]
    }

    /// A column by its name.
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        let place = self.names.iter().position(|known| known == name)?;
        Some(&self.columns[place])
    }

    /// Largest finite magnitude of a column; zero where there is none.
    pub fn largest(&self, name: &str) -> f64 {
        let values = self.column(name).unwrap_or_default().iter();
        let sizes = values.map(|value| value.abs());
        sizes.filter(|size| size.is_finite()).fold(0.0, f64::max)
    }

    /// Columns that count and that only one of two tables has.
    pub fn alone([first, second]: &[Self; 2], counts: fn(&str) -> bool) -> Vec<Difference> {
        let alone = |own: &Self, other: &Self| {
            let names = own.names.iter();
            let names = names.filter(|name| counts(name) && !other.names.contains(name));
            let path = own.path.display();
            let only = |name| Difference::partial(format!("only {path} has the column {name}"));
            names.map(only).collect::<Vec<_>>()
        };
        [alone(first, second), alone(second, first)].concat()
    }

    /// Names of the columns of both tables, in the order of the first.
    pub fn known([first, second]: &[Self; 2]) -> Vec<String> {
        let further = second.names.iter();
        let further = further.filter(|name| !first.names.contains(name));
        first.names.iter().chain(further).cloned().collect()
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

/// The number at a place of a row; an empty cell is a value that is missing.
fn number(
    path: &Path,
    record: &csv::StringRecord,
    place: usize,
    column: &str,
) -> Result<f64, CompareError> {
    let text = record.get(place).unwrap_or_default();
    if text.is_empty() {
        return Ok(f64::NAN);
    }
    text.parse().map_err(|_| CompareError::Number {
        path: path.to_owned(),
        line: record.position().map_or(0, csv::Position::line),
        column: column.to_owned(),
        text: text.to_owned(),
    })
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
