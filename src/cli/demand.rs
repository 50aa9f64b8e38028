//! What a run demands of the machine, and whether the machine has it.

use std::fmt;
use std::fs;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc;
use std::thread;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::analysis::Channel;
use crate::integrate::{IntegrateError, Pace};
use crate::scenario::{Scenario, StudyFile, TableFormat};
use crate::simulate::{BareRun, Model, RunSize, SimulateError};

/// Bytes of a number in a table of text.
const TEXT: f64 = 19.5;
/// Bytes of a number in a table of another format.
const BINARY: f64 = 9.0;
/// Bytes of what a run writes whatever it is.
const FLAT: f64 = 2e6;
/// Columns beside the trace: energy, and a drive.
const ENERGY: f64 = 12.0;
const DRIVE: f64 = 8.0;
/// Columns of a ball: load and contact angle at both races.
const BALL: f64 = 4.0;
/// Bytes that are put together and written in a second, about.
const WRITTEN: f64 = 2e8;
/// Time that is spent to find out how long a run takes.
const TRIED: Duration = Duration::from_millis(150);
/// Work of both passes over that of the first.
const BOTH_PASSES: f64 = 2.27;
/// Memory beside that of the run that a limit on addresses has to hold.
const ADDRESSES: f64 = 40e6;

/// What a run demands, or the runs of a study.
#[derive(Debug, Clone, Copy)]
pub struct Demand {
    /// Number of runs, where they are those of a study.
    runs: Option<u64>,
    size: RunSize,
    /// Bytes of all its files.
    disk: f64,
    /// Time it takes, s; none where it cannot be told.
    time: Option<f64>,
}

impl Demand {
    /// Of a scenario that moves; takes a look at its first steps.
    ///
    /// # Errors
    /// [`SimulateError`] where it cannot be run at all.
    pub fn of(scenario: &Scenario, model: &Model) -> Result<Self, SimulateError> {
        let size = RunSize::of(model)?;
        let disk = disk(scenario, model, &size);
        Ok(Self {
            runs: None,
            size,
            disk,
            time: time(model)?.map(|time| time + disk / WRITTEN),
        })
    }

    /// Of the runs of a study, all of which are taken to be like its first one.
    ///
    /// # Errors
    /// [`SimulateError`] where that cannot be run at all.
    pub fn of_runs(first: &Model, study: &StudyFile) -> Result<Self, SimulateError> {
        let size = RunSize::of(first)?;
        let runs = study.plan.runs().unwrap_or(u64::MAX);
        let mut columns = study.columns.len() as f64;
        if study.keep.traces {
            let channels = Channel::of_trace_in(&study.echo["base"], &first.rotor);
            columns += (channels.len() as u64 * size.samples) as f64;
        }
        Ok(Self {
            runs: Some(runs),
            size,
            disk: FLAT + TEXT * columns * runs as f64,
            time: time(first)?.map(|time| time * runs as f64),
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
            "disk_bytes": self.disk.round(),
            "expected_time_s": self.time,
        })
    }
}

impl fmt::Display for Demand {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (memory, disk) = (bytes(self.size.memory), bytes(self.disk));
        let samples = self.size.samples;
        let (runs, each, thread) = match self.runs {
            None => (String::new(), "", ""),
            Some(runs) => (
                format!("{runs} runs of "),
                " for each thread",
                " on one thread",
            ),
        };
        write!(
            f,
            "{runs}{samples} samples, about {memory} of memory{each}, {disk} of files"
        )?;
        match self.time {
            Some(time) if time < 1.0 => write!(f, ", less than a second")?,
            Some(time) if time < 100.0 => write!(f, ", {time:.0} s")?,
            Some(time) if time < 6000.0 => write!(f, ", {:.0} min", time / 60.0)?,
            Some(time) => write!(f, ", {:.0} h", time / 3600.0)?,
            None => return Ok(()),
        }
        write!(f, "{thread} at the pace of its start")
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

/// Bytes of all files of a run.
fn disk(scenario: &Scenario, model: &Model, size: &RunSize) -> f64 {
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
        let balls = bearings.map(|bearing| bearing.bearing.geometry.balls());
        columns += BALL * balls.sum::<usize>() as f64;
    }
    let mut numbers = columns * rows;
    if model.spectrum.is_some() {
        // amplitude and phase of every column at half as many frequencies as samples
        let part = 1.0 - model.settle / model.duration;
        numbers += 0.5 * (2.0 * size.columns as f64 + 2.0) * size.samples as f64 * part;
    }
    let formats = output.formats.iter().map(|format| match format {
        TableFormat::Csv => TEXT,
        _ => BINARY,
    });
    FLAT + numbers * formats.sum::<f64>()
}

/// Time that a run takes if it goes on as it begins, s.
fn time(model: &Model) -> Result<Option<f64>, SimulateError> {
    let run = BareRun::new(model)?;
    let (stop, pace) = (AtomicBool::new(false), Pace::default());
    let started = Instant::now();
    let ending = thread::scope(|scope| {
        let (running, ended) = mpsc::channel::<()>();
        let (stop, pace) = (&stop, &pace);
        let trial = scope.spawn(move || {
            let _running = running;
            run.integrate(stop, Some(pace))
        });
        let _ = ended.recv_timeout(TRIED);
        stop.store(true, Ordering::Relaxed);
        trial.join()
    });
    let part = match ending {
        Ok(Ok(_)) => 1.0,
        Ok(Err(SimulateError::Integrate(IntegrateError::Interrupted { .. }))) => {
            pace.now().0 / model.duration
        }
        // the run itself tells why it fails
        Ok(Err(_)) => return Ok(None),
        Err(panic) => std::panic::resume_unwind(panic),
    };
    let passes = if model.verify { BOTH_PASSES } else { 1.0 };
    Ok((part > 0.0).then(|| passes * started.elapsed().as_secs_f64() / part))
}

/// Bytes in words.
fn bytes(bytes: f64) -> String {
    match bytes {
        b if b < 1e9 => format!("{:.0} MB", (b / 1e6).ceil()),
        b => format!("{:.1} GB", b / 1e9),
    }
}
