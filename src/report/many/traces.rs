//! The traces of the runs, a file each.

use std::fs;
use std::io::{self, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};

use crc32fast::Hasher;

use super::StudyError;
use super::rows::Rows;
use crate::analysis::Channel;
use crate::record::open_regular;
use crate::report::run::tables::TraceCsv;
use crate::report::whole_file::sync_folder;
use crate::report::{FileAction, FileSet, PartialFile, ReportError, RunFolder};
use crate::rotor::Sample;
use crate::simulate::TraceSink;
use crate::study::many::{KeptTrace, RunRecord, TraceSeal};

/// Folder of the traces in that of the study.
const FOLDER: &str = "traces";

/// Where the traces of a study are kept; each is there whole or not at all.
#[derive(Debug)]
pub struct Traces {
    folder: RunFolder,
    /// Their columns.
    channels: Vec<Channel>,
}

impl Traces {
    /// Opens the folder of the traces in the folder of a study.
    ///
    /// # Errors
    /// [`ReportError::File`] where it cannot be created, or a link is in its place, which is not followed.
    pub fn open(study: &Path, channels: Vec<Channel>) -> Result<Self, ReportError> {
        let folder = RunFolder::of_any(&study.join(FOLDER), FileSet::RUNS)?;
        Ok(Self { folder, channels })
    }

    /// Begins the trace of a run.
    ///
    /// # Errors
    /// What the file system answers, with the name of the file.
    pub fn begin(&self, run: u64) -> io::Result<Box<dyn KeptTrace>> {
        let file = self.folder.create(&file_name(run)).map_err(other)?;
        let path = file.path().to_owned();
        let csv = TraceCsv::new(Summed::new(file), self.channels.clone());
        let csv = csv.map_err(|error| refused(&path, error))?;
        Ok(Box::new(TraceFile { csv, path }))
    }
}

fn file_name(run: u64) -> String {
    format!("trace-{run}.csv")
}

fn refused(path: &Path, error: io::Error) -> io::Error {
    other(ReportError::file(FileAction::Write, path)(error))
}

fn other(error: ReportError) -> io::Error {
    io::Error::other(error.to_string())
}

/// Whether the folder of a study has traces.
///
/// # Errors
/// [`ReportError::File`] where a link is in their place: what it leads to belongs to nobody here.
pub(super) fn stand(study: &Path) -> Result<bool, ReportError> {
    let path = study.join(FOLDER);
    match fs::symlink_metadata(&path) {
        Ok(known) if known.is_symlink() => {
            let error = io::Error::other("it is a link, which is not followed; remove it");
            Err(ReportError::file(FileAction::Create, &path)(error))
        }
        found => Ok(found.is_ok()),
    }
}

/// What comes before and after the number of the run in the name of a trace, and of one that is being written.
pub(super) const WHOLE: [&str; 2] = ["trace-", ".csv"];
pub(super) const UNFINISHED: [&str; 2] = [".trace-", ".csv.partial"];

/// Removes the traces that an earlier study has left: of the runs that are now made, and of those beyond the last.
pub(super) fn remove_earlier(
    study: &Path,
    [before, after]: [&str; 2],
    own: &Range<u64>,
    count: u64,
) -> Result<(), ReportError> {
    let is_left = |run: &u64| own.contains(run) || *run >= count;
    let entries = fs::read_dir(study.join(FOLDER)).into_iter().flatten();
    for path in entries.flatten().map(|entry| entry.path()) {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let number = name.strip_prefix(before);
        let number = number.and_then(|rest| rest.strip_suffix(after));
        let number = number.and_then(|number| number.parse::<u64>().ok());
        if number.as_ref().is_some_and(is_left) {
            fs::remove_file(&path).map_err(ReportError::file(FileAction::Remove, &path))?;
        }
    }
    Ok(())
}

/// Sees that the traces of some rows outlive a loss of power; one that has not outlived an earlier one is found by its
/// length.
pub(super) fn sync(study: &Path, rows: &Rows) -> Result<(), ReportError> {
    if !rows.head().keep.traces {
        return Ok(());
    }
    rows.each(|row| match traced(study, &row) {
        Some((path, seal)) => {
            sync_trace(&path, seal.bytes).map_err(ReportError::file(FileAction::Sync, &path))
        }
        None => Ok(()),
    })?;
    sync_folder(&study.join(FOLDER))
}

/// The trace of a run, and what it is known by.
fn traced(study: &Path, row: &RunRecord) -> Option<(PathBuf, TraceSeal)> {
    let seal = row.outcome.as_ref().ok()?.trace?;
    Some((study.join(FOLDER).join(file_name(row.run)), seal))
}

fn sync_trace(path: &Path, bytes: u64) -> io::Result<()> {
    let file = fs::File::options().append(true).open(path)?;
    let there = file.metadata()?.len();
    if there != bytes {
        let message =
            format!("it has {there} of {bytes} bytes; begin the study anew with --restart");
        return Err(io::Error::other(message));
    }
    file.sync_data()
}

/// The trace of one run.
#[derive(Debug)]
struct TraceFile {
    csv: TraceCsv<Summed<PartialFile>>,
    path: PathBuf,
}

impl TraceSink for TraceFile {
    fn needs_acceleration(&self) -> bool {
        self.csv.needs_acceleration()
    }

    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        self.csv
            .sample(sample)
            .map_err(|error| refused(&self.path, error))
    }
}

impl KeptTrace for TraceFile {
    fn finish(self: Box<Self>) -> io::Result<TraceSeal> {
        let summed = self.csv.finish();
        let summed = summed.map_err(|error| refused(&self.path, error))?;
        let seal = summed.seal();
        let file = summed.to.close().and_then(|file| file.rename());
        file.map(|_| seal).map_err(other)
    }
}

/// What takes bytes, and the sum of those that it took.
#[derive(Debug)]
struct Summed<W> {
    to: W,
    sum: Hasher,
    bytes: u64,
}

impl<W> Summed<W> {
    fn new(to: W) -> Self {
        Self {
            to,
            sum: Hasher::new(),
            bytes: 0,
        }
    }

    fn seal(&self) -> TraceSeal {
        TraceSeal {
            bytes: self.bytes,
            checksum: self.sum.clone().finalize(),
        }
    }
}

impl<W: Write> Write for Summed<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.to.write(bytes)?;
        self.sum.update(&bytes[..written]);
        self.bytes += written as u64;
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.to.flush()
    }
}

/// Checks that the folder of a study has the traces of some rows, each as its run has written it.
///
/// # Errors
/// [`StudyError::Trace`] names the first that does not.
pub(super) fn check(study: &Path, rows: &Rows) -> Result<(), StudyError> {
    if !rows.head().keep.traces {
        return Ok(());
    }
    rows.each(|row| {
        let Some((path, seal)) = traced(study, &row) else {
            return Ok(());
        };
        let reason = match sealed(&path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => "it is missing".to_owned(),
            Err(error) => error.to_string(),
            Ok(found) if found.bytes != seal.bytes => {
                format!("it has {} of {} bytes", found.bytes, seal.bytes)
            }
            Ok(found) if found != seal => "it is not what the run wrote".to_owned(),
            Ok(_) => return Ok(()),
        };
        let run = row.run;
        Err(StudyError::Trace { run, path, reason })
    })
}

/// What the file there is known by.
fn sealed(path: &Path) -> io::Result<TraceSeal> {
    let mut summed = Summed::new(io::sink());
    io::copy(&mut open_regular(path, u64::MAX)?, &mut summed)?;
    Ok(summed.seal())
}
