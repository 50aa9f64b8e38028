//! The files of a study of many runs: a journal while it goes on, tables, figures and a summary at its end.

mod digest;
mod figures;
mod identity;
mod journal;
mod make;
mod page;
mod part;
mod ross;
mod statistics;
mod tables;
mod traces;
mod waterfall;

use std::io::{self, BufRead, BufReader, Write};
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

pub use self::digest::Digest;
use self::journal::Journal;
pub use self::journal::{Done, JournalError};
pub use self::make::{MakeError, Making, StudyRuns, StudyWatch};
use self::page::write_page;
pub use self::part::MergeError;
use self::part::{PartSeal, part_name, seals};
use self::ross::ross_files;
use self::tables::{Table, content, header, write_header, write_rows};
pub use self::traces::Traces;
use self::traces::{has_traces, remove_stale, remove_unfinished, sync_traces};
use crate::report::figure::Figure;
use crate::report::{FileAction, FileSet, PartialFile, ReportError, RunFolder, WholeFile};
use crate::scenario::open_regular;
use crate::study::many::{RunRecord, Shard};

/// A study whose runs are being made.
#[derive(Debug)]
pub struct StudyReport<'a> {
    runs: &'a StudyRuns<'a>,
    folder: RunFolder,
    journal: Journal,
    shard: Shard,
}

impl<'a> StudyReport<'a> {
    /// Opens the folder of a study, going on from the runs that an earlier attempt has kept there unless
    /// all is to begin anew.
    ///
    /// # Errors
    /// [`JournalError`] where the folder cannot be written, or holds runs of another study.
    pub fn open(runs: &'a StudyRuns<'a>, making: &Making<'_>) -> Result<Self, JournalError> {
        let (study, schedule, shard) = (runs.study, &runs.schedule, making.shard);
        let folder = match shard {
            Shard::WHOLE => RunFolder::open(making.folder, FileSet::RUNS)?,
            _ => RunFolder::open_for_part(making.folder, FileSet::RUNS)?,
        };
        let first = shard.chains(schedule).start;
        let path = folder.path().join(match shard {
            Shard::WHOLE => "runs.journal".to_owned(),
            part => part_name("study", part, "journal"),
        });
        let own = schedule.runs_of(shard.chains(schedule));
        let known = json!({ "jeffcott": env!("CARGO_PKG_VERSION"), "study": study.echo });
        let journal = Journal::open(&path, &known, first, making.anew)?;
        let has_traces = has_traces(folder.path())? || study.keep.traces;
        remove_unfinished(folder.path(), &own, schedule.runs())?;
        if has_traces && journal.done == Done::none(first) {
            // traces are put in place one by one: what sealed those of an earlier study goes before them
            folder.unseal(&[FileSet::RUNS.seal, &part_name("study", shard, "json")])?;
            remove_stale(folder.path(), &own, schedule.runs())?;
        }
        Ok(Self {
            runs,
            folder,
            journal,
            shard,
        })
    }

    /// Notes the runs of a chain.
    ///
    /// # Errors
    /// [`ReportError`] where they cannot be written; those before them stay.
    pub fn add(&mut self, chain: u64, records: &[RunRecord]) -> Result<(), ReportError> {
        let content = content(self.runs, records)
            .map_err(ReportError::file(FileAction::Write, &self.journal.path))?;
        self.journal.add(chain, &content)
    }

    /// Writes the tables and, last, what seals them; returns the paths, and for a whole study its digest.
    ///
    /// # Errors
    /// [`JournalError`] where a file cannot be read, written or drawn; the journal then stays.
    pub fn finish(self) -> Result<(Vec<PathBuf>, Option<Digest>), JournalError> {
        let mut files = Vec::new();
        for table in Table::kept(&self.runs.study.keep) {
            let file = self.table(table)?;
            if table == Table::Traces {
                sync_traces(self.folder.path(), file.temporary())?;
            }
            files.push(file);
        }
        if self.shard != Shard::WHOLE {
            return Ok((self.seal_part(files)?, None));
        }
        let study = self.runs.study;
        let (paths, digest) = seal(self.folder, files, &study.title, &study.echo)?;
        Ok((paths, Some(digest)))
    }

    /// Writes a table in the order of the runs.
    fn table(&self, table: Table) -> Result<WholeFile, JournalError> {
        let name = match self.shard {
            Shard::WHOLE => format!("{}.csv", table.stem()),
            part => part_name(table.stem(), part, "csv"),
        };
        let mut file = self.folder.create(&name)?;
        let path = file.path().to_owned();
        let refused = || ReportError::file(FileAction::Write, &path);
        write_header(&header(self.runs, table), &mut file).map_err(refused())?;
        self.journal
            .in_order(|content| write_rows(content, table, &mut file).map_err(refused()))?;
        Ok(file.close()?)
    }

    fn seal_part(self, files: Vec<WholeFile>) -> Result<Vec<PathBuf>, ReportError> {
        let study = self.runs.study;
        let tables = Table::kept(&study.keep);
        let seal = PartSeal {
            jeffcott: env!("CARGO_PKG_VERSION").to_owned(),
            title: study.title.clone(),
            identity: study.echo.clone(),
            number: self.shard.number,
            count: self.shard.count,
            tables: tables.map(|table| table.stem().to_owned()).collect(),
        };
        let text = json!(seal);
        let name = part_name("study", self.shard, "json");
        let seal = self.folder.write(&name, format!("{text:#}\n").as_bytes())?;
        let paths = self.folder.put(files, seal, [])?;
        self.journal.remove()?;
        Ok(paths)
    }
}

