//! Why two results cannot be compared at all.

use std::error::Error;
use std::io;
use std::path::PathBuf;

/// Why two results cannot be compared at all; that they differ is not an error.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CompareError {
    /// A file cannot be opened or read.
    #[error("cannot read {}", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// The answer of the system.
        source: io::Error,
    },
    /// A file is not CSV.
    #[error("{} is not a table of comma-separated values", path.display())]
    Csv {
        /// The file.
        path: PathBuf,
        /// Where it breaks the form.
        source: csv::Error,
    },
    /// A file has no header or no row.
    #[error("{} has no rows of numbers to compare: a header line and at least one row are needed", path.display())]
    Empty {
        /// The file.
        path: PathBuf,
    },
    /// A folder holds no whole run.
    #[error(
        "{} has no summary.json of a whole run: give folders that `jeffcott run` has written to its end, or compare two \
         of their files",
        folder.display()
    )]
    Unsealed {
        /// The folder.
        folder: PathBuf,
    },
    /// Two columns have the same name.
    #[error("{} has two columns named {column:?}", path.display())]
    Duplicate {
        /// The file.
        path: PathBuf,
        /// Name of both.
        column: String,
    },
    /// A field is not a number.
    #[error("{}, line {line}, column {column:?}: {text:?} is not a number", path.display())]
    Number {
        /// The file.
        path: PathBuf,
        /// Line, from 1.
        line: u64,
        /// Name of the column.
        column: String,
        /// The text found there.
        text: String,
    },
    /// A tolerance is negative or not a number.
    #[error("the {kind} is {value}; it must be zero or positive and finite")]
    Tolerance {
        /// Which one, as `relative tolerance`.
        kind: &'static str,
        /// Value as given.
        value: f64,
    },
    /// A tolerance is given for a column that none of the tables has.
    #[error("no table has a column {name:?}; there are: {}", known.join(", "))]
    UnknownColumn {
        /// Name as given.
        name: String,
        /// Names of all columns.
        known: Vec<String>,
    },
    /// A folder was to be compared with a file.
    #[error("{} is a folder and {} is not: give two run folders or two files", folder.display(), file.display())]
    FolderAndFile {
        /// The folder.
        folder: PathBuf,
        /// The other.
        file: PathBuf,
    },
    /// Two folders hold no table.
    #[error("neither {} nor {} holds a table to compare ({names}), or no table is in both: give two files, as runs.csv of two studies", first.display(), second.display())]
    NoTables {
        /// First folder.
        first: PathBuf,
        /// Second folder.
        second: PathBuf,
        /// Names of the tables that are looked for.
        names: String,
    },
    /// A table that is to be compared by its lines is no spectrum.
    #[error("{} is no spectrum: lines need a column f_Hz first, and amplitudes", path.display())]
    NoLines {
        /// The file.
        path: PathBuf,
    },
    /// Lines are to be compared by name or order, and the results say neither.
    #[error("{} has no {what}: give folders of `jeffcott run` or `analyze`, at a known speed", path.display())]
    NoNames {
        /// The result.
        path: PathBuf,
        /// What is missing.
        what: &'static str,
    },
    /// No line of one result has a partner in the other.
    #[error("no line of {} is in {}, too", first.display(), second.display())]
    NoCommonLine {
        /// First result.
        first: PathBuf,
        /// Second result.
        second: PathBuf,
    },
    /// The results have nothing in common that could differ.
    #[error("nothing was compared: no column with numbers is in both besides the axis; there are: {}", columns.join(", "))]
    NothingCompared {
        /// Names of the columns of both.
        columns: Vec<String>,
    },
    /// A figure of the comparison cannot be drawn or written.
    #[error("the comparison is complete, but its figure could not be written")]
    Figure(#[from] crate::report::ReportError),
}

impl CompareError {
    /// The error and all its causes in one line.
    pub fn with_causes(&self) -> String {
        let causes = std::iter::successors(self.source(), |cause| (*cause).source());
        let causes: String = causes.map(|cause| format!(": {cause}")).collect();
        format!("{self}{causes}")
    }
}
