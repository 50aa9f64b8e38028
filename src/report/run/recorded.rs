//! A run that is kept in memory: its tables and figures one by one, and all its files.

use std::error::Error;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::answer::{Drawn, RunAnswer};
use super::histories::Histories;
use super::run_up::waterfall_table;
use super::tables::{ball_columns, ball_row, event_columns, event_row, sample_table};
use crate::analysis::Channel;
use crate::report::compare::Overlay;
use crate::report::findings::Findings;
use crate::report::spectra::estimated_table;
use crate::report::{FileAction, ReportError, RunReport, SensitivityTable};
use crate::scenario::Scenario;
use crate::simulate::{Maps, Model, Monitor, RecordedRun, SimulateError};
use crate::study::campbell::{Campbell, along_run_up};
use crate::table::Table;

/// What a run has found, with its samples: as [`Findings`], but each table and figure is made when it
/// is asked for.
#[derive(Debug, Clone)]
pub struct RunFindings {
    scenario: Scenario,
    model: Model,
    /// The run.
    pub recorded: RecordedRun,
    campbell: Option<Campbell>,
    measured: Vec<Overlay>,
    /// How its numbers change, where that is asked for.
    pub(crate) sensitivity: Option<SensitivityTable>,
}

impl RunFindings {
    /// Runs the model of a scenario and keeps its samples.
    ///
    /// # Errors
    /// [`SimulateError`], or [`ReportError`] where what is laid over the run cannot be read.
    pub(crate) fn new(
        scenario: Scenario,
        model: Model,
        monitor: &mut Monitor<'_>,
    ) -> Result<Self, Box<dyn Error + Send + Sync>> {
        let measured = scenario.measured.iter().map(|path| Overlay::load(path));
        let measured = measured.collect::<Result<_, _>>()?;
        let mut recorded = RecordedRun::watched(&model, scenario.output.balls, monitor)?;
        let campbell = along_run_up(&model, &mut recorded.run);
        Ok(Self {
            scenario,
            model,
            recorded,
            campbell,
            measured,
            sensitivity: None,
        })
    }

    fn answer(&self) -> RunAnswer<'_> {
        RunAnswer {
            scenario: &self.scenario,
            model: &self.model,
            run: &self.recorded.run,
            campbell: self.campbell.as_ref(),
            measured: &self.measured,
            sensitivity: self.sensitivity.as_ref(),
        }
    }

    /// What `summary.json` says.
    pub fn document(&self) -> Value {
        self.answer().reported().document
    }

    /// Key numbers and the strongest peaks, for people.
    pub fn text(&self) -> String {
        self.answer().reported().text(false)
    }

    /// Names of the tables that the run has, as those of its files.
    pub fn tables(&self) -> Vec<String> {
        let tables = self.tables_to_make().into_iter();
        tables.map(|(name, _)| name).collect()
    }

    /// A table by its name; none where the run has none of it. The trace has all samples, whatever `[output]` leaves
    /// out of its file.
    pub fn table(&self, name: &str) -> Option<Table<'_>> {
        let mut tables = self.tables_to_make().into_iter();
        let (_, make) = tables.find(|(known, _)| known == name)?;
        Some(make())
    }

    /// Every table that the run has: its name and what makes it.
    fn tables_to_make<'a>(&'a self) -> Vec<(String, MakeTable<'a>)> {
        let RecordedRun {
            run,
            samples,
            events,
            balls,
            ..
        } = &self.recorded;
        let mut tables = Vec::new();
        let mut add = |name: &str, make: MakeTable<'a>| tables.push((name.to_owned(), make));
        if let Some(first) = samples.first() {
            let (energy, drive) = (first.energy.is_some(), first.drive.is_some());
            let sampled: [(_, _, Vec<Channel>); 3] = [
                ("trace", true, Channel::of_trace_of(&self.model.rotor)),
                ("energy", energy, Channel::of_energy().collect()),
                ("drive", drive, Channel::of_drive().collect()),
            ];
            for (name, _, channels) in sampled.into_iter().filter(|(_, is_there, _)| *is_there) {
                add(name, Box::new(|| sample_table(samples, channels)));
            }
        }
        let rows = events.iter().map(event_row);
        add("events", Box::new(|| Table::of_rows(event_columns(), rows)));
        if let Some(first) = balls.first() {
            let rows = samples.iter().zip(balls);
            let rows = rows.map(|(sample, balls)| ball_row(sample, balls));
            let make = || Table::of_rows(ball_columns(first), rows);
            add("trace_balls", Box::new(make));
        }
        if let Some(Maps { waterfall, .. }) = &run.maps {
            add("waterfall", Box::new(|| waterfall_table(waterfall)));
        }
        if let Some(found) = &self.sensitivity {
            add("run_sensitivity", Box::new(|| found.table()));
        }
        let answer = self.answer();
        for (name, table) in answer.tables() {
            add(&name, Box::new(|| table));
        }
        if let Some(peaks) = answer.peaks() {
            add("peaks", Box::new(|| peaks));
        }
        tables
    }

    /// Names of the figures that the run has.
    pub fn figures(&self) -> Vec<String> {
        self.findings().figures().map(str::to_owned).collect()
    }

    /// A figure by its name as SVG; none where the run has none of it.
    pub fn figure(&self, name: &str) -> Option<String> {
        self.findings().figure(name)
    }

    fn findings(&self) -> Findings {
        let mut histories = Histories::new(self.model.rotor.shaft.freedoms);
        let samples = self.recorded.samples.iter();
        samples.for_each(|sample| histories.sample(sample));
        let drawn = Drawn {
            histories: Some(&histories),
            film: None,
        };
        self.answer().findings(drawn)
    }

    /// The spectra that another version of the scenario asks for, estimated from the samples of this run; of each
    /// its table, or why there is none.
    ///
    /// # Errors
    /// [`SimulateError`] where the shaft cannot be assembled.
    pub fn estimated(
        &self,
        asked: &Scenario,
    ) -> Result<Vec<Result<Table<'static>, String>>, SimulateError> {
        let spectra = asked.model.as_ref().map(|model| model.spectra.clone());
        let spectra = spectra.unwrap_or_default();
        let estimates = self.recorded.estimated(&self.model, spectra)?.into_iter();
        let tables = estimates.map(|found| {
            let spectrum = found.map_err(|error| error.to_string())?;
            Ok(estimated_table(&spectrum).into_owned())
        });
        Ok(tables.collect())
    }

    /// Writes all files of the run into a folder, as `jeffcott run` does; returns their paths.
    ///
    /// # Errors
    /// [`ReportError`] where a file cannot be written or drawn.
    pub fn write(&self, folder: &Path) -> Result<Vec<PathBuf>, ReportError> {
        let mut report = RunReport::new(&self.scenario, &self.model, folder)?;
        report.sensitivity.clone_from(&self.sensitivity);
        let replayed = self.recorded.replay(&mut report);
        replayed.map_err(ReportError::file(FileAction::Write, folder))?;
        Ok(report.finish(&self.model, self.recorded.run.clone())?.files)
    }
}

/// Makes a table when it is asked for.
type MakeTable<'a> = Box<dyn FnOnce() -> Table<'a> + 'a>;