/// Puts the parts of a study together, in the folder that they stand in: to the bytes of the study made in
/// one piece.
///
/// # Errors
/// `MergeError` where one is missing, broken or of another study.
pub fn merge(folder: &Path) -> Result<(Vec<PathBuf>, Digest), MergeError> {
    let seals = seals(folder)?;
    let first = &seals[0];
    let has = |table: Table| first.tables.iter().any(|name| name == table.stem());
    if has(Table::Traces) {
        let mut tables = seals.iter().map(|seal| seal.table(folder, Table::Traces));
        tables.try_for_each(|table| traces::check(folder, &table))?;
    }
    let target = RunFolder::open(folder, FileSet::RUNS)?;
    let mut files = Vec::new();
    for table in Table::ALL {
        if has(table) {
            files.push(joined(&target, table, &seals)?);
        }
    }
    Ok(seal(target, files, &first.title, &first.identity)?)
}

/// One table of all parts, its line of names once.
fn joined(folder: &RunFolder, table: Table, seals: &[PartSeal]) -> Result<WholeFile, MergeError> {
    let mut file = folder.create(&format!("{}.csv", table.stem()))?;
    let mut names = None;
    for seal in seals {
        let path = seal.table(folder.path(), table);
        let broken = |error: io::Error| MergeError::Broken {
            path: path.clone(),
            reason: error.to_string(),
        };
        let mut reader =
            BufReader::with_capacity(1 << 16, open_regular(&path, u64::MAX).map_err(broken)?);
        let mut header = String::new();
        reader.read_line(&mut header).map_err(broken)?;
        let written = match &names {
            None => file.write_all(header.as_bytes()),
            Some(names) if *names == header => Ok(()),
            Some(_) => {
                let other = io::Error::other("its columns are not those of the first part");
                return Err(broken(other));
            }
        };
        let target = file.path().to_owned();
        written
            .and_then(|()| io::copy(&mut reader, &mut file).map(drop))
            .map_err(ReportError::file(FileAction::Write, &target))?;
        names = Some(header);
    }
    Ok(file.close()?)
}

/// Digests the table of runs, draws what there is to draw, and gives all files their names.
fn seal(
    folder: RunFolder,
    mut files: Vec<WholeFile>,
    title: &str,
    identity: &Value,
) -> Result<(Vec<PathBuf>, Digest), ReportError> {
    let named = |files: &[WholeFile], table: Table| {
        let name = format!("{}.csv", table.stem());
        let found = files.iter().find(|file| file.path().ends_with(&name));
        found.map(|file| file.temporary().to_owned())
    };
    let runs = named(&files, Table::Runs).unwrap_or_default();
    let digest = Digest::of(&runs, identity)?;
    let tables = [Table::Points, Table::Spectra].map(|table| named(&files, table));
    let figures = figures(&digest, title, tables.each_ref().map(Option::as_deref))?;
    for figure in &figures {
        files.extend(folder.write_figure(figure)?);
    }
    let page = |file: &mut PartialFile| write_page(title, identity, &digest, &figures, file);
    files.push(folder.write_with("report.html", page)?);
    if let Some(stiffness) = named(&files, Table::Stiffness) {
        for (name, text) in ross_files(title, identity, &digest, &stiffness)? {
            files.push(folder.write(&name, text.as_bytes())?);
        }
    }
    let summary = json!({
        "jeffcott": env!("CARGO_PKG_VERSION"),
        "title": title,
        "study": identity,
        "digest": digest.summary(),
    });
    let paths = folder.commit(files, format!("{summary:#}\n").as_bytes())?;
    Ok((paths, digest))
}

/// Shows the rows of a table that stands in a file, each with the line of names.
fn each_row(
    path: &Path,
    mut show: impl FnMut(&csv::StringRecord, csv::StringRecord),
) -> Result<(), ReportError> {
    let refused = |error: csv::Error| {
        let error = io::Error::other(error.to_string());
        ReportError::file(FileAction::Read, path)(error)
    };
    let mut reader = csv::Reader::from_path(path).map_err(refused)?;
    let names = reader.headers().map_err(refused)?.clone();
    for record in reader.records() {
        show(&names, record.map_err(refused)?);
    }
    Ok(())
}

/// The number in a cell; NaN where there is none.
fn number_in(record: &csv::StringRecord, place: usize) -> f64 {
    let cell = record.get(place);
    cell.and_then(|cell| cell.parse().ok()).unwrap_or(f64::NAN)
}

/// What there is to draw.
fn figures(
    digest: &Digest,
    title: &str,
    [points, spectra]: [Option<&Path>; 2],
) -> Result<Vec<Figure>, ReportError> {
    let bifurcation = points.map(|points| digest.bifurcation(title, points));
    let waterfall = spectra.map(|spectra| digest.waterfall(title, spectra));
    let drawn = [
        digest.response(title),
        bifurcation.transpose()?.flatten(),
        waterfall.transpose()?.flatten(),
        digest.map(title),
        digest.tornado(title),
        digest.scatter(title),
    ];
    Ok(drawn.into_iter().flatten().collect())
}
