//! The files of one run, from the opening of the folder to the last rename.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::campbell;
use super::failure::{Failure, TRACE_UNTIL_FAILURE, failure_json};
use super::motion::{orbit_figure, write_poincare};
use super::page::Page;
use super::run_up::write_maps;
use super::sample_table::{SampleTable, TableKind};
use super::spectra::file_name;
use super::{
    BallTraceCsv, EventsCsv, FileAction, FileSet, PartialFile, ReportError, RestartWriter,
    RunFolder, RunIdentity, TraceCsv, TraceFigure, WholeFile, contact_choice_json,
    method_choice_json, spectrum_figure, summary, write_estimated, write_peaks, write_spectrum,
};
use crate::rotor::{BallContacts, Sample};
use crate::simulate::{Event, Model, Run, TraceSink};
use crate::study::campbell::Campbell;
use crate::study::{ContactChoice, MethodChoice};

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
    /// `spectrum.csv` and `peaks.csv`, where the run has spectra.
    pub spectrum: bool,
    /// `trace.svg`, and `spectrum.svg` where the run has spectra.
    pub figures: bool,
    /// `report.html`.
    pub page: bool,
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
    page: Option<Page>,
    samples: u64,
    contact_choice: Option<ContactChoice>,
    method_choice: Option<MethodChoice>,
    campbell: Option<Campbell>,
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
            page: outputs.page.then(|| Page::new(freedoms)),
            samples: 0,
            contact_choice: None,
            method_choice: None,
            campbell: None,
        })
    }

    /// The same with what was chosen for the run, which the summary tells: the law of the contacts and
    /// the method.
    pub fn with_choices(
        self,
        contact: Option<&ContactChoice>,
        method: Option<&MethodChoice>,
    ) -> Self {
        Self {
            contact_choice: contact.cloned(),
            method_choice: method.cloned(),
            ..self
        }
    }

    /// The same with natural frequencies over the speed.
    pub fn with_campbell(self, campbell: Option<Campbell>) -> Self {
        Self { campbell, ..self }
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
        if let Some(choice) = &self.method_choice {
            summary["method_choice"] = method_choice_json(choice);
        }
        if let Some(campbell) = &self.campbell {
            summary["critical_speeds"] = campbell::critical_speeds(campbell);
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
                files.push(
                    self.folder
                        .write_with("peaks.csv", |file| write_peaks(&run.peaks, spectrum, file))?,
                );
            }
            if self.outputs.figures {
                let svg = spectrum_figure(&self.title, spectrum, &run.peaks)?;
                files.push(self.folder.write("spectrum.svg", svg.as_bytes())?);
            }
        }
        if let Some(motion) = &run.motion {
            files.push(
                self.folder
                    .write_with("poincare.csv", |file| write_poincare(motion, file))?,
            );
            if self.outputs.figures {
                let svg = orbit_figure(&self.title, motion)?;
                files.push(self.folder.write("orbit.svg", svg.as_bytes())?);
            }
        }
        let (title, figures) = (&self.title, self.outputs.figures);
        if let Some(maps) = &run.maps {
            files.extend(write_maps(&self.folder, title, maps, figures)?);
        }
        if let Some(campbell) = &self.campbell {
            files.extend(campbell::write_files(
                &self.folder,
                title,
                campbell,
                figures,
            )?);
        }
        for spectrum in &run.spectra {
            let write = |file: &mut PartialFile| write_estimated(spectrum, file);
            files.push(self.folder.write_with(&file_name(spectrum), write)?);
        }
        if let Some(page) = &self.page {
            let figures = shown_figures(&files)?;
            let write = |file: &mut PartialFile| page.write(&summary, run, &figures, file);
            files.push(self.folder.write_with("report.html", write)?);
        }
        self.folder
            .commit(files, format!("{summary:#}\n").as_bytes())
    }
}

/// Figures that the page shows as they are: what its own charts do not.
fn shown_figures(files: &[WholeFile]) -> Result<Vec<(&'static str, String)>, ReportError> {
    const SHOWN: [&str; 3] = ["waterfall.svg", "order_tracks.svg", "campbell.svg"];
    let found = |name: &&'static str| {
        let name = *name;
        let file = files.iter().find(|file| file.path().ends_with(name))?;
        let text = fs::read_to_string(file.temporary());
        Some(
            text.map(|svg| (name, svg))
                .map_err(ReportError::file(FileAction::Read, file.temporary())),
        )
    };
    SHOWN.iter().filter_map(found).collect()
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
        if let Some(page) = &mut self.page {
            page.sample(sample);
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
