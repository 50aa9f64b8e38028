//! The files of one run, from the opening of the folder to the last rename, and its summary.

use std::io;
use std::num::NonZeroU64;
use std::path::{Path, PathBuf};

use serde::Serialize;
use serde_json::{Value, json};

use super::defects;
use super::error::failure_kind;
use super::figure::Figure;
use super::film::Film;
use super::histories::Histories;
use super::motion::{MotionSummary, orbit_figure, poincare_table};
use super::page::write_page;
use super::run_tables::{SampleFiles, ball_columns, ball_row, event_columns, event_row};
use super::run_up::{maps_figures, maps_json, tracks_table, waterfall_columns, waterfall_rows};
use super::scene::scene_figure;
use super::spectra::{
    NamedPeak, estimated_figure, estimated_json, estimated_table, frequency_limit_of, peak_table,
    spectrum_table, table_name,
};
use super::table::{Table, TableFiles};
use super::text::{method_use_json, parted};
use super::{
    FileSet, PartialFile, ReportError, RestartWriter, RunFolder, RunIdentity, campbell, document,
    spectrum_figure,
};
use crate::analysis::{Channel, Spectrum};
use crate::integrate::{Counters, IntegrateError};
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
    /// The trace first, if it is written, then energy and drive.
    tables: Vec<SampleFiles>,
    /// Begun with the first sample, which knows the balls.
    balls: Option<TableFiles>,
    events: Option<TableFiles>,
    histories: Option<Histories>,
    film: Option<Film>,
    samples: u64,
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
        let folder = RunFolder::open(folder, FileSet::MOTION)?;
        let folder = folder.with_tables(&outputs.formats, &scenario);
        let trace: Vec<Channel> = match &outputs.channels {
            Some(channels) => [Channel::Time].iter().chain(channels).copied().collect(),
            None => Channel::of_trace().collect(),
        };
        let tables = [
            (outputs.trace, "trace", trace),
            (outputs.energy, "energy", Channel::of_energy().collect()),
            (outputs.drive, "drive", Channel::of_drive().collect()),
        ];
        let tables = tables.into_iter().filter(|(is_written, ..)| *is_written);
        let tables = tables.map(|(_, stem, channels)| SampleFiles::open(&folder, stem, channels));
        let events = || TableFiles::open(&folder, "events", &event_columns());
        Ok(Self {
            tables: tables.collect::<Result<_, _>>()?,
            balls: None,
            events: outputs.events.then(events).transpose()?,
            histories: (outputs.figures || outputs.page).then(|| Histories::new(freedoms)),
            film: outputs.page.then(Film::default),
            folder,
            title: title.to_owned(),
            scenario,
            outputs,
            samples: 0,
            contact_choice: None,
            campbell: None,
        })
    }

    /// Whether the sample that was taken last goes to the tables.
    fn keeps_sample(&self) -> bool {
        (self.samples - 1).is_multiple_of(self.outputs.every.get())
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

    /// Writes what is known of a run that cannot go on, after some work: `failure.json` and the trace up to there.
    ///
    /// An earlier run in the same folder stands as it was.
    ///
    /// # Errors
    /// [`ReportError`] where a file cannot be written.
    pub(crate) fn fail(
        self,
        error: &IntegrateError,
        counters: Counters,
    ) -> Result<KeptFiles, ReportError> {
        let earlier = self.folder.standing();
        let trace = self.tables.into_iter().next();
        let trace = trace.filter(|_| self.outputs.trace);
        let files = trace.map(|trace| trace.files.close()).transpose()?;
        let formats = self.outputs.formats.iter();
        let names = formats.map(|format| format!("trace.until-failure.{}", format.extension()));
        let files = files.into_iter().flatten().zip(names);
        let files: Vec<_> = files.map(|(file, name)| file.named(&name)).collect();
        let trace = files.first().and_then(|file| file.path().file_name());
        let json = json!({
            "error": error.to_string(),
            "kind": failure_kind(error),
            "time_s": error.time(),
            "samples": self.samples,
            "counters": counters,
            "trace": trace.map(|name| name.to_string_lossy()),
            "of_an_earlier_run": earlier,
        });
        let json = document(&self.title, &self.scenario, json);
        let folder = self.folder.with_set(FileSet::FAILURE);
        Ok(KeptFiles {
            files: folder.commit(files, format!("{json:#}\n").as_bytes())?,
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
        let mut files = Vec::new();
        let histories = self.histories.as_ref();
        let mut figures = figures(&self.title, run, histories, self.campbell.as_ref());
        figures.extend(defects::figure(&self.title, model, run));
        let streamed = self.tables.into_iter().map(|table| table.files);
        for table in streamed.chain(self.balls).chain(self.events) {
            files.extend(table.close()?);
        }
        let folder = &self.folder;
        for (stem, table) in tables_at_end(run, self.outputs.spectrum, self.campbell.as_ref()) {
            files.extend(folder.write_table(&stem, &table)?);
        }
        if let Some(maps) = &run.maps {
            let columns = waterfall_columns(&maps.waterfall);
            let rows = waterfall_rows(&maps.waterfall);
            files.extend(TableFiles::write(folder, "waterfall", &columns, rows)?);
        }
        for figure in figures.iter().filter(|_| self.outputs.figures) {
            files.extend(folder.write_figure(figure)?);
        }
        if let Some(histories) = self.histories.filter(|_| self.outputs.page) {
            let scene = scene_figure(&self.title, &model.rotor);
            let shown = figures.iter().chain([&scene]);
            let figures: Vec<_> = shown
                .filter(|figure| ON_PAGE.contains(&figure.name()))
                .collect();
            let film = self.film.and_then(|film| film.json(&model.rotor));
            let write = |file: &mut PartialFile| {
                write_page(&summary, run, &histories, &figures, film, file)
            };
            files.push(folder.write_with("report.html", write)?);
        }
        self.folder
            .commit(files, format!("{summary:#}\n").as_bytes())
    }
}

/// What is drawn of a run.
pub(super) fn figures(
    title: &str,
    run: &Run,
    histories: Option<&Histories>,
    campbell: Option<&Campbell>,
) -> Vec<Figure> {
    let trace = histories.iter();
    let mut figures: Vec<_> = trace
        .map(|histories| histories.figure("trace.svg", title))
        .collect();
    let spectrum = run.spectrum.iter();
    figures.extend(spectrum.map(|spectrum| spectrum_figure(title, spectrum, &run.peaks)));
    let motion = run.motion.iter();
    figures.extend(motion.map(|motion| orbit_figure(title, motion)));
    figures.extend(run.maps.iter().flat_map(|maps| maps_figures(title, maps)));
    figures.extend(campbell.map(|campbell| campbell::figure(title, campbell)));
    let limit = frequency_limit_of(run);
    let spectra = run.spectra.iter();
    figures.extend(spectra.map(|spectrum| estimated_figure(title, spectrum, limit)));
    figures
}

/// Tables of a run that are known at its end, but for the waterfall, which is too long to be held twice.
pub(super) fn tables_at_end<'a>(
    run: &'a Run,
    with_spectrum: bool,
    campbell: Option<&'a Campbell>,
) -> Vec<(String, Table<'a>)> {
    let mut tables = Vec::new();
    if let Some(spectrum) = run.spectrum.as_ref().filter(|_| with_spectrum) {
        tables.push(("spectrum".to_owned(), spectrum_table(spectrum)));
        tables.push(("peaks".to_owned(), peak_table(&run.peaks, spectrum)));
    }
    let motion = run.motion.iter();
    tables.extend(motion.map(|motion| ("poincare".to_owned(), poincare_table(motion))));
    let maps = run.maps.iter();
    tables.extend(maps.map(|maps| ("order_tracks".to_owned(), tracks_table(&maps.tracks))));
    let campbell = campbell.into_iter();
    tables.extend(campbell.map(|campbell| ("campbell".to_owned(), campbell::modes(campbell))));
    let spectra = run.spectra.iter();
    tables.extend(spectra.map(|spectrum| (table_name(spectrum), estimated_table(spectrum))));
    tables
}

/// Figures that the page shows: what its own charts do not.
const ON_PAGE: [&str; 6] = [
    "scene",
    "orbit",
    "defects",
    "waterfall",
    "order_tracks",
    "campbell",
];

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
        self.tables.iter().any(SampleFiles::needs_acceleration)
    }

    fn needs_contact_angles(&self) -> bool {
        self.outputs.balls
    }

    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        self.samples += 1;
        if let Some(histories) = &mut self.histories {
            histories.sample(sample);
        }
        if !self.keeps_sample() {
            return Ok(());
        }
        let mut tables = self.tables.iter_mut();
        tables.try_for_each(|table| table.sample(sample))
    }

    fn balls(&mut self, sample: &Sample, balls: &BallContacts) -> io::Result<()> {
        if let Some(film) = &mut self.film {
            film.take(sample, balls);
        }
        if !self.outputs.balls || !self.keeps_sample() {
            return Ok(());
        }
        let files = match &mut self.balls {
            Some(files) => files,
            none => {
                let files = TableFiles::open(&self.folder, "trace_balls", &ball_columns(balls));
                none.insert(files.map_err(io::Error::other)?)
            }
        };
        files.row(&ball_row(sample, balls))
    }

    fn event(&mut self, event: &Event) -> io::Result<()> {
        if let Some(histories) = &mut self.histories {
            histories.event();
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
        let output = &scenario.output;
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
        let (title, echo) = (&scenario.title, scenario.echo.clone());
        Ok(Self {
            contact_choice: scenario.contact_choice.clone(),
            ..Self::open(folder, outputs, title, echo, kept)?
        })
    }
}

/// Everything that a run answers except trace and spectra: `summary.json` is `document` of it.
#[derive(Debug, Serialize)]
pub struct RunSummary<'a> {
    #[serde(flatten)]
    run: &'a Run,
    method_use: Option<Value>,
    measured_error: Option<ErrorSummary<'a>>,
    spectrum: Option<SpectrumSummary<'a>>,
    peaks: Vec<NamedPeak<'a>>,
    motion: Option<MotionSummary<'a>>,
    maps: Option<Value>,
    spectra: Vec<Value>,
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
        let (method_use, spectrum) = (run.method_use.as_ref(), run.spectrum.as_ref());
        let peaks = run.peaks.iter();
        Self {
            run,
            method_use: method_use.map(|used| method_use_json(used, parted(&run.bearings))),
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
            maps: run.maps.as_ref().map(maps_json),
            spectra: run.spectra.iter().map(estimated_json).collect(),
            contact_choice,
            critical_speeds: campbell.map(|campbell| &campbell.critical_speeds[..]),
        }
    }
}
