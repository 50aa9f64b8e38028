//! A run that is kept in memory: its tables and figures one by one, and all its files.

use std::io;
use std::path::{Path, PathBuf};

use serde_json::Value;

use super::campbell::{campbell_figure, campbell_table};
use super::motion::{orbit_figure, poincare_table};
use super::run_tables::{ball_columns, ball_row, event_columns, event_row, sample_table};
use super::run_up::{
    order_figure, order_tracks_table, waterfall_columns, waterfall_figure, waterfall_rows,
};
use super::spectra::{estimated_columns, estimated_figure, estimated_rows, table_name};
use super::spectrum::{frequency_limit_of, peak_table, spectrum_columns, spectrum_rows};
use super::table::Table;
use super::text::{contact_choice_text, text};
use super::{ReportError, RunReport, RunSummary, TraceFigure, document, spectrum_figure};
use crate::analysis::{Channel, EstimatedSpectrum};
use crate::scenario::{Scenario, ScenarioRunError};
use crate::simulate::{Model, Monitor, RecordedRun, SimulateError};
use crate::study::campbell::{Campbell, along_run_up};

/// A run with its samples, and all that its files say.
#[derive(Debug, Clone)]
pub struct RunAnswer {
    scenario: Scenario,
    model: Model,
    /// The run.
    pub recorded: RecordedRun,
    campbell: Option<Campbell>,
}

impl RunAnswer {
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
        let run = &self.recorded.run;
        let sample = self.recorded.samples.first();
        let has = |there: bool, names: &[&'static str]| if there { names.to_vec() } else { vec![] };
        let mut names = vec!["trace", "events"];
        names.extend(has(sample.is_some_and(|s| s.energy.is_some()), &["energy"]));
        names.extend(has(sample.is_some_and(|s| s.drive.is_some()), &["drive"]));
        names.extend(has(!self.recorded.balls.is_empty(), &["trace_balls"]));
        names.extend(has(run.spectrum.is_some(), &["spectrum", "peaks"]));
        names.extend(has(run.motion.is_some(), &["poincare"]));
        names.extend(has(run.maps.is_some(), &["waterfall", "order_tracks"]));
        names.extend(has(self.campbell.is_some(), &["campbell"]));
        let estimated = run.spectra.iter().map(table_name);
        names
            .into_iter()
            .map(str::to_owned)
            .chain(estimated)
            .collect()
    }

    /// A table by its name; none where the run has none of it. The trace has all samples, whatever `[output]` leaves
    /// out of its file.
    ///
    /// # Errors
    /// None of memory that is there.
    pub fn table(&self, name: &str) -> io::Result<Option<Table>> {
        let (run, samples) = (&self.recorded.run, &self.recorded.samples);
        if !self.tables().iter().any(|known| known == name) {
            return Ok(None);
        }
        let table = match name {
            "trace" => sample_table(samples, Channel::of_trace()),
            "energy" => sample_table(samples, Channel::of_energy()),
            "drive" => sample_table(samples, Channel::of_drive()),
            "events" => Table::of_rows(&event_columns(), |take| {
                let mut events = self.recorded.events.iter();
                events.try_for_each(|event| take(&event_row(event)))
            })?,
            "trace_balls" => return self.balls(),
            "poincare" => return Ok(run.motion.as_ref().map(poincare_table)),
            "campbell" => return Ok(self.campbell.as_ref().map(campbell_table)),
            "spectrum" => return run.spectrum.as_ref().map(spectrum_table).transpose(),
            "peaks" => {
                let spectrum = run.spectrum.as_ref();
                return Ok(spectrum.map(|spectrum| peak_table(&run.peaks, spectrum)));
            }
            "waterfall" => {
                let waterfall = run.maps.as_ref().map(|maps| &maps.waterfall);
                let table = waterfall.map(|waterfall| {
                    Table::of_rows(&waterfall_columns(waterfall), |take| {
                        waterfall_rows(waterfall, take)
                    })
                });
                return table.transpose();
            }
            "order_tracks" => {
                let maps = run.maps.as_ref();
                return Ok(maps.map(|maps| order_tracks_table(&maps.tracks)));
            }
            _ => {
                let found = run.spectra.iter().find(|one| table_name(one) == name);
                return found.map(estimated_table).transpose();
            }
        };
        Ok(Some(table))
    }

