//! Whether two results say the same: tables (trace or spectrum) or whole run folders.
//!
//! Columns are matched by name and rows by number. Two values a, b of a column agree where
//!
//! ```text
//! |a − b| ≤ absolute + relative · max|column|        (maximum over both tables)
//! ```
//!
//! so that a zero crossing needs no exception. NaN agrees with NaN only, ∞ with the same ∞ only.
//! A phase (`…_phase_rad` beside `…_amplitude_…`) is compared modulo 2π and may turn by as much as
//! moves its phasor within the allowance of the amplitude, on top of its own:
//!
//! ```text
//! |Δφ| ≤ absolute + relative · π + (allowance of the amplitude)/amplitude
//! ```
//!
//! Where the amplitude is within its allowance of zero, the phase says nothing and is not compared.
//!
//! Of a trace that was thinned while it was written, every row is compared with the one of the same
//! time. Spectra can be compared by their lines instead of row by row.
//!
//! ```no_run
//! use jeffcott::report::compare::{Rules, Tolerance, Tolerances, compare};
//! let rules = Rules::new(Tolerances::uniform(Tolerance::new(1e-6, 0.0)?));
//! let comparison = compare("output/old".as_ref(), "output/new".as_ref(), &rules)?;
//! println!("{comparison}");
//! assert!(comparison.agrees());
//! # Ok::<(), jeffcott::report::compare::CompareError>(())
//! ```

mod assertion;
mod error;
mod figure;
mod key_numbers;
mod lines;
mod named;
mod overlay;
mod page;
mod result;
mod rows;
mod rules;
mod table;
mod text;
mod words;

use std::fs;
use std::io::BufReader;
use std::path::Path;

use serde_json::Value;

use self::lines::{compare_quantities, compare_spectra, have_common, is_spectrum};
use self::named::{quantities, shaft};
use self::rows::compare_rows;
use self::table::Source;
use self::words::check_words;
use crate::record::open_regular;

pub use assertion::{ComparedSpectrum, spectra_close};
pub use error::CompareError;
pub(crate) use figure::write_figure;
pub(in crate::report) use overlay::{Overlay, overlay_figures};
pub(crate) use page::write_page;
pub use result::{ColumnComparison, Comparison, Difference, TableComparison, Worst};
pub use rules::{LineRules, LinesBy, Rules, Tolerance, Tolerances};

/// The document of comparisons: an object of one, an array of several.
pub(crate) fn document(comparisons: &[Comparison]) -> Value {
    match comparisons {
        [one] => one.to_json(),
        several => several.iter().map(Comparison::to_json).collect(),
    }
}

/// Tables of a run folder.
const TABLES: [&str; 2] = ["trace.csv", "spectrum.csv"];
/// The one that is compared by lines.
const SPECTRUM: &str = "spectrum.csv";

/// Compares two CSV files, or `trace.csv` and `spectrum.csv` of two run folders; by lines also folders of runs and of records.
///
/// # Errors
/// [`CompareError`] where there is nothing to compare; that results differ is no error.
pub fn compare(first: &Path, second: &Path, rules: &Rules) -> Result<Comparison, CompareError> {
    rules.check()?;
    for path in [first, second] {
        fs::metadata(path).map_err(|source| CompareError::Read {
            path: path.to_owned(),
            source,
        })?;
    }
    let (folder, file) = match (first.is_dir(), second.is_dir()) {
        (true, true) => return compare_folders(first, second, rules),
        (false, false) => {
            let name = first.display().to_string();
            let tables = [Source::open(first)?, Source::open(second)?];
            let table = compare_tables(name, &tables, rules)?;
            return Comparison::new(vec![table], Vec::new(), rules);
        }
        (true, false) => (first, second),
        (false, true) => (second, first),
    };
    Err(CompareError::FolderAndFile {
        folder: folder.to_owned(),
        file: file.to_owned(),
    })
}

