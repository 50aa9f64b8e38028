//! What a run demands of the machine, and whether the machine has it.

use std::f64::consts::TAU;
use std::fmt;
use std::fs;

use serde_json::{Value, json};

use crate::analysis::Channel;
use crate::scenario::{Scenario, StudyFile, TableFormat};
use crate::simulate::{Model, RunSize, SimulateError};
use crate::study::many::cycles_a_revolution;

/// Bytes of a number in a table of text.
const TEXT: f64 = 19.5;
/// Bytes of a number in a table of another format.
const BINARY: f64 = 9.0;
/// Columns besides the trace: energy, and a drive.
const ENERGY: f64 = 12.0;
const DRIVE: f64 = 8.0;
/// Columns of a ball: load and contact angle at both races.
const BALL: f64 = 4.0;
/// Columns of a line of a spectrum, or of a point, besides its displacements.
const PLACE: f64 = 3.0;
/// Columns of a bearing's stiffness and damping.
const STIFFNESS: f64 = 13.0;
/// Memory besides that of the run that a limit on addresses has to hold.
const ADDRESSES: f64 = 40e6;

/// What a run demands, or the runs of a study.
#[derive(Debug, Clone, Copy)]
pub struct Demand {
    /// Number of runs, where they are those of a study.
    runs: Option<u64>,
    size: RunSize,
    /// Bytes of its tables.
    tables: f64,
}

impl Demand {
    /// Of a scenario that moves.
    ///
    /// # Errors
    /// [`SimulateError`] where it cannot be run at all.
    pub fn from_scenario(scenario: &Scenario, model: &Model) -> Result<Self, SimulateError> {
        let size = RunSize::from_model(model)?;
        Ok(Self {
            runs: None,
            size,
            tables: tables(scenario, model, &size),
        })
    }

    /// Of so many runs of a study, all of which are taken to be like its first one.
    ///
    /// # Errors
    /// [`SimulateError`] where that cannot be run at all.
    pub fn from_study(first: &Model, study: &StudyFile, runs: u64) -> Result<Self, SimulateError> {
        let size = RunSize::from_model(first)?;
        let mut numbers = study.columns.len() as f64;
        if study.keep.traces {
            let channels = Channel::of_trace_in(&study.echo["base"], &first.rotor);
            numbers += (channels.len() as u64 * size.samples) as f64;
        }
        let revolutions = first.rotor.speed / TAU * (first.duration - first.settle);
        let section = study.keep.section;
        // a scene without such cycles has no points
        let points = section.map(|kind| cycles_a_revolution(kind, &first.rotor).unwrap_or(0.0));
        let lines = study.keep.highest_order.unwrap_or(0.0) + points.unwrap_or(0.0);
        let displacements = first.rotor.shaft.freedoms.axes().len() as f64;
        numbers += revolutions * lines * (PLACE + displacements);
        if study.keep.bearing_stiffness {
            numbers += STIFFNESS * first.rotor.bearings.len() as f64;
        }
        Ok(Self {
            runs: Some(runs),
            size,
            // until its end a study has its rows besides them
            tables: 2.0 * TEXT * numbers * runs as f64,
        })
    }

    /// What keeps `run` from beginning it, if it needs more memory than there is.
    pub fn memory_warning(&self) -> Option<String> {
        let refused = check_memory(&self.size, 1).err()?;
        Some(format!("`run` and `study` refuse it here: {refused}"))
    }

    /// For programs.
    pub fn json(&self) -> Value {
        json!({
            "runs": self.runs,
            "samples": self.size.samples,
            "memory_bytes": self.size.memory.round(),
            "table_bytes": self.tables.round(),
        })
    }
}

impl fmt::Display for Demand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (memory, tables) = (bytes(self.size.memory), bytes(self.tables));
        let samples = self.size.samples;
        let (runs, each) = match self.runs {
            None => (String::new(), ""),
            Some(runs) => (format!("{runs} runs of "), " for each thread"),
        };
        write!(
            f,
            "{runs}{samples} samples, about {memory} of memory{each}, {tables} of tables"
        )
    }
}

/// Refuses what needs more memory than there is, `at_once` of it at a time.
///
/// # Errors
/// What is needed and what is there, in words.
pub fn check_memory(size: &RunSize, at_once: usize) -> Result<(), String> {
    let needed = size.memory * at_once as f64;
    let Some((there, of)) = available().find(|(there, _)| *there < needed) else {
        return Ok(());
    };
    let fewer = match (there / size.memory) as usize {
        fewer if fewer >= 1 && at_once > 1 => format!(", or --threads {fewer}"),
        _ => String::new(),
    };
    Err(format!(
        "it needs about {} of memory and {} are there{of}: {:.3e} samples of {} columns are kept for the spectra; \
         set spectrum = false in [output], sample less often, or make `settle` longer or `duration` shorter{fewer}",
        bytes(needed),
        bytes(there),
        size.samples as f64,
        size.columns
    ))
}

/// Bytes that the process may still take, each with what says so; nothing where the system does not tell.
fn available() -> impl Iterator<Item = (f64, &'static str)> {
    let free = || {
        let text = fs::read_to_string("/proc/meminfo").ok()?;
        let of = |key: &str| {
            let line = text.lines().find(|line| line.starts_with(key))?;
            line.split_whitespace().nth(1)?.parse::<f64>().ok()
        };
        Some(1024.0 * (of("MemAvailable:")? + of("SwapFree:").unwrap_or(0.0)))
    };
    let addresses = || {
        let text = fs::read_to_string("/proc/self/limits").ok()?;
        let line = text
            .lines()
            .find_map(|line| line.strip_prefix("Max address space"))?;
        let limit: f64 = line.split_whitespace().next()?.parse().ok()?;
        Some((limit - ADDRESSES).max(0.0))
    };
    let found = [
        (free(), ""),
        (addresses(), " under the limit on addresses (ulimit -v)"),
    ];
    found
        .into_iter()
        .filter_map(|(there, of)| Some((there?, of)))
}

/// Bytes of the tables of a run.
fn tables(scenario: &Scenario, model: &Model, size: &RunSize) -> f64 {
    let output = &scenario.output;
    let rows = size.samples as f64 / output.written_of(size.samples as f64).get() as f64;
    let mut columns = 0.0;
    if output.trace {
        let chosen = output.channels.as_ref().map(|channels| channels.len() + 1);
        columns += chosen.unwrap_or_else(|| Channel::of_trace_of(&model.rotor).len()) as f64;
    }
    let driven = model.rotor.drive.is_some();
    if model.energy || driven {
        columns += ENERGY;
    }
    if driven {
        columns += DRIVE;
    }
    if output.balls {
        let bearings = model.rotor.bearings.iter();
        let balls = bearings.map(|bearing| bearing.bearing.geometry.all_balls());
        columns += BALL * balls.sum::<usize>() as f64;
    }
    let mut numbers = columns * rows + size.table_numbers;
    if model.spectrum.is_some() {
        // amplitude and phase of every column at half as many frequencies as samples
        let part = 1.0 - model.settle / model.duration;
        numbers += 0.5 * (2.0 * size.columns as f64 + 2.0) * size.samples as f64 * part;
    }
    let formats = output.formats.iter().map(|format| match format {
        TableFormat::Csv => TEXT,
        _ => BINARY,
    });
    numbers * formats.sum::<f64>()
}

/// Bytes in words.
fn bytes(bytes: f64) -> String {
    match bytes {
        b if b < 1e9 => format!("{:.0} MB", (b / 1e6).ceil()),
        b => format!("{:.1} GB", b / 1e9),
    }
}
