//! The traces of the runs, a file each.

use std::fs;
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};

use crate::report::trace_table::TraceCsv;
use crate::report::{FileAction, FileSet, PartialFile, ReportError, RunFolder};
use crate::rotor::Sample;
use crate::simulate::TraceSink;
use crate::study::many::KeptTrace;

/// Folder of the traces in that of the study.
const FOLDER: &str = "traces";

/// Where the traces of a study are kept; each stands there whole or not at all.
#[derive(Debug)]
pub struct Traces {
    folder: RunFolder,
}

impl Traces {
    /// Opens the folder of the traces in the folder of a study.
    pub(super) fn open(study: &Path) -> Result<Self, ReportError> {
        let folder = RunFolder::open(&study.join(FOLDER), FileSet::RUNS)?;
        Ok(Self { folder })
    }

    /// Begins the trace of a run.
    ///
    /// # Errors
    /// What the file system answers, with the name of the file.
    pub fn begin(&self, run: u64) -> io::Result<Box<dyn KeptTrace>> {
        let file = self.folder.create(&file_name(run)).map_err(other)?;
        let path = file.path().to_owned();
        let csv = TraceCsv::new(file).map_err(|error| refused(&path, error))?;
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

/// Removes the traces that an earlier study has left: of the runs that are now made, and of those beyond
/// the last.
pub(super) fn remove_stale(study: &Path, own: &Range<u64>, count: u64) -> Result<(), ReportError> {
    let entries = fs::read_dir(study.join(FOLDER)).into_iter().flatten();
    for path in entries.flatten().map(|entry| entry.path()) {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let number = name.strip_prefix("trace-");
        let number = number.and_then(|rest| rest.strip_suffix(".csv"));
        let number = number.and_then(|number| number.parse::<u64>().ok());
        if number.is_some_and(|number| own.contains(&number) || number >= count) {
            fs::remove_file(&path).map_err(ReportError::file(FileAction::Remove, &path))?;
        }
    }
    Ok(())
}

/// The trace of one run.
#[derive(Debug)]
struct TraceFile {
    csv: TraceCsv<PartialFile>,
    path: PathBuf,
}

impl TraceSink for TraceFile {
    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        self.csv
            .sample(sample)
            .map_err(|error| refused(&self.path, error))
    }
}

impl KeptTrace for TraceFile {
    fn finish(self: Box<Self>) -> io::Result<()> {
        let file = self.csv.finish();
        let file = file.map_err(|error| refused(&self.path, error))?;
        file.close().and_then(|file| file.rename()).map_err(other)?;
        Ok(())
    }
}