/// Compares two tables, by lines where that is asked for; `name` is what the result calls them.
fn compare_tables(
    name: String,
    tables: &[Source<'_>; 2],
    rules: &Rules,
) -> Result<TableComparison, CompareError> {
    let Some(lines) = &rules.lines else {
        check_words(tables)?;
        return Ok(compare_rows(name, tables, rules));
    };
    if let Some(table) = tables.iter().find(|table| !is_spectrum(table)) {
        let path = table.path.clone();
        return Err(CompareError::NoLines { path });
    }
    if lines.by != LinesBy::Frequency {
        let path = tables[0].path.clone();
        let what = "names of lines, nor a speed";
        return Err(CompareError::NoNames { path, what });
    }
    Ok(compare_spectra(name, tables, [1.0; 2], lines, rules))
}

/// Compares the strongest lines of two folders: by names, or where the spectra have no column in common, those that the documents
/// tell, else all of the spectra.
fn compare_folder_lines(
    folders: [&Path; 2],
    lines: &LineRules,
    rules: &Rules,
) -> Result<TableComparison, CompareError> {
    let documents = [sealed(folders[0])?, sealed(folders[1])?];
    let files = folders.map(|folder| folder.join(SPECTRUM));
    if lines.by != LinesBy::Name && files.iter().all(|file| file.exists()) {
        let spectra = [Source::open(&files[0])?, Source::open(&files[1])?];
        if have_common(&spectra) {
            let units = match lines.by {
                LinesBy::Order => [
                    shaft(folders[0], &documents[0])?,
                    shaft(folders[1], &documents[1])?,
                ],
                _ => [1.0; 2],
            };
            let name = SPECTRUM.to_owned();
            return Ok(compare_spectra(name, &spectra, units, lines, rules));
        }
    }
    let reported = |index: usize| quantities(folders[index], &documents[index], lines.by);
    compare_quantities([reported(0)?, reported(1)?], folders, lines, rules)
}

/// Most bytes of a summary.
const LARGEST: u64 = 256 << 20;

/// Seals of the folders that can be compared: of runs and of records.
const SEALS: [&str; 2] = ["summary.json", "record.json"];

/// The document of a whole run, or of a record.
///
/// # Errors
/// [`CompareError::Unsealed`] where there is none in the folder.
fn sealed(folder: &Path) -> Result<Value, CompareError> {
    let mut files = SEALS
        .iter()
        .filter_map(|seal| open_regular(&folder.join(seal), LARGEST).ok());
    let summary: Option<Value> = files
        .next()
        .and_then(|file| serde_json::from_reader(BufReader::new(file)).ok());
    let summary = summary.filter(|summary| summary["jeffcott"].is_string());
    summary.ok_or_else(|| CompareError::Unsealed {
        folder: folder.to_owned(),
    })
}

fn compare_folders(first: &Path, second: &Path, rules: &Rules) -> Result<Comparison, CompareError> {
    let only = |path: &Path| Difference::partial(format!("only one run has {}", path.display()));
    if let Some(lines) = &rules.lines {
        let table = compare_folder_lines([first, second], lines, rules)?;
        return Comparison::new(vec![table], Vec::new(), rules);
    }
    let (mut tables, mut partial) = (Vec::new(), Vec::new());
    let mut runs = [first, second].into_iter();
    if runs.any(|run| TABLES.iter().any(|name| run.join(name).exists())) {
        sealed(first)?;
        sealed(second)?;
    }
    for name in TABLES {
        let (left, right) = (first.join(name), second.join(name));
        match (left.exists(), right.exists()) {
            (true, true) => {
                let both = [Source::open(&left)?, Source::open(&right)?];
                tables.push(compare_tables(name.to_owned(), &both, rules)?);
            }
            (true, false) => partial.push(only(&left)),
            (false, true) => partial.push(only(&right)),
            (false, false) => {}
        }
    }
    if tables.is_empty() && (partial.is_empty() || rules.common) {
        return Err(CompareError::NoTables {
            first: first.to_owned(),
            second: second.to_owned(),
            names: TABLES.join(", "),
        });
    }
    Comparison::new(tables, partial, rules)
}
