//! The truth that errors are measured against: two different methods, as exact as the scene allows; and the distance
//! of every method and tolerance from it.

use std::sync::atomic::AtomicBool;
use std::time::Instant;

use serde::{Serialize, Serializer};
use serde_json::json;

use super::trace::Trace;
use super::{AccuracyError, Errors, Question, Scale, View, unless_stopped};
use crate::analysis::{Moments, Peak};
use crate::integrate::{Counters, Method};
use crate::keys;
use crate::rotor::{MotionScale, Rotor};
use crate::simulate::{BareRun, Model, Monitor, SimulateError, simulate};

/// Methods that share neither coefficients nor code, those before the others first.
const METHODS: [Method; 3] = [Method::Verner76, Method::Dop853, Method::Rodas];
/// Tolerances that a method is taken through, as far as time allows.
const TOLERANCES: [f64; 3] = [1e-8, 1e-10, 1e-12];
/// How much longer the next of these tolerances takes at most: two decades at order 3.5.
const NEXT_TAKES: f64 = 4.0;
/// A reference may take so many times as long as any other run.
const PATIENCE: f64 = 4.0;

/// References that differ by more than this part of the motion have diverged.
const PARTED: f64 = 1e-4;
/// Small differences that grow by more than this over the run make it irregular.
const AMPLIFIED: f64 = 1e6;
/// Parts of the run whose differences are compared.
const PARTS: usize = 16;

/// How the reference was found, and how far it can be trusted.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Agreement {
    /// Method and tolerance of the reference.
    #[serde(rename = "run", serialize_with = "run")]
    pub reference: (String, f64),
    /// Method and tolerance of the run that it is compared with.
    #[serde(rename = "compared_with", serialize_with = "run")]
    pub other: (String, f64),
    /// Distance of the two: the uncertainty of every error that is measured against the reference.
    pub uncertainty: Errors,
    /// Scatter of the statistics among all exact runs; as the uncertainty in all else.
    #[serde(rename = "scatter_of_statistics", serialize_with = "statistics")]
    pub scatter: Errors,
    /// Number of exact runs.
    #[serde(rename = "exact_runs")]
    pub runs: usize,
    /// How much the difference of the two grows from the first sixteenth of the run on: the largest part
    /// over the first.
    #[serde(rename = "growth_of_differences")]
    pub growth: f64,
    /// Whether traces cannot be compared: the references diverge.
    pub irregular: bool,
    /// What errors are relative to.
    #[serde(flatten)]
    pub(crate) scale: Scale,
}

/// Method and tolerance of a run.
fn run<S: Serializer>(
    (method, tolerance): &(String, f64),
    serializer: S,
) -> Result<S::Ok, S::Error> {
    json!({ "method": method, "tolerance": tolerance }).serialize(serializer)
}

/// Differences of statistics alone.
fn statistics<S: Serializer>(errors: &Errors, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map([
        ("displacement_relative", errors.statistics),
        ("force_relative", errors.force_statistics),
    ])
}

/// The truth.
#[derive(Debug, Clone)]
pub(super) struct Reference {
    pub trial: Trial,
    pub agreement: Agreement,
}

/// A method taken as far as time allows.
struct Taken {
    method: Method,
    tolerance: f64,
    /// The tightest.
    best: Trial,
    /// The looser ones, their statistics alone.
    others: Vec<Trial>,
}

impl Reference {
    /// Runs two methods as exactly as they go within the time that a run may take.
    pub fn find(
        question: &Question<'_>,
        rotor: &Rotor,
        scale: &MotionScale,
        view: View,
        stop: &AtomicBool,
    ) -> Result<Self, AccuracyError> {
        let longest = PATIENCE * question.longest;
        let mut taken = Vec::new();
        let mut failures = Vec::new();
        for method in METHODS {
            if taken.len() == 2 {
                break;
            }
            match take(question.model, view, method, longest, stop)? {
                Ok(found) => taken.push(found),
                Err(failure) => failures.push(format!("{method}: {failure}")),
            }
        }
        // the first stays the first where both are as tight
        taken.sort_by(|a: &Taken, b| a.tolerance.total_cmp(&b.tolerance));
        let mut taken = taken.into_iter();
        let (Some(first), Some(second)) = (taken.next(), taken.next()) else {
            return Err(AccuracyError::NoReference {
                failures: failures.join("; "),
            });
        };
        Ok(Self::of(first, second, rotor, scale))
    }

    fn of(first: Taken, second: Taken, rotor: &Rotor, scale: &MotionScale) -> Self {
        let scale = Scale::of(&first.best, rotor, scale);
        let between =
            |trial: &Trial| Errors::between(trial, &first.best, &scale, Moments::magnitude, 0.0);
        let uncertainty = between(&second.best);
        let others = first.others.iter().chain(&second.others);
        let scatter = others
            .clone()
            .map(between)
            .fold(uncertainty, |widest, other| widest.widest(&other));
        let growth = first.best.trace.growth(&second.best.trace, PARTS);
        Self {
            agreement: Agreement {
                reference: (first.method.to_string(), first.tolerance),
                other: (second.method.to_string(), second.tolerance),
                uncertainty,
                scatter,
                runs: 2 + others.count(),
                growth,
                irregular: !(uncertainty.displacement_relative <= PARTED && growth <= AMPLIFIED),
                scale,
            },
            trial: first.best,
        }
    }
}

