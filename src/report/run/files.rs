//! The files of one run, from the opening of the folder to the last rename.

use std::fmt;
use std::io;
use std::num::NonZeroU64;
use std::path::{Path, PathBuf};

use serde_json::json;

use super::answer::{Drawn, RunAnswer};
use super::film::Film;
use super::histories::Histories;
use super::run_up::{waterfall_columns, waterfall_rows};
use super::tables::{SampleFiles, ball_columns, ball_row, event_columns, event_row};
use crate::analysis::Channel;
use crate::integrate::{Counters, IntegrateError};
use crate::report::compare::Overlay;
use crate::report::findings::{WrittenFindings, document};
use crate::report::table::TableFiles;
use crate::report::{FileSet, ReportError, RunFolder, SensitivityTable};
use crate::rotor::{BallContacts, Sample};
use crate::scenario::Scenario;
use crate::simulate::{Event, Model, Run, TraceSink};
use crate::study::campbell::along_run_up;

/// Takes the trace of a run and writes its files.
///
/// Opened before the run, so that a folder that cannot be written costs no computing time; while
/// the run goes on, it streams the trace. Dropped before [`RunReport::finish`] it leaves nothing.
#[derive(Debug)]
pub struct RunReport {
    folder: RunFolder,
    /// What is run, and which files are written besides `summary.json`.
    scenario: Scenario,
    /// Of how many samples one is written to the tables, the first; spectra and figures rest on all.
    every: NonZeroU64,
    /// The trace first, if it is written, then energy and drive.
    tables: Vec<SampleFiles>,
    /// Begun with the first sample, which knows the balls.
    balls: Option<TableFiles>,
    events: Option<TableFiles>,
    histories: Option<Histories>,
    film: Option<Film>,
    /// Spectra of records that are laid over those of the run.
    measured: Vec<Overlay>,
    /// How the numbers of the run change, where that is asked for.
    pub(crate) sensitivity: Option<SensitivityTable>,
    samples: u64,
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
    /// let mut report = RunReport::new(&scenario, model, "output/steady".as_ref())?;
    /// let stop = AtomicBool::new(false);
    /// let mut monitor = Monitor { stop: &stop, progress: &mut |_part| {} };
    /// let run = simulate(model, &mut report, &mut monitor)?;
    /// let files = report.finish(model, run)?.files;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ReportError::File`] where folder or trace cannot be created.
    pub fn new(scenario: &Scenario, model: &Model, folder: &Path) -> Result<Self, ReportError> {
        let output = &scenario.output;
        let measured = scenario.measured.iter().map(|path| Overlay::load(path));
        let measured = measured.collect::<Result<_, _>>()?;
        let folder = RunFolder::open(folder, FileSet::MOTION)?;
        let folder = folder.with_tables(&output.formats, &scenario.echo);
        let trace: Vec<Channel> = match &output.channels {
            Some(channels) => [Channel::Time].iter().chain(channels).copied().collect(),
            None => Channel::of_trace_of(&model.rotor),
        };
        let drive = model.rotor.drive.is_some();
        let energy = model.energy || drive;
        let tables = [
            (output.trace, "trace", trace),
            (energy, "energy", Channel::of_energy().collect()),
            (drive, "drive", Channel::of_drive().collect()),
        ];
        let tables = tables.into_iter().filter(|(is_written, ..)| *is_written);
        let tables = tables.map(|(_, stem, channels)| SampleFiles::open(&folder, stem, channels));
        let histories = || Histories::new(model.rotor.shaft.freedoms);
        let events = || TableFiles::open(&folder, "events", &event_columns());
        Ok(Self {
            tables: tables.collect::<Result<_, _>>()?,
            balls: None,
            events: output.events.then(events).transpose()?,
            histories: (output.figures || output.report).then(histories),
            film: output.report.then(Film::default),
            every: output.written_of(model.samples()),
            folder,
            scenario: scenario.clone(),
            measured,
            sensitivity: None,
            samples: 0,
        })
    }

