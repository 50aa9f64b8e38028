//! The files of one run, from the opening of the folder to the last rename, and its summary.

use std::num::NonZeroU64;
use std::path::{Path, PathBuf};
use std::{fs, io};

use serde::Serialize;
use serde_json::Value;

use super::error::{Failure, FailureSummary, until_failure};
use super::motion::{MotionSummary, orbit_figure, poincare_table};
use super::page::Page;
use super::run_tables::{SampleTable, ball_columns, ball_row, event_columns, event_row};
use super::run_up::{MapsSummary, write_maps};
use super::spectra::{
    EstimatedSummary, estimated_columns, estimated_figure, estimated_rows, table_name,
};
use super::spectrum::{NamedPeak, frequency_limit_of, peak_table, spectrum_columns, spectrum_rows};
use super::table::{Column, Origin, TableFiles};
use super::text::MethodUseSummary;
use super::{
    FileAction, FileSet, PartialFile, ReportError, RestartWriter, RunFolder, RunIdentity,
    TraceFigure, WholeFile, campbell, document, spectrum_figure,
};
use crate::analysis::{Channel, Spectrum};
use crate::rotor::{BallContacts, Sample};
use crate::scenario::{Scenario, TableFormat};
use crate::simulate::{Event, MeasuredError, Model, Run, TraceSink};
use crate::study::ContactChoice;
use crate::study::campbell::{Campbell, CriticalSpeed};

/// Which files a run writes besides `summary.json`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Outputs {
    /// The trace.
    pub trace: bool,
    /// Where the energy is.
    pub energy: bool,
    /// Moments of a drive.
    pub drive: bool,
    /// Load and contact angle of every ball.
    pub balls: bool,
    /// The events.
    pub events: bool,
    /// The spectra, where the run has them.
    pub spectrum: bool,
    /// `trace.svg`, and `spectrum.svg` where the run has spectra.
    pub figures: bool,
    /// `report.html`.
    pub page: bool,
    /// Formats of all tables.
    pub formats: Vec<TableFormat>,
    /// Of how many samples one is written to the tables, the first; spectra and figures rest on all.
    pub every: NonZeroU64,
    /// What the trace shows beside the time; none: everything.
    pub channels: Option<Vec<Channel>>,
}

impl Default for Outputs {
    /// No file, and where one is asked for, CSV of all samples.
    fn default() -> Self {
        Self {
            trace: false,
            energy: false,
            drive: false,
            balls: false,
            events: false,
            spectrum: false,
            figures: false,
            page: false,
            formats: vec![TableFormat::Csv],
            every: NonZeroU64::MIN,
            channels: None,
        }
    }
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
    trace: Option<(SampleTable, TableFiles)>,
    /// Energy and drive.
    tables: Vec<(SampleTable, TableFiles)>,
    /// Begun with the first sample, which knows the balls.
    balls: Option<TableFiles>,
    events: Option<TableFiles>,
    figure: Option<TraceFigure>,
    page: Option<Page>,
    samples: u64,
    /// Kept from row to row for its room.
    row: Vec<f64>,
    contact_choice: Option<ContactChoice>,
    campbell: Option<Campbell>,
}

impl RunReport {
    /// Opens `folder` for a run in which the first `freedoms` of x, y, z, θx, θy move.
    ///
    /// `scenario` is echoed in `summary.json`.
    ///
    /// # Errors
    /// [`ReportError::File`] where folder or trace cannot be created.
    pub(crate) fn open(
        folder: &Path,
        outputs: Outputs,
        title: &str,
        scenario: Value,
        freedoms: usize,
    ) -> Result<Self, ReportError> {
        let origin = Origin {
            scenario: scenario.to_string(),
        };
        let mut report = Self {
            folder: RunFolder::open(folder, FileSet::MOTION)?.with_tables(&outputs.formats, origin),
            title: title.to_owned(),
            scenario,
            trace: None,
            tables: Vec::new(),
            balls: None,
            events: None,
            figure: outputs.figures.then(|| TraceFigure::new(freedoms)),
            page: outputs.page.then(|| Page::new(freedoms)),
            outputs,
            samples: 0,
            row: Vec::new(),
            contact_choice: None,
            campbell: None,
        };
        report.open_tables()?;
        Ok(report)
    }

