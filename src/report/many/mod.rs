//! The files of a study of many runs: its rows while it goes on, tables, figures and a summary at its end.

mod digest;
mod error;
mod figures;
mod identity;
mod make;
mod page;
mod ross;
mod rows;
mod standing;
mod statistics;
mod tables;
mod traces;
mod waterfall;

use std::path::{Path, PathBuf};

pub use self::digest::Digest;
pub use self::error::StudyError;
pub use self::make::{Asked, Making, StudyRuns, StudyWatch};
use self::page::write_page;
use self::ross::ross_files;
use self::rows::Rows;
use self::tables::Tables;
use crate::report::figure::Figure;
use crate::report::{FileSet, PartialFile, ReportError, RunFolder, WholeFile};

/// Puts the parts of a study together, in the folder that they stand in: to the bytes of the study made in
/// one piece.
///
/// # Errors
/// [`StudyError`] where one is missing, broken or of another study.
pub fn merge(folder: &Path) -> Result<(Vec<PathBuf>, Digest), StudyError> {
    let rows = Rows::of_parts(folder)?;
    traces::check(folder, &rows)?;
    write(RunFolder::open(folder, FileSet::RUNS)?, &rows)
}

/// Writes tables, figures and page of the rows of a whole study and, last, what seals them.
fn write(folder: RunFolder, rows: &Rows) -> Result<(Vec<PathBuf>, Digest), StudyError> {
    traces::sync(folder.path(), rows)?;
    let mut tables = Tables::begin(&folder, rows.head())?;
    let mut digest = Digest::new(rows.head());
    rows.each(|row| {
        tables.add(&row)?;
        digest.add(row);
        Ok::<_, ReportError>(())
    })?;
    digest.finish();
    let mut files = tables.end()?;
    let figures = figures(&digest, rows)?;
    for figure in &figures {
        files.push(folder.write_figure(figure)?);
    }
    let page = |file: &mut PartialFile| write_page(&digest, &figures, file);
    files.push(folder.write_with("report.html", page)?);
    for (name, text) in ross_files(&digest) {
        files.push(folder.write(&name, text.as_bytes())?);
    }
    digest.sealed = files.iter().map(WholeFile::name).collect();
    let (paths, _) = folder.commit(files, digest.document())?;
    Ok((paths, digest))
}

/// What there is to draw.
fn figures(digest: &Digest, rows: &Rows) -> Result<Vec<Figure>, ReportError> {
    let drawn = [
        digest.response(),
        digest.bifurcation(rows)?,
        digest.waterfall(rows)?,
        digest.map(),
        digest.tornado(),
        digest.scatter(),
    ];
    let drawn = drawn.into_iter().flatten();
    Ok(drawn.chain(digest.standing(rows)?).collect())
}