    /// Whether the sample that was taken last goes to the tables.
    fn keeps_sample(&self) -> bool {
        (self.samples - 1).is_multiple_of(self.every.get())
    }

    /// Writes what is known of a run that cannot go on, after some work: `failure.json` and the trace up to there.
    ///
    /// An earlier run in the same folder stays as it was.
    ///
    /// # Errors
    /// [`ReportError`] where a file cannot be written.
    pub(crate) fn fail(
        self,
        error: &IntegrateError,
        counters: Counters,
    ) -> Result<KeptFiles, ReportError> {
        let earlier = self.folder.whole_files();
        let trace = self.tables.into_iter().next();
        let output = &self.scenario.output;
        let trace = trace.filter(|_| output.trace);
        let files = trace.map(|trace| trace.files.close()).transpose()?;
        let formats = output.formats.iter();
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
        let json = document(&self.scenario.title, &self.scenario.echo, json);
        let folder = self.folder.with_set(FileSet::FAILURE);
        Ok(KeptFiles {
            files: folder.commit(files, json)?.0,
            beside_earlier: !earlier.is_empty(),
        })
    }

    /// Writes what is left and gives all files their names.
    ///
    /// # Errors
    /// [`ReportError`] where a file cannot be written or drawn; none of them looks whole then.
    pub fn finish(self, model: &Model, mut run: Run) -> Result<WrittenFindings, ReportError> {
        let campbell = along_run_up(model, &mut run);
        let answer = RunAnswer {
            scenario: &self.scenario,
            model,
            run: &run,
            campbell: campbell.as_ref(),
            measured: &self.measured,
            sensitivity: self.sensitivity.as_ref(),
        };
        let drawn = Drawn {
            histories: self.histories.as_ref(),
            film: self.film.as_ref(),
        };
        let findings = answer.findings(drawn);
        let mut files = Vec::new();
        let streamed = self.tables.into_iter().map(|table| table.files);
        for table in streamed.chain(self.balls).chain(self.events) {
            files.extend(table.close()?);
        }
        let folder = self.folder;
        for (stem, table) in answer.tables() {
            files.extend(folder.write_table(&stem, &table)?);
        }
        if let Some(maps) = &run.maps {
            let columns = waterfall_columns(&maps.waterfall);
            let rows = waterfall_rows(&maps.waterfall);
            files.extend(TableFiles::write(&folder, "waterfall", &columns, rows)?);
        }
        findings.write_beside(folder, files)
    }
}

/// The kind of failure in one word, for programs.
fn failure_kind(error: &IntegrateError) -> &'static str {
    match error {
        IntegrateError::StepLimit { .. } => "step_limit",
        IntegrateError::StepUnderflow { .. } => "step_underflow",
        IntegrateError::Stiff { .. } => "stiff",
        IntegrateError::NotFinite { .. } => "not_finite",
        IntegrateError::Interrupted { .. } => "interrupted",
    }
}

/// What was kept of a run that cannot go on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct KeptFiles {
    /// Paths of the files.
    pub files: Vec<PathBuf>,
    /// Whether the same folder holds the results of an earlier run.
    pub beside_earlier: bool,
}

impl fmt::Display for KeptFiles {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let files = self.files.iter().map(|file| file.display().to_string());
        let files = files.collect::<Vec<_>>().join(" and ");
        let others = match self.beside_earlier {
            true => "; the other results there are those of an earlier run",
            false => "",
        };
        write!(f, "kept {files}{others}")
    }
}

impl TraceSink for RunReport {
    fn needs_acceleration(&self) -> bool {
        self.tables.iter().any(SampleFiles::needs_acceleration)
    }

    fn needs_contact_angles(&self) -> bool {
        self.scenario.output.balls
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
        if !self.scenario.output.balls || !self.keeps_sample() {
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
