//! One run of a scene: what can be compared of it, and what its integration costs.

use std::sync::atomic::AtomicBool;
use std::time::Instant;

use serde::Serialize;

use super::trace::Trace;
use crate::analysis::Peak;
use crate::integrate::{Counters, IntegrateError, Method, MethodUse};
use crate::simulate::{BareRun, Model, Monitor, SimulateError, simulate};

/// Most runs of a measurement of time, of which the shortest counts.
const MOST_REPEATS: u32 = 15;
/// A measurement of time ends after this time in s, too.
const LONG_ENOUGH: f64 = 0.15;
/// Of a run that takes longer than this with its observation, s, the observation is a small part: it is not run again by itself.
const LONG: f64 = 0.5;

/// Weakest labelled peak that is compared, relative to the strongest peak of the same unit.
const WEAKEST_LINE: f64 = 1e-3;
/// Peaks this many bins apart are one line.
const SAME_LINE: f64 = 0.75;

/// The model by another method at another tolerance, without a second pass.
pub(super) fn with(model: &Model, method: Method, tolerance: f64) -> Model {
    let mut model = model.clone();
    model.verify = false;
    model.integrator.method = method;
    model.integrator.tolerance = tolerance;
    model
}

/// A run, or in words why it failed; that somebody stopped it ends all.
pub(super) fn unless_stopped<T>(
    result: Result<T, SimulateError>,
) -> Result<Result<T, String>, SimulateError> {
    match result {
        Err(error @ SimulateError::Integrate(IntegrateError::Interrupted { .. })) => Err(error),
        result => Ok(result.map_err(|error| error.to_string())),
    }
}

/// What came of a run.
#[derive(Debug, Clone)]
pub(super) struct Trial {
    pub trace: Trace,
    peaks: Vec<Peak>,
    /// Width of a bin of the spectra, Hz.
    resolution: f64,
    /// Time of the run with its observation, s.
    pub seconds: f64,
    counters: Counters,
    /// Which methods carried the run, where the choice was left open.
    method_use: Option<MethodUse>,
}

impl Trial {
    /// Runs a model and keeps what can be compared.
    pub fn run(model: &Model, stop: &AtomicBool) -> Result<Self, SimulateError> {
        let started = Instant::now();
        let mut trace = Trace::new(model)?;
        let mut monitor = Monitor {
            stop,
            progress: &mut |_| {},
        };
        let run = simulate(model, &mut trace, &mut monitor)?;
        Ok(Self {
            trace,
            resolution: run.spectrum.map_or(0.0, |spectrum| spectrum.resolution),
            peaks: run.peaks,
            seconds: started.elapsed().as_secs_f64(),
            counters: run.counters,
            method_use: run.method_use,
        })
    }

    /// Whether `verner76` carried a part of the run for another method.
    pub fn went_over(&self) -> bool {
        let change = self.method_use.and_then(|methods| methods.change);
        change.is_some()
    }

    /// What the integration costs: by itself, or, where it is long, as it was.
    pub fn cost(&self, model: &Model, stop: &AtomicBool) -> Result<Cost, SimulateError> {
        if self.seconds <= LONG {
            return Cost::measure(model, stop);
        }
        Ok(Cost {
            seconds: self.seconds,
            repeats: 1,
            counters: self.counters,
        })
    }

    /// Largest difference in amplitude over the labelled peaks of `truth`, relative to each; 1 where a
    /// line is missing, `None` where nothing is labelled.
    ///
    /// Peaks below a thousandth of the strongest of the same unit are left out.
    pub fn line_error(&self, truth: &Self) -> Option<f64> {
        let labelled = truth.peaks.iter().filter(|peak| peak.line.is_some());
        let strong = labelled.filter(|peak| peak.amplitude >= WEAKEST_LINE * truth.strongest(peak));
        let errors =
            strong.map(|peak| (self.amplitude(peak) - peak.amplitude).abs() / peak.amplitude);
        errors.reduce(f64::max)
    }

    fn strongest(&self, like: &Peak) -> f64 {
        let unit = like.channel.unit();
        let same = self.peaks.iter().filter(|peak| peak.channel.unit() == unit);
        same.map(|peak| peak.amplitude).fold(0.0, f64::max)
    }

    /// Amplitude of the same line here; zero where there is none.
    fn amplitude(&self, line: &Peak) -> f64 {
        let near = |peak: &&Peak| {
            peak.channel == line.channel
                && (peak.frequency - line.frequency).abs() < SAME_LINE * self.resolution
        };
        let peaks = self.peaks.iter().filter(near);
        peaks.map(|peak| peak.amplitude).fold(0.0, f64::max)
    }
}

/// What an integration costs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Cost {
    /// Shortest time of all repeats, s.
    #[serde(rename = "wall_time_s")]
    pub seconds: f64,
    /// How often it was run.
    pub repeats: u32,
    /// Its work.
    #[serde(flatten)]
    pub counters: Counters,
}

impl Cost {
    /// Measures the integration by itself, again and again where it is short.
    fn measure(model: &Model, stop: &AtomicBool) -> Result<Self, SimulateError> {
        let bare = BareRun::new(model)?;
        let mut cost = Self {
            seconds: f64::INFINITY,
            repeats: 0,
            counters: Counters::default(),
        };
        let mut total = 0.0;
        while cost.repeats == 0 || (cost.repeats < MOST_REPEATS && total < LONG_ENOUGH) {
            let started = Instant::now();
            cost.counters = bare.integrate(stop)?;
            let seconds = started.elapsed().as_secs_f64();
            cost.seconds = cost.seconds.min(seconds);
            cost.repeats += 1;
            total += seconds;
        }
        Ok(cost)
    }
}