    fn balls(&self) -> io::Result<Option<Table>> {
        let Some(first) = self.recorded.balls.first() else {
            return Ok(None);
        };
        let mut row = Vec::new();
        let rows = self.recorded.samples.iter().zip(&self.recorded.balls);
        let table = Table::of_rows(&ball_columns(first), |take| {
            for (sample, balls) in rows {
                ball_row(sample, balls, &mut row);
                take(&row)?;
            }
            Ok(())
        });
        table.map(Some)
    }

    /// Names of the figures that the run has.
    pub fn figures(&self) -> Vec<String> {
        let run = &self.recorded.run;
        // the map of a run-up that is too short for it is a table without rows
        let drawn = |name: &String| match (name.as_str(), &run.maps) {
            ("waterfall", Some(maps)) => !maps.waterfall.slices.is_empty(),
            ("order_tracks", Some(maps)) => !maps.tracks.points.is_empty(),
            ("spectrum" | "campbell", _) => true,
            (other, _) => other.starts_with("spectrum_"),
        };
        let orbit = run.motion.as_ref().map(|_| "orbit".to_owned());
        let tables = self.tables().into_iter().filter(drawn);
        std::iter::once("trace".to_owned())
            .chain(orbit)
            .chain(tables)
            .collect()
    }

    /// A figure by its name as SVG; none where the run has none of it.
    ///
    /// # Errors
    /// [`ReportError::Draw`] where the drawing library fails.
    pub fn figure(&self, name: &str) -> Result<Option<String>, ReportError> {
        if !self.figures().iter().any(|known| known == name) {
            return Ok(None);
        }
        let (run, title) = (&self.recorded.run, &self.scenario.title);
        let maps = run.maps.as_ref();
        let figure = match name {
            "trace" => {
                let mut figure = TraceFigure::new(self.model.rotor.shaft.freedoms.count());
                let samples = self.recorded.samples.iter();
                samples.for_each(|sample| figure.sample(sample));
                Some(figure.figure("trace.svg", title))
            }
            "spectrum" => {
                let spectrum = run.spectrum.as_ref();
                let svg = spectrum.map(|spectrum| spectrum_figure(title, spectrum, &run.peaks));
                return svg.transpose();
            }
            "orbit" => run
                .motion
                .as_ref()
                .map(|motion| orbit_figure(title, motion)),
            "waterfall" => maps.map(|maps| waterfall_figure(title, maps)),
            "order_tracks" => maps.map(|maps| order_figure(title, &maps.tracks)),
            "campbell" => {
                let campbell = self.campbell.as_ref();
                campbell.map(|campbell| campbell_figure(title, campbell))
            }
            _ => {
                let found = run.spectra.iter().find(|one| table_name(one) == name);
                found.map(|one| estimated_figure(title, one, frequency_limit_of(run)))
            }
        };
        figure.map(|figure| figure.svg()).transpose()
    }

    /// The spectra that another version of the scenario asks for, estimated from the samples of this run; of each
    /// its table, or why there is none.
    ///
    /// # Errors
    /// [`SimulateError`] where the shaft cannot be assembled.
    pub fn estimated(&self, asked: &Scenario) -> Result<Vec<Result<Table, String>>, SimulateError> {
        let spectra = asked.model.as_ref().map(|model| model.spectra.clone());
        let estimates = self
            .recorded
            .estimated(&self.model, spectra.unwrap_or_default())?;
        let table = |found: Result<EstimatedSpectrum, _>| match found {
            Ok(spectrum) => estimated_table(&spectrum).map_err(|error| error.to_string()),
            Err(error) => Err(crate::analysis::EstimateError::to_string(&error)),
        };
        Ok(estimates.into_iter().map(table).collect())
    }

    /// Writes all files of the run into a folder, as `jeffcott run` does; returns their paths.
    ///
    /// # Errors
    /// [`ReportError`] where a file cannot be written or drawn.
    pub fn write(&self, folder: &Path) -> Result<Vec<PathBuf>, ReportError> {
        let report = RunReport::of(&self.scenario, &self.model, folder)?;
        let mut report = report.with_campbell(self.campbell.clone());
        let replayed = self.recorded.replay(&mut report);
        replayed.map_err(ReportError::file(super::FileAction::Write, folder))?;
        report.finish(&self.model, &self.recorded.run)
    }
}

fn spectrum_table(spectrum: &crate::analysis::Spectrum) -> io::Result<Table> {
    Table::of_rows(&spectrum_columns(spectrum), |take| {
        spectrum_rows(spectrum, take)
    })
}

fn estimated_table(spectrum: &EstimatedSpectrum) -> io::Result<Table> {
    Table::of_rows(&estimated_columns(spectrum), |take| {
        estimated_rows(spectrum, take)
    })
}
