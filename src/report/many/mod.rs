//! The files of a study of many runs: its rows while it goes on, tables, figures and a summary at its end.

mod bifurcation;
mod cells;
mod column_digest;
mod digest;
mod error;
mod figures;
mod head;
mod identity;
mod ross;
mod rows;
mod shown;
mod standing;
mod statistics;
mod tables;
mod traces;
mod waterfall;

use std::path::Path;

use serde_json::json;

use self::digest::Digest;
pub use self::error::StudyError;
pub use self::head::StudyHead;
use self::ross::ross_files;
pub(crate) use self::rows::{RowFile, Rows};
use self::tables::Tables;
pub(crate) use self::traces::Traces;
use crate::report::figure::Figure;
use crate::report::terminal::Lines;
use crate::report::{FileSet, ReportError, RunFolder, WrittenFindings};
use crate::study::many::Shard;

/// Opens folder and rows of a part of a study of so many runs, behind the rows that an earlier attempt has kept, unless all is
/// to begin `anew`.
///
/// # Errors
/// [`StudyError`] where the folder cannot be written, or holds runs of another study.
pub(crate) fn open(
    folder: &Path,
    head: StudyHead,
    runs: u64,
    anew: bool,
) -> Result<(RunFolder, RowFile), StudyError> {
    let (folder, name) = match head.shard {
        Shard::WHOLE => {
            let folder = RunFolder::open(folder, FileSet::RUNS)?;
            (folder, "runs.jsonl".to_owned())
        }
        Shard { number, count } => {
            let folder = RunFolder::open_for_part(folder, FileSet::RUNS)?;
            (folder, format!("runs.part-{number}-of-{count}.jsonl"))
        }
    };
    let rows = RowFile::open(&folder.path().join(name), head, anew)?;
    let own = &rows.head.runs;
    let has_traces = traces::stand(folder.path())? || rows.head.keep.traces;
    traces::remove_earlier(folder.path(), traces::UNFINISHED, own, runs)?;
    if has_traces && rows.count == 0 {
        // traces are put in place one by one: what sealed those of an earlier study goes before them
        folder.unseal()?;
        traces::remove_earlier(folder.path(), traces::WHOLE, own, runs)?;
    }
    Ok((folder, rows))
}

/// Ends the files of a part, whose rows are all there, or of the whole study.
///
/// # Errors
/// [`StudyError`] where a file cannot be written.
pub(crate) fn finish(folder: RunFolder, rows: RowFile) -> Result<WrittenFindings, StudyError> {
    let rows = Rows::from_one(rows);
    let head = rows.head();
    if head.shard == Shard::WHOLE {
        return write(folder, &rows);
    }
    traces::sync(folder.path(), &rows)?;
    Ok(WrittenFindings {
        files: rows.synced()?,
        document: json!({ "title": head.title }),
        text: Lines::titled(&head.title),
        incomplete: false,
    })
}

/// Puts the parts of a study together, in the folder that holds them: to the bytes of the study made in
/// one piece.
///
/// # Errors
/// [`StudyError`] where one is missing, broken or of another study.
pub(crate) fn merge(folder: &Path) -> Result<WrittenFindings, StudyError> {
    let rows = Rows::from_parts(folder)?;
    traces::check(folder, &rows)?;
    write(RunFolder::open(folder, FileSet::RUNS)?, &rows)
}

/// Writes tables, figures and page of the rows of a whole study and, last, what seals them.
fn write(folder: RunFolder, rows: &Rows) -> Result<WrittenFindings, StudyError> {
    traces::sync(folder.path(), rows)?;
    let mut tables = Tables::begin(&folder, rows.head())?;
    let mut digest = Digest::new(rows.head());
    rows.each(|row| {
        tables.add(&row)?;
        digest.add(row);
        Ok::<_, ReportError>(())
    })?;
    digest.finish(rows)?;
    let mut files = tables.end()?;
    for (name, text) in ross_files(&digest) {
        files.push(folder.write(&name, text.as_bytes())?);
    }
    let cells = digest.cells(rows)?;
    let figures = cells.figure().into_iter().chain(figures(&digest, rows)?);
    let mut findings = digest.findings(figures.collect());
    cells.tell(&mut findings.text);
    Ok(findings.write_beside(folder, files)?)
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