    /// Begins the tables whose columns are known before the run.
    fn open_tables(&mut self) -> Result<(), ReportError> {
        if self.outputs.trace {
            let table = match &self.outputs.channels {
                Some(channels) => {
                    SampleTable::new([Channel::Time].into_iter().chain(channels.iter().copied()))
                }
                None => SampleTable::new(Channel::of_trace()),
            };
            self.trace = Some(self.open_samples("trace", table)?);
        }
        if self.outputs.energy {
            let table = self.open_samples("energy", SampleTable::new(Channel::of_energy()))?;
            self.tables.push(table);
        }
        if self.outputs.drive {
            let table = self.open_samples("drive", SampleTable::new(Channel::of_drive()))?;
            self.tables.push(table);
        }
        if self.outputs.events {
            self.events = Some(self.open_table("events", &event_columns())?);
        }
        Ok(())
    }

    fn open_samples(
        &self,
        stem: &str,
        table: SampleTable,
    ) -> Result<(SampleTable, TableFiles), ReportError> {
        let files = self.open_table(stem, &table.columns())?;
        Ok((table, files))
    }

    fn open_table(&self, stem: &str, columns: &[Column]) -> Result<TableFiles, ReportError> {
        TableFiles::open(&self.folder, stem, columns)
    }

    /// Whether the sample that was taken last goes to the tables.
    fn keeps_sample(&self) -> bool {
        (self.samples - 1).is_multiple_of(self.outputs.every.get())
    }

    /// The same with the law of the contacts that was chosen for the run, which the summary tells.
    pub(crate) fn with_choice(self, contact: Option<&ContactChoice>) -> Self {
        Self {
            contact_choice: contact.cloned(),
            ..self
        }
    }

    /// The same with natural frequencies over the speed.
    pub(crate) fn with_campbell(self, campbell: Option<Campbell>) -> Self {
        Self { campbell, ..self }
    }

    /// Starts the file that keeps what it takes to go on.
    ///
    /// # Errors
    /// [`ReportError::File`] where it cannot be created.
    pub(crate) fn keep_states(
        &self,
        identity: &RunIdentity<'_>,
    ) -> Result<RestartWriter, ReportError> {
        RestartWriter::create(&self.folder, identity)
    }

