//! A trace of this program as Parquet: columns of numbers with its names.

use std::panic::catch_unwind;

use ::bytes::Bytes as Shared;
use ::parquet::errors::{ParquetError, Result};
use ::parquet::file::reader::{FileReader, SerializedFileReader};
use ::parquet::record::Field;

use super::bytes::Bytes;
use super::text::{Heading, add};
use super::{Problem, Record};

/// Names of columns, with their numbers.
type Columns = Vec<(String, Vec<f64>)>;

/// Reads the columns of numbers; of those of words all are missing.
pub(super) fn read(record: &mut Record, mut bytes: Bytes<'_>) -> Result<(), Problem> {
    let bytes = bytes.take(bytes.left())?;
    // the library panics at some contradictions between pages
    let read = catch_unwind(|| columns(bytes));
    let panicked = |_| {
        Err(ParquetError::General(
            "its pages contradict each other".to_owned(),
        ))
    };
    let columns = read.unwrap_or_else(panicked);
    let columns = columns.map_err(|error| {
        Problem::Unfit(format!(
            "{error}; write the table without compression, or as CSV"
        ))
    })?;
    let (names, values): (Vec<_>, _) = columns.into_iter().unzip();
    let headings = names.iter().map(|name| Heading::of_trace(name));
    add(record, headings.collect(), values)
}

fn columns(bytes: Vec<u8>) -> Result<Columns> {
    let reader = SerializedFileReader::new(Shared::from(bytes))?;
    let schema = reader.metadata().file_metadata().schema_descr_ptr();
    let named = schema
        .columns()
        .iter()
        .map(|it| (it.name().to_owned(), Vec::new()));
    let mut columns: Columns = named.collect();
    for row in reader.get_row_iter(None)? {
        let row = row?;
        for ((_, values), (_, field)) in columns.iter_mut().zip(row.get_column_iter()) {
            values.push(match field {
                Field::Double(value) => *value,
                Field::Float(value) => f64::from(*value),
                Field::Int(value) => f64::from(*value),
                Field::Long(value) => *value as f64,
                _ => f64::NAN,
            });
        }
    }
    Ok(columns)
}
