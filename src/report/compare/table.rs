//! A table of numbers, read row by row: a CSV file, or a spectrum in memory.

use std::fs::File;
use std::path::{Path, PathBuf};

use super::CompareError;
use crate::analysis::Spectrum;
use crate::report::spectrum::{spectrum_columns, spectrum_rows};

/// A table with a header and numbers below; of a file, one row is in memory at a time.
pub(super) struct Table {
    path: PathBuf,
    columns: Vec<String>,
    rows: Rows,
}

/// Where the rows come from.
enum Rows {
    File(Box<FileRows>),
    /// All numbers row by row, and how many of them are read.
    Memory(Vec<f64>, usize),
}

struct FileRows {
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
            rows: Rows::File(Box::new(FileRows {
                start: reader.position().clone(),
                reader,
                record: csv::StringRecord::new(),
            })),
        })
    }

    /// The table of a spectrum, as its file would be; `name` is what messages call it.
    pub fn of_spectrum(name: &str, spectrum: &Spectrum) -> Self {
        let columns = spectrum_columns(spectrum).into_iter();
        let mut numbers = Vec::new();
        // keeping rows cannot fail
        let _ = spectrum_rows(spectrum, |row| {
            numbers.extend_from_slice(row);
            Ok(())
        });
        Self {
            path: PathBuf::from(name),
            columns: columns.map(|column| column.name.into_owned()).collect(),
            rows: Rows::Memory(numbers, 0),
        }
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
        match &mut self.rows {
            Rows::Memory(_, read) => {
                *read = 0;
                Ok(())
            }
            Rows::File(rows) => {
                let start = rows.start.clone();
                let sought = rows.reader.seek(start);
                sought.map_err(|source| bad_csv(&self.path, source))
            }
        }
    }

    /// Reads the next row into `row`; `false` at the end.
    pub fn read(&mut self, row: &mut Vec<f64>) -> Result<bool, CompareError> {
        row.clear();
        match &mut self.rows {
            Rows::Memory(numbers, read) => {
                let rest = numbers.get(*read..).unwrap_or_default();
                row.extend(rest.iter().take(self.columns.len()));
                *read += row.len();
                Ok(!row.is_empty())
            }
            Rows::File(rows) => rows.read(&self.path, &self.columns, row),
        }
    }
}

impl FileRows {
    fn read(
        &mut self,
        path: &Path,
        columns: &[String],
        row: &mut Vec<f64>,
    ) -> Result<bool, CompareError> {
        let more = self.reader.read_record(&mut self.record);
        if !more.map_err(|source| bad_csv(path, source))? {
            return Ok(false);
        }
        for (text, column) in self.record.iter().zip(columns) {
            // an empty cell is a value that is missing
            let number = match text {
                "" => Ok(f64::NAN),
                text => text.parse(),
            };
            row.push(number.map_err(|_| CompareError::Number {
                path: path.to_owned(),
                line: self.record.position().map_or(0, csv::Position::line),
                column: column.clone(),
                text: text.to_owned(),
            })?);
        }
        Ok(true)
    }
}

/// A failure to read is told apart from a file that is not CSV.
pub(super) fn bad_csv(path: &Path, source: csv::Error) -> CompareError {
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
