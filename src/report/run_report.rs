//! The files of one run, from the opening of the folder to the last rename.

use std::io;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::failure::{Failure, TRACE_UNTIL_FAILURE, failure_json};
use super::{
    FileAction, FileSet, PartialFile, ReportError, RestartWriter, RunFolder, RunIdentity, TraceCsv,
    TraceFigure, WholeFile, spectrum_figure, summary, write_spectrum,
};
use crate::rotor::Sample;
use crate::simulate::{Model, Run, TraceSink};

/// Which files a run writes besides `summary.json`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Outputs {
    /// `trace.csv`.
    pub trace: bool,
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
    figure: Option<TraceFigure>,
    samples: u64,
}

/// `trace.csv` being written.
#[derive(Debug)]
struct OpenTrace {
    path: PathBuf,
    csv: TraceCsv<PartialFile>,
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
        Ok(Self {
            folder,
            title: title.to_owned(),
            scenario,
            outputs,
            trace,
            figure: outputs.figures.then(|| TraceFigure::new(freedoms)),
            samples: 0,
        })
    }

    /// Starts the file that keeps what it takes to go on.
    ///
    /// # Errors
    /// [`ReportError::File`] where it cannot be created.
    pub fn keep_states(&self, identity: &RunIdentity<'_>) -> Result<RestartWriter, ReportError> {
        RestartWriter::create(&self.folder, identity)
    }

    /// Writes what is known of a run that cannot go on: `failure.json` and the trace up to there.
    ///
    /// An earlier run in the same folder stands as it was.
    ///
    /// # Errors
    /// [`ReportError`] where a file cannot be written.
    pub fn fail(self, failure: &Failure<'_>) -> Result<KeptFiles, ReportError> {
        let earlier = self.folder.standing();
        let trace = self.trace.is_some();
        let json = failure_json(
            &self.title,
            &self.scenario,
            failure,
            self.samples,
            trace,
            &earlier,
        );
        let trace = self.trace.map(close_trace).transpose()?;
        let files = trace.map(|file| file.named(TRACE_UNTIL_FAILURE));
        let files = files.into_iter().collect();
        let sealed = format!("{json:#}\n");
        Ok(KeptFiles {
            files: self
                .folder
                .commit_as(FileSet::FAILURE, files, sealed.as_bytes())?,
            beside_earlier: !earlier.is_empty(),
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

/// What was kept of a run that cannot go on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeptFiles {
    /// Paths of the files.
    pub files: Vec<PathBuf>,
    /// Whether the results of an earlier run stand in the same folder.
    pub beside_earlier: bool,
}

impl TraceSink for RunReport {
    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        self.samples += 1;
        if let Some(figure) = &mut self.figure {
            figure.sample(sample);
        }
        match &mut self.trace {
            None => Ok(()),
            Some(OpenTrace { path, csv }) => csv.sample(sample).map_err(|error| {
                let kind = error.kind();
                let named = ReportError::file(FileAction::Write, path)(error);
                io::Error::new(kind, named)
            }),
        }
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