    /// Writes what is known of a run that cannot go on: `failure.json` and the trace up to there.
    ///
    /// An earlier run in the same folder stands as it was.
    ///
    /// # Errors
    /// [`ReportError`] where a file cannot be written.
    pub(crate) fn fail(self, failure: &Failure<'_>) -> Result<KeptFiles, ReportError> {
        let earlier = self.folder.standing();
        let formats = self.trace.is_some().then_some(&self.outputs.formats[..]);
        let names: Vec<String> = formats
            .unwrap_or_default()
            .iter()
            .map(|format| until_failure(*format))
            .collect();
        let summary = FailureSummary::new(failure, self.samples, &names, &earlier);
        let json = document(&self.title, &self.scenario, summary);
        let trace = self.trace.map(|(_, files)| files.close()).transpose()?;
        let files = trace.into_iter().flatten().zip(&names);
        let files = files.map(|(file, name)| file.named(name)).collect();
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
        let (choice, campbell) = (self.contact_choice.as_ref(), self.campbell.as_ref());
        let summary = RunSummary::new(model, run, choice, campbell);
        let summary = document(&self.title, &self.scenario, summary);
        let folder = &self.folder;
        let mut files = Vec::new();
        let trace = self.trace.map(|(_, files)| files);
        let tables = self.tables.into_iter().map(|(_, files)| files);
        let tables = trace
            .into_iter()
            .chain(self.balls)
            .chain(self.events)
            .chain(tables);
        for table in tables {
            files.extend(table.close()?);
        }
        if let Some(figure) = self.figure {
            let figure = figure.figure("trace.svg", &self.title);
            files.push(self.folder.write_figure(&figure)?);
        }
        if let Some(spectrum) = &run.spectrum {
            if self.outputs.spectrum {
                let columns = spectrum_columns(spectrum);
                let rows =
                    |take: &mut dyn FnMut(&[f64]) -> io::Result<()>| spectrum_rows(spectrum, take);
                files.extend(folder.write_rows("spectrum", &columns, rows)?);
                let peaks = peak_table(&run.peaks, spectrum);
                files.extend(folder.write_table("peaks", &peaks)?);
            }
            if self.outputs.figures {
                let svg = spectrum_figure(&self.title, spectrum, &run.peaks)?;
                files.push(self.folder.write("spectrum.svg", svg.as_bytes())?);
            }
        }
        if let Some(motion) = &run.motion {
            files.extend(folder.write_table("poincare", &poincare_table(motion))?);
            if self.outputs.figures {
                let figure = orbit_figure(&self.title, motion);
                files.push(self.folder.write_figure(&figure)?);
            }
        }
        let (title, figures) = (&self.title, self.outputs.figures);
        if let Some(maps) = &run.maps {
            files.extend(write_maps(folder, title, maps, figures)?);
        }
        if let Some(campbell) = &self.campbell {
            files.extend(campbell::write_files(
                &self.folder,
                title,
                campbell,
                figures,
            )?);
        }
        let limit = frequency_limit_of(run);
        for spectrum in &run.spectra {
            let columns = estimated_columns(spectrum);
            files.extend(folder.write_rows(&table_name(spectrum), &columns, |take| {
                estimated_rows(spectrum, take)
            })?);
            if self.outputs.figures {
                let figure = estimated_figure(title, spectrum, limit);
                files.push(self.folder.write_figure(&figure)?);
            }
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
    fn needs_acceleration(&self) -> bool {
        let trace = self.trace.as_ref();
        trace.is_some_and(|(table, _)| table.needs_acceleration())
    }

    fn needs_contact_angles(&self) -> bool {
        self.outputs.balls
    }

    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        self.samples += 1;
        if let Some(figure) = &mut self.figure {
            figure.sample(sample);
        }
        if let Some(page) = &mut self.page {
            page.sample(sample);
        }
        if !self.keeps_sample() {
            return Ok(());
        }
        for (table, files) in self.trace.iter_mut().chain(&mut self.tables) {
            files.row(table.row(sample))?;
        }
        Ok(())
    }

    fn balls(&mut self, sample: &Sample, balls: &BallContacts) -> io::Result<()> {
        if !self.outputs.balls || !self.keeps_sample() {
            return Ok(());
        }
        if self.balls.is_none() {
            let files = self.open_table("trace_balls", &ball_columns(balls));
            self.balls = Some(files.map_err(io::Error::other)?);
        }
        match &mut self.balls {
            None => Ok(()),
            Some(files) => {
                ball_row(sample, balls, &mut self.row);
                files.row(&self.row)
            }
        }
    }

    fn event(&mut self, event: &Event) -> io::Result<()> {
        if let Some(page) = &mut self.page {
            page.event();
        }
        match &mut self.events {
            None => Ok(()),
            Some(files) => files.row(&event_row(event)),
        }
    }
}

impl RunReport {
    /// Opens `folder` for the run of a scenario's model, with the files that its `[output]` asks for.
    ///
    /// ```no_run
    /// use std::sync::atomic::AtomicBool;
    /// use jeffcott::report::RunReport;
    /// use jeffcott::simulate::{Monitor, simulate};
    ///
    /// let scenario = jeffcott::scenario::load("scenarios/steady-7205c.toml".as_ref())?;
    /// let model = scenario.model.as_ref().ok_or("nothing moves")?;
    /// let mut report = RunReport::of(&scenario, model, "output/steady".as_ref())?;
    /// let stop = AtomicBool::new(false);
    /// let mut monitor = Monitor { stop: &stop, progress: &mut |_part| {} };
    /// let run = simulate(model, &mut report, &mut monitor)?;
    /// let files = report.finish(model, &run)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ReportError::File`] where folder or trace cannot be created.
    pub fn of(scenario: &Scenario, model: &Model, folder: &Path) -> Result<Self, ReportError> {
        let Scenario {
            title,
            output,
            echo,
            contact_choice,
            ..
        } = scenario;
        let outputs = Outputs {
            trace: output.trace,
            energy: model.energy || model.rotor.drive.is_some(),
            drive: model.rotor.drive.is_some(),
            balls: output.balls,
            events: output.events,
            spectrum: model.spectrum.is_some(),
            figures: output.figures,
            page: output.report,
            formats: output.formats.clone(),
            every: output.written_of(model.samples()),
            channels: output.channels.clone(),
        };
        let kept = model.rotor.shaft.freedoms.count();
        let report = Self::open(folder, outputs, title, echo.clone(), kept)?;
        Ok(report.with_choice(contact_choice.as_ref()))
    }
}

/// Everything that a run answers except trace and spectra: `summary.json` is `document` of it.
#[derive(Debug, Serialize)]
pub struct RunSummary<'a> {
    #[serde(flatten)]
    run: &'a Run,
    method_use: Option<MethodUseSummary>,
    measured_error: Option<ErrorSummary<'a>>,
    spectrum: Option<SpectrumSummary<'a>>,
    peaks: Vec<NamedPeak<'a>>,
    motion: Option<MotionSummary<'a>>,
    maps: Option<MapsSummary<'a>>,
    spectra: Vec<EstimatedSummary<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    contact_choice: Option<&'a ContactChoice>,
    #[serde(skip_serializing_if = "Option::is_none")]
    critical_speeds: Option<&'a [CriticalSpeed]>,
}

