//! The files of one run, from the opening of the folder to the last rename.

use std::io;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::sample_table::{SampleTable, TableKind};
use super::{
    FileAction, FileSet, PartialFile, ReportError, RunFolder, TraceCsv, TraceFigure, WholeFile,
    spectrum_figure, summary, write_spectrum,
};
use crate::rotor::Sample;
use crate::simulate::{Model, Run, TraceSink};

/// Which files a run writes besides `summary.json`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Outputs {
    /// `trace.csv`.
    pub trace: bool,
    /// `energy.csv`.
    pub energy: bool,
    /// `drive.csv`.
    pub drive: bool,
    /// `spectrum.csv`, where the run has spectra.
    pub spectrum: bool,
    /// `trace.svg`, and `spectrum.svg` where the run has spectra.
    pub figures: bool,
}

/// Takes the trace of a run and writes its files.
///
/// Opened before the run, so that a folder that cannot be written costs no computing time; while
/// the run goes on, it streams the trace. Dropped before [`RunReport::finish`] it leaves nothing.
#[derive(Debug)]
pub struct RunReport {
    folder: RunFolder,
    title: String,
    scenario: Value,
    outputs: Outputs,
    trace: Option<OpenTrace>,
    tables: Vec<OpenTable>,
    figure: Option<TraceFigure>,
}

/// `trace.csv` being written.
#[derive(Debug)]
struct OpenTrace {
    path: PathBuf,
    csv: TraceCsv<PartialFile>,
}

/// A table beside the trace, being written.
#[derive(Debug)]
struct OpenTable {
    path: PathBuf,
    table: SampleTable<PartialFile>,
}

impl RunReport {
    /// Opens `folder` for a run in which the first `freedoms` of x, y, z, θx, θy move.
    ///
    /// `scenario` is echoed in `summary.json`.
    ///
    /// # Errors
    /// [`ReportError::File`] where folder or trace cannot be created.
    pub fn open(
        folder: &Path,
        outputs: Outputs,
        title: &str,
        scenario: Value,
        freedoms: usize,
    ) -> Result<Self, ReportError> {
        let folder = RunFolder::open(folder, FileSet::MOTION)?;
        let trace = outputs.trace.then(|| open_trace(&folder)).transpose()?;
        let tables = [
            (outputs.energy, TableKind::ENERGY),
            (outputs.drive, TableKind::DRIVE),
        ];
        let tables = tables
            .into_iter()
            .filter(|(asked, _)| *asked)
            .map(|(_, kind)| OpenTable::open(&folder, kind))
            .collect::<Result<_, _>>()?;
        Ok(Self {
            folder,
            title: title.to_owned(),
            scenario,
            outputs,
            trace,
            tables,
            figure: outputs.figures.then(|| TraceFigure::new(freedoms)),
        })
    }

    /// Writes what is left and gives all files their names; returns their paths.
    ///
    /// # Errors
    /// [`ReportError`] where a file cannot be written or drawn; none of them looks whole then.
    pub fn finish(self, model: &Model, run: &Run) -> Result<Vec<PathBuf>, ReportError> {
        let summary = summary(&self.title, &self.scenario, model, run);
        let mut files = Vec::new();
        if let Some(trace) = self.trace {
            files.push(close_trace(trace)?);
        }
        for table in self.tables {
            files.push(table.close()?);
        }
        if let Some(figure) = self.figure {
            let svg = figure.draw(&self.title)?;
            files.push(self.folder.write("trace.svg", svg.as_bytes())?);
        }
        if let Some(spectrum) = &run.spectrum {
            if self.outputs.spectrum {
                let mut file = self.folder.create("spectrum.csv")?;
                let path = file.path().to_owned();
                write_spectrum(spectrum, &mut file)
                    .map_err(ReportError::file(FileAction::Write, &path))?;
                files.push(file.close()?);
            }
            if self.outputs.figures {
                let svg = spectrum_figure(&self.title, spectrum, &run.peaks)?;
                files.push(self.folder.write("spectrum.svg", svg.as_bytes())?);
            }
        }
        self.folder
            .commit(files, format!("{summary:#}\n").as_bytes())
    }
}

impl TraceSink for RunReport {
    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        if let Some(figure) = &mut self.figure {
            figure.sample(sample);
        }
        for OpenTable { path, table } in &mut self.tables {
            table.sample(sample).map_err(named(path))?;
        }
        match &mut self.trace {
            None => Ok(()),
            Some(OpenTrace { path, csv }) => csv.sample(sample).map_err(named(path)),
        }
    }
}

/// The error of a file that cannot be written, with its name.
fn named(path: &Path) -> impl FnOnce(io::Error) -> io::Error + '_ {
    move |error| {
        let kind = error.kind();
        io::Error::new(kind, ReportError::file(FileAction::Write, path)(error))
    }
}

impl OpenTable {
    fn open(folder: &RunFolder, kind: TableKind) -> Result<Self, ReportError> {
        let file = folder.create(kind.file)?;
        let path = file.path().to_owned();
        let table =
            SampleTable::new(kind, file).map_err(ReportError::file(FileAction::Write, &path))?;
        Ok(Self { path, table })
    }

    fn close(self) -> Result<WholeFile, ReportError> {
        let Self { path, table } = self;
        let file = table.finish();
        file.map_err(ReportError::file(FileAction::Write, &path))?
            .close()
    }
}

fn open_trace(folder: &RunFolder) -> Result<OpenTrace, ReportError> {
    let file = folder.create("trace.csv")?;
    let path = file.path().to_owned();
    let csv = TraceCsv::new(file).map_err(ReportError::file(FileAction::Write, &path))?;
    Ok(OpenTrace { path, csv })
}

fn close_trace(trace: OpenTrace) -> Result<WholeFile, ReportError> {
    let file = trace
        .csv
        .finish()
        .map_err(ReportError::file(FileAction::Write, &trace.path))?;
    file.close()
}