/// The tightest run of a method that stays within a time; why there is none, where there is none.
fn take(
    model: &Model,
    view: View,
    method: Method,
    longest: f64,
    stop: &AtomicBool,
) -> Result<Result<Taken, String>, AccuracyError> {
    let mut taken: Option<Taken> = None;
    for tolerance in TOLERANCES {
        if let Some(taken) = &taken
            && NEXT_TAKES * taken.best.seconds > longest
        {
            break;
        }
        match unless_stopped(observe(&with(model, method, tolerance), view, stop))? {
            Ok(best) => {
                let others = taken.take().map_or_else(Vec::new, |mut before| {
                    before.best.trace.forget_points();
                    before.others.push(before.best);
                    before.others
                });
                taken = Some(Taken {
                    method,
                    tolerance,
                    best,
                    others,
                });
            }
            Err(failure) if taken.is_none() => return Ok(Err(failure)),
            Err(_) => break,
        }
    }
    Ok(taken.ok_or_else(|| "not run".to_owned()))
}

/// How much longer the next tolerance is taken to run where only one has been: an order of three.
const FIRST_GUESS: f64 = 2.2;

/// A method at a tolerance.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Row {
    /// Name of the method.
    pub method: String,
    /// Tolerance asked for.
    pub tolerance: f64,
    /// What was measured, or why nothing was.
    #[serde(flatten, serialize_with = "keys::or_note")]
    pub result: Result<Measured, String>,
}

/// What was measured of a method at a tolerance.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Measured {
    /// What the integration costs.
    pub cost: Cost,
    /// Largest distance from the reference.
    #[serde(rename = "error")]
    pub errors: Errors,
    /// Whether the error is not above the uncertainty of the reference; in an irregular motion, whether
    /// the statistics are within the scatter of exact runs.
    pub within_uncertainty: bool,
}

/// The rows of one method; tolerances that would take too long are left out.
pub(super) fn rows(
    question: &Question<'_>,
    method: Method,
    reference: &Reference,
    view: View,
    stop: &AtomicBool,
) -> Result<Vec<Row>, AccuracyError> {
    let mut rows = Vec::new();
    let mut before: Option<f64> = None;
    let mut expected = 0.0;
    for &tolerance in question.tolerances {
        let result = if expected > question.longest {
            Err(format!(
                "left out: would take about {expected:.1} s, more than {} s",
                question.longest
            ))
        } else {
            let model = with(question.model, method, tolerance);
            unless_stopped(measured(&model, reference, view, stop))?
        };
        if let Ok(measured) = &result {
            let seconds = measured.cost.seconds;
            let factor = before.map_or(FIRST_GUESS, |before| (seconds / before).clamp(1.2, 10.0));
            expected = factor * seconds;
            before = Some(seconds);
        }
        rows.push(Row {
            method: method.to_string(),
            tolerance,
            result,
        });
    }
    Ok(rows)
}

fn measured(
    model: &Model,
    reference: &Reference,
    view: View,
    stop: &AtomicBool,
) -> Result<Measured, SimulateError> {
    let trial = observe(model, view, stop)?;
    let agreement = &reference.agreement;
    let errors = Errors::between(
        &trial,
        &reference.trial,
        &agreement.scale,
        Moments::magnitude,
        0.0,
    );
    Ok(Measured {
        cost: measure(model, stop)?,
        errors,
        within_uncertainty: if agreement.irregular {
            errors.within_scatter(&agreement.scatter)
        } else {
            errors.displacement <= agreement.uncertainty.displacement
        },
    })
}

/// A measurement of time ends after so many runs,
const MOST_REPEATS: u32 = 15;
/// or after this time in s, whichever is first; the shortest run counts.
const LONG_ENOUGH: f64 = 0.15;

/// Weakest labelled peak that is compared, relative to the strongest peak of the same unit.
const WEAKEST_LINE: f64 = 1e-3;
/// Peaks this many bins apart are one line.
const SAME_LINE: f64 = 0.75;

/// What came of a run.
#[derive(Debug, Clone)]
pub(super) struct Trial {
    pub trace: Trace,
    pub peaks: Vec<Peak>,
    /// Width of a bin of the spectra, Hz.
    pub resolution: f64,
    /// Time of the run with its observation, s.
    pub seconds: f64,
}

/// What a bare integration costs.
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

/// The model by another method at another tolerance, without a second pass.
pub(super) fn with(model: &Model, method: Method, tolerance: f64) -> Model {
    let mut model = model.clone();
    model.verify = false;
    model.integrator.method = method;
    model.integrator.tolerance = tolerance;
    model
}

/// Runs a model and keeps what can be compared.
pub(super) fn observe(
    model: &Model,
    view: View,
    stop: &AtomicBool,
) -> Result<Trial, SimulateError> {
    let started = Instant::now();
    let mut trace = Trace::new(view);
    let mut monitor = Monitor {
        stop,
        progress: &mut |_| {},
    };
    let run = simulate(model, &mut trace, &mut monitor)?;
    Ok(Trial {
        trace,
        resolution: run.spectrum.map_or(0.0, |spectrum| spectrum.resolution),
        peaks: run.peaks,
        seconds: started.elapsed().as_secs_f64(),
    })
}

/// Measures the integration by itself, again and again where it is short.
pub(super) fn measure(model: &Model, stop: &AtomicBool) -> Result<Cost, SimulateError> {
    let bare = BareRun::new(model)?;
    let mut cost = Cost {
        seconds: f64::INFINITY,
        repeats: 0,
        counters: Counters::default(),
    };
    let mut total = 0.0;
    while cost.repeats == 0 || (cost.repeats < MOST_REPEATS && total < LONG_ENOUGH) {
        let started = Instant::now();
        cost.counters = bare.integrate(stop, None)?;
        let seconds = started.elapsed().as_secs_f64();
        cost.seconds = cost.seconds.min(seconds);
        cost.repeats += 1;
        total += seconds;
    }
    Ok(cost)
}

impl Trial {
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
