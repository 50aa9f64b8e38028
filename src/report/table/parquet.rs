//! A table as Parquet.

use std::io::{self, Write};
use std::sync::Arc;

use parquet::basic::{LogicalType, Repetition, Type as PhysicalType};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int32Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::{Type, TypePtr};

use super::Origin;
use crate::table::{Column, ColumnKind};

/// Numbers that are kept in memory: 8 MiB.
const GROUP: usize = 1 << 20;

/// Writes a table in row groups of about 8 MiB, plainly encoded; `jeffcott_version` and `scenario_json`
/// are in the metadata of the file.
///
/// Real numbers are of type DOUBLE, NaN where there is none; whole numbers are INT32, null where there is none; words UTF-8.
pub struct ParquetTable<W: Write + Send> {
    writer: SerializedFileWriter<W>,
    kinds: Vec<ColumnKind>,
    /// The row group being filled, column by column.
    group: Vec<Vec<f64>>,
    /// Rows of a whole group.
    rows: usize,
}

impl<W: Write + Send> std::fmt::Debug for ParquetTable<W> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("ParquetTable")
            .field("kinds", &self.kinds)
            .finish_non_exhaustive()
    }
}

impl<W: Write + Send> ParquetTable<W> {
    /// Begins the file.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn new(writer: W, columns: &[Column], origin: &Origin) -> io::Result<Self> {
        let texts = [
            ("jeffcott_version", Origin::VERSION),
            ("scenario_json", &origin.scenario),
        ];
        let texts = texts.map(|(key, text)| KeyValue::new(key.to_owned(), text.to_owned()));
        let properties = WriterProperties::builder()
            .set_dictionary_enabled(false)
            .set_key_value_metadata(Some(texts.to_vec()))
            .build();
        let schema = schema(columns).map_err(io::Error::other)?;
        let rows = GROUP / columns.len().max(1);
        Ok(Self {
            writer: SerializedFileWriter::new(writer, schema, Arc::new(properties))?,
            kinds: columns.iter().map(|column| column.kind.clone()).collect(),
            group: columns.iter().map(|_| Vec::with_capacity(rows)).collect(),
            rows,
        })
    }

    /// Takes a row, one number a column.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn row(&mut self, row: &[f64]) -> io::Result<()> {
        for (column, value) in self.group.iter_mut().zip(row) {
            column.push(*value);
        }
        if self
            .group
            .first()
            .is_some_and(|column| column.len() == self.rows)
        {
            self.write_group()?;
        }
        Ok(())
    }

    /// Writes what is left and gives the writer back.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn finish(mut self) -> io::Result<W> {
        if self.group.first().is_some_and(|column| !column.is_empty()) {
            self.write_group()?;
        }
        Ok(self.writer.into_inner()?)
    }

    fn write_group(&mut self) -> io::Result<()> {
        let mut group = self.writer.next_row_group()?;
        for (values, kind) in self.group.iter_mut().zip(&self.kinds) {
            if let Some(mut writer) = group.next_column()? {
                write_column(&mut writer, values, kind)?;
                writer.close()?;
            }
            values.clear();
        }
        group.close()?;
        Ok(())
    }
}

fn write_column(
    writer: &mut SerializedColumnWriter<'_>,
    values: &[f64],
    kind: &ColumnKind,
) -> Result<(), ParquetError> {
    match kind {
        ColumnKind::Count => {
            let there = values.iter().map(|value| i16::from(!value.is_nan()));
            let there: Vec<i16> = there.collect();
            let given = values.iter().filter(|value| !value.is_nan());
            let whole: Vec<i32> = given.map(|value| *value as i32).collect();
            writer
                .typed::<Int32Type>()
                .write_batch(&whole, Some(&there), None)?;
        }
        ColumnKind::Word(_) => {
            let words = values.iter().map(|value| kind.word(*value).into());
            let words: Vec<ByteArray> = words.collect();
            writer
                .typed::<ByteArrayType>()
                .write_batch(&words, None, None)?;
        }
        _ => {
            writer
                .typed::<DoubleType>()
                .write_batch(values, None, None)?;
        }
    }
    Ok(())
}

fn schema(columns: &[Column]) -> Result<TypePtr, ParquetError> {
    let fields: Result<Vec<TypePtr>, _> = columns.iter().map(field).collect();
    let schema = Type::group_type_builder("table").with_fields(fields?);
    schema.build().map(Arc::new)
}

fn field(column: &Column) -> Result<TypePtr, ParquetError> {
    let physical = match column.kind {
        ColumnKind::Count => PhysicalType::INT32,
        ColumnKind::Word(_) => PhysicalType::BYTE_ARRAY,
        _ => PhysicalType::DOUBLE,
    };
    let repetition = match column.kind {
        ColumnKind::Count => Repetition::OPTIONAL,
        _ => Repetition::REQUIRED,
    };
    let text = matches!(column.kind, ColumnKind::Word(_)).then_some(LogicalType::String);
    Type::primitive_type_builder(&column.name(), physical)
        .with_repetition(repetition)
        .with_logical_type(text)
        .build()
        .map(Arc::new)
}
