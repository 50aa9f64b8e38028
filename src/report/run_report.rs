//! The files of one run, from the opening of the folder to the last rename.

use std::io;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::failure::{Failure, TRACE_UNTIL_FAILURE, failure_json};
use super::sample_table::{SampleTable, TableKind};
use super::{
    BallTraceCsv, EventsCsv, FileAction, FileSet, PartialFile, ReportError, RestartWriter,
    RunFolder, RunIdentity, TraceCsv, TraceFigure, WholeFile, contact_choice_json, spectrum_figure,
    summary, write_spectrum,
};
use crate::rotor::{BallContacts, Sample};
use crate::simulate::{Event, Model, Run, TraceSink};
use crate::study::ContactChoice;

/// Which files a run writes besides `summary.json`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Outputs {
    /// `trace.csv`.
    pub trace: bool,
    /// `energy.csv`.
    pub energy: bool,
    /// `drive.csv`.
    pub drive: bool,
    /// `trace_balls.csv`.
    pub balls: bool,
    /// `events.csv`.
    pub events: bool,
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
    trace: Option<Open<TraceCsv<PartialFile>>>,
    tables: Vec<Open<SampleTable<PartialFile>>>,
    balls: Option<Open<BallTraceCsv<PartialFile>>>,
    events: Option<Open<EventsCsv<PartialFile>>>,
    figure: Option<TraceFigure>,
    samples: u64,
    contact_choice: Option<ContactChoice>,
}

/// A table being written.
#[derive(Debug)]
struct Open<C> {
    path: PathBuf,
    csv: C,
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
        let trace = outputs
            .trace
            .then(|| open(&folder, "trace.csv", TraceCsv::new));
        let balls = outputs.balls.then(|| {
            open(&folder, "trace_balls.csv", |file| {
                Ok(BallTraceCsv::new(file))
            })
        });
        let events = outputs
            .events
            .then(|| open(&folder, "events.csv", EventsCsv::new));
        let tables = [
            (outputs.energy, TableKind::ENERGY),
            (outputs.drive, TableKind::DRIVE),
        ];
        let tables = tables
            .into_iter()
            .filter(|(asked, _)| *asked)
            .map(|(_, kind)| open(&folder, kind.file, |file| SampleTable::new(kind, file)))
            .collect::<Result<_, _>>()?;
        Ok(Self {
            folder,
            title: title.to_owned(),
            scenario,
            outputs,
            trace: trace.transpose()?,
            tables,
            balls: balls.transpose()?,
            events: events.transpose()?,
            figure: outputs.figures.then(|| TraceFigure::new(freedoms)),
            samples: 0,
            contact_choice: None,
        })
    }

    /// The same with the law of the contacts that was chosen for the run, which the summary tells.
    pub fn with_choice(self, contact: Option<&ContactChoice>) -> Self {
        Self {
            contact_choice: contact.cloned(),
            ..self
        }
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
        let trace = self.trace.map(|trace| trace.close(TraceCsv::finish));
        let trace = trace.transpose()?;
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
        let mut summary = summary(&self.title, &self.scenario, model, run);
        if let Some(choice) = &self.contact_choice {
            summary["contact_choice"] = contact_choice_json(choice);
        }
        let mut files = Vec::new();
        if let Some(trace) = self.trace {
            files.push(trace.close(TraceCsv::finish)?);
        }
        if let Some(balls) = self.balls {
            files.push(balls.close(BallTraceCsv::finish)?);
        }
        if let Some(events) = self.events {
            files.push(events.close(EventsCsv::finish)?);
        }
        for table in self.tables {
            files.push(table.close(SampleTable::finish)?);
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
        for table in &mut self.tables {
            table.write(|csv| csv.sample(sample))?;
        }
        match &mut self.trace {
            None => Ok(()),
            Some(trace) => trace.write(|csv| csv.sample(sample)),
        }
    }

    fn balls(&mut self, sample: &Sample, balls: &BallContacts) -> io::Result<()> {
        match &mut self.balls {
            None => Ok(()),
            Some(table) => table.write(|csv| csv.row(sample, balls)),
        }
    }

    fn event(&mut self, event: &Event) -> io::Result<()> {
        match &mut self.events {
            None => Ok(()),
            Some(table) => table.write(|csv| csv.row(event)),
        }
    }
}

fn open<C>(
    folder: &RunFolder,
    name: &str,
    start: impl FnOnce(PartialFile) -> io::Result<C>,
) -> Result<Open<C>, ReportError> {
    let file = folder.create(name)?;
    let path = file.path().to_owned();
    let csv = start(file).map_err(ReportError::file(FileAction::Write, &path))?;
    Ok(Open { path, csv })
}

impl<C> Open<C> {
    /// Writes by `row`; what goes wrong is told with the name of the file.
    fn write(&mut self, row: impl FnOnce(&mut C) -> io::Result<()>) -> io::Result<()> {
        row(&mut self.csv).map_err(|error| {
            let kind = error.kind();
            let named = ReportError::file(FileAction::Write, &self.path)(error);
            io::Error::new(kind, named)
        })
    }

    fn close(
        self,
        finish: impl FnOnce(C) -> io::Result<PartialFile>,
    ) -> Result<WholeFile, ReportError> {
        finish(self.csv)
            .map_err(ReportError::file(FileAction::Write, &self.path))?
            .close()
    }
}