/// The measured error beside what was asked for.
#[derive(Debug, Serialize)]
struct ErrorSummary<'a> {
    #[serde(flatten)]
    error: &'a MeasuredError,
    tolerance: f64,
    reference_share_of_evaluations: f64,
}

/// How the spectra were made.
#[derive(Debug, Serialize)]
struct SpectrumSummary<'a> {
    #[serde(flatten)]
    spectrum: &'a Spectrum,
    scaling: &'static str,
}

impl<'a> RunSummary<'a> {
    /// The summary of a run of a model, with the law of the contacts that was chosen for it and the natural
    /// frequencies over the speed, where there are any.
    pub fn new(
        model: &Model,
        run: &'a Run,
        contact_choice: Option<&'a ContactChoice>,
        campbell: Option<&'a Campbell>,
    ) -> Self {
        let spectrum = run.spectrum.as_ref();
        let peaks = run.peaks.iter();
        Self {
            run,
            method_use: run.method_use.as_ref().map(MethodUseSummary::from),
            measured_error: run.measured_error.as_ref().map(|error| ErrorSummary {
                error,
                tolerance: model.integrator.tolerance,
                reference_share_of_evaluations: error.share_of_evaluations(&run.counters),
            }),
            spectrum: spectrum.map(|spectrum| SpectrumSummary {
                spectrum,
                scaling: "one-sided, peak values; the mean stands alone at frequency zero, taken away before the window; \
                          phase of cos(2 pi f t + phase) with t from start_s",
            }),
            peaks: peaks.map(|peak| NamedPeak::new(peak, spectrum)).collect(),
            motion: run.motion.as_ref().map(MotionSummary::from),
            maps: run.maps.as_ref().map(MapsSummary::from),
            spectra: run.spectra.iter().map(EstimatedSummary::from).collect(),
            contact_choice,
            critical_speeds: campbell.map(|campbell| &campbell.critical_speeds[..]),
        }
    }
}
