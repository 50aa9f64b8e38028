//! Compares two files, or the tables of two run folders.

use std::fs;
use std::path::Path;

use super::rows::compare_tables;
use super::{CompareError, Difference, TableComparison, Tolerances};

/// Tables of a run folder.
const TABLES: [&str; 2] = ["trace.csv", "spectrum.csv"];

/// What the comparison of two results found; shown as a table by `Display`.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// Tables that both results have.
    pub tables: Vec<TableComparison>,
    /// Files that only one of the results has.
    pub differences: Vec<Difference>,
}

impl Comparison {
    /// Whether both results have the same tables and all their values agree.
    pub fn agrees(&self) -> bool {
        self.differences.is_empty() && self.tables.iter().all(TableComparison::agrees)
    }
}

/// Compares two CSV files, or `trace.csv` and `spectrum.csv` of two run folders.
///
/// # Errors
/// [`CompareError`] where there is nothing to compare; that results differ is no error.
pub fn compare(
    first: &Path,
    second: &Path,
    tolerances: &Tolerances,
) -> Result<Comparison, CompareError> {
    for path in [first, second] {
        fs::metadata(path).map_err(|source| CompareError::Read {
            path: path.to_owned(),
            source,
        })?;
    }
    let comparison = match (first.is_dir(), second.is_dir()) {
        (true, true) => compare_folders(first, second, tolerances)?,
        (false, false) => Comparison {
            tables: vec![compare_tables(
                first.display().to_string(),
                first,
                second,
                tolerances,
            )?],
            differences: Vec::new(),
        },
        (true, false) => return Err(folder_and_file(first, second)),
        (false, true) => return Err(folder_and_file(second, first)),
    };
    check_names(&comparison, tolerances)?;
    Ok(comparison)
}

fn folder_and_file(folder: &Path, file: &Path) -> CompareError {
    CompareError::FolderAndFile {
        folder: folder.to_owned(),
        file: file.to_owned(),
    }
}

fn compare_folders(
    first: &Path,
    second: &Path,
    tolerances: &Tolerances,
) -> Result<Comparison, CompareError> {
    let mut tables = Vec::new();
    let mut differences = Vec::new();
    for name in TABLES {
        let (left, right) = (first.join(name), second.join(name));
        match (left.exists(), right.exists()) {
            (true, true) => {
                tables.push(compare_tables(name.to_owned(), &left, &right, tolerances)?);
            }
            (true, false) => differences.push(Difference::File { only: left }),
            (false, true) => differences.push(Difference::File { only: right }),
            (false, false) => {}
        }
    }
    if tables.is_empty() && differences.is_empty() {
        return Err(CompareError::NoTables {
            first: first.to_owned(),
            second: second.to_owned(),
        });
    }
    Ok(Comparison {
        tables,
        differences,
    })
}

/// A tolerance for a column that does not exist is a slip of the pen that would hide a difference.
fn check_names(comparison: &Comparison, tolerances: &Tolerances) -> Result<(), CompareError> {
    let known = || comparison.tables.iter().flat_map(|table| &table.known);
    for name in tolerances.named() {
        if !known().any(|column| column == name) {
            return Err(CompareError::UnknownColumn {
                name: name.to_owned(),
                known: known().cloned().collect(),
            });
        }
    }
    Ok(())
}
