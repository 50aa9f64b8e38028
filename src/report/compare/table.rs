//! Reads a CSV table of numbers row by row.

use std::fs::File;
use std::path::{Path, PathBuf};

use super::CompareError;

/// A CSV file with a header line and numbers below, of which one row is in memory at a time.
pub(super) struct Table {
    path: PathBuf,
    columns: Vec<String>,
    reader: csv::Reader<File>,
    /// Place of the first row.
    start: csv::Position,
    record: csv::StringRecord,
}

impl Table {
    /// Opens the file and reads its header.
    pub fn open(path: &Path) -> Result<Self, CompareError> {
        let file = File::open(path).map_err(|source| CompareError::Read {
            path: path.to_owned(),
            source,
        })?;
        let mut reader = csv::ReaderBuilder::new()
            .trim(csv::Trim::All)
            .from_reader(file);
        let header = reader.headers().map_err(|source| bad_csv(path, source))?;
        let columns: Vec<String> = header.iter().map(str::to_owned).collect();
        if columns.is_empty() {
            return Err(CompareError::Empty {
                path: path.to_owned(),
            });
        }
        if let Some(column) = first_duplicate(&columns) {
            return Err(CompareError::Duplicate {
                path: path.to_owned(),
                column: column.to_owned(),
            });
        }
        Ok(Self {
            path: path.to_owned(),
            columns,
            start: reader.position().clone(),
            reader,
            record: csv::StringRecord::new(),
        })
    }

    /// Names of the columns.
    pub fn columns(&self) -> &[String] {
        &self.columns
    }

    /// Path of the file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Goes back to the first row; a pipe cannot.
    pub fn rewind(&mut self) -> Result<(), CompareError> {
        let start = self.start.clone();
        self.reader
            .seek(start)
            .map_err(|source| bad_csv(&self.path, source))
    }

    /// Reads the next row into `row`; `false` at the end.
    pub fn read(&mut self, row: &mut Vec<f64>) -> Result<bool, CompareError> {
        row.clear();
        let more = self.reader.read_record(&mut self.record);
        if !more.map_err(|source| bad_csv(&self.path, source))? {
            return Ok(false);
        }
        for (text, column) in self.record.iter().zip(&self.columns) {
            let number = text.parse().map_err(|_| CompareError::Number {
                path: self.path.clone(),
                line: self.record.position().map_or(0, csv::Position::line),
                column: column.clone(),
                text: text.to_owned(),
            })?;
            row.push(number);
        }
        Ok(true)
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

fn first_duplicate(columns: &[String]) -> Option<&str> {
    let mut earlier = std::collections::HashSet::new();
    columns
        .iter()
        .map(String::as_str)
        .find(|column| !earlier.insert(*column))
}
