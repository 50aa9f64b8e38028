//! Tables of numbers in every language that they are written in.
//!
//! Rows are written while the run goes on, in memory that does not grow with it.

#[cfg(feature = "parquet")]
mod parquet;

use std::io;
use std::io::Write;
use std::path::PathBuf;

use super::{FileAction, PartialFile, ReportError, RunFolder, WholeFile};
use crate::scenario::TableFormat;
use crate::table::{Column, ColumnKind};

#[cfg(feature = "parquet")]
pub use parquet::ParquetTable;

/// A number in the shortest form that reads back to the same value.
pub(in crate::report) fn number(value: f64) -> String {
    format!("{value:?}")
}

/// A number, or an empty cell.
pub(in crate::report) fn cell(value: Option<f64>) -> String {
    value.map(number).unwrap_or_default()
}

/// What a table comes from, named in the files that have room for it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Origin {
    /// The scenario with its defaults, JSON.
    pub scenario: String,
}

impl Origin {
    /// Version that writes the tables.
    pub const VERSION: &'static str = env!("CARGO_PKG_VERSION");
}

/// A table being written.
#[derive(Debug)]
pub(in crate::report) struct TableFiles(Vec<TableFile>);

/// A table being written in one format.
#[derive(Debug)]
struct TableFile {
    path: PathBuf,
    writer: TableWriter,
}

#[derive(Debug)]
enum TableWriter {
    Csv(CsvTable<PartialFile>),
    #[cfg(feature = "parquet")]
    Parquet(ParquetTable<PartialFile>),
}

impl TableFiles {
    /// Writes a whole table.
    pub fn write(
        folder: &RunFolder,
        stem: &str,
        columns: &[Column],
        rows: impl IntoIterator<Item = Vec<f64>>,
    ) -> Result<Vec<WholeFile>, ReportError> {
        let mut files = Self::open(folder, stem, columns)?;
        let written = rows.into_iter().try_for_each(|row| files.row(&row));
        written.map_err(ReportError::file(FileAction::Write, folder.path()))?;
        files.close()
    }

    /// Begins the table `stem` in every format that the folder has its tables in.
    pub fn open(folder: &RunFolder, stem: &str, columns: &[Column]) -> Result<Self, ReportError> {
        let open = |format: &TableFormat| TableFile::open(folder, stem, *format, columns);
        folder
            .formats
            .iter()
            .map(open)
            .collect::<Result<_, _>>()
            .map(Self)
    }

    /// Writes a row; what goes wrong is reported with the name of the file.
    pub fn row(&mut self, row: &[f64]) -> io::Result<()> {
        self.0.iter_mut().try_for_each(|file| file.row(row))
    }

    /// Ends the files.
    pub fn close(self) -> Result<Vec<WholeFile>, ReportError> {
        self.0.into_iter().map(TableFile::close).collect()
    }
}

impl TableFile {
    fn open(
        folder: &RunFolder,
        stem: &str,
        format: TableFormat,
        columns: &[Column],
    ) -> Result<Self, ReportError> {
        let name = format!("{stem}.{}", format.extension());
        let file = folder.create(&name)?;
        let path = file.path().to_owned();
        let writer = match format {
            TableFormat::Csv => CsvTable::new(file, columns).map(TableWriter::Csv),
            TableFormat::Parquet => parquet_table(file, columns, &folder.origin),
        };
        let writer = writer.map_err(ReportError::file(FileAction::Write, &path))?;
        Ok(Self { path, writer })
    }

    fn row(&mut self, row: &[f64]) -> io::Result<()> {
        let written = match &mut self.writer {
            TableWriter::Csv(table) => table.row(row),
            #[cfg(feature = "parquet")]
            TableWriter::Parquet(table) => table.row(row),
        };
        written.map_err(ReportError::named(&self.path))
    }

    fn close(self) -> Result<WholeFile, ReportError> {
        let finished = match self.writer {
            TableWriter::Csv(table) => table.finish(),
            #[cfg(feature = "parquet")]
            TableWriter::Parquet(table) => table.finish(),
        };
        finished
            .map_err(ReportError::file(FileAction::Write, &self.path))?
            .close()
    }
}

