//! Compares two files, or the tables of two run folders.

use std::fs;
use std::path::Path;

use super::events::{compare_events, is_events};
use super::lines::{compare_lines, is_spectrum};
use super::rows::compare_rows;
use super::table::Table;
use super::{CompareError, Difference, Rules, TableComparison};

/// Tables of a run folder.
const TABLES: [&str; 3] = ["trace.csv", "spectrum.csv", "events.csv"];
/// Those that are compared by lines.
const SPECTRA: [&str; 1] = ["spectrum.csv"];

/// What the comparison of two results found; shown as a table by `Display`.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Comparison {
    /// Tables that both results have.
    pub tables: Vec<TableComparison>,
    /// Files that only one of the results has.
    pub differences: Vec<Difference>,
    /// Files that only one of the results has and that are not asked for.
    pub left_out: Vec<Difference>,
}

impl Comparison {
    /// Whether both results have the same tables and all their values agree.
    pub fn agrees(&self) -> bool {
        self.differences.is_empty() && self.tables.iter().all(TableComparison::agrees)
    }
}

/// Compares two CSV files, or `trace.csv`, `spectrum.csv` and `events.csv` of two run folders.
///
/// # Errors
/// [`CompareError`] where there is nothing to compare; that results differ is no error.
pub fn compare(first: &Path, second: &Path, rules: &Rules) -> Result<Comparison, CompareError> {
    for path in [first, second] {
        fs::metadata(path).map_err(|source| CompareError::Read {
            path: path.to_owned(),
            source,
        })?;
    }
    let comparison = match (first.is_dir(), second.is_dir()) {
        (true, true) => compare_folders(first, second, rules)?,
        (false, false) => {
            let name = first.display().to_string();
            Comparison::of(compare_files(name, [first, second], rules)?)
        }
        (true, false) => return Err(folder_and_file(first, second)),
        (false, true) => return Err(folder_and_file(second, first)),
    };
    comparison.check_names(rules)?;
    Ok(comparison)
}

/// Compares two files of whatever they hold; `name` is what the result calls them.
fn compare_files(
    name: String,
    paths: [&Path; 2],
    rules: &Rules,
) -> Result<TableComparison, CompareError> {
    if paths.iter().all(|path| is_events(path)) {
        return compare_events(name, paths, rules);
    }
    let tables = [Table::open(paths[0])?, Table::open(paths[1])?];
    compare_tables(name, tables, rules)
}

/// Compares two tables of numbers, by lines where that is asked for.
pub(super) fn compare_tables(
    name: String,
    tables: [Table; 2],
    rules: &Rules,
) -> Result<TableComparison, CompareError> {
    let Some(count) = rules.lines else {
        return compare_rows(name, tables, rules);
    };
    match tables.iter().find(|table| !is_spectrum(table)) {
        Some(table) => Err(CompareError::NoLines {
            path: table.path().to_owned(),
        }),
        None => compare_lines(name, tables, count, rules),
    }
}

fn folder_and_file(folder: &Path, file: &Path) -> CompareError {
    CompareError::FolderAndFile {
        folder: folder.to_owned(),
        file: file.to_owned(),
    }
}

fn compare_folders(first: &Path, second: &Path, rules: &Rules) -> Result<Comparison, CompareError> {
    let (mut tables, mut partial) = (Vec::new(), Vec::new());
    let names = if rules.lines.is_some() {
        &SPECTRA[..]
    } else {
        &TABLES[..]
    };
    for name in names {
        let (left, right) = (first.join(name), second.join(name));
        match (left.exists(), right.exists()) {
            (true, true) => tables.push(compare_files((*name).to_owned(), [&left, &right], rules)?),
            (true, false) => partial.push(Difference::File { only: left }),
            (false, true) => partial.push(Difference::File { only: right }),
            (false, false) => {}
        }
    }
    if tables.is_empty() && (partial.is_empty() || rules.common) {
        return Err(CompareError::NoTables {
            first: first.to_owned(),
            second: second.to_owned(),
            names: names.join(", "),
        });
    }
    let (differences, left_out) = if rules.common {
        (Vec::new(), partial)
    } else {
        (partial, Vec::new())
    };
    Ok(Comparison {
        tables,
        differences,
        left_out,
    })
}

impl Comparison {
    /// The comparison of two tables alone.
    pub(super) fn of(table: TableComparison) -> Self {
        Self {
            tables: vec![table],
            differences: Vec::new(),
            left_out: Vec::new(),
        }
    }

    /// A tolerance for a column that does not exist is a slip of the pen that would hide a difference.
    pub(super) fn check_names(&self, rules: &Rules) -> Result<(), CompareError> {
        let known = || self.tables.iter().flat_map(|table| &table.known);
        for name in rules.tolerances.named() {
            if !known().any(|column| column == name) {
                return Err(CompareError::UnknownColumn {
                    name: name.to_owned(),
                    known: known().cloned().collect(),
                });
            }
        }
        Ok(())
    }
}
