//! A table in all the formats that are asked for, as files of a run folder.

use std::io;
use std::path::PathBuf;

#[cfg(feature = "parquet")]
use super::ParquetTable;
use super::{Column, CsvTable, MatTable};
use crate::report::{FileAction, PartialFile, ReportError, RunFolder, WholeFile};
use crate::scenario::TableFormat;

/// What a table comes from, told in the files that have room for it.
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
    Mat(MatTable<PartialFile>),
}

impl TableFiles {
    /// Begins the table `stem` in every format that the folder has its tables in.
    pub fn open(folder: &RunFolder, stem: &str, columns: &[Column]) -> Result<Self, ReportError> {
        let (formats, origin) = folder.tables();
        let open = |format: &TableFormat| TableFile::open(folder, stem, *format, columns, origin);
        formats.iter().map(open).collect::<Result<_, _>>().map(Self)
    }

    /// Writes a row; what goes wrong is told with the name of the file.
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
        origin: &Origin,
    ) -> Result<Self, ReportError> {
        let name = format!("{stem}.{}", format.extension());
        let file = folder.create(&name)?;
        let path = file.path().to_owned();
        let writer = match format {
            TableFormat::Csv => CsvTable::new(file, columns).map(TableWriter::Csv),
            #[cfg(feature = "parquet")]
            TableFormat::Parquet => {
                ParquetTable::new(file, columns, origin).map(TableWriter::Parquet)
            }
            #[cfg(not(feature = "parquet"))]
            TableFormat::Parquet => Err(io::Error::from(io::ErrorKind::Unsupported)),
            TableFormat::Mat => {
                let rows = folder.path().join(format!(".{name}.rows.partial"));
                MatTable::new(file, columns, origin, &rows).map(TableWriter::Mat)
            }
        };
        let writer = writer.map_err(ReportError::file(FileAction::Write, &path))?;
        Ok(Self { path, writer })
    }

    fn row(&mut self, row: &[f64]) -> io::Result<()> {
        let written = match &mut self.writer {
            TableWriter::Csv(table) => table.row(row),
            #[cfg(feature = "parquet")]
            TableWriter::Parquet(table) => table.row(row),
            TableWriter::Mat(table) => table.row(row),
        };
        written.map_err(|error| {
            let kind = error.kind();
            let named = ReportError::file(FileAction::Write, &self.path)(error);
            io::Error::new(kind, named)
        })
    }

    fn close(self) -> Result<WholeFile, ReportError> {
        let finished = match self.writer {
            TableWriter::Csv(table) => table.finish(),
            #[cfg(feature = "parquet")]
            TableWriter::Parquet(table) => table.finish(),
            TableWriter::Mat(table) => table.finish(),
        };
        finished
            .map_err(ReportError::file(FileAction::Write, &self.path))?
            .close()
    }
}