#[cfg(feature = "parquet")]
fn parquet_table(
    file: PartialFile,
    columns: &[Column],
    origin: &Origin,
) -> io::Result<TableWriter> {
    ParquetTable::new(file, columns, origin).map(TableWriter::Parquet)
}

#[cfg(not(feature = "parquet"))]
fn parquet_table(_: PartialFile, _: &[Column], _: &Origin) -> io::Result<TableWriter> {
    Err(io::ErrorKind::Unsupported.into())
}

/// Writes rows of numbers in the shortest form that reads back to the same value; a cell is empty where there is none.
#[derive(Debug)]
pub struct CsvTable<W: Write> {
    writer: W,
    kinds: Vec<ColumnKind>,
    /// Kept from row to row for its room.
    line: Vec<u8>,
}

impl<W: Write> CsvTable<W> {
    /// Writes the header.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn new(mut writer: W, columns: &[Column]) -> io::Result<Self> {
        let names: Vec<_> = columns.iter().map(Column::name).collect();
        writeln!(writer, "{}", names.join(","))?;
        Ok(Self {
            writer,
            kinds: columns.iter().map(|column| column.kind.clone()).collect(),
            line: Vec::new(),
        })
    }

    /// Writes a row, one number a column.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn row(&mut self, row: &[f64]) -> io::Result<()> {
        self.line.clear();
        for (value, kind) in row.iter().zip(&self.kinds) {
            write_cell(*value, kind, &mut self.line);
            self.line.push(b',');
        }
        if let Some(last) = self.line.last_mut() {
            *last = b'\n';
        }
        self.writer.write_all(&self.line)
    }

    /// Gives the writer back.
    ///
    /// # Errors
    /// What the writer answers.
    pub fn finish(mut self) -> io::Result<W> {
        self.writer.flush()?;
        Ok(self.writer)
    }
}

fn write_cell(value: f64, kind: &ColumnKind, line: &mut Vec<u8>) {
    match kind {
        ColumnKind::Word(_) => push_word(kind.word(value), line),
        _ if value.is_nan() => {}
        ColumnKind::Count => {
            // writing to a vector cannot fail
            let _ = write!(line, "{}", value as i64);
        }
        _ => {
            let mut digits = ryu::Buffer::new();
            line.extend_from_slice(digits.format(value).as_bytes());
        }
    }
}

/// A word, between quotes where it holds what separates cells.
fn push_word(word: &str, line: &mut Vec<u8>) {
    if !word.contains([',', '"', '\n', '\r']) {
        line.extend_from_slice(word.as_bytes());
        return;
    }
    line.push(b'"');
    line.extend_from_slice(word.replace('"', "\"\"").as_bytes());
    line.push(b'"');
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::table::Table;

    #[test]
    fn what_is_missing_is_an_empty_cell_and_words_may_hold_commas() {
        let rows = [(1.0, Some(0.1), "a, \"b\""), (2.0, None, "")];
        let table = Table::from_items(&rows)
            .count("n", |row| row.0)
            .number("x", "m", |row| row.1)
            .word("note", |row| row.2)
            .end();
        let mut csv = CsvTable::new(Vec::new(), &table.columns()).expect("memory takes everything");
        for row in table.rows() {
            csv.row(&row).expect("memory takes everything");
        }
        let csv = csv.finish().expect("memory takes everything");
        assert_eq!(csv, b"n,x_m,note\n1,0.1,\"a, \"\"b\"\"\"\n2,,\n");
    }

    #[test]
    fn numbers_keep_all_their_digits() -> Result<(), std::io::Error> {
        let columns = [Column::number("x", "m"), Column::count("balls")];
        let mut table = CsvTable::new(Vec::new(), &columns)?;
        table.row(&[0.1 + 0.2, 7.0])?;
        assert_eq!(table.finish()?, b"x_m,balls\n0.30000000000000004,7\n");
        Ok(())
    }
}
