//! The truth that errors are measured against: two different methods, as exact as the scene allows.

use std::sync::atomic::AtomicBool;

use serde::{Serialize, Serializer, ser::SerializeMap};

use super::error::{Errors, Norm, Scale};
use super::trial::{Trial, observe, with};
use super::{AccuracyError, NamedMethod, View, is_interrupted};
use crate::integrate::Method;
use crate::rotor::{MotionScale, Rotor};
use crate::simulate::Model;

/// Methods that share neither coefficients nor code, those before the others first.
const METHODS: [Method; 3] = [Method::Verner76, Method::Dop853, Method::Rodas];
/// Tolerances that a method is taken through, as far as time allows.
const TOLERANCES: [f64; 3] = [1e-8, 1e-10, 1e-12];
/// How much longer the next of these tolerances takes at most: two decades at order 3.5.
const NEXT_TAKES: f64 = 4.0;
/// A reference may take so many times as long as any other run.
const PATIENCE: f64 = 4.0;

/// References that differ by more than this part of the motion have parted company.
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
    /// Whether traces cannot be compared: the references part company.
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
    let mut map = serializer.serialize_map(Some(2))?;
    map.serialize_entry("method", method)?;
    map.serialize_entry("tolerance", tolerance)?;
    map.end()
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
        model: &Model,
        rotor: &Rotor,
        scale: &MotionScale,
        view: View,
        known: &[NamedMethod],
        longest: f64,
        stop: &AtomicBool,
    ) -> Result<Self, AccuracyError> {
        let mut taken = Vec::new();
        let mut failures = Vec::new();
        for method in METHODS {
            if taken.len() == 2 {
                break;
            }
            match take(model, view, method, PATIENCE * longest, stop)? {
                Ok(found) => taken.push(found),
                Err(failure) => failures.push(format!("{}: {failure}", name(known, method))),
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
        Ok(Self::of(first, second, rotor, scale, known))
    }

    fn of(
        first: Taken,
        second: Taken,
        rotor: &Rotor,
        scale: &MotionScale,
        known: &[NamedMethod],
    ) -> Self {
        let scale = Scale::of(&first.best, rotor, scale);
        let between =
            |trial: &Trial| Errors::between(trial, &first.best, &scale, Norm::Largest, 0.0);
        let uncertainty = between(&second.best);
        let others = first.others.iter().chain(&second.others);
        let scatter = others
            .clone()
            .map(between)
            .fold(uncertainty, |widest, other| widest.widest(&other));
        let parts = first.best.trace.growth(&second.best.trace, PARTS);
        let growth = growth(&parts);
        Self {
            agreement: Agreement {
                reference: (name(known, first.method), first.tolerance),
                other: (name(known, second.method), second.tolerance),
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

/// Largest of the parts over the first.
fn growth(parts: &[f64]) -> f64 {
    let largest = parts.iter().copied().fold(0.0, f64::max);
    match parts.first() {
        Some(&first) if first > 0.0 => largest / first,
        _ => 1.0,
    }
}

fn name(known: &[NamedMethod], method: Method) -> String {
    let named = known.iter().find(|named| named.method == method);
    named.map_or_else(|| format!("{method:?}"), |named| named.name.clone())
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
        match observe(&with(model, method, tolerance), view, stop) {
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
            Err(error) if is_interrupted(&error) => return Err(error.into()),
            Err(error) if taken.is_none() => return Ok(Err(error.to_string())),
            Err(_) => break,
        }
    }
    Ok(taken.ok_or_else(|| "not run".to_owned()))
}
