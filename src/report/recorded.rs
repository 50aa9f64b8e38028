//! A run that is kept in memory: its tables and figures one by one, and all its files.

use std::io;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::figure::Figure;
use super::histories::Histories;
use super::run_report::{figures, tables};
use super::run_tables::{ball_columns, ball_row, event_columns, event_row, sample_table};
use super::run_up::waterfall_table;
use super::spectra::estimated_table;
use super::table::Table;
use super::text::{contact_choice_text, text};
use super::{FileAction, ReportError, RunReport, RunSummary, document};
use crate::analysis::Channel;
use crate::rotor::Sample;
use crate::scenario::{Scenario, ScenarioRunError};
use crate::simulate::{Model, Monitor, RecordedRun, SimulateError};
use crate::study::campbell::{Campbell, along_run_up};

/// What a run has found, with its samples: as [`Findings`](super::Findings), but each table and figure is made when it
/// is asked for.
#[derive(Debug, Clone)]
pub struct RunFindings {
    scenario: Scenario,
    model: Model,
    /// The run.
    pub recorded: RecordedRun,
    campbell: Option<Campbell>,
}

impl RunFindings {
    /// Runs a scenario and keeps its samples.
    ///
    /// # Errors
    /// [`ScenarioRunError`].
    pub fn of(scenario: Scenario, monitor: &mut Monitor<'_>) -> Result<Self, ScenarioRunError> {
        let model = scenario.model.clone().ok_or(ScenarioRunError::NoTime)?;
        let mut recorded = RecordedRun::watched(&model, scenario.output.balls, monitor)?;
        let campbell = along_run_up(&model, &mut recorded.run);
        Ok(Self {
            scenario,
            model,
            recorded,
            campbell,
        })
    }

    /// What `summary.json` says.
    pub fn document(&self) -> Value {
        let Scenario { title, echo, .. } = &self.scenario;
        let choice = self.scenario.contact_choice.as_ref();
        let run = &self.recorded.run;
        let summary = RunSummary::new(&self.model, run, choice, self.campbell.as_ref());
        document(title, echo, summary)
    }

    /// Key numbers and the strongest peaks, for people.
    pub fn text(&self) -> String {
        let choice = self.scenario.contact_choice.as_ref();
        let chosen = choice.map(contact_choice_text).unwrap_or_default();
        text(&self.scenario.title, &self.model, &self.recorded.run, &[]) + &chosen
    }

    /// Names of the tables that the run has, as those of its files.
    pub fn tables(&self) -> Vec<String> {
        let sampled = SAMPLED.iter().filter(|(_, has, _)| self.has(*has));
        let mut names: Vec<String> = sampled.map(|(name, ..)| (*name).to_owned()).collect();
        names.push("events".to_owned());
        if !self.recorded.balls.is_empty() {
            names.push("trace_balls".to_owned());
        }
        if self.recorded.run.maps.is_some() {
            names.push("waterfall".to_owned());
        }
        names.extend(self.ended().into_iter().map(|(name, _)| name));
        names
    }

    /// A table by its name; none where the run has none of it. The trace has all samples, whatever `[output]` leaves
    /// out of its file.
    ///
    /// # Errors
    /// None of memory that is there.
    pub fn table(&self, name: &str) -> io::Result<Option<Table<'_>>> {
        let sampled = SAMPLED.iter().find(|(known, ..)| *known == name);
        if let Some((_, has, channels)) = sampled {
            let table = || sample_table(&self.recorded.samples, channels());
            return Ok(self.has(*has).then(table));
        }
        match name {
            "events" => self.events().map(Some),
            "trace_balls" => self.balls(),
            "waterfall" => {
                let maps = self.recorded.run.maps.as_ref();
                let table = maps.map(|maps| waterfall_table(&maps.waterfall));
                table.transpose()
            }
            _ => {
                let mut tables = self.ended().into_iter();
                let found = tables.find(|(known, _)| known == name);
                Ok(found.map(|(_, table)| table))
            }
        }
    }

    /// Tables of what is known at the end of the run.
    fn ended(&self) -> Vec<(String, Table<'_>)> {
        tables(&self.recorded.run, true, self.campbell.as_ref())
    }

    /// Whether something is observed in the samples.
    fn has(&self, observed: fn(&Sample) -> bool) -> bool {
        self.recorded.samples.first().is_some_and(observed)
    }

    fn events(&self) -> io::Result<Table<'static>> {
        Table::of_rows(&event_columns(), |take| {
            let mut events = self.recorded.events.iter();
            events.try_for_each(|event| take(&event_row(event)))
        })
    }

    fn balls(&self) -> io::Result<Option<Table<'static>>> {
        let Some(first) = self.recorded.balls.first() else {
            return Ok(None);
        };
        let mut row = Vec::new();
        let mut rows = self.recorded.samples.iter().zip(&self.recorded.balls);
        let table = Table::of_rows(&ball_columns(first), |take| {
            rows.try_for_each(|(sample, balls)| {
                ball_row(sample, balls, &mut row);
                take(&row)
            })
        });
        table.map(Some)
    }

    /// Names of the figures that the run has.
    pub fn figures(&self) -> Vec<String> {
        let figures = self.drawn();
        figures.iter().map(|one| one.name().to_owned()).collect()
    }

    /// A figure by its name as SVG; none where the run has none of it.
    ///
    /// # Errors
    /// [`ReportError::Draw`] where the drawing library fails.
    pub fn figure(&self, name: &str) -> Result<Option<String>, ReportError> {
        let figures = self.drawn();
        let found = figures.iter().find(|figure| figure.name() == name);
        found.map(Figure::svg).transpose()
    }

    fn drawn(&self) -> Vec<Figure> {
        let mut histories = Histories::new(self.model.rotor.shaft.freedoms.count());
        let samples = self.recorded.samples.iter();
        samples.for_each(|sample| histories.sample(sample));
        let (title, run) = (&self.scenario.title, &self.recorded.run);
        figures(title, run, Some(&histories), self.campbell.as_ref())
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
        let tables = estimates.map(|found| match found {
            Ok(spectrum) => Ok(estimated_table(&spectrum).into_owned()),
            Err(error) => Err(error.to_string()),
        });
        Ok(tables.collect())
    }

    /// Writes all files of the run into a folder, as `jeffcott run` does; returns their paths.
    ///
    /// # Errors
    /// [`ReportError`] where a file cannot be written or drawn.
    pub fn write(&self, folder: &Path) -> Result<Vec<PathBuf>, ReportError> {
        let report = RunReport::of(&self.scenario, &self.model, folder)?;
        let mut report = report.with_campbell(self.campbell.clone());
        let replayed = self.recorded.replay(&mut report);
        replayed.map_err(ReportError::file(FileAction::Write, folder))?;
        report.finish(&self.model, &self.recorded.run)
    }
}

/// A table of samples: its name, whether a sample has what it shows, and its columns.
type Sampled = (&'static str, fn(&Sample) -> bool, fn() -> Vec<Channel>);

/// Tables of the samples.
const SAMPLED: [Sampled; 3] = [
    ("trace", |_| true, || Channel::of_trace().collect()),
    (
        "energy",
        |sample| sample.energy.is_some(),
        || Channel::of_energy().collect(),
    ),
    (
        "drive",
        |sample| sample.drive.is_some(),
        || Channel::of_drive().collect(),
    ),
];
