//! A load series in a CSV file: times and values with their units in the header.

use std::io;
use std::path::Path;

use crate::rotor::load::{Column, SeriesError};

/// Most bytes of a file.
const LARGEST: u64 = 512 << 20;
/// Name of the column of times.
const TIME: &str = "t_s";
/// Names of the columns of the freedoms, in their order.
const COLUMNS: [&str; 5] = ["x_N", "y_N", "z_N", "tilt_x_N_m", "tilt_y_N_m"];

/// Why a file holds no load series. Rows count from the first below the header.
#[derive(Debug, thiserror::Error)]
pub(super) enum SeriesFileError {
    #[error("it cannot be read: {0}")]
    Unreadable(#[from] io::Error),
    #[error("it is not a file")]
    NotAFile,
    #[error(
        "it has {} MB, and {} MB are the most that is kept in memory; give fewer rows, or divide it in time and run \
         the scenario for each part", bytes >> 20, LARGEST >> 20
    )]
    TooLarge { bytes: u64 },
    #[error("it is not CSV: {0}")]
    NotCsv(#[from] csv::Error),
    #[error("its first column must be `{TIME}`, not `{found}`")]
    NoTime { found: String },
    #[error("it has a column `{name}`; known are {TIME}, {}", COLUMNS.join(", "))]
    UnknownColumn { name: String },
    #[error("it has two columns `{name}`")]
    TwiceColumn { name: String },
    #[error("it has no column but `{TIME}`; add some of {}", COLUMNS.join(", "))]
    NoColumn,
    #[error("row {row} has {found} entries, the header {expected}")]
    Length {
        row: usize,
        found: usize,
        expected: usize,
    },
    #[error("row {row} has nothing in column `{column}`")]
    Gap { row: usize, column: String },
    #[error("row {row} has `{text}` in column `{column}`, which is not a number")]
    NotANumber {
        row: usize,
        column: String,
        text: String,
    },
    #[error(transparent)]
    Series(#[from] SeriesError),
}

/// Times in s and the columns beside them.
pub(super) fn read(path: &Path) -> Result<(Vec<f64>, Vec<Column>), SeriesFileError> {
    let known = std::fs::metadata(path)?;
    if !known.is_file() {
        return Err(SeriesFileError::NotAFile);
    }
    if known.len() > LARGEST {
        return Err(SeriesFileError::TooLarge { bytes: known.len() });
    }
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .flexible(true)
        .from_path(path)?;
    let header: Vec<String> = reader.headers()?.iter().map(str::to_owned).collect();
    let mut columns = columns(&header)?;
    let mut times = Vec::new();
    for (index, record) in reader.records().enumerate() {
        let (record, row) = (record?, index + 1);
        if record.len() != header.len() {
            return Err(SeriesFileError::Length {
                row,
                found: record.len(),
                expected: header.len(),
            });
        }
        let mut values = record.iter().zip(&header);
        let mut number = || values.next().map_or(Ok(0.0), |pair| number(pair, row));
        times.push(number()?);
        for column in &mut columns {
            column.values.push(number()?);
        }
    }
    Ok((times, columns))
}

/// The empty columns that a header promises.
fn columns(header: &[String]) -> Result<Vec<Column>, SeriesFileError> {
    // a file from a spreadsheet may begin with a byte order mark
    let first = header
        .first()
        .map_or("", |name| name.trim_start_matches('\u{feff}'));
    if first != TIME {
        let found = first.to_owned();
        return Err(SeriesFileError::NoTime { found });
    }
    let mut columns: Vec<Column> = Vec::new();
    for name in &header[1..] {
        let name = name.clone();
        let Some(axis) = COLUMNS.iter().position(|known| *known == name) else {
            return Err(SeriesFileError::UnknownColumn { name });
        };
        if columns.iter().any(|column| column.axis == axis) {
            return Err(SeriesFileError::TwiceColumn { name });
        }
        let values = Vec::new();
        columns.push(Column { axis, values });
    }
    if columns.is_empty() {
        return Err(SeriesFileError::NoColumn);
    }
    Ok(columns)
}

fn number((text, column): (&str, &String), row: usize) -> Result<f64, SeriesFileError> {
    let column = || column.clone();
    if text.is_empty() {
        let column = column();
        return Err(SeriesFileError::Gap { row, column });
    }
    text.parse().map_err(|_| SeriesFileError::NotANumber {
        row,
        column: column(),
        text: text.to_owned(),
    })
}
